// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's own meshers, for the samples that they can mesh: all are asked for 30 degrees.
#ifndef CGAL_MESHERS_H
#define CGAL_MESHERS_H

// CGAL 6 calls the package of make_surface_mesh() deprecated.
#define CGAL_NO_DEPRECATION_WARNINGS 1

#include "Sample_mesher.h"
#include "measure.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Surface_mesh_complex_2_in_triangulation_3.h>
#include <CGAL/Surface_mesh_default_criteria_3.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace cgal_meshers {

typedef Sample_kernel::Point_2 Point_2;
typedef Sample_kernel::Point_3 Point_3;
typedef std::function<double(const Point_3&)> Distance;

// the signed distance to a sample surface, empty if it is not known
inline Distance distance_to(const std::string& sample_name)
{
  if(sample_name == "flat")
    return [](const Point_3& p) { return p.z(); };
  if(sample_name == "sphere")
    return [](const Point_3& p) { return std::sqrt(p.x() * p.x() + p.y() * p.y() + p.z() * p.z()) - 1; };
  if(sample_name == "torus")
    return [](const Point_3& p) { return std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - 0.3; };
  return {};
}

// How far points may be from the zero set of a function, as a share of the radius of the sphere around it: below what is measured.
const double error_bound_of_zero_sets = 1e-6;

// make_surface_mesh() on the zero set of a function. The bounds are those of the radius of a facet's circumscribed ball and of its
// centre's distance from that of the circumscribed circle.
inline Mesher_run mesh_implicit(const Distance& function, double radius, double distance, Sample_mesh& mesh)
{
  typedef CGAL::Surface_mesh_default_triangulation_3 Triangulation;
  typedef Triangulation::Geom_traits Traits;
  typedef CGAL::Implicit_surface_3<Traits, Distance> Surface;
  const Surface surface(function, Traits::Sphere_3(CGAL::ORIGIN, 4), error_bound_of_zero_sets);
  const CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(30, radius, distance);
  Triangulation triangulation;
  CGAL::Surface_mesh_complex_2_in_triangulation_3<Triangulation> complex(triangulation);
  const Mesher_run run = run_of([&] { CGAL::make_surface_mesh(complex, surface, criteria, CGAL::Non_manifold_tag()); });
  CGAL::facets_in_complex_2_to_triangle_mesh(complex, mesh);
  return run;
}

// the circumradius of an equilateral triangle
inline double radius_of(double edge_length)
{
  return edge_length / std::sqrt(3.);
}

template <class Triangulation>
void append_domain(const Triangulation& triangulation, Sample_mesh& mesh)
{
  std::map<typename Triangulation::Vertex_handle, Sample_mesh::Vertex_index> vertices;
  for(const auto v : triangulation.finite_vertex_handles())
    vertices[v] = mesh.add_vertex(Point_3(v->point().x(), v->point().y(), 0));
  for(const auto f : triangulation.finite_face_handles())
    if(f->is_in_domain())
      mesh.add_face(vertices[f->vertex(0)], vertices[f->vertex(1)], vertices[f->vertex(2)]);
}

// in how many parts this package's mesher divides each side of the unit square
inline std::size_t parts_of_side(double edge_length)
{
  return static_cast<std::size_t>(std::ceil(1 / edge_length));
}

// the unit square, its sides divided in equal parts
inline std::vector<Point_2> divided_square(std::size_t parts)
{
  const std::array<Point_2, 5> corners = {Point_2(0, 0), Point_2(1, 0), Point_2(1, 1), Point_2(0, 1), Point_2(0, 0)};
  std::vector<Point_2> points;
  for(std::size_t side = 0; side < 4; ++side)
    for(std::size_t i = 0; i < parts; ++i)
      points.push_back(corners[side] + (static_cast<double>(i) / parts) * (corners[side + 1] - corners[side]));
  return points;
}

// The mesher of refine_Delaunay_mesh_2() in a polygon of the plane. It may divide the sides of the polygon further.
inline Mesher_run mesh_polygon(const std::vector<Point_2>& polygon, double edge_length, Sample_mesh& mesh)
{
  typedef CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Sample_kernel>,
                                               CGAL::Delaunay_mesh_face_base_2<Sample_kernel>> Tds;
  typedef CGAL::Constrained_Delaunay_triangulation_2<Sample_kernel, Tds> Triangulation;
  typedef CGAL::Delaunay_mesh_size_criteria_2<Triangulation> Criteria;
  const double squared_sine_of_30_degrees = 0.25;
  Triangulation triangulation;
  const Mesher_run run = run_of([&] {
    triangulation.insert_constraint(polygon.begin(), polygon.end(), true);
    CGAL::Delaunay_mesher_2<Triangulation, Criteria> mesher(triangulation, Criteria(squared_sine_of_30_degrees, edge_length));
    mesher.refine_mesh();
  });
  append_domain(triangulation, mesh);
  return run;
}

// those that can mesh the sample, for about `size` triangles
inline std::vector<Sample_mesher> meshers_of(const Sample& sample, double size)
{
  if(sample.name == "flat") {
    const std::vector<Point_2> polygon = divided_square(parts_of_side(sample.edge_length(size)));
    return {{"Delaunay_mesher_2",
             [polygon](double edge_length, Sample_mesh& mesh) { return mesh_polygon(polygon, edge_length, mesh); }}};
  }
  if(sample.name == "sphere" || sample.name == "torus") {
    const Distance distance = distance_to(sample.name);
    return {{"make_surface_mesh",
             // The radius alone decides: a ball is not farther from its circle than its radius.
             [distance](double edge_length, Sample_mesh& mesh) {
               return mesh_implicit(distance, radius_of(edge_length), radius_of(edge_length), mesh);
             }}};
  }
  return {};
}

} // namespace cgal_meshers

#endif // CGAL_MESHERS_H
