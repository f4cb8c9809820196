// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_SURFACE_OF_REVOLUTION_3_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_SURFACE_OF_REVOLUTION_3_H

#include <CGAL/Parametric_frame_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Surface_jet_3.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A point of a profile curve, or one of its derivatives: distance from the axis and height.
struct Profile_point
{
  double radius, height;
};

struct Profile_jet
{
  Profile_point point, first, second;
};

// v -> (radius + v radius_slope, v height_slope)
struct Line_profile
{
  double radius, radius_slope, height_slope;

  Profile_point point(double v) const { return { radius + v * radius_slope, v * height_slope }; }

  Profile_jet jet(double v) const { return { point(v), { radius_slope, height_slope }, { 0, 0 } }; }
};

// v -> (center + radius cos v, radius sin v)
struct Circle_profile
{
  double center, radius;

  Profile_point point(double v) const { return { center + radius * std::cos(v), radius * std::sin(v) }; }

  Profile_jet jet(double v) const
  {
    const double c = radius * std::cos(v), s = radius * std::sin(v);
    return { { center + c, s }, { -s, c }, { -c, -s } };
  }
};

// S(u,v) = (r(v) cos u, r(v) sin u, h(v)) in a frame, for the profile v -> (r, h).
template <class Kernel, class Profile>
class Surface_of_revolution_3
{
public:
  typedef Kernel Geom_traits;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;

private:
  Profile m_profile;
  Parametric_frame_3<Kernel> m_frame;

protected:
  Surface_of_revolution_3(const Profile& profile, const Parametric_frame_3<Kernel>& frame)
    : m_profile(profile), m_frame(frame)
  {}

  [[noreturn]] static void refuse(const char* surface, const std::string& expected, double value)
  {
    std::ostringstream message;
    message << surface << ": expected a " << expected << ", found " << value;
    throw Parametric_surface_mesh_error(message.str());
  }

  static void check_positive(const char* surface, const std::string& name, double value)
  {
    if(!(std::isfinite(value) && value > 0))
      refuse(surface, "positive finite " + name, value);
  }

public:
  /// the place of the surface.
  const Parametric_frame_3<Kernel>& frame() const { return m_frame; }

  /// `S(u,v)`
  Point_3 point(double u, double v) const
  {
    const Vector_3 outward = m_frame.vector(std::cos(u), std::sin(u), 0);
    return m_frame.origin() + in_meridian_plane(m_profile.point(v), outward);
  }

  /// `S(u,v)` with all partial derivatives up to second order.
  Surface_jet_3<Kernel> jet(double u, double v) const
  {
    const Profile_jet p = m_profile.jet(v);
    const double c = std::cos(u), s = std::sin(u);
    const Vector_3 outward = m_frame.vector(c, s, 0), along = m_frame.vector(-s, c, 0);
    return { m_frame.origin() + in_meridian_plane(p.point, outward),
             p.point.radius * along, in_meridian_plane(p.first, outward),
             -p.point.radius * outward, p.first.radius * along, in_meridian_plane(p.second, outward) };
  }

  /// none: lines and circles have no features.
  std::array<std::vector<double>, 2> feature_lines() const { return {}; }

private:
  Vector_3 in_meridian_plane(const Profile_point& p, const Vector_3& outward) const
  {
    return p.radius * outward + p.height * m_frame.z_direction();
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_SURFACE_OF_REVOLUTION_3_H
