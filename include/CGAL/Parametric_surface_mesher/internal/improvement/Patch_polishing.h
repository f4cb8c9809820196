// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_PATCH_POLISHING_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_PATCH_POLISHING_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Better_place.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Failure_count.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Guarded_change.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Vertex_star.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Triangle_quality.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/for_each_with_lookahead.h>

#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Sweeps over the inner vertices of a patch that is refined: each climbs the slope of a quality that counts mean ratios and
smallest angles, in small steps that make no more triangles fail a criterion, and no smallest angle below 40 degrees smaller
than it was. Where there is such an angle, the mean of the places where the triangles around would be equilateral is tried
first. No edge is flipped.
*/
template <class Evaluator, class Judge>
class Patch_polishing
{
  typedef Patch_triangulation_2<typename Evaluator::Kernel> Triangulation;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Evaluator::Kernel::Point_2 Point_2;
  typedef Vertex_star<Triangulation, typename Evaluator::Oracle::Metric_field> Star;
  typedef internal::Failure_count<Judge> Failure_count;

  static constexpr double quality_of_perfect_star = 0.998;
  // By the spacing. The smallest angle has kinks, so that none is right everywhere.
  static constexpr double long_step = 0.03, short_step = 0.01;

  Triangulation& m_triangulation;
  Star m_star;
  Better_place<Evaluator, Star> m_better_place;
  const Failure_count m_number_of_failures;
  Guarded_change<Triangulation, Judge> m_change;

public:
  // all vertices are looked at in the first sweep, later those around moves
  // \pre there is a verdict on all faces
  Patch_polishing(Triangulation& triangulation, const Evaluator& evaluate, const Judge& judge,
                  const Parametric_surface_mesh_criteria& criteria)
    : m_triangulation(triangulation), m_star(triangulation, evaluate.oracle().metric()),
      m_better_place(evaluate, m_star, criteria), m_number_of_failures(judge, criteria),
      m_change(m_number_of_failures)
  {
    for(Vertex_handle vertex : triangulation.finite_vertex_handles())
      vertex->set_settled(false);
  }

  // it refers to itself
  Patch_polishing(const Patch_polishing&) = delete;
  Patch_polishing& operator=(const Patch_polishing&) = delete;

  // One sweep, or a part of one that is stopped. Returns the number of vertices that have moved.
  template <class GoFurther>
  std::size_t operator()(const GoFurther& go_further)
  {
    std::size_t number_of_moves = 0;
    for_each_vertex_with_lookahead(m_triangulation, [&](Vertex_handle vertex) {
      if(vertex->is_on_boundary() || vertex->is_settled() || vertex->is_kept() || !go_further())
        return;
      m_star.collect(vertex);
      const bool has_moved = move_if_better(vertex);
      vertex->set_settled(!has_moved);
      if(has_moved)
        m_star.unsettle_ring();
      number_of_moves += has_moved;
    });
    return number_of_moves;
  }

private:
  bool move_if_better(Vertex_handle vertex)
  {
    const Star_quality before = m_star.quality(Mean_ratio_and_angle());
    if(before.mean > quality_of_perfect_star)
      return false;
    if(!before.is_good() && move_if_better(vertex, m_star.mean_of_apices(), before))
      return true;
    const Point_2 position = m_star.center().domain_point();
    const auto direction = m_star.spacing() * m_star.direction_of_ascent(Mean_ratio_and_angle());
    return move_if_better(vertex, position + long_step * direction, before)
           || move_if_better(vertex, position + short_step * direction, before);
  }

  bool move_if_better(Vertex_handle vertex, const Point_2& target, const Star_quality& before)
  {
    if(!m_better_place.is_found_at(target, before, Mean_ratio_and_angle()))
      return false;
    m_change.begin(m_star.faces(), before.squared_sine);
    m_change.transaction().move(vertex, m_better_place.point());
    if(m_change.is_allowed(m_star.faces()))
      return true;
    m_change.transaction().roll_back();
    return false;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_PATCH_POLISHING_H
