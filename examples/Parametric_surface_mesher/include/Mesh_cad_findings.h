// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is wrong with a mesh of mesh_cad, and what is good to know of it, in sentences. The exit status follows from these, too.
#ifndef MESH_CAD_FINDINGS_H
#define MESH_CAD_FINDINGS_H

#include "Mesh_cad_contacts.h"
#include "Mesh_cad_details.h"
#include "Mesh_cad_imprints.h"
#include "Mesh_cad_options.h"
#include "Mesh_cad_result.h"
#include "Mesh_findings.h"
#include "Second_order_measures.h"
#include "Usage_error.h"
#include "distance_findings.h"
#include "findings_of_report.h"
#include "summary_lines.h"
#include "text_of_numbers.h"
#include "unit_of_length.h"

#include <CGAL/Open_cascade_model_3.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace mesh_cad {

inline mesh_patch::Text_of_length text_of_length(const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  return {has_unit(options) ? symbol_of_unit(options.unit) : "", mesh_patch::negligible_share_of_size * result.shape.diagonal};
}

inline bool are_only_some_faces_wanted(const Mesh_cad_options& options)
{
  return !options.face_list.empty() || !options.part_lists.empty();
}

// Faces that the mesh is without although they were wanted, and borders where they are missing.
inline void add_missing_faces(const Mesh_cad_options& options, const Mesh_cad_result& result, Mesh_findings& findings)
{
  for(const std::string& fault : result.file_faults)
    findings.faults.push_back("the file was not read completely: " + fault);
  std::vector<std::string> left_out;
  for(const auto& face : result.left_out)
    left_out.push_back("face " + std::to_string(face.shape_face + 1) + " is left out: " + face.reason);
  mesh_patch::append_first(left_out, "faces are left out, which --json lists", findings.faults);
  if(result.number_of_lost_faces > 0)
    findings.faults.push_back(mesh_patch::plural(result.number_of_lost_faces, "face was", "faces were")
                              + " lost when edges were joined; a smaller distance of --sew may keep them");
  if(are_only_some_faces_wanted(options) || result.quality.is_closed == result.shape.is_shape_closed)
    return;
  if(result.quality.is_closed)
    findings.notes.push_back("the mesh is closed, although the shape is not");
  else
    findings.faults.push_back("the mesh is not closed, although the shape is");
}

inline void add_distance(const Mesh_cad_result& result, Mesh_findings& findings)
{
  if(result.is_distance_measured)
    mesh_patch::add_distance("shape", result.measures.distance, *result.criteria.distance() + result.shape.largest_gap, findings);
  else
    findings.unchecked.push_back("the distance from the shape");
}

// Edges that lie farther off their faces than the file says.
inline void add_gaps(const Mesh_cad_result& result, const mesh_patch::Text_of_length& length, Mesh_findings& findings)
{
  std::set<std::size_t> edges;
  double tolerance = 0;
  for(const auto& gap : result.shape.gaps) {
    edges.insert(gap.shape_edge);
    tolerance = (std::max)(tolerance, gap.tolerance);
  }
  if(!edges.empty())
    findings.notes.push_back("the file is inexact: " + mesh_patch::plural(edges.size(), "edge lies", "edges lie") + " up to "
                             + length(result.shape.largest_gap) + " off a face, and the file says " + length(tolerance)
                             + (result.quality.is_closed ? "; this does no harm, the mesh is closed" : ""));
}

// Edges and vertices inside faces.
inline void add_inner_elements(const CGAL::Open_cascade_model_3& shape, Mesh_findings& findings)
{
  std::size_t number_of_edges = 0, number_of_vertices = 0;
  std::vector<std::string> not_followed;
  const auto add = [&](const char* what, std::size_t index, const auto& element, std::size_t& number) {
    if(element.reason.empty())
      ++number;
    else
      not_followed.push_back(what + (" " + std::to_string(index + 1)) + " lies inside face " + std::to_string(element.shape_face + 1)
                             + ", but the mesh does not follow it: " + element.reason);
  };
  for(const auto& edge : shape.inner_edges)
    add("edge", edge.shape_edge, edge, number_of_edges);
  for(const auto& vertex : shape.inner_vertices)
    add("vertex", vertex.shape_vertex, vertex, number_of_vertices);
  mesh_patch::append_first(not_followed, "edges and vertices inside faces that the mesh does not follow", findings.notes);
  const std::string edges = mesh_patch::plural(number_of_edges, "edge"),
                    vertices = mesh_patch::plural(number_of_vertices, "vertex", "vertices");
  if(number_of_edges + number_of_vertices > 0)
    findings.notes.push_back("the mesh follows "
                             + (number_of_vertices == 0 ? edges : number_of_edges == 0 ? vertices : edges + " and " + vertices)
                             + " inside faces");
}

// What was done to the shape so that it could be meshed.
inline void add_repairs(const Mesh_cad_result& result, Mesh_findings& findings)
{
  const auto add = [&](std::size_t number, const char* one, const char* several, const char* rest) {
    if(number > 0)
      findings.notes.push_back(mesh_patch::plural(number, one, several) + rest);
  };
  const auto& shape = result.shape;
  add(result.number_of_sewn_edges, "pair of edges was", "pairs of edges were", " joined, since they are at the same place");
  add(shape.repeated_faces.size(), "face is", "faces are", " in the file twice, in a shell and outside of shells, and meshed once");
  add(shape.turned_edges.size(), "edge of a shell is", "edges of a shell are", " open, since its faces cannot all face to the same side");
  add(shape.number_of_rebuilt_curves, "edge was", "edges were",
      " put on a face anew, since the file has no curve or a wrong one for it there");
  add(shape.number_of_joined_vertices, "vertex was", "vertices were", " joined to others, so close that the file takes them for the same");
  add(shape.number_of_reversed_faces, "face was", "faces were", " turned, to face to the same side as neighbours");
}

// What makes small triangles or angles.
inline void add_small_places(const Mesh_cad_options& options, const Mesh_cad_result& result, const mesh_patch::Text_of_length& length,
                             Mesh_findings& findings)
{
  const auto& m = result.measures;
  const std::string edges = mesh_patch::plural(m.tiny_edges.size(), "edge") + " shorter than a thousandth of its diagonal",
                    faces = mesh_patch::plural(m.sliver_faces.size(), "face") + " that "
                            + (m.sliver_faces.size() == 1 ? "is" : "are") + " long and narrow";
  if(!m.tiny_edges.empty() || !m.sliver_faces.empty())
    findings.notes.push_back("the shape has " + (m.tiny_edges.empty() ? faces : m.sliver_faces.empty() ? edges : edges + ", and " + faces)
                             + ": triangles are small there");
  if(options.layers > 0 && result.layers.is_limited)
    findings.notes.push_back("the thinnest places have fewer than " + mesh_patch::text_of(options.layers)
                             + " layers, since no edges shorter than " + length(result.layers.smallest_length)
                             + " were wanted; a smaller --min-edge allows more");
  if(const std::size_t number = result.report.number_of_edges_added_to_thin_strips)
    findings.notes.push_back("for the sake of angles narrow faces have " + mesh_patch::plural(number, "edge")
                             + " more than the shortest length (--min-edge) allows");
}

inline Mesh_findings findings(const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  const mesh_patch::Text_of_length length = text_of_length(options, result);
  Mesh_findings found;
  add_missing_faces(options, result, found);
  mesh_patch::add_stop(result.report, found);
  mesh_patch::add_unmet(result.report, result.criteria, length, found);
  add_distance(result, found);
  if(result.second_order)
    mesh_patch::add_second_order(*result.second_order, found);
  if(options.self_intersections == "ignore")
    found.unchecked.push_back("whether the mesh intersects itself");
  mesh_patch::add_intersections(result.report, [&](std::size_t face) { return result.shape.shape_faces[face] + 1; }, found);
  add_simplifications(result, length, found);
  add_small_places(options, result, length, found);
  add_gaps(result, length, found);
  add_repairs(result, found);
  add_contacts(result.contacts, length, found);
  if(options.is_conformal && result.contacts.empty())
    found.notes.push_back("no parts touch");
  add_imprints(result.imprints, length, found);
  add_inner_elements(result.shape, found);
  found.notes.insert(found.notes.end(), result.names.faults.begin(), result.names.faults.end());
  return found;
}

} // namespace mesh_cad

#endif // MESH_CAD_FINDINGS_H
