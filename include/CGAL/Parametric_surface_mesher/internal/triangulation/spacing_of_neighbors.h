// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_SPACING_OF_NEIGHBORS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_SPACING_OF_NEIGHBORS_H

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The mean spacing of the neighbours of a vertex, weighted by their inverse distances in space; infinity if none has a finite one.
template <class Triangulation>
double spacing_of_neighbors(const Triangulation& triangulation, typename Triangulation::Vertex_handle vertex)
{
  std::vector<std::pair<double, double>> neighbors; // weight and spacing; sorted, so that the sum does not depend on the first neighbour
  auto neighbor = triangulation.incident_vertices(vertex);
  const auto first = neighbor;
  do
    if(!triangulation.is_infinite(neighbor) && std::isfinite(neighbor->spacing()))
      neighbors.emplace_back(1 / std::sqrt(squared_distance(vertex->point().surface_point(), neighbor->point().surface_point())),
                             neighbor->spacing());
  while(++neighbor != first);
  std::sort(neighbors.begin(), neighbors.end());
  double sum = 0, weights = 0;
  for(const auto& of_neighbor : neighbors) {
    sum += of_neighbor.first * of_neighbor.second;
    weights += of_neighbor.first;
  }
  return weights > 0 ? sum / weights : std::numeric_limits<double>::infinity();
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_SPACING_OF_NEIGHBORS_H
