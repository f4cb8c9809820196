// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_SHELLS_OF_FACES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_SHELLS_OF_FACES_H

#include <CGAL/Parametric_surface_mesher/internal/model/Other_sides.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The shells of the faces of a model.
template <class Model>
std::vector<std::size_t> shells(const Model& model)
{
  std::vector<std::size_t> result;
  for(const auto& face : model.faces())
    result.push_back(face.shell);
  return result;
}

// By face: its shell, and that of its other side, or `none`.
template <class Model>
std::vector<std::array<std::size_t, 2>> shells_on_both_sides(const Model& model, const Other_sides& other_sides)
{
  std::vector<std::array<std::size_t, 2>> result;
  for(std::size_t f = 0; f < model.faces().size(); ++f) {
    const std::size_t back = other_sides.back(f);
    result.push_back({model.faces()[f].shell, back == Other_sides::none ? Other_sides::none : model.faces()[back].shell});
  }
  return result;
}


} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_SHELLS_OF_FACES_H
