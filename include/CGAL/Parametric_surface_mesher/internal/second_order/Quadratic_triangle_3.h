// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_QUADRATIC_TRIANGLE_3_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_QUADRATIC_TRIANGLE_3_H

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A vector polynomial of degree 2 on a triangle by its Bezier coefficients: `sum_ij l_i l_j c_ij` at the barycentric coordinates
// `l`. First those of the corners, `c_00`, `c_11`, `c_22`, then those of the sides, `c_01`, `c_12`, `c_20`.
template <class Kernel>
struct Quadratic_vector_3
{
  typedef typename Kernel::Vector_3 Vector_3;

  std::array<Vector_3, 6> coefficients;
  double largest_term = 0; // no product that they are sums of is larger: their rounding errors are relative to this

  // The integral over the area of the triangle: each of the six Bernstein polynomials has the same.
  Vector_3 mean() const
  {
    Vector_3 sum = coefficients[0];
    for(std::size_t i = 1; i < 6; ++i)
      sum = sum + coefficients[i];
    return sum / 6;
  }
};

// A curved triangle through six nodes: three corners, then the nodes between corners 0 and 1, 1 and 2, 2 and 0.
template <class Kernel>
class Quadratic_triangle_3
{
public:
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;
  typedef std::array<Point_3, 6> Nodes;

private:
  Nodes m_nodes;

public:
  explicit Quadratic_triangle_3(const Nodes& nodes) : m_nodes(nodes) {}

  const Nodes& nodes() const { return m_nodes; }

  // The point at barycentric coordinates.
  Point_3 point(double l0, double l1, double l2) const
  {
    const std::array<double, 6> weights = {l0 * (2 * l0 - 1), l1 * (2 * l1 - 1), l2 * (2 * l2 - 1), 4 * l0 * l1, 4 * l1 * l2, 4 * l2 * l0};
    Vector_3 sum(0, 0, 0);
    for(std::size_t i = 0; i < 6; ++i)
      sum = sum + weights[i] * (m_nodes[i] - m_nodes[0]);
    return m_nodes[0] + sum;
  }

  // The normal of the straight triangle, twice as long as its area.
  Vector_3 straight_normal() const { return cross_product(m_nodes[1] - m_nodes[0], m_nodes[2] - m_nodes[0]); }

  // The cross product of the derivatives by the second and the third barycentric coordinate: the normal, as long as the triangle
  // is stretched, constant if the triangle is straight. Both derivatives are linear.
  Quadratic_vector_3<Kernel> normal() const
  {
    const std::array<Vector_3, 6> b = control_vectors();
    const std::array<Vector_3, 3> du = {2 * (b[3] - b[0]), 2 * (b[1] - b[3]), 2 * (b[4] - b[5])};
    const std::array<Vector_3, 3> dv = {2 * (b[5] - b[0]), 2 * (b[4] - b[3]), 2 * (b[2] - b[5])};
    Quadratic_vector_3<Kernel> result;
    result.largest_term = std::sqrt(largest_square(du) * largest_square(dv));
    for(std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = (i + 1) % 3;
      result.coefficients[i] = cross_product(du[i], dv[i]);
      result.coefficients[3 + i] = (cross_product(du[i], dv[k]) + cross_product(du[k], dv[i])) / 2;
    }
    return result;
  }

private:
  static double largest_square(const std::array<Vector_3, 3>& v)
  {
    return (std::max)({v[0].squared_length(), v[1].squared_length(), v[2].squared_length()});
  }

  // The Bezier control points, seen from the first corner, so that rounding is relative to the size of the triangle.
  std::array<Vector_3, 6> control_vectors() const
  {
    std::array<Vector_3, 6> result;
    for(std::size_t i = 0; i < 6; ++i)
      result[i] = m_nodes[i] - m_nodes[0];
    for(std::size_t i = 0; i < 3; ++i)
      result[3 + i] = 2 * result[3 + i] - (result[i] + result[(i + 1) % 3]) / 2;
    return result;
  }
};

// The node in the middle of a straight side.
template <class Point_3>
Point_3 straight_middle(const Point_3& p, const Point_3& q)
{
  return p + (q - p) / 2;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_QUADRATIC_TRIANGLE_3_H
