// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Six-node triangles in the programs: their nodes, and what is said of them.
#ifndef SECOND_ORDER_MEASURES_H
#define SECOND_ORDER_MEASURES_H

#include "Mesh_findings.h"
#include "Usage_error.h"
#include "text_of_numbers.h"

#include <CGAL/make_second_order_mesh.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

struct Second_order_measures
{
  CGAL::Second_order_mesh_report report;
  double distance = 0; // the largest one from places of curved triangles to their surfaces
};

namespace mesh_patch {

// The number of pieces of a side between the places of a triangle that are measured.
const unsigned int subdivisions_for_distance = 4;

inline nlohmann::ordered_json json_of_second_order(const Second_order_measures& measures)
{
  const auto& r = measures.report;
  nlohmann::ordered_json uncertified = nlohmann::ordered_json::array();
  for(const auto& triangle : r.uncertified)
    uncertified.push_back(triangle.face + 1);
  return {{"smallest_scaled_jacobian", r.smallest_scaled_jacobian},
          {"uncertified", uncertified},
          {"curved_less", r.number_of_curved_less},
          {"nodes_on_edges", r.number_on_curves},
          {"nodes_on_faces", r.number_on_surfaces},
          {"projected_nodes", r.number_of_projected},
          {"straight_edges", r.number_of_straight},
          {"distance", measures.distance}};
}

// `is_measured`: whether the distance is known
inline void print_second_order(std::ostream& out, const Second_order_measures& measures, bool is_measured, const Text_of_length& length)
{
  const int digits = 3;
  out << "  curved triangles with six nodes: " << (is_measured ? "at most " + length(measures.distance) + " away; " : "")
      << "smallest scaled Jacobian " << text_of(measures.report.smallest_scaled_jacobian, digits) << " (1 is straight, 0 is folded)\n";
}

inline void add_second_order(const Second_order_measures& measures, Mesh_findings& findings)
{
  const auto& r = measures.report;
  if(!r.uncertified.empty())
    findings.faults.push_back(plural(r.uncertified.size(), "curved triangle has no area or is", "curved triangles have no area or are")
                              + " folded, the first one is number " + std::to_string(r.uncertified.front().face + 1));
  if(r.number_of_curved_less > 0)
    findings.notes.push_back(plural(r.number_of_curved_less, "side of a curved triangle bends", "sides of curved triangles bend")
                             + " less than the shape, so that no triangle is folded");
  if(r.number_of_projected > 0)
    findings.notes.push_back(plural(r.number_of_projected, "node lies", "nodes lie") + " on the shape only near the middle of the side");
  if(r.number_of_straight > 0)
    findings.notes.push_back(plural(r.number_of_straight, "side of a curved triangle stays", "sides of curved triangles stay")
                             + " straight, since no place for the node was found");
}

} // namespace mesh_patch

#endif // SECOND_ORDER_MEASURES_H
