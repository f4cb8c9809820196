// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_TRIANGLES_BY_BOUNDARY_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_TRIANGLES_BY_BOUNDARY_H

#include <CGAL/Parametric_surface_mesher/internal/sizing/regular_tensor.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The area of the domain that a loop encloses.
template <class Kernel>
double area_inside(const std::vector<Boundary_vertex<Kernel>>& loop)
{
  double sum = 0;
  for(std::size_t i = 0; i < loop.size(); ++i) {
    const auto p = loop[i].domain_point - loop[0].domain_point,
               q = loop[(i + 1) % loop.size()].domain_point - loop[0].domain_point;
    sum += p.x() * q.y() - p.y() * q.x();
  }
  return 0.5 * std::fabs(sum);
}

// The number of equilateral triangles that a patch has room for if those inside have the size of those at its boundary. Area and
// size are means over the boundary vertices. This is usually an overestimate, as vertices are dense where triangles are small.
template <class Oracle>
double number_of_triangles_by_boundary(const Oracle& oracle, const Boundary_loops<typename Oracle::Geom_traits>& loops)
{
  double area = 0, area_ratio = 0, density = 0;
  std::size_t n = 0;
  for(const auto& loop : loops) {
    area += n == 0 ? area_inside(loop) : -area_inside(loop);
    n += loop.size();
    for(std::size_t i = 0; i < loop.size(); ++i) {
      const auto& uv = loop[i].domain_point;
      area_ratio += std::sqrt(std::fabs(tensor_of_field(oracle, uv, oracle.surface().jet(uv.x(), uv.y())).determinant()));
      density += 1 / squared_distance(loop[i].surface_point, loop[(i + 1) % loop.size()].surface_point);
    }
  }
  const double area_of_equilateral = std::sqrt(3.) / 4;
  return area * (area_ratio / double(n)) * (density / double(n)) / area_of_equilateral;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_TRIANGLES_BY_BOUNDARY_H
