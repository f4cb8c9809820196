// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the time for models grows with the number of faces: make_model_of_rectangular_patches(), validate() and
// make_parametric_surface_mesh() on a closed surface of bicubic patches, each of them with as many triangles whatever their
// number. Then make_model_of_rectangular_patches() alone, on grids many corners of which have the same coordinates.
#include "Benchmark_settings.h"
#include "Sample_surfaces.h"
#include "Text_table.h"
#include "measure.h"

#include <CGAL/Bezier_surface_3.h>
#include <CGAL/Parametric_function_surface_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangle_mesh_quality.h>
#include <CGAL/make_model_of_rectangular_patches.h>
#include <CGAL/make_parametric_surface_mesh.h>
#include <CGAL/Parametric_surface_mesher/validate.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

typedef CGAL::Bezier_surface_3<Sample_kernel> Patch;
typedef CGAL::Parametric_surface_model_3<Patch> Model;
typedef CGAL::Surface_mesh<Sample_kernel::Point_3> Mesh;
typedef CGAL::Parametric_surface_mesh_report Report;

using sample_surfaces::pi;

const double tube_radius = 0.25; // of the torus; that of its middle circle is 1

struct Settings : Benchmark_settings
{
  std::vector<double> triangles_per_face = {50, 10};

  Settings();
};

// a rectangle [0,width] x [0,height], divided into the domains of patches
struct Grid
{
  std::size_t columns, rows;
  double width, height;

  std::size_t number_of_patches() const { return columns * rows; }
  double u(std::size_t column) const { return width * column / columns; }
  double v(std::size_t row) const { return height * row / rows; }
};

// The bicubic patch with the points, first derivatives and mixed derivatives of a surface at the corners of a rectangle.
template <class Surface>
Patch bicubic_patch(const Surface& surface, double u_min, double u_max, double v_min, double v_max)
{
  const std::array<double, 4> steps = {0, 1. / 3, -1. / 3, 0};
  std::vector<Sample_kernel::Point_3> points;
  for(int j = 0; j < 4; ++j)
    for(int i = 0; i < 4; ++i) {
      const auto jet = surface.jet(i < 2 ? u_min : u_max, j < 2 ? v_min : v_max);
      const double a = steps[i] * (u_max - u_min), b = steps[j] * (v_max - v_min);
      points.push_back(jet.point + a * jet.du + b * jet.dv + a * b * jet.duv);
    }
  return Patch(3, 3, points);
}

template <class Surface>
std::vector<Patch> bicubic_patches(const Surface& surface, const Grid& grid)
{
  std::vector<Patch> patches;
  for(std::size_t row = 0; row < grid.rows; ++row)
    for(std::size_t column = 0; column < grid.columns; ++column)
      patches.push_back(bicubic_patch(surface, grid.u(column), grid.u(column + 1), grid.v(row), grid.v(row + 1)));
  return patches;
}

// about `number` patches, nearly square in space
Grid torus_grid(double number)
{
  const double rows = (std::max)(3., std::round(std::sqrt(tube_radius * number))),
               columns = (std::max)(3., std::round(number / rows));
  return {static_cast<std::size_t>(columns), static_cast<std::size_t>(rows), 2 * pi, 2 * pi};
}

// a torus with waves, about five patches long and high in proportion: so patches are alike, whatever their number
std::vector<Patch> wavy_torus(const Grid& grid)
{
  const double height = 0.1 * 2 * pi * tube_radius / grid.rows, a = std::round(0.2 * grid.columns),
               b = std::round(0.2 * grid.rows);
  const auto surface = CGAL::make_parametric_function_surface<Sample_kernel>([=](auto u, auto v) {
    using std::cos;
    using std::sin;
    const auto radius = tube_radius + height * cos(a * u) * cos(b * v);
    const auto distance = 1 + radius * cos(v);
    return CGAL::parametric_surface_point(distance * cos(u), distance * sin(u), radius * sin(v));
  });
  return bicubic_patches(surface, grid);
}

// the length of the edges for so many triangles in all
double torus_edge_length(double number_of_triangles)
{
  return sample_surfaces::edge_length(4 * pi * pi * tube_radius, number_of_triangles);
}

// minima over the repetitions, and what is the same in each
struct Result
{
  double matching = std::numeric_limits<double>::infinity(), validation = matching, meshing = matching;
  Report::Seconds phases = {matching, matching, matching, matching, matching};
  CGAL::Triangle_mesh_quality quality;
  std::size_t boundary_limited = 0, unmet = 0;
  double bytes_per_triangle = 0;
  bool is_right = true; // a closed torus, and nothing unmet but at boundaries
};

void keep_least(double value, double& least)
{
  least = (std::min)(value, least);
}

void keep_least(const Report::Seconds& seconds, Report::Seconds& least)
{
  keep_least(seconds.division, least.division);
  keep_least(seconds.triangulation, least.triangulation);
  keep_least(seconds.refinement, least.refinement);
  keep_least(seconds.improvement, least.improvement);
  keep_least(seconds.output, least.output);
}

void measure_once(const std::vector<Patch>& patches, double edge_length, Result& result)
{
  const double memory_before = peak_memory();
  const double gamma = 0.2; // so that the curvature does not ask for more triangles, however few the faces are
  const auto criteria = CGAL::Parametric_surface_mesh_criteria().set_max_edge(edge_length).set_gamma(gamma);
  Model model;
  Mesh mesh;
  Report report;
  keep_least(seconds_of([&] { model = CGAL::make_model_of_rectangular_patches(patches); }), result.matching);
  keep_least(seconds_of([&] { CGAL::Parametric_surface_mesher::validate(model); }), result.validation);
  keep_least(seconds_of([&] { report = CGAL::make_parametric_surface_mesh(model, criteria, mesh); }), result.meshing);
  keep_least(report.seconds, result.phases);
  const double bytes_per_triangle = (peak_memory() - memory_before) / report.number_of_faces;
  result.bytes_per_triangle = (std::max)(bytes_per_triangle, result.bytes_per_triangle); // grows in the first run alone
  result.quality = CGAL::triangle_mesh_quality(mesh);
  result.boundary_limited = report.count(CGAL::Parametric_surface_mesher::Unmet_cause::BOUNDARY);
  result.unmet = report.unmet.size() - result.boundary_limited;
  const auto& q = result.quality;
  result.is_right = result.is_right && model.edges().size() == 2 * patches.size() && q.is_closed && q.is_manifold
                    && q.number_of_connected_components == 1 && q.euler_characteristic == 0 && result.unmet == 0;
}

Result measure(const Grid& grid, double triangles_per_face, std::size_t repeat)
{
  const std::vector<Patch> patches = wavy_torus(grid);
  const double edge_length = torus_edge_length(triangles_per_face * grid.number_of_patches());
  Result result;
  for(std::size_t i = 0; i < repeat; ++i)
    measure_once(patches, edge_length, result);
  return result;
}

std::string microseconds(double seconds)
{
  return text("%.3g", 1e6 * seconds);
}

// `first`: seconds per face for the first size
Text_table::Line line(std::size_t faces, const Result& r, double first)
{
  const double triangles = static_cast<double>(r.quality.number_of_faces);
  const auto seconds = [](double value) { return text("%.3g", value); };
  return {std::to_string(faces), text("%.0f", triangles), seconds(r.matching), seconds(r.validation),
          seconds(r.phases.division), seconds(r.phases.triangulation), seconds(r.phases.refinement),
          seconds(r.phases.improvement), seconds(r.phases.output), seconds(r.meshing), microseconds(r.meshing / faces),
          microseconds(r.meshing / triangles), text("%.2f", r.meshing / faces / first),
          text("%.2f", r.quality.min_angle), std::to_string(r.boundary_limited), std::to_string(r.unmet),
          text("%.0f", r.bytes_per_triangle)};
}

void complain(const std::string& what, std::size_t faces)
{
  std::cerr << "wrong result: " << what << ", " << faces << " faces\n";
}

Text_table measure_meshing(const Settings& settings, bool& is_right)
{
  Text_table table({"faces", "triangles", "matching", "validation", "div.", "triang.", "refin.", "improv.", "output", "meshing",
                    "us/face", "us/tri", "ratio", "min angle", "bnd-limited", "unmet", "bytes/tri"});
  for(const double triangles_per_face : settings.triangles_per_face) {
    if(!(triangles_per_face > 0 && std::isfinite(triangles_per_face)))
      throw std::invalid_argument("--triangles-per-face takes positive numbers");
    double first = 0; // seconds per face
    for(const double size : settings.sizes) {
      const Grid grid = torus_grid(size);
      const std::size_t faces = grid.number_of_patches();
      const Result result = in_child_process([&] { return measure(grid, triangles_per_face, settings.repeat); });
      if(first == 0)
        first = result.meshing / faces;
      table.add_line(line(faces, result, first));
      if(!result.is_right)
        complain("mesh of a torus", faces);
      is_right = is_right && result.is_right;
      std::cerr << "." << std::flush;
    }
  }
  std::cerr << "\n";
  return table;
}

// patches to be matched, and how many edges there should be
struct Arrangement
{
  std::string name;
  std::vector<Patch> patches;
  std::size_t number_of_edges;
};

template <class Surface>
Arrangement open_arrangement(const std::string& name, const Surface& surface, const Grid& grid)
{
  return {name, bicubic_patches(surface, grid), grid.columns * (grid.rows + 1) + grid.rows * (grid.columns + 1)};
}

std::vector<Arrangement> arrangements(double size)
{
  const auto plane_of_x_and_y = CGAL::make_parametric_function_surface<Sample_kernel>(
    [](auto u, auto v) { return CGAL::parametric_surface_point(u, v, 0.); });
  const auto plane_of_y_and_z = CGAL::make_parametric_function_surface<Sample_kernel>(
    [](auto u, auto v) { return CGAL::parametric_surface_point(0., u, v); });
  const double side = std::ceil(std::sqrt(size)), length = std::ceil(0.5 * size);
  const Grid square = {static_cast<std::size_t>(side), static_cast<std::size_t>(side), side, side},
             strip = {2, static_cast<std::size_t>(length), 2, length}, torus = torus_grid(size);
  return {{"torus", wavy_torus(torus), 2 * torus.number_of_patches()},
          open_arrangement("square, z = 0", plane_of_x_and_y, square),
          open_arrangement("square, x = 0", plane_of_y_and_z, square),
          open_arrangement("strip along y", plane_of_x_and_y, strip)};
}

Text_table measure_matching(const Settings& settings, bool& is_right)
{
  Text_table table({"arrangement", "faces", "matching", "us/face", "ratio"});
  std::vector<double> first; // seconds per face
  for(const double size : settings.sizes) {
    std::size_t number = 0;
    for(const Arrangement& arrangement : arrangements(size)) {
      const std::size_t faces = arrangement.patches.size();
      double seconds = std::numeric_limits<double>::infinity();
      for(std::size_t i = 0; i < settings.repeat; ++i) {
        Model model;
        keep_least(seconds_of([&] { model = CGAL::make_model_of_rectangular_patches(arrangement.patches); }), seconds);
        if(model.edges().size() != arrangement.number_of_edges) {
          complain(arrangement.name, faces);
          is_right = false;
        }
      }
      if(number == first.size())
        first.push_back(seconds / faces);
      table.add_line({arrangement.name, std::to_string(faces), text("%.3g", seconds), microseconds(seconds / faces),
                      text("%.2f", seconds / faces / first[number])});
      ++number;
    }
  }
  return table;
}

const char usage[] =
  "Usage: model_sizes [SIZE...] [OPTIONS]\n"
  "Prints how the times for making, checking and meshing a model of about SIZE faces grow with their number: processor\n"
  "times in seconds, user and system. Meshing is the sum of its phases and another validation.\n"
  "The ratio is that of the times per face to that of the first SIZE, for meshing in the first table, for matching in the\n"
  "second one. Exit status: 1 if a result is wrong, 2 after an error.\n";

Settings::Settings()
  : Benchmark_settings(usage, {100, 1000, 10000}, "faces", "least")
{
  using boost::program_options::value;
  options().add_options()
    ("triangles-per-face", value(&triangles_per_face)->multitoken()->default_value(triangles_per_face, "50 10"),
     "about how many triangles each face gets");
}

} // namespace

int main(int argc, char** argv)
{
  Settings settings;
  bool is_right = true;
  const int status = run_benchmark(argc, argv, settings, [&] {
    measure_meshing(settings, is_right).print(std::cout, settings.format);
    std::cout << "\n";
    return measure_matching(settings, is_right);
  });
  return status == 0 && !is_right ? 1 : status;
}
