// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_HAS_FINITE_COORDINATES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_HAS_FINITE_COORDINATES_H

#include <CGAL/number_utils.h>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

template <class Point_3>
bool has_finite_coordinates(const Point_3& p)
{
  return is_finite(p.x()) && is_finite(p.y()) && is_finite(p.z());
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_HAS_FINITE_COORDINATES_H
