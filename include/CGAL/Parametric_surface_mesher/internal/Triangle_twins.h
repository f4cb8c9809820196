// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGLE_TWINS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGLE_TWINS_H

#include <CGAL/Parametric_surface_mesh_error.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Which sides of indexed triangles are opposite to each other. Side `3 f + k` runs from corner `k` of triangle `f` to the
// next one.
class Triangle_twins
{
  typedef std::vector<std::array<std::size_t, 3>> Triangles;

  // a side without a known twin, with its vertices in ascending order
  struct Entry
  {
    std::size_t smaller_vertex, larger_vertex, side;
    bool is_ascending; // whether the side runs to its larger vertex

    bool has_vertices_of(const Entry& other) const
    {
      return smaller_vertex == other.smaller_vertex && larger_vertex == other.larger_vertex;
    }

    bool operator<(const Entry& other) const
    {
      return std::tie(smaller_vertex, larger_vertex, side) < std::tie(other.smaller_vertex, other.larger_vertex, other.side);
    }
  };

  const Triangles& m_triangles;
  std::vector<std::size_t> m_twins;

public:
  static const std::size_t none = std::size_t(-1);

  // `twins`: of the sides, `none` where they are not known. To find those takes `n log n` for `n` sides.
  // throws Parametric_surface_mesh_error if two of these run through an edge in the same direction
  Triangle_twins(const Triangles& triangles, std::vector<std::size_t> twins) : m_triangles(triangles), m_twins(std::move(twins))
  {
    m_twins.resize(3 * triangles.size(), std::size_t(none));
    std::vector<Entry> entries;
    for(std::size_t side = 0; side < m_twins.size(); ++side)
      if(m_twins[side] == none) {
        const std::size_t v = source(side), w = target(side);
        entries.push_back({(std::min)(v, w), (std::max)(v, w), side, v < w});
      }
    std::sort(entries.begin(), entries.end());
    for(std::size_t i = 1; i < entries.size(); ++i)
      if(entries[i].has_vertices_of(entries[i - 1]))
        match(entries[i], entries[i - 1]);
  }

  // the side opposite to `side`, or `none` on the border
  std::size_t twin(std::size_t side) const { return m_twins[side]; }

  // of the triangles, counting two opposite sides as one
  std::size_t number_of_edges() const
  {
    const std::size_t on_border = std::size_t(std::count(m_twins.begin(), m_twins.end(), std::size_t(none)));
    return (m_twins.size() + on_border) / 2;
  }

  std::size_t source(std::size_t side) const { return m_triangles[side / 3][side % 3]; }
  std::size_t target(std::size_t side) const { return m_triangles[side / 3][(side % 3 + 1) % 3]; }

private:
  void match(const Entry& a, const Entry& b)
  {
    if(a.is_ascending == b.is_ascending)
      throw Parametric_surface_mesh_error("the mesh is not manifold: triangles " + std::to_string(b.side / 3) + " and "
                                          + std::to_string(a.side / 3) + " have the same edge in the same direction");
    if(m_twins[b.side] != none)
      throw Parametric_surface_mesh_error("the mesh is not manifold: an edge of triangle " + std::to_string(a.side / 3)
                                          + " is an edge of two others");
    m_twins[a.side] = b.side;
    m_twins[b.side] = a.side;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGLE_TWINS_H
