// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles that pass through each other or are folded, in numbers.
#ifndef MESH_CAD_INTERSECTIONS_H
#define MESH_CAD_INTERSECTIONS_H

#include "Mesh_cad_result.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>

namespace mesh_cad {

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

} // namespace mesh_cad

#endif // MESH_CAD_INTERSECTIONS_H
