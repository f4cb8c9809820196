// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_SCALED_JACOBIAN_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_SCALED_JACOBIAN_H

#include <CGAL/Parametric_surface_mesher/internal/second_order/Quadratic_triangle_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Between two numbers.
struct Bounds
{
  double lower, upper;
};

// The smallest value on a triangle of a polynomial of degree 2, `l^T q l` with barycentric coordinates `l`. The entries of the symmetric
// matrix `q` are its Bezier coefficients (Johnen, Remacle, Geuzaine: Geometrical validity of curvilinear finite elements, 2013):
// none of its values is below the least of them, and those on the diagonal are values. Where the two differ by more than
// `accuracy`, the triangle is divided into four, whose coefficients are closer to the values.
class Smallest_value
{
  typedef Eigen::Matrix3d Matrix;

  static constexpr int max_depth = 12; // each division takes three quarters of the difference away

  const double m_accuracy;
  Bounds m_bounds;

public:
  Smallest_value(const Matrix& q, double accuracy) : m_accuracy(accuracy), m_bounds{q.minCoeff(), q.diagonal().minCoeff()}
  {
    if(m_bounds.upper - m_bounds.lower > accuracy)
      m_bounds.lower = lower_bound(q, max_depth);
  }

  const Bounds& bounds() const { return m_bounds; }

private:
  double lower_bound(const Matrix& q, int depth)
  {
    m_bounds.upper = (std::min)(m_bounds.upper, q.diagonal().minCoeff());
    const double lower = q.minCoeff();
    if(m_bounds.upper - lower <= m_accuracy || depth == 0)
      return lower;
    double result = std::numeric_limits<double>::infinity();
    for(const Matrix& corners : quarters())
      result = (std::min)(result, lower_bound(corners.transpose() * q * corners, depth - 1));
    return result;
  }

  // The barycentric coordinates of the corners of each quarter, in the columns.
  static const std::array<Matrix, 4>& quarters()
  {
    static const std::array<Matrix, 4> result = [] {
      std::array<Matrix, 4> quarter;
      for(int i = 0; i < 3; ++i)
        for(int k = 0; k < 3; ++k)
          quarter[i].col(k) = 0.5 * (Matrix::Identity().col(i) + Matrix::Identity().col(k));
      quarter[3] = 0.5 * (Matrix::Ones() - Matrix::Identity());
      return quarter;
    }();
    return result;
  }
};

/*
How much a curved triangle is squeezed where it is worst: the smallest value of its normal in the direction of its mean, over that mean.
1 for a straight triangle, and 0 or less for one that is folded. The mean of the normal depends on the sides alone, and has the
direction of the straight triangle's normal if they are straight. What is returned is proved: the value is not smaller. It is at most
`accuracy` below the true one. Minus infinity for a triangle without area, and for one that faces against `side`.
*/
template <class Kernel>
double scaled_jacobian(const Quadratic_triangle_3<Kernel>& triangle, const typename Kernel::Vector_3& side)
{
  const double accuracy = 0.01, none = -std::numeric_limits<double>::infinity();
  const auto normal = triangle.normal();
  const auto mean = normal.mean();
  const double squared = mean.squared_length();
  if(!(squared > 0) || !std::isfinite(squared) || !(mean * side > 0))
    return none;
  std::array<double, 6> c;
  for(std::size_t i = 0; i < 6; ++i)
    c[i] = normal.coefficients[i] * mean / squared;
  Eigen::Matrix3d q;
  q << c[0], c[3], c[5], c[3], c[1], c[4], c[5], c[4], c[2];
  const double rounding = 64 * std::numeric_limits<double>::epsilon() * normal.largest_term / std::sqrt(squared);
  return Smallest_value(q, accuracy).bounds().lower - rounding;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_SCALED_JACOBIAN_H
