// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What of a shape is not in its mesh, since it is too small: faces, edges and detail of faces.
#ifndef MESH_CAD_DETAILS_H
#define MESH_CAD_DETAILS_H

#include "Mesh_cad_result.h"
#include "Mesh_findings.h"
#include "Usage_error.h"
#include "text_of_numbers.h"

#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Parametric_surface_mesh_report.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace mesh_cad {

// A face that two shells share counts once.
inline std::size_t number_of_meshed_faces(const Mesh_cad_result& result)
{
  std::set<std::size_t> faces(result.shape.shape_faces.begin(), result.shape.shape_faces.end());
  for(const auto& face : result.left_out)
    faces.erase(face.shape_face);
  for(const auto& face : result.shape.closed_up)
    faces.erase(face.shape_face);
  return faces.size();
}

// edges that are so short that they are a vertex of the model, from 1
inline std::vector<std::size_t> collapsed_edges(const CGAL::Open_cascade_model_3& shape)
{
  std::vector<std::size_t> result;
  for(std::size_t e = 0; e < shape.model_edges.size(); ++e)
    if(shape.model_edges[e].empty())
      result.push_back(e + 1);
  return result;
}

// By the number of the face, from 1. A face with creases is several of the model, whose triangles are added up; one that two shells
// share is two of the model, with the same place, and counts once.
inline std::map<std::size_t, CGAL::Parametric_surface_mesh_report::Removed_detail> details_by_face(const Mesh_cad_result& result)
{
  std::map<std::size_t, CGAL::Parametric_surface_mesh_report::Removed_detail> details;
  for(const auto& detail : result.report.removed_details) {
    const auto found = details.emplace(result.shape.shape_faces[detail.face] + 1, detail);
    auto& same = found.first->second;
    same.moved = (std::max)(same.moved, detail.moved);
    if(!found.second && same.place != detail.place)
      same.number_of_triangles += detail.number_of_triangles;
  }
  return details;
}

inline nlohmann::ordered_json json_of_details(const Mesh_cad_result& result)
{
  nlohmann::ordered_json details = nlohmann::ordered_json::array();
  for(const auto& detail : details_by_face(result))
    details.push_back({{"face", detail.first}, {"triangles", detail.second.number_of_triangles},
                       {"moved", detail.second.moved}, {"place", detail.second.place}});
  return details;
}

// As "face 3", or "8 faces (3, 4, 7, 9, 12, ...)".
inline std::string text_of_faces(const std::vector<std::size_t>& numbers)
{
  const std::size_t most = 5;
  if(numbers.size() == 1)
    return "face " + std::to_string(numbers.front());
  std::string list;
  for(std::size_t i = 0; i < (std::min)(most, numbers.size()); ++i)
    list += (i == 0 ? "" : ", ") + std::to_string(numbers[i]);
  return std::to_string(numbers.size()) + " faces (" + list + (numbers.size() > most ? ", ...)" : ")");
}

inline void add_closed_up_faces(const Mesh_cad_result& result, const mesh_patch::Text_of_length& length, Mesh_findings& findings)
{
  const auto& closed_up = result.shape.closed_up;
  if(closed_up.size() == 1)
    findings.notes.push_back("face " + closed_up_text(closed_up.front(), length));
  if(closed_up.size() <= 1)
    return;
  std::vector<std::size_t> numbers;
  double width = 0;
  for(const auto& face : closed_up) {
    numbers.push_back(face.shape_face + 1);
    width = (std::max)(width, face.width);
  }
  findings.notes.push_back(text_of_faces(numbers) + " are closed up: they are nowhere wider than " + length(width));
}

// Detail of faces that still have triangles.
inline void add_removed_details(const Mesh_cad_result& result, const mesh_patch::Text_of_length& length, Mesh_findings& findings)
{
  std::set<std::size_t> faces_without_triangles;
  for(const auto& face : result.shape.closed_up)
    faces_without_triangles.insert(face.shape_face + 1);
  std::vector<std::size_t> numbers;
  CGAL::Parametric_surface_mesh_report::Removed_detail largest{};
  std::size_t face_of_largest = 0;
  for(const auto& face : details_by_face(result)) {
    if(faces_without_triangles.count(face.first) > 0)
      continue;
    numbers.push_back(face.first);
    if(numbers.size() == 1 || face.second.moved > largest.moved) {
      largest = face.second;
      face_of_largest = face.first;
    }
  }
  if(!numbers.empty())
    findings.notes.push_back("small detail of " + text_of_faces(numbers) + " is left out, which moved the mesh by at most "
                             + length(largest.moved) + (numbers.size() > 1 ? ", that at face " + std::to_string(face_of_largest) : "") + " near "
                             + mesh_patch::text_of(largest.place) + "; --keep-detail keeps it");
}

// What was simplified, in sentences.
inline void add_simplifications(const Mesh_cad_result& result, const mesh_patch::Text_of_length& length, Mesh_findings& findings)
{
  add_closed_up_faces(result, length, findings);
  add_removed_details(result, length, findings);
  const std::size_t number_of_edges = collapsed_edges(result.shape).size();
  if(number_of_edges > 0)
    findings.notes.push_back(mesh_patch::plural(number_of_edges, "edge is so short that it", "edges are so short that each")
                             + " became one point");
}

} // namespace mesh_cad

#endif // MESH_CAD_DETAILS_H
