// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_PERIODIC_B_SPLINE_SURFACE_3_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_PERIODIC_B_SPLINE_SURFACE_3_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/B_spline_surface_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A B-spline surface, continued periodically in the directions in which it closes smoothly on itself.
template <class Kernel>
class Periodic_b_spline_surface_3
{
  typedef B_spline_surface_3<Kernel> Spline;

  Spline m_spline;
  bool m_is_periodic_u, m_is_periodic_v;

public:
  typedef Kernel Geom_traits;

  Periodic_b_spline_surface_3(Spline spline, bool is_periodic_u, bool is_periodic_v)
    : m_spline(std::move(spline)), m_is_periodic_u(is_periodic_u), m_is_periodic_v(is_periodic_v)
  {}

  auto point(double u, double v) const { return m_spline.point(base_u(u), base_v(v)); }
  auto jet(double u, double v) const { return m_spline.jet(base_u(u), base_v(v)); }

  std::array<std::vector<double>, 2> feature_lines() const
  {
    std::array<std::vector<double>, 2> result = m_spline.feature_lines();
    if(m_is_periodic_u)
      add_periods(m_spline.u_max() - m_spline.u_min(), result[0]);
    if(m_is_periodic_v)
      add_periods(m_spline.v_max() - m_spline.v_min(), result[1]);
    return result;
  }

private:
  // one before, and one after: the domains of faces are not farther away
  static void add_periods(double period, std::vector<double>& lines)
  {
    const std::vector<double> base(std::move(lines));
    lines.clear();
    for(int i = -1; i <= 1; ++i)
      for(double x : base)
        lines.push_back(x + i * period);
  }

  double base_u(double u) const { return m_is_periodic_u ? base(u, m_spline.u_min(), m_spline.u_max()) : u; }
  double base_v(double v) const { return m_is_periodic_v ? base(v, m_spline.v_min(), m_spline.v_max()) : v; }

  // Moves `x` into the base period; both of its ends stay where they are.
  static double base(double x, double min, double max)
  {
    return min <= x && x <= max ? x : x - std::floor((x - min) / (max - min)) * (max - min);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_PERIODIC_B_SPLINE_SURFACE_3_H
