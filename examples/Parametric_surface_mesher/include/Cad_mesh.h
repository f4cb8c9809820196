// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mesh of a CAD model, and its triangles one by one.
#ifndef CAD_MESH_H
#define CAD_MESH_H

#include "distance_over_triangle.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_surface_mesh_parameters.h>
#include <CGAL/Parametric_surface_mesher/Model_places.h>
#include <CGAL/Surface_mesh.h>

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
    const auto of_edges = parameters::edge_place_map(edge_place, others...);
    return parameters::halfedge_uv_map(uv, parameters::face_patch_id_map(patch, parameters::vertex_place_map(vertex_place, of_edges)));
  }
};

namespace mesh_cad {

typedef Cad_mesh::Kernel Kernel;

using mesh_patch::Triangle_corners;
using mesh_patch::at;
using mesh_patch::places_in_triangle;

inline Triangle_corners corners(const Cad_mesh& mesh, Cad_mesh::Mesh::Face_index face)
{
  return mesh_patch::corners_of_triangle(mesh.mesh, mesh.uv, face);
}

} // namespace mesh_cad

#endif // CAD_MESH_H
