// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURVES_ARC_LENGTH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURVES_ARC_LENGTH_H

#include <CGAL/Parametric_surface_mesher/internal/curves/Legendre_expansion.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A point of a curve, by the arc length up to it and by its parameter.
struct Curve_position
{
  double length;
  double parameter;
};

// The arc length of a curve in space, and its inverse. The speed of the curve is expanded in Legendre polynomials on intervals
// that are halved until the expansions converge; all lengths are integrals of the expansions, so the curve is evaluated only
// once. On lines and circles the speed counts as constant, so that symmetric curves are divided symmetrically.
template <class Speed>
class Arc_length
{
  struct Interval
  {
    Curve_position begin;
    double half_width; // half the difference of its parameters; negative if they descend
    Legendre_expansion speed;

    double local(double t) const { return (t - begin.parameter) / half_width - 1; }
    double length_at(double t) const { return begin.length + std::fabs(half_width) * speed.integral(local(t)); }
  };

  // Relative error of the speed: lengths then are exact to about 1e-9, far below what a division of curves needs.
  static constexpr double tolerance = 1e-9;
  static constexpr double rounding = 1e-13; // relative, of lengths and speeds
  static constexpr int max_depth = 10;

  Speed m_speed;
  std::vector<Interval> m_intervals;
  Curve_position m_begin, m_end;
  bool m_is_constant = false;

public:
  // `speed(t)` is the length of the derivative; `end < begin` is allowed. The curve is expanded on at least `n` intervals.
  Arc_length(Speed speed, double begin, double end, std::size_t n) : m_speed(speed), m_begin{0, begin}, m_end{0, end}
  {
    expand(n);
  }

  double length() const { return m_end.length; }

  // Expands the speed on at least `n` intervals, unless it is constant.
  void refine(std::size_t n)
  {
    if(n > m_intervals.size() && !m_is_constant)
      expand(n);
  }

  // The length up to the parameter `t`.
  double length_at(double t) const
  {
    return m_is_constant ? length() * (t - m_begin.parameter) / (m_end.parameter - m_begin.parameter)
                         : interval_at(t).length_at(t);
  }

  // The position up to which the curve has length `s`.
  Curve_position position_at(double s) const
  {
    if(s <= 0)
      return m_begin;
    if(s >= length())
      return m_end;
    return position_between(m_begin, m_end, s);
  }

  // The position of length `s` between two known ones, by Newton steps that keep a bracket. (Boost's
  // newton_raphson_iterate() wants ascending brackets, and ends by digits of the parameter instead of the length.)
  Curve_position position_between(const Curve_position& from, const Curve_position& to, double s) const
  {
    double t = from.parameter + (to.parameter - from.parameter) * (s - from.length) / (to.length - from.length);
    if(m_is_constant)
      return {s, t};
    const Interval& interval = *std::prev(std::upper_bound(
      m_intervals.begin() + 1, m_intervals.end(), s, [](double length, const Interval& i) { return length < i.begin.length; }));
    const double sign = interval.half_width > 0 ? 1 : -1;
    double t0 = clamped(interval.begin.parameter, from, to),
           t1 = clamped(interval.begin.parameter + 2 * interval.half_width, from, to);
    if(!((t - t0) * (t - t1) < 0))
      t = 0.5 * (t0 + t1);
    for(int step = 0; step < 60; ++step) {
      const double excess = interval.length_at(t) - s;
      if(std::fabs(excess) <= rounding * length())
        break;
      (excess < 0 ? t0 : t1) = t;
      const double newton = t - sign * excess / interval.speed.value(interval.local(t));
      t = (newton - t0) * (newton - t1) < 0 ? newton : 0.5 * (t0 + t1);
      if(t == t0 || t == t1)
        break;
    }
    return {s, t};
  }

private:
  static double clamped(double t, const Curve_position& a, const Curve_position& b)
  {
    return (std::max)((std::min)(a.parameter, b.parameter), (std::min)((std::max)(a.parameter, b.parameter), t));
  }

  const Interval& interval_at(double t) const
  {
    const bool is_ascending = m_end.parameter > m_begin.parameter;
    return *std::prev(std::upper_bound(m_intervals.begin() + 1, m_intervals.end(), t, [=](double x, const Interval& i) {
      return is_ascending ? x < i.begin.parameter : x > i.begin.parameter;
    }));
  }

  void expand(std::size_t n)
  {
    m_intervals.clear();
    m_end.length = 0;
    const double begin = m_begin.parameter, width = m_end.parameter - begin;
    for(std::size_t i = 0; i < n; ++i)
      append(begin + width * double(i) / double(n), begin + width * double(i + 1) / double(n), max_depth);
    const double speed = m_intervals.front().speed.value(0);
    m_is_constant = std::all_of(m_intervals.begin(), m_intervals.end(), [=](const Interval& i) {
      return i.speed.is_constant() && std::fabs(i.speed.value(0) - speed) <= rounding * speed;
    });
  }

  // Halves the interval from `t0` to `t1` until the expansions converge.
  void append(double t0, double t1, int depth)
  {
    const double middle = t0 + 0.5 * (t1 - t0), half_width = 0.5 * (t1 - t0);
    const Legendre_expansion speed([&](double x) { return m_speed(middle + x * half_width); });
    if(depth > 0 && !speed.has_converged(tolerance)) {
      append(t0, middle, depth - 1);
      append(middle, t1, depth - 1);
      return;
    }
    m_intervals.push_back({{m_end.length, t0}, half_width, speed});
    m_end.length += std::fabs(half_width) * speed.integral(1);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURVES_ARC_LENGTH_H
