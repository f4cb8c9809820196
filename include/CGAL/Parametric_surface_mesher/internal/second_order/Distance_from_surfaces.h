// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_DISTANCE_FROM_SURFACES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_DISTANCE_FROM_SURFACES_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Mesh_in_model.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Quadratic_triangle_3.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Surface_foot.h>
#include <CGAL/Parametric_surface_model_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// How far places of curved triangles are from the surfaces of their faces.
template <class Surface, class Mesh>
class Distance_from_surfaces
{
  typedef typename Surface::Geom_traits Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Mesh::face_descriptor face_descriptor;

  // Of the size of a triangle: within that distance of a place in the domain, the closest point is looked for from there.
  static constexpr double share_for_first_place = 0.1;

  const Parametric_surface_model_3<Surface>& m_model;
  const Mesh& m_mesh;
  unsigned int m_subdivisions;

public:
  // `subdivisions`: the number of pieces of a side
  Distance_from_surfaces(const Parametric_surface_model_3<Surface>& model, const Mesh& mesh, unsigned int subdivisions)
    : m_model(model), m_mesh(mesh), m_subdivisions(subdivisions)
  {}

  // The largest distance from places of a triangle to its surface.
  template <class MidSidePointMap>
  double of_triangle(face_descriptor f, const MidSidePointMap& points) const
  {
    const Surface& surface = m_model.faces()[m_mesh.patch(f)].surface;
    const auto sides = m_mesh.sides(f);
    const Quadratic_triangle_3<Kernel> triangle({m_mesh.source_point(sides[0]), m_mesh.source_point(sides[1]), m_mesh.source_point(sides[2]),
                                                 node(sides[0], points), node(sides[1], points), node(sides[2], points)});
    const std::array<Point_2, 3> uv = {m_mesh.source_uv(sides[0]), m_mesh.source_uv(sides[1]), m_mesh.source_uv(sides[2])};
    const double size = std::sqrt((std::max)({squared_distance(triangle.nodes()[0], triangle.nodes()[1]),
                                              squared_distance(triangle.nodes()[1], triangle.nodes()[2]),
                                              squared_distance(triangle.nodes()[2], triangle.nodes()[0])}));
    double result = 0;
    for(unsigned int i = 0; i <= m_subdivisions; ++i)
      for(unsigned int k = 0; i + k <= m_subdivisions; ++k) {
        const double a = double(i) / m_subdivisions, b = double(k) / m_subdivisions, c = double(m_subdivisions - i - k) / m_subdivisions;
        result = (std::max)(result, distance(surface, triangle.point(a, b, c), places(uv, a, b, c), size));
      }
    return result;
  }

private:
  template <class MidSidePointMap>
  Point_3 node(typename Mesh::halfedge_descriptor h, const MidSidePointMap& points) const
  {
    return get(points, edge(h, m_mesh.mesh));
  }

  // Where to look: at the same place of the triangle in the domain, and, since this is far off around a pole, with a parameter of one of
  // the corners.
  static std::vector<Point_2> places(const std::array<Point_2, 3>& uv, double a, double b, double c)
  {
    const double u = a * uv[0].x() + b * uv[1].x() + c * uv[2].x(), v = a * uv[0].y() + b * uv[1].y() + c * uv[2].y();
    return {Point_2(u, v),         Point_2(uv[0].x(), v), Point_2(uv[1].x(), v), Point_2(uv[2].x(), v),
            Point_2(u, uv[0].y()), Point_2(u, uv[1].y()), Point_2(u, uv[2].y())};
  }

  // The distance of a point from the closest point of a surface that was found. It is never less than the true one, and infinite where
  // the surface cannot be evaluated.
  static double distance(const Surface& surface, const Point_3& p, const std::vector<Point_2>& places, double size)
  {
    double squared = std::numeric_limits<double>::infinity();
    const auto look_at = [&](const Point_2& uv) { squared = (std::min)(squared, squared_distance(p, surface.point(uv.x(), uv.y()))); };
    try {
      look_at(places.front());
      find_near(surface, p, places, share_for_first_place * size, [&](const Point_2& start) {
        const auto foot = find_on_surface(surface, start, p, size, Tangent_directions());
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

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_DISTANCE_FROM_SURFACES_H
