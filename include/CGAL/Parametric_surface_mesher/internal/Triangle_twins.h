// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGLE_TWINS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGLE_TWINS_H

#include <CGAL/Parametric_surface_mesh_error.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Which sides of indexed triangles are opposite to each other. Side `3 f + k` runs from corner `k` of triangle `f` to the
// next one.
class Triangle_twins
{
  typedef std::vector<std::array<std::size_t, 3>> Triangles;

  struct Entry
  {
    std::size_t larger_vertex, side;
    bool is_ascending; // whether the side runs to its larger vertex
  };

  const Triangles& m_triangles;
  std::vector<std::size_t> m_twins;

public:
  static const std::size_t none = std::size_t(-1);

  // Sides are sorted into buckets by their smaller vertex: linear time.
  // throws Parametric_surface_mesh_error if two triangles run through an edge in the same direction
  Triangle_twins(const Triangles& triangles, std::size_t number_of_vertices)
    : m_triangles(triangles), m_twins(3 * triangles.size(), std::size_t(-1))
  {
    std::vector<std::size_t> starts(number_of_vertices + 1, 0);
    for(std::size_t side = 0; side < m_twins.size(); ++side)
      ++starts[(std::min)(source(side), target(side)) + 1];
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      starts[v + 1] += starts[v];
    std::vector<std::size_t> ends(starts.begin(), starts.end() - 1);
    std::vector<Entry> entries(m_twins.size());
    for(std::size_t side = 0; side < m_twins.size(); ++side) {
      const std::size_t v = source(side), w = target(side), bucket = (std::min)(v, w);
      const Entry entry{(std::max)(v, w), side, v < w};
      for(std::size_t i = starts[bucket]; i < ends[bucket]; ++i)
        if(entries[i].larger_vertex == entry.larger_vertex)
          match(entry, entries[i]);
      entries[ends[bucket]++] = entry;
    }
  }

  // the side opposite to `side`, or `none` on the border
  std::size_t twin(std::size_t side) const { return m_twins[side]; }

  std::size_t source(std::size_t side) const { return m_triangles[side / 3][side % 3]; }
  std::size_t target(std::size_t side) const { return m_triangles[side / 3][(side % 3 + 1) % 3]; }

private:
  void match(const Entry& a, const Entry& b)
  {
    if(a.is_ascending == b.is_ascending)
      throw Parametric_surface_mesh_error("the mesh is not manifold: triangles " + std::to_string(b.side / 3) + " and "
                                          + std::to_string(a.side / 3) + " have the same edge in the same direction");
    m_twins[a.side] = b.side;
    m_twins[b.side] = a.side;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGLE_TWINS_H
