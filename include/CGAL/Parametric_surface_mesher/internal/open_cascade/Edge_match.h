// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_EDGE_MATCH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_EDGE_MATCH_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Domain_curve_2.h>
#include <CGAL/Parametric_surface_mesher/internal/curves/Arc_length.h>
#include <CGAL/Space_curve_3.h>
#include <CGAL/number_utils.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A curve in space, or a part of one, with its arc length.
template <class Kernel>
struct Measured_space_curve
{
  typedef std::shared_ptr<const Space_curve_3<Kernel>> Curve;

  Curve curve;
  double begin, end; // the parameters of its ends
  Arc_length<std::function<double(double)>> length;

  Measured_space_curve(const Curve& c, double t0, double t1)
    : curve(c), begin(t0), end(t1), length([c](double t) { return c->speed(t); }, t0, t1, 16)
  {}
  explicit Measured_space_curve(const Curve& c) : Measured_space_curve(c, c->begin(), c->end()) {}

  double parameter_at(double share) const { return length.position_at(share * length.length()).parameter; }
};

// Two curves in space, side by side, that are to become one. Two points correspond if the lengths before them are equal shares of
// the whole lengths (on the second curve the length behind the point, if it runs in the opposite direction).
template <class Kernel>
class Edge_match
{
  typedef Measured_space_curve<Kernel> Measured_curve;
  typedef Domain_curve_2<Kernel> Curve;

  static constexpr int number_of_samples = 64; // of the distance
  static constexpr double tolerance_of_linearity = 1e-10; // in parameters, which run from 0 to 1

  std::shared_ptr<const Measured_curve> m_first, m_second;
  bool m_is_reversed;

public:
  Edge_match(const Measured_curve& first, const Measured_curve& second, bool is_reversed)
    : m_first(std::make_shared<Measured_curve>(first)), m_second(std::make_shared<Measured_curve>(second)),
      m_is_reversed(is_reversed)
  {}

  bool is_reversed() const { return m_is_reversed; }

  // The largest distance between corresponding points.
  double distance() const
  {
    double squared = 0;
    for(int i = 0; i <= number_of_samples; ++i) {
      const double t = m_first->parameter_at(double(i) / number_of_samples);
      const double d = squared_distance(m_first->curve->point(t), m_second->curve->point(parameter(t)));
      squared = (std::max)(squared, d);
    }
    return std::sqrt(squared);
  }

  // Converts a curve in a domain from the parameters of the second curve to those of the first. Its second derivative is set to
  // zero; it is not needed, because an edge is measured on its curve in space.
  Curve reparametrized(const Curve& curve) const
  {
    const auto source = curve.point(m_is_reversed ? m_second->end : m_second->begin),
               target = curve.point(m_is_reversed ? m_second->begin : m_second->end);
    if(curve.is_straight() && is_linear())
      return Curve::segment(source, target);
    const auto jet = [match = *this, curve](double t) {
      auto result = curve.jet(match.parameter(t));
      result.first = match.derivative(t) * result.first;
      result.second = 0 * result.second;
      return result;
    };
    Curve result(jet, m_first->begin, m_first->end);
    result.set_end_points(source, target);
    return result;
  }

private:
  // The parameter of the second curve that corresponds to the parameter `t` of the first.
  double parameter(double t) const
  {
    const double share = m_first->length.length_at(t) / m_first->length.length();
    return m_second->parameter_at(m_is_reversed ? 1 - share : share);
  }

  // The derivative of `parameter()`.
  double derivative(double t) const
  {
    const double speed = m_first->curve->speed(t) / m_first->length.length() * m_second->length.length(),
                 result = speed / m_second->curve->speed(parameter(t));
    return (m_is_reversed ? -1 : 1) * (std::isfinite(result) ? result : 1);
  }

  // Whether corresponding parameters are in proportion.
  bool is_linear() const
  {
    for(const double share : {0.125, 0.375, 0.5, 0.75}) {
      const double s = parameter(m_first->begin + share * (m_first->end - m_first->begin)),
                   expected = m_is_reversed ? 1 - share : share;
      if(std::fabs(s - m_second->begin - expected * (m_second->end - m_second->begin)) > tolerance_of_linearity)
        return false;
    }
    return true;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_EDGE_MATCH_H
