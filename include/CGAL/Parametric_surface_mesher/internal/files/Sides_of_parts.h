// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_SIDES_OF_PARTS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_SIDES_OF_PARTS_H

#include <CGAL/Element_mesh_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// One side of a triangle, as a part has it. Triangles without a part have one side.
struct Side_of_part
{
  std::array<std::size_t, 3> nodes;
  std::size_t part; // or the number of parts
  std::size_t surface;
};

// The sides of all triangles, in the order of these. A triangle between two parts has one side for each of them.
inline std::vector<Side_of_part> sides_of_parts(const Element_mesh_3& mesh)
{
  std::vector<Side_of_part> result;
  for(std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    const std::size_t surface = mesh.triangle_surfaces[i];
    const auto& parts = mesh.surfaces[surface].parts;
    result.push_back({{{t[0], t[1], t[2]}}, (std::min)(parts[0], mesh.parts.size()), surface});
    if(parts[1] < mesh.parts.size())
      result.push_back({{{t[0], t[2], t[1]}}, parts[1], surface});
  }
  return result;
}

// The sides of the triangles, in a list for each part, and in a last one if they are of no part.
inline std::vector<std::vector<Side_of_part>> sides_by_part(const Element_mesh_3& mesh)
{
  std::vector<std::vector<Side_of_part>> result(mesh.parts.size() + 1);
  for(const Side_of_part& side : sides_of_parts(mesh))
    result[side.part].push_back(side);
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_SIDES_OF_PARTS_H
