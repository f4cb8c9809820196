// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_EDGE_MERGING_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_EDGE_MERGING_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Open_cascade_surface_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Edge_match.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/convert_curves.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

struct Directed_edge
{
  std::size_t edge;
  bool is_reversed;
};
typedef std::vector<Directed_edge> Edge_chain;

// Merges vertices and edges of a model: vertices are replaced by another vertex, and edges by a chain of edges along them.
// Everything that is replaced lies within a given width of its replacement, so that widths do not add up. Two edges may be as far
// apart as both of their tolerances in the file are, up to the tolerance that is trusted.
class Edge_merging
{
  typedef Parametric_surface_model_3<Open_cascade_surface_3> Model;
  typedef Model::Geom_traits Kernel;
  typedef Model::Point_3 Point_3;
  typedef Measured_space_curve<Kernel> Measured_curve;

public:
  // An edge, with the part of another edge that it replaces.
  struct Piece
  {
    std::size_t edge;
    Edge_match<Kernel> match;
  };
  typedef std::vector<Piece> Pieces;

private:
  const Model* m_model;
  double m_width, m_trusted_tolerance;
  std::vector<std::size_t> m_vertices; // the replacement of each vertex
  std::map<std::size_t, Edge_chain> m_chains; // the replacements of edges

public:
  Edge_merging(const Model& model, double width, double trusted_tolerance)
    : m_model(&model), m_width(width), m_trusted_tolerance(trusted_tolerance), m_vertices(model.vertices().size())
  {
    std::iota(m_vertices.begin(), m_vertices.end(), std::size_t(0));
  }

  std::size_t vertex(std::size_t v) const { return m_vertices[v]; }
  std::size_t source(const Directed_edge& e) const { return m_vertices[vertex_before(e)]; }
  std::size_t target(const Directed_edge& e) const { return source({e.edge, !e.is_reversed}); }

  bool is_replaced(std::size_t edge) const { return m_chains.count(edge) != 0; }

  Edge_chain chain(std::size_t edge) const
  {
    const auto found = m_chains.find(edge);
    return found != m_chains.end() ? found->second : Edge_chain{{edge, false}};
  }

  // The pieces that replace an edge; none if it is not replaced.
  Pieces pieces(std::size_t edge) const { return is_replaced(edge) ? *pieces(edge, chain(edge)) : Pieces(); }

  // Divides an edge, by shares of the length, into pieces along the edges of a chain; none if the chain does not run along it.
  std::optional<Pieces> pieces(std::size_t edge, const Edge_chain& chain) const
  {
    if(!runs_along(edge, chain))
      return std::nullopt;
    const Measured_curve measured(curve(edge));
    std::vector<Measured_curve> parts;
    double length = 0, before = 0, begin = measured.begin;
    for(const Directed_edge& part : chain) {
      parts.emplace_back(curve(part.edge));
      length += parts.back().length.length();
    }
    Pieces result;
    for(std::size_t i = 0; i < chain.size(); ++i) {
      before += parts[i].length.length();
      const double end = i + 1 < chain.size() ? measured.parameter_at(before / length) : measured.end;
      if(!(begin < end))
        return std::nullopt;
      result.push_back({chain[i].edge, {parts[i], Measured_curve(measured.curve, begin, end), chain[i].is_reversed}});
      if(!(result.back().match.distance() <= width(edge, chain[i].edge)))
        return std::nullopt;
      begin = end;
    }
    return result;
  }

  // The following functions return false if they fail; the object must not be used any more then.

  bool merge_vertices(std::size_t v, std::size_t w)
  {
    const std::size_t kept = (std::min)(m_vertices[v], m_vertices[w]), other = (std::max)(m_vertices[v], m_vertices[w]);
    for(std::size_t i = 0; i < m_vertices.size() && kept != other; ++i)
      if(m_vertices[i] == other) {
        if(!are_close(m_model->vertices()[i], m_model->vertices()[kept]))
          return false;
        m_vertices[i] = kept;
      }
    return true;
  }

  // Merges two chains that lie side by side.
  bool merge(const Edge_chain& first, const Edge_chain& second)
  {
    const Edge_chain a = in_place(first), b = in_place(second);
    if(a.size() == 1)
      return replace(a.front(), b);
    if(b.size() == 1)
      return replace(b.front(), a);
    bool result = a.size() == b.size();
    for(std::size_t i = 0; i < a.size() && result; ++i)
      result = merge({a[i]}, {b[i]});
    return result;
  }

  static Edge_chain reversed(Edge_chain chain)
  {
    std::reverse(chain.begin(), chain.end());
    for(Directed_edge& e : chain)
      e.is_reversed = !e.is_reversed;
    return chain;
  }

private:
  const std::shared_ptr<const Space_curve_3<Kernel>>& curve(std::size_t edge) const { return m_model->edges()[edge].curve; }

  bool are_close(const Point_3& p, const Point_3& q) const { return squared_distance(p, q) <= square(m_width); }

  // How far apart two edges may be that become one.
  double width(std::size_t edge, std::size_t other) const
  {
    const auto& edges = m_model->edges();
    return (std::max)(m_width, (std::min)({edges[edge].tolerance, edges[other].tolerance, m_trusted_tolerance}));
  }

  std::size_t vertex_before(const Directed_edge& e) const
  {
    return e.is_reversed ? m_model->edges()[e.edge].target : m_model->edges()[e.edge].source;
  }

  // Whether the ends are close to each other, a quick test.
  bool runs_along(std::size_t edge, const Edge_chain& chain) const
  {
    const auto has_no_curve = [this](const Directed_edge& e) { return !curve(e.edge); };
    if(!curve(edge) || std::any_of(chain.begin(), chain.end(), has_no_curve))
      return false;
    const auto point = [this](const Directed_edge& e, double t) { return curve(e.edge)->point(e.is_reversed ? 1 - t : t); };
    const auto is_end_close = [&](const Directed_edge& other, double t) {
      return squared_distance(point({edge, false}, t), point(other, t)) <= square(width(edge, other.edge));
    };
    return is_end_close(chain.front(), 0) && is_end_close(chain.back(), 1);
  }

  Edge_chain in_place(const Edge_chain& chain) const
  {
    Edge_chain result;
    for(const Directed_edge& e : chain) {
      const Edge_chain part = e.is_reversed ? reversed(this->chain(e.edge)) : this->chain(e.edge);
      result.insert(result.end(), part.begin(), part.end());
    }
    return result;
  }

  // Replaces an edge that is not replaced yet by a chain, wherever the edge occurs.
  bool replace(const Directed_edge& old, const Edge_chain& chain)
  {
    const auto is_old = [&](const Directed_edge& e) { return e.edge == old.edge; };
    if(chain.size() == 1 && is_old(chain.front()))
      return chain.front().is_reversed == old.is_reversed;
    if(std::any_of(chain.begin(), chain.end(), is_old) || !merge_vertices(source(old), source(chain.front()))
       || !merge_vertices(target(old), target(chain.back())))
      return false;
    m_chains[old.edge] = old.is_reversed ? reversed(chain) : chain;
    for(auto& other : m_chains) {
      const bool is_changed = std::any_of(other.second.begin(), other.second.end(), is_old);
      if(is_changed)
        other.second = in_place(other.second);
      if((is_changed || other.first == old.edge) && !pieces(other.first, other.second))
        return false;
    }
    return true;
  }
};

// What stands in the model for an edge of the shape.
struct Edge_replacement
{
  bool is_point;               // whether a vertex stands for it
  Edge_merging::Pieces pieces; // none if the edge stands for itself
  Unit_range range{0, 1};      // the part of the edge between its vertices, as parameters of its curves
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_EDGE_MERGING_H
