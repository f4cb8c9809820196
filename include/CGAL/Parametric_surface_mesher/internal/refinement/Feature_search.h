// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_FEATURE_SEARCH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_FEATURE_SEARCH_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Inner_points.h>
#include <CGAL/Parametric_surface_mesher/internal/surfaces/feature_lines.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/for_each_with_lookahead.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_oracle_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Lines of the domain in one direction.
class Parallel_lines
{
  std::vector<double> m_lines;
  double m_smallest_gap = std::numeric_limits<double>::infinity();

public:
  explicit Parallel_lines(std::vector<double> lines) : m_lines(std::move(lines))
  {
    for(std::size_t i = 1; i < m_lines.size(); ++i)
      m_smallest_gap = (std::min)(m_smallest_gap, m_lines[i] - m_lines[i - 1]);
  }

  bool is_empty() const { return m_lines.empty(); }

  // whether no more than one gap is between
  bool are_at_most_two_between(double min, double max) const { return max - min < 2 * m_smallest_gap; }

  template <class Visit>
  void for_each_between(double min, double max, const Visit& visit) const
  {
    for(auto line = std::upper_bound(m_lines.begin(), m_lines.end(), min); line != m_lines.end() && *line < max; ++line)
      visit(*line);
  }
};

/*
Finds features that triangles miss: in triangles that are large beside the features that the surface may have, be it that all
their own samples are close to the surface, or that the refinement found no good place for a point. Where two lines of the
surface cross inside such a triangle, the surface is compared with it, and where they are farther apart than the criteria
allow, a vertex is inserted. Its spacing is limited by the curvature there, which makes the refinement insert others around it.
*/
template <class Evaluator>
class Feature_search
{
  typedef internal::Inner_points<Evaluator> Inner_points;
  typedef typename Inner_points::Triangulation Triangulation;
  typedef typename Inner_points::Face_handle Face_handle;
  typedef typename Inner_points::Candidate Candidate;
  typedef typename Inner_points::Point Point;
  typedef typename Evaluator::Kernel Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;

  // a place in a triangle, with the squared distance of the surface there from its plane
  struct Place
  {
    Face_handle face;
    Point_2 point;
    double squared_height = 0;
    bool is_hidden = false; // from the samples that every triangle has
  };

  Triangulation& m_triangulation;
  const Evaluator& m_evaluate;
  const Parametric_surface_mesh_criteria& m_criteria;
  Inner_points m_points;
  std::array<Parallel_lines, 2> m_lines;

public:
  // `surface` and `box`: of the patch in its domain. `chart_box`: in the coordinates that it is meshed in
  template <class Surface>
  Feature_search(Triangulation& triangulation, const Evaluator& evaluate, const Parametric_surface_mesh_criteria& criteria,
                 const Surface& surface, const Bbox_2& chart_box)
    : m_triangulation(triangulation), m_evaluate(evaluate), m_criteria(criteria), m_points(triangulation, evaluate),
      m_lines(lines(surface, chart_box))
  {}

  // Inserts a vertex in each triangle that misses a feature. Returns whether there is one.
  // \pre the patch is refined: what a triangle's own samples tell has been heeded
  bool operator()()
  {
    if(m_lines[0].is_empty() || m_lines[1].is_empty())
      return false;
    bool is_found = false;
    for(const Place& place : missed_places())
      is_found |= insert(place);
    return is_found;
  }

  std::size_t number_of_replaced_tensors() const { return m_points.number_of_replaced_tensors(); }

  // The place in a face where the surface is farthest from it, with height 0 if that is no farther than the criteria allow.
  Place missed_place(Face_handle face) const
  {
    const Point &a = face->vertex(0)->point(), &b = face->vertex(1)->point(), &c = face->vertex(2)->point();
    Place result;
    if(m_lines[0].are_at_most_two_between((std::min)({a.x(), b.x(), c.x()}), (std::max)({a.x(), b.x(), c.x()}))
       && m_lines[1].are_at_most_two_between((std::min)({a.y(), b.y(), c.y()}), (std::max)({a.y(), b.y(), c.y()})))
      return result;
    result = farthest_place(face);
    const double limit = squared_limit(face);
    if(!(result.squared_height > limit) || is_by_corners(face, result.squared_height, limit))
      return Place();
    result.is_hidden = is_hidden(face, limit);
    return result;
  }

  // Adds to the verdict on a face what it fails at a feature that it misses, because no vertex could be inserted there: the distance,
  // or the deviation if there is no bound of the distance.
  void judge(Face_handle face)
  {
    if(m_lines[0].is_empty() || m_lines[1].is_empty() || is_collapsed(face))
      return;
    const Place place = missed_place(face);
    if(!(place.squared_height > 0))
      return;
    const auto& distance = m_criteria.distance();
    if(distance && place.squared_height <= square(*distance))
      return;
    const Verdict before = face->verdict();
    Verdict verdict(before.failed() | (distance ? Mesh_criterion::DISTANCE : Mesh_criterion::DEVIATION), before.scope());
    verdict.refuse(before.is_refused() ? before.refusal() : why_missed(place));
    face->set_verdict(verdict);
  }

private:
  // In a chart the lines are even, and as many.
  template <class Surface>
  std::array<Parallel_lines, 2> lines(const Surface& surface, const Bbox_2& chart_box) const
  {
    Feature_lines lines;
    if(m_criteria.feature_resolution() > 0)
      lines = feature_lines(surface, chart_box, m_criteria.feature_resolution());
    if(!m_evaluate.oracle().surface().chart().is_identity())
      lines = {even_lines(chart_box.xmin(), chart_box.xmax(), lines[0].size()),
               even_lines(chart_box.ymin(), chart_box.ymax(), lines[1].size())};
    return {Parallel_lines(std::move(lines[0])), Parallel_lines(std::move(lines[1]))};
  }

  // one in a triangle; in an order that does not depend on that of the faces
  std::vector<Place> missed_places() const
  {
    std::vector<Place> result;
    for_each_face_with_lookahead(m_triangulation, [&](Face_handle face) {
      if(!face->is_in_domain() || is_collapsed(face) || !is_divisible(face))
        return;
      const Place place = missed_place(face);
      if(place.squared_height > 0)
        result.push_back(place);
    });
    std::sort(result.begin(), result.end(), [](const Place& p, const Place& q) { return p.point < q.point; });
    return result;
  }

  // The face may have changed since, but it is near.
  bool insert(const Place& place)
  {
    Candidate candidate;
    if(m_triangulation.number_of_vertices() >= m_criteria.max_number_of_vertices() || why_refused(place, candidate))
      return false;
    m_points.insert(candidate);
    return true;
  }

  // The cause why a vertex cannot be inserted at a place, if there is one. What a triangle's own samples tell, and the refinement
  // could not mend, is no reason for small angles at the boundary.
  std::optional<Unmet_cause> why_refused(const Place& place, Candidate& candidate)
  {
    if(!m_points.locate(place.face, place.point, candidate))
      return Unmet_cause::BOUNDARY;
    if(!m_points.is_far_enough(candidate, square(m_criteria.min_edge())))
      return Unmet_cause::MINIMUM_EDGE;
    if(!place.is_hidden && Inner_points::is_near_boundary(candidate) && encroaches(candidate))
      return Unmet_cause::BOUNDARY;
    return {};
  }

  Unmet_cause why_missed(const Place& place)
  {
    if(m_triangulation.number_of_vertices() >= m_criteria.max_number_of_vertices())
      return Unmet_cause::VERTEX_LIMIT;
    if(!is_divisible(place.face))
      return Unmet_cause::MINIMUM_EDGE;
    Candidate candidate;
    return why_refused(place, candidate).value_or(Unmet_cause::NO_BETTER_POINT); // improvement has moved vertices away from it
  }

  bool encroaches(const Candidate& candidate)
  {
    const auto& star = m_points.star_of(candidate);
    return std::any_of(star.begin(), star.end(), [&](const auto& edge) {
      return edge.first->is_constrained(edge.second)
             && m_points.encroaches(candidate, edge.first->vertex((edge.second + 1) % 3)->point(),
                                    edge.first->vertex((edge.second + 2) % 3)->point());
    });
  }

  static double squared_longest_edge(Face_handle face)
  {
    return (std::max)({squared_length_in_space(face, 0), squared_length_in_space(face, 1), squared_length_in_space(face, 2)});
  }

  bool is_divisible(Face_handle face) const { return squared_longest_edge(face) >= 4 * square(m_criteria.min_edge()); }

  // by the distance, and by the deviation ratio for the longest edge
  double squared_limit(Face_handle face) const
  {
    const double by_ratio = square(m_criteria.gamma()) * squared_longest_edge(face);
    return m_criteria.distance() ? (std::min)(by_ratio, square(*m_criteria.distance())) : by_ratio;
  }

  Place farthest_place(Face_handle face) const
  {
    const Point &a = face->vertex(0)->point(), &b = face->vertex(1)->point(), &c = face->vertex(2)->point();
    Place result;
    m_lines[0].for_each_between((std::min)({a.x(), b.x(), c.x()}), (std::max)({a.x(), b.x(), c.x()}), [&](double u) {
      double min = std::numeric_limits<double>::infinity(), max = -min;
      const auto cross = [&](const Point& p, const Point& q) {
        if((p.x() < u) != (q.x() < u)) {
          const double v = p.y() + (u - p.x()) / (q.x() - p.x()) * (q.y() - p.y());
          min = (std::min)(min, v);
          max = (std::max)(max, v);
        }
      };
      cross(a, b);
      cross(b, c);
      cross(c, a);
      m_lines[1].for_each_between(min, max, [&](double v) {
        const double height = squared_height(face, Point_2(u, v));
        if(height > result.squared_height)
          result = {face, Point_2(u, v), height};
      });
    });
    return result;
  }

  // of the surface over the plane of the triangle
  double squared_height(Face_handle face, const Point_2& place) const
  {
    const Point_3 &p = face->vertex(0)->point().surface_point(), &q = face->vertex(1)->point().surface_point(),
                  &r = face->vertex(2)->point().surface_point();
    const Vector_3 normal = cross_product(q - p, r - p);
    const double height = normal * (m_evaluate.oracle().surface().point(place.x(), place.y()) - p);
    if(!std::isfinite(height))
      throw_not_finite(m_evaluate.oracle().surface(), place);
    const double squared_length = normal * normal;
    return squared_length > 0 ? height * height / squared_length : 0;
  }

  // Whether the samples that every triangle has are within the limit.
  bool is_hidden(Face_handle face, double squared_limit) const
  {
    const Point &a = face->vertex(0)->point(), &b = face->vertex(1)->point(), &c = face->vertex(2)->point();
    for(const Point_2& p : {midpoint(a.domain_point(), b.domain_point()), midpoint(b.domain_point(), c.domain_point()),
                            midpoint(c.domain_point(), a.domain_point()),
                            Point_2((a.x() + b.x() + c.x()) / 3, (a.y() + b.y() + c.y()) / 3)})
      if(squared_height(face, p) > squared_limit)
        return false;
    return true;
  }

  // Whether the height is beyond the limit only as much as the corners are off the surface: those on a boundary may be.
  bool is_by_corners(Face_handle face, double squared_height_found, double squared_limit) const
  {
    double gap = 0;
    for(int i = 0; i < 3; ++i)
      gap = (std::max)(gap, squared_height(face, face->vertex(i)->point().domain_point()));
    return std::sqrt(squared_height_found) <= std::sqrt(squared_limit) + std::sqrt(gap);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_FEATURE_SEARCH_H
