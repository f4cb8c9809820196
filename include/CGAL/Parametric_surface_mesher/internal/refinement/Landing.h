// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_LANDING_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_LANDING_H

#include <array>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Measures how far a new point of the surface is from its target, a point in the plane of a face that is given by barycentric
// coordinates, and corrects its place in the domain by the affine map of the face: a Newton step with the slopes of the face's
// chords.
template <class Kernel>
class Landing
{
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_2 Vector_2;
  typedef typename Kernel::Vector_3 Vector_3;

  Vector_2 m_domain_edges[2];
  Vector_3 m_edges[2];
  double m_squares[3]; // the squared lengths of two edges, and their product
  Point_3 m_target;

public:
  template <class Face_handle>
  Landing(Face_handle face, const std::array<double, 3>& weights)
  {
    const auto& p = face->vertex(0)->point();
    for(int i = 0; i < 2; ++i) {
      const auto& q = face->vertex(i + 1)->point();
      m_domain_edges[i] = q.domain_point() - p.domain_point();
      m_edges[i] = q.surface_point() - p.surface_point();
    }
    m_squares[0] = m_edges[0] * m_edges[0];
    m_squares[1] = m_edges[0] * m_edges[1];
    m_squares[2] = m_edges[1] * m_edges[1];
    m_target = p.surface_point() + weights[1] * m_edges[0] + weights[2] * m_edges[1];
  }

  // The squared error within the plane of the face.
  template <class ParametricPoint>
  double squared_error(const ParametricPoint& point) const
  {
    const std::array<double, 2> step = step_to_target(point);
    return (step[0] * m_edges[0] + step[1] * m_edges[1]).squared_length();
  }

  template <class ParametricPoint>
  Point_2 corrected(const ParametricPoint& point) const
  {
    const std::array<double, 2> step = step_to_target(point);
    return point.domain_point() + step[0] * m_domain_edges[0] + step[1] * m_domain_edges[1];
  }

private:
  // The way to the target in multiples of the edges; none in a face without area.
  template <class ParametricPoint>
  std::array<double, 2> step_to_target(const ParametricPoint& point) const
  {
    const Vector_3 way = m_target - point.surface_point();
    const double a = way * m_edges[0], b = way * m_edges[1];
    const double determinant = m_squares[0] * m_squares[2] - m_squares[1] * m_squares[1];
    if(!(determinant > 1e-12 * m_squares[0] * m_squares[2]))
      return {0, 0};
    return {(a * m_squares[2] - b * m_squares[1]) / determinant, (b * m_squares[0] - a * m_squares[1]) / determinant};
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_LANDING_H
