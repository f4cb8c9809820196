// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mesh of a CAD model, and its triangles one by one.
#ifndef CAD_MESH_H
#define CAD_MESH_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_surface_mesh_parameters.h>
#include <CGAL/Parametric_surface_mesher/Model_places.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>

// A mesh with the face of the model that each triangle lies on, its corners in the domain of that face, and the pieces of edges.
struct Cad_mesh
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

  Mesh mesh;
  Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2> uv
    = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  Mesh::Property_map<Mesh::Face_index, std::size_t> patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;
  Mesh::Property_map<Mesh::Vertex_index, CGAL::Parametric_surface_mesher::Vertex_place> vertex_place
    = mesh.add_property_map<Mesh::Vertex_index, CGAL::Parametric_surface_mesher::Vertex_place>("v:place").first;
  Mesh::Property_map<Mesh::Edge_index, CGAL::Parametric_surface_mesher::Edge_place> edge_place
    = mesh.add_property_map<Mesh::Edge_index, CGAL::Parametric_surface_mesher::Edge_place>("e:place").first;
  Mesh::Property_map<Mesh::Edge_index, Kernel::Point_3> mid_side_nodes; // there are some if the elements are of second order

  // Where its elements lie in the model, as named parameters, with others.
  template <class... NamedParameters>
  auto places(const NamedParameters&... others) const
  {
    namespace parameters = CGAL::parameters;
    return parameters::halfedge_uv_map(
      uv, parameters::face_patch_id_map(patch, parameters::vertex_place_map(vertex_place, parameters::edge_place_map(edge_place, others...))));
  }
};

namespace mesh_cad {

typedef Cad_mesh::Kernel Kernel;

// The corners of a triangle: in space, and in the domain of its face.
struct Triangle_corners
{
  std::array<Kernel::Point_3, 3> points;
  std::array<Kernel::Point_2, 3> uv;
};

inline Triangle_corners corners(const Cad_mesh& mesh, Cad_mesh::Mesh::Face_index face)
{
  Triangle_corners result;
  std::size_t i = 0;
  for(const auto h : mesh.mesh.halfedges_around_face(mesh.mesh.halfedge(face))) {
    result.points[i] = mesh.mesh.point(mesh.mesh.target(h));
    result.uv[i++] = mesh.uv[h];
  }
  return result;
}

// The middles of the sides and the centroid of a triangle, in barycentric coordinates.
inline std::array<std::array<double, 3>, 4> places_in_triangle()
{
  return {{{0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {1. / 3, 1. / 3, 1. / 3}}};
}

inline Kernel::Point_2 at(const Triangle_corners& c, const std::array<double, 3>& w)
{
  return Kernel::Point_2(w[0] * c.uv[0].x() + w[1] * c.uv[1].x() + w[2] * c.uv[2].x(), w[0] * c.uv[0].y() + w[1] * c.uv[1].y() + w[2] * c.uv[2].y());
}

} // namespace mesh_cad

#endif // CAD_MESH_H
