// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_DOMAIN_PERIODS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_DOMAIN_PERIODS_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Open_cascade_surface_3.h>

#include <cmath>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The whole periods of a surface between points of its domain.
class Domain_periods
{
  typedef Open_cascade_surface_3::Geom_traits Kernel;
  typedef Kernel::Point_2 Point_2;
  typedef Kernel::Vector_2 Vector_2;

  // Squared ratio of derivatives: below, a point is at a pole up to rounding.
  static constexpr double squared_ratio_at_pole = 1e-12;

  const Open_cascade_surface_3& m_surface;

public:
  explicit Domain_periods(const Open_cascade_surface_3& surface) : m_surface(surface) {}

  // The whole periods between `p` and `q`. At a pole, where lengths in the domain mean nothing, there are none.
  Vector_2 between(const Point_2& p, const Point_2& q) const
  {
    if(!(m_surface.u_period() > 0 || m_surface.v_period() > 0))
      return Vector_2(0, 0);
    const auto jet = m_surface.jet(p.x(), p.y());
    const bool is_pole_u = jet.du.squared_length() < squared_ratio_at_pole * jet.dv.squared_length(),
               is_pole_v = jet.dv.squared_length() < squared_ratio_at_pole * jet.du.squared_length();
    return Vector_2(is_pole_u ? 0 : whole_periods(q.x() - p.x(), m_surface.u_period()),
                    is_pole_v ? 0 : whole_periods(q.y() - p.y(), m_surface.v_period()));
  }

  // The whole periods that move the middle of a box into another one; none if that is not possible.
  Vector_2 into(const Bbox_2& inner, const Bbox_2& outer) const
  {
    return Vector_2(shift(inner.xmin(), inner.xmax(), outer.xmin(), outer.xmax(), m_surface.u_period()),
                    shift(inner.ymin(), inner.ymax(), outer.ymin(), outer.ymax(), m_surface.v_period()));
  }

private:
  static double shift(double min, double max, double outer_min, double outer_max, double period)
  {
    const double middle = 0.5 * (min + max);
    if(!(period > 0) || (outer_min <= middle && middle <= outer_max))
      return 0;
    const double result = period * std::ceil((outer_min - middle) / period);
    return middle + result <= outer_max ? result : 0;
  }

  static double whole_periods(double difference, double period)
  {
    return period > 0 ? period * std::round(difference / period) : 0;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_DOMAIN_PERIODS_H
