// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_IN_NUMBERS_OF_SHAPE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_IN_NUMBERS_OF_SHAPE_H

#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Crease_division.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The model of a divided shape, with the numbers that faces and edges have in the shape that was given.
inline Open_cascade_model_3 in_numbers_of_shape(Open_cascade_model_3 model, const Crease_division& division)
{
  const auto rename_face = [&](auto& entry) { entry.shape_face = division.old_face(entry.shape_face); };
  const auto rename_face_and_edge = [&](auto& entries) {
    for(auto& entry : entries) {
      rename_face(entry);
      entry.shape_edge = division.old_edge(entry.shape_edge);
    }
    // a crease is no edge of the shape
    const auto is_of_crease = [](const auto& entry) { return entry.shape_edge == Crease_division::no_index; };
    entries.erase(std::remove_if(entries.begin(), entries.end(), is_of_crease), entries.end());
  };
  for(auto* faces : {&model.shape_faces, &model.repeated_faces})
    for(std::size_t& face : *faces)
      face = division.old_face(face);
  std::for_each(model.left_out.begin(), model.left_out.end(), rename_face);
  std::for_each(model.closed_up.begin(), model.closed_up.end(), rename_face);
  rename_face_and_edge(model.gaps);
  rename_face_and_edge(model.inner_edges);
  for(auto& inner : model.inner_vertices) {
    rename_face(inner);
    inner.shape_vertex = division.old_vertex(inner.shape_vertex);
  }
  std::vector<std::vector<std::size_t>> model_edges(division.number_of_old_edges());
  for(std::size_t e = 0; e < model.model_edges.size(); ++e)
    if(division.old_edge(e) != Crease_division::no_index) {
      auto& same = model_edges[division.old_edge(e)];
      same.insert(same.end(), model.model_edges[e].begin(), model.model_edges[e].end());
    }
  model.model_edges = std::move(model_edges);
  for(std::size_t& vertex : model.shape_vertices)
    if(vertex != Open_cascade_model_3::none)
      vertex = division.old_vertex(vertex);
  model.number_of_shape_faces = division.number_of_old_faces();
  model.number_of_shape_edges = division.number_of_old_edges();
  return model;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_IN_NUMBERS_OF_SHAPE_H
