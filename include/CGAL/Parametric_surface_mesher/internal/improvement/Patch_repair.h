// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_PATCH_REPAIR_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_PATCH_REPAIR_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Face_turning.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Failure_count.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Guarded_change.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Repair_places.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Vertex_star.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Edge_flip.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Transaction.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Vertex_removal.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <initializer_list>
#include <iterator>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
What insertion of points could not make good, and what has an angle below the one aimed at: edges of such faces are
flipped and their inner vertices moved, where that raises the smallest angle around and makes no face too large or too far
from the surface. If neither helps a face that fails the angle, one of its inner vertices is taken out, on the same terms:
beside a piece of boundary that is longer than the edges around, there often is one too many. The boundary stays. Most of
these faces lie beside it, where a vertex is a little off the one place that suits its neighbours, or where fronts have met.
Where they are many, it is the boundary that keeps them from being better, and small steps are made but for faces near the
criterion of the angle, and around those that fail one.
*/
template <class Evaluator, class Judge>
class Patch_repair
{
  typedef typename Evaluator::Kernel Kernel;
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Point Point;
  typedef Vertex_star<Triangulation, typename Evaluator::Oracle::Metric_field> Star;
  typedef internal::Failure_count<Judge> Failure_count;

  // of the squared sine
  static constexpr double least_gain = 1.01, least_gain_of_many = 1.2;
  static constexpr double share_of_near = 1.3; // 35 degrees, for a criterion of 30

  static constexpr double share_of_few = 0.1; // of the faces

  // Enough for all faces but where nearly all are poor.
  static constexpr std::size_t default_max_number_of_attempts = 1000, faces_for_attempt = 20;
  // After these, a quarter as many at faces that fail a criterion: most of the others are left for the sake of the boundary.
  static constexpr std::size_t share_at_failures = 4;

  Triangulation& m_triangulation;
  const Evaluator& m_evaluate;
  double m_squared_sine, m_squared_sine_of_criterion, m_squared_min_edge;
  double m_least_gain = least_gain; // for the face that is repaired
  bool m_are_poor_few = true;       // of the faces
  bool m_has_new_failures = false;
  const bool m_is_unfinished;       // for want of vertices: then none is taken out
  Star m_star;
  Repair_places<Evaluator, Star> m_places;
  Face_turning<Evaluator> m_turn_over;
  const Failure_count m_number_of_failures;
  Guarded_change<Triangulation, Judge> m_change;
  std::deque<Face_handle> m_queue;
  std::unordered_set<Face_handle> m_removed; // faces

public:
  Patch_repair(Triangulation& triangulation, const Evaluator& evaluate, const Judge& judge,
               const Parametric_surface_mesh_criteria& criteria)
    : m_triangulation(triangulation), m_evaluate(evaluate),
      m_squared_sine(squared_sine_of_degrees(criteria.improvement_angle())),
      m_squared_sine_of_criterion(squared_sine_of_degrees(criteria.angle())),
      m_squared_min_edge(square(criteria.min_edge())),
      m_is_unfinished(triangulation.number_of_vertices() >= criteria.max_number_of_vertices()),
      m_star(triangulation, evaluate.oracle().metric()), m_places(evaluate, m_star),
      m_turn_over(triangulation, evaluate, m_squared_min_edge),
      m_number_of_failures(judge, criteria),
      m_change(m_number_of_failures)
  {}

  // it refers to itself
  Patch_repair(const Patch_repair&) = delete;
  Patch_repair& operator=(const Patch_repair&) = delete;

  // Each change raises the smallest angle of some faces; the work is bounded all the same. Where the criteria ask for more
  // than can be, bad faces are many and improvement would take longer than refinement: some are left as they are, those that
  // fail a criterion last. A face that could not be repaired is tried again once something beside it has changed, and not before.
  // Returns how many faces that fail the angle were left because of that.
  template <class GoFurther>
  std::size_t operator()(const GoFurther& go_further)
  {
    return (*this)(go_further, max_number_of_attempts(), max_number_of_attempts() / share_at_failures);
  }

  // The same at faces that fail a criterion alone.
  template <class GoFurther>
  std::size_t at_failures(const GoFurther& go_further)
  {
    return (*this)(go_further, 0, max_number_of_attempts() / share_at_failures);
  }

  // `attempts_left`: at faces as they come. `attempts_at_failures_left`: at those that fail a criterion, after these
  template <class GoFurther>
  std::size_t operator()(const GoFurther& go_further, std::size_t attempts_left, std::size_t attempts_at_failures_left)
  {
    add_all_poor(go_further);
    if(m_queue.empty())
      return 0;
    for(Vertex_handle vertex : m_triangulation.finite_vertex_handles())
      vertex->set_settled(false);
    std::size_t number_of_left = 0;
    while(!m_queue.empty()) {
      const Face_handle face = take_first();
      if(face == Face_handle() || !is_poor(face))
        continue;
      std::size_t& attempts = attempts_left > 0 || !face->verdict().fails() ? attempts_left : attempts_at_failures_left;
      if(attempts > 0 && go_further()) {
        --attempts;
        if(!repair(face))
          note_unrepaired(face);
      }
      else
        number_of_left += leave(face);
    }
    return number_of_left;
  }

  // Whether there are faces that fail a criterion and have become so here: refinement has not looked at them.
  bool has_new_failures() const { return m_has_new_failures; }

private:
  std::size_t max_number_of_attempts() const
  {
    return default_max_number_of_attempts + m_triangulation.number_of_faces() / faces_for_attempt;
  }

  void note_unrepaired(Face_handle face)
  {
    const Verdict verdict = face->verdict();
    if(verdict.is_refused() && verdict.refusal() == Unmet_cause::WORK_LIMIT)
      face->refuse(Unmet_cause::NO_BETTER_POINT); // that limit was for an earlier attempt
    m_has_new_failures = m_has_new_failures || (verdict.fails() && !verdict.is_refused());
  }

  // What repair could have made better is left because of the bound on the work, whatever refinement has said of it, but for
  // the limit of vertices: with more of them there might be nothing to repair. Tells whether the face fails the angle.
  bool leave(Face_handle face)
  {
    const bool fails_angle = face->verdict().fails(Mesh_criterion::ANGLE);
    if(fails_angle && !m_is_unfinished)
      face->refuse(Unmet_cause::WORK_LIMIT);
    return fails_angle;
  }

  // \pre there is a verdict on the face
  bool is_poor(Face_handle face) const
  {
    return face->verdict().fails() || (m_squared_sine > 0 && squared_sine(face) < m_squared_sine);
  }

  // of the queue; returns none if it was removed
  Face_handle take_first()
  {
    const Face_handle face = m_queue.front();
    m_queue.pop_front();
    if(m_removed.count(face) > 0)
      return Face_handle();
    face->set_waiting(false);
    return face;
  }

  double squared_sine(Face_handle face) const
  {
    return is_collapsed(face) ? 1 : face_measures(face, m_evaluate.oracle().metric()).squared_smallest_sine;
  }

  template <class GoFurther>
  void add_all_poor(const GoFurther& go_further)
  {
    std::size_t number_of_faces = 0;
    for(Face_handle face : m_triangulation.finite_face_handles())
      if(face->is_in_domain() && go_further()) {
        ++number_of_faces;
        add_if_poor(face);
      }
    m_are_poor_few = double(m_queue.size()) < share_of_few * double(number_of_faces);
  }

  void add_if_poor(Face_handle face)
  {
    if(face->is_waiting() || !is_poor(face))
      return;
    face->set_waiting(true);
    m_queue.push_back(face);
  }

  // A vertex that has no better place is settled until its star changes.
  bool repair(Face_handle face)
  {
    const bool is_urgent = squared_sine(face) < share_of_near * m_squared_sine_of_criterion || is_at_failure(face);
    m_least_gain = m_are_poor_few || is_urgent ? least_gain : least_gain_of_many;
    if(m_turn_over.is_inverted(face) && turn_over(face))
      return true;
    for(int i = 0; i < 3; ++i)
      if(flip_if_better(face, i))
        return true;
    for(int i = 0; i < 3; ++i) {
      const Vertex_handle vertex = face->vertex(i);
      if(vertex->is_on_boundary() || vertex->is_settled())
        continue;
      if(move_if_better(vertex, {1., 0.5, 0.25, 0.1}))
        return true;
      vertex->set_settled(true);
    }
    if(!m_is_unfinished && squared_sine(face) < m_squared_sine_of_criterion)
      for(int i = 0; i < 3; ++i)
        if(!face->vertex(i)->is_on_boundary() && remove_if_better(face->vertex(i)))
          return true;
    if(m_number_of_failures.is_needle(squared_sine(face))) // one that much is in the way of
      for(int i = 0; i < 3; ++i)
        if(!face->vertex(i)->is_on_boundary() && move_if_better(face->vertex(i), {0.05, 0.02}))
          return true;
    return false;
  }

  // Whether it has a vertex with a face that fails a criterion.
  bool is_at_failure(Face_handle face) const
  {
    for(int i = 0; i < 3; ++i) {
      auto around = m_triangulation.incident_faces(face->vertex(i));
      const auto first = around;
      do
        if(around->is_in_domain() && around->verdict().fails())
          return true;
      while(++around != first);
    }
    return false;
  }

  bool turn_over(Face_handle face)
  {
    const std::vector<Face_handle>& changed = m_turn_over(face);
    m_number_of_failures.examine_all(changed);
    add_around(changed);
    return !changed.empty();
  }

  // changed faces and their neighbours are looked at again
  template <class Faces>
  void add_around(const Faces& changed)
  {
    for(Face_handle face : changed) {
      add_if_poor(face);
      for(int i = 0; i < 3; ++i)
        if(!face->is_constrained(i))
          add_if_poor(face->neighbor(i));
    }
  }

  bool flip_if_better(Face_handle face, int i)
  {
    if(face->is_constrained(i))
      return false;
    const Edge_flip<Triangulation> edge(m_triangulation, face, i);
    const auto& metric = m_evaluate.oracle().metric();
    const auto sine = [](const std::array<double, 3>& lengths) { return face_measures(lengths).squared_smallest_sine; };
    const double worst = edge.worst_before(metric, sine);
    if(!(edge.worst_after(metric, sine) > m_least_gain * worst) || !edge.is_valid())
      return false;
    const auto faces = edge.faces();
    m_change.begin(faces, worst);
    m_change.transaction().flip(edge);
    if(m_change.is_allowed(faces)) {
      add_around(faces);
      return true;
    }
    m_change.transaction().roll_back();
    return false;
  }

  // Tries places at shares of the way to apices.
  bool move_if_better(Vertex_handle vertex, std::initializer_list<double> shares)
  {
    m_star.collect(vertex);
    const Point old_point = vertex->point();
    const double old_sine = m_star.squared_smallest_sine(old_point), least = m_least_gain * old_sine;
    bool has_begun = false;
    for(const auto& candidate : m_places(vertex, least, shares)) {
      if(!m_star.is_around(candidate.position))
        continue;
      const Point point = m_evaluate.position(candidate.position, vertex->spacing()).point;
      if(!(m_star.squared_smallest_sine(point, least) > least) || !m_star.is_far_enough(point, old_point, m_squared_min_edge))
        continue;
      if(!has_begun)
        m_change.begin(m_star.faces(), old_sine);
      has_begun = true;
      m_change.transaction().move(vertex, point);
      if(m_change.is_allowed(m_star.faces())) {
        m_star.unsettle_ring();
        add_around(m_star.faces());
        return true;
      }
    }
    if(has_begun)
      m_change.transaction().roll_back();
    return false;
  }

  bool remove_if_better(Vertex_handle vertex)
  {
    m_star.collect(vertex);
    const double worst = m_star.squared_smallest_sine(vertex->point());
    m_change.begin(m_star.faces(), worst);
    const auto sine = [](const std::array<double, 3>& lengths) { return face_measures(lengths).squared_smallest_sine; };
    Vertex_removal<Triangulation> removal(m_triangulation, vertex, m_change.transaction());
    if(removal.cut_ears(m_evaluate.oracle().metric(), sine, m_least_gain * worst)
       && is_better_without(vertex, removal, worst)) {
      remove(vertex, removal);
      return true;
    }
    m_change.transaction().roll_back();
    return false;
  }

  // \pre three faces are left at the vertex
  bool is_better_without(Vertex_handle vertex, Vertex_removal<Triangulation>& removal, double worst) const
  {
    std::vector<Face_handle> faces = faces_without(vertex);
    return removal.with_last_face([&](Face_handle last) {
      faces.push_back(last);
      return !is_collapsed(last) && !m_turn_over.is_inverted(last) && squared_sine(last) > m_least_gain * worst
             && m_change.is_allowed(faces);
    });
  }

  // \pre three faces are left at the vertex
  void remove(Vertex_handle vertex, Vertex_removal<Triangulation>& removal)
  {
    std::vector<Face_handle> changed = faces_without(vertex);
    const std::vector<Face_handle> faces = removal.faces();
    const Face_handle last = removal.remove();
    std::copy_if(faces.begin(), faces.end(), std::inserter(m_removed, m_removed.end()),
                 [=](Face_handle face) { return face != last; });
    changed.push_back(last);
    m_number_of_failures.examine_all(changed);
    add_around(changed);
  }

  // those of the star that are no longer at its centre
  std::vector<Face_handle> faces_without(Vertex_handle vertex) const
  {
    std::vector<Face_handle> result;
    std::copy_if(m_star.faces().begin(), m_star.faces().end(), std::back_inserter(result),
                 [&](Face_handle face) { return !face->has_vertex(vertex); });
    return result;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_PATCH_REPAIR_H
