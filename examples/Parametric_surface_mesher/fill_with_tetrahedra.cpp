// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a closed surface to tetrahedra. A torus, closed by its seams, and a cone with a base in its hole are meshed as one
// model of three patches. TetGen fills both and keeps every triangle, which is checked. Give the name of a .vtk file to get
// the tetrahedra.
#include "Output_files.h"
#include "Sample_surfaces.h"
#include "Tetrahedra.h"
#include "check_tetrahedra.h"

#include <CGAL/Parametric_function_surface_3.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Rectangular_patch_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_model_of_rectangular_patches.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <iostream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

typedef Sample_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Rectangular_patch_3<Sample_surface> Patch; // of surfaces of any kind

namespace {

const double pi = 4 * std::atan(1.);

// All patches make full turns: the torus in both directions, the cone from its base (v = 0) to its apex, and the base from its
// centre (v = 0) to its rim.
std::vector<Patch> make_patches()
{
  const double radius = 0.5, slope = pi / 4;
  const CGAL::Parametric_torus_3<Kernel> torus(1, 0.3);
  const CGAL::Parametric_cone_3<Kernel> cone(radius, -slope);
  const auto base = CGAL::make_parametric_function_surface([](auto u, auto v) {
    using std::cos;
    using std::sin;
    return CGAL::parametric_surface_point(v * cos(u), v * sin(u), 0);
  });
  return {Patch(Sample_surface(torus), 0, 2 * pi, 0, 2 * pi),
          Patch(Sample_surface(cone), 0, 2 * pi, 0, radius / std::sin(slope)),
          Patch(Sample_surface(base), 0, 2 * pi, 0, radius)};
}

Mesh make_surface()
{
  CGAL::Parametric_surface_mesh_criteria criteria;
  // At the apex of the cone small triangles deviate as much as large ones, so the minimum edge limits the refinement.
  criteria.set_max_edge(0.1).set_min_edge(0.02);
  Mesh mesh;
  CGAL::make_parametric_surface_mesh(CGAL::make_model_of_rectangular_patches(make_patches()), criteria, mesh);
  return mesh;
}

double smallest_dihedral_angle(const Tetrahedra& tetrahedra)
{
  static const int edges[6][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}};
  double result = 180;
  for(const Tetrahedra::Cell& c : tetrahedra.cells)
    for(const auto& e : edges) {
      const auto& p = tetrahedra.points;
      const double angle = CGAL::approximate_dihedral_angle(p[c[e[0]]], p[c[e[1]]], p[c[e[2]]], p[c[e[3]]]);
      result = (std::min)(result, std::fabs(angle));
    }
  return result;
}

void print_summary(const Mesh& surface, const Tetrahedra& tetrahedra)
{
  std::cout << surface.number_of_faces() << " triangles with " << surface.number_of_vertices() << " vertices\n"
            << tetrahedra.cells.size() << " tetrahedra with " << tetrahedra.points.size()
            << " vertices; the triangles are their boundary\n"
            << "volume " << CGAL::Polygon_mesh_processing::volume(surface) << ", smallest dihedral angle "
            << smallest_dihedral_angle(tetrahedra) << " degrees\n";
}

void run(const std::vector<std::string>& arguments)
{
  if(arguments.size() > 1)
    throw std::invalid_argument("expected no argument, or the name of one file");
  if(!arguments.empty() && std::filesystem::path(arguments[0]).extension() != ".vtk")
    throw std::invalid_argument("'" + arguments[0] + "' does not end in .vtk; the tetrahedra are written as a VTK file");
  Tetrahedra tetrahedra;
  Output_files files; // refuses a bad file name before the work begins
  if(!arguments.empty())
    files.add(arguments[0], [&](std::ostream& out) { write_VTK(out, tetrahedra); });

  const Mesh surface = make_surface();
  tetrahedra = fill_with_tetrahedra(surface);
  check_tetrahedra(surface, tetrahedra);
  files.write();
  print_summary(surface, tetrahedra);
}

} // namespace

int main(int argc, char** argv)
try {
  run(std::vector<std::string>(argv + 1, argv + argc));
  return 0;
}
catch(const std::exception& error) {
  std::cerr << "fill_with_tetrahedra: " << error.what() << "\n";
  return 1;
}
