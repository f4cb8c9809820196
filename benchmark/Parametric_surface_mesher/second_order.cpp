// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Six-node triangles of CAD models, as mesh_cad makes them with --order 2, and those of Gmsh with the optimisation of its elements, if there is
// a program `gmsh`: invalid ones, distance from the surfaces by the same evaluator, and time. Gmsh's sizes are between diagonal/1000 and
// diagonal/20 with 20 elements per turn. Each model has a process and 300 seconds of its own.
#include "Mesh_cad_options.h"
#include "Mesh_cad_result.h"
#include "Second_order_triangles.h"
#include "Text_table.h"
#include "text_in_process.h"

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

const unsigned int seconds_for_a_model = 300;

std::vector<Second_order_triangle> own_triangles(const Mesh_cad_result& result)
{
  const auto mesh = CGAL::Parametric_surface_mesher::internal::make_mesh_in_model(result.mesh.mesh, result.mesh.places());
  std::vector<Second_order_triangle> triangles;
  for(const auto f : result.mesh.mesh.faces())
    triangles.push_back({mesh.curved_triangle<mesh_cad::Kernel>(f, result.mesh.mid_side_nodes), result.shape.shape_faces[result.mesh.patch[f]]});
  return triangles;
}

// Runs Gmsh, and returns its processor time; below 0 if it fails.
double seconds_of_gmsh(const std::string& model, double diagonal, int order, const std::string& out)
{
  std::ostringstream command;
  command << "timeout 200 gmsh '" << model << "' -2 -order " << order << " -nt 1 -v 0 -format msh22 -o '" << out << "'"
          << " -setstring Geometry.OCCTargetUnit MM -setnumber Mesh.SaveAll 1 -setnumber Mesh.HighOrderOptimize 1"
          << " -setnumber Mesh.MeshSizeMax " << diagonal / 20 << " -setnumber Mesh.MeshSizeMin " << diagonal / 1000
          << " -setnumber Mesh.MeshSizeFromCurvature 20 -setnumber Mesh.MinimumElementsPerTwoPi 20 > /dev/null 2>&1";
  int status = 0;
  const double seconds = mesh_cad::seconds_of([&] { status = std::system(command.str().c_str()); });
  return status == 0 ? seconds : -1;
}

// The cells of one program: triangles, the largest distance, that of straight sides, the ratios, the Jacobian, the invalid ones.
void print_cells(std::ostream& out, const Second_order_quality& q, double diagonal)
{
  out << q.number_of_triangles << "\t" << text_of_number("%.1e", q.largest / diagonal) << "\t"
      << text_of_number("%.3f", q.largest / q.straight_largest) << "\t" << text_of_number("%.3f", q.mean / q.straight_mean) << "\t"
      << text_of_number("%.2f", q.smallest_jacobian) << "\t" << q.number_of_invalid_ones << "\t";
}

void print_cells_of_gmsh(std::ostream& out, const std::string& model, const Mesh_cad_result& result, const Second_order_judge& judge)
{
  const std::string file = (std::filesystem::temp_directory_path() / ("second_order_" + std::to_string(getpid()) + ".msh")).string();
  const double first = seconds_of_gmsh(model, result.shape.diagonal, 1, file), second = seconds_of_gmsh(model, result.shape.diagonal, 2, file);
  if(first >= 0 && second >= 0) {
    print_cells(out, judge(read_second_order_msh(file)), result.shape.diagonal);
    out << text_of_number("%.2f", second - first);
  }
  std::remove(file.c_str());
}

// the cells of a line but for the name, separated by tabs
std::string cells(const std::string& model, bool is_gmsh_wanted)
{
  Mesh_cad_options options;
  options.input = model;
  options.is_quiet = true;
  options.order = 2;
  Mesh_cad_result result;
  mesh_cad::mesh_and_measure(options, result);
  const Second_order_judge judge(result);
  std::ostringstream out;
  print_cells(out, judge(own_triangles(result)), result.shape.diagonal);
  out << result.second_order->report.number_of_curved_less << "\t" << text_of_number("%.2f", result.second_order_seconds) << "\t";
  if(is_gmsh_wanted)
    print_cells_of_gmsh(out, model, result, judge);
  return out.str();
}

const Text_table::Line titles = {"model", "triangles", "distance", "ratio", "mean ratio", "Jacobian", "invalid", "curved less", "s",
                                 "Gmsh: triangles", "distance", "ratio", "mean ratio", "Jacobian", "invalid", "s"};

Text_table::Line line(const std::string& file_name, bool is_gmsh_wanted)
{
  Text_table::Line result(1, std::filesystem::path(file_name).filename().string());
  std::istringstream in(text_in_process(seconds_for_a_model, [&] { return cells(file_name, is_gmsh_wanted); }));
  for(std::string cell; std::getline(in, cell, '\t');)
    result.push_back(cell);
  result.resize(titles.size());
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  Text_table::Format format = Text_table::PLAIN;
  Text_table table(titles);
  const bool is_gmsh_wanted = std::system("gmsh --version > /dev/null 2>&1") == 0;
  for(const std::string& argument : arguments)
    if(argument == "--markdown")
      format = Text_table::MARKDOWN;
    else
      table.add_line(line(argument, is_gmsh_wanted));
  if(table.lines().size() == 1) {
    std::cerr << "usage: second_order [--markdown] FILE...\n";
    return 2;
  }
  table.print(std::cout, format);
  return 0;
}
