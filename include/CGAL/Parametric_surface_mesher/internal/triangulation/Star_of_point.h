// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_STAR_OF_POINT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_STAR_OF_POINT_H

#include <CGAL/enum.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The boundary edges of the star that a point would get if it were inserted: the star consists of the faces whose circumellipse
// contains the point, as far as they can be reached from the face that contains it without crossing a constraint.
// (CGAL's get_conflicts_and_boundary() does not bound their number.)
template <class Triangulation>
class Star_of_point
{
public:
  typedef typename Triangulation::Face_handle Face_handle;
  typedef std::pair<Face_handle, int> Edge; // a face of the star, and the index of its edge

private:
  // Where the metric varies the conflict region need not be a disc. True stars have some ten edges.
  static constexpr std::size_t default_max_number_of_edges = 200;

  const Triangulation& m_triangulation;
  const std::size_t m_max_number_of_edges;
  std::vector<Edge> m_boundary, m_stack;
  bool m_is_cut_short = false;

public:
  explicit Star_of_point(const Triangulation& triangulation, std::size_t max_number_of_edges = default_max_number_of_edges)
    : m_triangulation(triangulation), m_max_number_of_edges(max_number_of_edges)
  {}

  template <class Point>
  const std::vector<Edge>& compute(const Point& p, Face_handle face)
  {
    m_boundary.clear();
    m_stack.clear();
    m_is_cut_short = false;
    push_edges(face, -1);
    while(!m_stack.empty()) {
      const Edge edge = m_stack.back();
      m_stack.pop_back();
      if(is_in_star(p, edge))
        push_edges(edge.first->neighbor(edge.second), m_triangulation.mirror_index(edge.first, edge.second));
      else
        m_boundary.push_back(edge);
    }
    return m_boundary;
  }

  // The edges of the star that was computed last.
  const std::vector<Edge>& boundary() const { return m_boundary; }

  // Whether that star has too many edges to be computed to the end.
  bool is_cut_short() const { return m_is_cut_short; }

private:
  // Pushes the edges of a face other than `entry` (all three if that is -1), so that the next one counterclockwise is on top.
  void push_edges(Face_handle face, int entry)
  {
    if(entry < 0) {
      for(int i : {2, 1, 0})
        m_stack.emplace_back(face, i);
      return;
    }
    m_stack.emplace_back(face, (entry + 2) % 3);
    m_stack.emplace_back(face, (entry + 1) % 3);
  }

  template <class Point>
  bool is_in_star(const Point& p, const Edge& edge)
  {
    const Face_handle face = edge.first, neighbor = face->neighbor(edge.second);
    if(face->is_constrained(edge.second))
      return false;
    if(m_boundary.size() + m_stack.size() > m_max_number_of_edges) {
      m_is_cut_short = true;
      return false;
    }
    return m_triangulation.geom_traits().side_of_oriented_circle_2_object()(
             neighbor->vertex(0)->point(), neighbor->vertex(1)->point(), neighbor->vertex(2)->point(), p)
           == ON_POSITIVE_SIDE;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_STAR_OF_POINT_H
