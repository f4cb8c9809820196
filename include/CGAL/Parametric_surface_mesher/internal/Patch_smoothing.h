// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_SMOOTHING_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_SMOOTHING_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/Edge_flip.h>
#include <CGAL/Parametric_surface_mesher/internal/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/Star_limits.h>
#include <CGAL/Parametric_surface_mesher/internal/Valence_equalization.h>
#include <CGAL/Parametric_surface_mesher/internal/Vertex_star.h>
#include <CGAL/Parametric_surface_mesher/internal/for_each_with_lookahead.h>

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
good, valences are not what is wrong: their edges are not flipped, and all moves are made that gain anything.
Sweeps are thrifty until they are asked to be thorough: then hardly a vertex stays because its move would gain little.
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

  // what is not worth its time
  struct Thrift
  {
    double quality_of_perfect_star;
    double shortest_move;      // by the spacing
    double shortest_felt_move; // in a good star: from there on the vertices around are looked at again
  };

  static constexpr Thrift thrifty = {0.998, 0.03, 0.08}, thrifty_if_blocked = {0.998, 0.02, 0}, thorough = {0.9999, 0.01, 0};

  Triangulation& m_triangulation;
  const Evaluator& m_evaluate;
  const Star_limits m_limits;
  const bool m_is_blocked;
  Thrift m_thrift;
  Vertex_star<Triangulation, Metric_field> m_star;
  Valence_equalization<Evaluator> m_equalize_valences;
  std::vector<Vertex_handle> m_crowded; // by more than six neighbours

public:
  Patch_smoothing(Triangulation& triangulation, const Evaluator& evaluate, const Parametric_surface_mesh_criteria& criteria)
    : m_triangulation(triangulation), m_evaluate(evaluate), m_limits(criteria), m_is_blocked(has_blocked_face(triangulation)),
      m_thrift(m_is_blocked ? thrifty_if_blocked : thrifty), m_star(triangulation, evaluate.oracle().metric()),
      m_equalize_valences(triangulation, evaluate, criteria)
  {}

  // from the next sweep on; all vertices are looked at again
  void be_thorough()
  {
    m_thrift = thorough;
    for(Vertex_handle vertex : m_triangulation.finite_vertex_handles())
      vertex->set_settled(false);
  }

  // one sweep; returns the number of vertices that have moved
  std::size_t operator()()
  {
    std::size_t number_of_moves = 0;
    for_each_vertex_with_lookahead(m_triangulation, [&](Vertex_handle vertex) {
      if(!vertex->is_on_boundary() && !vertex->is_settled() && !vertex->is_kept())
        number_of_moves += smooth(vertex);
    });
    for(Face_handle face : m_triangulation.finite_face_handles())
      if(face->is_in_domain() && face->state() == Face_state::UNKNOWN)
        flip_obtuse(face);
    for(Vertex_handle vertex : m_crowded)
      m_equalize_valences(vertex);
    m_crowded.clear();
    return number_of_moves;
  }

private:
  static bool has_blocked_face(const Triangulation& triangulation)
  {
    const auto faces = triangulation.finite_face_handles();
    return std::any_of(faces.begin(), faces.end(), [](Face_handle face) {
      return face->is_in_domain() && face->state() == Face_state::BLOCKED;
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
    if(before.mean_ratio > m_thrift.quality_of_perfect_star)
      return false;
    const Point_2 target = m_star.mean_of_apices();
    if(is_near(vertex->point(), target, m_thrift.shortest_move * vertex->spacing()) || !m_star.is_around(target))
      return false;
    const Point point = m_evaluate.position(target, vertex->spacing()).point;
    const Star_shape after = m_star.shape(point);
    if(!after.quality.is_better_than(before) || !m_limits.allow(after, [&] { return m_star.shape(vertex->point()); })
       || m_star.is_inverted(point, m_evaluate.oracle()))
      return false;
    const bool is_felt = !before.is_good() || !is_near(point, vertex->point(), m_thrift.shortest_felt_move * vertex->spacing());
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
    if(edge.worst_after(metric, squared_mean_ratio) > edge.worst_before(metric, squared_mean_ratio) && edge.is_valid())
      edge.flip();
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_SMOOTHING_H
