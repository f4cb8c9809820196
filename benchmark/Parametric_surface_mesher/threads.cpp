// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What threads save: models of 50 equal faces and of one big face, meshed by turns with one thread and with several. The
// meshes must be the same bit by bit.
#include "Benchmark_settings.h"
#include "Sample_mesher.h"
#include "Sample_models.h"
#include "Text_table.h"
#include "measure.h"

#include <CGAL/make_model_of_rectangular_patches.h>
#include <CGAL/make_parametric_surface_mesh.h>
#include <CGAL/tags.h>

#include <boost/program_options.hpp>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

typedef CGAL::Parametric_surface_model_3<Sample_surface> Model;

struct Settings : Benchmark_settings
{
  int threads = tbb::info::default_concurrency();

  Settings();
};

// (u, v, 0.1 sin(pi u) sin(pi v)): congruent over all squares of the integer grid, and as smooth across their sides
struct Waves : sample_surfaces::From_jet<Waves>
{
  sample_surfaces::Jet jet(double u, double v) const
  {
    using sample_surfaces::Vector_3;
    const double w = sample_surfaces::pi, height = 0.1;
    const double su = std::sin(w * u), cu = std::cos(w * u), sv = std::sin(w * v), cv = std::cos(w * v);
    return {sample_surfaces::Point_3(u, v, height * su * sv),
            Vector_3(1, 0, height * w * cu * sv),
            Vector_3(0, 1, height * w * su * cv),
            Vector_3(0, 0, -height * w * w * su * sv),
            Vector_3(0, 0, height * w * w * cu * cv),
            Vector_3(0, 0, -height * w * w * su * sv)};
  }
};

const int columns = 10, rows = 5;
const double area = columns * rows * 1.0243;

Model model_of_equal_faces()
{
  std::vector<sample_surfaces::Patch> patches;
  for(int i = 0; i < columns; ++i)
    for(int j = 0; j < rows; ++j)
      patches.emplace_back(Sample_surface(Waves()), i, i + 1, j, j + 1);
  return sample_surface_model(CGAL::make_model_of_rectangular_patches(patches));
}

Model model_of_one_face()
{
  const std::vector<sample_surfaces::Patch> patch = {{Sample_surface(Waves()), 0, columns, 0, rows}};
  return sample_surface_model(CGAL::make_model_of_rectangular_patches(patch));
}

// Times of all runs, by the clock on the wall and of the processors together.
struct Times
{
  std::vector<double> seconds, processor_seconds;
};

template <class ConcurrencyTag>
void mesh_model(const Model& model, double edge_length, Sample_mesh& mesh, Times& times)
{
  const auto criteria = CGAL::Parametric_surface_mesh_criteria().set_max_edge(edge_length);
  const auto begin = std::chrono::steady_clock::now();
  times.processor_seconds.push_back(
    seconds_of([&] { CGAL::make_parametric_surface_mesh<ConcurrencyTag>(model, criteria, mesh); }));
  times.seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
}

bool is_same_point(const Sample_kernel::Point_3& p, const Sample_kernel::Point_3& q)
{
  for(int i = 0; i < 3; ++i) {
    const double a = p[i], b = q[i];
    if(std::memcmp(&a, &b, sizeof a) != 0)
      return false;
  }
  return true;
}

// the same vertices and faces in the same order, every bit
bool is_same_mesh(const Sample_mesh& a, const Sample_mesh& b)
{
  if(a.number_of_vertices() != b.number_of_vertices() || a.number_of_halfedges() != b.number_of_halfedges()
     || a.number_of_faces() != b.number_of_faces())
    return false;
  for(const auto v : a.vertices())
    if(!is_same_point(a.point(v), b.point(v)))
      return false;
  for(const auto h : a.halfedges())
    if(a.target(h) != b.target(h) || a.next(h) != b.next(h) || a.face(h) != b.face(h))
      return false;
  return true;
}

void compare(const std::string& name, const Model& model, double size, const Settings& settings, Text_table& table)
{
  const double edge_length = sample_surfaces::edge_length(area, size);
  Times one, several;
  std::vector<double> ratios;
  std::size_t number_of_triangles = 0;
  for(std::size_t i = 0; i < settings.repeat; ++i) {
    Sample_mesh a, b;
    mesh_model<CGAL::Sequential_tag>(model, edge_length, a, one);
    mesh_model<CGAL::Parallel_tag>(model, edge_length, b, several);
    ratios.push_back(one.seconds.back() / several.seconds.back());
    if(!is_same_mesh(a, b))
      throw std::runtime_error("with threads the mesh of " + name + " is another one");
    number_of_triangles = a.number_of_faces();
    std::cerr << "." << std::flush;
  }
  table.add_line({name, text("%.0f", static_cast<double>(number_of_triangles)), std::to_string(settings.threads),
                  text("%.3f", median(one.seconds)), text("%.3f", median(several.seconds)), text("%.2f", median(ratios)),
                  text("%.3f", median(one.processor_seconds)), text("%.3f", median(several.processor_seconds)), "yes"});
}

Text_table compare_all(const Settings& settings)
{
  if(settings.threads < 1)
    throw std::invalid_argument("--threads must be positive");
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, settings.threads);
  const Model equal_faces = model_of_equal_faces(), one_face = model_of_one_face();
  Text_table table({"model", "triangles", "threads", "sequential s", "parallel s", "ratio", "sequential CPU s", "parallel CPU s",
                    "same mesh"});
  for(const double size : settings.sizes) {
    compare("50 equal faces", equal_faces, size, settings, table);
    compare("one face", one_face, size, settings, table);
  }
  std::cerr << "\n";
  return table;
}

const char usage[] =
  "Usage: threads [SIZE...] [OPTIONS]\n"
  "Meshes models of 50 equal faces and of one face with about SIZE triangles by turns with one thread and with several.\n"
  "The ratio is that of the times by the clock on the wall, so nothing else should run: the processor times (CPU) tell whether\n"
  "the program had the processors for itself. Fails if the meshes are not the same bit by bit.\n";

Settings::Settings()
  : Benchmark_settings(usage, {2000000})
{
  options().add_options()
    ("threads", boost::program_options::value(&threads)->default_value(threads), "number of threads");
}

} // namespace

int main(int argc, char** argv)
{
  Settings settings;
  return run_benchmark(argc, argv, settings, [&] { return compare_all(settings); });
}
