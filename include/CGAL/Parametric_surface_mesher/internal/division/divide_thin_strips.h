// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_DIVIDE_THIN_STRIPS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_DIVIDE_THIN_STRIPS_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Model_division.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Thin_strip_choice.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Thin_strip_division.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Thin_strips.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Triangulated_boundary.h>

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

struct Divided_thin_strips
{
  std::size_t number_of_pieces = 0; // those that there are more than before
  std::set<std::size_t> faces;      // those that use edges which have changed
  Sizes_beside_strips sizes;
};

// Divides the edges of thin strips among these faces, as far as that is cheap. Pieces may cross then.
template <class Oracle>
Divided_thin_strips divide_thin_strips(Model_division<Oracle>& division, const std::vector<Oracle>& oracles,
                                       const Parametric_surface_mesh_criteria& criteria,
                                       std::vector<Triangulated_boundary<Oracle>>& boundaries, const std::set<std::size_t>& faces)
{
  const Thin_strips<Oracle> find(division, oracles, criteria);
  std::map<std::size_t, typename Thin_strips<Oracle>::Places> strips;
  for(const std::size_t face : faces)
    division.is_done_for(face, [&] {
      boundaries[face].update(oracles[face], division.boundary_loops(face));
      auto places = find(face, boundaries[face]);
      if(!places.empty())
        strips.emplace(face, std::move(places));
    });
  Divided_thin_strips result;
  if(strips.empty())
    return result;
  Thin_strip_choice<Oracle> choose(division, oracles, criteria, boundaries);
  const auto chosen = choose(strips);
  result.number_of_pieces = Thin_strip_division<Model_division<Oracle>>(division, chosen)();
  for(const auto& edge : chosen)
    for(const auto& use : division.uses()[edge.first])
      result.faces.insert(use.face);
  result.sizes = choose.sizes();
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_DIVIDE_THIN_STRIPS_H
