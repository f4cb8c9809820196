// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DOMAIN_CURVE_2_H
#define CGAL_DOMAIN_CURVE_2_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_surface_mesher/internal/support/check_value.h>
#include <CGAL/Parametric_surface_mesher/internal/surfaces/Taylor_polynomial_2.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <functional>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherDomain

A curve in the parameter domain with its first and second derivative: a piece of a boundary loop.
Segments and arcs are made by static functions, anything else from a callable.

\tparam Kernel a model of `Kernel` with `double` as number type
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel>
class Domain_curve_2
{
public:
  static_assert(std::is_same<typename Kernel::FT, double>::value,
                "The kernel of a domain must have 'double' as its number type FT.");

  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Vector_2 Vector_2;

  /// a point of the curve with the first two derivatives by the curve's parameter.
  struct Jet
  {
    Point_2 point;
    Vector_2 first;
    Vector_2 second;
  };

private:
  std::function<Jet(double)> m_jet;
  double m_begin, m_end;
  Point_2 m_source, m_target;
  bool m_is_straight = false;
  unsigned int m_number_of_edges = 0;

public:
  /*!
  the curve `jet(t)` for `t` from `begin` to `end`, its derivatives given with it.
  \param jet a callable that returns a `Jet` for a `double`
  \throws Parametric_surface_mesh_error if `begin` and `end` are not finite or are equal
  */
  Domain_curve_2(std::function<Jet(double)> jet, double begin, double end)
    : m_jet(std::move(jet)), m_begin(begin), m_end(end)
  {
    Parametric_surface_mesher::internal::check_range_of_curve(begin, end);
    m_source = m_jet(begin).point;
    m_target = m_jet(end).point;
  }

  /// the segment from `p` to `q`, for `t` from 0 to 1.
  static Domain_curve_2 segment(const Point_2& p, const Point_2& q)
  {
    const Vector_2 d = q - p;
    Domain_curve_2 curve([p, d](double t) { return Jet{p + t * d, d, Vector_2(0, 0)}; }, 0, 1);
    curve.m_target = q;
    curve.m_is_straight = true;
    return curve;
  }

  /// the arc about `center` from angle `begin` to angle `end` (radians; clockwise if `end < begin`).
  /// \throws Parametric_surface_mesh_error if `radius` is not positive and finite, or as above
  static Domain_curve_2 arc(const Point_2& center, double radius, double begin, double end)
  {
    Parametric_surface_mesher::internal::check_positive_and_finite("radius of an arc", radius);
    return Domain_curve_2(
      [center, radius](double t) {
        const double c = radius * std::cos(t), s = radius * std::sin(t);
        return Jet{center + Vector_2(c, s), Vector_2(-s, c), Vector_2(-c, -s)};
      },
      begin, end);
  }

  /// the full circle, counterclockwise; it closes exactly.
  static Domain_curve_2 circle(const Point_2& center, double radius)
  {
    Domain_curve_2 curve = arc(center, radius, 0, 2 * CGAL_PI);
    curve.m_target = curve.m_source;
    return curve;
  }

  /*!
  the curve `t -> (u(t), v(t))` for `t` from `begin` to `end`; derivatives by automatic differentiation.
  \param f a callable that is generic in the type of its argument, `[](auto t) {...}`, and returns a `std::tuple`, `std::pair`
         or `std::array` of two, or of one number and something that depends on `t`. How to write it is told at
         `Parametric_function_surface_3`
  */
  template <class Function>
  static Domain_curve_2 from_function(Function f, double begin, double end)
  {
    return Domain_curve_2(
      [f](double t) {
        const auto uv = f(Parametric_surface_mesher::internal::Taylor_polynomial_2::first_variable(t));
        const Parametric_surface_mesher::internal::Taylor_polynomial_2 u = std::get<0>(uv), v = std::get<1>(uv);
        return Jet{Point_2(u.value, v.value), Vector_2(u.du, v.du), Vector_2(u.duu, v.duu)};
      },
      begin, end);
  }

  /// prescribes the number of pieces of equal length in 3D that the curve is divided in; 0 lets the criteria decide.
  Domain_curve_2& set_number_of_edges(unsigned int n)
  {
    m_number_of_edges = n;
    return *this;
  }

  /// the prescribed number of pieces, or 0.
  unsigned int number_of_edges() const { return m_number_of_edges; }

  /// moves the end points, by rounding errors, so that the curve meets its neighbours exactly.
  void set_end_points(const Point_2& source, const Point_2& target)
  {
    m_source = source;
    m_target = target;
  }

  double begin() const { return m_begin; }            ///< the parameter of `source()`
  double end() const { return m_end; }                ///< the parameter of `target()`
  const Point_2& source() const { return m_source; }  ///< the first point
  const Point_2& target() const { return m_target; }  ///< the last point
  bool is_straight() const { return m_is_straight; }  ///< tells whether this is a segment

  /// the point and derivatives at `t`.
  Jet jet(double t) const { return m_jet(t); }

  /// the point at `t`; exactly `source()` and `target()` at the ends.
  Point_2 point(double t) const
  {
    return t == m_begin ? m_source : t == m_end ? m_target : m_jet(t).point;
  }
};

} // namespace CGAL

#endif // CGAL_DOMAIN_CURVE_2_H
