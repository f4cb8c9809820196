// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes all CAD models of a folder as mesh_cad does without options, lets Open CASCADE judge the meshes, and prints a
// table. Each model has a process and 60 seconds of its own.
#include "Cad_mesh_judge_input.h"
#include "Mesh_cad_options.h"
#include "Mesh_cad_result.h"
#include "Text_table.h"

#include "Cad_mesh_judge.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

const unsigned int seconds_for_a_model = 60;

std::string text(const char* format, double value)
{
  char buffer[64];
  std::snprintf(buffer, sizeof(buffer), format, value);
  return buffer;
}

std::string verdict_text(const Mesh_cad_result& result, const Cad_mesh_verdict& verdict)
{
  std::string names;
  for(const auto& face : result.left_out)
    names += (names.empty() ? " left out " : ",") + std::to_string(face.shape_face + 1);
  if(!result.shape.closed_up.empty())
    names += " closed up " + std::to_string(result.shape.closed_up.size());
  return verdict.text() + names;
}

// the cells of a line but for the name, separated by tabs
std::string cells(const std::string& file_name)
{
  Mesh_cad_options options;
  options.input = file_name;
  options.is_quiet = true;
  Mesh_cad_result result;
  mesh_cad::mesh_and_measure(options, result);
  const TopoDS_Shape shape = mesh_cad::read_shape(options, result);
  const Cad_mesh_verdict verdict = Cad_mesh_judge(shape, judge_input(result))();
  const double seconds = result.model_seconds + result.meshing_seconds, triangles = double(result.quality.number_of_faces);
  std::ostringstream out;
  out << mesh_cad::number_of_meshed_faces(result) << "/" << result.shape.number_of_shape_faces << "\t"
      << (verdict.is_closed() ? "yes" : "no") << "/" << (verdict.is_shape_closed ? "yes" : "no") << "\t"
      << verdict_text(result, verdict) << "\t" << result.quality.number_of_faces << "\t" << text("%.2f", seconds) << "\t"
      << text("%.0fk", triangles / seconds / 1000) << "\t" << text("%.3g", result.quality.min_angle) << "\t"
      << text("%.3g", result.measures.min_angle_apart) << "\t"
      << text("%.3g", 100. * result.measures.below_10 / triangles) << "\t"
      << text("%.3g", 100. * (result.measures.below_10 - result.measures.below_10_at_corners) / triangles) << "\t"
      << text("%.1f", result.quality.mean_min_angle) << "\t" << text("%.2e", verdict.deviation);
  return out.str();
}

// What `cells` returns or throws, from a process of its own.
std::string cells_in_process(const std::string& file_name)
{
  int ends[2];
  if(pipe(ends) != 0)
    return "no pipe";
  const pid_t child = fork();
  if(child == 0) {
    const rlimit limit = {seconds_for_a_model, seconds_for_a_model};
    setrlimit(RLIMIT_CPU, &limit);
    std::string result;
    try {
      result = cells(file_name);
    }
    catch(const std::exception& error) {
      result = std::string("-\t-\tERROR ") + error.what();
    }
    const bool is_written = write(ends[1], result.data(), result.size()) == ssize_t(result.size());
    _exit(is_written ? 0 : 1);
  }
  close(ends[1]);
  std::string result;
  char buffer[4096];
  for(ssize_t n; (n = read(ends[0], buffer, sizeof(buffer))) > 0;)
    result.append(buffer, std::size_t(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return !WIFSIGNALED(status) ? result : WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL ? "-\t-\tTIMEOUT" : "-\t-\tCRASH";
}

std::vector<std::string> files_in(const std::string& folder)
{
  std::vector<std::string> result;
  for(const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    for(const char* known : {".step", ".stp", ".iges", ".igs", ".brep", ".rle"})
      if(ending == known)
        result.push_back(entry.path().string());
  }
  std::sort(result.begin(), result.end());
  return result;
}

Text_table::Line line(const std::string& file_name, std::size_t number_of_cells)
{
  Text_table::Line result(1, std::filesystem::path(file_name).filename().string());
  std::istringstream in(cells_in_process(file_name));
  for(std::string cell; std::getline(in, cell, '\t');)
    result.push_back(cell);
  result.resize(number_of_cells);
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool is_markdown = std::find(arguments.begin(), arguments.end(), "--markdown") != arguments.end();
  if(arguments.size() != (is_markdown ? 2u : 1u) || arguments.back() == "--markdown"
     || !std::filesystem::is_directory(arguments.back())) {
    std::cerr << "Usage: cad_models [--markdown] FOLDER\n";
    return 2;
  }
  const Text_table::Line titles = {"model", "faces", "closed", "verdict", "triangles", "CPU s", "per s", "min angle", "apart",
                                   "% <10", "not at corners", "mean min angle", "deviation"};
  Text_table table(titles);
  for(const std::string& file : files_in(arguments.back()))
    table.add_line(line(file, titles.size()));
  table.print(std::cout, is_markdown ? Text_table::MARKDOWN : Text_table::PLAIN);
  return 0;
}
