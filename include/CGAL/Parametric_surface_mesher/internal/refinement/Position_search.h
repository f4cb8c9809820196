// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_POSITION_SEARCH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_POSITION_SEARCH_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/Mesh_criterion.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Inner_points.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Landing.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Point_placement.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Finds a position for a new point that makes a bad face better: the centre of its circumellipse, or elsewhere if that is
// behind the boundary or too close to it. The boundary is never split. Where there is none, it tells why.
template <class Evaluator>
class Position_search
{
  typedef typename Evaluator::Kernel Kernel;
  typedef internal::Inner_points<Evaluator> Inner_points;
  typedef typename Inner_points::Face_handle Face_handle;
  typedef typename Inner_points::Vertex_handle Vertex_handle;
  typedef typename Inner_points::Location Location;
  typedef typename Inner_points::Candidate Candidate;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Point_placement<Kernel>::Weights Weights;

  static constexpr double fraction_of_spacing = 0.15;
  // Of a point's place, by the circumradius. What a front has left is at odd places, where small errors do not matter.
  static constexpr double tolerated_error = 0.02, tolerated_error_after_front = 0.2;
  static constexpr int max_number_of_corrections = 4;

  Inner_points& m_points;
  const Evaluator& m_evaluate;
  std::vector<Point_2> m_positions;
  const bool m_has_off_centers;
  const Off_center_placement m_off_centers;
  const Own_placement m_own_placement; // or none
  const double m_squared_min_distance, m_tolerated_squared_error;

public:
  Position_search(Inner_points& points, const Evaluator& evaluate, const Parametric_surface_mesh_criteria& criteria)
    : m_points(points), m_evaluate(evaluate),
      m_has_off_centers(criteria.placement() == Mesh_point_placement::OFF_CENTER),
      m_off_centers(criteria.angle() * std::atan(1.) / 45), m_own_placement(criteria.own_placement()), m_squared_min_distance(square(criteria.min_edge())),
      m_tolerated_squared_error(
        square(criteria.placement() == Mesh_point_placement::FRONTAL ? tolerated_error_after_front : tolerated_error))
  {}

  // Returns why there is no position for the face, if so: what stands against the first one, or, where that is but too close
  // to a vertex, that no other one makes the triangles around it better.
  // \pre the verdict on the face is known
  std::optional<Unmet_cause> operator()(Face_handle face, Candidate& candidate)
  {
    const Face_measures measures = face_measures(face, m_evaluate.oracle().metric());
    const double squared_distance = required_squared_distance(face, measures);
    m_positions.clear();
    const std::optional<Unmet_cause> refusal = look_at_first(face, measures, squared_distance, candidate);
    if(!refusal)
      return std::nullopt;
    switch(find_alternative(face, measures, squared_distance, candidate)) {
    case Alternative::FOUND: return std::nullopt;
    case Alternative::NONE_BETTER: return refusal == Unmet_cause::SPACING ? Unmet_cause::NO_BETTER_POINT : refusal;
    default: return refusal;
    }
  }

private:
  enum class Alternative
  {
    NONE_FAR_ENOUGH, // from vertices
    NONE_BETTER,
    FOUND
  };

  // Positions over the edges of the boundary that are in the way become positions to try.
  std::optional<Unmet_cause> look_at_first(Face_handle face, const Face_measures& measures, double squared_distance,
                                           Candidate& candidate)
  {
    if(!locate(face, first_weights(face, measures), measures.squared_circumradius, candidate)) {
      append_apices(candidate.location);
      return why_not_located(candidate.location);
    }
    if(!m_points.is_far_enough(candidate, squared_distance))
      return m_points.is_far_enough(candidate, m_squared_min_distance) ? Unmet_cause::SPACING : Unmet_cause::MINIMUM_EDGE;
    return Inner_points::is_near_boundary(candidate) ? why_encroaching(candidate) : std::nullopt;
  }

  static Unmet_cause why_not_located(const Location& location)
  {
    switch(location.kind) {
    case Location::LOST: return Unmet_cause::WORK_LIMIT;
    case Location::ON_VERTEX: return Unmet_cause::MINIMUM_EDGE;
    default: return why_behind(location.face, location.index);
    }
  }

  // Edge `i` is constrained, and in the way. Of a cut the user knows nothing.
  static Unmet_cause why_behind(Face_handle face, int i)
  {
    return is_on_true_boundary(face, i) ? Unmet_cause::BOUNDARY : Unmet_cause::NO_BETTER_POINT;
  }

  Weights first_weights(Face_handle face, const Face_measures& measures) const
  {
    if(!m_has_off_centers && !m_own_placement)
      return Circumcenter_placement()(measures.squared_lengths, 0);
    const double spacing = (face->vertex(0)->spacing() + face->vertex(1)->spacing() + face->vertex(2)->spacing()) / 3;
    return m_own_placement ? checked_weights(measures.squared_lengths, spacing) : m_off_centers(measures.squared_lengths, spacing);
  }

  Weights checked_weights(const Weights& squared_lengths, double spacing) const
  {
    const Weights weights = m_own_placement(squared_lengths, spacing);
    const double sum = weights[0] + weights[1] + weights[2], tolerance = 1e-6 * (1 + std::fabs(weights[0]) + std::fabs(weights[1]));
    if(!(std::fabs(sum - 1) <= tolerance))
      throw Parametric_surface_mesh_error("the placement of points returned (" + describe(weights[0]) + ", " + describe(weights[1]) + ", "
                                          + describe(weights[2]) + "); barycentric coordinates must be finite, with 1 as their sum");
    return weights;
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
    if(required < spacing * spacing && face->verdict().fails(Mesh_criterion::ANGLE))
      return spacing * spacing;
    return required;
  }

  // Whether the point is too close to edges of the boundary, and why it then is refused. The apices over these become
  // positions to try.
  std::optional<Unmet_cause> why_encroaching(const Candidate& candidate)
  {
    std::optional<Unmet_cause> result;
    for(const auto& edge : m_points.star_of(candidate)) {
      if(!edge.first->is_constrained(edge.second))
        continue;
      const auto &p = edge.first->vertex((edge.second + 1) % 3)->point(),
                 &q = edge.first->vertex((edge.second + 2) % 3)->point();
      if(m_points.encroaches(candidate, p, q)) {
        Point_placement<Kernel>::append_apices(p, q, m_positions);
        if(result != Unmet_cause::BOUNDARY)
          result = why_behind(edge.first, edge.second);
      }
    }
    return result && m_points.is_star_cut_short() ? Unmet_cause::WORK_LIMIT : result;
  }

  void append_apices(const Location& location)
  {
    if(location.kind == Location::BEHIND_CONSTRAINT)
      Point_placement<Kernel>::append_apices(location.face->vertex((location.index + 1) % 3)->point(),
                                             location.face->vertex((location.index + 2) % 3)->point(), m_positions);
  }

  // Finds the one of the other positions with the best star, if that is better than the face.
  Alternative find_alternative(Face_handle face, const Face_measures& measures, double squared_distance, Candidate& best)
  {
    double best_sine = measures.squared_smallest_sine;
    Alternative result = Alternative::NONE_FAR_ENOUGH;
    const auto consider = [&](const Candidate& candidate) {
      if(!m_points.is_far_enough(candidate, squared_distance))
        return;
      result = (std::max)(result, Alternative::NONE_BETTER);
      const double sine = smallest_sine_of_star(candidate);
      if(sine > best_sine) {
        best = candidate;
        best_sine = sine;
        result = Alternative::FOUND;
      }
    };
    Candidate candidate;
    for(const Point_2& position : m_positions)
      if(m_points.locate(face, position, candidate))
        consider(candidate);
    for(const Weights& weights : Point_placement<Kernel>::alternatives(measures))
      if(locate(face, weights, measures.squared_circumradius, candidate))
        consider(candidate);
    return result;
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
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_POSITION_SEARCH_H
