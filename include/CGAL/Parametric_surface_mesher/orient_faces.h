// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_ORIENT_FACES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_ORIENT_FACES_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/model/Model_uses.h>
#include <CGAL/Parametric_surface_mesher/internal/model/volume_under_face.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Parametric_surface_model_3.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {

namespace internal {

// Reverses faces of a model so that neighbours face to the same side, and closed pieces outward.
template <class Model>
class Face_orientation
{
  typedef typename Model_uses<Model>::Use Use;

  Model& m_model;
  Model_uses<Model> m_uses;
  std::vector<bool> m_is_done;

public:
  explicit Face_orientation(Model& model) : m_model(model), m_uses(model), m_is_done(model.faces().size()) {}

  void operator()()
  {
    for(std::size_t f = 0; f < m_is_done.size(); ++f)
      if(!m_is_done[f]) {
        const std::vector<std::size_t> piece = orient_piece(f);
        if(is_closed(piece) && volume(piece) < 0)
          for(std::size_t face : piece)
            m_model.faces()[face].is_reversed = !m_model.faces()[face].is_reversed;
      }
  }

private:
  // returns the faces of the piece; the first of them stays as it is
  std::vector<std::size_t> orient_piece(std::size_t first)
  {
    std::vector<std::size_t> piece(1, first);
    m_is_done[first] = true;
    for(std::size_t i = 0; i < piece.size(); ++i)
      for(const auto& loop : m_model.faces()[piece[i]].loops)
        for(const auto& use : loop)
          if(m_uses[use.edge].size() == 2 && m_uses.is_manifold(use.edge) && !m_model.edges()[use.edge].is_collapsed)
            orient_across(piece[i], use.edge, piece);
    return piece;
  }

  void orient_across(std::size_t face, std::size_t edge, std::vector<std::size_t>& piece)
  {
    const bool is_first = m_uses[edge][0].face == face;
    const Use &here = m_uses[edge][is_first ? 0 : 1], &there = m_uses[edge][is_first ? 1 : 0];
    if(!m_is_done[there.face]) {
      if(m_uses.is_face_left(here) == m_uses.is_face_left(there))
        m_model.faces()[there.face].is_reversed = !m_model.faces()[there.face].is_reversed;
      m_is_done[there.face] = true;
      piece.push_back(there.face);
    }
    else if(m_uses.is_face_left(here) == m_uses.is_face_left(there))
      throw Parametric_surface_mesh_error("the surface is not orientable: " + numbered("faces", face) + " and "
                                          + std::to_string(there.face + 1) + " cannot face to the same side along "
                                          + numbered("edge", edge));
  }

  bool is_closed(const std::vector<std::size_t>& piece) const
  {
    for(std::size_t face : piece)
      for(const auto& loop : m_model.faces()[face].loops)
        for(const auto& use : loop)
          if(!m_model.edges()[use.edge].is_collapsed
             && !(m_uses[use.edge].size() == 2 && m_uses.is_manifold(use.edge)))
            return false;
    return true;
  }

  double volume(const std::vector<std::size_t>& piece) const
  {
    double sum = 0;
    for(std::size_t face : piece)
      sum += volume_under_face(m_model.faces()[face], m_model.vertices().front(), piece.size() < 50 ? 4 : 1);
    return sum;
  }
};

} // namespace internal

/*!
\ingroup PkgParametricSurfaceMesherModel

reverses faces of a model (by `Parametric_surface_model_3::Face::is_reversed`) so that neighbours face to the same side.
The first face of each connected piece keeps its direction, unless the piece is closed: then all of its faces face outward,
and its mesh bounds a positive volume.

Faces are neighbours at an edge with two uses, both in one shell.

\throws Parametric_surface_mesh_error if a piece is not orientable, or a face uses an edge that does not exist; the message
names the faces and the edge

Complexity: linear in the number of faces and edge uses.
*/
template <class Surface>
void orient_faces(Parametric_surface_model_3<Surface>& model)
{
  internal::Face_orientation<Parametric_surface_model_3<Surface>> orient(model);
  orient();
}

} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_ORIENT_FACES_H
