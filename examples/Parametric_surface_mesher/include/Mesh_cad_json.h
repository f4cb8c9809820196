// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The results of mesh_cad in numbers: what --json writes.
#ifndef MESH_CAD_JSON_H
#define MESH_CAD_JSON_H

#include "Mesh_cad_details.h"
#include "Mesh_cad_faces.h"
#include "Mesh_cad_intersections.h"
#include "Mesh_cad_options.h"
#include "Mesh_cad_result.h"
#include "Unmet_count.h"
#include "json_of_names.h"
#include "summary_lines.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <ostream>
#include <vector>

namespace mesh_cad {

inline nlohmann::ordered_json json_of_shape(const Mesh_cad_result& result)
{
  const auto& shape = result.shape;
  nlohmann::ordered_json left_out = nlohmann::ordered_json::array(), gaps = nlohmann::ordered_json::array(),
                         closed_up = nlohmann::ordered_json::array(), inner_edges = nlohmann::ordered_json::array(),
                         inner_vertices = nlohmann::ordered_json::array();
  for(const auto& face : result.left_out)
    left_out.push_back({{"face", face.shape_face + 1}, {"reason", face.reason}});
  for(const auto& face : shape.closed_up)
    closed_up.push_back({{"face", face.shape_face + 1}, {"width", face.width}});
  for(const auto& gap : shape.gaps)
    gaps.push_back({{"edge", gap.shape_edge + 1}, {"face", gap.shape_face + 1}, {"distance", gap.distance}, {"tolerance", gap.tolerance}});
  for(const auto& edge : shape.inner_edges)
    inner_edges.push_back({{"edge", edge.shape_edge + 1}, {"face", edge.shape_face + 1}, {"not_followed", edge.reason}});
  for(const auto& vertex : shape.inner_vertices)
    inner_vertices.push_back({{"vertex", vertex.shape_vertex + 1}, {"face", vertex.shape_face + 1}, {"not_followed", vertex.reason}});
  return {{"removed_details", json_of_details(result)},
          {"file_faults", result.file_faults},
          {"size", mesh_patch::sides(result.measures.box)},
          {"diagonal", shape.diagonal},
          {"faces", shape.number_of_shape_faces},
          {"edges", shape.number_of_shape_edges},
          {"meshed_faces", number_of_meshed_faces(result)},
          {"left_out", left_out},
          {"closed_up", closed_up},
          {"collapsed_edges", collapsed_edges(shape)},
          {"shape_closed", shape.is_shape_closed},
          {"largest_gap", shape.largest_gap},
          {"gaps_above_tolerance", gaps},
          {"rebuilt_curves", shape.number_of_rebuilt_curves},
          {"removed_slits", shape.number_of_removed_slits},
          {"joined_vertices", shape.number_of_joined_vertices},
          {"reversed_faces", shape.number_of_reversed_faces},
          {"inner_edges", inner_edges},
          {"inner_vertices", inner_vertices},
          {"imprints", json_of_imprints(result.imprints)},
          {"repeated_faces", numbers_from_1(shape.repeated_faces)},
          {"turned_edges", numbers_from_1(shape.turned_edges)},
          {"contacts", json_of_contacts(result.contacts)},
          {"sewn_edges", result.number_of_sewn_edges},
          {"lost_faces", result.number_of_lost_faces}};
}

inline std::vector<std::size_t> faces_of_shape(const Mesh_cad_result& result, std::vector<std::size_t> faces_of_model)
{
  for(std::size_t& face : faces_of_model)
    face = result.shape.shape_faces[face];
  return faces_of_model;
}

// A number that may not be known.
inline nlohmann::ordered_json number_or_null(bool is_known, double number)
{
  return is_known ? nlohmann::ordered_json(number) : nlohmann::ordered_json();
}

inline nlohmann::ordered_json json_of_mesh(const Mesh_cad_result& result)
{
  const auto& q = result.quality;
  const auto& m = result.measures;
  const auto& s = result.report.seconds;
  return {{"max_edge", result.criteria.max_edge()},
          {"min_edge", result.criteria.min_edge()},
          {"gamma", result.criteria.gamma()},
          {"angle", result.criteria.angle()},
          {"vertices", q.number_of_vertices},
          {"triangles", q.number_of_faces},
          {"area", q.area},
          {"closed", q.is_closed},
          {"border_edges", m.border_edges},
          {"components", q.number_of_connected_components},
          {"min_angle", q.min_angle},
          {"min_angle_apart_from_corners", m.min_angle_apart},
          {"mean_min_angle", q.mean_min_angle},
          {"mean_radius_ratio", q.mean_radius_ratio},
          {"below_10", m.below_10},
          {"below_10_at_corners", m.below_10_at_corners},
          {"tiny_edges", numbers_from_1(m.tiny_edges)},
          {"sliver_faces", numbers_from_1(faces_of_shape(result, m.sliver_faces))},
          {"self_intersections", json_of_intersections(result)},
          {"folds", json_of_folds(result)},
          {"distance", number_or_null(result.is_distance_measured, m.distance)},
          {"distance_over_diagonal", number_or_null(result.is_distance_measured, m.distance / result.shape.diagonal)},
          {"layers", {{"smallest_length", result.layers.smallest_length}, {"limited", result.layers.is_limited}}},
          {"decided_by", result.is_distance_measured ? json_of_bounds(result.deciding_bounds) : nlohmann::ordered_json()},
          {"unmet_by", mesh_patch::json_of_unmet(result.report)},
          {"unjudged", result.report.number_of_unjudged_faces},
          {"stopped", result.report.is_stopped},
          {"work_limits", result.report.number_of_work_limits},
          {"order", result.second_order ? 2 : 1},
          {"seconds", {{"reading", result.reading_seconds}, {"model", result.model_seconds},
                       {"meshing", result.meshing_seconds}, {"second_order", result.second_order_seconds},
                       {"measuring", result.measuring_seconds}, {"intersections", result.intersections_seconds}}},
          {"meshing_phases", {{"division", s.division}, {"triangulation", s.triangulation}, {"refinement", s.refinement},
                              {"improvement", s.improvement}, {"intersections", s.intersections}, {"output", s.output}}}};
}

// Names that are not in UTF-8 lose what is not.
inline void write_json(std::ostream& out, const nlohmann::ordered_json& json)
{
  out << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
}

inline void write_json(std::ostream& out, const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  nlohmann::ordered_json json = {{"name", title(options)}};
  json.update(json_of_shape(result));
  json.update(json_of_names(result.names));
  json["face_list"] = json_of_faces(face_list(result.open_cascade_shape, unit_in_millimetres(options)), result.names);
  json.update(json_of_mesh(result));
  if(result.second_order) {
    json["second_order"] = mesh_patch::json_of_second_order(*result.second_order);
    json["second_order"]["distance"] = number_or_null(result.is_distance_measured, result.second_order->distance);
  }
  write_json(out, json);
}

} // namespace mesh_cad

#endif // MESH_CAD_JSON_H
