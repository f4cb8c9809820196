// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_PATCH_REFINEMENT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_PATCH_REFINEMENT_H

#include <CGAL/Mesh_2/Face_badness.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Advancing_front.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Bad_face_queue.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Inner_points.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Landing.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Point_placement.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/for_each_with_lookahead.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Refinement of a patch (paper, section "Procedure"): while a triangle is bad, insert a point at the centre of its
// circumellipse, or elsewhere if that is behind the boundary or too close to it. The boundary is never split.
template <class Evaluator, class Criteria, class Visitor>
class Patch_refinement
{
public:
  typedef decltype(std::declval<const Criteria&>().is_bad_object(std::declval<const Evaluator&>().oracle())) Is_bad;
  typedef typename Criteria::Quality Quality;

private:
  typedef typename Evaluator::Kernel Kernel;
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Kernel::Point_2 Point_2;
  typedef internal::Inner_points<Evaluator> Inner_points;
  typedef typename Inner_points::Location Location;
  typedef typename Inner_points::Candidate Candidate;
  typedef typename Point_placement<Kernel>::Weights Weights;

  static constexpr double fraction_of_spacing = 0.15;
  // Of a point's place, by the circumradius. What a front has left is at odd places, where small errors do not matter.
  static constexpr double tolerated_error = 0.02, tolerated_error_after_front = 0.2;
  static const int max_number_of_corrections = 4;

  Triangulation& m_triangulation;
  const Evaluator& m_evaluate;
  const Criteria& m_criteria;
  Visitor& m_visitor;
  Is_bad m_is_bad;
  Bad_face_queue<Face_handle> m_queue;
  Inner_points m_points;
  std::vector<Point_2> m_positions;
  double m_squared_min_distance, m_tolerated_squared_error;
  bool m_tests_shape_only = false;
  bool m_is_stopped = false;

public:
  Patch_refinement(Triangulation& triangulation, const Evaluator& evaluate, const Criteria& criteria, Visitor& visitor)
    : m_triangulation(triangulation), m_evaluate(evaluate), m_criteria(criteria), m_visitor(visitor),
      m_is_bad(criteria.is_bad_object(evaluate.oracle())), m_points(triangulation, evaluate),
      m_squared_min_distance(square(criteria.min_edge())),
      m_tolerated_squared_error(
        square(criteria.placement() == Mesh_point_placement::FRONTAL ? tolerated_error_after_front : tolerated_error))
  {}

  // The first points, from the boundary inwards.
  template <class Faces>
  void advance_front(const Faces& faces)
  {
    Advancing_front<Evaluator, Visitor> advance(m_triangulation, m_points, m_criteria.max_number_of_vertices(), m_visitor);
    advance(faces);
    m_is_stopped = advance.is_stopped();
  }

  // Refines until no triangle fails the criteria, as far as they can be met.
  void operator()()
  {
    m_tests_shape_only = false;
    refine_all();
  }

  // The same for size and angle alone, which cost little to test: most triangles on the way do not live to be tested whole.
  // Criteria of the user's own are tested whole all the same.
  void refine_by_shape()
  {
    m_tests_shape_only = true;
    refine_all();
  }

  const Is_bad& is_bad() const { return m_is_bad; }
  bool is_stopped() const { return m_is_stopped; }

  // why a bad face was left
  Unmet_cause cause(Face_handle face) const
  {
    if(m_is_stopped)
      return Unmet_cause::STOPPED;
    if(is_full())
      return Unmet_cause::VERTEX_LIMIT;
    for(int i = 0; i < 3; ++i)
      if(face->vertex(i)->is_on_boundary())
        return Unmet_cause::BOUNDARY;
    const Face_measures measures = face_measures(face, m_evaluate.oracle().metric());
    return squared_distance_by_shape(measures) < required_squared_distance(face, measures)
             ? Unmet_cause::MINIMUM_EDGE
             : Unmet_cause::NO_BETTER_POINT;
  }

  std::size_t number_of_replaced_tensors() const { return m_points.number_of_replaced_tensors(); }

private:
  void refine_all()
  {
    for_each_face_with_lookahead(m_triangulation, [this](Face_handle face) {
      if(face->is_in_domain())
        examine(face);
    });
    for(std::size_t n = 1; !m_is_stopped; ++n) {
      const Face_handle face = m_queue.pop();
      if(face == Face_handle())
        break;
      refine(face);
      if(n % 512 == 0)
        report_progress();
    }
  }

  Mesh_2::Face_badness badness(Face_handle face, Quality& quality) const
  {
    if(is_collapsed(face))
      return Mesh_2::NOT_BAD;
    typedef Parametric_surface_mesh_criteria::Is_bad<typename Evaluator::Oracle> Own_is_bad;
    if constexpr(std::is_same_v<Is_bad, Own_is_bad>) {
      if(m_tests_shape_only)
        return m_is_bad.is_bad_by_shape(face, quality);
      if(face->state() == Face_state::GOOD && m_is_bad.is_bad_by_deviation(face, quality) == Mesh_2::NOT_BAD)
        return Mesh_2::NOT_BAD; // its shape was found good before
    }
    return m_is_bad(face, quality);
  }

  bool is_full() const { return m_triangulation.number_of_vertices() >= m_criteria.max_number_of_vertices(); }

  void report_progress()
  {
    m_visitor.on_progress(m_triangulation.number_of_vertices(), m_queue.size());
    m_is_stopped = !m_visitor.go_further();
  }

  void examine(Face_handle face)
  {
    Quality quality;
    const Mesh_2::Face_badness found = badness(face, quality);
    if(found == Mesh_2::NOT_BAD)
      face->set_state(Face_state::GOOD);
    else {
      face->set_state(Face_state::QUEUED);
      m_queue.push(face, quality.badness,
                   quality.is_well_shaped ? Urgency::LAST
                   : found == Mesh_2::IMPERATIVELY_BAD ? Urgency::FIRST : Urgency::NORMAL);
    }
  }

  void refine(Face_handle face)
  {
    if(is_full() || !insert_for(face))
      face->set_state(Face_state::BLOCKED);
  }

  bool insert_for(Face_handle face)
  {
    const Face_measures measures = face_measures(face, m_evaluate.oracle().metric());
    const double squared_distance = required_squared_distance(face, measures);
    Candidate candidate;
    m_positions.clear();
    if(locate(face, first_weights(face, measures), measures.squared_circumradius, candidate)
       && m_points.is_far_enough(candidate, squared_distance)) {
      if(Inner_points::is_near_boundary(candidate) && encroaches(candidate))
        return insert_alternative(face, measures, squared_distance);
      insert(candidate);
      return true;
    }
    if(!Inner_points::is_near_boundary(candidate))
      return insert_alternative(face, measures, squared_distance);
    append_apices(candidate.location);
    return insert_alternative(face, measures, squared_distance);
  }

  Weights first_weights(Face_handle face, const Face_measures& measures) const
  {
    if(m_criteria.placement() != Mesh_point_placement::OFF_CENTER)
      return Point_placement<Kernel>::circumcenter_weights(measures);
    const double spacing = (face->vertex(0)->spacing() + face->vertex(1)->spacing() + face->vertex(2)->spacing()) / 3;
    return Point_placement<Kernel>::off_center_weights(measures, m_criteria.angle() * std::atan(1.) / 45, spacing);
  }

  // The point of the face with these barycentric coordinates. Where the parametrisation changes its speed within the face,
  // its affine map is corrected by where points land.
  bool locate(Face_handle face, const Weights& weights, double squared_circumradius, Candidate& candidate)
  {
    if(!m_points.locate(face, Point_placement<Kernel>::barycentric(face, weights), candidate))
      return false;
    const Landing<Kernel> landing(face, weights);
    for(int step = 0; step < max_number_of_corrections; ++step) {
      const double squared_error = landing.squared_error(candidate.position.point);
      if(!(squared_error > m_tolerated_squared_error * squared_circumradius))
        break;
      Candidate corrected;
      if(!m_points.locate(candidate.location.face, landing.corrected(candidate.position.point), corrected)
         || !(landing.squared_error(corrected.position.point) < 0.7 * squared_error))
        break;
      candidate = corrected;
    }
    return true;
  }

  // How far from other vertices a point for a bad face must be: 0.7 of its shortest edge (measured against the spacing of
  // its vertices instead, up to 2 % of the triangles of a steep peak stay below 30 degrees), or of its circumradius, since
  // a large equilateral triangle has its centre closer than its vertices are to each other.
  static double squared_distance_by_shape(const Face_measures& measures)
  {
    const double shortest = *std::min_element(measures.squared_lengths.begin(), measures.squared_lengths.end());
    return 0.49 * (std::min)(shortest, measures.squared_circumradius);
  }

  // The number of points is bounded: no two are closer than the minimum edge allows. An angle that cannot be had must not
  // shrink edges that far: for its sake they stay above a fraction of the spacing.
  double required_squared_distance(Face_handle face, const Face_measures& measures) const
  {
    const double required = (std::max)(m_squared_min_distance, squared_distance_by_shape(measures));
    const double spacing = fraction_of_spacing
                           * (std::min)({face->vertex(0)->spacing(), face->vertex(1)->spacing(), face->vertex(2)->spacing()});
    typename Criteria::Quality quality;
    if(required < spacing * spacing && m_is_bad(face, quality) == Mesh_2::BAD)
      return spacing * spacing;
    return required;
  }

  // Whether the point is too close to edges of the boundary. The apices over these become positions to try.
  bool encroaches(const Candidate& candidate)
  {
    bool result = false;
    for(const auto& edge : m_points.star_of(candidate)) {
      if(!edge.first->is_constrained(edge.second))
        continue;
      const auto &p = edge.first->vertex((edge.second + 1) % 3)->point(),
                 &q = edge.first->vertex((edge.second + 2) % 3)->point();
      if(m_points.encroaches(candidate, p, q)) {
        Point_placement<Kernel>::append_apices(p, q, m_positions);
        result = true;
      }
    }
    return result;
  }

  void append_apices(const Location& location)
  {
    if(location.kind == Location::BEHIND_CONSTRAINT)
      Point_placement<Kernel>::append_apices(location.face->vertex((location.index + 1) % 3)->point(),
                                             location.face->vertex((location.index + 2) % 3)->point(), m_positions);
  }

  // Tries other positions and inserts the one with the best star, if that is better than the face.
  bool insert_alternative(Face_handle face, const Face_measures& measures, double squared_distance)
  {
    Candidate best;
    double best_sine = measures.squared_smallest_sine;
    bool is_found = false;
    const auto consider = [&](const Candidate& candidate) {
      if(!m_points.is_far_enough(candidate, squared_distance))
        return;
      const double sine = smallest_sine_of_star(candidate);
      if(sine > best_sine) {
        best = candidate;
        best_sine = sine;
        is_found = true;
      }
    };
    Candidate candidate;
    for(const Point_2& position : m_positions)
      if(m_points.locate(face, position, candidate))
        consider(candidate);
    for(const Weights& weights : Point_placement<Kernel>::alternatives(measures))
      if(locate(face, weights, measures.squared_circumradius, candidate))
        consider(candidate);
    if(is_found)
      insert(best);
    return is_found;
  }

  double smallest_sine_of_star(const Candidate& candidate)
  {
    double smallest = 1;
    for(const auto& edge : m_points.star_of(candidate)) {
      const auto &p = edge.first->vertex((edge.second + 1) % 3)->point(),
                 &q = edge.first->vertex((edge.second + 2) % 3)->point();
      const auto& metric = m_evaluate.oracle().metric();
      smallest = (std::min)(smallest, squared_smallest_sine({metric.squared_length(p, q),
                                                             metric.squared_length(q, candidate.position.point),
                                                             metric.squared_length(candidate.position.point, p)}));
    }
    return smallest;
  }

  void insert(Candidate& candidate)
  {
    m_points.insert(candidate);
    for(Face_handle face : m_points.star()) {
      examine(face);
      const Face_handle across = face->neighbor(0);
      if(across->state() == Face_state::BLOCKED)
        examine(across);
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_PATCH_REFINEMENT_H
