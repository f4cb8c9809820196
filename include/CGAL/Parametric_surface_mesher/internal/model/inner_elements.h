// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_INNER_ELEMENTS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_INNER_ELEMENTS_H

#include <CGAL/Parametric_surface_mesher/internal/model/Bad_faces.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Whether a loop of a face runs along an edge inside the face and back again.
template <class Loop>
bool is_inner_edge(const Loop& loop)
{
  return loop.size() == 2 && loop[0].edge == loop[1].edge && loop[0].is_reversed != loop[1].is_reversed
         && loop[0].curve.source() == loop[1].curve.source() && loop[0].curve.target() == loop[1].curve.target();
}

// By edge: whether a face has it inside.
template <class Model>
std::vector<bool> are_inner_edges(const Model& model)
{
  std::vector<bool> result(model.edges().size(), false);
  for(const auto& face : model.faces())
    for(const auto& loop : face.loops)
      if(is_inner_edge(loop))
        result[loop.front().edge] = true;
  return result;
}

// The vertices inside faces that are not left out.
template <class Model>
std::vector<std::size_t> inner_points(const Model& model, const Bad_faces& bad_faces)
{
  std::vector<std::size_t> result;
  for(std::size_t f = 0; f < model.faces().size(); ++f)
    for(const auto& point : model.faces()[f].inner_points)
      if(!model.faces()[f].loops.empty() && !bad_faces.contains(f))
        result.push_back(point.vertex);
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_INNER_ELEMENTS_H
