// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_GROUP_POINTS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_GROUP_POINTS_H

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// For each point the number of one that stands for all those within the tolerance. A sweep along x: `O(n log n)` if few points have
// the same x.
template <class Point>
std::vector<std::size_t> group_points(const std::vector<Point>& points, double tolerance)
{
  std::vector<std::size_t> order(points.size()), result(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::make_pair(points[a].x(), a) < std::make_pair(points[b].x(), b);
  });
  for(std::size_t i = 0; i < order.size(); ++i) {
    const Point& p = points[order[i]];
    result[order[i]] = order[i];
    for(std::size_t k = i; k-- > 0 && p.x() - points[order[k]].x() <= tolerance;)
      if(squared_distance(p, points[order[k]]) <= tolerance * tolerance) {
        result[order[i]] = result[order[k]];
        break;
      }
  }
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_GROUP_POINTS_H
