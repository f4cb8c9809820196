// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_ARC_LENGTH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_ARC_LENGTH_H

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
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

// The arc length of a curve in space, by adaptive quadrature of its speed, and its inverse.
template <class Speed>
class Arc_length
{
  Speed m_speed;
  std::vector<Curve_position> m_table;

public:
  // `speed(t)` is the length of the derivative; `end < begin` is allowed. The length is tabulated at `n` intervals.
  Arc_length(Speed speed, double begin, double end, std::size_t n)
    : m_speed(speed), m_table(1, Curve_position{0, begin})
  {
    for(std::size_t i = 1; i <= n; ++i) {
      const double t = i == n ? end : begin + (end - begin) * double(i) / double(n);
      m_table.push_back({m_table.back().length + length_between(m_table.back().parameter, t), t});
    }
  }

  double length() const { return m_table.back().length; }

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
    for(int step = 0; step < 60; ++step) {
      const double excess = from.length + length_between(from.parameter, t) - s;
      if(std::fabs(excess) <= 1e-11 * length())
        break;
      (excess < 0 ? t0 : t1) = t;
      const double newton = t - excess / m_speed(t) * (to.parameter > from.parameter ? 1 : -1);
      const bool is_inside = (newton - t0) * (newton - t1) < 0;
      t = is_inside ? newton : 0.5 * (t0 + t1);
      if(t == t0 || t == t1)
        break;
    }
    return {s, t};
  }

private:
  double length_between(double t0, double t1) const
  {
    // over [0,1], as the quadrature's stopping test does not scale with the interval
    const auto scaled_speed = [&](double x) { return m_speed(t0 + x * (t1 - t0)); };
    return std::fabs(t1 - t0)
           * boost::math::quadrature::gauss_kronrod<double, 15>::integrate(scaled_speed, 0., 1., 12, 1e-9);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_ARC_LENGTH_H
