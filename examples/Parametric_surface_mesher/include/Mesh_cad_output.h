// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files and the summary of mesh_cad.
#ifndef MESH_CAD_OUTPUT_H
#define MESH_CAD_OUTPUT_H

#include "Mesh_cad_faces.h"
#include "Mesh_cad_intersections.h"
#include "Mesh_cad_options.h"
#include "Mesh_cad_result.h"
#include "Output_files.h"
#include "Unmet_count.h"
#include "json_of_names.h"
#include "write_mesh_cad_file.h"
#include "write_page.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <ostream>
#include <sstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace mesh_cad {

inline std::string title(const Mesh_cad_options& options)
{
  return options.input.substr(options.input.find_last_of('/') + 1);
}

inline void write_picture(std::ostream& out, const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  mesh_patch::write_picture(out, options.picture, result.page, title(options));
}

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
          {"distance", m.distance},
          {"distance_over_diagonal", m.distance / result.shape.diagonal},
          {"layers", {{"smallest_length", result.layers.smallest_length}, {"limited", result.layers.is_limited}}},
          {"decided_by", json_of_bounds(result.deciding_bounds)},
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
  if(result.second_order)
    json["second_order"] = mesh_patch::json_of_second_order(*result.second_order);
  write_json(out, json);
}

inline void print_summary(std::ostream& out, const Mesh_cad_options& options, const Mesh_cad_result& result);

inline void write_page(std::ostream& out, const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  std::ostringstream summary;
  print_summary(summary, options, result);
  mesh_patch::write_page(out, result.page, title(options), has_unit(options) ? symbol_of_unit(options.unit) : "", summary.str());
}

// The files that the options ask for; throws if one of them could not be written later.
inline Output_files output_files(const Mesh_cad_options& o, const Mesh_cad_result& result)
{
  Output_files files;
  const auto add = [&](const char* option, const std::string& name, const std::vector<std::string>& endings,
                       Output_files::Writer write) {
    if(name.empty())
      return;
    mesh_patch::check_ending(option, name, endings);
    files.add(name, std::move(write));
  };
  if(o.order == 2 && !o.out.empty())
    mesh_patch::check_ending("order 2 --out", o.out, endings_for_solvers());
  add("out", o.out, all_endings(),
      [&](std::ostream& out) { write_result(out, o.out, o, result); });
  add("picture", o.picture, {".png", ".svg"}, [&](std::ostream& out) { write_picture(out, o, result); });
  add("page", o.page, {".html"}, [&](std::ostream& out) { write_page(out, o, result); });
  add("json", o.json, {".json"}, [&](std::ostream& out) { write_json(out, o, result); });
  return files;
}

// Edges that lie farther off their faces than the file says.
inline void print_gaps(std::ostream& out, const Mesh_cad_result& result)
{
  std::set<std::size_t> edges;
  double tolerance = 0;
  for(const auto& gap : result.shape.gaps) {
    edges.insert(gap.shape_edge);
    tolerance = (std::max)(tolerance, gap.tolerance);
  }
  if(!edges.empty())
    out << "  note: " << mesh_patch::plural(edges.size(), "edge lies", "edges lie") << " up to " << result.shape.largest_gap
        << " off their faces (file tolerance " << tolerance << ")"
        << (result.quality.is_closed ? "; harmless, the mesh is closed" : "") << "\n";
}

inline void print_angles(std::ostream& out, const Mesh_cad_result& result)
{
  const auto& m = result.measures;
  out << "  angles: minimum " << result.quality.min_angle;
  if(m.min_angle_apart > result.quality.min_angle)
    out << " (" << m.min_angle_apart << " apart from sharp corners)";
  out << " degrees, mean of each triangle's minimum " << result.quality.mean_min_angle << "; ";
  if(m.below_10 == 0)
    out << "none below 10\n";
  else
    out << mesh_patch::plural(m.below_10, "triangle") << " below 10 (" << m.below_10_at_corners << " of them in sharp corners)\n";
}

inline void print_inner_elements(std::ostream& out, const CGAL::Open_cascade_model_3& shape)
{
  std::size_t number_of_edges = 0, number_of_vertices = 0;
  for(const auto& edge : shape.inner_edges)
    if(edge.reason.empty())
      ++number_of_edges;
    else
      out << "  edge " << edge.shape_edge + 1 << " lies inside face " << edge.shape_face + 1
          << "; the mesh does not follow it: " << edge.reason << "\n";
  for(const auto& vertex : shape.inner_vertices)
    if(vertex.reason.empty())
      ++number_of_vertices;
    else
      out << "  vertex " << vertex.shape_vertex + 1 << " lies inside face " << vertex.shape_face + 1
          << "; the mesh does not have it: " << vertex.reason << "\n";
  if(number_of_edges + number_of_vertices > 0)
    out << "  the mesh follows " << mesh_patch::plural(number_of_edges, "edge") << " and "
        << mesh_patch::plural(number_of_vertices, "vertex", "vertices") << " inside faces\n";
}

inline void print_shape(std::ostream& out, const Mesh_cad_result& result)
{
  const auto& shape = result.shape;
  for(const std::string& fault : result.file_faults)
    out << "  NOT READ: " << fault << "\n";
  for(const std::string& fault : result.names.faults)
    out << "  note: " << fault << "\n";
  for(const auto& face : result.left_out)
    out << "  LEFT OUT face " << face.shape_face + 1 << ": " << face.reason << "\n";
  for(const auto& face : shape.closed_up)
    out << "  face " << closed_up_text(face) << "\n";
  if(!collapsed_edges(shape).empty())
    out << "  " << mesh_patch::plural(collapsed_edges(shape).size(), "short edge became a vertex", "short edges became vertices") << "\n";
  print_inner_elements(out, shape);
  print_imprints(out, result.imprints);
  if(!shape.repeated_faces.empty())
    out << "  " << mesh_patch::plural(shape.repeated_faces.size(), "face")
        << " of shells are in the file once more, outside of shells, and meshed once\n";
  if(!shape.turned_edges.empty())
    out << "  a shell that cannot be oriented is open at " << mesh_patch::plural(shape.turned_edges.size(), "edge") << "\n";
  print_contacts(out, result.contacts);
  if(result.number_of_sewn_edges > 0)
    out << "  sewing joined " << mesh_patch::plural(result.number_of_sewn_edges, "pair") << " of edges\n";
  if(result.number_of_lost_faces > 0)
    out << "  " << mesh_patch::plural(result.number_of_lost_faces, "face") << " LOST BY SEWING\n";
  print_gaps(out, result);
  if(shape.number_of_rebuilt_curves > 0)
    out << "  " << mesh_patch::plural(shape.number_of_rebuilt_curves, "curve")
        << " of the file missing or wrong in the domain of a face, and projected anew\n";
  if(shape.number_of_joined_vertices > 0)
    out << "  " << mesh_patch::plural(shape.number_of_joined_vertices, "vertex", "vertices")
        << " joined to others, within their tolerances\n";
  if(shape.number_of_reversed_faces > 0)
    out << "  " << mesh_patch::plural(shape.number_of_reversed_faces, "face") << " reversed to face to the same side as their neighbours\n";
}

// Detail of faces that still have triangles; those without are closed up.
inline void print_details(std::ostream& out, const Mesh_cad_result& result)
{
  const std::size_t max_number_of_lines = 10;
  std::set<std::size_t> closed_up;
  for(const auto& face : result.shape.closed_up)
    closed_up.insert(face.shape_face + 1);
  std::size_t number = 0;
  double moved = 0;
  for(const auto& face : details_by_face(result)) {
    const auto& detail = face.second;
    moved = (std::max)(moved, detail.moved);
    if(closed_up.count(face.first) > 0 || ++number > max_number_of_lines)
      continue;
    out << "  detail of face " << face.first << " at (" << detail.place[0] << ", " << detail.place[1]
        << ", " << detail.place[2] << ") is removed: " << mesh_patch::plural(detail.number_of_triangles, "triangle")
        << ", moved by at most " << detail.moved << "\n";
  }
  if(number > max_number_of_lines)
    out << "  and detail of " << mesh_patch::plural(number - max_number_of_lines, "other face") << ", moved by at most " << moved << "\n";
}

inline void print_summary(std::ostream& out, const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  const auto& q = result.quality;
  const auto& m = result.measures;
  out.precision(4);
  out << title(options) << ": " << mesh_patch::plural(result.shape.number_of_shape_faces, "face") << ", "
      << mesh_patch::plural(q.number_of_vertices, "vertex", "vertices") << ", "
      << mesh_patch::plural(q.number_of_faces, "triangle") << ", "
      << (q.is_closed ? "closed" : mesh_patch::plural(q.number_of_boundary_cycles, "border"));
  if(q.is_closed != result.shape.is_shape_closed && options.face_list.empty() && options.part_lists.empty())
    out << (q.is_closed ? ", ALTHOUGH THE SHAPE IS NOT CLOSED" : ", ALTHOUGH THE SHAPE IS CLOSED");
  out << "\n";
  print_shape(out, result);
  if(options.is_conformal && result.contacts.empty())
    out << "  no parts touch\n";
  print_details(out, result);
  print_intersections(out, result);
  print_angles(out, result);
  if(!m.tiny_edges.empty() || !m.sliver_faces.empty())
    out << "  " << mesh_patch::plural(m.tiny_edges.size(), "tiny edge") << ", "
        << mesh_patch::plural(m.sliver_faces.size(), "sliver face") << "\n";
  if(options.layers > 0)
    out << "  " << options.layers << " layers: edges of " << result.layers.smallest_length << " and more"
        << (result.layers.is_limited ? "; thinner places have fewer layers (--min-edge)" : "") << "\n";
  if(result.report.number_of_edges_added_to_thin_strips > 0)
    out << "  " << mesh_patch::plural(result.report.number_of_edges_added_to_thin_strips, "edge")
        << " more along faces so narrow that edges there are shorter than the minimum edge\n";
  out << "  distance from the shape: at most " << m.distance << " (" << m.distance / result.shape.diagonal << " of its diagonal)";
  const double rounding = 1e-6;
  if(share_of_allowed_distance(result) > 1 + rounding)
    out << ", MORE THAN THE BOUND OF " << *result.criteria.distance();
  out << "\n";
  if(result.second_order)
    mesh_patch::print_second_order(out, *result.second_order);
  print_deciding_bound(out, result.deciding_bounds);
  mesh_patch::print_unmet(out, result.report);
  out << "  " << result.meshing_seconds << " s for meshing (reading " << result.reading_seconds << ", model " << result.model_seconds
      << ", measuring " << result.measuring_seconds << ", looking for intersections " << result.intersections_seconds << ")\n";
}

// What --list or --list-faces asks for.
inline void list(std::ostream& out, const Mesh_cad_options& given)
{
  const double unit = unit_in_millimetres(given);
  Mesh_cad_options options = given;
  scale_lengths(unit, options);
  Mesh_cad_result result;
  Output_files files;
  Face_list faces;
  if(!options.json.empty()) {
    mesh_patch::check_ending("json", options.json, {".json"});
    files.add(options.json, [&](std::ostream& out_of_json) {
      nlohmann::ordered_json json = json_of_names(result.names);
      json["face_list"] = json_of_faces(faces, result.names);
      write_json(out_of_json, json);
    });
  }
  const TopoDS_Shape shape = read_shape(options, result);
  if(options.is_face_list_wanted || !options.json.empty())
    faces = face_list(shape, unit);
  print_parts(out, title(options), has_unit(options) ? options.unit : "the unit of the file", unit, result.names, shape);
  if(options.is_face_list_wanted)
    print_faces(out, faces, result.names);
  scale_lengths(1 / unit, result.names);
  files.write();
}

} // namespace mesh_cad

#endif // MESH_CAD_OUTPUT_H
