// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MESH_SIZES_H
#define MESH_SIZES_H

#include <cmath>
#include <optional>

// What a mesher is asked for.
struct Mesh_sizes
{
  double edge_length;             // where the distance does not ask for less
  std::optional<double> distance; // from the surface, the largest one; none asks for equal edges

  // the edge of which the middle is as far off an arc of this radius as is allowed
  double edge_length_on_arc(double radius) const
  {
    if(!distance)
      return edge_length;
    const double length = std::sqrt(8 * radius * *distance);
    return length < edge_length ? length : edge_length;
  }
};

#endif // MESH_SIZES_H
