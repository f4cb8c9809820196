// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_CORNERS_OF_SOUP_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_CORNERS_OF_SOUP_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The indices of the three points of each triangle of a soup, one triangle after the other.
template <class TriangleRange>
std::vector<std::size_t> corners_of_soup(std::size_t number_of_points, const TriangleRange& triangles)
{
  std::vector<std::size_t> corners;
  std::size_t t = 0;
  for(const auto& triangle : triangles)
  {
    for(const auto& index : triangle)
      corners.push_back(static_cast<std::size_t>(index));
    if(corners.size() != 3 * (t + 1))
      throw Parametric_surface_mesh_error(numbered("face", t) + " of the soup has not three points");
    if(*std::max_element(corners.end() - 3, corners.end()) >= number_of_points)
      throw Parametric_surface_mesh_error(numbered("face", t) + " of the soup has a point index that is "
                                          "not below the number of points " + std::to_string(number_of_points));
    ++t;
  }
  return corners;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_CORNERS_OF_SOUP_H
