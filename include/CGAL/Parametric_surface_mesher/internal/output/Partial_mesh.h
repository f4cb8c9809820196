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

// One part of an `Indexed_mesh`: the triangles of a patch or of a part of it, with the points that no other part has. Side
// `3 f + k` runs from corner `k` of triangle `f` to the next corner. Indices have 32 bits, as those of `Surface_mesh`, because
// they take most of the memory.
template <class Kernel>
struct Partial_mesh
{
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef std::uint32_t Index;

  // In `faces`, before the part has its place in the mesh: points of cuts, which the parts of its patch share, have indices from
  // the first number on, those of its own from the second on. Smaller indices are those of points of the division.
  static constexpr Index first_cut_point = Index(1) << 30, first_own_point = Index(1) << 31;

  std::size_t patch = 0;
  std::vector<Point_3> points;
  std::vector<Point_2> domain_points;                // those of the points, if kept
  std::vector<std::array<Index, 3>> faces;           // indices below are those of points that parts share
  std::vector<std::array<Index, 3>> halfedges;       // by side; edge `e` has halfedges `2 e` and `2 e + 1`
  std::vector<Index> border;                         // sides that other parts may share; they have no halfedge yet
  std::size_t number_of_edges = 0;                   // edges without a side in `border`
  std::vector<std::array<Point_2, 3>> corner_points; // in the domain of the patch, if kept

  std::size_t place_of_cuts = 0, first_point = 0, first_face = 0, first_edge = 0; // its place in the mesh

  Index source(std::size_t side) const { return faces[side / 3][side % 3]; }
  Index target(std::size_t side) const { return faces[side / 3][(side % 3 + 1) % 3]; }
  Index halfedge(std::size_t side) const { return halfedges[side / 3][side % 3]; }

  // Gives points of the division other indices. `indices`: the new ones, by the present ones
  template <class Indices>
  void renumber_division(const Indices& indices)
  {
    for(auto& face : faces)
      for(Index& v : face)
        if(v < first_cut_point)
          v = Index(indices.at(v));
  }

  // Reverses all faces.
  void reverse()
  {
    for(auto& face : faces)
      std::swap(face[1], face[2]);
    for(auto& corners : corner_points)
      std::swap(corners[1], corners[2]);
    // in a reversed face the first and the last side change places
    for(auto& sides : halfedges)
      std::swap(sides[0], sides[2]);
    for(Index& side : border)
      side = 3 * (side / 3) + 2 - side % 3;
  }

  // Changes indices of own points and halfedges to those in the mesh.
  void take_place()
  {
    for(auto& face : faces)
      for(Index& v : face)
        if(v >= first_own_point)
          v = Index(v - first_own_point + first_point);
        else if(v >= first_cut_point)
          v = Index(v - first_cut_point + place_of_cuts);
    for(auto& sides : halfedges)
      for(Index& halfedge : sides)
        halfedge = Index(halfedge + 2 * first_edge);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_PARTIAL_MESH_H
