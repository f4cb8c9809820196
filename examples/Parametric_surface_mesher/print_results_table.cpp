// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prints the results that mesh_patch has written with --json as one table, a line for each file.
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

std::string number(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// The count in a result, which may be a number, a list, or an object with one of these for each cause.
long count(const nlohmann::json& value)
{
  if(value.is_number())
    return value.get<long>();
  if(value.is_array())
    return static_cast<long>(value.size());
  long sum = 0;
  for(const auto& item : value.items())
    sum += count(item.value());
  return sum;
}

// The name of the file without its folder and ending.
std::string stem(const std::string& path)
{
  const std::size_t begin = path.find_last_of("/\\") + 1; // 0 if there is none
  return path.substr(begin, path.find_last_of('.') - begin);
}

std::vector<std::string> row(const std::string& path)
{
  std::ifstream in(path);
  if(!in)
    throw std::runtime_error("cannot be read");
  const nlohmann::json result = nlohmann::json::parse(in);
  return { stem(path),
           std::to_string(count(result.at("vertices"))),
           std::to_string(count(result.at("triangles"))),
           number("%.2f", result.at("min_angle").get<double>()),
           number("%.4f", result.at("mean_radius_ratio").get<double>()),
           number("%.4f", result.at("max_deviation").get<double>()),
           std::to_string(count(result.at("boundary_limited"))),
           std::to_string(count(result.at("unmet"))),
           number("%.3f", result.at("seconds").at("meshing").get<double>()) };
}

} // namespace

int main(int argc, char** argv)
{
  if(argc < 2 || std::string(argv[1]) == "--help") {
    (argc < 2 ? std::cerr : std::cout)
      << "Usage: print_results_table FILE.json...\n"
         "Prints the results written by mesh_patch --json as one table.\n";
    return argc < 2 ? 2 : 0;
  }

  std::vector<std::vector<std::string> > table = {
    { "surface", "vertices", "triangles", "min angle", "mean 2r/R", "max dev.", "bnd-limited", "unmet", "seconds" }
  };
  for(int i = 1; i < argc; ++i)
    try {
      table.push_back(row(argv[i]));
    } catch(const std::exception& e) {
      std::cerr << "print_results_table: " << argv[i] << ": " << e.what() << "\n";
      return 2;
    }

  std::vector<std::size_t> widths(table[0].size());
  for(const auto& line : table)
    for(std::size_t i = 0; i < line.size(); ++i)
      widths[i] = (std::max)(widths[i], line[i].size());

  for(const auto& line : table) {
    // names to the left, numbers to the right
    std::cout << line[0] << std::string(widths[0] - line[0].size(), ' ');
    for(std::size_t i = 1; i < line.size(); ++i)
      std::cout << "  " << std::string(widths[i] - line[i].size(), ' ') << line[i];
    std::cout << "\n";
  }
  return 0;
}
