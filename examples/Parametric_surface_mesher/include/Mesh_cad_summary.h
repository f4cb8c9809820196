// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What mesh_cad prints of a mesh, for people.
#ifndef MESH_CAD_SUMMARY_H
#define MESH_CAD_SUMMARY_H

#include "Mesh_cad_findings.h"
#include "Mesh_cad_options.h"
#include "Mesh_cad_result.h"
#include "Second_order_measures.h"
#include "deciding_bounds.h"
#include "summary_lines.h"
#include "text_of_numbers.h"

#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include <cstddef>
#include <ostream>
#include <set>
#include <string>

namespace mesh_cad {

// As "18 solids, 160 faces". Shells of solids do not count.
inline std::string contents_of(const TopoDS_Shape& shape)
{
  TopTools_IndexedMapOfShape solids, faces;
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopTools_IndexedDataMapOfShapeListOfShape shells;
  TopExp::MapShapesAndAncestors(shape, TopAbs_SHELL, TopAbs_SOLID, shells);
  std::size_t number_of_shells = 0;
  for(const TopTools_ListOfShape& solids_of_shell : shells)
    number_of_shells += solids_of_shell.IsEmpty();
  std::string result;
  if(solids.Extent() > 0)
    result += mesh_patch::plural(std::size_t(solids.Extent()), "solid") + ", ";
  if(number_of_shells > 0)
    result += mesh_patch::plural(number_of_shells, "shell") + ", ";
  return result + mesh_patch::plural(std::size_t(faces.Extent()), "face");
}

// The name of what is in the file if there is one, and if the name of the file does not tell.
inline std::string name_of_contents(const Mesh_cad_options& options, const Names& names)
{
  std::set<std::string> roots;
  for(const auto& part : names.parts)
    if(part.parent == Names::none)
      roots.insert(part.name);
  const std::string file = title(options), stem = file.substr(0, file.find_last_of('.'));
  return roots.size() == 1 && *roots.begin() != stem && !roots.begin()->empty() ? "'" + *roots.begin() + "', " : "";
}

// The first line: what the file has.
inline void print_shape(std::ostream& out, const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  out << title(options) << ": " << name_of_contents(options, result.names) << contents_of(result.open_cascade_shape);
  if(are_only_some_faces_wanted(options)) {
    const std::size_t number = number_of_meshed_faces(result);
    out << ", of which " << number << (number == 1 ? " is" : " are") << " meshed";
  }
  out << "; " << mesh_patch::text_of_size(mesh_patch::sides(result.measures.box)) << " "
      << (has_unit(options) ? symbol_of_unit(options.unit) : "in the unit of the file") << "\n";
}

inline std::string why_open(const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  return are_only_some_faces_wanted(options) ? ", as not all faces are meshed" : result.shape.is_shape_closed ? "" : ", as the shape is";
}

inline void print_angles(std::ostream& out, const Mesh_cad_result& result)
{
  const auto& m = result.measures;
  const std::string minimum = mesh_patch::text_of_angle(result.quality.min_angle), apart = mesh_patch::text_of_angle(m.min_angle_apart);
  const bool is_other_apart = apart != minimum && m.min_angle_apart < 180; // which it is if all angles are in sharp corners
  const std::string behind_minimum = is_other_apart ? " (" + apart + " apart from sharp corners of the shape)" : "";
  std::string behind_number;
  if(m.below_10_at_corners > 0)
    behind_number = (m.below_10_at_corners == m.below_10 ? ", at" : ", " + std::to_string(m.below_10_at_corners) + " of them at")
                    + std::string(" sharp corners of the shape");
  mesh_patch::print_angles(out, result.quality, m.below_10, {behind_minimum, behind_number});
}

inline void print_summary(std::ostream& out, const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  const mesh_patch::Text_of_length length = text_of_length(options, result);
  print_shape(out, options, result);
  mesh_patch::print_triangles(out, result.quality, why_open(options, result));
  print_angles(out, result);
  const double* distance = result.is_distance_measured ? &result.measures.distance : nullptr;
  mesh_patch::print_distance(out, "shape", distance, &*result.criteria.distance(), length);
  if(result.second_order)
    mesh_patch::print_second_order(out, *result.second_order, result.is_distance_measured, length);
  if(result.is_distance_measured)
    print_deciding_bound(out, result.deciding_bounds);
  if(options.layers > 0)
    out << "  layers: edges of " << length(result.layers.smallest_length) << " and more, for " << mesh_patch::text_of(options.layers)
        << " layers of elements in walls and gaps\n";
  mesh_patch::print_seconds(out, {{"reading", result.reading_seconds},
                                  {"preparing", result.model_seconds},
                                  {"meshing", result.meshing_seconds},
                                  {"curving", result.second_order_seconds},
                                  {"looking for intersections", result.intersections_seconds},
                                  {"measuring", result.measuring_seconds}});
  mesh_patch::print_findings(out, findings(options, result));
}

} // namespace mesh_cad

#endif // MESH_CAD_SUMMARY_H
