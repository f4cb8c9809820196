// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_GROUP_POINTS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_GROUP_POINTS_H

#include <CGAL/Point_2.h>
#include <CGAL/Point_3.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The coordinate along a direction that is skew to the axes, where corners of patches often have equal coordinates.
template <class Kernel>
double skew_coordinate(const CGAL::Point_2<Kernel>& p) { return 0.74 * p.x() + 0.67 * p.y(); }

template <class Kernel>
double skew_coordinate(const CGAL::Point_3<Kernel>& p) { return 0.64 * p.x() + 0.59 * p.y() + 0.49 * p.z(); }

// For each point the number of one that stands for all those within the tolerance. A sweep: `O(n log n)` if few points are
// close in its direction.
template <class Point>
std::vector<std::size_t> group_points(const std::vector<Point>& points, double tolerance)
{
  std::vector<std::size_t> order(points.size()), result(points.size());
  std::vector<double> coordinates;
  for(const Point& p : points)
    coordinates.push_back(skew_coordinate(p));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::make_pair(coordinates[a], a) < std::make_pair(coordinates[b], b);
  });
  for(std::size_t i = 0; i < order.size(); ++i) {
    result[order[i]] = order[i];
    for(std::size_t k = i; k-- > 0 && coordinates[order[i]] - coordinates[order[k]] <= tolerance;)
      if(squared_distance(points[order[i]], points[order[k]]) <= tolerance * tolerance) {
        result[order[i]] = result[order[k]];
        break;
      }
  }
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_GROUP_POINTS_H
