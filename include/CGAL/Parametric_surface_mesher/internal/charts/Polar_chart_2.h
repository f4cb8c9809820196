// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_POLAR_CHART_2_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_POLAR_CHART_2_H

#include <CGAL/Parametric_surface_mesher/internal/charts/Radial_scale.h>
#include <CGAL/Surface_jet_3.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A side of the domain that is a point in space: on a line `v = level` (or `u = level`).
struct Collapsed_side
{
  double from, to;  // range of the coordinate that runs along the side
  double low, high; // range of that coordinate in the whole domain
  double level;     // the value of the other coordinate on the side
  double extent;    // how far the domain reaches in the other coordinate
  double angle;     // in space, swept over by the directions that leave the side
  bool is_on_v_line;
  bool is_lower; // whether the domain lies above the level
};

/*
Coordinates in which a patch with poles is regular. A pole is a whole side of the domain: close to it the metric tensor
degenerates and the affine map of a triangle means nothing. In the plane of complex numbers z,
- with one pole, z = r e^(i theta): polar coordinates, the pole at the origin;
- with two opposite poles, E = r/(1-r) e^(i theta) goes from one pole at 0 to the other at infinity, and z = (E-1)/(E+1)
  brings that to 1: as a sphere is mapped by stereographic
  projection.
Here r is the coordinate across the collapsed side, from 0 to 1 over the extent of the domain, and theta, proportional to
the coordinate along it, sweeps over the angle that the pole has in space, but at most over 270 degrees, so that the ends
of a full turn stay apart. With one pole a scale may be put between the logarithms of |z| and r.
*/
template <class Kernel>
class Polar_chart_2
{
public:
  typedef typename Kernel::Point_2 Point_2;
  typedef std::complex<double> Complex;

private:
  int m_number_of_poles = 1;
  bool m_is_swapped = false;                    // whether the sides are on lines u = constant
  double m_middle = 0, m_theta_per_along = 1;   // for the coordinate along the sides
  double m_level = 0, m_across_per_r = 1;       // for the coordinate across them
  Radial_scale m_scale;
  double m_lower_angle = 0, m_upper_angle = 0;  // in space, at the poles at r = 0 and r = 1

public:
  Polar_chart_2() = default;

  explicit Polar_chart_2(const Collapsed_side& side, const Radial_scale& scale = Radial_scale())
    : m_number_of_poles(1), m_scale(scale)
  {
    set_theta(side, side.angle);
    m_lower_angle = side.angle;
    m_level = side.level;
    m_across_per_r = side.is_lower ? side.extent : -side.extent;
  }

  // \pre the two sides are opposite; `lower` is the one below the domain
  Polar_chart_2(const Collapsed_side& lower, const Collapsed_side& upper) : m_number_of_poles(2)
  {
    set_theta(lower, (std::max)(lower.angle, upper.angle));
    m_lower_angle = lower.angle;
    m_upper_angle = upper.angle;
    m_level = lower.level;
    m_across_per_r = upper.level - lower.level;
  }

  bool is_pole(const Point_2& z) const
  {
    return z.y() == 0 && (m_number_of_poles == 1 ? z.x() == 0 : z.x() == -1 || z.x() == 1);
  }

  // A point of the patch at about this distance from the pole `z`.
  Point_2 beside_pole(const Point_2& z, double distance) const
  {
    return Point_2(z.x() > 0 ? z.x() - distance : z.x() + distance, z.y());
  }

  // The angle that the surface has in space at the pole `z`.
  double angle_at_pole(const Point_2& z) const { return z.x() > 0 ? m_upper_angle : m_lower_angle; }

  // The chart point of a domain point.
  Point_2 chart_point(const Point_2& uv) const
  {
    const double along = m_is_swapped ? uv.y() : uv.x(), across = m_is_swapped ? uv.x() : uv.y();
    const double r = (across - m_level) / m_across_per_r, theta = (along - m_middle) * m_theta_per_along;
    if(m_number_of_poles == 1) {
      const Complex z = std::polar(scaled(r), theta);
      return Point_2(z.real(), z.imag());
    }
    if(r >= 1)
      return Point_2(1, 0);
    const Complex e = std::polar((std::max)(r, 0.) / (1 - r), theta);
    const Complex z = product(e - 1., reciprocal(e + 1.));
    return Point_2(z.real(), z.imag());
  }

  // The domain point of a chart point; for a pole, the middle of the collapsed side.
  Point_2 domain_point(const Point_2& z) const
  {
    if(is_pole(z))
      return in_domain(m_middle, z.x() > 0 ? m_level + m_across_per_r : m_level);
    return in_domain(m_middle + theta_of(z) / m_theta_per_along, m_level + m_across_per_r * radius(z).value);
  }

  // Moves `pole`, a domain point on a collapsed side, along that side to the place opposite to `other`.
  Point_2 on_collapsed_side(const Point_2& pole, const Point_2& other) const
  {
    return m_is_swapped ? Point_2(pole.x(), other.y()) : Point_2(other.x(), pole.y());
  }

  // Converts the jet of a surface from coordinates of the domain to those of the chart. Since L = log E is analytic, the
  // Cauchy-Riemann equations give all derivatives of its real and imaginary parts from L' and L''.
  // \pre `point` is not a pole
  Surface_jet_3<Kernel> chart_jet(const Surface_jet_3<Kernel>& s, const Point_2& point) const
  {
    const Complex z(point.x(), point.y());
    const Radial_scale::Jet r = radius(point);
    const Complex d = m_number_of_poles == 1 ? reciprocal(z) : 2. * reciprocal(1. - product(z, z));
    const Complex dd = m_number_of_poles == 1 ? -product(d, d) : product(z, product(d, d));
    const double r1 = m_across_per_r * r.first, r2 = m_across_per_r * r.second;
    const double t = 1 / m_theta_per_along;
    // p is the coordinate along the sides, q the one across them
    const double px = t * d.imag(), py = t * d.real(), pxx = t * dd.imag(), pxy = t * dd.real(), pyy = -pxx;
    const double ax = d.real(), ay = -d.imag(), axx = dd.real(), axy = -dd.imag();
    const double qx = r1 * ax, qy = r1 * ay;
    const double qxx = r2 * ax * ax + r1 * axx, qxy = r2 * ax * ay + r1 * axy, qyy = r2 * ay * ay - r1 * axx;
    const auto &sp = m_is_swapped ? s.dv : s.du, &sq = m_is_swapped ? s.du : s.dv;
    const auto &spp = m_is_swapped ? s.dvv : s.duu, &sqq = m_is_swapped ? s.duu : s.dvv;
    return {s.point,
            px * sp + qx * sq,
            py * sp + qy * sq,
            px * px * spp + 2 * px * qx * s.duv + qx * qx * sqq + pxx * sp + qxx * sq,
            px * py * spp + (px * qy + py * qx) * s.duv + qx * qy * sqq + pxy * sp + qxy * sq,
            py * py * spp + 2 * py * qy * s.duv + qy * qy * sqq + pyy * sp + qyy * sq};
  }

private:
  // The sign of theta is chosen such that the chart keeps the orientation of the domain.
  void set_theta(const Collapsed_side& side, double angle)
  {
    const double three_quarters = 1.5 * CGAL_PI; // of a turn
    m_is_swapped = !side.is_on_v_line;
    m_middle = 0.5 * (side.low + side.high);
    m_theta_per_along = (std::min)(angle / std::fabs(side.to - side.from), three_quarters / (side.high - side.low));
    if(side.is_lower == side.is_on_v_line)
      m_theta_per_along = -m_theta_per_along;
  }

  // With one pole, |z| as a function of r.
  double scaled(double r) const
  {
    return m_scale.is_identity() ? (std::max)(r, 0.) : r > 0 ? std::exp(m_scale.inverse(std::log(r))) : 0;
  }

  // This is computed in real arithmetic, since the complex functions of the standard library take several times as long.
  double theta_of(const Point_2& z) const
  {
    const double x = z.x(), y = z.y();
    return m_number_of_poles == 1 ? std::atan2(y, x) : std::atan2(2 * y, 1 - x * x - y * y);
  }

  // The radius r, with its derivatives by the logarithm of |E| (of |z|, with one pole). The logarithm costs as much as an
  // evaluation of a simple surface and is computed only if the radius is scaled.
  Radial_scale::Jet radius(const Point_2& z) const
  {
    const double x = z.x(), y = z.y();
    if(m_number_of_poles == 2) {
      const double below = std::sqrt((1 + x) * (1 + x) + y * y), above = std::sqrt((1 - x) * (1 - x) + y * y);
      const double r = below / (below + above), first = r * (1 - r);
      return {r, first, first * (1 - 2 * r)};
    }
    if(m_scale.is_identity()) {
      const double r = std::sqrt(x * x + y * y);
      return {r, r, r};
    }
    const Radial_scale::Jet l = m_scale(0.5 * std::log(x * x + y * y));
    const double r = std::exp(l.value);
    return {r, r * l.first, r * (l.first * l.first + l.second)};
  }

  static Complex reciprocal(const Complex& z)
  {
    const double n = z.real() * z.real() + z.imag() * z.imag();
    return Complex(z.real() / n, -z.imag() / n);
  }

  static Complex product(const Complex& z, const Complex& w)
  {
    return Complex(z.real() * w.real() - z.imag() * w.imag(), z.real() * w.imag() + z.imag() * w.real());
  }

  Point_2 in_domain(double along, double across) const
  {
    return m_is_swapped ? Point_2(across, along) : Point_2(along, across);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_POLAR_CHART_2_H
