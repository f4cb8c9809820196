// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_LEAST_NUMBERS_OF_PIECES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_LEAST_NUMBERS_OF_PIECES_H

#include <CGAL/Parametric_surface_mesher/internal/model/Model_uses.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The number of pieces that each edge needs at least. A loop must have three pieces, no two pieces may have the same ends, and an
// edge at which the mesh is cut must have an inner point.
template <class Model>
std::vector<std::size_t> least_numbers_of_pieces(const Model& model, const Model_uses<Model>& uses)
{
  std::vector<std::size_t> result(model.edges().size(), 1);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> edges_between; // by the two vertices
  for(std::size_t e : uses.order()) {
    const auto& edge = model.edges()[e];
    const auto first = edges_between.emplace(std::minmax(edge.source, edge.target), e);
    if(edge.source == edge.target)
      result[e] = 3;
    else if(!uses.is_manifold(e))
      result[e] = 2;
    if(edge.source != edge.target && !first.second)
      result[e] = result[first.first->second] = 2;
  }
  for(const auto& face : model.faces())
    for(const auto& loop : face.loops) {
      const std::size_t n = std::count_if(loop.begin(), loop.end(),
                                          [&](const auto& use) { return !model.edges()[use.edge].is_collapsed; });
      for(const auto& use : loop)
        result[use.edge] = (std::max)(result[use.edge], n == 1 ? std::size_t(3) : n == 2 ? 2 : 1);
    }
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_LEAST_NUMBERS_OF_PIECES_H
