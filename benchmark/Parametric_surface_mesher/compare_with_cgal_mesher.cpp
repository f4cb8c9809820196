// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// make_parametric_surface_mesh() beside CGAL's own meshers, on what both can do: make_surface_mesh() and make_mesh_3() on the sphere and
// the torus as implicit surfaces, Delaunay_mesher_2 on the flat square, and remeshers of a finer mesh. All are asked for the same number
// of triangles, and for 30 degrees if they can be asked.

#include "Benchmark_settings.h"
#include "Sample_mesher.h"
#include "Text_table.h"
#include "cgal_meshers.h"
#include "measure.h"

#ifdef WITH_REMESHERS
#include "cgal_remeshers.h"
#endif

#include <CGAL/Triangle_mesh_quality.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

typedef cgal_meshers::Distance Distance;
typedef Sample_mesh Mesh;

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

Sample_mesher parametric_mesher(const Sample& sample)
{
  return {"make_parametric_surface_mesh", [sample](double edge_length, Mesh& mesh) {
            const auto criteria = CGAL::Parametric_surface_mesh_criteria().set_max_edge(edge_length);
            return run_of([&] { CGAL::make_parametric_surface_mesh(sample.surface, sample.domain, criteria, mesh); });
          }};
}

struct Competitor
{
  Sample_mesher mesher;
  double edge_length = 0;
  std::vector<double> seconds = {};
};

void measure(Competitor& competitor)
{
  competitor.seconds.push_back(mean_seconds([&] {
    Mesh mesh;
    return competitor.mesher.run(competitor.edge_length, mesh).seconds;
  }));
}

Text_table::Line line(const Sample& sample, const Competitor& competitor, const Distance& distance)
{
  Mesh mesh;
  competitor.mesher.run(competitor.edge_length, mesh);
  const CGAL::Triangle_mesh_quality quality = CGAL::triangle_mesh_quality(mesh);
  const double faces = static_cast<double>(quality.number_of_faces), seconds = median(competitor.seconds);
  return {sample.name + ", " + competitor.mesher.name, text("%.0f", faces), text("%.3g", seconds), text("%.0f", faces / seconds),
          text("%.2f", quality.min_angle), text("%.2f", quality.mean_min_angle), text("%.4f", quality.mean_radius_ratio),
          text("%.2e", deviation(mesh, distance))};
}

// Times the meshers by turns.
void compare(const std::string& name, double size, const Benchmark_settings& settings, Text_table& table)
{
  const Sample sample = make_sample(name);
  const Distance distance = cgal_meshers::distance_to(name);
  std::vector<Competitor> competitors = {{parametric_mesher(sample)}};
  for(const Sample_mesher& mesher : cgal_meshers::meshers_of(sample, size))
    competitors.push_back({mesher});
#ifdef WITH_REMESHERS
  for(const Sample_mesher& mesher : cgal_remeshers::meshers_of(sample, size))
    competitors.push_back({mesher});
#endif
  for(Competitor& competitor : competitors)
    competitor.edge_length = calibrated_edge_length(competitor.mesher, sample, size);
  for(std::size_t i = 0; i < settings.repeat; ++i)
    for(Competitor& competitor : competitors)
      measure(competitor);
  for(const Competitor& competitor : competitors)
    table.add_line(line(sample, competitor, distance));
}

const char usage[] =
  "Usage: compare_with_cgal_mesher [SIZE...] [OPTIONS]\n"
  "Meshes the sphere, the torus and the flat square with about SIZE triangles by this package and by CGAL's\n"
  "make_surface_mesh(), Delaunay_mesher_2 and, if built so, make_mesh_3() and remeshers, and prints speeds and shapes.\n"
  "Times are processor times, user and system, without that of the finer mesh that remeshers start from. The deviation is\n"
  "the largest distance from the surface, at middles of edges and centroids.\n";

} // namespace

int main(int argc, char** argv)
{
  Benchmark_settings settings(usage, {50000});
  return run_benchmark(argc, argv, settings, [&] {
    Text_table table({"surface, mesher", "triangles", "seconds", "tri/s", "min angle", "mean min", "mean 2r/R", "deviation"});
    for(const double size : settings.sizes)
      for(const char* name : {"sphere", "torus", "flat"})
        compare(name, size, settings, table);
    return table;
  });
}
