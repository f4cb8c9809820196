// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_PARTIAL_MESH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_PARTIAL_MESH_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The triangles of a patch, or of a part of one, with the points that no other part has. Side `3 f + k` runs from corner `k`
// of triangle `f` to the next one. Indices have 32 bits, as those of `Surface_mesh`: they take most of the memory.
template <class Kernel>
struct Partial_mesh
{
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef std::uint32_t Index;

  static const Index first_own_point = Index(1) << 31; // in `faces`, before the part has its place in the mesh

  std::size_t patch = 0;
  std::vector<Point_3> points;
  std::vector<Point_2> domain_points;                // of the points, if kept
  std::vector<std::array<Index, 3>> faces;           // smaller indices are those of points that parts share
  std::vector<std::array<Index, 3>> halfedges;       // of the sides; edge `e` has halfedges `2 e` and `2 e + 1`
  std::vector<Index> border;                         // sides that other parts may have, too: without halfedges yet
  std::size_t number_of_edges = 0;                   // others than these
  std::vector<std::array<Point_2, 3>> corner_points; // of the faces, in the domain of the patch, if kept

  std::size_t first_point = 0, first_face = 0, first_edge = 0; // in the mesh

  Index source(std::size_t side) const { return faces[side / 3][side % 3]; }
  Index target(std::size_t side) const { return faces[side / 3][(side % 3 + 1) % 3]; }
  Index halfedge(std::size_t side) const { return halfedges[side / 3][side % 3]; }

  // turns all faces to the other side
  void reverse()
  {
    for(auto& face : faces)
      std::swap(face[1], face[2]);
    for(auto& corners : corner_points)
      std::swap(corners[1], corners[2]);
    // of a face that is turned, the first side and the last one change their places
    for(auto& sides : halfedges)
      std::swap(sides[0], sides[2]);
    for(Index& side : border)
      side = 3 * (side / 3) + 2 - side % 3;
  }

  // makes indices of points and halfedges those in the mesh
  void take_place()
  {
    for(auto& face : faces)
      for(Index& v : face)
        if(v >= first_own_point)
          v = Index(v - first_own_point + first_point);
    for(auto& sides : halfedges)
      for(Index& halfedge : sides)
        halfedge = Index(halfedge + 2 * first_edge);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_PARTIAL_MESH_H
