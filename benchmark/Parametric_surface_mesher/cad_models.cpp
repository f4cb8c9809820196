// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes all CAD models of some folders as mesh_cad does without options, lets Open CASCADE judge the meshes, and prints a
// table for each folder. Each model has a process and 60 seconds of its own.
#include "Cad_mesh_judge_input.h"
#include "Mesh_cad_options.h"
#include "Mesh_cad_result.h"
#include "Text_table.h"
#include "text_in_process.h"

#include "Cad_mesh_judge.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

const unsigned int seconds_for_a_model = 60;

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
      << verdict_text(result, verdict) << "\t" << result.quality.number_of_faces << "\t" << text_of_number("%.2f", seconds) << "\t"
      << text_of_number("%.0fk", triangles / seconds / 1000) << "\t" << text_of_number("%.3g", result.quality.min_angle) << "\t"
      << text_of_number("%.3g", result.measures.min_angle_apart) << "\t"
      << text_of_number("%.3g", 100. * result.measures.below_10 / triangles) << "\t"
      << text_of_number("%.3g", 100. * (result.measures.below_10 - result.measures.below_10_at_corners) / triangles) << "\t"
      << text_of_number("%.1f", result.quality.mean_min_angle) << "\t" << text_of_number("%.2e", verdict.deviation);
  return out.str();
}

const Text_table::Line titles = {"model", "faces", "closed", "verdict", "triangles", "CPU s", "per s", "min angle", "apart",
                                 "% <10", "not at corners", "mean min angle", "deviation"};
const std::size_t verdict_column = 3, apart_column = 8, needles_column = 10;

Text_table::Line line(const std::string& file_name)
{
  Text_table::Line result(1, std::filesystem::path(file_name).filename().string());
  std::istringstream in(text_in_process(seconds_for_a_model, [&] { return cells(file_name); }));
  for(std::string cell; std::getline(in, cell, '\t');)
    result.push_back(cell);
  result.resize(titles.size());
  return result;
}

// How many models of a folder are as they should be.
class Tally
{
  std::size_t m_number_of_models = 0, m_ok = 0, m_with_needles = 0, m_below_1 = 0;

public:
  void add(const Text_table::Line& line)
  {
    ++m_number_of_models;
    m_ok += line[verdict_column].rfind("ok", 0) == 0;
    const auto number = [&](std::size_t column) { return std::strtod(line[column].c_str(), nullptr); };
    m_with_needles += number(needles_column) > 0;
    m_below_1 += !line[apart_column].empty() && number(apart_column) < 1;
  }

  void print(std::ostream& out) const
  {
    out << m_ok << " of " << m_number_of_models << " are ok; apart from corners there are triangles below 10 degrees on "
        << m_with_needles << ", and below 1 degree on " << m_below_1 << "\n";
  }
};

void print_folder(const std::string& folder, Text_table::Format format)
{
  Text_table table(titles);
  Tally tally;
  for(const std::string& file : cad_files_in(folder)) {
    table.add_line(line(file));
    tally.add(table.lines().back());
  }
  table.print(std::cout, format);
  std::cout << "\n" << std::filesystem::path(folder).filename().string() << ": ";
  tally.print(std::cout);
  std::cout.flush(); // else the processes of the next folder would print it once more
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> folders(argv + 1, argv + argc);
  const auto option = std::find(folders.begin(), folders.end(), "--markdown");
  const bool is_markdown = option != folders.end();
  if(is_markdown)
    folders.erase(option);
  if(folders.empty()
     || !std::all_of(folders.begin(), folders.end(), [](const std::string& f) { return std::filesystem::is_directory(f); })) {
    std::cerr << "Usage: cad_models [--markdown] FOLDER...\n";
    return 2;
  }
  for(const std::string& folder : folders)
    print_folder(folder, is_markdown ? Text_table::MARKDOWN : Text_table::PLAIN);
  return 0;
}
