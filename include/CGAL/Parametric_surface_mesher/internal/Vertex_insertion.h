// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_VERTEX_INSERTION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_VERTEX_INSERTION_H

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Insertion of a vertex inside the domain: the face or edge that holds it is split, then the edges opposite to it are
// flipped while the point lies in the circumellipse of the triangle across. Each flip raises the degree of the new vertex,
// so this ends whatever the metric does.
template <class Triangulation>
class Vertex_insertion
{
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Point Point;

  Triangulation& m_triangulation;
  std::vector<Face_handle> m_stack; // faces whose edge opposite to the new vertex is to be looked at
  std::vector<Face_handle> m_star;  // faces of the new vertex

public:
  explicit Vertex_insertion(Triangulation& triangulation) : m_triangulation(triangulation) {}

  Vertex_handle insert_in_face(const Point& p, Face_handle face)
  {
    const Vertex_handle vertex = m_triangulation.tds().insert_in_face(face);
    return restore(vertex, p);
  }

  // \pre edge `i` of `face` is not constrained
  Vertex_handle insert_in_edge(const Point& p, Face_handle face, int i)
  {
    CGAL_precondition(!face->is_constrained(i));
    const Vertex_handle vertex = m_triangulation.tds().insert_in_edge(face, i);
    return restore(vertex, p);
  }

  // the faces around the vertex inserted last
  const std::vector<Face_handle>& star() const { return m_star; }

private:
  Vertex_handle restore(Vertex_handle vertex, const Point& p)
  {
    vertex->set_point(p);
    collect_star(vertex);
    for(Face_handle face : m_star) {
      const int i = face->index(vertex);
      const bool is_constrained = face->neighbor(i)->is_constrained(m_triangulation.mirror_index(face, i));
      face->set_constraints(false, false, false);
      face->set_constraint(i, is_constrained);
    }
    m_stack = m_star;
    while(!m_stack.empty()) {
      const Face_handle face = m_stack.back();
      m_stack.pop_back();
      flip_if_not_delaunay(face, vertex);
    }
    collect_star(vertex);
    for(Face_handle face : m_star) {
      face->set_in_domain(true);
      face->touch();
    }
    return vertex;
  }

  void flip_if_not_delaunay(Face_handle face, Vertex_handle vertex)
  {
    const int i = face->index(vertex);
    if(face->is_constrained(i))
      return;
    const Face_handle across = face->neighbor(i);
    if(m_triangulation.geom_traits().side_of_oriented_circle_2_object()(
         across->vertex(0)->point(), across->vertex(1)->point(), across->vertex(2)->point(), vertex->point())
       != ON_POSITIVE_SIDE)
      return;
    m_triangulation.flip(face, i);
    m_stack.push_back(face);
    m_stack.push_back(across);
  }

  void collect_star(Vertex_handle vertex)
  {
    m_star.clear();
    const Face_handle first = vertex->face();
    Face_handle face = first;
    do {
      m_star.push_back(face);
      face = face->neighbor((face->index(vertex) + 1) % 3);
    } while(face != first);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_VERTEX_INSERTION_H
