// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which bound makes the triangles of a mesh as small as they are.
#ifndef DECIDING_BOUNDS_H
#define DECIDING_BOUNDS_H

#include "triangle_data.h"

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/pieces_of_patches.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <utility>
#include <vector>

namespace mesh_cad {

// The shares of triangles whose size is decided by a bound.
struct Deciding_bounds
{
  double max_edge = 0, gamma = 0, distance = 0;
  double surroundings = 0; // short edges and narrow places of the boundary, sizes of faces and edges, and what grows from these
};

// Counts a triangle for the bound that decides its size.
inline void add_triangle(const Triangle_corners& c, const CGAL::Open_cascade_surface_3& surface,
                         const CGAL::Parametric_surface_mesh_criteria& criteria, Deciding_bounds& numbers)
{
  const double share_of_bound = 0.5; // triangles that are smaller are so for the sake of what is around them
  const double factor_of_chord = 6; // of a triangle, by the height over its circumcircle; of an edge it is 8
  const double curvature = mesh_cad::curvature(c, surface),
               length = std::sqrt(std::sqrt(CGAL::squared_area(c.points[0], c.points[1], c.points[2])) * 4 / std::sqrt(3.));
  const double by_gamma = factor_of_chord * criteria.gamma() / curvature,
               by_distance = criteria.distance() ? std::sqrt(factor_of_chord * *criteria.distance() / curvature) : by_gamma,
               by_size = criteria.max_edge(), least = (std::min)({by_gamma, by_distance, by_size});
  double& number = !(length > share_of_bound * least) ? numbers.surroundings
                   : least == by_size                ? numbers.max_edge
                   : least == by_gamma               ? numbers.gamma
                                                     : numbers.distance;
  ++number;
}

template <class ConcurrencyTag>
Deciding_bounds deciding_bounds(const Cad_mesh& mesh, const CGAL::Open_cascade_model_3& shape,
                                const CGAL::Parametric_surface_mesh_criteria& criteria)
{
  using namespace CGAL::Parametric_surface_mesher::internal;
  const auto pieces = pieces_of_patches(mesh.mesh.faces(), [&](auto f) { return mesh.patch[f]; });
  std::vector<Deciding_bounds> numbers(pieces.size());
  for_each_piece<ConcurrencyTag>(shape.model, pieces, [&](const auto& piece, std::size_t i, const CGAL::Open_cascade_surface_3& surface) {
    for(const auto f : piece.faces)
      add_triangle(corners(mesh, f), surface, criteria, numbers[i]);
  });
  Deciding_bounds sum;
  for(double Deciding_bounds::*bound :
      {&Deciding_bounds::max_edge, &Deciding_bounds::gamma, &Deciding_bounds::distance, &Deciding_bounds::surroundings}) {
    for(const Deciding_bounds& number : numbers)
      sum.*bound += number.*bound;
    sum.*bound /= (std::max)(1., double(mesh.mesh.number_of_faces()));
  }
  return sum;
}

inline nlohmann::ordered_json json_of_bounds(const Deciding_bounds& bounds)
{
  return {{"max_edge", bounds.max_edge}, {"gamma", bounds.gamma}, {"distance", bounds.distance}, {"surroundings", bounds.surroundings}};
}

// The most important one.
inline void print_deciding_bound(std::ostream& out, const Deciding_bounds& bounds)
{
  const std::array<std::pair<double, const char*>, 4> all
    = {{{bounds.max_edge, "the largest edge length (--max-edge)"},
        {bounds.gamma, "the curvature (--elements-per-turn)"},
        {bounds.distance, "the curvature and the allowed distance (--distance)"},
        {bounds.surroundings, "short edges, narrow places or given sizes nearby (--growth)"}}};
  const auto largest = std::max_element(all.begin(), all.end());
  out << "  edge lengths: decided for " << std::lround(100 * largest->first) << " % of the triangles by " << largest->second << "\n";
}

} // namespace mesh_cad

#endif // DECIDING_BOUNDS_H
