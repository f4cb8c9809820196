// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Speed, shape and memory of make_parametric_surface_mesh() on the sample surfaces, as one table. A speed depends on the machine;
// so CGAL's range insertion into a constrained Delaunay triangulation with as many triangles is timed by turns
// with the meshing, and the ratio of the two is what counts.
#include "Benchmark_settings.h"
#include "Sample_surfaces.h"
#include "Text_table.h"
#include "measure.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangle_mesh_quality.h>
#include <CGAL/algorithm.h>
#include <CGAL/make_parametric_surface_mesh.h>
#include <CGAL/point_generators_2.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

typedef Sample_kernel::Point_2 Point_2;
typedef CGAL::Surface_mesh<Sample_kernel::Point_3> Mesh;
typedef CGAL::Constrained_Delaunay_triangulation_2<Sample_kernel> Triangulation;
typedef CGAL::Parametric_surface_mesh_report Report;

struct Settings : Benchmark_settings
{
  std::vector<std::string> surfaces;
  std::string placement;
  bool is_unimproved = false;
  bool inserts_domain_points = false;

  Settings();
};

// medians over the repetitions, and what is the same in each
struct Result
{
  double seconds, insertion_seconds, ratio; // ratio of the times per triangle
  Report::Seconds phases;                   // sums over all runs
  CGAL::Triangle_mesh_quality quality;
  std::size_t boundary_limited, unmet;
  double bytes_per_triangle;
};

CGAL::Mesh_point_placement placement(const std::string& name)
{
  if(name == "frontal")
    return CGAL::Mesh_point_placement::FRONTAL;
  if(name == "off-center")
    return CGAL::Mesh_point_placement::OFF_CENTER;
  if(name == "circumcenter")
    return CGAL::Mesh_point_placement::CIRCUMCENTER;
  throw std::invalid_argument("--placement must be frontal, off-center or circumcenter");
}

CGAL::Parametric_surface_mesh_criteria criteria_for(const Sample& sample, double size, const Settings& settings)
{
  CGAL::Parametric_surface_mesh_criteria result;
  result.set_max_edge(sample.edge_length(size)).set_placement(placement(settings.placement));
  if(settings.is_unimproved)
    result.set_max_number_of_sweeps(0).set_improvement_angle(0);
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

void measure_mesh(const Sample& sample, double size, const Settings& settings, Result& result)
{
  const double memory_before = peak_memory();
  Mesh mesh;
  const Report report = CGAL::make_parametric_surface_mesh(sample.surface, sample.domain, criteria_for(sample, size, settings), mesh);
  result.bytes_per_triangle = (peak_memory() - memory_before) / report.number_of_faces;
  result.quality = CGAL::triangle_mesh_quality(mesh);
  result.boundary_limited = report.count(CGAL::Unmet_cause::BOUNDARY);
  result.unmet = report.unmet.size() - result.boundary_limited;
}

// of a triangulation with some `number_of_triangles`: nearly two for each point
std::vector<Point_2> random_points(std::size_t number_of_triangles)
{
  CGAL::Random random(1);
  CGAL::Random_points_in_square_2<Point_2> generator(0.5, random);
  std::vector<Point_2> points;
  std::copy_n(generator, number_of_triangles / 2 + 10, std::back_inserter(points));
  return points;
}

// the domain points of the mesh, in random order
std::vector<Point_2> domain_points(const Sample& sample, double size, const Settings& settings)
{
  Mesh mesh;
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv").first;
  CGAL::make_parametric_surface_mesh(sample.surface, sample.domain, criteria_for(sample, size, settings), mesh,
                                     CGAL::parameters::vertex_uv_map(uv));
  std::vector<Point_2> points;
  for(const Mesh::Vertex_index v : mesh.vertices())
    points.push_back(uv[v]);
  CGAL::Random random(1);
  CGAL::cpp98::random_shuffle(points.begin(), points.end(), random);
  return points;
}

double seconds_per_triangle_of_insertion(const std::vector<Point_2>& points)
{
  Triangulation triangulation;
  const double seconds = seconds_of([&] { triangulation.insert(points.begin(), points.end()); });
  return seconds / triangulation.number_of_faces();
}

void measure_times(const Sample& sample, double size, const Settings& settings, Result& result)
{
  const double number_of_triangles = static_cast<double>(result.quality.number_of_faces);
  const std::vector<Point_2> points
    = settings.inserts_domain_points ? domain_points(sample, size, settings) : random_points(result.quality.number_of_faces);
  const auto mesh_once = [&] {
    Mesh mesh;
    Report report;
    const double seconds = seconds_of([&] {
      report = CGAL::make_parametric_surface_mesh(sample.surface, sample.domain, criteria_for(sample, size, settings), mesh);
    });
    add(report.seconds, result.phases);
    return seconds;
  };
  const auto insert_once = [&] { return number_of_triangles * seconds_per_triangle_of_insertion(points); };

  std::vector<double> seconds, insertion_seconds, ratios;
  for(std::size_t i = 0; i < settings.repeat; ++i) {
    insertion_seconds.push_back(mean_seconds(insert_once));
    seconds.push_back(mean_seconds(mesh_once));
    ratios.push_back(seconds.back() / insertion_seconds.back());
  }
  result.seconds = median(seconds);
  result.insertion_seconds = median(insertion_seconds);
  result.ratio = median(ratios);
}

Result measure(const Sample& sample, double size, const Settings& settings)
{
  Result result = Result();
  measure_mesh(sample, size, settings, result);
  measure_times(sample, size, settings, result);
  return result;
}

Text_table make_table()
{
  return Text_table({"surface", "triangles", "seconds", "tri/s", "CDT tri/s", "ratio", "div. %", "triang. %", "refin. %",
                     "improv. %", "output %", "min angle", "mean min", "mean 2r/R", "< 30 deg", "bnd-limited", "unmet",
                     "bytes/tri"});
}

void add_line(const std::string& name, const Result& r, Text_table& table)
{
  const double faces = static_cast<double>(r.quality.number_of_faces);
  const auto percent = [&](double seconds) { return text("%.1f", 100 * seconds / r.phases.meshing()); };
  table.add_line({name, text("%.0f", faces), text("%.3g", r.seconds), text("%.0f", faces / r.seconds),
                  text("%.0f", faces / r.insertion_seconds), text("%.2f", r.ratio), percent(r.phases.division),
                  percent(r.phases.triangulation), percent(r.phases.refinement), percent(r.phases.improvement),
                  percent(r.phases.output), text("%.2f", r.quality.min_angle), text("%.2f", r.quality.mean_min_angle),
                  text("%.4f", r.quality.mean_radius_ratio), text("%.0f", r.quality.share_below_30_degrees * faces),
                  std::to_string(r.boundary_limited), std::to_string(r.unmet), text("%.0f", r.bytes_per_triangle)});
}

const char usage[] =
  "Usage: performance [SIZE...] [OPTIONS]\n"
  "Prints speed, shape and memory of the meshes of the sample surfaces with about SIZE triangles. Times are processor\n"
  "times, user and system, those of the phases in percent of their sum. The ratio is that to the time\n"
  "in which points are inserted into a constrained Delaunay triangulation of as many triangles.\n";

Settings::Settings()
  : Benchmark_settings(usage, {5000, 50000, 500000})
{
  using namespace boost::program_options;
  options().add_options()
    ("surfaces", value(&surfaces)->multitoken()->default_value(sample_names(), "all"), "names of sample surfaces")
    ("placement", value(&placement)->default_value("frontal"), "frontal, off-center or circumcenter")
    ("unimproved", bool_switch(&is_unimproved), "without smoothing sweeps and improvement of the worst triangles")
    ("domain-points", bool_switch(&inserts_domain_points), "inserts the domain points of the mesh instead of random points");
}

Text_table measure_all(const Settings& settings)
{
  Text_table table = make_table();
  for(const double size : settings.sizes)
    for(const std::string& name : settings.surfaces) {
      const Sample sample = make_sample(name);
      add_line(name, in_child_process([&] { return measure(sample, size, settings); }), table);
      std::cerr << "." << std::flush;
    }
  std::cerr << "\n";
  return table;
}

} // namespace

int main(int argc, char** argv)
{
  Settings settings;
  return run_benchmark(argc, argv, settings, [&] { return measure_all(settings); });
}
