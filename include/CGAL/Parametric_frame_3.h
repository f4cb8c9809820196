// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_FRAME_3_H
#define CGAL_PARAMETRIC_FRAME_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesh_error.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Origin.h>

#include <cmath>
#include <sstream>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

The place of a surface in space: an origin and three orthonormal directions, right- or left-handed.

\tparam Kernel a model of `Kernel` with `double` as number type
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel>
class Parametric_frame_3
{
public:
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;

private:
  Point_3 m_origin;
  Vector_3 m_x, m_y, m_z;

public:
  /// the standard frame.
  Parametric_frame_3() : m_origin(0, 0, 0), m_x(1, 0, 0), m_y(0, 1, 0), m_z(0, 0, 1) {}

  /*!
  the right-handed frame with the `z` direction of `axis`, whose `x` direction is that of `x_hint` as far as it is
  orthogonal to `axis`.
  \throws Parametric_surface_mesh_error if a coordinate is not finite or the vectors are parallel
  */
  Parametric_frame_3(const Point_3& origin, const Vector_3& axis, const Vector_3& x_hint)
    : m_origin(origin), m_z(axis / length(axis))
  {
    const Vector_3 y = cross_product(m_z, x_hint / length(x_hint));
    m_y = y / length(y);
    m_x = cross_product(m_y, m_z);
    check("two vectors that are not parallel", axis, x_hint);
  }

  /*!
  the frame with the given directions; left-handed if they are.
  \throws Parametric_surface_mesh_error if a coordinate is not finite or the vectors are not orthonormal
          (up to `1e-9`)
  */
  Parametric_frame_3(const Point_3& origin, const Vector_3& x, const Vector_3& y, const Vector_3& z)
    : m_origin(origin), m_x(x), m_y(y), m_z(z)
  {
    check("orthonormal vectors", x, y);
  }

  const Point_3& origin() const { return m_origin; }
  const Vector_3& x_direction() const { return m_x; }
  const Vector_3& y_direction() const { return m_y; }
  const Vector_3& z_direction() const { return m_z; }

  /// the vector with the coordinates `x`, `y`, `z` in the frame.
  Vector_3 vector(double x, double y, double z) const
  {
    return Vector_3(x * m_x.x() + y * m_y.x() + z * m_z.x(),
                    x * m_x.y() + y * m_y.y() + z * m_z.y(),
                    x * m_x.z() + y * m_y.z() + z * m_z.z());
  }

private:
  static double length(const Vector_3& v) { return std::sqrt(v.squared_length()); }

  bool is_orthonormal() const
  {
    const double products[6] = { m_x * m_x - 1, m_y * m_y - 1, m_z * m_z - 1, m_x * m_y, m_y * m_z, m_z * m_x };
    for(double product : products)
      if(!(std::abs(product) < 1e-9)) // true for nan
        return false;
    return true;
  }

  void check(const char* expected, const Vector_3& a, const Vector_3& b) const
  {
    if(std::isfinite(length(m_origin - ORIGIN)) && is_orthonormal())
      return;
    std::ostringstream message;
    message << "frame: expected a finite origin and " << expected << ", found origin (" << m_origin
            << "), vectors (" << a << ") and (" << b << ")";
    throw Parametric_surface_mesh_error(message.str());
  }
};

} // namespace CGAL

#endif // CGAL_PARAMETRIC_FRAME_3_H
