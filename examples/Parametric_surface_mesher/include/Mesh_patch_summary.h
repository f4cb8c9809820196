// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What mesh_patch prints of a mesh, for people. The exit status follows from the findings, too.
#ifndef MESH_PATCH_SUMMARY_H
#define MESH_PATCH_SUMMARY_H

#include "Mesh_findings.h"
#include "Mesh_patch_input.h"
#include "Mesh_patch_result.h"
#include "Model_counts.h"
#include "Second_order_measures.h"
#include "Usage_error.h"
#include "distance_findings.h"
#include "findings_of_report.h"
#include "summary_lines.h"
#include "text_of_numbers.h"

#include <CGAL/Bbox_3.h>

#include <cstddef>
#include <ostream>
#include <string>

namespace mesh_patch {

inline Mesh_findings findings(const Mesh_patch_input& input, const Mesh_patch_result& result)
{
  const Text_of_length length;
  const auto& d = result.deviation;
  Mesh_findings found;
  if(const std::size_t number = d.number_of_inverted_faces + d.number_of_domain_violations)
    found.faults.push_back(plural(number, "triangle is", "triangles are") + " turned to the wrong side in the domain, or outside of it");
  if(!result.quality.is_manifold && counts(input).nonmanifold_edges == 0)
    found.notes.push_back("at some vertices several sheets of triangles meet: the mesh is not manifold");
  add_stop(result.report, found);
  add_unmet(result.report, result.criteria, length, found);
  if(result.criteria.distance())
    add_distance("surface", result.distance, *result.criteria.distance(), found);
  if(result.second_order)
    add_second_order(*result.second_order, found);
  add_intersections(result.report, [](std::size_t face) { return face + 1; }, found);
  return found;
}

inline void print_summary(std::ostream& out, const Mesh_patch_input& input, const Mesh_patch_result& result)
{
  const CGAL::Bbox_3 box = box_of(result.mesh);
  const Text_of_length length = text_of_length(box);
  const auto& q = result.quality;
  const auto& allowed = result.criteria.distance();
  out << input.name << ": ";
  if(input.patches.size() > 1)
    out << plural(input.patches.size(), "face") << "; ";
  out << text_of_size(sides(box)) << "\n";
  print_triangles(out, q, q.number_of_connected_components > 1 ? ", " + plural(q.number_of_connected_components, "separate piece") : "");
  print_angles(out, q, number_below_10_degrees(q));
  print_distance(out, "surface", &result.distance, allowed ? &*allowed : nullptr, length);
  if(result.second_order)
    print_second_order(out, *result.second_order, true, length);
  out << "  time: " << text_of(result.report.seconds.meshing(), 2) << " s for meshing\n";
  print_findings(out, findings(input, result));
}

} // namespace mesh_patch

#endif // MESH_PATCH_SUMMARY_H
