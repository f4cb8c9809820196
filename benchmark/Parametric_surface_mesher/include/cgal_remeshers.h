// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's remeshers, which start from a mesh of the surface that is finer than the one that is wanted: the way from a parametric surface to
// a mesh by CGAL alone. And its mesher of solids, with criteria for their boundary alone.
#ifndef CGAL_REMESHERS_H
#define CGAL_REMESHERS_H

#include "Sample_mesher.h"
#include "cgal_meshers.h"

#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/facets_in_complex_3_to_triangle_mesh.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/make_parametric_surface_mesh.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/Polygon_mesh_processing/Adaptive_sizing_field.h>
#include <CGAL/Polygon_mesh_processing/surface_Delaunay_remeshing.h>
#endif

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace cgal_remeshers {

namespace PMP = CGAL::Polygon_mesh_processing;

// The edge length of the mesh that is remeshed, as a share of the one that is wanted on average. Shorter edges change the results little.
const double share_of_tessellation = 1. / 3;
const unsigned int number_of_iterations = 5; // of remeshing; more change little
// The shortest and the longest edges that curvature may ask for, as shares of the mean.
const double shortest_share = 0.2, longest_share = 4;

inline Sample_mesh tessellation(const Sample& sample, double edge_length)
{
  Sample_mesh mesh;
  const auto criteria = CGAL::Parametric_surface_mesh_criteria().set_max_edge(edge_length);
  CGAL::make_parametric_surface_mesh(sample.surface, sample.domain, criteria, mesh);
  return mesh;
}

inline Mesher_run remesh(const Sample_mesh& fine, double edge_length, Sample_mesh& mesh)
{
  mesh = fine;
  return run_of([&] {
    PMP::isotropic_remeshing(mesh.faces(), edge_length, mesh, CGAL::parameters::number_of_iterations(number_of_iterations));
    mesh.collect_garbage();
  });
}

#if CGAL_VERSION_NR >= 1060000000
// `distance`: how far from the surface edges of these sizes may be, which decides the number of triangles
inline Mesher_run remesh_adaptively(const Sample_mesh& fine, double edge_length, double distance, Sample_mesh& mesh)
{
  mesh = fine;
  return run_of([&] {
    PMP::Adaptive_sizing_field<Sample_mesh> field(
      distance, std::make_pair(shortest_share * edge_length, longest_share * edge_length), mesh.faces(), mesh);
    PMP::isotropic_remeshing(mesh.faces(), field, mesh, CGAL::parameters::number_of_iterations(number_of_iterations));
    mesh.collect_garbage();
  });
}

inline Mesher_run remesh_by_delaunay(const Sample_mesh& fine, double edge_length, Sample_mesh& mesh)
{
  return run_of([&] {
    mesh = PMP::surface_Delaunay_remeshing(fine, CGAL::parameters::mesh_edge_size(edge_length)
                                                   .mesh_facet_angle(30)
                                                   .mesh_facet_size(edge_length / std::sqrt(3.))
                                                   .features_angle_bound(60)
                                                   .protect_constraints(false));
  });
}
#endif

// make_mesh_3() on the zero set of a function, with criteria for the surface alone. In CGAL 6 it takes the place of make_surface_mesh().
inline Mesher_run mesh_boundary_of_solid(const cgal_meshers::Distance& function, double edge_length, Sample_mesh& mesh)
{
  typedef CGAL::Labeled_mesh_domain_3<Sample_kernel> Domain;
  typedef CGAL::Mesh_triangulation_3<Domain>::type Triangulation;
  typedef CGAL::Mesh_criteria_3<Triangulation> Criteria;
  const Domain domain = Domain::create_implicit_mesh_domain(function, Sample_kernel::Sphere_3(CGAL::ORIGIN, 4));
  const double radius = edge_length / std::sqrt(3.);
  const Criteria criteria(Criteria::Facet_criteria(30, radius, radius), Criteria::Cell_criteria(0, 0));
  CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> complex;
  const Mesher_run run = run_of([&] {
    complex = CGAL::make_mesh_3<CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>>(
      domain, criteria, CGAL::parameters::no_perturb(), CGAL::parameters::no_exude());
  });
  CGAL::facets_in_complex_3_to_triangle_mesh(complex, mesh);
  return run;
}

// All meshers that can mesh the sample, for about `size` triangles.
inline std::vector<Sample_mesher> meshers_of(const Sample& sample, double size)
{
  const auto fine = std::make_shared<const Sample_mesh>(tessellation(sample, share_of_tessellation * sample.edge_length(size)));
  std::vector<Sample_mesher> result{
    {"isotropic_remeshing", [fine](double edge_length, Sample_mesh& mesh) { return remesh(*fine, edge_length, mesh); }}};
#if CGAL_VERSION_NR >= 1060000000
  result.push_back({"isotropic_remeshing, adaptive", [fine, mean = sample.edge_length(size)](double edge_length, Sample_mesh& mesh) {
                      // An edge of length L is L^2 / 8 off a circle of radius 1.
                      return remesh_adaptively(*fine, mean, edge_length * edge_length / 8, mesh);
                    }});
  result.push_back({"surface_Delaunay_remeshing",
                    [fine](double edge_length, Sample_mesh& mesh) { return remesh_by_delaunay(*fine, edge_length, mesh); }});
#endif
  if(sample.name == "sphere" || sample.name == "torus")
    result.push_back({"make_mesh_3", [distance = cgal_meshers::distance_to(sample.name)](double edge_length, Sample_mesh& mesh) {
                        return mesh_boundary_of_solid(distance, edge_length, mesh);
                      }});
  return result;
}

} // namespace cgal_remeshers

#endif // CGAL_REMESHERS_H
