// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_B_SPLINE_SURFACE_3_H
#define CGAL_B_SPLINE_SURFACE_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesher/internal/surfaces/B_spline_basis.h>
#include <CGAL/Parametric_surface_mesher/internal/surfaces/Control_net_3.h>
#include <CGAL/Surface_jet_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_surface_mesher/internal/surfaces/feature_lines.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

A tensor-product B-spline surface, polynomial or rational (NURBS).

A knot vector is flat: it holds each knot as often as its multiplicity says, so that it has (number of control
points) + degree + 1 entries. It need not have its ends at full multiplicity. The domain goes from the entry at
`degree` to the entry at (number of control points); outside it the surface continues as the polynomial, or rational
function, of the nearest knot interval.

At a knot of multiplicity `degree` (and `degree - 1`) the surface is only continuous (continuously differentiable):
`jet()` returns the derivatives of the interval after the knot, at the end of the domain those of the last interval.

At the corners of a surface with end knots of full multiplicity `point()` returns the control points, exactly if
the surface is polynomial or the weight there is a power of 2, else up to rounding.

\tparam Kernel a model of `Kernel` with `double` as number type

\cgalModels{ParametricSurface_3}

\sa `CGAL::Bezier_surface_3`
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel>
class B_spline_surface_3
{
public:
  typedef Kernel Geom_traits;
  typedef typename Kernel::Point_3 Point_3;

private:
  Parametric_surface_mesher::internal::Knot_vector m_knots_u, m_knots_v;
  Parametric_surface_mesher::internal::Control_net_3<Kernel> m_net;

public:
  /*!
  the surface of the given degrees, knot vectors, control points and weights. Points and weights come row by row:
  first the row with the number 0 in the `v` direction, in the order of growing `u`. Without weights the
  surface is polynomial.

  \tparam PointRange a range of `Kernel::Point_3`
  \throws Parametric_surface_mesh_error if a degree is not between 1 and 25; knots are not finite, decrease, bound no
          interval, or have a multiplicity above the degree inside the domain or above degree + 1 elsewhere; the
          number of points or weights does not fit; a coordinate is not finite; or a weight is not positive and
          finite
  */
  template <class PointRange>
  B_spline_surface_3(int degree_u, int degree_v,
                     std::vector<double> knots_u, std::vector<double> knots_v,
                     const PointRange& control_points,
                     std::vector<double> weights = std::vector<double>())
    : m_knots_u("B-spline surface, u", degree_u, std::move(knots_u)),
      m_knots_v("B-spline surface, v", degree_v, std::move(knots_v)),
      m_net("B-spline surface", m_knots_u.number_of_functions(), m_knots_v.number_of_functions(),
            control_points, std::move(weights))
  {}

  /// \name Control Points and Knots
  /// @{
  int degree_u() const { return m_knots_u.degree(); }
  int degree_v() const { return m_knots_v.degree(); }
  int number_of_control_points_u() const { return m_knots_u.number_of_functions(); }
  int number_of_control_points_v() const { return m_knots_v.number_of_functions(); }

  /// the control point with the number `i` in the `u` direction and `j` in the `v` direction.
  Point_3 control_point(int i, int j) const { return m_net.point(i, j); }

  /// the weight of `control_point(i, j)`; 1 if all are equal.
  double weight(int i, int j) const { return m_net.weight(i, j); }

  /// tells whether the weights differ.
  bool is_rational() const { return m_net.is_rational(); }

  const std::vector<double>& knots_u() const { return m_knots_u.knots(); }
  const std::vector<double>& knots_v() const { return m_knots_v.knots(); }
  /// @}

  /// \name Domain
  /// @{
  double u_min() const { return m_knots_u.min(); }
  double u_max() const { return m_knots_u.max(); }
  double v_min() const { return m_knots_v.min(); }
  double v_max() const { return m_knots_v.max(); }
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

  /// the lines between which no feature is looked for: for each knot interval as many as the degree.
  std::array<std::vector<double>, 2> feature_lines() const
  {
    return {feature_lines(m_knots_u), feature_lines(m_knots_v)};
  }

private:
  static std::vector<double> feature_lines(const Parametric_surface_mesher::internal::Knot_vector& knots)
  {
    return Parametric_surface_mesher::internal::polynomial_lines(
      {std::lower_bound(knots.knots().begin(), knots.knots().end(), knots.min()),
       std::upper_bound(knots.knots().begin(), knots.knots().end(), knots.max())},
      knots.degree());
  }

  template <class Basis>
  auto evaluate(double u, double v) const
  {
    const auto at_u = m_knots_u.locate(u), at_v = m_knots_v.locate(v);
    Basis basis_u, basis_v;
    evaluate_basis(at_u.first, degree_u(), basis_u);
    evaluate_basis(at_v.first, degree_v(), basis_v);
    return m_net.evaluate(basis_u, degree_u(), at_u.second, basis_v, degree_v(), at_v.second);
  }
};

} // namespace CGAL

#endif // CGAL_B_SPLINE_SURFACE_3_H
