// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_PIECES_OF_PATCHES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_PIECES_OF_PATCHES_H

#include <CGAL/Parametric_surface_mesher/internal/support/run_jobs.h>
#include <CGAL/Parametric_surface_mesher/internal/surfaces/are_copies_independent.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iterator>
#include <map>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Triangles of a mesh that lie on the same face of a model: as many as one job measures.
template <class Face>
struct Piece_of_patch
{
  std::size_t patch;
  bool is_first; // of its patch
  std::vector<Face> faces;
};

// `faces`: those of a mesh; `patch_of`: gives the index in the model of what a face lies on. The pieces do not depend on the number of
// threads.
template <class FaceRange, class PatchOf>
auto pieces_of_patches(const FaceRange& faces, const PatchOf& patch_of)
{
  typedef std::decay_t<decltype(*std::begin(faces))> Face;
  const std::size_t largest = 4096; // a job takes some milliseconds: the scheduler costs nothing, and threads end at the same time
  std::vector<Piece_of_patch<Face>> result;
  std::map<std::size_t, std::size_t> last_pieces; // by patch, the index of the piece that is not full
  for(const Face f : faces) {
    const std::size_t patch = patch_of(f);
    const auto last = last_pieces.emplace(patch, result.size());
    const bool is_first = last.second;
    if(is_first || result[last.first->second].faces.size() == largest) {
      last.first->second = result.size();
      result.push_back({patch, is_first, {}});
    }
    result[last.first->second].faces.push_back(f);
  }
  return result;
}

// Calls `function` with each piece, its index, and the surface of its patch, which is a copy: surfaces may keep what they were last asked
// for. Of several exceptions the one of the first piece is thrown.
template <class ConcurrencyTag, class Model, class Piece, class Function>
void for_each_piece(const Model& model, const std::vector<Piece>& pieces, const Function& function)
{
  std::vector<typename Model::Surface_3> surfaces;
  std::vector<Job> jobs;
  for(const Piece& piece : pieces) {
    const auto& surface = model.faces()[piece.patch].surface;
    surfaces.push_back(surface);
    jobs.push_back({double(piece.faces.size()), !are_copies_independent(surface)});
  }
  const auto errors = run_jobs<ConcurrencyTag>(jobs, [&](std::size_t i) { function(pieces[i], i, surfaces[i]); });
  const auto first = std::find_if(errors.begin(), errors.end(), [](const std::exception_ptr& error) { return bool(error); });
  if(first != errors.end())
    std::rethrow_exception(*first);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_PIECES_OF_PATCHES_H
