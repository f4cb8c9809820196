// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPACE_CURVE_3_H
#define CGAL_SPACE_CURVE_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/support/check_value.h>

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherModel

A curve in space with its first and second derivative: an edge of a model.

\tparam Kernel a model of `Kernel` with `double` as number type

\cgalModels{ParametricCurve_3}
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel>
class Space_curve_3
{
public:
  typedef Kernel Geom_traits;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;

  /// a point of the curve with the first two derivatives by the curve's parameter.
  struct Jet
  {
    Point_3 point;
    Vector_3 first;
    Vector_3 second;
  };

private:
  std::function<Jet(double)> m_jet;
  double m_begin, m_end;

public:
  /*!
  the curve `jet(t)` for `t` from `begin` to `end`.
  \param jet a callable that returns a `Jet` for a `double`
  \throws Parametric_surface_mesh_error if `begin` and `end` are not finite or are equal
  */
  Space_curve_3(std::function<Jet(double)> jet, double begin, double end)
    : m_jet(std::move(jet)), m_begin(begin), m_end(end)
  {
    Parametric_surface_mesher::internal::check_range_of_curve(begin, end);
  }

  /// the segment from `p` to `q`, for `t` from 0 to 1.
  static Space_curve_3 segment(const Point_3& p, const Point_3& q)
  {
    const Vector_3 d = q - p;
    return Space_curve_3([p, d](double t) { return Jet{p + t * d, d, Vector_3(0, 0, 0)}; }, 0, 1);
  }

  double begin() const { return m_begin; } ///< the parameter of the first point
  double end() const { return m_end; }     ///< the parameter of the last point

  /// the point and derivatives at `t`.
  Jet jet(double t) const { return m_jet(t); }

  /// the point at `t`.
  Point_3 point(double t) const
  {
    const Point_3 p = m_jet(t).point;
    check_finite(p.x() + p.y() + p.z(), t);
    return p;
  }

  /// the length of the derivative by `t`.
  double speed(double t) const
  {
    const double speed = std::sqrt(m_jet(t).first.squared_length());
    check_finite(speed, t);
    return speed;
  }

  /// the curvature radius at `t`; infinite where the curve is straight.
  double curvature_radius(double t) const
  {
    const Jet jet = m_jet(t);
    const double bend = std::sqrt(cross_product(jet.first, jet.second).squared_length());
    return bend > 0 ? std::pow(jet.first.squared_length(), 1.5) / bend : std::numeric_limits<double>::infinity();
  }

private:
  static void check_finite(double x, double t)
  {
    if(std::isfinite(x))
      return;
    std::ostringstream message;
    message << "a curve in space or its derivative is not finite at its parameter " << t;
    throw Parametric_surface_mesh_error(message.str());
  }
};

} // namespace CGAL

#endif // CGAL_SPACE_CURVE_3_H
