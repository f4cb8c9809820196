// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_POLE_RING_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_POLE_RING_H

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Charted_boundary.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Pointed_apex.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Domain_walk.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Vertex_insertion.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Inserts the first inner points of a patch with poles: around each pole, between its neighbours on the boundary, such that triangles
// with equal angles of about 60 degrees meet there. Around the apex of a pointed cone only a few triangles have room, which
// refinement rarely finds; smoothing does not move their points.
template <class Evaluator>
class Pole_ring
{
  typedef typename Evaluator::Kernel Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef internal::Location<Triangulation> Location;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef Boundary_vertex<Kernel> Boundary_point;

  // No ring is inserted if the pieces of the boundary at the pole differ from their mean by more than this factor.
  static constexpr double tolerated_difference = 1.2;
  // The smallest distance between points, as a share of the arc between neighbours on the ring (half the radius at most).
  static constexpr double share_of_arc = 0.7;
  // In radians: with sectors below 52 degrees an apex is pointed, and smoothing would draw the ring towards it.
  static constexpr double sector_of_pointed_apex = 0.91;

  Triangulation& m_triangulation;
  const Evaluator& m_evaluate;
  const Charted_boundary<Kernel>& m_boundary; // that of the whole patch
  Vertex_insertion<Triangulation> m_insertion;

public:
  Pole_ring(Triangulation& triangulation, const Evaluator& evaluate, const Charted_boundary<Kernel>& boundary)
    : m_triangulation(triangulation), m_evaluate(evaluate), m_boundary(boundary), m_insertion(triangulation)
  {}

  // `loops` is the divided boundary, in the chart, of the patch or of a part of it.
  void operator()(const Boundary_loops<Kernel>& loops)
  {
    if(chart().is_identity())
      return;
    for(const auto& loop : loops) {
      if(lies_inside(loop))
        continue; // an edge that ends at a pole has the domain all around
      const std::size_t n = loop.size();
      for(std::size_t i = 0; i < n; ++i)
        if(chart().is_pole(loop[i].domain_point))
          insert_ring(loop[i], loop[(i + n - 1) % n], loop[(i + 1) % n]);
    }
  }

private:
  const auto& chart() const { return m_boundary.chart(); }

  void insert_ring(const Boundary_point& pole, const Boundary_point& before, const Boundary_point& after)
  {
    const double radius_before = std::sqrt(squared_distance(pole.surface_point, before.surface_point)),
                 radius_after = std::sqrt(squared_distance(pole.surface_point, after.surface_point));
    const double radius = 0.5 * (radius_before + radius_after);
    const Vertex_handle vertex = pole_vertex(pole.index);
    if(vertex == Vertex_handle() || (std::max)(radius_before, radius_after) > tolerated_difference * radius)
      return;
    const double angle = chart().angle_at_pole(vertex->point().domain_point());
    const bool is_all_around = before.index == after.index;
    const int n = number_of_sectors(angle, is_all_around);
    const double min_distance = (std::min)(0.5, share_of_arc * angle / n) * radius;
    // around a pointed apex the triangles must remain as long as the first piece of the seam
    const bool is_pointed = is_all_around && angle / n < sector_of_pointed_apex;
    const Point_2 from = m_boundary.domain_point(before.domain_point), to = m_boundary.domain_point(after.domain_point);
    for(int k = 1; k < n; ++k)
      insert(chart().chart_point(from + double(k) / n * (to - from)), vertex, radius, min_distance, is_pointed);
  }

  Vertex_handle pole_vertex(std::size_t index) const
  {
    for(Vertex_handle vertex : m_triangulation.finite_vertex_handles())
      if(vertex->index() == index && vertex->is_on_boundary() && chart().is_pole(vertex->point().domain_point()))
        return vertex;
    return Vertex_handle();
  }

  // Inserts a point of the ring if it is inside the domain and not much closer to others than the points of the ring are to each
  // other.
  void insert(const Point_2& position, Vertex_handle pole, double radius, double min_distance, bool is_pointed)
  {
    auto face = pole->face();
    while(!face->is_in_domain())
      face = face->neighbor(m_triangulation.ccw(face->index(pole)));
    const Location location = walk_in_domain(m_triangulation, face, position);
    if(location.kind != Location::IN_FACE
       && (location.kind != Location::ON_EDGE || location.face->is_constrained(location.index)))
      return;
    const auto evaluated = m_evaluate(position, radius);
    for(int i = 0; i < 3; ++i)
      if(squared_distance(evaluated.point.surface_point(), location.face->vertex(i)->point().surface_point())
         < min_distance * min_distance)
        return;
    const Vertex_handle vertex = location.kind == Location::IN_FACE
                                   ? m_insertion.insert_in_face(evaluated.point, location.face)
                                   : m_insertion.insert_in_edge(evaluated.point, location.face, location.index);
    vertex->set_kept(is_pointed);
    vertex->set_spacing(is_pointed ? radius : (std::min)(radius, evaluated.spacing_limit));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_POLE_RING_H
