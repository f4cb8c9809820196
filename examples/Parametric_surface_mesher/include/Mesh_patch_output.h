// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files of mesh_patch.
#ifndef MESH_PATCH_OUTPUT_H
#define MESH_PATCH_OUTPUT_H

#include "Mesh_patch_input.h"
#include "Mesh_patch_options.h"
#include "Mesh_patch_result.h"
#include "Mesh_patch_summary.h"
#include "Model_counts.h"
#include "Output_files.h"
#include "Patch_triangles.h"
#include "Unmet_count.h"
#include "write_mesh_file.h"
#include "write_mesh_picture.h"
#include "write_page.h"
#include "write_second_order_patch.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace mesh_patch {

// All patches as one mesh of points (u,v,0).
inline Mesh domain_mesh(const Mesh_patch_result& result)
{
  Mesh mesh;
  const Uv_layout layout(result.patches);
  for(std::size_t i = 0; i < result.patches.size(); ++i) {
    const Patch_triangles& patch = result.patches[i];
    const std::array<double, 2> t = layout.translation(i);
    const std::size_t first = mesh.number_of_vertices();
    for(const auto v : patch.mesh.vertices())
      mesh.add_vertex({patch.uv[v].x() + t[0], patch.uv[v].y() + t[1], 0});
    for(const auto face : patch.mesh.faces()) {
      std::vector<Mesh::Vertex_index> corners;
      for(const auto v : patch.mesh.vertices_around_face(patch.mesh.halfedge(face)))
        corners.push_back(Mesh::Vertex_index(Mesh::size_type(first + v)));
      mesh.add_face(corners);
    }
  }
  return mesh;
}

inline void write_picture(std::ostream& out, const Mesh_patch_input& input, const Mesh_patch_options& options,
                          const Mesh_patch_result& result)
{
  write_picture(out, options.picture, result.page, input.name);
}

inline void write_uv_picture(std::ostream& out, const Mesh_patch_input& input, const Mesh_patch_result& result)
{
  Domain_picture_options picture;
  const Uv_layout layout(result.patches);
  picture.title = input.name;
  picture.is_range_shown = layout.columns == 1;
  if(layout.columns > 1)
    picture.title += ", patches in rows of " + std::to_string(layout.columns);
  for(std::size_t i = 0; i < result.ellipses.size(); ++i)
    for(const auto& e : result.ellipses[i])
      picture.ellipses.push_back({{e.center().x() + layout.translation(i)[0], e.center().y() + layout.translation(i)[1]},
                                  e.a(), e.b(), e.alpha()});
  const Mesh mesh = domain_mesh(result);
  const auto arrays = mesh_picture::arrays<2>(mesh, [&](auto v) { return mesh.point(v); });
  write_domain_picture(out, arrays.first, arrays.second, picture);
}

inline nlohmann::ordered_json json_of_model(const Model_counts& counts)
{
  return {{"faces", counts.faces},
          {"model_vertices", counts.vertices},
          {"model_edges", counts.edges},
          {"model_border_edges", counts.border_edges},
          {"model_seams", counts.seams},
          {"model_poles", counts.poles},
          {"model_nonmanifold_edges", counts.nonmanifold_edges}};
}

inline nlohmann::ordered_json json_of_shape(const CGAL::Triangle_mesh_quality& q, const CGAL::Triangle_mesh_deviation& d, double distance)
{
  return {{"vertices", q.number_of_vertices},
          {"triangles", q.number_of_faces},
          {"edges", q.number_of_edges},
          {"area", q.area},
          {"min_angle", q.min_angle},
          {"mean_min_angle", q.mean_min_angle},
          {"max_angle", q.max_angle},
          {"min_radius_ratio", q.min_radius_ratio},
          {"mean_radius_ratio", q.mean_radius_ratio},
          {"shortest_edge", q.min_edge_length},
          {"mean_edge", q.mean_edge_length},
          {"longest_edge", q.max_edge_length},
          {"max_deviation", d.max_inner_deviation_ratio},
          {"max_normal_deviation", d.max_inner_normal_deviation_ratio},
          {"max_boundary_deviation", d.max_border_deviation_ratio},
          {"max_distance", distance},
          {"inverted_triangles", d.number_of_inverted_faces + d.number_of_domain_violations},
          {"connected_components", q.number_of_connected_components},
          {"boundary_cycles", q.number_of_boundary_cycles},
          {"border_edges", q.number_of_border_edges},
          {"euler_characteristic", q.euler_characteristic},
          {"closed", q.is_closed},
          {"manifold", q.is_manifold}};
}

inline nlohmann::ordered_json json_of_report(const CGAL::Parametric_surface_mesh_report& report)
{
  const std::size_t boundary_limited = report.count(CGAL::Parametric_surface_mesher::Unmet_cause::BOUNDARY);
  const auto& s = report.seconds;
  return {{"min_angle_off_boundary", report.smallest_angle_off_boundary},
          {"division_edges", report.number_of_boundary_edges},
          {"boundary_limited", boundary_limited},
          {"unmet", report.unmet.size() - boundary_limited},
          {"unmet_by", json_of_unmet(report)},
          {"unjudged", report.number_of_unjudged_faces},
          {"work_limits", report.number_of_work_limits},
          {"seconds", {{"division", s.division}, {"triangulation", s.triangulation}, {"refinement", s.refinement},
                       {"improvement", s.improvement}, {"output", s.output}, {"meshing", s.meshing()}}}};
}

inline void write_json(std::ostream& out, const Mesh_patch_input& input, const Mesh_patch_options& options,
                       const Mesh_patch_result& result)
{
  const auto& criteria = result.criteria;
  const Uv_layout layout(result.patches);
  nlohmann::ordered_json json
    = {{"name", input.name}, {"metric", options.metric}, {"max_edge", criteria.max_edge()},
       {"min_edge", criteria.min_edge()}, {"gamma", criteria.gamma()}, {"angle", criteria.angle()},
       {"size_factor", criteria.size_factor()}, {"patches", result.patches.size()},
       {"uv_columns", layout.columns}, {"uv_shift", layout.shift}};
  if(criteria.distance())
    json["distance"] = *criteria.distance();
  json.update(json_of_model(counts(input)));
  json.update(json_of_shape(result.quality, result.deviation, result.distance));
  json.update(json_of_report(result.report));
  json["order"] = result.second_order ? 2 : 1;
  if(result.second_order)
    json["second_order"] = json_of_second_order(*result.second_order);
  out << json.dump(2) << "\n";
}

inline void write_page(std::ostream& out, const Mesh_patch_input& input, const Mesh_patch_result& result)
{
  std::ostringstream summary;
  print_summary(summary, input, result);
  write_page(out, result.page, input.name, "", summary.str());
}

// The files that the options ask for; throws if one of them could not be written later. They take what is in `input` and
// `result` when they are written.
inline Output_files output_files(const Mesh_patch_options& o, const Mesh_patch_input& input, const Mesh_patch_result& result)
{
  Output_files files;
  const auto add = [&](const char* option, const std::string& name, const std::vector<std::string>& endings,
                       Output_files::Writer write) {
    if(name.empty())
      return;
    check_ending(option, name, endings);
    files.add(name, std::move(write));
  };
  const std::vector<std::string> formats = {".off", ".obj", ".ply", ".stl"};
  add("out", o.out, o.order == 2 ? endings_for_second_order() : formats, [&](std::ostream& out) {
    if(result.second_order)
      write_second_order(out, o.out, result);
    else
      write_mesh(out, o.out, result.mesh, [](std::size_t patch) { return patch + 1; });
  });
  add("uv", o.uv, formats, [&](std::ostream& out) { write_mesh(out, o.uv, domain_mesh(result)); });
  add("picture", o.picture, {".png", ".svg"}, [&](std::ostream& out) { write_picture(out, input, o, result); });
  add("uv-picture", o.uv_picture, {".svg"}, [&](std::ostream& out) { write_uv_picture(out, input, result); });
  add("page", o.page, {".html"}, [&](std::ostream& out) { write_page(out, input, result); });
  add("json", o.json, {".json"}, [&](std::ostream& out) { write_json(out, input, o, result); });
  return files;
}

} // namespace mesh_patch

#endif // MESH_PATCH_OUTPUT_H
