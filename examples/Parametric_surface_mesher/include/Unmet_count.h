// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef UNMET_COUNT_H
#define UNMET_COUNT_H

#include <CGAL/Parametric_surface_mesh_report.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace mesh_patch {

// Triangles that fail the same criteria for the same cause.
struct Unmet_count
{
  CGAL::Parametric_surface_mesher::Criterion_set criteria;
  CGAL::Parametric_surface_mesher::Unmet_cause cause;
  std::size_t triangles;
};

// by cause, then criteria
inline std::vector<Unmet_count> unmet_counts(const CGAL::Parametric_surface_mesh_report& report)
{
  using namespace CGAL::Parametric_surface_mesher;
  std::map<std::pair<Unmet_cause, Criterion_set>, std::size_t> counts;
  for(const auto& unmet : report.unmet)
    ++counts[{unmet.cause, unmet.criteria}];
  std::vector<Unmet_count> result;
  for(const auto& count : counts)
    result.push_back({count.first.second, count.first.first, count.second});
  return result;
}

inline nlohmann::ordered_json json_of_unmet(const CGAL::Parametric_surface_mesh_report& report)
{
  nlohmann::ordered_json result = nlohmann::ordered_json::array();
  for(const Unmet_count& count : unmet_counts(report)) {
    nlohmann::ordered_json criteria = nlohmann::ordered_json::array();
    for(const auto criterion : CGAL::Parametric_surface_mesher::all_criteria())
      if(count.criteria.contains(criterion))
        criteria.push_back(name(criterion));
    result.push_back({{"criteria", criteria}, {"cause", name(count.cause)}, {"triangles", count.triangles}});
  }
  return result;
}

} // namespace mesh_patch

#endif // UNMET_COUNT_H
