// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Six-node triangles in the programs: their nodes, and what is said of them.
#ifndef SECOND_ORDER_MEASURES_H
#define SECOND_ORDER_MEASURES_H

#include "Unmet_count.h"

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

inline void print_second_order(std::ostream& out, const Second_order_measures& measures)
{
  const auto& r = measures.report;
  out << "  second order: smallest scaled Jacobian " << r.smallest_scaled_jacobian << ", distance of the curved triangles at most "
      << measures.distance;
  if(r.number_of_curved_less > 0)
    out << "; " << plural(r.number_of_curved_less, "edge") << " curved less";
  if(r.number_of_projected > 0)
    out << "; " << plural(r.number_of_projected, "node") << " projected";
  if(r.number_of_straight > 0)
    out << "; " << plural(r.number_of_straight, "edge") << " left straight";
  out << "\n";
  if(!r.uncertified.empty())
    out << "  " << plural(r.uncertified.size(), "triangle") << " NOT CERTIFIED, the first one is number " << r.uncertified.front().face + 1 << "\n";
}

} // namespace mesh_patch

#endif // SECOND_ORDER_MEASURES_H
