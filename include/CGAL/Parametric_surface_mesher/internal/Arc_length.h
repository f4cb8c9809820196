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

// The arc length of a curve in space, by adaptive quadrature of its speed, and its inverse.
template <class Speed>
class Arc_length
{
  Speed m_speed;
  std::vector<double> m_parameters, m_lengths; // the length up to each of the parameters

public:
  // `speed(t)` is the length of the derivative; may not throw away the sign: `end < begin` is allowed.
  // The length is tabulated at `n` intervals.
  Arc_length(Speed speed, double begin, double end, std::size_t n)
    : m_speed(speed), m_parameters(1, begin), m_lengths(1, 0.)
  {
    for(std::size_t i = 1; i <= n; ++i) {
      const double t = i == n ? end : begin + (end - begin) * double(i) / double(n);
      m_lengths.push_back(m_lengths.back() + length_between(m_parameters.back(), t));
      m_parameters.push_back(t);
    }
  }

  double length() const { return m_lengths.back(); }

  // the parameter up to which the curve has length `s`
  double parameter_at(double s) const
  {
    if(s <= 0)
      return m_parameters.front();
    if(s >= length())
      return m_parameters.back();
    const std::size_t i = std::upper_bound(m_lengths.begin(), m_lengths.end(), s) - m_lengths.begin();
    return solve(m_parameters[i - 1], m_parameters[i], s - m_lengths[i - 1], m_lengths[i] - m_lengths[i - 1]);
  }

private:
  double length_between(double t0, double t1) const
  {
    return std::fabs(boost::math::quadrature::gauss_kronrod<double, 15>::integrate(m_speed, t0, t1, 12, 1e-9));
  }

  // Secant steps that keep a bracket; the interval has length `total` and the answer length `target` from t0.
  double solve(double t0, double t1, double target, double total) const
  {
    const double origin = t0;
    double below = 0, above = total;
    for(int step = 0; step < 40; ++step) {
      const double share = (target - below) / (above - below);
      const double t = t0 + (t1 - t0) * (step % 4 == 3 ? 0.5 : share);
      const double length = length_between(origin, t);
      if(std::fabs(length - target) <= 1e-12 * this->length() || t == t0 || t == t1)
        return t;
      (length < target ? t0 : t1) = t;
      (length < target ? below : above) = length;
    }
    return t0;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_ARC_LENGTH_H
