// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A comparison as data for plot_comparison.py.
#ifndef WRITE_COMPARISON_H
#define WRITE_COMPARISON_H

#include "Comparison_run.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

inline nlohmann::json json_of(const Comparison_run& run)
{
  nlohmann::json result = {{"shape", run.shape},
                           {"mesher", run.mesher},
                           {"target", run.target.kind == Comparison_target::TRIANGLES ? "triangles" : "distance"},
                           {"value", run.target.value},
                           {"triangles", run.verdict.faces},
                           {"distance", run.verdict.distance},
                           {"min_angle", run.verdict.min_angle},
                           {"mean_radius_ratio", run.verdict.mean_radius_ratio},
                           {"smallest_angles", run.verdict.smallest_angles}};
  if(!run.seconds.empty())
    result["seconds"] = median(run.seconds);
  return result;
}

// The triangles of a mesh with a corner in a ball, each by nine coordinates.
inline nlohmann::json json_of_triangles(const Sample_mesh& mesh, const comparison::Point_3& center, double radius)
{
  nlohmann::json result = nlohmann::json::array();
  for(const auto& t : comparison::triangles_of(mesh)) {
    bool is_near = false;
    nlohmann::json corners;
    for(int i = 0; i < 3; ++i) {
      is_near = is_near || CGAL::squared_distance(t[i], center) < radius * radius;
      for(int k = 0; k < 3; ++k)
        corners.push_back(t[i][k]);
    }
    if(is_near)
      result.push_back(corners);
  }
  return result;
}

#endif // WRITE_COMPARISON_H
