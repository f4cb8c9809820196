// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Speed, shape and memory of make_parametric_surface_mesh() on the sample surfaces, as one table, with other meshers beside
// it if wanted. A speed depends on the machine; so CGAL's range insertion into a constrained Delaunay triangulation with as
// many triangles is timed by turns with the meshing, and the ratio of the two is what counts.
#include "Benchmark_settings.h"
#include "Sample_mesher.h"
#include "Text_table.h"
#include "bare_insertion.h"
#include "cgal_meshers.h"
#include "gmsh_meshers.h"
#include "measure.h"

#include <CGAL/Random.h>
#include <CGAL/Triangle_mesh_quality.h>
#include <CGAL/algorithm.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <boost/program_options.hpp>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

typedef Sample_kernel::Point_2 Point_2;
typedef CGAL::Parametric_surface_mesh_report Report;

const double reference_size = 50000; // the time per triangle of other sizes is compared with that of this one

struct Settings : Benchmark_settings
{
  std::vector<std::string> surfaces;
  std::string placement;
  bool is_unimproved = false;
  bool inserts_domain_points = false;
  bool has_peers = false;

  Settings();
};

// medians over the repetitions, and what is the same in each
struct Result
{
  double seconds, insertion_seconds, ratio; // ratio of the times per triangle
  Report::Seconds phases;                   // sums over all runs, 0 for other meshers
  CGAL::Triangle_mesh_quality quality;
  std::size_t boundary_limited, unmet;
  double bytes_per_triangle;

  double number_of_triangles() const { return static_cast<double>(quality.number_of_faces); }
  double seconds_per_triangle() const { return seconds / number_of_triangles(); }
};

struct Row
{
  std::string surface;
  std::string peer; // empty for this package's mesher
  double size;
  Result result;
};

CGAL::Parametric_surface_mesher::Mesh_point_placement placement(const std::string& name)
{
  if(name == "frontal")
    return CGAL::Parametric_surface_mesher::Mesh_point_placement::FRONTAL;
  if(name == "off-center")
    return CGAL::Parametric_surface_mesher::Mesh_point_placement::OFF_CENTER;
  if(name == "circumcenter")
    return CGAL::Parametric_surface_mesher::Mesh_point_placement::CIRCUMCENTER;
  throw std::invalid_argument("--placement must be frontal, off-center or circumcenter");
}

CGAL::Parametric_surface_mesh_criteria criteria_for(double edge_length, const Settings& settings)
{
  CGAL::Parametric_surface_mesh_criteria result;
  result.set_max_edge(edge_length).set_placement(placement(settings.placement));
  if(settings.is_unimproved)
    result.set_max_number_of_sweeps(0).set_improvement_angle(0);
  return result;
}

Sample_mesher parametric_mesher(const Sample& sample, const Settings& settings)
{
  return {"", [&](double edge_length, Sample_mesh& mesh) {
            Report report;
            Mesher_run run = run_of([&] {
              report = CGAL::make_parametric_surface_mesh(sample.surface, sample.domain, criteria_for(edge_length, settings),
                                                          mesh);
            });
            run.report = report;
            return run;
          }};
}

std::vector<Sample_mesher> peers(const Sample& sample, double size)
{
  std::vector<Sample_mesher> result = cgal_meshers::meshers_of(sample, size);
  for(const Sample_mesher& mesher : gmsh_meshers::meshers_of(sample))
    result.push_back(mesher);
  return result;
}

void add(const Report::Seconds& seconds, Report::Seconds& sum)
{
  sum.division += seconds.division;
  sum.triangulation += seconds.triangulation;
  sum.refinement += seconds.refinement;
  sum.improvement += seconds.improvement;
  sum.output += seconds.output;
}

void measure_mesh(const Sample_mesher& mesher, double edge_length, Result& result)
{
  Sample_mesh mesh;
  const Mesher_run run = mesher.run(edge_length, mesh);
  result.quality = CGAL::triangle_mesh_quality(mesh);
  result.bytes_per_triangle = run.memory / result.number_of_triangles();
  if(run.report) {
    result.boundary_limited = run.report->count(CGAL::Parametric_surface_mesher::Unmet_cause::BOUNDARY);
    result.unmet = run.report->unmet.size() - result.boundary_limited;
  }
}

// the domain points of this package's mesh, in random order
std::vector<Point_2> domain_points(const Sample& sample, double size, const Settings& settings)
{
  Sample_mesh mesh;
  const auto uv = mesh.add_property_map<Sample_mesh::Vertex_index, Point_2>("v:uv").first;
  CGAL::make_parametric_surface_mesh(sample.surface, sample.domain, criteria_for(sample.edge_length(size), settings), mesh,
                                     CGAL::parameters::vertex_uv_map(uv));
  std::vector<Point_2> points;
  for(const Sample_mesh::Vertex_index v : mesh.vertices())
    points.push_back(uv[v]);
  CGAL::Random random(1);
  CGAL::cpp98::random_shuffle(points.begin(), points.end(), random);
  return points;
}

void measure_times(const Sample_mesher& mesher, double edge_length, const std::vector<Point_2>& points, std::size_t repeat,
                   Result& result)
{
  const auto mesh_once = [&] {
    Sample_mesh mesh;
    const Mesher_run run = mesher.run(edge_length, mesh);
    if(run.report)
      add(run.report->seconds, result.phases);
    return run.seconds;
  };
  const auto insert_once = [&] { return result.number_of_triangles() * bare_insertion::seconds_per_triangle(points); };

  std::vector<double> seconds, insertion_seconds, ratios;
  for(std::size_t i = 0; i < repeat; ++i) {
    insertion_seconds.push_back(mean_seconds(insert_once));
    seconds.push_back(mean_seconds(mesh_once));
    ratios.push_back(seconds.back() / insertion_seconds.back());
  }
  result.seconds = median(seconds);
  result.insertion_seconds = median(insertion_seconds);
  result.ratio = median(ratios);
}

// Child processes keep what one mesher leaves in memory from the others.
Result measure(const Sample& sample, const Sample_mesher& mesher, double edge_length, double size, const Settings& settings)
{
  return in_child_process([&] {
    Result result = Result();
    measure_mesh(mesher, edge_length, result);
    const std::vector<Point_2> points
      = settings.inserts_domain_points ? domain_points(sample, size, settings)
                                       : bare_insertion::random_points(result.quality.number_of_faces);
    measure_times(mesher, edge_length, points, settings.repeat, result);
    return result;
  });
}

void check_same_surface(const Row& row, const Result& result)
{
  if(std::abs(row.result.quality.area / result.quality.area - 1) > 0.05)
    throw std::runtime_error(row.peer + " has meshed another surface than " + row.surface + ": the area is "
                             + text("%g", row.result.quality.area) + " instead of " + text("%g", result.quality.area));
}

// Of other meshers, the edge length is such that they make as many triangles.
void measure(const Sample& sample, double size, const Settings& settings, std::vector<Row>& rows)
{
  const Sample_mesher mesher = parametric_mesher(sample, settings);
  const Result result = measure(sample, mesher, sample.edge_length(size), size, settings);
  rows.push_back({sample.name, mesher.name, size, result});
  if(!settings.has_peers)
    return;
  for(const Sample_mesher& peer : peers(sample, size)) {
    const double edge_length
      = in_child_process([&] { return calibrated_edge_length(peer, sample, result.number_of_triangles()); });
    rows.push_back({sample.name, peer.name, size, measure(sample, peer, edge_length, size, settings)});
    check_same_surface(rows.back(), result);
    std::cerr << "," << std::flush;
  }
}

Text_table make_table()
{
  return Text_table({"surface", "triangles", "seconds", "tri/s", "CDT tri/s", "ratio", "div. %", "triang. %", "refin. %",
                     "improv. %", "output %", "min angle", "mean min", "mean 2r/R", "< 30 deg", "bnd-limited", "unmet",
                     "bytes/tri", "to 50k"});
}

// the time per triangle, as a multiple of that at the reference size
std::string growth(const Row& row, const std::vector<Row>& rows)
{
  for(const Row& other : rows)
    if(other.surface == row.surface && other.peer == row.peer && other.size == reference_size)
      return text("%.2f", row.result.seconds_per_triangle() / other.result.seconds_per_triangle());
  return "-";
}

void add_line(const Row& row, const std::vector<Row>& rows, Text_table& table)
{
  const Result& r = row.result;
  const double faces = r.number_of_triangles();
  const bool is_peer = !row.peer.empty();
  const auto percent = [&](double seconds) { return is_peer ? "-" : text("%.1f", 100 * seconds / r.phases.meshing()); };
  const auto count = [&](std::size_t n) { return is_peer ? "-" : std::to_string(n); };
  table.add_line({is_peer ? row.surface + ", " + row.peer : row.surface, text("%.0f", faces), text("%.3g", r.seconds),
                  text("%.0f", faces / r.seconds), text("%.0f", faces / r.insertion_seconds), text("%.2f", r.ratio),
                  percent(r.phases.division), percent(r.phases.triangulation), percent(r.phases.refinement),
                  percent(r.phases.improvement), percent(r.phases.output), text("%.2f", r.quality.min_angle),
                  text("%.2f", r.quality.mean_min_angle), text("%.4f", r.quality.mean_radius_ratio),
                  text("%.0f", r.quality.share_below_30_degrees * faces), count(r.boundary_limited), count(r.unmet),
                  text("%.0f", r.bytes_per_triangle), growth(row, rows)});
}

const char usage[] =
  "Usage: performance [SIZE...] [OPTIONS]\n"
  "Prints speed, shape and memory of the meshes of the sample surfaces with about SIZE triangles. Times are processor\n"
  "times, user and system, those of the phases in percent of their sum. The ratio is that to the time\n"
  "in which points are inserted into a constrained Delaunay triangulation of as many triangles. The last column is\n"
  "the time per triangle over that with the size 50000, if that is among the sizes.\n";

Settings::Settings()
  : Benchmark_settings(usage, {5000, 50000, 500000})
{
  using namespace boost::program_options;
  options().add_options()
    ("surfaces", value(&surfaces)->multitoken()->default_value(sample_names(), "all"), "names of sample surfaces")
    ("placement", value(&placement)->default_value("frontal"), "frontal, off-center or circumcenter")
    ("unimproved", bool_switch(&is_unimproved), "without smoothing sweeps and improvement of the worst triangles")
    ("domain-points", bool_switch(&inserts_domain_points), "inserts the domain points of the mesh instead of random points")
    ("peers", bool_switch(&has_peers),
     "with CGAL's own meshers and Gmsh, where they can mesh the surface, asked for as many triangles");
}

Text_table measure_all(const Settings& settings)
{
  std::vector<Row> rows;
  for(const double size : settings.sizes)
    for(const std::string& name : settings.surfaces) {
      measure(make_sample(name), size, settings, rows);
      std::cerr << "." << std::flush;
    }
  std::cerr << "\n";
  Text_table table = make_table();
  for(const Row& row : rows)
    add_line(row, rows, table);
  return table;
}

} // namespace

int main(int argc, char** argv)
{
  Settings settings;
  return run_benchmark(argc, argv, settings, [&] { return measure_all(settings); });
}
