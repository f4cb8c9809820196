// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_STRIP_TRIANGULATION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_STRIP_TRIANGULATION_H

#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Makes a triangulation of triangles that are given with their neighbours. Their outer edges become constraints with infinite faces
behind them, so the result does not fill its convex hull. Smoothing and refinement work on it, since they cross no constraints;
points cannot be located from outside.
*/
template <class Kernel>
class Strip_triangulation
{
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Vertex Vertex;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;

  Triangulation& m_triangulation;
  std::unordered_map<const void*, Vertex_handle> m_vertices; // never iterated over
  std::vector<Face_handle> m_faces, m_outer_faces;
  std::size_t m_number_of_vertices_on_boundary = 0;

public:
  // \pre the triangulation is empty
  Strip_triangulation(Triangulation& triangulation, std::size_t number_of_faces) : m_triangulation(triangulation)
  {
    triangulation.tds().delete_face(triangulation.infinite_vertex()->face());
    triangulation.tds().set_dimension(2);
    m_faces.reserve(number_of_faces);
    m_vertices.reserve(number_of_faces);
  }

  // The vertex with this key; a new one is a copy of `other`.
  Vertex_handle vertex(const void* key, const Vertex& other, bool is_on_boundary)
  {
    Vertex_handle& result = m_vertices[key];
    if(result == Vertex_handle()) {
      result = m_triangulation.tds().create_vertex();
      result->set_point(other.point());
      result->set_spacing(other.spacing());
      result->set_index(other.index());
      result->set_on_boundary(is_on_boundary);
      result->set_kept(other.is_kept());
      m_number_of_vertices_on_boundary += is_on_boundary;
    }
    return result;
  }

  std::size_t number_of_vertices_on_boundary() const { return m_number_of_vertices_on_boundary; }

  // Sets the vertices of a face; `corner(i)` is its vertex `i`.
  template <class Corner>
  void add_face(const Corner& corner)
  {
    const Vertex_handle v0 = corner(0), v1 = corner(1), v2 = corner(2);
    const Face_handle face = m_triangulation.tds().create_face(v0, v1, v2);
    face->set_in_domain(true);
    for(Vertex_handle v : {v0, v1, v2})
      v->set_face(face);
    m_faces.push_back(face);
  }

  // Sets the face across edge `i` of face `k`; there is none if `across` is negative.
  void set_neighbor(std::size_t k, int i, std::ptrdiff_t across)
  {
    const Face_handle face = m_faces[k];
    if(across >= 0) {
      face->set_neighbor(i, m_faces[std::size_t(across)]);
      return;
    }
    const Vertex_handle v = face->vertex(Triangulation::cw(i)), w = face->vertex(Triangulation::ccw(i));
    const Face_handle outer = m_triangulation.tds().create_face(v, w, m_triangulation.infinite_vertex());
    face->set_constraint(i, true);
    outer->set_constraint(2, true);
    m_triangulation.tds().set_adjacency(face, i, outer, 2);
    m_outer_faces.push_back(outer);
  }

  // Joins the infinite faces. Must be called when all neighbours are set.
  void close()
  {
    std::unordered_map<const void*, std::vector<Face_handle>> from_vertex; // the infinite faces whose edge ends at a vertex
    for(Face_handle outer : m_outer_faces)
      from_vertex[&*outer->vertex(1)].push_back(outer);
    for(Face_handle outer : m_outer_faces) {
      std::vector<Face_handle>& others = from_vertex[&*outer->vertex(0)];
      m_triangulation.tds().set_adjacency(outer, 1, others.back(), 0);
      others.pop_back();
    }
    if(!m_outer_faces.empty())
      m_triangulation.infinite_vertex()->set_face(m_outer_faces.front());
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_STRIP_TRIANGULATION_H
