// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_MODEL_OF_PATCH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_MODEL_OF_PATCH_H

#include <CGAL/Parametric_domain_2.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/model/curve_box.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Boundary_size.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Parametric_surface_mesher/internal/support/group_points.h>
#include <CGAL/Parametric_surface_model_3.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Relative: points closer than this are the same point, computed in different ways.
constexpr double rounding_of_end_points = 1e-9;

// The largest absolute coordinate of the end points of curves of a domain; tolerances of gaps are relative to it.
template <class Kernel>
double extent(const Parametric_domain_2<Kernel>& domain)
{
  double result = 0;
  for(const auto& loop : domain.loops())
    for(const auto& curve : loop)
      result = (std::max)({result, std::fabs(curve.source().x()), std::fabs(curve.source().y())});
  return result;
}

// Refuses loops whose curves do not join, and makes those that join up to rounding join exactly.
template <class Kernel>
void close_loops(Parametric_domain_2<Kernel>& domain)
{
  const double tolerance = rounding_of_end_points * extent(domain);
  for(std::size_t l = 0; l < domain.loops().size(); ++l) {
    auto& loop = domain.loops()[l];
    if(loop.empty())
      throw Parametric_surface_mesh_error(numbered("loop", l) + " has no curve");
    for(std::size_t i = 0; i < loop.size(); ++i) {
      auto &curve = loop[i], &next = loop[(i + 1) % loop.size()];
      const double gap = std::sqrt(squared_distance(curve.target(), next.source()));
      if(!(gap <= tolerance))
        throw Parametric_surface_mesh_error(numbered("loop", l) + " is open: " + numbered("curve", i)
                                            + " ends at (u,v) = " + describe(curve.target()) + ", the next one starts at "
                                            + describe(next.source()));
      curve.set_end_points(curve.source(), next.source());
    }
    const Bbox_2 box = loop_box(loop, [](const auto& curve) -> const auto& { return curve; });
    if(box.xmin() == box.xmax() && box.ymin() == box.ymax())
      throw Parametric_surface_mesh_error(numbered("loop", l) + " has area zero: all of it is at (u,v) = "
                                          + describe(loop.front().source()));
  }
}

// Makes a model of one face from a patch: each curve of the domain is an edge, in the order of loops and curves. Curves
// that begin at the same point of the domain have a common vertex, and a curve that is a point in space is collapsed.
template <class Surface>
class Patch_model_maker
{
  typedef typename Surface::Geom_traits Kernel;
  typedef Parametric_surface_model_3<Surface> Model;
  typedef Parametric_domain_2<Kernel> Domain;

  const Surface& m_surface;
  Domain m_domain;
  std::vector<bool> m_is_collapsed;     // by curve
  std::vector<std::size_t> m_sources, m_targets; // by curve: the index of a curve that begins there
  Model m_model;

public:
  Patch_model_maker(const Surface& surface, const Domain& domain) : m_surface(surface), m_domain(domain) {}

  Model operator()()
  {
    close_loops(m_domain);
    find_collapsed_curves();
    find_ends();
    add_vertices_and_edges();
    add_face();
    return std::move(m_model);
  }

private:
  template <class Visit>
  void for_each_curve(Visit visit) const
  {
    for(const auto& loop : m_domain.loops())
      for(const auto& curve : loop)
        visit(curve);
  }

  void find_collapsed_curves()
  {
    Bbox_3 box;
    for_each_curve([&](const auto& curve) { box += curve_box(m_surface, curve); });
    for_each_curve([&](const auto& curve) {
      m_is_collapsed.push_back(diagonal(curve_box(m_surface, curve)) <= rounding_of_end_points * diagonal(box));
    });
  }

  void find_ends()
  {
    std::vector<typename Kernel::Point_2> sources;
    for_each_curve([&](const auto& curve) { sources.push_back(curve.source()); });
    m_sources = group_points(sources, rounding_of_end_points * extent(m_domain));
    std::size_t first = 0;
    for(const auto& loop : m_domain.loops()) {
      for(std::size_t i = 0; i < loop.size(); ++i)
        m_targets.push_back(m_sources[first + (i + 1) % loop.size()]);
      first += loop.size();
    }
  }

  void add_vertices_and_edges()
  {
    std::vector<std::size_t> ranks(m_sources.size()), parents(m_sources.size());
    boost::disjoint_sets<std::size_t*, std::size_t*> ends(ranks.data(), parents.data());
    for(std::size_t i = 0; i < m_sources.size(); ++i)
      ends.make_set(i);
    for(std::size_t i = 0; i < m_sources.size(); ++i)
      if(m_is_collapsed[i])
        ends.union_set(m_sources[i], m_targets[i]);
    std::map<std::size_t, std::size_t> vertices; // by representative
    std::size_t number = 0;
    for_each_curve([&](const auto& curve) {
      const std::size_t end = ends.find_set(m_sources[number++]);
      if(vertices.count(end) == 0)
        vertices[end] = m_model.add_vertex(m_surface.point(curve.source().x(), curve.source().y()));
    });
    for(std::size_t i = 0; i < m_sources.size(); ++i)
      m_model.add_edge(vertices[ends.find_set(m_sources[i])], vertices[ends.find_set(m_targets[i])], m_is_collapsed[i]);
  }

  void add_face()
  {
    typename Model::Face face{m_surface, {}};
    std::size_t edge = 0;
    for(const auto& loop : m_domain.loops()) {
      face.loops.emplace_back();
      for(const auto& curve : loop)
        face.loops.back().push_back({edge++, false, curve});
    }
    m_model.add_face(std::move(face));
  }
};

template <class Surface>
Parametric_surface_model_3<Surface>
model_of_patch(const Surface& surface, const Parametric_domain_2<typename Surface::Geom_traits>& domain)
{
  return Patch_model_maker<Surface>(surface, domain)();
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_MODEL_OF_PATCH_H
