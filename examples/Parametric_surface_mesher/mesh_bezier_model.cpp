// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Utah teapot: 28 Bezier patches become one model, whose shared curves are divided once, and then one mesh without
// cracks.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_bezier_patches.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangle_mesh_quality.h>
#include <CGAL/make_model_of_rectangular_patches.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <cstddef>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main(int argc, char** argv)
try {
  const std::string file_name = argc > 1 ? argv[1] : PARAMETRIC_SURFACE_MESHER_DATA_DIR "/teapot.bpt";
  const auto patches = CGAL::IO::read_bezier_patches<Kernel>(file_name);
  const auto model = CGAL::make_model_of_rectangular_patches(patches);
  std::cout << patches.size() << " patches with " << 4 * patches.size() << " sides share " << model.edges().size()
            << " curves\n";

  CGAL::Parametric_surface_mesh_criteria criteria;
  criteria.set_max_edge(0.2).set_gamma(0.1);
  Mesh mesh;
  const auto patch_of = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;
  const auto report
    = CGAL::make_parametric_surface_mesh(model, criteria, mesh, CGAL::parameters::face_patch_id_map(patch_of));

  std::vector<std::size_t> triangles_of_patch(patches.size());
  for(const auto f : mesh.faces())
    ++triangles_of_patch[patch_of[f]];
  const CGAL::Triangle_mesh_quality quality = CGAL::triangle_mesh_quality(mesh);
  std::cout << quality.number_of_faces << " triangles, " << triangles_of_patch[0] << " of them on the first patch\n"
            << quality.number_of_connected_components << " pieces: body, lid, handle and spout\n"
            << "mean of the smallest angles: " << quality.mean_min_angle << " degrees; "
            << report.count(CGAL::Parametric_surface_mesher::Unmet_cause::BOUNDARY) << " triangles are limited by the curves\n";
  return quality.is_manifold ? 0 : 1;
}
catch(const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
