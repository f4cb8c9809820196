// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_BDF_WRITER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_BDF_WRITER_H

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Element_sets.h>

#include <cstddef>
#include <cstdio>
#include <cstring>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A line of a comment.
inline std::string bdf_comment(const std::string& text)
{
  const std::size_t max_length = 70; // of a line, 80
  return "$ " + one_line(text).substr(0, max_length) + "\n";
}

// Fields of 8 characters, 10 in a line.
inline std::string bdf_card(const std::string& keyword, const std::vector<std::size_t>& numbers)
{
  const std::size_t max_number_of_fields = 8; // in a line, beside the first and the last one
  char field[32];
  std::snprintf(field, sizeof(field), "%-8s", keyword.c_str());
  std::string result = field;
  for(std::size_t i = 0; i < numbers.size(); ++i) {
    if(i > 0 && i % max_number_of_fields == 0)
      result += "+       \n+       ";
    std::snprintf(field, sizeof(field), "%8zu", numbers[i]);
    result += field;
  }
  return result + "\n";
}

// A number in a field of 16 characters.
inline std::string bdf_number(double x)
{
  const std::size_t width = 16;
  char field[32];
  std::snprintf(field, sizeof(field), "%16.9E", x);
  if(std::strlen(field) > width)
    std::snprintf(field, sizeof(field), "%16.8E", x); // with a sign and an exponent of three digits
  return field;
}

inline void write_bulk_data(std::ostream& out, const Element_mesh_3& mesh)
{
  const std::vector<std::size_t> properties = unique_numbers(mesh.surfaces);
  out << "$ Triangles of the faces of a shape\nBEGIN BULK\n";
  for(std::size_t s = 0; s < mesh.surfaces.size(); ++s) {
    const auto& surface = mesh.surfaces[s];
    out << bdf_comment("property " + std::to_string(properties[s]) + ": face_" + std::to_string(surface.number)
                       + (surface.name.empty() ? "" : " " + surface.name)
                       + (surface.parts[0] == Element_mesh_3::none ? "" : ", part " + mesh.parts[surface.parts[0]].name));
  }
  char line[128];
  for(std::size_t i = 0; i < mesh.nodes.size(); ++i) { // fields of 16 characters
    const auto& p = mesh.nodes[i];
    std::snprintf(line, sizeof(line), "GRID*   %16zu%16s", i + 1, "");
    out << line << bdf_number(p[0]) << bdf_number(p[1]) << "*\n*       " << bdf_number(p[2]) << '\n';
  }
  for(std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    std::vector<std::size_t> numbers{i + 1, properties[mesh.triangle_surfaces[i]]};
    for(std::size_t k = 0; k < mesh.nodes_of_triangle(); ++k)
      numbers.push_back(mesh.triangles[i][k] + 1);
    out << bdf_card(mesh.is_second_order ? "CTRIA6" : "CTRIA3", numbers);
  }
  out << "ENDDATA\n";
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_BDF_WRITER_H
