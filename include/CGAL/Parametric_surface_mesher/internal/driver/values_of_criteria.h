// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_VALUES_OF_CRITERIA_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_VALUES_OF_CRITERIA_H

#include <CGAL/Parametric_surface_mesh_criteria.h>

#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The values of the criteria that decide how a face is meshed once its boundary is divided, apart from the limit of vertices. Functions
// among the criteria have no value.
inline std::vector<double> values_of_criteria(const Parametric_surface_mesh_criteria& criteria)
{
  const double none = -1; // no value is negative
  return {criteria.max_edge(),
          criteria.min_edge(),
          criteria.size_factor(),
          criteria.growth(),
          criteria.gamma(),
          criteria.angle(),
          criteria.distance().value_or(none),
          double(criteria.feature_resolution()),
          double(criteria.curve_deviation()),
          double(criteria.placement()),
          criteria.max_number_of_sweeps() ? double(*criteria.max_number_of_sweeps()) : none,
          criteria.improvement_angle(),
          criteria.improvement_time(),
          double(criteria.part_size())};
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_VALUES_OF_CRITERIA_H
