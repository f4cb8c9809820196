// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_TRIANGLE_COMPLEX_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_TRIANGLE_COMPLEX_H

#include <CGAL/Parametric_surface_mesher/internal/curing/Displacement.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Some triangles of a mesh, with those around each vertex. Any number of them may meet in an edge: triangles belong to shells,
// and it is in each shell that they make a surface. They are changed by replacing some by others.
template <class Kernel>
class Triangle_complex
{
public:
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef std::size_t Index;

  static constexpr Index none = Index(-1);

  struct Vertex
  {
    Point_3 point;
    int dimension;     // of what it lies on: 0 for a vertex of the model, 1 for an edge, 2 for a face
    Index entity;      // the index of that vertex or edge
    bool is_fixed;     // whether it has triangles that are not here
    Displacement displacement = {}; // of the points of the mesh, as it was, that are here now
    std::vector<Index> triangles = {};
  };

  struct Triangle
  {
    std::array<Index, 3> vertices;
    std::array<Point_2, 3> uv; // the corners in the domain of the patch
    Index patch;
    std::array<Index, 2> shells; // the one that it is the outside of, and one that it is the inside of, or none
    Index part;                // the part of the mesh that it belongs to
    Index replaced = none;     // the triangle whose place it has taken, alone or with others
    bool is_removed = false;

    std::size_t corner(Index v) const { return std::size_t(std::find(vertices.begin(), vertices.end(), v) - vertices.begin()); }
    bool has(Index v) const { return corner(v) < 3; }
    // The third vertex beside two of them.
    Index apex(Index v, Index w) const
    {
      return *std::find_if(vertices.begin(), vertices.end(), [=](Index x) { return x != v && x != w; });
    }

    bool is_in(Index shell) const { return shell != none && (shell == shells[0] || shell == shells[1]); }
    bool is_in_shell_of(const Triangle& other) const { return is_in(other.shells[0]) || is_in(other.shells[1]); }
  };

  // What takes the place of some triangles.
  struct Change
  {
    std::vector<Index> removed;
    std::vector<Triangle> added;
    Index survivor;      // the vertex that others move to; of a flip, an end of the new edge
    int dimension;       // of the survivor afterwards
    bool removes_detail; // whether edges or vertices of the model are joined
    std::vector<std::pair<Index, Displacement>> displacements; // of vertices that others have moved to, afterwards
  };

  // The neighbours of a vertex in a shell, with the number of triangles at the edge to each.
  typedef std::map<Index, int> Neighbors;

private:
  std::vector<Vertex> m_vertices;
  std::vector<Triangle> m_triangles;

public:
  Index add_vertex(const Vertex& vertex)
  {
    m_vertices.push_back(vertex);
    return m_vertices.size() - 1;
  }

  Index add_triangle(const Triangle& triangle)
  {
    const Index t = m_triangles.size();
    m_triangles.push_back(triangle);
    for(Index v : triangle.vertices)
      m_vertices[v].triangles.push_back(t);
    return t;
  }

  const std::vector<Vertex>& vertices() const { return m_vertices; }
  const std::vector<Triangle>& triangles() const { return m_triangles; }
  const Vertex& vertex(Index v) const { return m_vertices[v]; }
  const Triangle& triangle(Index t) const { return m_triangles[t]; }
  const Point_3& point(Index t, std::size_t corner) const { return m_vertices[m_triangles[t].vertices[corner % 3]].point; }

  // The triangles at an edge.
  std::vector<Index> triangles_at(Index v, Index w) const
  {
    std::vector<Index> result;
    for(Index t : m_vertices[v].triangles)
      if(m_triangles[t].has(w))
        result.push_back(t);
    return result;
  }

  std::vector<Index> shells_at(Index v) const
  {
    std::vector<Index> result;
    for(Index t : m_vertices[v].triangles)
      for(Index shell : m_triangles[t].shells)
        if(shell != none)
          result.push_back(shell);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  Neighbors neighbors(Index v, Index shell) const
  {
    Neighbors result;
    for(Index t : m_vertices[v].triangles)
      if(m_triangles[t].is_in(shell))
        for(Index w : m_triangles[t].vertices)
          if(w != v)
            ++result[w];
    return result;
  }

  // Whether the side of a triangle from this corner to the next one is on the border of its patch.
  bool is_on_patch_border(Index t, std::size_t corner) const
  {
    const Triangle& triangle = m_triangles[t];
    std::size_t number = 0;
    for(Index other : m_vertices[triangle.vertices[corner]].triangles)
      if(other != t && m_triangles[other].is_in_shell_of(triangle) && m_triangles[other].has(triangle.vertices[(corner + 1) % 3])) {
        if(m_triangles[other].patch != triangle.patch)
          return true;
        ++number;
      }
    return number != 1;
  }

  // The triangle on the other side of the side from this corner to the next one.
  // \pre that is not on the border of the patch
  Index neighbor_in_patch(Index t, std::size_t corner) const
  {
    const Triangle& triangle = m_triangles[t];
    for(Index other : triangles_at(triangle.vertices[corner], triangle.vertices[(corner + 1) % 3]))
      if(other != t && m_triangles[other].is_in_shell_of(triangle))
        return other;
    return t;
  }

  // Applies a change, and returns the one that takes it back if it is the next that is applied.
  Change apply(const Change& change)
  {
    Vertex& survivor = m_vertices[change.survivor];
    Change back = change;
    back.dimension = survivor.dimension;
    survivor.dimension = change.dimension;
    for(auto& displacement : back.displacements)
      std::swap(m_vertices[displacement.first].displacement, displacement.second);
    for(Index t : change.removed)
      detach(t);
    for(const Triangle& triangle : change.added)
      add_triangle(triangle);
    return back;
  }

  void take_back(const Change& back)
  {
    for(std::size_t i = 0; i < back.added.size(); ++i) {
      detach(m_triangles.size() - 1);
      m_triangles.pop_back();
    }
    for(Index t : back.removed) {
      m_triangles[t].is_removed = false;
      for(Index v : m_triangles[t].vertices)
        m_vertices[v].triangles.push_back(t);
    }
    m_vertices[back.survivor].dimension = back.dimension;
    for(const auto& displacement : back.displacements)
      m_vertices[displacement.first].displacement = displacement.second;
    for(Index t : back.removed) // lists in ascending order make results independent of changes that were taken back
      for(Index v : m_triangles[t].vertices)
        std::sort(m_vertices[v].triangles.begin(), m_vertices[v].triangles.end());
  }

private:
  void detach(Index t)
  {
    m_triangles[t].is_removed = true;
    for(Index v : m_triangles[t].vertices) {
      auto& triangles = m_vertices[v].triangles;
      triangles.erase(std::find(triangles.begin(), triangles.end(), t));
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_TRIANGLE_COMPLEX_H
