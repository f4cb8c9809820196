// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A user-defined criterion in addition to those of the package: no edge may climb more than a given height, for instance because
// contour lines will be drawn on the mesh.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_function_surface_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

// By how much a triangle climbs, as a share of what it may.
struct Climb
{
  double max_climb;

  template <class Triangle>
  double operator()(const Triangle& triangle) const
  {
    const double z[] = {triangle.point(0).z(), triangle.point(1).z(), triangle.point(2).z()};
    return CGAL::square((*std::max_element(z, z + 3) - *std::min_element(z, z + 3)) / max_climb);
  }
};

int main()
{
  const auto hill = CGAL::make_parametric_function_surface([](auto u, auto v) {
    using std::exp;
    return CGAL::parametric_surface_point(u, v, exp(-2 * (u * u + v * v)));
  });
  const auto domain = CGAL::Parametric_domain_2<Kernel>::rectangle(-2, 2, -2, 2);
  for(const double max_climb : {1., 0.05, 0.02}) {
    CGAL::Parametric_surface_mesh_criteria criteria;
    criteria.set_max_edge(0.2);
    Mesh mesh;
    const auto report = CGAL::make_parametric_surface_mesh(hill, domain, criteria, mesh,
                                                           CGAL::parameters::triangle_criterion(Climb{max_climb}));
    double found = 0;
    for(const auto e : mesh.edges())
      found = (std::max)(found, std::fabs(mesh.point(mesh.vertex(e, 0)).z() - mesh.point(mesh.vertex(e, 1)).z()));
    std::cout << "climb up to " << max_climb << ": " << mesh.number_of_faces() << " triangles, largest climb " << found
              << ", smallest angle " << report.smallest_angle << " degrees\n";
    if(report.unmet.empty() && found > max_climb)
      return 1;
  }
  return 0;
}
