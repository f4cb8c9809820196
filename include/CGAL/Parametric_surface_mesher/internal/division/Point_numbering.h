// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_POINT_NUMBERING_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_POINT_NUMBERING_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The indices in the mesh of the points of a division: of vertices of the model, and of the inner points of its edges, which
// are consecutive along an edge.
class Point_numbering
{
  static constexpr std::size_t none = std::size_t(-1);

  std::vector<std::size_t> m_vertices;           // by vertex of the model
  std::vector<std::size_t> m_first_inner_points; // by edge
  std::size_t m_number_of_points = 0;

public:
  Point_numbering(std::size_t number_of_vertices, std::size_t number_of_edges)
    : m_vertices(number_of_vertices, std::size_t(none)), m_first_inner_points(number_of_edges)
  {}

  void clear()
  {
    std::fill(m_vertices.begin(), m_vertices.end(), std::size_t(none));
    m_number_of_points = 0;
  }

  // Gives the next index to a vertex that has none.
  void add_vertex(std::size_t vertex)
  {
    if(!has_vertex(vertex))
      m_vertices[vertex] = m_number_of_points++;
  }

  // Gives the next indices to the inner points of an edge.
  void add_inner_points(std::size_t edge, std::size_t number)
  {
    m_first_inner_points[edge] = m_number_of_points;
    m_number_of_points += number;
  }

  std::size_t number_of_points() const { return m_number_of_points; }

  bool has_vertex(std::size_t vertex) const { return m_vertices[vertex] != none; }

  // \pre it has an index
  std::size_t vertex(std::size_t vertex) const { return m_vertices[vertex]; }

  // The index of an inner point of an edge. `number`: 0 for the one after the first point of the edge, and so on
  std::size_t inner_point(std::size_t edge, std::size_t number) const { return m_first_inner_points[edge] + number; }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_POINT_NUMBERING_H
