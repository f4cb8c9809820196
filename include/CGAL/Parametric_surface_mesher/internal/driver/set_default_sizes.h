// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_SET_DEFAULT_SIZES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_SET_DEFAULT_SIZES_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Fills in the sizes that the user left open.
inline void set_default_sizes(Parametric_surface_mesh_criteria& criteria, double diagonal)
{
  if(!(diagonal > 0) || !std::isfinite(diagonal))
    throw Parametric_surface_mesh_error("the surface is degenerate: its boundary is a point in space");
  if(!criteria.sizing().max_edge)
    criteria.set_max_edge(diagonal / 20);
  if(!criteria.sizing().min_edge)
    criteria.set_min_edge((std::min)(criteria.max_edge(), diagonal / 20) / 200);
  if(criteria.min_edge() > criteria.max_edge())
    throw Parametric_surface_mesh_error("the minimum edge length " + describe(criteria.min_edge())
                                        + " is larger than the maximum edge length " + describe(criteria.max_edge()));
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_SET_DEFAULT_SIZES_H
