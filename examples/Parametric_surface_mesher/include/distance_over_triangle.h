// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The points of a surface over a triangle of its mesh, and how far they are from that mesh.
#ifndef DISTANCE_OVER_TRIANGLE_H
#define DISTANCE_OVER_TRIANGLE_H

#include "Aabb_tree_types.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace mesh_patch {

// The corners of a triangle: in space, and in the domain of its face.
struct Triangle_corners
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;

  std::array<Kernel::Point_3, 3> points;
  std::array<Kernel::Point_2, 3> uv;
};

typedef CGAL::Surface_mesh<Triangle_corners::Kernel::Point_3> Triangle_mesh;
typedef Aabb_tree<Triangle_corners::Kernel, CGAL::AABB_face_graph_triangle_primitive<Triangle_mesh>> Triangle_tree;

template <class Halfedge_uv>
Triangle_corners corners_of_triangle(const Triangle_mesh& mesh, const Halfedge_uv& uv, Triangle_mesh::Face_index face)
{
  Triangle_corners result;
  std::size_t i = 0;
  for(const auto h : mesh.halfedges_around_face(mesh.halfedge(face))) {
    result.points[i] = mesh.point(mesh.target(h));
    result.uv[i++] = uv[h];
  }
  return result;
}

// The middles of the sides and the centroid of a triangle, in barycentric coordinates.
inline std::array<std::array<double, 3>, 4> places_in_triangle()
{
  return {{{0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {1. / 3, 1. / 3, 1. / 3}}};
}

inline Triangle_corners::Kernel::Point_2 at(const Triangle_corners& c, const std::array<double, 3>& w)
{
  return {w[0] * c.uv[0].x() + w[1] * c.uv[1].x() + w[2] * c.uv[2].x(), w[0] * c.uv[0].y() + w[1] * c.uv[1].y() + w[2] * c.uv[2].y()};
}

// The squared distance of a point from the mesh; 0 if it is not above `found`. The distance from the triangle that it lies over is
// usually short enough; around poles another triangle may be closer, which takes longer to find.
inline double squared_distance_above(double found, const Triangle_corners::Kernel::Point_3& p,
                                     const Triangle_corners::Kernel::Triangle_3& triangle, const Triangle_tree& tree)
{
  return CGAL::squared_distance(p, triangle) > found ? tree.squared_distance(p) : 0;
}

// The largest squared distance from the mesh of the points of a surface over places of a triangle, if that is above `found`, or `found`.
template <class Surface>
double largest_squared_distance(double found, const Triangle_corners& c, const Surface& surface, const Triangle_tree& tree)
{
  const Triangle_corners::Kernel::Triangle_3 triangle(c.points[0], c.points[1], c.points[2]);
  for(const auto& w : places_in_triangle()) {
    const auto uv = at(c, w);
    found = (std::max)(found, squared_distance_above(found, surface.point(uv.x(), uv.y()), triangle, tree));
  }
  return found;
}

} // namespace mesh_patch

#endif // DISTANCE_OVER_TRIANGLE_H
