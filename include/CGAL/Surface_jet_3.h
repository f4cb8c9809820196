// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_JET_3_H
#define CGAL_SURFACE_JET_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

A surface point with the partial derivatives of the parametrisation up to second order:
what a model of `ParametricSurface_3` returns from `jet(u, v)`.

\tparam Kernel a model of `Kernel` with `double` as number type
*/
template <class Kernel>
struct Surface_jet_3
{
  static_assert(std::is_same<typename Kernel::FT, double>::value,
                "The kernel of a parametric surface must have 'double' as its number type FT.");

  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;

  Point_3 point; ///< `S(u,v)`
  Vector_3 du;   ///< `dS/du`
  Vector_3 dv;   ///< `dS/dv`
  Vector_3 duu;  ///< `d^2S/du^2`
  Vector_3 duv;  ///< `d^2S/(du dv)`
  Vector_3 dvv;  ///< `d^2S/dv^2`
};

} // namespace CGAL

#endif // CGAL_SURFACE_JET_3_H
