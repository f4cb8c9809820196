// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_IS_TURNED_BY_DIVISION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_IS_TURNED_BY_DIVISION_H

#include <CGAL/Parametric_surface_mesher/internal/sizing/Boundary_size.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>

#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Whether the divided outer loop of a face runs around it in the other direction than its curves do. The curves of a face that is
// narrower than their tolerance may cross each other; its triangles are turned then, to fit those of its neighbours.
template <class Face, class Kernel>
bool is_turned_by_division(const Face& face, const Boundary_loops<Kernel>& loops)
{
  double area_of_curves = 0, area_of_polygon = 0;
  for(const auto& use : face.loops.front())
    area_of_curves += (use.is_reversed ? -1 : 1) * double_area_seen_from(face.loops.front().front().curve.source(), use.curve);
  const auto& polygon = loops.front();
  const auto origin = polygon.front().domain_point;
  for(std::size_t i = 0; i + 1 < polygon.size(); ++i) {
    const auto p = polygon[i].domain_point - origin, q = polygon[i + 1].domain_point - origin;
    area_of_polygon += p.x() * q.y() - p.y() * q.x();
  }
  return (area_of_curves > 0) != (area_of_polygon > 0);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_IS_TURNED_BY_DIVISION_H
