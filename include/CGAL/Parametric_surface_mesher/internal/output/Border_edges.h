// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_BORDER_EDGES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_BORDER_EDGES_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Joins the parts of a mesh by finding the sides on their borders that are opposite to each other. The edges between parts come
// after those inside parts.
template <class Kernel>
class Border_edges
{
  typedef Indexed_mesh<Kernel> Mesh;
  typedef typename Mesh::Part Part;

public:
  // A side of a triangle on the border of a part.
  struct Side
  {
    std::uint32_t smaller_vertex, larger_vertex, part, side;
    bool is_alone; // whether it is on the border of the mesh

    bool has_vertices_of(const Side& other) const
    {
      return smaller_vertex == other.smaller_vertex && larger_vertex == other.larger_vertex;
    }

    bool operator<(const Side& other) const
    {
      return std::tie(smaller_vertex, larger_vertex, part, side)
             < std::tie(other.smaller_vertex, other.larger_vertex, other.part, other.side);
    }
  };

private:
  Mesh& m_mesh;
  std::vector<Side> m_sides; // in ascending order
  std::size_t m_number_of_edges;

public:
  // Gives the sides their halfedges, in O(n log n) time for n sides.
  // \throws Parametric_surface_mesh_error if two sides run through an edge in the same direction, or an edge has three sides
  explicit Border_edges(Mesh& mesh) : m_mesh(mesh), m_number_of_edges(mesh.number_of_inner_edges())
  {
    for(std::size_t p = 0; p < mesh.parts.size(); ++p)
      for(const auto side : mesh.parts[p].border) {
        const auto v = mesh.parts[p].source(side), w = mesh.parts[p].target(side);
        m_sides.push_back({(std::min)(v, w), (std::max)(v, w), std::uint32_t(p), side, true});
      }
    std::sort(m_sides.begin(), m_sides.end());
    for(std::size_t i = 0; i < m_sides.size(); ++i)
      if(i > 0 && m_sides[i].has_vertices_of(m_sides[i - 1]))
        join(m_sides[i - 1], m_sides[i]);
      else
        set_halfedge(m_sides[i], 2 * m_number_of_edges++);
  }

  std::size_t number_of_edges() const { return m_number_of_edges; } // those of the whole mesh

  const std::vector<Side>& sides() const { return m_sides; }

private:
  void join(Side& a, Side& b)
  {
    if((source(a) < target(a)) == (source(b) < target(b)))
      throw Parametric_surface_mesh_error("the mesh is not manifold: " + name_of_triangle(a) + " and "
                                          + name_of_triangle(b) + " have the same edge in the same direction");
    if(!a.is_alone)
      throw Parametric_surface_mesh_error("the mesh is not manifold: an edge of " + name_of_triangle(b)
                                          + " is an edge of two others");
    a.is_alone = b.is_alone = false;
    set_halfedge(b, 2 * (m_number_of_edges - 1) + 1);
  }

  void set_halfedge(const Side& side, std::size_t halfedge)
  {
    m_mesh.parts[side.part].halfedges[side.side / 3][side.side % 3] = typename Part::Index(halfedge);
  }

  std::size_t source(const Side& side) const { return m_mesh.parts[side.part].source(side.side); }
  std::size_t target(const Side& side) const { return m_mesh.parts[side.part].target(side.side); }

  std::string name_of_triangle(const Side& side) const
  {
    return numbered("triangle", m_mesh.parts[side.part].first_face + side.side / 3);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_BORDER_EDGES_H
