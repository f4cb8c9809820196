// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_APPEND_DIVISION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_APPEND_DIVISION_H

#include <CGAL/Parametric_surface_mesher/internal/division/Place_in_model.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Adds all points and edges of a division to a mesh.
// \pre the mesh is empty
template <class Division, class Kernel>
void append_division(const Division& division, Indexed_mesh<Kernel>& mesh)
{
  mesh.points.resize(division.number_of_points());
  mesh.domain_points.resize(division.number_of_points());
  mesh.places = places_in_model(division);
  for(std::size_t v = 0; v < division.model().vertices().size(); ++v)
    if(division.is_used(v))
      mesh.points[division.vertex_index(v)] = division.model().vertices()[v];
  for(std::size_t e : division.uses().order()) {
    const auto& points = division.points(e);
    for(std::size_t i = 1; i + 1 < points.size(); ++i)
      mesh.points[division.index(e, i)] = points[i];
    for(const auto& shell : division.uses().by_shell(e))
      for(std::size_t i = 0; i + 1 < points.size(); ++i)
        mesh.chords[shell.first].emplace(std::minmax(division.index(e, i), division.index(e, i + 1)));
  }
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_APPEND_DIVISION_H
