// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What mesh_cad tells of facets that pass through each other.
#ifndef MESH_CAD_INTERSECTIONS_H
#define MESH_CAD_INTERSECTIONS_H

#include "Mesh_cad_result.h"
#include "Usage_error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <string>

namespace mesh_cad {

// Whether the mesh intersects itself where the shape does not.
inline bool intersects_itself(const Mesh_cad_result& result)
{
  return std::any_of(result.report.intersections.begin(), result.report.intersections.end(),
                     [](const auto& intersection) { return !intersection.is_of_surfaces; });
}

// The numbers of two faces of the model in the shape, from 1.
inline std::array<std::size_t, 2> numbers_of_faces(const Mesh_cad_result& result, const std::array<std::size_t, 2>& faces)
{
  return {result.shape.shape_faces[faces[0]] + 1, result.shape.shape_faces[faces[1]] + 1};
}

inline nlohmann::ordered_json json_of_intersections(const Mesh_cad_result& result)
{
  nlohmann::ordered_json intersections = nlohmann::ordered_json::array();
  for(const auto& intersection : result.report.intersections)
    intersections.push_back({{"faces", numbers_of_faces(result, intersection.faces)},
                             {"triangle_pairs", intersection.number_of_pairs}, {"place", intersection.place},
                             {"of_shape", intersection.is_of_surfaces}});
  return intersections;
}

inline nlohmann::ordered_json json_of_folds(const Mesh_cad_result& result)
{
  nlohmann::ordered_json folds = nlohmann::ordered_json::array();
  for(const auto& fold : result.report.folds)
    folds.push_back({{"faces", numbers_of_faces(result, fold.faces)}, {"triangle_pairs", fold.number_of_pairs}, {"place", fold.place}});
  return folds;
}

// `where`: an intersection or a fold
template <class Where>
void print_where(std::ostream& out, const Mesh_cad_result& result, const Where& where)
{
  const auto faces = numbers_of_faces(result, where.faces);
  out << (faces[0] == faces[1] ? "face " + std::to_string(faces[0])
                               : "faces " + std::to_string(faces[0]) + " and " + std::to_string(faces[1]))
      << " at (" << where.place[0] << ", " << where.place[1] << ", " << where.place[2] << "), "
      << mesh_patch::plural(where.number_of_pairs, "pair") << " of triangles\n";
}

inline void print_intersections(std::ostream& out, const Mesh_cad_result& result)
{
  const std::size_t max_number_of_lines = 10;
  std::size_t number = 0;
  for(const auto& intersection : result.report.intersections) {
    if(++number > max_number_of_lines)
      continue;
    out << (intersection.is_of_surfaces ? "  the shape intersects itself: " : "  THE MESH INTERSECTS ITSELF: ");
    print_where(out, result, intersection);
  }
  if(number > max_number_of_lines)
    out << "  and in " << mesh_patch::plural(number - max_number_of_lines, "other pair") << " of faces\n";
  for(const auto& fold : result.report.folds) {
    out << "  THE MESH IS FOLDED: ";
    print_where(out, result, fold);
  }
}

} // namespace mesh_cad

#endif // MESH_CAD_INTERSECTIONS_H
