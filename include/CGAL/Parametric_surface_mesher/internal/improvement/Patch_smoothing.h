// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_PATCH_SMOOTHING_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_PATCH_SMOOTHING_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Better_place.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Valence_equalization.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Vertex_star.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Triangle_quality.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Edge_flip.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/for_each_with_lookahead.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Sweeps over the inner vertices of a patch: each is moved to the mean of the places where the triangles around it would be
equilateral, if that makes them better, and edges between two triangles with opposite angles of more than 180 degrees in
space are flipped, as are those that keep valences from being six. Where triangles are left that insertion could not make
good, valences are not what is wrong: their edges are not flipped, and shorter moves are made, too.
*/
template <class Evaluator>
class Patch_smoothing
{
  typedef typename Evaluator::Kernel Kernel;
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Point Point;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Evaluator::Oracle::Metric_field Metric_field;

  typedef Vertex_star<Triangulation, Metric_field> Star;

  // What is not worth its time. Lengths are shares of the spacing.
  static constexpr double quality_of_perfect_star = 0.998, shortest_move = 0.03, shortest_move_if_blocked = 0.02;
  static constexpr double shortest_felt_move = 0.08; // in a good star: from there on vertices around are looked at again

  Triangulation& m_triangulation;
  const Evaluator& m_evaluate;
  const bool m_is_blocked;
  Star m_star;
  Better_place<Evaluator, Star> m_better_place;
  Valence_equalization<Evaluator> m_equalize_valences;
  std::vector<Vertex_handle> m_crowded; // by more than six neighbours

public:
  Patch_smoothing(Triangulation& triangulation, const Evaluator& evaluate, const Parametric_surface_mesh_criteria& criteria)
    : m_triangulation(triangulation), m_evaluate(evaluate), m_is_blocked(has_refused_face(triangulation)),
      m_star(triangulation, evaluate.oracle().metric()), m_better_place(evaluate, m_star, criteria),
      m_equalize_valences(triangulation, evaluate, criteria)
  {}

  // it refers to itself
  Patch_smoothing(const Patch_smoothing&) = delete;
  Patch_smoothing& operator=(const Patch_smoothing&) = delete;

  // one sweep; returns the number of vertices that have moved
  template <class GoFurther>
  std::size_t operator()(const GoFurther& go_further)
  {
    std::size_t number_of_moves = 0;
    for_each_vertex_with_lookahead(m_triangulation, [&](Vertex_handle vertex) {
      if(!vertex->is_on_boundary() && !vertex->is_settled() && !vertex->is_kept() && go_further())
        number_of_moves += smooth(vertex);
    });
    for(Face_handle face : m_triangulation.finite_face_handles())
      if(face->is_in_domain() && !face->verdict().is_known() && go_further())
        flip_obtuse(face);
    for(Vertex_handle vertex : m_crowded)
      if(go_further())
        m_equalize_valences(vertex);
    m_crowded.clear();
    return number_of_moves;
  }

private:
  static bool has_refused_face(const Triangulation& triangulation)
  {
    const auto faces = triangulation.finite_face_handles();
    return std::any_of(faces.begin(), faces.end(), [](Face_handle face) {
      return face->is_in_domain() && face->verdict().is_refused();
    });
  }

  bool smooth(Vertex_handle vertex)
  {
    m_star.collect(vertex);
    if(m_star.faces().size() > 6 && !m_is_blocked)
      m_crowded.push_back(vertex);
    vertex->set_settled(true);
    return move_if_better(vertex);
  }

  bool move_if_better(Vertex_handle vertex)
  {
    const Star_quality before = m_star.quality();
    if(before.mean > quality_of_perfect_star)
      return false;
    const Point_2 target = m_star.mean_of_apices();
    const double shortest = m_is_blocked ? shortest_move_if_blocked : shortest_move;
    if(is_near(vertex->point(), target, shortest * vertex->spacing()) || !m_better_place.is_found_at(target, before))
      return false;
    const Point& point = m_better_place.point();
    const bool is_felt = m_is_blocked || !before.is_good()
                         || !is_near(point, vertex->point(), shortest_felt_move * vertex->spacing());
    m_star.try_at(point);
    if(is_felt)
      unsettle_around(vertex);
    return true;
  }

  void unsettle_around(Vertex_handle vertex)
  {
    vertex->set_settled(false);
    m_star.unsettle_ring();
  }

  static bool is_near(const Point& p, const Point_2& target, double distance)
  {
    return p.tensor().squared_length(target.x() - p.x(), target.y() - p.y()) < distance * distance;
  }

  // Flips the edge opposite to an obtuse angle, if the two triangles become better. Of two opposite angles with a sum above
  // 180 degrees one at least is obtuse.
  void flip_obtuse(Face_handle face)
  {
    const std::array<double, 3> lengths = squared_lengths(face, m_evaluate.oracle().metric());
    for(int i = 0; i < 3; ++i)
      if(lengths[i] > lengths[(i + 1) % 3] + lengths[(i + 2) % 3] && !face->is_constrained(i)) {
        flip_if_better(Edge_flip<Triangulation>(m_triangulation, face, i));
        return;
      }
  }

  void flip_if_better(Edge_flip<Triangulation> edge)
  {
    const auto& metric = m_evaluate.oracle().metric();
    const Squared_mean_ratio quality;
    if(edge.worst_after(metric, quality) > edge.worst_before(metric, quality) && edge.is_valid())
      edge.flip();
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_PATCH_SMOOTHING_H
