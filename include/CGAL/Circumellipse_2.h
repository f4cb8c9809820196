// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CIRCUMELLIPSE_2_H
#define CGAL_CIRCUMELLIPSE_2_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Metric_tensor_2.h>
#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherMetrics

The ellipse `{x : (x-c)^T M (x-c) = D}` through the three vertices of a triangle in the parameter
domain, for a metric tensor `M`: the image of the circumscribed circle of the triangle's image on the surface.

Equations (4) and (5) of the paper, with two corrections: the parametric form is
`v = v_c + A cos(t) sin(alpha) + B sin(t) cos(alpha)` (the paper has a minus, which is no rotated ellipse),
and for a tensor scaled to the eigenvalue 1 along the major axis the constant is `D = A^2`
(the paper has `A^2 B^2`). For any other scale `D = A^2 lambda_min = B^2 lambda_max`.

\tparam Kernel a model of `Kernel` with `double` as number type
*/
template <class Kernel>
class Circumellipse_2
{
public:
  typedef typename Kernel::Point_2 Point_2;

private:
  Metric_tensor_2 m_tensor;
  Point_2 m_center;
  double m_d;

public:
  /*!
  the ellipse through `p`, `q`, `r` under the tensor `tensor`.
  \pre `tensor` is positive definite and the points are not collinear
  */
  Circumellipse_2(const Point_2& p, const Point_2& q, const Point_2& r, const Metric_tensor_2& tensor)
    : m_tensor(tensor)
  {
    CGAL_precondition(tensor.is_positive_definite());
    Eigen::Matrix2d metric, sides;
    metric << tensor.e(), tensor.f(), tensor.f(), tensor.g();
    sides << q.x() - p.x(), q.y() - p.y(), r.x() - p.x(), r.y() - p.y();
    CGAL_precondition(sides.determinant() != 0);
    // equal length of the vectors from the centre: 2 side^T M (c - p) = side^T M side
    const Eigen::Vector2d lengths(tensor.squared_length(sides(0, 0), sides(0, 1)),
                                  tensor.squared_length(sides(1, 0), sides(1, 1)));
    const Eigen::Vector2d c = (2 * sides * metric).fullPivLu().solve(lengths);
    m_center = Point_2(p.x() + c.x(), p.y() + c.y());
    m_d = tensor.squared_length(c.x(), c.y());
  }

  /// the tensor `M`.
  const Metric_tensor_2& tensor() const { return m_tensor; }

  /// the centre `c = (u_c, v_c)`.
  const Point_2& center() const { return m_center; }

  /// the constant `D`: the squared length of every half diameter under `M`.
  double d() const { return m_d; }

  /// the major half axis, as a length in the domain.
  double a() const { return std::sqrt(m_d / m_tensor.lambda_min()); }

  /// the minor half axis, as a length in the domain.
  double b() const { return std::sqrt(m_d / m_tensor.lambda_max()); }

  /// the angle of the major axis to the `u` axis, in radians.
  double alpha() const { return m_tensor.alpha(); }

  /// the implicit function `G` (paper, eq. 5) at `x`: negative inside, zero on the ellipse, positive outside.
  double implicit_value(const Point_2& x) const
  {
    return m_tensor.squared_length(x.x() - m_center.x(), x.y() - m_center.y()) - m_d;
  }

  /// the point with parameter `t` in radians (paper, eq. 4 corrected).
  Point_2 point(double t) const
  {
    const double s = std::sin(alpha()), c = std::cos(alpha());
    const double major = a() * std::cos(t), minor = b() * std::sin(t);
    return Point_2(m_center.x() + major * c - minor * s, m_center.y() + major * s + minor * c);
  }
};

} // namespace CGAL

#endif // CGAL_CIRCUMELLIPSE_2_H
