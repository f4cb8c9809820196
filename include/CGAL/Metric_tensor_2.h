// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_METRIC_TENSOR_2_H
#define CGAL_METRIC_TENSOR_2_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesher/internal/support/check_value.h>
#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cmath>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherMetrics

A symmetric 2x2 tensor `(E F; F G)` that measures lengths in the parameter domain:
a domain vector `d` has squared length `d^T M d`.

For a parametric surface, `E = S_u.S_u`, `F = S_u.S_v`, `G = S_v.S_v` is the first fundamental
form. Equivalently a tensor is given by the ellipses that it sees as circles: the angle `alpha` of
their major axis to the `u` axis and the ratio `k = A/B >= 1` of their half axes (eq. 5 of the paper,
whose bracket is the quadratic form of the tensor `from_ellipse(alpha, k)`).

A tensor measures lengths only if it is positive definite; `is_positive_definite()` tells.
*/
class Metric_tensor_2
{
  double m_e = 1, m_f = 0, m_g = 1;

public:
  /// the identity: the Euclidean metric.
  Metric_tensor_2() = default;

  /// the tensor `(e f; f g)`.
  Metric_tensor_2(double e, double f, double g) : m_e(e), m_f(f), m_g(g) {}

  /*!
  the tensor whose circles are ellipses with the major axis at angle `alpha` (radians) to the `u` axis and
  the ratio `k` of major to minor half axis. The eigenvalue along the major axis is 1, across it `k^2`
  (paper, eq. 5, where the implicit form is then `d^T M d = D` with `D = A^2`).
  \throws Parametric_surface_mesh_error if `k` is not positive and finite
  */
  static Metric_tensor_2 from_ellipse(double alpha, double k)
  {
    Parametric_surface_mesher::internal::check_positive_and_finite("ratio of the half axes", k);
    const double c = std::cos(alpha), s = std::sin(alpha), kk = k * k;
    return Metric_tensor_2(c * c + kk * s * s, (1 - kk) * s * c, s * s + kk * c * c);
  }

  /// \name Components
  /// @{
  double e() const { return m_e; }
  double f() const { return m_f; }
  double g() const { return m_g; }
  double determinant() const { return m_e * m_g - m_f * m_f; }
  double trace() const { return m_e + m_g; }
  /// @}

  /// tells whether all components are finite and `d^T M d > 0` for every `d != 0`.
  bool is_positive_definite() const
  {
    return std::isfinite(m_e) && std::isfinite(m_f) && std::isfinite(m_g)
           && m_e > 0 && m_g > 0 && determinant() > 0;
  }

  /// `d^T M d` for `d = (du, dv)`: the squared length of `d`.
  double squared_length(double du, double dv) const
  {
    return m_e * du * du + 2 * m_f * du * dv + m_g * dv * dv;
  }

  /// \name Ellipse
  /// The ellipses `d^T M d = const`.
  /// \pre `is_positive_definite()`
  /// @{

  /// the angle of the major axis to the `u` axis, in `(-pi/2, pi/2]`; 0 for a circle.
  /// It is the direction of the eigenvector with the smaller eigenvalue.
  double alpha() const
  {
    if(m_f == 0)
      return m_e <= m_g ? 0 : CGAL_PI / 2;
    return 0.5 * std::atan2(-2 * m_f, m_g - m_e);
  }

  /// the ratio `k = A/B >= 1` of the half axes: `sqrt(lambda_max/lambda_min)`.
  double k() const { return std::sqrt(lambda_max() / lambda_min()); }

  /// the smaller eigenvalue.
  double lambda_min() const { return determinant() / lambda_max(); }

  /// the larger eigenvalue.
  double lambda_max() const { return eigenvalues()[1]; }
  /// @}

  friend Metric_tensor_2 operator+(const Metric_tensor_2& m, const Metric_tensor_2& n)
  {
    return Metric_tensor_2(m.m_e + n.m_e, m.m_f + n.m_f, m.m_g + n.m_g);
  }

  friend Metric_tensor_2 operator*(double s, const Metric_tensor_2& m)
  {
    return Metric_tensor_2(s * m.m_e, s * m.m_f, s * m.m_g);
  }

  friend bool operator==(const Metric_tensor_2& m, const Metric_tensor_2& n)
  {
    return m.m_e == n.m_e && m.m_f == n.m_f && m.m_g == n.m_g;
  }

  friend bool operator!=(const Metric_tensor_2& m, const Metric_tensor_2& n) { return !(m == n); }

private:
  Eigen::Vector2d eigenvalues() const
  {
    Eigen::Matrix2d matrix;
    matrix << m_e, m_f, m_f, m_g;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    return solver.computeDirect(matrix, Eigen::EigenvaluesOnly).eigenvalues();
  }
};

} // namespace CGAL

#endif // CGAL_METRIC_TENSOR_2_H
