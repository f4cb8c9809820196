// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_VALENCE_EQUALIZATION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_VALENCE_EQUALIZATION_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Star_limits.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Vertex_star.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Edge_flip.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Transaction.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Flips edges where that brings the valences of the four vertices around closer to six, which no triangle tells: where fronts
have met, pairs of vertices with five and seven neighbours are left, and some of them can annihilate each other. The four
vertices are moved to where the triangles around them are closest to equilateral. All is undone unless that makes the
triangles around them better, and leaves no angle below 40 degrees: where the boundary keeps triangles from being good,
valences are not what is wrong.
*/
template <class Evaluator>
class Valence_equalization
{
  typedef Patch_triangulation_2<typename Evaluator::Kernel> Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Point Point;
  typedef std::array<Vertex_handle, 4> Quadrilateral; // the edge runs from 0 to 1

  struct Neighbor
  {
    Vertex_handle vertex;
    int valence;
  };

  Triangulation& m_triangulation;
  const Evaluator& m_evaluate;
  const Star_limits m_limits;
  Vertex_star<Triangulation, typename Evaluator::Oracle::Metric_field> m_star;
  std::vector<Neighbor> m_ring;
  std::vector<Face_handle> m_faces;
  Transaction<Triangulation> m_transaction;

public:
  Valence_equalization(Triangulation& triangulation, const Evaluator& evaluate,
                       const Parametric_surface_mesh_criteria& criteria)
    : m_triangulation(triangulation), m_evaluate(evaluate), m_limits(criteria),
      m_star(triangulation, evaluate.oracle().metric())
  {}

  // Flips an edge of a vertex with more than six neighbours if that improves valences and shapes.
  void operator()(Vertex_handle vertex)
  {
    collect_ring(vertex);
    const std::size_t n = m_ring.size();
    for(std::size_t k = 0; k < n; ++k) {
      const Neighbor &across = m_ring[k], &left = m_ring[(k + 1) % n], &right = m_ring[(k + n - 1) % n];
      // a flip reduces the sum of the squared differences of the four valences from six under this condition
      const bool gains = int(n) + across.valence > left.valence + right.valence + 2;
      const Quadrilateral vertices{vertex, across.vertex, left.vertex, right.vertex};
      if(gains && std::all_of(vertices.begin(), vertices.end(), can_move) && flip_if_better(vertices))
        return;
    }
  }

private:
  static bool can_move(Vertex_handle vertex) { return !vertex->is_on_boundary() && !vertex->is_kept(); }

  // Collects the neighbours of a vertex in counterclockwise order.
  void collect_ring(Vertex_handle vertex)
  {
    m_ring.clear();
    auto neighbor = m_triangulation.incident_vertices(vertex);
    const auto first = neighbor;
    do
      m_ring.push_back({neighbor, int(m_triangulation.degree(neighbor))});
    while(++neighbor != first);
  }

  bool flip_if_better(const Quadrilateral& vertices)
  {
    Face_handle face;
    int i = 0;
    CGAL_assertion_code(const bool is_edge =) m_triangulation.is_edge(vertices[0], vertices[1], face, i);
    CGAL_assertion(is_edge);
    const Edge_flip<Triangulation> edge(m_triangulation, face, i);
    if(!edge.is_valid())
      return false;
    m_faces.clear();
    const Star_shape before = shape(vertices);
    m_transaction.begin(m_faces);
    m_transaction.flip(edge);
    for(Vertex_handle vertex : vertices)
      move(vertex);
    const Star_shape after = shape(vertices);
    if(after.quality.is_good() && after.quality.is_better_than(before.quality)
       && m_limits.allow(after, [&] { return before; })) {
      unsettle(vertices);
      return true;
    }
    m_transaction.roll_back();
    return false;
  }

  // Moves a vertex to where the triangles around are closest to equilateral, whether that is better or not.
  void move(Vertex_handle vertex)
  {
    m_star.collect(vertex);
    m_star.quality();
    const auto target = m_star.mean_of_apices();
    if(!m_star.is_around(target))
      return;
    const Point point = m_evaluate.position(target, vertex->spacing()).point;
    if(!m_star.is_inverted(point, m_evaluate.oracle()))
      m_transaction.move(vertex, point);
  }

  void unsettle(const Quadrilateral& vertices)
  {
    for(Vertex_handle vertex : vertices) {
      m_star.collect(vertex);
      m_star.unsettle_ring();
    }
  }

  // The worst measures among all four stars, with the mean of their mean qualities. Their faces are collected.
  Star_shape shape(const Quadrilateral& vertices)
  {
    Star_shape result;
    for(Vertex_handle vertex : vertices) {
      m_star.collect(vertex);
      m_faces.insert(m_faces.end(), m_star.faces().begin(), m_star.faces().end());
      const Star_shape shape = m_star.shape(vertex->point());
      result.quality.squared_sine = (std::min)(result.quality.squared_sine, shape.quality.squared_sine);
      result.quality.mean += shape.quality.mean / double(vertices.size());
      result.squared_size = (std::max)(result.squared_size, shape.squared_size);
      result.squared_length = (std::max)(result.squared_length, shape.squared_length);
      result.squared_distance = (std::min)(result.squared_distance, shape.squared_distance);
    }
    return result;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_VALENCE_EQUALIZATION_H
