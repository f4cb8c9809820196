// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_STEREOGRAPHIC_SPHERE_3_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_STEREOGRAPHIC_SPHERE_3_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Domain_curve_2.h>
#include <CGAL/Parametric_frame_3.h>
#include <CGAL/Surface_jet_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
A sphere, parametrised by stereographic projection from its point in the `z` direction of a frame. It has no seams and no poles,
apart from that one point, and everywhere the same scale in all directions. With g = 2 / (1 + u^2 + v^2),

  S(u,v) = center + r (u g, v g, 1 - g).

With a right-handed frame S_u x S_v points inward.
*/
template <class Kernel>
class Stereographic_sphere_3
{
public:
  typedef Kernel Geom_traits;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_2 Vector_2;
  typedef typename Kernel::Vector_3 Vector_3;
  typedef Domain_curve_2<Kernel> Curve;

private:
  Parametric_frame_3<Kernel> m_frame;
  double m_radius;

public:
  Stereographic_sphere_3(const Parametric_frame_3<Kernel>& frame, double radius) : m_frame(frame), m_radius(radius) {}

  Point_3 point(double u, double v) const
  {
    const double g = 2 / (1 + u * u + v * v);
    return m_frame.origin() + vector(u * g, v * g, 1 - g);
  }

  std::array<std::vector<double>, 2> feature_lines() const { return {}; }

  Surface_jet_3<Kernel> jet(double u, double v) const
  {
    const double g = 2 / (1 + u * u + v * v);
    const double gu = -u * g * g, gv = -v * g * g;
    const double guu = -g * g - 2 * u * g * gu, guv = -2 * u * g * gv, gvv = -g * g - 2 * v * g * gv;
    return {m_frame.origin() + vector(u * g, v * g, 1 - g),
            vector(g + u * gu, v * gu, -gu),
            vector(u * gv, g + v * gv, -gv),
            vector(2 * gu + u * guu, v * guu, -guu),
            vector(gv + u * guv, gu + v * guv, -guv),
            vector(u * gvv, 2 * gv + v * gvv, -gvv)};
  }

  // Converts a curve from the domain of another parametrisation of the same sphere to this domain.
  template <class Surface>
  Curve curve(const Surface& surface, const Curve& other) const
  {
    return Curve([sphere = *this, surface, other](double t) { return domain_jet(sphere.space_jet(surface, other, t)); },
                 other.begin(), other.end());
  }

  // Converts a point of the domain of another parametrisation of the same sphere.
  template <class Surface>
  Point_2 domain_point(const Surface& surface, const Point_2& other) const
  {
    const Vector_3 n = in_frame(surface.point(other.x(), other.y()) - m_frame.origin());
    return Point_2(n.x() / (1 - n.z()), n.y() / (1 - n.z()));
  }

private:
  // A point of a curve in space with its derivatives.
  struct Space_jet
  {
    Vector_3 point, first, second; // relative to the centre, in coordinates of the frame, divided by the radius
  };

  Vector_3 vector(double x, double y, double z) const { return m_frame.vector(m_radius * x, m_radius * y, m_radius * z); }

  Vector_3 in_frame(const Vector_3& v) const
  {
    return Vector_3(v * m_frame.x_direction(), v * m_frame.y_direction(), v * m_frame.z_direction()) / m_radius;
  }

  template <class Surface>
  Space_jet space_jet(const Surface& surface, const Curve& curve, double t) const
  {
    auto c = curve.jet(t);
    c.point = curve.point(t);
    const auto s = surface.jet(c.point.x(), c.point.y());
    const double u = c.first.x(), v = c.first.y();
    return {in_frame(s.point - m_frame.origin()), in_frame(u * s.du + v * s.dv),
            in_frame(u * u * s.duu + 2 * u * v * s.duv + v * v * s.dvv + c.second.x() * s.du + c.second.y() * s.dv)};
  }

  // Projects to the domain: (x, y) / (1 - z).
  static typename Curve::Jet domain_jet(const Space_jet& n)
  {
    const double w = 1 / (1 - n.point.z());
    const double w1 = n.first.z() * w * w, w2 = n.second.z() * w * w + 2 * n.first.z() * n.first.z() * w * w * w;
    const Vector_2 p(n.point.x(), n.point.y()), p1(n.first.x(), n.first.y()), p2(n.second.x(), n.second.y());
    return {Point_2(p.x() * w, p.y() * w), w * p1 + w1 * p, w * p2 + 2 * w1 * p1 + w2 * p};
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_STEREOGRAPHIC_SPHERE_3_H
