// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_FRONTAL_PLACEMENT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_FRONTAL_PLACEMENT_H

#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Point_placement.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Linear_tensor_field_2.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Where a new point goes that makes a triangle of the wanted size with an edge of the front, as far as the circumcentre of the
face in front of it allows. Its distances in space to the ends of the edge are predicted by the tensors of the face behind
the edge, so that most often the surface is evaluated once, and then set right by Newton steps in the domain.
*/
template <class Inner_points>
class Frontal_placement
{
  typedef typename Inner_points::Kernel Kernel;
  typedef typename Inner_points::Face_handle Face_handle;
  typedef typename Inner_points::Point Point;
  typedef typename Inner_points::Candidate Candidate;
  typedef typename Kernel::Point_2 Point_2;

  static constexpr double squared_accepted_error = 0.005 * 0.005;
  static constexpr double share_of_spacing = 0.8;
  static constexpr double smallest_height = 0.3; // of a new triangle, by its side
  static constexpr int max_number_of_corrections = 2;

  Inner_points& m_points;

public:
  explicit Frontal_placement(Inner_points& points) : m_points(points) {}

  // Returns whether there is a place over the edge opposite to corner `front`. Where the surface allows less than the
  // spacing of the edge's ends, the sides are to be between the two.
  bool operator()(Face_handle face, int front, const Face_measures& measures, Candidate& candidate) const
  {
    const double spacing = 0.5 * (face->vertex((front + 1) % 3)->spacing() + face->vertex((front + 2) % 3)->spacing());
    if(!place(face, front, measures, spacing, candidate))
      return false;
    const double limit = m_points.spacing_limit(candidate);
    Candidate closer;
    if(limit < share_of_spacing * spacing && place(face, front, measures, 0.5 * (spacing + limit), closer))
      candidate = closer;
    return true;
  }

private:
  bool place(Face_handle face, int front, const Face_measures& measures, double side, Candidate& candidate) const
  {
    const Point &p = face->vertex((front + 1) % 3)->point(), &q = face->vertex((front + 2) % 3)->point();
    const double quarter = measures.squared_lengths[front] / 4; // the square of half the edge
    const double height
      = (std::min)(std::sqrt((std::max)(side * side - quarter, quarter)), height_of_circumcenter(measures, front));
    if(!(height > smallest_height * side))
      return false;
    const double squared_side = height * height + quarter;
    const Point_2 apex = Point_placement<Kernel>::apex(p, q, height / (2 * std::sqrt(quarter)));
    if(!m_points.locate(face, predicted_position(face, front, apex, squared_side), candidate))
      return false;
    correct(p, q, squared_side, candidate);
    return true;
  }

  // over the edge opposite to corner `i`; negative if the angle there is obtuse
  static double height_of_circumcenter(const Face_measures& measures, int i)
  {
    const std::array<double, 3>& l = measures.squared_lengths;
    const double height = std::sqrt((std::max)(0., measures.squared_circumradius - l[i] / 4));
    return l[(i + 1) % 3] + l[(i + 2) % 3] > l[i] ? height : -height;
  }

  // A Newton step from `x` without an evaluation: the distances are those under the tensors of the face behind the edge,
  // continued to the middles of the new sides. Without such a face, or if it tells something else, `x`.
  static Point_2 predicted_position(Face_handle face, int front, const Point_2& x, double squared_side)
  {
    if(face->is_constrained(front))
      return x;
    const Face_handle behind = face->neighbor(front);
    const Point &p = face->vertex((front + 1) % 3)->point(), &q = face->vertex((front + 2) % 3)->point();
    const Linear_tensor_field_2<Point> tensor(p, q, behind->vertex(behind->index(face))->point());
    const Metric_tensor_2 to_p = tensor(0.5 * (p.x() + x.x()), 0.5 * (p.y() + x.y())),
                          to_q = tensor(0.5 * (q.x() + x.x()), 0.5 * (q.y() + x.y()));
    const double from_p = to_p.squared_length(x.x() - p.x(), x.y() - p.y()),
                 from_q = to_q.squared_length(x.x() - q.x(), x.y() - q.y());
    if(!(is_similar(from_p, squared_side) && is_similar(from_q, squared_side)))
      return x;
    const Point_2 result = newton_step(x, p, to_p, squared_side - from_p, q, to_q, squared_side - from_q);
    return std::isfinite(result.x() + result.y()) ? result : x; // tensors that are continued may have any determinant
  }

  static bool is_similar(double squared_length, double squared_side)
  {
    return squared_length > 0.5 * squared_side && squared_length < 2 * squared_side;
  }

  // by Newton steps, as long as they bring it closer
  void correct(const Point& p, const Point& q, double squared_side, Candidate& candidate) const
  {
    double error = squared_error(candidate, p, q, squared_side);
    for(int step = 0; step < max_number_of_corrections && error > squared_accepted_error; ++step) {
      const Point_2 position = corrected_position(candidate.position.point, p, q, squared_side);
      Candidate corrected;
      if(!m_points.locate(candidate.location.face, position, corrected))
        break;
      const double corrected_error = squared_error(corrected, p, q, squared_side);
      if(!(corrected_error < error))
        break;
      candidate = corrected;
      error = corrected_error;
    }
  }

  // of the distances to `p` and `q`, relative
  double squared_error(const Candidate& candidate, const Point& p, const Point& q, double squared_side) const
  {
    const double a = m_points.squared_length(p, candidate.position.point) / squared_side - 1,
                 b = m_points.squared_length(q, candidate.position.point) / squared_side - 1;
    return 0.25 * (std::max)(a * a, b * b);
  }

  Point_2 corrected_position(const Point& x, const Point& p, const Point& q, double squared_side) const
  {
    return newton_step(x, p, x.tensor(), squared_side - m_points.squared_length(p, x),
                       q, x.tensor(), squared_side - m_points.squared_length(q, x));
  }

  // A Newton step for the squared distances to `p` and `q`, which are too small by `p_error` and `q_error`. Tensors give
  // their derivatives, by half: M(x - p) and M(x - q).
  static Point_2 newton_step(const Point_2& x, const Point_2& p, const Metric_tensor_2& to_p, double p_error,
                             const Point_2& q, const Metric_tensor_2& to_q, double q_error)
  {
    const double pu = x.x() - p.x(), pv = x.y() - p.y(), qu = x.x() - q.x(), qv = x.y() - q.y();
    const double a0 = to_p.e() * pu + to_p.f() * pv, a1 = to_p.f() * pu + to_p.g() * pv;
    const double b0 = to_q.e() * qu + to_q.f() * qv, b1 = to_q.f() * qu + to_q.g() * qv;
    const double determinant = a0 * b1 - a1 * b0, a = 0.5 * p_error, b = 0.5 * q_error;
    return Point_2(x.x() + (a * b1 - b * a1) / determinant, x.y() + (b * a0 - a * b0) / determinant);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_FRONTAL_PLACEMENT_H
