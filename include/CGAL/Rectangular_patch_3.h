// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RECTANGULAR_PATCH_3_H
#define CGAL_RECTANGULAR_PATCH_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/surfaces/are_copies_independent.h>
#include <CGAL/Surface_jet_3.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

The part of a surface over the rectangle `[u_min, u_max] x [v_min, v_max]` of its domain: what
`make_model_of_rectangular_patches()` takes. A full turn of a cylinder, for instance, is a patch that meets itself.

On the sides of the rectangle `jet()` returns the derivatives from within, so that a crease of the surface may be a side.

\tparam Surface a model of `ParametricSurface_3`

\cgalModels{ParametricSurface_3}
*/
template <class Surface>
class Rectangular_patch_3
{
public:
  typedef typename Surface::Geom_traits Geom_traits;
  typedef typename Geom_traits::Point_3 Point_3;

private:
  Surface m_surface;
  double m_u_min, m_u_max, m_v_min, m_v_max;

public:
  /// \throws Parametric_surface_mesh_error if the bounds are not finite, or a lower one is not below the upper one
  Rectangular_patch_3(Surface surface, double u_min, double u_max, double v_min, double v_max)
    : m_surface(std::move(surface)), m_u_min(u_min), m_u_max(u_max), m_v_min(v_min), m_v_max(v_max)
  {
    if(!std::isfinite(u_max - u_min) || !std::isfinite(v_max - v_min) || !(u_min < u_max) || !(v_min < v_max)) {
      std::ostringstream message;
      message << "the rectangle [" << u_min << ", " << u_max << "] x [" << v_min << ", " << v_max
              << "] of a patch is empty or not finite";
      throw Parametric_surface_mesh_error(message.str());
    }
  }

  /// the whole surface.
  const Surface& surface() const { return m_surface; }

  double u_min() const { return m_u_min; }
  double u_max() const { return m_u_max; }
  double v_min() const { return m_v_min; }
  double v_max() const { return m_v_max; }

  /// as those of the whole surface; see `ParametricSurface_3`.
  bool has_independent_copies() const { return Parametric_surface_mesher::internal::are_copies_independent(m_surface); }

  /// `S(u,v)`
  Point_3 point(double u, double v) const { return m_surface.point(u, v); }

  /// `S(u,v)` with all partial derivatives up to second order.
  Surface_jet_3<Geom_traits> jet(double u, double v) const
  {
    return m_surface.jet(inward(u, m_u_min, m_u_max), inward(v, m_v_min, m_v_max));
  }

private:
  static double inward(double x, double min, double max)
  {
    return (std::min)((std::max)(x, std::nextafter(min, max)), std::nextafter(max, min));
  }
};

} // namespace CGAL

#endif // CGAL_RECTANGULAR_PATCH_3_H
