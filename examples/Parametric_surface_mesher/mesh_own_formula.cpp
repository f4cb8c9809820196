// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A surface given by a formula, over a disk with a triangular hole. The formula is written once; its derivatives come from
// automatic differentiation. The parameters (u,v) are kept at the vertices.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_function_surface_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <cmath>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Parametric_domain_2<Kernel> Domain;

int main()
{
  const auto surface = CGAL::make_parametric_function_surface([](auto u, auto v) {
    using std::cos;
    using std::exp;
    return CGAL::parametric_surface_point(u, v, exp(-(u * u + v * v)) * cos(4 * u));
  });
  Domain domain({Domain::Curve::circle(Kernel::Point_2(0, 0), 1.5)});
  domain.add_hole(Domain::polygon({{0.5, 0.5}, {0.9, 0.5}, {0.5, 0.9}}));

  CGAL::Parametric_surface_mesh_criteria criteria; // angles of at least 30 degrees, deviation of at most 5 % of an edge
  criteria.set_max_edge(0.1);

  Mesh mesh;
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const CGAL::Parametric_surface_mesh_report report
    = CGAL::make_parametric_surface_mesh(surface, domain, criteria, mesh, CGAL::parameters::vertex_uv_map(uv));

  std::cout << report.number_of_faces << " triangles, smallest angle " << report.smallest_angle << " degrees, "
            << report.unmet.size() << " triangles miss a criterion\n"
            << "vertex 0 has (u,v) = (" << uv[Mesh::Vertex_index(0)] << ") and lies at (" << mesh.point(Mesh::Vertex_index(0))
            << ")\n";
  return CGAL::IO::write_OFF("own_formula.off", mesh) ? 0 : 1;
}
