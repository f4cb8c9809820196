// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_ARC_LENGTH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_ARC_LENGTH_H

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A point of a curve: the arc length up to it, and its parameter.
struct Curve_position
{
  double length;
  double parameter;
};

// The arc length of a curve in space, by adaptive quadrature of its speed, and its inverse. Where the speed is the same at
// all points of the quadrature, as on lines and circles, it counts as constant.
template <class Speed>
class Arc_length
{
  Speed m_speed;
  std::vector<Curve_position> m_table;
  double m_constant_speed = -1; // below 0 if it is not constant

public:
  // `speed(t)` is the length of the derivative; `end < begin` is allowed. The length is tabulated at `n` intervals.
  Arc_length(Speed speed, double begin, double end, std::size_t n) : m_speed(speed)
  {
    double smallest = std::numeric_limits<double>::infinity(), largest = 0;
    tabulate(begin, end, n, [&](double t) {
      const double result = m_speed(t);
      smallest = (std::min)(smallest, result);
      largest = (std::max)(largest, result);
      return result;
    });
    if(largest <= (1 + 1e-13) * smallest)
      m_constant_speed = largest;
  }

  double length() const { return m_table.back().length; }

  // Tabulates the length at `n` intervals, unless there are as many or the speed is constant.
  void refine(std::size_t n)
  {
    if(n + 1 > m_table.size() && !is_constant())
      tabulate(m_table.front().parameter, m_table.back().parameter, n, m_speed);
  }

  // the length up to the parameter `t`
  double length_at(double t) const
  {
    const bool is_ascending = m_table.back().parameter > m_table.front().parameter;
    const auto above = std::upper_bound(m_table.begin() + 1, m_table.end() - 1, t, [&](double t, const Curve_position& p) {
      return is_ascending ? t < p.parameter : t > p.parameter;
    });
    return (above - 1)->length + length_between((above - 1)->parameter, t);
  }

  // the position up to which the curve has length `s`
  Curve_position position_at(double s) const
  {
    if(s <= 0)
      return m_table.front();
    if(s >= length())
      return m_table.back();
    const auto above = std::upper_bound(m_table.begin(), m_table.end(), s,
                                        [](double s, const Curve_position& p) { return s < p.length; });
    return position_between(*(above - 1), *above, s);
  }

  // The position of length `s` between two known ones, by Newton steps that keep a bracket.
  Curve_position position_between(const Curve_position& from, const Curve_position& to, double s) const
  {
    double t0 = from.parameter, t1 = to.parameter;
    double t = t0 + (t1 - t0) * (s - from.length) / (to.length - from.length);
    if(is_constant())
      return {s, t};
    for(int step = 0; step < 60; ++step) {
      const double excess = from.length + length_between(from.parameter, t) - s;
      if(std::fabs(excess) <= 1e-11 * length())
        break;
      (excess < 0 ? t0 : t1) = t;
      const double newton = t - excess / m_speed(t) * (to.parameter > from.parameter ? 1 : -1);
      const bool is_inside = (newton - t0) * (newton - t1) < 0;
      t = is_inside ? newton : 0.5 * (t0 + t1);
      const bool is_last_step = is_inside && std::fabs(excess) <= 1e-7 * length(); // leaves the square of that
      if(t == t0 || t == t1 || is_last_step)
        break;
    }
    return {s, t};
  }

private:
  bool is_constant() const { return m_constant_speed >= 0; }

  template <class Function>
  void tabulate(double begin, double end, std::size_t n, const Function& speed)
  {
    m_table.assign(1, Curve_position{0, begin});
    for(std::size_t i = 1; i <= n; ++i) {
      const double t = i == n ? end : begin + (end - begin) * double(i) / double(n);
      m_table.push_back({m_table.back().length + integral(speed, m_table.back().parameter, t), t});
    }
  }

  double length_between(double t0, double t1) const
  {
    return is_constant() ? std::fabs(t1 - t0) * m_constant_speed : integral(m_speed, t0, t1);
  }

  template <class Function>
  static double integral(const Function& speed, double t0, double t1)
  {
    // over [0,1], as the quadrature's stopping test does not scale with the interval
    const auto scaled_speed = [&](double x) { return speed(t0 + x * (t1 - t0)); };
    return std::fabs(t1 - t0)
           * boost::math::quadrature::gauss_kronrod<double, 15>::integrate(scaled_speed, 0., 1., 12, 1e-9);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_ARC_LENGTH_H
