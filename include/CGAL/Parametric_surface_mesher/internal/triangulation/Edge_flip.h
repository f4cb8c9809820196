// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_EDGE_FLIP_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_EDGE_FLIP_H

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// An edge between two triangles, and the other diagonal of their quadrilateral.
template <class Triangulation>
class Edge_flip
{
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Point Point;
  typedef std::array<double, 3> Squared_lengths;

  Triangulation& m_triangulation;
  Face_handle m_face, m_across;
  std::array<Point, 4> m_points; // the corners of the quadrilateral; the edge is from 1 to 3

public:
  // \pre edge `i` of `face` is not constrained
  Edge_flip(Triangulation& triangulation, Face_handle face, int i)
    : m_triangulation(triangulation), m_face(face), m_across(face->neighbor(i)),
      m_points{face->vertex(i)->point(), face->vertex((i + 1) % 3)->point(), triangulation.mirror_vertex(face, i)->point(),
               face->vertex((i + 2) % 3)->point()}
  {}

  std::array<Face_handle, 2> faces() const { return {m_face, m_across}; }

  // Whether the flip is allowed:
  // - the quadrilateral is strictly convex in the domain, by an exact test;
  // - the new triangles do not stand up from the surface, as they may if three points are nearly on a line in the domain;
  // - no inner vertex is joined to a second copy of a vertex on a seam, since the output would have to split that edge.
  bool is_valid() const
  {
    const auto orientation = m_triangulation.geom_traits().orientation_2_object();
    if(orientation(m_points[0], m_points[1], m_points[2]) != LEFT_TURN
       || orientation(m_points[2], m_points[3], m_points[0]) != LEFT_TURN || stands_up())
      return false;
    const Vertex_handle v = m_face->vertex(m_face->index(m_across)), w = m_across->vertex(m_across->index(m_face));
    return v->is_on_boundary() == w->is_on_boundary()
           || !(v->is_on_boundary() ? has_neighbor_with_index(w, v->index()) : has_neighbor_with_index(v, w->index()));
  }

  // The smaller one of the qualities of the two triangles. `quality` is a function of squared edge lengths.
  template <class MetricField, class Quality>
  double worst_before(const MetricField& metric, const Quality& quality) const
  {
    return (std::min)(quality(squared_lengths(metric, 0, 1, 3)), quality(squared_lengths(metric, 2, 3, 1)));
  }

  // The smaller one of the qualities that the triangles would have after the flip.
  template <class MetricField, class Quality>
  double worst_after(const MetricField& metric, const Quality& quality) const
  {
    return (std::min)(quality(squared_lengths(metric, 0, 1, 2)), quality(squared_lengths(metric, 2, 3, 0)));
  }

  // The quality, after the flip, of the triangle that cuts off the first vertex of the edge.
  template <class MetricField, class Quality>
  double quality_of_ear(const MetricField& metric, const Quality& quality) const
  {
    return quality(squared_lengths(metric, 0, 1, 2));
  }

  void flip()
  {
    turn();
    touch();
  }

  // Each flip turns the two triangles by a quarter turn; three more flips restore both faces.
  void undo()
  {
    for(int k = 0; k < 3; ++k)
      turn();
    touch();
  }

private:
  typedef typename Point::Surface_point_3 Point_3;

  // The squared cosine of 78 degrees. On a fine mesh neighbours enclose a few degrees; larger angles arise from corners that are
  // nearly collinear in the domain.
  static constexpr double squared_cosine_of_standing = 0.04;

  // Whether a new triangle would make an angle of more than 78 degrees with the surface.
  bool stands_up() const
  {
    const auto before = normal(0, 1, 3) + normal(2, 3, 1);
    for(const auto& after : {normal(0, 1, 2), normal(2, 3, 0)}) {
      const double product = before * after;
      if(!(product > 0 && product * product > squared_cosine_of_standing * before.squared_length() * after.squared_length()))
        return true;
    }
    return false;
  }

  auto normal(int i, int j, int k) const
  {
    const Point_3& p = m_points[i].surface_point();
    return cross_product(m_points[j].surface_point() - p, m_points[k].surface_point() - p);
  }

  bool has_neighbor_with_index(Vertex_handle vertex, std::size_t index) const
  {
    auto neighbor = m_triangulation.incident_vertices(vertex);
    const auto first = neighbor;
    do
      if(neighbor->is_on_boundary() && neighbor->index() == index)
        return true;
    while(++neighbor != first);
    return false;
  }

  template <class MetricField>
  Squared_lengths squared_lengths(const MetricField& metric, int i, int j, int k) const
  {
    return {metric.squared_length(m_points[j], m_points[k]), metric.squared_length(m_points[k], m_points[i]),
            metric.squared_length(m_points[i], m_points[j])};
  }

  void turn() { m_triangulation.flip(m_face, m_face->index(m_across)); }

  void touch()
  {
    for(Face_handle face : {m_face, m_across}) {
      face->touch();
      for(int i = 0; i < 3; ++i)
        face->vertex(i)->set_settled(false);
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_EDGE_FLIP_H
