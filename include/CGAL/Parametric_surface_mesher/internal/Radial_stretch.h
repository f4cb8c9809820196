// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_RADIAL_STRETCH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_RADIAL_STRETCH_H

#include <CGAL/Parametric_surface_mesher/internal/Polar_chart_2.h>
#include <CGAL/Parametric_surface_mesher/internal/Radial_scale.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// How far a polar chart of a surface is from keeping angles: the ratio of the lengths that it gives to steps across and
// along the collapsed sides. It is 1 at the poles.
template <class Surface>
class Radial_stretch
{
  typedef typename Surface::Geom_traits Kernel;

  static constexpr double smallest_r = 1e-3; // closer to a pole the ratio counts as 1
  static constexpr double tolerated = 8;     // ratio of ratios

  const Surface& m_surface;
  Collapsed_side m_side; // the lower one of two
  bool m_has_two_poles;
  double m_at_begin = 1, m_at_end = 1;

public:
  Radial_stretch(const Surface& surface, const Collapsed_side& side, bool has_two_poles)
    : m_surface(surface), m_side(side), m_has_two_poles(has_two_poles)
  {
    m_at_begin = raw(begin());
    m_at_end = has_two_poles ? raw(end()) : m_at_begin;
  }

  // The scale that makes the chart keep angles as well as a function of the distance from the poles can; the identity if
  // the chart is good without, or the surface is not regular.
  Radial_scale scale() const
  {
    const int number_of_samples = 24;
    double smallest = 1, largest = 1;
    for(int i = 1; i <= number_of_samples; ++i) {
      const double r = double(i) / (number_of_samples + m_has_two_poles);
      const double ratio = (*this)(m_has_two_poles ? std::log(r / (1 - r)) : std::log(r));
      if(!(ratio > 0) || !std::isfinite(ratio))
        return Radial_scale();
      smallest = (std::min)(smallest, ratio);
      largest = (std::max)(largest, ratio);
    }
    return largest > tolerated * smallest ? Radial_scale(begin(), end(), *this) : Radial_scale();
  }

  // at the logarithm of r or, with two poles, of r/(1-r)
  double operator()(double l) const
  {
    const double r = r_of(l);
    return raw(l) / (m_at_begin * std::pow(m_at_end / m_at_begin, r));
  }

private:
  double begin() const { return std::log(smallest_r); }
  double end() const { return m_has_two_poles ? -begin() : 0; }
  double r_of(double l) const { return m_has_two_poles ? 1 / (1 + std::exp(-l)) : std::exp(l); }

  // in means over the domain
  double raw(double l) const
  {
    const int number_of_samples = 4;
    const double r = r_of(l), level = m_side.level + (m_side.is_lower ? r : -r) * m_side.extent;
    double along = 0, across = 0;
    for(int i = 0; i < number_of_samples; ++i) {
      const double x = m_side.low + (i + 0.5) / number_of_samples * (m_side.high - m_side.low);
      const auto jet = m_side.is_on_v_line ? m_surface.jet(x, level) : m_surface.jet(level, x);
      along += std::sqrt((m_side.is_on_v_line ? jet.du : jet.dv).squared_length());
      across += std::sqrt((m_side.is_on_v_line ? jet.dv : jet.du).squared_length());
    }
    return across * r * (m_has_two_poles ? 1 - r : 1) / along;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_RADIAL_STRETCH_H
