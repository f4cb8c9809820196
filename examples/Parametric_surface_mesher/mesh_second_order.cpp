// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Six-node triangles on a torus: each edge of the mesh gets a node on the surface, which the triangles on both sides share. They are
// far closer to the torus than straight ones, and proved not to be folded.
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Rectangular_patch_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_model_of_rectangular_patches.h>
#include <CGAL/make_parametric_surface_mesh.h>
#include <CGAL/make_second_order_mesh.h>

#include <cstddef>
#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Parametric_torus_3<Kernel> Torus;

int main()
{
  namespace params = CGAL::parameters;

  // The whole torus as a model of one face, which closes on itself.
  const std::vector<CGAL::Rectangular_patch_3<Torus>> patches = {{Torus(1, 0.4), 0, 2 * CGAL_PI, 0, 2 * CGAL_PI}};
  const auto model = CGAL::make_model_of_rectangular_patches(patches);

  // Straight triangles, with where they lie in the model.
  Mesh mesh;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const auto place = mesh.add_property_map<Mesh::Edge_index, CGAL::Parametric_surface_mesher::Edge_place>("e:place").first;
  const auto maps = params::halfedge_uv_map(uv, params::edge_place_map(place));
  CGAL::make_parametric_surface_mesh(model, CGAL::Parametric_surface_mesh_criteria().set_max_edge(0.15), mesh, maps);

  // A node for each edge; first in the middle of the straight edge, to compare.
  const auto node = mesh.add_property_map<Mesh::Edge_index, Kernel::Point_3>("e:node").first;
  for(const auto e : mesh.edges())
    node[e] = CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
  const double straight = CGAL::second_order_mesh_distance(model, mesh, node, maps);
  const auto report = CGAL::make_second_order_mesh(model, mesh, node, maps);
  const double curved = CGAL::second_order_mesh_distance(model, mesh, node, maps);

  std::cout << mesh.number_of_faces() << " triangles with " << mesh.number_of_vertices() + mesh.number_of_edges()
            << " nodes; distance from the torus " << straight << " if straight, " << curved << " if curved; smallest scaled Jacobian "
            << report.smallest_scaled_jacobian << "\n";
  return report.uncertified.empty() && curved < straight / 20 ? 0 : 1;
}
