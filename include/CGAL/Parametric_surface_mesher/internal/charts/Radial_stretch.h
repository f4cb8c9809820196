// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_RADIAL_STRETCH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_RADIAL_STRETCH_H

#include <CGAL/Parametric_surface_mesher/internal/charts/Polar_chart_2.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Radial_scale.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Measures how far a polar chart with one pole is from keeping angles: of two steps that are equally long in the chart, one across
// the collapsed side and one along it, the ratio of the lengths on the surface. It is 1 at the pole.
template <class Surface>
class Radial_stretch
{
  // Closer to the pole the ratio counts as 1.
  static constexpr double smallest_r = 1e-3;
  // The chart gets a scale only if the ratio varies by more than this factor; smaller variations are left to the metric tensor.
  static constexpr double tolerated = 8;

  const Surface& m_surface;
  Collapsed_side m_side;
  double m_at_pole = 1;

public:
  Radial_stretch(const Surface& surface, const Collapsed_side& side) : m_surface(surface), m_side(side)
  {
    m_at_pole = (*this)(std::log(smallest_r));
  }

  // The scale of the radius with which the chart keeps angles best. It is the identity if the chart is good enough without one,
  // or if the surface is not regular.
  Radial_scale scale() const
  {
    const int number_of_samples = 24;
    double smallest = 1, largest = 1;
    for(int i = 1; i <= number_of_samples; ++i) {
      const double ratio = (*this)(std::log(double(i) / number_of_samples));
      if(!(ratio > 0) || !std::isfinite(ratio))
        return Radial_scale();
      smallest = (std::min)(smallest, ratio);
      largest = (std::max)(largest, ratio);
    }
    return largest > tolerated * smallest ? Radial_scale(std::log(smallest_r), 0, *this) : Radial_scale();
  }

  // The ratio at this logarithm of r, in means over the domain.
  double operator()(double log_of_r) const
  {
    const int number_of_samples = 4;
    const double r = std::exp(log_of_r), level = m_side.level + (m_side.is_lower ? r : -r) * m_side.extent;
    double along = 0, across = 0;
    for(int i = 0; i < number_of_samples; ++i) {
      const double x = m_side.low + (i + 0.5) / number_of_samples * (m_side.high - m_side.low);
      const auto jet = m_side.is_on_v_line ? m_surface.jet(x, level) : m_surface.jet(level, x);
      along += std::sqrt((m_side.is_on_v_line ? jet.du : jet.dv).squared_length());
      across += std::sqrt((m_side.is_on_v_line ? jet.dv : jet.du).squared_length());
    }
    return across * r / along / m_at_pole;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_RADIAL_STRETCH_H
