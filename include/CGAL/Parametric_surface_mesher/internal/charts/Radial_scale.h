// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_RADIAL_SCALE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_RADIAL_SCALE_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
A monotone function l of a real number a, by a table: that with `dl/da = 1 / stretch(l)` and `l = a` at the beginning of a
range of l. Beyond the table it is continued by straight lines. Without a table it is the identity.

Cubic between the entries, so its first derivative is continuous.
*/
class Radial_scale
{
  static constexpr double step = 0.1; // of a, between entries of the table
  static constexpr std::size_t max_number_of_entries = 240;

  double m_begin = 0;
  std::vector<double> m_values, m_slopes;

public:
  struct Jet
  {
    double value, first, second;
  };

  Radial_scale() = default;

  // The scale stays the identity if the range is too long for the table.
  template <class Stretch>
  Radial_scale(double begin, double end, const Stretch& stretch) : m_begin(begin)
  {
    double l = begin;
    const auto slope = [&](double x) { return 1 / stretch((std::min)(x, end)); };
    append(l, slope(l));
    while(l < end) {
      if(m_values.size() == max_number_of_entries) {
        m_values.clear();
        m_slopes.clear();
        return;
      }
      const double k1 = m_slopes.back(), k2 = slope(l + 0.5 * step * k1), k3 = slope(l + 0.5 * step * k2),
                   k4 = slope(l + step * k3); // classical Runge-Kutta method; one function does not justify odeint
      l += step * (k1 + 2 * k2 + 2 * k3 + k4) / 6;
      append(l, slope(l));
    }
  }

  bool is_identity() const { return m_values.empty(); }

  Jet operator()(double a) const
  {
    if(is_identity())
      return {a, 1, 0};
    const double x = (a - m_begin) / step, last = double(m_values.size() - 1);
    if(x <= 0 || x >= last) {
      const std::size_t i = x <= 0 ? 0 : m_values.size() - 1;
      return {m_values[i] + (x <= 0 ? x : x - last) * step * m_slopes[i], m_slopes[i], 0};
    }
    const std::size_t i = std::size_t(x);
    const double t = x - double(i), d = (m_values[i + 1] - m_values[i]) / step, s = m_slopes[i], e = m_slopes[i + 1];
    const double c2 = 3 * d - 2 * s - e, c3 = s + e - 2 * d; // cubic Hermite interpolation, with derivatives
    return {m_values[i] + step * t * (s + t * (c2 + t * c3)), s + t * (2 * c2 + 3 * t * c3), (2 * c2 + 6 * t * c3) / step};
  }

  // The `a` at which the scale has this value.
  double inverse(double value) const
  {
    if(is_identity())
      return value;
    const auto above = std::upper_bound(m_values.begin(), m_values.end(), value);
    const std::size_t i = std::size_t((std::max)(above - m_values.begin(), std::ptrdiff_t(1)) - 1);
    double a = m_begin + step * double(i);
    for(int k = 0; k < 6; ++k) {
      const Jet jet = (*this)(a);
      a += (value - jet.value) / jet.first;
      if(std::fabs(value - jet.value) < 1e-15)
        break;
    }
    return a;
  }

private:
  void append(double value, double slope)
  {
    m_values.push_back(value);
    m_slopes.push_back(slope);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_RADIAL_SCALE_H
