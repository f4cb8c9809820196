// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_SPHERE_PARAMETERS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_SPHERE_PARAMETERS_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/number_utils.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <ElSLib.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Sphere.hxx>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The parameters of points of a sphere, as Open CASCADE has them, for faces that are meshed in other parameters.
class Sphere_parameters
{
  static constexpr double pole = 1e-7; // cosine of a latitude at which the longitude has no meaning

  gp_Sphere m_sphere;
  double m_u_min = 0, m_u_max = 0;

public:
  explicit Sphere_parameters(const TopoDS_Face& face) : m_sphere(BRepAdaptor_Surface(face, false).Sphere())
  {
    double v_min = 0, v_max = 0;
    BRepTools::UVBounds(face, m_u_min, m_u_max, v_min, v_max);
  }

  // Returns the parameters of the corners of a triangle. All of them are in one period, and in that of the face where this is possible.
  // A corner at a pole has the longitude between those of the others.
  std::array<gp_Pnt2d, 3> operator()(const std::array<gp_Pnt, 3>& corners) const
  {
    std::array<double, 3> u, v;
    std::array<bool, 3> is_pole;
    for(std::size_t i = 0; i < 3; ++i) {
      ElSLib::Parameters(m_sphere, corners[i], u[i], v[i]);
      is_pole[i] = std::cos(v[i]) < pole;
    }
    const std::size_t first = is_pole[0] ? 1 : 0;
    for(std::size_t i = 0; i < 3; ++i)
      u[i] = nearest_turn(u[i], u[first]);
    for(std::size_t i = 0; i < 3; ++i)
      if(is_pole[i])
        u[i] = 0.5 * (u[(i + 1) % 3] + u[(i + 2) % 3]);
    const double mean = (u[0] + u[1] + u[2]) / 3, shift = nearest_turn(mean, 0.5 * (m_u_min + m_u_max)) - mean;
    return {gp_Pnt2d(u[0] + shift, v[0]), gp_Pnt2d(u[1] + shift, v[1]), gp_Pnt2d(u[2] + shift, v[2])};
  }

private:
  static double nearest_turn(double angle, double other)
  {
    const double turn = 2 * CGAL_PI;
    return angle - turn * std::round((angle - other) / turn);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_SPHERE_PARAMETERS_H
