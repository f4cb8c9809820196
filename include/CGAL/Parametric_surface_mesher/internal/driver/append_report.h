// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_APPEND_REPORT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_APPEND_REPORT_H

#include <CGAL/Parametric_surface_mesh_report.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Adds what is told of a part of a mesh, whose faces begin with number `first_face`.
inline void append_report(const Parametric_surface_mesh_report& part, std::size_t first_face,
                          Parametric_surface_mesh_report& report)
{
  report.seconds += part.seconds;
  report.number_of_replaced_tensors += part.number_of_replaced_tensors;
  report.number_of_work_limits += part.number_of_work_limits;
  report.number_of_unjudged_faces += part.number_of_unjudged_faces;
  report.number_of_collapsed_faces += part.number_of_collapsed_faces;
  report.smallest_angle = (std::min)(report.smallest_angle, part.smallest_angle);
  report.smallest_angle_off_boundary = (std::min)(report.smallest_angle_off_boundary, part.smallest_angle_off_boundary);
  for(const auto& unmet : part.unmet)
    report.unmet.push_back({first_face + unmet.face, unmet.criteria, unmet.cause});
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_APPEND_REPORT_H
