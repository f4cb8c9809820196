// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_MESHED_PATCH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_MESHED_PATCH_H

#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Partial_mesh.h>

#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The triangles of a patch: what its mesher hands over. It refers to nothing else.
template <class Kernel>
struct Meshed_patch
{
  struct Part
  {
    Partial_mesh<Kernel> mesh;
    Parametric_surface_mesh_report report;
  };

  std::vector<Part> parts;
  std::vector<typename Kernel::Point_3> cut_points; // that the parts share; `Partial_mesh` tells how they are numbered
  std::vector<typename Kernel::Point_2> cut_domain_points;
  Parametric_surface_mesh_report report; // what is not told of the parts
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_MESHED_PATCH_H
