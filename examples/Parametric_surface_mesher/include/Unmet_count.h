// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef UNMET_COUNT_H
#define UNMET_COUNT_H

#include <CGAL/Parametric_surface_mesh_report.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace mesh_patch {

struct Unmet_count
{
  const char *criterion, *cause;
  std::size_t triangles;
};

// The triangles that fail, by criterion and cause, without those that there are none of.
inline std::vector<Unmet_count> unmet_counts(const CGAL::Parametric_surface_mesh_report& report)
{
  using CGAL::Mesh_criterion;
  using CGAL::Unmet_cause;
  static const std::pair<Mesh_criterion, const char*> criteria[]
    = {{Mesh_criterion::SIZE, "size"}, {Mesh_criterion::ANGLE, "angle"}, {Mesh_criterion::DEVIATION, "deviation"},
       {Mesh_criterion::DISTANCE, "distance"}};
  static const std::pair<Unmet_cause, const char*> causes[]
    = {{Unmet_cause::BOUNDARY, "boundary"}, {Unmet_cause::MINIMUM_EDGE, "minimum edge"},
       {Unmet_cause::NO_BETTER_POINT, "lack of a better point"}, {Unmet_cause::VERTEX_LIMIT, "vertex limit"},
       {Unmet_cause::STOPPED, "stopped"}};
  std::vector<Unmet_count> result;
  for(const auto& cause : causes)
    for(const auto& criterion : criteria)
      if(const std::size_t n = report.count(criterion.first, cause.first))
        result.push_back({criterion.second, cause.second, n});
  return result;
}

} // namespace mesh_patch

#endif // UNMET_COUNT_H
