// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_NARROW_FACE_CLOSER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_NARROW_FACE_CLOSER_H

#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Edge_merging.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Finds faces that are nowhere wider than a given width and closes them up: edges on one side replace the one on the other side, and
// short edges become a vertex. Short edges of other faces become a vertex as well. A face that cannot be closed up without harm
// to its neighbours stays.
class Narrow_face_closer
{
  typedef Parametric_surface_model_3<Open_cascade_surface_3> Model;
  typedef Model::Point_3 Point_3;
  typedef std::vector<std::size_t> Wire; // the edges of a loop of a face; a seam occurs twice

  static constexpr int number_of_samples = 16;

  struct Side_by_side
  {
    std::size_t edge;
    Edge_chain chain; // the edges along it
  };

  const Model& m_model;
  const TopTools_IndexedMapOfShape& m_faces;
  double m_width, m_trusted_tolerance;
  std::vector<bool> m_is_short; // by edge: not longer than the width, and not a point
  std::vector<std::vector<Wire>> m_wires; // by face
  std::vector<bool> m_is_kept; // by face: stays although it may be narrow
  Edge_merging m_merging;
  std::map<std::size_t, double> m_closed_up; // the widths of the faces that are closed up
  std::set<std::size_t> m_refused; // faces that stay; narrow ones beside them must stay, too

public:
  // \pre the model has the vertices and the edges of the shape
  Narrow_face_closer(const Model& model, const TopTools_IndexedMapOfShape& edges, const TopTools_IndexedMapOfShape& faces,
                     double width, double trusted_tolerance)
    : m_model(model), m_faces(faces), m_width(width), m_trusted_tolerance(trusted_tolerance),
      m_is_kept(std::size_t(faces.Extent()), false), m_merging(model, width, trusted_tolerance)
  {
    for(std::size_t e = 0; e < model.edges().size(); ++e)
      m_is_short.push_back(succeeds([&] { return is_short(e); }));
    for(int f = 1; f <= faces.Extent(); ++f)
      m_wires.push_back(wires_of(faces(f), edges));
    for(close_up_all(); !m_refused.empty(); close_up_all())
      keep_refused();
    for(std::size_t e = 0; e < m_is_short.size(); ++e)
      if(m_is_short[e] && !is_point(m_merging, e))
        collapse(e);
  }

  std::vector<Open_cascade_model_3::Closed_up_face> closed_up() const
  {
    std::vector<Open_cascade_model_3::Closed_up_face> result;
    for(const auto& face : m_closed_up)
      result.push_back({face.first, face.second});
    return result;
  }

  bool is_closed_up(std::size_t face) const { return m_closed_up.count(face) != 0; }

  // What replaces a vertex.
  std::size_t vertex_place(std::size_t v) const { return m_merging.vertex(v); }
  Edge_replacement edge_replacement(std::size_t e) const { return {is_point(m_merging, e), m_merging.pieces(e), {0, 1}}; }

private:
  static std::vector<Wire> wires_of(const TopoDS_Shape& face, const TopTools_IndexedMapOfShape& edges)
  {
    std::vector<Wire> result;
    for(TopoDS_Iterator wire(face); wire.More(); wire.Next())
      if(wire.Value().ShapeType() == TopAbs_WIRE) {
        result.emplace_back();
        for(TopoDS_Iterator edge(wire.Value()); edge.More(); edge.Next())
          if(edge.Value().Orientation() == TopAbs_FORWARD || edge.Value().Orientation() == TopAbs_REVERSED)
            result.back().push_back(std::size_t(edges.FindIndex(edge.Value())) - 1);
      }
    return result;
  }

  bool are_close(const Point_3& p, const Point_3& q) const { return squared_distance(p, q) <= square(m_width); }

  bool is_short(std::size_t e) const
  {
    const auto& edge = m_model.edges()[e];
    const Point_3 source = m_model.vertices()[edge.source];
    if(!(m_width > 0) || edge.is_collapsed || !edge.curve || edge.source == edge.target
       || !are_close(source, m_model.vertices()[edge.target]))
      return false;
    for(int i = 1; i < number_of_samples; ++i)
      if(!are_close(source, edge.curve->point(double(i) / number_of_samples)))
        return false;
    return true;
  }

  bool is_point(const Edge_merging& merging, std::size_t e) const
  {
    return m_is_short[e] && merging.source({e, false}) == merging.target({e, false});
  }

  // The short edges of a face, or the long ones; poles are neither.
  std::vector<std::size_t> edges_of(std::size_t f, bool are_short) const
  {
    std::vector<std::size_t> result;
    for(const Wire& wire : m_wires[f])
      for(const std::size_t e : wire)
        if(m_is_short[e] == are_short && !m_model.edges()[e].is_collapsed)
          result.push_back(e);
    return result;
  }

  void close_up_all()
  {
    m_merging = Edge_merging(m_model, m_width, m_trusted_tolerance);
    m_closed_up.clear();
    m_refused.clear();
    for(const bool is_long : {false, true}) // small faces first: they may be at the ends of narrow ones
      for(std::size_t f = 0; f < m_wires.size(); ++f)
        if(!m_is_kept[f] && succeeds([&] { return may_be_narrow(f, is_long); }))
          close_up(f);
    for(std::size_t f = 0; f < m_wires.size(); ++f)
      for(const Wire& wire : m_wires[f])
        if(!is_closed_up(f) && is_flat(wire))
          m_refused.insert(f);
  }

  // Whether a wire without its points consists of two edges side by side.
  bool is_flat(const Wire& wire) const
  {
    Wire left;
    std::copy_if(wire.begin(), wire.end(), std::back_inserter(left), [&](std::size_t e) { return !is_point(m_merging, e); });
    return left.size() < wire.size() && is_pair(left);
  }

  bool is_pair(const Wire& wire) const { return wire.size() == 2 && succeeds([&] { return !pairs_of(wire).empty(); }); }

  // A quick test that excludes most faces.
  bool may_be_narrow(std::size_t f, bool is_long) const
  {
    return edges_of(f, false).empty() != is_long && (!edges_of(f, true).empty() || !pairs_of(edges_of(f, false)).empty());
  }

  // Keeps the narrow faces around those that stay: a needle that is closed up only in a part is worse than one that is meshed.
  void keep_refused()
  {
    std::set<std::size_t> edges;
    const auto keep = [&](std::size_t f) {
      m_is_kept[f] = true;
      for(const Wire& wire : m_wires[f])
        edges.insert(wire.begin(), wire.end());
    };
    const std::vector<bool> before = m_is_kept;
    std::for_each(m_refused.begin(), m_refused.end(), keep);
    for(bool is_any_new = true; std::exchange(is_any_new, false);)
      for(std::size_t f = 0; f < m_wires.size(); ++f)
        if(!m_is_kept[f] && is_closed_up(f) && has_any(f, edges)) {
          keep(f);
          is_any_new = true;
        }
    if(m_is_kept == before) // the cause is unknown: no face is closed up
      m_is_kept.assign(m_is_kept.size(), true);
  }

  bool has_any(std::size_t f, const std::set<std::size_t>& edges) const
  {
    return std::any_of(m_wires[f].begin(), m_wires[f].end(), [&](const Wire& wire) {
      return std::any_of(wire.begin(), wire.end(), [&](std::size_t e) { return edges.count(e) != 0; });
    });
  }

  // Returns the result of `test`, or false if a curve or surface cannot be evaluated. Building the face will report the error.
  template <class Test>
  static bool succeeds(const Test& test)
  {
    try {
      return guarded(test);
    }
    catch(const std::exception&) {
      return false;
    }
  }

  void close_up(std::size_t f)
  {
    Edge_merging merging = m_merging;
    double width = 0;
    const auto merge = [&] { return merge_short_edges(f, merging, width) && merge_long_edges(f, merging, width); };
    if(!succeeds(merge) || !succeeds([&] { return is_area_small(f, (std::max)(width, m_width)); }))
      return;
    m_closed_up[f] = width;
    if(are_neighbors_well(merging))
      m_merging = std::move(merging);
    else {
      m_closed_up.erase(f);
      m_refused.insert(f);
    }
  }

  // Replaces a short edge that is not on a narrow face by a vertex if enough is left of the wires that contain it.
  void collapse(std::size_t e)
  {
    for(std::size_t f = 0; f < m_wires.size(); ++f)
      for(const Wire& wire : m_wires[f]) {
        Wire left;
        std::copy_if(wire.begin(), wire.end(), std::back_inserter(left), [&](std::size_t i) { return !m_is_short[i]; });
        const bool is_concerned = std::find(wire.begin(), wire.end(), e) != wire.end();
        if(is_concerned && (m_is_kept[f] || left.empty() || is_pair(left)))
          return;
      }
    Edge_merging merging = m_merging;
    if(merging.merge_vertices(m_model.edges()[e].source, m_model.edges()[e].target) && are_neighbors_well(merging))
      m_merging = std::move(merging);
  }

  bool merge_short_edges(std::size_t f, Edge_merging& merging, double& width) const
  {
    for(const std::size_t e : edges_of(f, true)) {
      const std::size_t v = m_model.edges()[e].source, w = m_model.edges()[e].target;
      if(!merging.merge_vertices(v, w))
        return false;
      width = (std::max)(width, std::sqrt(squared_distance(m_model.vertices()[v], m_model.vertices()[w])));
    }
    return true;
  }

  // Merges the edges of both sides: in pairs, or one edge with several others along it.
  bool merge_long_edges(std::size_t f, Edge_merging& merging, double& width) const
  {
    std::vector<Side_by_side> all = pairs_of(edges_of(f, false));
    if(all.empty() && !edges_of(f, false).empty())
      all = longest_and_others(f, merging);
    for(const Side_by_side& sides : all) {
      const auto across = merging.pieces(sides.edge, sides.chain);
      if(!across || !merging.merge({{sides.edge, false}}, sides.chain))
        return false;
      for(const auto& piece : *across)
        width = (std::max)(width, piece.match.distance());
    }
    return !all.empty() || edges_of(f, false).empty();
  }

  // The edges in pairs side by side; none if an edge has no partner.
  std::vector<Side_by_side> pairs_of(std::vector<std::size_t> edges) const
  {
    std::vector<Side_by_side> result;
    while(!edges.empty()) {
      const std::size_t e = edges.front();
      Edge_chain partner;
      for(std::size_t i = 1; i < edges.size() && partner.empty(); ++i)
        for(const bool is_reversed : {false, true})
          if(partner.empty() && edges[i] != e && m_merging.pieces(e, {{edges[i], is_reversed}})) {
            partner = {{edges[i], is_reversed}};
            edges.erase(edges.begin() + i);
          }
      if(partner.empty())
        return {};
      edges.erase(edges.begin());
      result.push_back({e, partner});
    }
    return result;
  }

  std::vector<Side_by_side> longest_and_others(std::size_t f, const Edge_merging& merging) const
  {
    std::vector<std::size_t> edges = edges_of(f, false);
    const std::size_t longest = take_longest(edges);
    const Edge_chain chain = chain_of(merging, longest, edges);
    for(const Edge_chain& i : {chain, Edge_merging::reversed(chain)})
      if(!i.empty() && merging.pieces(longest, i))
        return {{longest, i}};
    return {};
  }

  double length(std::size_t e) const
  {
    const auto& curve = m_model.edges()[e].curve;
    double result = 0;
    for(int i = 0; i < number_of_samples && curve; ++i)
      result += std::sqrt(squared_distance(curve->point(double(i) / number_of_samples),
                                           curve->point(double(i + 1) / number_of_samples)));
    return result;
  }

  std::size_t take_longest(std::vector<std::size_t>& edges) const
  {
    const auto is_shorter = [this](std::size_t a, std::size_t b) { return length(a) < length(b); };
    const auto place = std::max_element(edges.begin(), edges.end(), is_shorter);
    const std::size_t result = *place;
    edges.erase(place);
    return result;
  }

  // The chain of the other edges of a face from the source of the longest one to its target, which may be the same.
  static Edge_chain chain_of(const Edge_merging& merging, std::size_t longest, std::vector<std::size_t> others)
  {
    if(std::find(others.begin(), others.end(), longest) != others.end())
      return {};
    Edge_chain chain;
    std::size_t end = merging.source({longest, false});
    while(!others.empty()) {
      const auto next = std::find_if(others.begin(), others.end(), [&](std::size_t e) {
        return merging.source({e, false}) == end || merging.target({e, false}) == end;
      });
      if(next == others.end())
        return {};
      chain.push_back({*next, merging.source({*next, false}) != end});
      end = merging.target(chain.back());
      others.erase(next);
    }
    return chain;
  }

  // Two edges side by side may also bound the rest of a closed surface, whose area is large.
  bool is_area_small(std::size_t f, double width) const
  {
    GProp_GProps area, perimeter;
    BRepGProp::SurfaceProperties(m_faces(int(f) + 1), area);
    BRepGProp::LinearProperties(m_faces(int(f) + 1), perimeter);
    return std::fabs(area.Mass()) <= width * perimeter.Mass();
  }

  // Whether the boundaries of all remaining faces still bound them.
  bool are_neighbors_well(const Edge_merging& merging) const
  {
    for(std::size_t f = 0; f < m_wires.size(); ++f)
      if(!is_closed_up(f))
        for(const Wire& wire : m_wires[f])
          if(!is_well(merging, wire))
            return false;
    return true;
  }

  bool is_well(const Edge_merging& merging, const Wire& wire) const
  {
    const auto is_point = [&](std::size_t e) { return this->is_point(merging, e); };
    const auto is_changed = [&](std::size_t e) { return is_point(e) || merging.is_replaced(e); };
    if(std::none_of(wire.begin(), wire.end(), is_changed))
      return true;
    if(std::all_of(wire.begin(), wire.end(), is_point))
      return false;
    std::map<std::size_t, std::set<std::size_t>> edges; // replacements, with the edges that they replace
    for(const std::size_t e : wire)
      for(const Directed_edge& part : merging.chain(e))
        if(!is_point(e))
          edges[part.edge].insert(e);
    for(const auto& edge : edges)
      if(edge.second.size() > 1 && is_spike(merging, edge.first, edges))
        return false;
    return true;
  }

  // Whether a wire runs along an edge and directly back.
  template <class Edges>
  bool is_spike(const Edge_merging& merging, std::size_t e, const Edges& edges) const
  {
    for(const std::size_t end : {merging.source({e, false}), merging.target({e, false})}) {
      const auto is_other_at_end = [&](const auto& other) {
        return other.first != e
               && (merging.source({other.first, false}) == end || merging.target({other.first, false}) == end);
      };
      if(std::none_of(edges.begin(), edges.end(), is_other_at_end))
        return true;
    }
    return false;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_NARROW_FACE_CLOSER_H
