// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_SPLIT_AT_CREASES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_SPLIT_AT_CREASES_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/B_spline_surface_3.h>
#include <CGAL/Rectangular_patch_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {

namespace internal {

// `min`, the knots between `min` and `max` where a spline is only continuous, `max`.
inline std::vector<double> smooth_intervals(const std::vector<double>& knots, int degree, double min, double max)
{
  std::vector<double> result(1, min);
  for(auto knot = std::upper_bound(knots.begin(), knots.end(), min); knot != knots.end() && *knot < max;) {
    const auto next = std::upper_bound(knot, knots.end(), *knot);
    if(next - knot >= degree)
      result.push_back(*knot);
    knot = next;
  }
  result.push_back(max);
  return result;
}

} // namespace internal

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

splits a B-spline surface where it need not have a tangent plane: along the knots whose multiplicity is the degree, or
more. The pieces go row by row, first those with the smallest `v`. A surface without such knots is one piece.

With `make_model_of_rectangular_patches()` the creases become edges of a model, and so edges of the mesh. Inside a
patch a crease would be meshed by ever smaller triangles, down to the minimum edge length.

Knots of lower multiplicity, where only higher derivatives jump, need no splitting.
*/
template <class Kernel>
std::vector<Rectangular_patch_3<B_spline_surface_3<Kernel>>> split_at_creases(const B_spline_surface_3<Kernel>& surface)
{
  using internal::smooth_intervals;
  const auto u = smooth_intervals(surface.knots_u(), surface.degree_u(), surface.u_min(), surface.u_max()),
             v = smooth_intervals(surface.knots_v(), surface.degree_v(), surface.v_min(), surface.v_max());
  std::vector<Rectangular_patch_3<B_spline_surface_3<Kernel>>> result;
  for(std::size_t j = 0; j + 1 < v.size(); ++j)
    for(std::size_t i = 0; i + 1 < u.size(); ++i)
      result.emplace_back(surface, u[i], u[i + 1], v[j], v[j + 1]);
  return result;
}

} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_SPLIT_AT_CREASES_H
