// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_FACE_TURNING_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_FACE_TURNING_H

#include <CGAL/Parametric_surface_mesher/internal/improvement/Vertex_star.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Edge_flip.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Transaction.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Where the parametrisation changes its speed within a face, the face can lie on the wrong side of the surface, though it has
the right orientation in the domain. That is the worst there is: such a face is turned over by a flip or by moving one of its
inner vertices, whatever angles this costs.
*/
template <class Evaluator>
class Face_turning
{
  typedef typename Evaluator::Kernel Kernel;
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Point Point;
  typedef typename Kernel::Point_2 Point_2;

  Triangulation& m_triangulation;
  const Evaluator& m_evaluate;
  double m_squared_min_edge;
  Vertex_star<Triangulation, typename Evaluator::Oracle::Metric_field> m_star;
  Transaction<Triangulation> m_transaction;
  std::vector<Face_handle> m_changed;
  std::vector<Point_2> m_apices;

public:
  Face_turning(Triangulation& triangulation, const Evaluator& evaluate, double squared_min_edge)
    : m_triangulation(triangulation), m_evaluate(evaluate), m_squared_min_edge(squared_min_edge),
      m_star(triangulation, evaluate.oracle().metric())
  {}

  bool is_inverted(Face_handle face) const { return internal::is_inverted(face, m_evaluate.oracle()); }

  // Returns the faces that have changed, of which fewer face away than before; none if there is no such change.
  const std::vector<Face_handle>& operator()(Face_handle face)
  {
    m_changed.clear();
    for(int i = 0; i < 3 && m_changed.empty(); ++i)
      if(!face->is_constrained(i))
        flip(Edge_flip<Triangulation>(m_triangulation, face, i));
    for(int i = 0; i < 3 && m_changed.empty(); ++i)
      if(!face->vertex(i)->is_on_boundary())
        move(face->vertex(i));
    return m_changed;
  }

private:
  template <class Faces>
  std::size_t number_of_inverted(const Faces& faces) const
  {
    return std::size_t(std::count_if(faces.begin(), faces.end(), [this](Face_handle face) { return is_inverted(face); }));
  }

  void flip(Edge_flip<Triangulation> edge)
  {
    if(!edge.is_valid())
      return;
    const auto faces = edge.faces();
    const std::size_t inverted = number_of_inverted(faces);
    m_transaction.begin(faces);
    m_transaction.flip(edge);
    if(number_of_inverted(faces) < inverted) {
      m_changed.assign(faces.begin(), faces.end());
      return;
    }
    m_transaction.roll_back();
  }

  // Moves a vertex by shares of the ways to the apices of equilateral triangles over the edges of the star, and to their mean.
  void move(Vertex_handle vertex)
  {
    m_star.collect(vertex);
    m_transaction.begin(m_star.faces());
    m_star.apices(m_apices);
    const Point p = vertex->point();
    for(const Point_2& apex : m_apices)
      for(double share : {1., 0.5, 0.25, 0.1})
        if(move(vertex, Point_2(p.x() + share * (apex.x() - p.x()), p.y() + share * (apex.y() - p.y())))) {
          m_star.unsettle_ring();
          m_changed = m_star.faces();
          return;
        }
  }

  bool move(Vertex_handle vertex, const Point_2& position)
  {
    if(!m_star.is_around(position))
      return false;
    const Point to = m_evaluate.position(position, vertex->spacing()).point;
    if(!m_star.is_far_enough(to, vertex->point(), m_squared_min_edge))
      return false;
    const std::size_t inverted = number_of_inverted(m_star.faces());
    m_transaction.move(vertex, to);
    if(number_of_inverted(m_star.faces()) < inverted)
      return true;
    m_transaction.roll_back();
    return false;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_FACE_TURNING_H
