// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURVES_EQUAL_ARC_CURVE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURVES_EQUAL_ARC_CURVE_H

#include <CGAL/Domain_curve_2.h>
#include <CGAL/Parametric_surface_mesher/internal/curves/Arc_length.h>
#include <CGAL/Parametric_surface_mesher/divide_curve.h>

#include <cmath>
#include <functional>
#include <memory>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Two curves on surfaces that are the same curve in space, but run through it with different speeds. Two points correspond if
// the lengths before them are equal shares of the whole lengths.
template <class Surface>
class Equal_arc_curve
{
  typedef typename Surface::Geom_traits Kernel;
  typedef typename Kernel::Point_3 Point_3;
  typedef Domain_curve_2<Kernel> Curve;

  // A curve with its surface and its arc length. It owns all three.
  struct Measured_curve
  {
    Surface surface;
    Curve curve;
    Curve_on_surface_3<Surface> on_surface;
    Arc_length<std::function<double(double)>> length;

    Measured_curve(const Surface& s, const Curve& c)
      : surface(s), curve(c), on_surface(surface, curve),
        length([this](double t) { return on_surface.speed(t); }, c.begin(), c.end(), 16)
    {}
    Measured_curve(const Measured_curve&) = delete;
    Measured_curve& operator=(const Measured_curve&) = delete;
  };

  std::shared_ptr<const Measured_curve> m_first, m_second;

public:
  Equal_arc_curve(const Surface& first_surface, const Curve& first, const Surface& second_surface, const Curve& second)
    : m_first(std::make_shared<Measured_curve>(first_surface, first)),
      m_second(std::make_shared<Measured_curve>(second_surface, second))
  {}

  double length() const { return m_first->length.length(); }

  // Whether corresponding points are within the tolerance at `n + 1` places.
  bool is_within(double tolerance, int n) const
  {
    for(int i = 0; i <= n; ++i) {
      const double share = double(i) / n;
      const Point_3 p = m_first->on_surface.point(m_first->length.position_at(share * m_first->length.length()).parameter),
                    q = m_second->on_surface.point(m_second->length.position_at(share * m_second->length.length()).parameter);
      if(!(squared_distance(p, q) <= tolerance * tolerance))
        return false;
    }
    return true;
  }

  // The second curve with the parameters of the first one. Its second derivative is set to zero; it is not needed, because an
  // edge is measured on its first use.
  Curve reparametrized() const
  {
    const auto jet = [first = m_first, second = m_second](double t) {
      const double share = first->length.length_at(t) / first->length.length();
      const double s = second->length.position_at(share * second->length.length()).parameter;
      const auto c = second->curve.jet(s);
      const double speed = first->on_surface.speed(t) / first->length.length() * second->length.length();
      const double scale = speed / second->on_surface.speed(s) * (second->curve.end() > second->curve.begin() ? 1 : -1);
      return typename Curve::Jet{second->curve.point(s), (std::isfinite(scale) ? scale : 1) * c.first, 0 * c.first};
    };
    Curve result(jet, m_first->curve.begin(), m_first->curve.end());
    result.set_end_points(m_second->curve.source(), m_second->curve.target());
    return result;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURVES_EQUAL_ARC_CURVE_H
