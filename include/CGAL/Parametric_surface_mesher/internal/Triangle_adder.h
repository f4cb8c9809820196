// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGLE_ADDER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGLE_ADDER_H

#include <CGAL/Parametric_surface_mesher/internal/Triangle_twins.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Adds indexed triangles to a face graph, in linear time: halfedges, their connection around faces, and then along borders.
template <class TriangleMesh>
class Triangle_adder
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  const Triangle_twins& m_twins;
  const std::vector<vertex_descriptor>& m_vertices;
  TriangleMesh& m_mesh;
  std::vector<halfedge_descriptor> m_halfedges; // of the sides of the triangles

public:
  Triangle_adder(const Triangle_twins& twins, const std::vector<vertex_descriptor>& vertices, TriangleMesh& mesh)
    : m_twins(twins), m_vertices(vertices), m_mesh(mesh)
  {}

  // returns the new faces; halfedge `3 f + k` runs from corner `k` of triangle `f` to the next one
  std::vector<face_descriptor> operator()(std::size_t number_of_triangles)
  {
    m_halfedges.reserve(3 * number_of_triangles);
    for(std::size_t side = 0; side < 3 * number_of_triangles; ++side)
      m_halfedges.push_back(make_halfedge(side));
    std::vector<face_descriptor> faces;
    faces.reserve(number_of_triangles);
    for(std::size_t f = 0; f < number_of_triangles; ++f) {
      faces.push_back(add_face(m_mesh));
      set_halfedge(faces.back(), m_halfedges[3 * f], m_mesh);
      for(std::size_t k = 0; k < 3; ++k) {
        set_face(m_halfedges[3 * f + k], faces.back(), m_mesh);
        set_next(m_halfedges[3 * f + k], m_halfedges[3 * f + (k + 1) % 3], m_mesh);
      }
    }
    for_each_border_halfedge([this](halfedge_descriptor h) { set_face(h, Graph_traits::null_face(), m_mesh); });
    for_each_border_halfedge([this](halfedge_descriptor h) { connect_border(h); });
    return faces;
  }

  halfedge_descriptor halfedge_of_side(std::size_t side) const { return m_halfedges[side]; }

private:
  halfedge_descriptor make_halfedge(std::size_t side)
  {
    const std::size_t twin = m_twins.twin(side);
    if(twin < side)
      return opposite(m_halfedges[twin], m_mesh);
    const halfedge_descriptor h = halfedge(add_edge(m_mesh), m_mesh);
    const vertex_descriptor source = m_vertices[m_twins.source(side)], target = m_vertices[m_twins.target(side)];
    set_target(h, target, m_mesh);
    set_target(opposite(h, m_mesh), source, m_mesh);
    set_halfedge(target, h, m_mesh);
    set_halfedge(source, opposite(h, m_mesh), m_mesh);
    return h;
  }

  template <class Visit>
  void for_each_border_halfedge(Visit visit)
  {
    for(std::size_t side = 0; side < m_halfedges.size(); ++side)
      if(m_twins.twin(side) == Triangle_twins::none)
        visit(opposite(m_halfedges[side], m_mesh));
  }

  // The next border halfedge is found by turning around the target, through the triangles there: pieces that touch in a
  // vertex keep borders of their own.
  void connect_border(halfedge_descriptor h)
  {
    halfedge_descriptor next_border = opposite(h, m_mesh);
    do
      next_border = opposite(next(next(next_border, m_mesh), m_mesh), m_mesh);
    while(face(next_border, m_mesh) != Graph_traits::null_face());
    set_next(h, next_border, m_mesh);
    set_halfedge(target(h, m_mesh), h, m_mesh);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGLE_ADDER_H
