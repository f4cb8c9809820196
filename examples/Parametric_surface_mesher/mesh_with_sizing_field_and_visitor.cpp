// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sphere patch with edges that grow from the south to the north, by a sizing field over the parameters. A visitor shows
// progress and stops the refinement at a number of vertices; the result is a valid mesh.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <cstddef>
#include <functional>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

struct Stopping_visitor : CGAL::Parametric_surface_mesh_visitor
{
  std::size_t limit, number_of_vertices = 0;

  explicit Stopping_visitor(std::size_t number) : limit(number) {}

  void on_phase(const char* name) { std::cout << "  " << name << "\n"; }
  void on_progress(std::size_t vertices, std::size_t waiting)
  {
    number_of_vertices = vertices;
    std::cout << "    " << vertices << " vertices, at most " << waiting << " triangles waiting\n";
  }
  bool go_further() { return number_of_vertices < limit; }
};

int main()
{
  const CGAL::Parametric_sphere_3<Kernel> sphere(1);
  const auto domain = CGAL::Parametric_domain_2<Kernel>::rectangle(0, 2, -1, 1); // longitude and latitude
  CGAL::Parametric_surface_mesh_criteria criteria;
  criteria.set_max_edge(0.2).set_sizing_field([](double /* u */, double v) { return 0.02 + 0.04 * (v + 1); });

  for(const std::size_t limit : {100000, 1000}) {
    std::cout << "limit " << limit << "\n";
    Mesh mesh;
    Stopping_visitor visitor(limit);
    const auto report = CGAL::make_parametric_surface_mesh(sphere, domain, criteria, mesh,
                                                           CGAL::parameters::visitor(std::ref(visitor)));
    std::cout << "  " << mesh.number_of_faces() << " triangles, of which the stop left "
              << report.count(CGAL::Parametric_surface_mesher::Unmet_cause::STOPPED) << " unfinished\n";
    if(!mesh.is_valid())
      return 1;
  }
  return 0;
}
