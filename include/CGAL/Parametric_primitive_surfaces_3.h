// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_PRIMITIVE_SURFACES_3_H
#define CGAL_PARAMETRIC_PRIMITIVE_SURFACES_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_frame_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/surfaces/Surface_of_revolution_3.h>
#include <CGAL/Surface_jet_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Origin.h>
#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <sstream>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

The plane `S(u,v) = origin + u a + v b`.

\tparam Kernel a model of `Kernel` with `double` as number type

\cgalModels{ParametricSurface_3}
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel>
class Parametric_plane_3
{
public:
  typedef Kernel Geom_traits;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;

private:
  Point_3 m_origin;
  Vector_3 m_a, m_b;

public:
  /*!
  the plane through `origin` with the directions `a` and `b`, of any length and angle.
  \throws Parametric_surface_mesh_error if a coordinate is not finite or `a` and `b` are parallel
  */
  Parametric_plane_3(const Point_3& origin, const Vector_3& a, const Vector_3& b)
    : m_origin(origin), m_a(a), m_b(b)
  {
    const double squared_area = cross_product(a, b).squared_length();
    if(!std::isfinite(squared_area + (origin - ORIGIN).squared_length()) || !(squared_area > 0)) {
      std::ostringstream message;
      message << "plane: expected a finite origin and two vectors that span it, found origin (" << origin
              << "), vectors (" << a << ") and (" << b << ")";
      throw Parametric_surface_mesh_error(message.str());
    }
  }

  /// the plane of the `x` and `y` direction of `frame`.
  explicit Parametric_plane_3(const Parametric_frame_3<Kernel>& frame = Parametric_frame_3<Kernel>())
    : m_origin(frame.origin()), m_a(frame.x_direction()), m_b(frame.y_direction())
  {}

  /// `S(u,v)`
  Point_3 point(double u, double v) const { return m_origin + u * m_a + v * m_b; }

  /// `S(u,v)` with all partial derivatives up to second order.
  Surface_jet_3<Kernel> jet(double u, double v) const
  {
    const Vector_3 zero(0, 0, 0);
    return { point(u, v), m_a, m_b, zero, zero, zero };
  }

  /// none: a plane has no features.
  std::array<std::vector<double>, 2> feature_lines() const { return {}; }
};

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

The cylinder `S(u,v) = (r cos u, r sin u, v)` in the coordinates of a frame.

\tparam Kernel a model of `Kernel` with `double` as number type

\cgalModels{ParametricSurface_3}
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel>
class Parametric_cylinder_3
  : public Parametric_surface_mesher::internal::Surface_of_revolution_3<
             Kernel, Parametric_surface_mesher::internal::Line_profile>
{
  typedef Parametric_surface_mesher::internal::Surface_of_revolution_3<
            Kernel, Parametric_surface_mesher::internal::Line_profile> Base;

  double m_radius;

public:
  typedef Parametric_frame_3<Kernel> Frame_3;

  /*!
  the cylinder of the given radius about the `z` direction of `frame`.
  \throws Parametric_surface_mesh_error if `radius` is not positive and finite
  */
  explicit Parametric_cylinder_3(double radius, const Frame_3& frame = Frame_3())
    : Base({ radius, 0, 1 }, frame), m_radius(radius)
  {
    Base::check_positive("cylinder", "radius", radius);
  }

  /// the radius.
  double radius() const { return m_radius; }
};

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

The cone `S(u,v) = ((r + v sin a) cos u, (r + v sin a) sin u, v cos a)` in the coordinates of a frame, where `r` is
the radius at `v = 0` and `a` the angle of its lines to the axis. The lines meet in the apex at `v = -r / sin a`,
where the surface has no tangent plane.

\tparam Kernel a model of `Kernel` with `double` as number type

\cgalModels{ParametricSurface_3}
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel>
class Parametric_cone_3
  : public Parametric_surface_mesher::internal::Surface_of_revolution_3<
             Kernel, Parametric_surface_mesher::internal::Line_profile>
{
  typedef Parametric_surface_mesher::internal::Surface_of_revolution_3<
            Kernel, Parametric_surface_mesher::internal::Line_profile> Base;

  double m_radius, m_semi_angle;

public:
  typedef Parametric_frame_3<Kernel> Frame_3;

  /*!
  the cone with radius `radius` in the `xy` plane of `frame`, that widens with `v` by the angle `semi_angle`
  (radians), or narrows if it is negative.
  \throws Parametric_surface_mesh_error if `radius` is negative or not finite, or `semi_angle` is not in
          `(-pi/2, pi/2)` or zero
  */
  Parametric_cone_3(double radius, double semi_angle, const Frame_3& frame = Frame_3())
    : Base({ radius, std::sin(semi_angle), std::cos(semi_angle) }, frame),
      m_radius(radius), m_semi_angle(semi_angle)
  {
    if(radius != 0)
      Base::check_positive("cone", "radius", radius);
    if(semi_angle == 0 || !(std::abs(semi_angle) < CGAL_PI / 2))
      Base::refuse("cone", "semi-angle in (-pi/2, pi/2) and not 0", semi_angle);
  }

  /// the radius at `v = 0`.
  double radius() const { return m_radius; }

  /// the angle of the lines to the axis, in radians.
  double semi_angle() const { return m_semi_angle; }
};

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

The sphere `S(u,v) = (r cos v cos u, r cos v sin u, r sin v)` in the coordinates of a frame: `u` is the longitude,
`v` the latitude. It is degenerate at the poles `v = +-pi/2`.

\tparam Kernel a model of `Kernel` with `double` as number type

\cgalModels{ParametricSurface_3}
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel>
class Parametric_sphere_3
  : public Parametric_surface_mesher::internal::Surface_of_revolution_3<
             Kernel, Parametric_surface_mesher::internal::Circle_profile>
{
  typedef Parametric_surface_mesher::internal::Surface_of_revolution_3<
            Kernel, Parametric_surface_mesher::internal::Circle_profile> Base;

  double m_radius;

public:
  typedef Parametric_frame_3<Kernel> Frame_3;

  /*!
  the sphere of the given radius about the origin of `frame`.
  \throws Parametric_surface_mesh_error if `radius` is not positive and finite
  */
  explicit Parametric_sphere_3(double radius, const Frame_3& frame = Frame_3())
    : Base({ 0, radius }, frame), m_radius(radius)
  {
    Base::check_positive("sphere", "radius", radius);
  }

  /// the radius.
  double radius() const { return m_radius; }
};

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

The torus `S(u,v) = ((R + r cos v) cos u, (R + r cos v) sin u, r sin v)` in the coordinates of a frame: `u` is the
angle about the axis, `v` that about the circle of the tube's centres. Where `r >= R` the torus crosses itself, or
touches itself.

\tparam Kernel a model of `Kernel` with `double` as number type

\cgalModels{ParametricSurface_3}
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel>
class Parametric_torus_3
  : public Parametric_surface_mesher::internal::Surface_of_revolution_3<
             Kernel, Parametric_surface_mesher::internal::Circle_profile>
{
  typedef Parametric_surface_mesher::internal::Surface_of_revolution_3<
            Kernel, Parametric_surface_mesher::internal::Circle_profile> Base;

  double m_major_radius, m_minor_radius;

public:
  typedef Parametric_frame_3<Kernel> Frame_3;

  /*!
  the torus about the `z` direction of `frame`.
  \throws Parametric_surface_mesh_error if a radius is not positive and finite
  */
  Parametric_torus_3(double major_radius, double minor_radius, const Frame_3& frame = Frame_3())
    : Base({ major_radius, minor_radius }, frame), m_major_radius(major_radius), m_minor_radius(minor_radius)
  {
    Base::check_positive("torus", "major radius", major_radius);
    Base::check_positive("torus", "minor radius", minor_radius);
  }

  /// the radius of the circle of the tube's centres.
  double major_radius() const { return m_major_radius; }

  /// the radius of the tube.
  double minor_radius() const { return m_minor_radius; }
};

} // namespace CGAL

#endif // CGAL_PARAMETRIC_PRIMITIVE_SURFACES_3_H
