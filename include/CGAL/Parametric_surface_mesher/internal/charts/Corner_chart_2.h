// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_CORNER_CHART_2_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_CORNER_CHART_2_H

#include <CGAL/Surface_jet_3.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Coordinates in which a patch with two collapsed sides that meet in a corner, both the same point P, is regular. With s and
t the distances from these sides, 1 at the opposite ones, the surface is P + s t A(s,t): it leaves P in the directions of
A(0,t) and A(s,0), and lines `s t = constant` go around P. The same is true of the plane map

  (x, y) = s t (1 + 2 s, 1 + 2 t),

which is one-to-one for positive s and t: the corner becomes the origin, and the sides that are left two curves from
there.
*/
template <class Kernel>
class Corner_chart_2
{
public:
  typedef typename Kernel::Point_2 Point_2;

private:
  // The angle at the origin is that from (1, 1 + k) to (1 + k, 1): 53 degrees for 2. With larger values the angle is wider and
  // the map is more distorted away from the origin.
  static constexpr double k = 2;

  struct Parameters
  {
    double s, t;
  };

  Point_2 m_corner;
  double m_u_extent = 1, m_v_extent = 1; // signed distances from the corner to the opposite sides
  bool m_is_s_along_u = true;            // chosen so that the chart keeps the orientation of the domain

public:
  Corner_chart_2() = default;

  // The domain is the rectangle with the diagonal from `corner` to `opposite`.
  Corner_chart_2(const Point_2& corner, const Point_2& opposite)
    : m_corner(corner), m_u_extent(opposite.x() - corner.x()), m_v_extent(opposite.y() - corner.y()),
      m_is_s_along_u(m_u_extent * m_v_extent > 0)
  {}

  bool is_pole(const Point_2& z) const { return z.x() == 0 && z.y() == 0; }

  // A point at about this distance from the pole, in the middle of the directions that leave it.
  Point_2 beside_pole(const Point_2&, double distance) const { return Point_2(distance, distance); }

  Point_2 chart_point(const Point_2& uv) const
  {
    const Parameters p = parameters((std::max)(0., (uv.x() - m_corner.x()) / m_u_extent),
                                    (std::max)(0., (uv.y() - m_corner.y()) / m_v_extent));
    const double product = p.s * p.t;
    return Point_2(product * (1 + k * p.s), product * (1 + k * p.t));
  }

  Point_2 domain_point(const Point_2& z) const
  {
    const Parameters p = parameters_at(z), q = parameters(p.s, p.t); // parameters() is its own inverse
    return Point_2(m_corner.x() + q.s * m_u_extent, m_corner.y() + q.t * m_v_extent);
  }

  // The point on the closer one of the collapsed sides that is opposite to `other`.
  Point_2 on_collapsed_side(const Point_2& other) const
  {
    return (other.x() - m_corner.x()) / m_u_extent < (other.y() - m_corner.y()) / m_v_extent
             ? Point_2(m_corner.x(), other.y())
             : Point_2(other.x(), m_corner.y());
  }

  // Converts the jet of a surface from coordinates of the domain to those of the chart, at the chart point `z`, by the
  // derivatives of the inverse map.
  // \pre `z` is not the pole
  Surface_jet_3<Kernel> chart_jet(const Surface_jet_3<Kernel>& by_uv, const Point_2& z) const
  {
    const Surface_jet_3<Kernel> j = jet_by_parameters(by_uv);
    const Parameters p = parameters_at(z);
    const double x_s = p.t * (1 + 2 * k * p.s), x_t = p.s * (1 + k * p.s), y_s = p.t * (1 + k * p.t),
                 y_t = p.s * (1 + 2 * k * p.t), determinant = x_s * y_t - x_t * y_s;
    const double s_x = y_t / determinant, s_y = -x_t / determinant, t_x = -y_s / determinant, t_y = x_s / determinant;
    // the second derivative of the map in two directions (s,t), times the inverse of its first, with changed sign
    const auto second = [&](double s1, double t1, double s2, double t2) {
      const double mixed = s1 * t2 + s2 * t1;
      const double x = 2 * k * p.t * s1 * s2 + (1 + 2 * k * p.s) * mixed,
                   y = 2 * k * p.s * t1 * t2 + (1 + 2 * k * p.t) * mixed;
      return Parameters{-(s_x * x + s_y * y), -(t_x * x + t_y * y)};
    };
    const auto along = [&](double s1, double t1, double s2, double t2) {
      const Parameters d = second(s1, t1, s2, t2);
      return s1 * s2 * j.duu + (s1 * t2 + s2 * t1) * j.duv + t1 * t2 * j.dvv + d.s * j.du + d.t * j.dv;
    };
    return {j.point,
            s_x * j.du + t_x * j.dv,
            s_y * j.du + t_y * j.dv,
            along(s_x, t_x, s_x, t_x),
            along(s_x, t_x, s_y, t_y),
            along(s_y, t_y, s_y, t_y)};
  }

private:
  Parameters parameters(double a, double b) const { return m_is_s_along_u ? Parameters{a, b} : Parameters{b, a}; }

  Surface_jet_3<Kernel> jet_by_parameters(const Surface_jet_3<Kernel>& j) const
  {
    const double a = m_u_extent, b = m_v_extent;
    return m_is_s_along_u ? Surface_jet_3<Kernel>{j.point, a * j.du, b * j.dv, a * a * j.duu, a * b * j.duv, b * b * j.dvv}
                          : Surface_jet_3<Kernel>{j.point, b * j.dv, a * j.du, b * b * j.dvv, a * b * j.duv, a * a * j.duu};
  }

  // With c = s t, x - y = k c (s - t) and x + y = 2 c + sqrt((x - y)^2 + 4 k^2 c^3). The right side is convex in c, so Newton's
  // method descends to the solution from any start above it.
  static Parameters parameters_at(const Point_2& z)
  {
    const double x = (std::max)(z.x(), 0.), y = (std::max)(z.y(), 0.), sum = x + y, difference = x - y;
    double c = sum / 2;
    if(!(c > 0))
      return {0, 0};
    for(int i = 0; i < 100; ++i) {
      const double root = std::sqrt(difference * difference + 4 * k * k * c * c * c);
      const double next = c - (2 * c + root - sum) / (2 + (root > 0 ? 6 * k * k * c * c / root : 0));
      if(!(next < c * (1 - 1e-15)) || !(next > 0))
        break;
      c = next;
    }
    const double d = difference / (k * c), larger = 0.5 * (std::fabs(d) + std::sqrt(d * d + 4 * c));
    return d > 0 ? Parameters{larger, c / larger} : Parameters{c / larger, larger};
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_CORNER_CHART_2_H
