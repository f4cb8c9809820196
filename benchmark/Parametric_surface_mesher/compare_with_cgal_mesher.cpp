// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// make_parametric_surface_mesh() beside CGAL's own meshers, on what both can do: make_surface_mesh() on the sphere and the torus
// as implicit surfaces, Delaunay_mesher_2 on the flat square. All are asked for 30 degrees and the same number of triangles.

// CGAL 6 calls the package of make_surface_mesh() deprecated.
#define CGAL_NO_DEPRECATION_WARNINGS 1

#include "Benchmark_settings.h"
#include "Sample_surfaces.h"
#include "Text_table.h"
#include "measure.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_complex_2_in_triangulation_3.h>
#include <CGAL/Surface_mesh_default_criteria_3.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/Triangle_mesh_quality.h>
#include <CGAL/make_parametric_surface_mesh.h>
#include <CGAL/make_surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace {

typedef Sample_kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef std::function<double(const Point_3&)> Distance;
// meshes with a wanted edge length, and returns the time without that of the conversion to `Mesh`
typedef std::function<double(double edge_length, Mesh& mesh)> Mesher;

// signed distances to the sample surfaces
double distance_to_sphere(const Point_3& p) { return std::sqrt(p.x() * p.x() + p.y() * p.y() + p.z() * p.z()) - 1; }

double distance_to_torus(const Point_3& p)
{
  return std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - 0.3;
}

double distance_to_plane(const Point_3& p) { return p.z(); }

// the largest distance from the surface, over the middles of edges and the centroids
double deviation(const Mesh& mesh, const Distance& distance)
{
  double worst = 0;
  for(const Mesh::Edge_index e : mesh.edges())
    worst = (std::max)(worst, std::abs(distance(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))))));
  for(const Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    worst = (std::max)(worst, std::abs(distance(CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                                               mesh.point(mesh.target(mesh.next(h)))))));
  }
  return worst;
}

double mesh_parametric(const Sample& sample, double edge_length, Mesh& mesh)
{
  const auto criteria = CGAL::Parametric_surface_mesh_criteria().set_max_edge(edge_length);
  return seconds_of([&] { CGAL::make_parametric_surface_mesh(sample.surface, sample.domain, criteria, mesh); });
}

double mesh_implicit(const Distance& function, double edge_length, Mesh& mesh)
{
  typedef CGAL::Surface_mesh_default_triangulation_3 Triangulation;
  typedef Triangulation::Geom_traits Traits;
  typedef CGAL::Implicit_surface_3<Traits, Distance> Surface;
  const Surface surface(function, Traits::Sphere_3(CGAL::ORIGIN, 4));
  // the radius alone decides the size: the bound of the distance is that of the centre of a circle with this radius
  const double radius = edge_length / std::sqrt(3.);
  const CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(30, radius, radius);
  Triangulation triangulation;
  CGAL::Surface_mesh_complex_2_in_triangulation_3<Triangulation> complex(triangulation);
  const double seconds = seconds_of([&] { CGAL::make_surface_mesh(complex, surface, criteria, CGAL::Non_manifold_tag()); });
  CGAL::facets_in_complex_2_to_triangle_mesh(complex, mesh);
  return seconds;
}

template <class Triangulation>
void append_domain(const Triangulation& triangulation, Mesh& mesh)
{
  std::map<typename Triangulation::Vertex_handle, Mesh::Vertex_index> vertices;
  for(const auto v : triangulation.finite_vertex_handles())
    vertices[v] = mesh.add_vertex(Point_3(v->point().x(), v->point().y(), 0));
  for(const auto f : triangulation.finite_face_handles())
    if(f->is_in_domain())
      mesh.add_face(vertices[f->vertex(0)], vertices[f->vertex(1)], vertices[f->vertex(2)]);
}

double mesh_unit_square(double edge_length, Mesh& mesh)
{
  typedef CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Sample_kernel>,
                                               CGAL::Delaunay_mesh_face_base_2<Sample_kernel>> Tds;
  typedef CGAL::Constrained_Delaunay_triangulation_2<Sample_kernel, Tds> Triangulation;
  typedef CGAL::Delaunay_mesh_size_criteria_2<Triangulation> Criteria;
  typedef Sample_kernel::Point_2 Point_2;
  const double squared_sine_of_30_degrees = 0.25;
  const std::vector<Point_2> square = {Point_2(0, 0), Point_2(1, 0), Point_2(1, 1), Point_2(0, 1)};
  Triangulation triangulation;
  const double seconds = seconds_of([&] {
    triangulation.insert_constraint(square.begin(), square.end(), true);
    CGAL::Delaunay_mesher_2<Triangulation, Criteria> mesher(triangulation, Criteria(squared_sine_of_30_degrees, edge_length));
    mesher.refine_mesh();
  });
  append_domain(triangulation, mesh);
  return seconds;
}

// The edge length for `size` triangles, whatever a mesher makes of it: their number goes with its inverse square.
double calibrated_edge_length(const Mesher& mesher, const Sample& sample, double size)
{
  Mesh mesh;
  mesher(sample.edge_length(size), mesh);
  return sample.edge_length(size) * std::sqrt(num_faces(mesh) / size);
}

struct Competitor
{
  std::string name;
  Mesher mesher;
  double edge_length = 0;
  std::vector<double> seconds = {};
};

void measure(Competitor& competitor)
{
  competitor.seconds.push_back(mean_seconds([&] {
    Mesh mesh;
    return competitor.mesher(competitor.edge_length, mesh);
  }));
}

Text_table::Line line(const Sample& sample, const Competitor& competitor, const Distance& distance)
{
  Mesh mesh;
  competitor.mesher(competitor.edge_length, mesh);
  const CGAL::Triangle_mesh_quality quality = CGAL::triangle_mesh_quality(mesh);
  const double faces = static_cast<double>(quality.number_of_faces), seconds = median(competitor.seconds);
  return {sample.name + ", " + competitor.name, text("%.0f", faces), text("%.3g", seconds), text("%.0f", faces / seconds),
          text("%.2f", quality.min_angle), text("%.2f", quality.mean_min_angle), text("%.4f", quality.mean_radius_ratio),
          text("%.2e", deviation(mesh, distance))};
}

// Times the two by turns.
void compare(const std::string& name, Competitor other, const Distance& distance, double size,
             const Benchmark_settings& settings, Text_table& table)
{
  const Sample sample = make_sample(name);
  std::vector<Competitor> competitors
    = {{"make_parametric_surface_mesh", [&](double length, Mesh& mesh) { return mesh_parametric(sample, length, mesh); }}, other};
  for(Competitor& competitor : competitors)
    competitor.edge_length = calibrated_edge_length(competitor.mesher, sample, size);
  for(std::size_t i = 0; i < settings.repeat; ++i)
    for(Competitor& competitor : competitors)
      measure(competitor);
  for(const Competitor& competitor : competitors)
    table.add_line(line(sample, competitor, distance));
}

void compare_all(double size, const Benchmark_settings& settings, Text_table& table)
{
  for(const auto& surface : std::map<std::string, Distance>{{"sphere", distance_to_sphere}, {"torus", distance_to_torus}}) {
    const Distance& distance = surface.second;
    compare(surface.first,
            {"make_surface_mesh", [&](double length, Mesh& mesh) { return mesh_implicit(distance, length, mesh); }}, distance,
            size, settings, table);
  }
  compare("flat", {"Delaunay_mesher_2", mesh_unit_square}, distance_to_plane, size, settings, table);
}

const char usage[] =
  "Usage: compare_with_cgal_mesher [SIZE...] [OPTIONS]\n"
  "Meshes the sphere, the torus and the flat square with about SIZE triangles by this package and by CGAL's\n"
  "make_surface_mesh() and Delaunay_mesher_2, and prints speeds and shapes. Times are processor times, user and\n"
  "system. The deviation is the largest distance from the surface, at middles of edges and centroids.\n";

} // namespace

int main(int argc, char** argv)
{
  Benchmark_settings settings(usage, {50000});
  return run_benchmark(argc, argv, settings, [&] {
    Text_table table({"surface, mesher", "triangles", "seconds", "tri/s", "min angle", "mean min", "mean 2r/R", "deviation"});
    for(const double size : settings.sizes)
      compare_all(size, settings, table);
    return table;
  });
}
