// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_BEZIER_SURFACE_3_H
#define CGAL_BEZIER_SURFACE_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesher/internal/surfaces/B_spline_basis.h>
#include <CGAL/Parametric_surface_mesher/internal/surfaces/Control_net_3.h>
#include <CGAL/Surface_jet_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_surface_mesher/internal/surfaces/feature_lines.h>

#include <array>
#include <string>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

A tensor-product Bezier surface over `[0,1] x [0,1]`. Outside the square it continues as the same polynomial.

At the corners `point()` returns the control points exactly.

\tparam Kernel a model of `Kernel` with `double` as number type

\cgalModels{ParametricSurface_3}

\sa `CGAL::B_spline_surface_3`
\sa `CGAL::IO::read_bezier_patches()`
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel>
class Bezier_surface_3
{
public:
  typedef Kernel Geom_traits;
  typedef typename Kernel::Point_3 Point_3;

private:
  int m_degree_u, m_degree_v;
  Parametric_surface_mesher::internal::Control_net_3<Kernel> m_net;

public:
  /*!
  the surface of the given degrees and control points. The points come row by row, as in a `.bpt` file: first
  the `degree_u + 1` points of the side `v = 0` in the order of growing `u`, at last those of the side `v = 1`.

  \tparam PointRange a range of `Kernel::Point_3`
  \throws Parametric_surface_mesh_error if a degree is not between 1 and 25, the number of points is not
          `(degree_u + 1) (degree_v + 1)`, or a coordinate is not finite
  */
  template <class PointRange>
  Bezier_surface_3(int degree_u, int degree_v, const PointRange& control_points)
    : m_degree_u(checked_degree("u", degree_u)), m_degree_v(checked_degree("v", degree_v)),
      m_net("Bezier surface", degree_u + 1, degree_v + 1, control_points, std::vector<double>())
  {}

  /// \name Control Points
  /// @{
  int degree_u() const { return m_degree_u; }
  int degree_v() const { return m_degree_v; }
  int number_of_control_points_u() const { return m_degree_u + 1; }
  int number_of_control_points_v() const { return m_degree_v + 1; }

  /// the control point with the number `i` in the `u` direction and `j` in the `v` direction.
  Point_3 control_point(int i, int j) const { return m_net.point(i, j); }
  /// @}

  /// \name Domain
  /// @{
  double u_min() const { return 0; }
  double u_max() const { return 1; }
  double v_min() const { return 0; }
  double v_max() const { return 1; }
  /// @}

  /// `S(u,v)`
  Point_3 point(double u, double v) const
  {
    return evaluate<Parametric_surface_mesher::internal::Basis_functions>(u, v);
  }

  /// `S(u,v)` with all partial derivatives up to second order.
  Surface_jet_3<Kernel> jet(double u, double v) const
  {
    return evaluate<Parametric_surface_mesher::internal::Basis_function_jets>(u, v);
  }

  /// the lines between which no feature is looked for: as many in each direction as the degree.
  std::array<std::vector<double>, 2> feature_lines() const
  {
    using Parametric_surface_mesher::internal::polynomial_lines;
    return {polynomial_lines({0, 1}, m_degree_u), polynomial_lines({0, 1}, m_degree_v)};
  }

private:
  template <class Basis>
  auto evaluate(double u, double v) const
  {
    typedef Parametric_surface_mesher::internal::Unit_interval Unit_interval;
    Basis basis_u, basis_v;
    evaluate_basis(Unit_interval(u), m_degree_u, basis_u);
    evaluate_basis(Unit_interval(v), m_degree_v, basis_v);
    return m_net.evaluate(basis_u, m_degree_u, 0, basis_v, m_degree_v, 0);
  }

  static int checked_degree(const char* direction, int degree)
  {
    Parametric_surface_mesher::internal::check_degree(std::string("Bezier surface, ") + direction, degree);
    return degree;
  }
};

} // namespace CGAL

#endif // CGAL_BEZIER_SURFACE_3_H
