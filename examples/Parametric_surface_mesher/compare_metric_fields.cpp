// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The two metric fields of the package on a torus. The first fundamental form makes triangles equilateral in space; the
// principal curvatures stretch them along the direction of least curvature, which takes fewer triangles for the same
// deviation.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/First_fundamental_form_metric_2.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Principal_curvature_metric_2.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangle_mesh_deviation.h>
#include <CGAL/Triangle_mesh_quality.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <cmath>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

template <class Metric>
void mesh_torus(const std::string& name, const Metric& metric)
{
  const double pi = 4 * std::atan(1.);
  const CGAL::Parametric_torus_3<Kernel> torus(1, 0.2);
  const auto domain = CGAL::Parametric_domain_2<Kernel>::rectangle(0, 2 * pi, 0, 2 * pi);
  CGAL::Parametric_surface_mesh_criteria criteria;
  criteria.set_max_edge(0.5).set_gamma(0.04);
  Mesh mesh;
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  CGAL::make_parametric_surface_mesh(torus, domain, criteria, mesh,
                                     CGAL::parameters::metric_field(metric, CGAL::parameters::vertex_uv_map(uv)));
  const auto quality = CGAL::triangle_mesh_quality(mesh);
  const auto deviation = CGAL::triangle_mesh_deviation(mesh, torus, uv);
  std::cout << name << ": " << quality.number_of_faces << " triangles, smallest angle " << quality.min_angle
            << " degrees, mean " << quality.mean_min_angle << ", deviation ratio up to "
            << deviation.max_inner_deviation_ratio << "\n";
}

int main()
{
  mesh_torus("first fundamental form", CGAL::First_fundamental_form_metric_2<Kernel>());
  mesh_torus("principal curvatures", CGAL::Principal_curvature_metric_2<Kernel>());
  return 0;
}
