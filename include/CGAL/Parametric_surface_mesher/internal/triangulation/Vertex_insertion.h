// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_VERTEX_INSERTION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_VERTEX_INSERTION_H

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Insertion of a vertex inside the domain: the face or edge that holds it is split, then the edges opposite to it are
// flipped while the point lies in the circumellipse of the triangle across. Each flip raises the degree of the new vertex,
// so this ends for any metric. The new vertex is vertex 0 of all its faces, so that it need not be searched for at each step, as
// the general functions of the data structure do. (Insertion by these functions was measured to be slower.)
template <class Triangulation>
class Vertex_insertion
{
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Point Point;

  Triangulation& m_triangulation;
  std::vector<Face_handle> m_stack; // faces whose edge opposite to the new vertex has to be flipped
  std::vector<Face_handle> m_star;  // faces around the new vertex

public:
  explicit Vertex_insertion(Triangulation& triangulation) : m_triangulation(triangulation) {}

  Vertex_handle insert_in_face(const Point& p, Face_handle face)
  {
    const Vertex_handle vertex = split(face, p);
    look_at(p, face, face->neighbor(1), face->neighbor(2));
    restore(vertex);
    return vertex;
  }

  // \pre edge `i` of `face` is not constrained, and `p` sees the four other edges of its two faces from inside
  Vertex_handle insert_in_edge(const Point& p, Face_handle face, int i)
  {
    CGAL_precondition(!face->is_constrained(i));
    const Face_handle across = face->neighbor(i);
    const Vertex_handle vertex = split(face, p);
    for(Face_handle side : {face, face->neighbor(1), face->neighbor(2)}) {
      if(side->neighbor(0) == across) {
        flip(side);
        look_at(p, side, across);
      }
      else
        look_at(p, side);
    }
    restore(vertex);
    return vertex;
  }

  // The faces around the vertex that was inserted last, counterclockwise; it is vertex 0 of each.
  const std::vector<Face_handle>& star() const { return m_star; }

private:
  // `face` becomes the one of the three new faces that keeps its edge 0, which is then opposite to the new vertex.
  Vertex_handle split(Face_handle face, const Point& p)
  {
    auto& tds = m_triangulation.tds();
    const Vertex_handle vertex = tds.create_vertex(), a = face->vertex(0), b = face->vertex(1), c = face->vertex(2);
    vertex->set_point(p);
    const Face_handle over_b = tds.create_face(vertex, c, a), over_c = tds.create_face(vertex, a, b);
    take_edge(over_b, face, 1);
    take_edge(over_c, face, 2);
    over_b->set_neighbors(over_b->neighbor(0), over_c, face);
    over_c->set_neighbors(over_c->neighbor(0), face, over_b);
    face->set_vertex(0, vertex);
    face->set_neighbors(face->neighbor(0), over_b, over_c);
    face->set_constraints(face->is_constrained(0), false, false);
    over_b->set_in_domain(true);
    over_c->set_in_domain(true);
    a->set_face(over_b);
    vertex->set_face(face);
    return vertex;
  }

  // The neighbour across edge `i` of `from` becomes the one across edge 0 of `face`.
  static void take_edge(Face_handle face, Face_handle from, int i)
  {
    const Face_handle across = from->neighbor(i);
    face->set_neighbor(0, across);
    across->set_neighbor(across->index(from), face);
    face->set_constraints(from->is_constrained(i), false, false);
  }

  void restore(Vertex_handle vertex)
  {
    while(!m_stack.empty()) {
      const Face_handle face = m_stack.back(), across = face->neighbor(0);
      m_stack.pop_back();
      flip(face);
      look_at(vertex->point(), face, across);
    }
    collect_star(vertex->face());
    for(Face_handle face : m_star)
      face->touch();
  }

  // Tests all edges before pushing any: the outcomes are unpredictable, and without branches in between the processor works on
  // several tests at once.
  template <class... Faces>
  void look_at(const Point& p, Faces... faces)
  {
    const std::array<bool, sizeof...(Faces)> are_to_be_flipped{!faces->is_constrained(0) && !is_delaunay(faces, p)...};
    const std::array<Face_handle, sizeof...(Faces)> all{faces...};
    for(std::size_t i = 0; i < all.size(); ++i)
      if(are_to_be_flipped[i])
        m_stack.push_back(all[i]);
  }

  bool is_delaunay(Face_handle face, const Point& p) const
  {
    const Face_handle across = face->neighbor(0);
    return m_triangulation.geom_traits().side_of_oriented_circle_2_object()(
             across->vertex(0)->point(), across->vertex(1)->point(), across->vertex(2)->point(), p)
           != ON_POSITIVE_SIDE;
  }

  // Replaces the edge from `a` to `b`, opposite to the new vertex, by one from the new vertex to the corner `c` across it. `face`
  // keeps `a`, and the face across keeps `b`.
  static void flip(Face_handle face)
  {
    const Face_handle across = face->neighbor(0), behind_b = face->neighbor(1);
    const Vertex_handle vertex = face->vertex(0), a = face->vertex(1), b = face->vertex(2);
    const int i = across->index(face), at_b = Triangulation::ccw(i), at_a = Triangulation::cw(i);
    const Vertex_handle c = across->vertex(i);
    const Face_handle over_bc = across->neighbor(at_a);
    const bool is_bc_constrained = across->is_constrained(at_a);
    take_edge(face, across, at_b);
    face->set_vertex(2, c);
    face->set_neighbor(1, across);
    across->set_vertices(vertex, c, b);
    across->set_neighbors(over_bc, behind_b, face);
    across->set_constraints(is_bc_constrained, false, false);
    behind_b->set_neighbor(2, across);
    a->set_face(face);
    b->set_face(across);
  }

  void collect_star(Face_handle first)
  {
    m_star.clear();
    Face_handle face = first;
    do {
      m_star.push_back(face);
      face = face->neighbor(1);
    } while(face != first);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_VERTEX_INSERTION_H
