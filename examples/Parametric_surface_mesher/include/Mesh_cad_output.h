// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files of mesh_cad, and its lists of parts and faces.
#ifndef MESH_CAD_OUTPUT_H
#define MESH_CAD_OUTPUT_H

#include "Mesh_cad_faces.h"
#include "Mesh_cad_json.h"
#include "Mesh_cad_options.h"
#include "Mesh_cad_parts.h"
#include "Mesh_cad_result.h"
#include "Mesh_cad_summary.h"
#include "Output_files.h"
#include "json_of_names.h"
#include "unit_of_length.h"
#include "write_mesh_cad_file.h"
#include "write_page.h"

#include <nlohmann/json.hpp>

#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace mesh_cad {

inline void write_picture(std::ostream& out, const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  mesh_patch::write_picture(out, options.picture, result.page, title(options));
}

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
