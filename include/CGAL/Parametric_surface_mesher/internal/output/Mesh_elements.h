// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_MESH_ELEMENTS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_MESH_ELEMENTS_H

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// New vertices, edges and faces of any face graph, by index; edge `e` has the halfedges `2 e` and `2 e + 1`.
template <class TriangleMesh>
class Added_elements
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  const TriangleMesh& m_mesh;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<halfedge_descriptor> m_halfedges; // one for each edge
  std::vector<face_descriptor> m_faces;

public:
  Added_elements(std::size_t number_of_vertices, std::size_t number_of_edges, std::size_t number_of_faces,
                 TriangleMesh& mesh)
    : m_mesh(mesh)
  {
    reserve(mesh, num_vertices(mesh) + number_of_vertices, num_edges(mesh) + number_of_edges,
            num_faces(mesh) + number_of_faces);
    add(number_of_vertices, m_vertices, [&] { return add_vertex(mesh); });
    add(number_of_edges, m_halfedges, [&] { return halfedge(add_edge(mesh), mesh); });
    add(number_of_faces, m_faces, [&] { return add_face(mesh); });
  }

  vertex_descriptor new_vertex(std::size_t i) const { return m_vertices[i]; }

  halfedge_descriptor new_halfedge(std::size_t i) const
  {
    return i % 2 == 0 ? m_halfedges[i / 2] : opposite(m_halfedges[i / 2], m_mesh);
  }

  face_descriptor new_face(std::size_t i) const { return m_faces[i]; }

private:
  template <class Descriptor, class Make>
  static void add(std::size_t n, std::vector<Descriptor>& result, const Make& make)
  {
    result.reserve(n);
    for(std::size_t i = 0; i < n; ++i)
      result.push_back(make());
  }
};

// New elements of a `Surface_mesh` from which nothing was removed: their indices are consecutive, and several threads may write
// them.
template <class SurfaceMesh>
class Appended_elements
{
  typedef typename SurfaceMesh::size_type size_type;

  const size_type m_first_vertex, m_first_halfedge, m_first_face;

public:
  // \pre `!mesh.has_garbage()`
  Appended_elements(std::size_t number_of_vertices, std::size_t number_of_edges, std::size_t number_of_faces,
                    SurfaceMesh& mesh)
    : m_first_vertex(mesh.number_of_vertices()), m_first_halfedge(mesh.number_of_halfedges()),
      m_first_face(mesh.number_of_faces())
  {
    const size_type vertices = size_type(m_first_vertex + number_of_vertices),
                    edges = size_type(m_first_halfedge / 2 + number_of_edges), faces = size_type(m_first_face + number_of_faces);
    mesh.reserve(vertices, edges, faces); // so that no array grows to twice the needed size
    mesh.resize(vertices, edges, faces);
  }

  typename SurfaceMesh::Vertex_index new_vertex(std::size_t i) const
  {
    return typename SurfaceMesh::Vertex_index(size_type(m_first_vertex + i));
  }

  typename SurfaceMesh::Halfedge_index new_halfedge(std::size_t i) const
  {
    return typename SurfaceMesh::Halfedge_index(size_type(m_first_halfedge + i));
  }

  typename SurfaceMesh::Face_index new_face(std::size_t i) const
  {
    return typename SurfaceMesh::Face_index(size_type(m_first_face + i));
  }
};

template <class TriangleMesh>
struct Is_surface_mesh : std::false_type
{};

template <class Point>
struct Is_surface_mesh<Surface_mesh<Point>> : std::true_type
{};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_MESH_ELEMENTS_H
