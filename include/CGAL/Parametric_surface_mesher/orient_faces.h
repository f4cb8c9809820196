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

public:
  // Two neighbours that cannot face to the same side along an edge.
  struct Contradiction
  {
    std::size_t face, other, edge;
  };

  // Faces that are connected, and what was found when they were oriented.
  struct Piece
  {
    std::vector<std::size_t> faces;
    std::vector<Contradiction> contradictions;
    bool is_changed = false; // whether a face was reversed
  };

private:
  Model& m_model;
  Model_uses<Model> m_uses;
  std::vector<bool> m_is_done; // by face

public:
  explicit Face_orientation(Model& model) : m_model(model), m_uses(model), m_is_done(model.faces().size()) {}

  bool is_done(std::size_t face) const { return m_is_done[face]; }

  // Orients the piece of a face, which stays as it is.
  Piece orient_piece(std::size_t first)
  {
    Piece piece;
    piece.faces.push_back(first);
    m_is_done[first] = true;
    for(std::size_t i = 0; i < piece.faces.size(); ++i)
      for(const auto& loop : m_model.faces()[piece.faces[i]].loops)
        for(const auto& use : loop)
          orient_across(piece.faces[i], use.edge, piece);
    return piece;
  }

  // Makes a closed piece face outward.
  void face_outward(const Piece& piece)
  {
    if(is_closed(piece) && volume(piece) < 0)
      for(std::size_t face : piece.faces)
        m_model.faces()[face].is_reversed = !m_model.faces()[face].is_reversed;
  }

private:
  // The two uses of an edge along which a face and a neighbour in its shell must face to the same side; none if there are not two.
  std::vector<Use> neighbors(std::size_t face, std::size_t edge) const
  {
    std::vector<Use> result;
    if(!m_model.edges()[edge].is_collapsed && !m_model.edges()[edge].allows_turned_faces)
      result = m_uses.in_shell(edge, m_model.faces()[face].shell);
    return result.size() == 2 ? result : std::vector<Use>();
  }

  void orient_across(std::size_t face, std::size_t edge, Piece& piece)
  {
    const std::vector<Use> uses = neighbors(face, edge);
    if(uses.empty())
      return;
    const std::size_t other = uses[uses[0].face == face ? 1 : 0].face;
    const bool is_turned = m_uses.is_face_left(uses[0]) == m_uses.is_face_left(uses[1]);
    if(!m_is_done[other]) {
      m_model.faces()[other].is_reversed = m_model.faces()[other].is_reversed != is_turned;
      piece.is_changed = piece.is_changed || is_turned;
      m_is_done[other] = true;
      piece.faces.push_back(other);
    }
    else if(is_turned)
      piece.contradictions.push_back({face, other, edge});
  }

  bool is_closed(const Piece& piece) const
  {
    for(std::size_t face : piece.faces)
      for(const auto& loop : m_model.faces()[face].loops)
        for(const auto& use : loop)
          if(!m_model.edges()[use.edge].is_collapsed && neighbors(face, use.edge).empty())
            return false;
    return piece.contradictions.empty();
  }

  double volume(const Piece& piece) const
  {
    double sum = 0;
    for(std::size_t face : piece.faces)
      sum += volume_under_face(m_model.faces()[face], m_model.vertices().front(), piece.faces.size() < 50 ? 4 : 1);
    return sum;
  }
};

template <class Contradiction>
[[noreturn]] void throw_not_orientable(const Contradiction& contradiction)
{
  throw Parametric_surface_mesh_error("the surface is not orientable: " + numbered("faces", contradiction.face) + " and "
                                      + std::to_string(contradiction.other + 1) + " cannot face to the same side along "
                                      + numbered("edge", contradiction.edge));
}

} // namespace internal

/*!
\ingroup PkgParametricSurfaceMesherModel

reverses faces of a model (by `Parametric_surface_model_3::Face::is_reversed`) so that neighbours face to the same side.
The first face of each connected piece keeps its direction, unless the piece is closed: then all of its faces face outward,
and its mesh bounds a positive volume.

Faces are neighbours at an edge with two uses in their shell, if it does not allow turned faces.

\throws Parametric_surface_mesh_error if a piece is not orientable, or a face uses an edge that does not exist; the message
names the faces and the edge

Complexity: linear in the number of faces and edge uses.
*/
template <class Surface>
void orient_faces(Parametric_surface_model_3<Surface>& model)
{
  internal::Face_orientation<Parametric_surface_model_3<Surface>> orientation(model);
  for(std::size_t f = 0; f < model.faces().size(); ++f)
    if(!orientation.is_done(f)) {
      const auto piece = orientation.orient_piece(f);
      if(!piece.contradictions.empty())
        internal::throw_not_orientable(piece.contradictions.front());
      orientation.face_outward(piece);
    }
}

} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_ORIENT_FACES_H
