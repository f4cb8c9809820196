// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's remeshers, which start from a mesh of the surface that is finer than the one that is wanted: the way from a parametric surface to
// a mesh by CGAL alone. And its mesher of solids, with criteria for their boundary alone.
#ifndef CGAL_REMESHERS_H
#define CGAL_REMESHERS_H

#include "Comparison_shape.h"
#include "Mesh_sizes.h"
#include "Sample_mesher.h"
#include "cgal_meshers.h"

#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_domain_with_polyline_features_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/facets_in_complex_3_to_triangle_mesh.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/Polygon_mesh_processing/Adaptive_sizing_field.h>
#include <CGAL/Polygon_mesh_processing/surface_Delaunay_remeshing.h>
#endif

#include <cmath>
#include <utility>
#include <vector>

namespace cgal_remeshers {

namespace PMP = CGAL::Polygon_mesh_processing;

const unsigned int number_of_iterations = 5; // of remeshing; more change little
const double sharp_angle = 60;               // between the normals beside an edge that is kept
// The shortest and the longest edges that curvature may ask for, as shares of the mean, where no distance is asked for.
const double shortest_share = 0.2, longest_share = 4;

// Isotropic remeshing with edges of the sizes of `field`, a number or a sizing field of CGAL. Sharp edges are divided anew, but stay.
template <class Field>
void remesh_to(Field& field, Sample_mesh& mesh)
{
  auto is_sharp = mesh.add_property_map<Sample_mesh::Edge_index, bool>("e:is_sharp", false).first;
  PMP::detect_sharp_edges(mesh, sharp_angle, is_sharp);
  PMP::isotropic_remeshing(mesh.faces(), field, mesh,
                           CGAL::parameters::number_of_iterations(number_of_iterations).edge_is_constrained_map(is_sharp));
  mesh.remove_property_map(is_sharp);
  mesh.collect_garbage();
}

inline Mesher_run remesh(const Sample_mesh& fine, const Comparison_shape& shape, const Mesh_sizes& sizes, Sample_mesh& mesh)
{
  mesh = fine;
  const double edge_length = sizes.edge_length_on_arc(shape.smallest_radius);
  return run_of([&] { remesh_to(edge_length, mesh); });
}

#if CGAL_VERSION_NR >= 1060000000
inline Mesher_run remesh_adaptively(const Sample_mesh& fine, const Mesh_sizes& sizes, Sample_mesh& mesh)
{
  // Of equal edges an edge of length L is L^2 / 8 off a circle of radius 1.
  const double mean = sizes.edge_length_on_arc(1), distance = sizes.distance.value_or(mean * mean / 8);
  const double longest = sizes.distance ? sizes.edge_length : longest_share * mean;
  mesh = fine;
  return run_of([&] {
    PMP::Adaptive_sizing_field<Sample_mesh> field(distance, std::make_pair(shortest_share * mean, longest), mesh.faces(), mesh);
    remesh_to(field, mesh);
  });
}

inline Mesher_run remesh_by_delaunay(const Sample_mesh& fine, const Comparison_shape& shape, const Mesh_sizes& sizes,
                                     Sample_mesh& mesh)
{
  const double radius = cgal_meshers::radius_of(sizes.edge_length);
  return run_of([&] {
    mesh = PMP::surface_Delaunay_remeshing(fine, CGAL::parameters::mesh_edge_size(sizes.edge_length_on_arc(1))
                                                   .mesh_facet_angle(30)
                                                   .mesh_facet_size(radius)
                                                   .mesh_facet_distance(sizes.distance.value_or(radius))
                                                   .features_angle_bound(sharp_angle)
                                                   .protect_constraints(!shape.rims.empty()));
  });
}
#endif

// a rim as a polygon that is far finer than any mesh
inline std::vector<Sample_kernel::Point_3> polygon_of_rim(double height)
{
  const int parts = 2000;
  std::vector<Sample_kernel::Point_3> points;
  for(int i = 0; i < parts; ++i) {
    const double angle = 2 * sample_surfaces::pi * i / parts;
    points.emplace_back(std::cos(angle), std::sin(angle), height);
  }
  points.push_back(points.front());
  return points;
}

// make_mesh_3() on the zero set of a function, with criteria for the surface alone, and with the rims as its features. In CGAL 6 it takes
// the place of make_surface_mesh().
inline Mesher_run mesh_boundary_of_solid(const Comparison_shape& shape, const Mesh_sizes& sizes, Sample_mesh& mesh)
{
  typedef CGAL::Labeled_mesh_domain_3<Sample_kernel> Zero_set;
  typedef CGAL::Mesh_domain_with_polyline_features_3<Zero_set> Domain;
  typedef CGAL::Mesh_triangulation_3<Domain>::type Triangulation;
  typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index, Domain::Curve_index> Complex;
  typedef CGAL::Mesh_criteria_3<Triangulation> Criteria;
  const Sample_kernel::Sphere_3 ball(CGAL::ORIGIN, 4);
  Domain domain(Zero_set::create_implicit_mesh_domain(
    shape.distance, ball, CGAL::parameters::relative_error_bound = cgal_meshers::error_bound_of_zero_sets));
  std::vector<std::vector<Sample_kernel::Point_3>> rims;
  for(const double height : shape.rims)
    rims.push_back(polygon_of_rim(height));
  domain.add_features(rims.begin(), rims.end());
  const double radius = cgal_meshers::radius_of(sizes.edge_length);
  const Criteria criteria(Criteria::Edge_criteria(sizes.edge_length_on_arc(1)),
                          Criteria::Facet_criteria(30, radius, sizes.distance.value_or(radius)), Criteria::Cell_criteria(0, 0));
  Complex complex;
  const Mesher_run run = run_of([&] {
    complex = CGAL::make_mesh_3<Complex>(domain, criteria, CGAL::parameters::no_perturb(), CGAL::parameters::no_exude());
  });
  CGAL::facets_in_complex_3_to_triangle_mesh(complex, mesh);
  return run;
}

} // namespace cgal_remeshers

#endif // CGAL_REMESHERS_H
