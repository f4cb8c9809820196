// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_DISTANCE_FROM_SURFACE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_DISTANCE_FROM_SURFACE_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Quadratic_triangle_3.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Surface_foot.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// How far places of curved triangles are from a surface.
template <class Surface>
class Distance_from_surface
{
  typedef typename Surface::Geom_traits Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;

  // Of the size of a triangle: within that distance of a place in the domain, the closest point is looked for from there.
  static constexpr double share_for_first_place = 0.1;

  const Surface& m_surface;
  unsigned int m_subdivisions;

public:
  // `subdivisions`: the number of pieces of a side
  Distance_from_surface(const Surface& surface, unsigned int subdivisions) : m_surface(surface), m_subdivisions(subdivisions) {}

  // The largest distance from places of a triangle. `uv`: the parameters of its corners
  double operator()(const Quadratic_triangle_3<Kernel>& triangle, const std::array<Point_2, 3>& uv) const
  {
    const auto& p = triangle.nodes();
    const double size
      = std::sqrt((std::max)({squared_distance(p[0], p[1]), squared_distance(p[1], p[2]), squared_distance(p[2], p[0])}));
    double result = 0;
    for(unsigned int i = 0; i <= m_subdivisions; ++i)
      for(unsigned int k = 0; i + k <= m_subdivisions; ++k) {
        const double a = double(i) / m_subdivisions, b = double(k) / m_subdivisions, c = double(m_subdivisions - i - k) / m_subdivisions;
        result = (std::max)(result, distance(triangle.point(a, b, c), places(uv, a, b, c), size));
      }
    return result;
  }

private:
  // Where to look: at the same place of the triangle in the domain, and, since this is far off around a pole, with a parameter of one of
  // the corners.
  static std::vector<Point_2> places(const std::array<Point_2, 3>& uv, double a, double b, double c)
  {
    const double u = a * uv[0].x() + b * uv[1].x() + c * uv[2].x(), v = a * uv[0].y() + b * uv[1].y() + c * uv[2].y();
    return {Point_2(u, v),         Point_2(uv[0].x(), v), Point_2(uv[1].x(), v), Point_2(uv[2].x(), v),
            Point_2(u, uv[0].y()), Point_2(u, uv[1].y()), Point_2(u, uv[2].y())};
  }

  // The distance of a point from the closest point of the surface that was found. It is never less than the true one, and infinite where
  // the surface cannot be evaluated.
  double distance(const Point_3& p, const std::vector<Point_2>& places, double size) const
  {
    double squared = std::numeric_limits<double>::infinity();
    const auto look_at = [&](const Point_2& uv) { squared = (std::min)(squared, squared_distance(p, m_surface.point(uv.x(), uv.y()))); };
    try {
      look_at(places.front());
      find_near(m_surface, p, places, share_for_first_place * size, [&](const Point_2& start) {
        const auto foot = find_on_surface(m_surface, start, p, size, Tangent_directions());
        look_at(foot ? *foot : start);
        return foot && squared <= square(share_for_first_place * size);
      });
    }
    catch(const Parametric_surface_mesh_error&) {
    }
    return std::sqrt(squared);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_DISTANCE_FROM_SURFACE_H
