// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// make_parametric_surface_mesh() beside CGAL's own meshers, on what both can do: on a sphere, a torus and a tin, of which CGAL's are given
// the zero set of a function, or a finer mesh to remesh; and in a square in the plane. They are asked for the same number of triangles,
// and for the same distance from the surface.

#include "Benchmark_settings.h"
#include "Comparison_run.h"
#include "Comparison_shape.h"
#include "Text_table.h"
#include "cgal_meshers.h"
#include "write_comparison.h"

#ifdef WITH_REMESHERS
#include "cgal_remeshers.h"
#endif

#include <CGAL/make_model_of_rectangular_patches.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

typedef Sample_mesh Mesh;

struct Settings : Benchmark_settings
{
  std::vector<double> distances = {5e-4};
  std::string json;

  Settings()
    : Benchmark_settings(
        "Usage: compare_with_cgal_mesher [SIZE...] [OPTIONS]\n"
        "Meshes a sphere, a torus, a tin and a square by this package and by CGAL's make_surface_mesh(), Delaunay_mesher_2 and, if built\n"
        "so, make_mesh_3() and remeshers: with about SIZE triangles, and with the same distance from the surface. Prints both tables.\n"
        "Times are processor times, user and system, without that of the finer mesh that remeshers start from. \"time\" is a multiple\n"
        "of that of this package.\n",
        {10000})
  {
    using boost::program_options::value;
    options().add_options()
      ("distances", value(&distances)->multitoken(), "largest distances from surfaces with a radius of 1 (0.0005)")
      ("json", value(&json), "a file for plot_comparison.py; takes longer, as meshes of other sizes are made for it");
  }
};

Mesher_run mesh_model(const Comparison_shape& shape, const Mesh_sizes& sizes, Mesh& mesh)
{
  auto criteria = CGAL::Parametric_surface_mesh_criteria().set_max_edge(sizes.edge_length);
  // Who asks for a distance wants no more triangles than that needs: they may grow in a flat lid, as those of the others do.
  const double growth = 0.2;
  if(sizes.distance)
    criteria.set_distance(*sizes.distance).set_growth(growth);
  return run_of([&] { CGAL::make_parametric_surface_mesh(shape.model, criteria, mesh); });
}

Comparison_mesher parametric_mesher(const Comparison_shape& shape)
{
  return {"make_parametric_surface_mesh",
          [&shape](const Mesh_sizes& sizes, Mesh& mesh) { return mesh_model(shape, sizes, mesh); }};
}

// All meshers for a shape in space; remeshers start from `fine`.
std::vector<Comparison_mesher> meshers_of(const Comparison_shape& shape, [[maybe_unused]] const Mesh& fine)
{
  std::vector<Comparison_mesher> meshers = {parametric_mesher(shape)};
  meshers.push_back({"make_surface_mesh", [&shape](const Mesh_sizes& sizes, Mesh& mesh) {
                       const double radius = cgal_meshers::radius_of(sizes.edge_length);
                       return cgal_meshers::mesh_implicit(shape.distance, radius, sizes.distance.value_or(radius), mesh);
                     }});
#ifdef WITH_REMESHERS
  using namespace cgal_remeshers;
  meshers.push_back(
    {"make_mesh_3", [&shape](const Mesh_sizes& sizes, Mesh& mesh) { return mesh_boundary_of_solid(shape, sizes, mesh); }});
  meshers.push_back(
    {"isotropic_remeshing", [&](const Mesh_sizes& sizes, Mesh& mesh) { return remesh(fine, shape, sizes, mesh); }});
#if CGAL_VERSION_NR >= 1060000000
  meshers.push_back(
    {"isotropic_remeshing, adaptive", [&](const Mesh_sizes& sizes, Mesh& mesh) { return remesh_adaptively(fine, sizes, mesh); }});
  meshers.push_back({"surface_Delaunay_remeshing",
                     [&](const Mesh_sizes& sizes, Mesh& mesh) { return remesh_by_delaunay(fine, shape, sizes, mesh); }});
#endif
#endif
  return meshers;
}

// Times by turns, so that what else the machine does falls on all.
void measure(const std::vector<Comparison_mesher>& meshers, std::size_t repeat, std::vector<Comparison_run>& runs)
{
  for(std::size_t i = 0; i < repeat; ++i)
    for(std::size_t k = 0; k < runs.size(); ++k) {
      const comparison::Cost cost = comparison::cost_of(meshers[k], runs[k].sizes);
      runs[k].seconds.push_back(cost.seconds);
      runs[k].memory = cost.memory;
    }
}

Text_table::Line line(const Comparison_run& run, const Comparison_run& own, const Comparison_shape& shape)
{
  std::vector<double> ratios;
  for(std::size_t i = 0; i < run.seconds.size(); ++i)
    ratios.push_back(run.seconds[i] / own.seconds[i]);
  const Comparison_verdict& v = run.verdict;
  return {run.shape + ", " + run.mesher, text("%.0f", v.faces), text("%.3g", median(run.seconds)), text("%.3g", median(ratios)),
          text("%.1f", v.min_angle), text("%.1f", v.mean_min_angle), text("%.2f", 100 * v.share_below_30_degrees),
          text("%.4f", v.mean_radius_ratio), text("%.1e", v.distance),
          shape.rims.empty() ? "-" : text("%.0f %%", 100 * v.share_of_rims), text("%.0f", run.memory / v.faces)};
}

Text_table empty_table()
{
  return Text_table({"shape, mesher", "triangles", "seconds", "time", "min angle", "mean min", "% < 30 deg", "mean 2r/R", "distance",
                     "rims kept", "bytes/tri"});
}

struct Comparison
{
  Text_table with_triangles = empty_table(), with_distance = empty_table();
  nlohmann::json runs = nlohmann::json::array(), details = nlohmann::json::array();

  Text_table& table(const Comparison_target& target)
  {
    return target.kind == Comparison_target::TRIANGLES ? with_triangles : with_distance;
  }

  void print(std::ostream& out, Text_table::Format format) const
  {
    out << "As many triangles:\n\n";
    with_triangles.print(out, format);
    out << "\nThe same distance:\n\n";
    with_distance.print(out, format);
  }
};

// The edge length to begin with. Triangles with edges of length L are L^2 / 6 off a sphere of radius 1.
double first_edge_length(const Comparison_target& target, const Comparison_shape& shape)
{
  return target.kind == Comparison_target::TRIANGLES ? shape.edge_length(target.value) : std::sqrt(6 * target.value);
}

// What remeshers start from: edges of a third of the shortest ones that are wanted. Shorter edges change the results little.
Mesh fine_mesh(const Comparison_target& target, const Comparison_shape& shape)
{
  const double wanted = first_edge_length(target, shape);
  const double shortest = target.kind == Comparison_target::TRIANGLES ? wanted : wanted * std::sqrt(shape.smallest_radius);
  Mesh mesh;
  mesh_model(shape, {shortest / 3, {}}, mesh);
  return mesh;
}

// Where it is sharp, a mesh is worth a look.
void add_details(const std::vector<Comparison_mesher>& meshers, const std::vector<Comparison_run>& runs, nlohmann::json& details)
{
  const comparison::Point_3 on_rim(1, 0, comparison_shapes::height_of_tin);
  for(std::size_t k = 0; k < runs.size(); ++k) {
    Mesh mesh;
    meshers[k].run(runs[k].sizes, mesh);
    details.push_back({{"mesher", runs[k].mesher}, {"triangles", json_of_triangles(mesh, on_rim, 0.4)}});
  }
}

void compare(const Comparison_target& target, const Comparison_shape& shape, const Settings& settings, Comparison& result)
{
  const Mesh fine = fine_mesh(target, shape);
  const std::vector<comparison::Point_3> points = comparison::points_of_surface(fine, shape);
  const std::vector<Comparison_mesher> meshers = meshers_of(shape, fine);
  std::vector<Comparison_run> runs;
  for(const Comparison_mesher& mesher : meshers)
    runs.push_back(calibrated_run(mesher, shape, target, first_edge_length(target, shape), points, 6));
  measure(meshers, settings.repeat, runs);
  for(const Comparison_run& run : runs) {
    result.table(target).add_line(line(run, runs.front(), shape));
    result.runs.push_back(json_of(run));
  }
  if(!settings.json.empty() && target.kind == Comparison_target::TRIANGLES && !shape.rims.empty())
    add_details(meshers, runs, result.details);
}

// Triangles against distance, whatever both are for a series of bounds.
void add_series(const Comparison_shape& shape, Comparison& result)
{
  for(const double distance : {1e-2, 3e-3, 1e-3, 3e-4}) {
    const Comparison_target target{Comparison_target::DISTANCE, distance};
    const Mesh fine = fine_mesh(target, shape);
    const std::vector<comparison::Point_3> points = comparison::points_of_surface(fine, shape);
    for(const Comparison_mesher& mesher : meshers_of(shape, fine)) {
      nlohmann::json run = json_of(calibrated_run(mesher, shape, target, first_edge_length(target, shape), points, 1));
      run["target"] = "series";
      result.runs.push_back(run);
    }
  }
}

// A square in the plane, its sides divided as by this package: Delaunay_mesher_2 may divide them further.
void compare_in_plane(double size, const Settings& settings, Comparison& result)
{
  const std::vector<sample_surfaces::Patch> patches = {sample_surfaces::whole_patch(make_sample("flat"))};
  const auto model = CGAL::make_model_of_rectangular_patches(patches);
  const Comparison_shape square{"square", sample_surface_model(model), 1, cgal_meshers::distance_to("flat"), 1};
  const Comparison_target target{Comparison_target::TRIANGLES, size};
  const auto polygon = cgal_meshers::divided_square(cgal_meshers::parts_of_side(square.edge_length(size)));
  const std::vector<Comparison_mesher> meshers = {
    parametric_mesher(square), {"Delaunay_mesher_2", [polygon](const Mesh_sizes& sizes, Mesh& mesh) {
                                  return cgal_meshers::mesh_polygon(polygon, sizes.edge_length, mesh);
                                }}};
  std::vector<Comparison_run> runs;
  for(const Comparison_mesher& mesher : meshers)
    runs.push_back(calibrated_run(mesher, square, target, square.edge_length(size), {Sample_surface::Point_3(0, 0, 0)}, 6));
  measure(meshers, settings.repeat, runs);
  for(const Comparison_run& run : runs)
    result.table(target).add_line(line(run, runs.front(), square));
}

Comparison compare_all(const Settings& settings)
{
  std::ofstream out;
  if(!settings.json.empty()) { // before all the work
    out.open(settings.json);
    if(!out)
      throw std::runtime_error("cannot write " + settings.json);
  }
  Comparison result;
  const std::vector<Comparison_shape> shapes = comparison_shapes_of_space();
  for(const double size : settings.sizes) {
    for(const Comparison_shape& shape : shapes)
      compare({Comparison_target::TRIANGLES, size}, shape, settings, result);
    compare_in_plane(size, settings, result);
  }
  for(const double distance : settings.distances)
    for(const Comparison_shape& shape : shapes)
      compare({Comparison_target::DISTANCE, distance}, shape, settings, result);
  if(settings.json.empty())
    return result;
  for(const Comparison_shape& shape : shapes)
    add_series(shape, result);
  out << nlohmann::json{{"runs", result.runs}, {"details", result.details}} << "\n";
  if(!out.flush())
    throw std::runtime_error("cannot write " + settings.json);
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  Settings settings;
  return run_benchmark(argc, argv, settings, [&] { return compare_all(settings); });
}
