// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_PLACE_IN_MODEL_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_PLACE_IN_MODEL_H

#include <CGAL/Parametric_surface_mesher/internal/model/inner_elements.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// What a point of a mesh lies on.
struct Place_in_model
{
  static constexpr std::size_t none = std::size_t(-1);

  int dimension = 2;         // 0 for a vertex, 1 for an edge, 2 for a face
  std::size_t entity = none; // the index of the vertex, edge or face, if it is known
  std::size_t number = none; // on an edge: the number of the point among those of its division
  bool is_inside_face = false; // whether it is a point of an edge inside a face, or such a vertex: curing leaves these as they are
};

// The places of the points of a division, by their indices.
template <class Division>
std::vector<Place_in_model> places_in_model(const Division& division)
{
  std::vector<Place_in_model> result(division.number_of_points());
  const std::vector<bool> are_inner_edges = internal::are_inner_edges(division.model());
  for(std::size_t e : division.uses().order()) {
    for(std::size_t i = 1; i < division.number_of_pieces(e); ++i)
      result[division.index(e, i)] = {1, e, i};
    for(std::size_t v : {division.model().edges()[e].source, division.model().edges()[e].target})
      result[division.vertex_index(v)] = {0, v, Place_in_model::none};
  }
  for(std::size_t v : division.inner_points())
    result[division.vertex_index(v)] = {0, v, Place_in_model::none, true};
  for(std::size_t e : division.uses().order())
    for(std::size_t i = 0; i <= division.number_of_pieces(e) && are_inner_edges[e]; ++i)
      result[division.index(e, i)].is_inside_face = true;
  return result;
}

// Whether a face uses the points of a division that is not left out, by their present indices.
template <class Division>
std::vector<bool> are_points_used(const Division& division)
{
  std::vector<bool> result(division.number_of_points(), false);
  for(std::size_t e : division.uses().order())
    for(std::size_t i = 0; i <= division.number_of_pieces(e); ++i)
      result[division.index(e, i)] = true;
  for(std::size_t v : division.inner_points())
    result[division.vertex_index(v)] = true;
  return result;
}

// The points of a division at which several pieces of the mesh may meet: the vertices of the model, and all points on edges that are
// not manifold.
template <class Division>
std::vector<std::size_t> meeting_points(const Division& division)
{
  std::vector<std::size_t> result;
  for(std::size_t v = 0; v < division.model().vertices().size(); ++v)
    if(division.is_used(v))
      result.push_back(division.vertex_index(v));
  for(std::size_t e : division.uses().order())
    if(!division.uses().is_manifold(e))
      for(std::size_t i = 1; i < division.number_of_pieces(e); ++i)
        result.push_back(division.index(e, i));
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_PLACE_IN_MODEL_H
