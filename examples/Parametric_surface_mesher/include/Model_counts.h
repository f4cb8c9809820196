// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a model consists of, in numbers.
#ifndef MODEL_COUNTS_H
#define MODEL_COUNTS_H

#include "Sample_models.h"
#include "Sample_surfaces.h"

#include <cstddef>
#include <vector>

// Collapsed edges are poles and count nowhere else.
struct Model_counts
{
  std::size_t faces = 0, vertices = 0, edges = 0, poles = 0;
  std::size_t border_edges = 0;      // used once
  std::size_t seams = 0;             // used twice by one face
  std::size_t nonmanifold_edges = 0; // used three times or more
};

inline Model_counts model_counts(const Sample_surface_model& model)
{
  std::vector<std::vector<std::size_t>> faces(model.edges().size()); // of the uses of each edge
  for(std::size_t f = 0; f < model.faces().size(); ++f)
    for(const auto& loop : model.faces()[f].loops)
      for(const auto& use : loop)
        faces[use.edge].push_back(f);

  Model_counts result;
  result.faces = model.faces().size();
  result.vertices = model.vertices().size();
  for(std::size_t e = 0; e < faces.size(); ++e) {
    if(model.edges()[e].is_collapsed) {
      ++result.poles;
      continue;
    }
    ++result.edges;
    result.border_edges += faces[e].size() == 1;
    result.seams += faces[e].size() == 2 && faces[e][0] == faces[e][1];
    result.nonmanifold_edges += faces[e].size() > 2;
  }
  return result;
}

// A single patch is a model of one face, each curve of its loops a border edge.
inline Model_counts model_counts(const CGAL::Parametric_domain_2<Sample_kernel>& domain)
{
  Model_counts result;
  result.faces = 1;
  for(const auto& loop : domain.loops())
    result.edges += loop.size();
  result.vertices = result.border_edges = result.edges;
  return result;
}

#endif // MODEL_COUNTS_H
