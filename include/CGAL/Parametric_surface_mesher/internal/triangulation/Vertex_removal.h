// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_VERTEX_REMOVAL_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_VERTEX_REMOVAL_H

#include <CGAL/Parametric_surface_mesher/internal/triangulation/Edge_flip.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Transaction.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Removes an inner vertex: edges at it are flipped away, the one with the best ear first, until three triangles are left, which
// become one. Until then the transaction can be rolled back.
template <class Triangulation>
class Vertex_removal
{
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;

  Triangulation& m_triangulation;
  Vertex_handle m_vertex;
  Transaction<Triangulation>& m_transaction;

public:
  // `transaction`: the flips are part of it, and are taken back with it
  Vertex_removal(Triangulation& triangulation, Vertex_handle vertex, Transaction<Triangulation>& transaction)
    : m_triangulation(triangulation), m_vertex(vertex), m_transaction(transaction)
  {}

  // Flips until three triangles are left and all others have a quality above `bound`; returns whether this was possible.
  template <class MetricField, class Quality>
  bool cut_ears(const MetricField& metric, const Quality& quality, double bound)
  {
    while(faces().size() > 3)
      if(!cut_best_ear(metric, quality, bound))
        return false;
    return true;
  }

  // The triangles at the vertex.
  std::vector<Face_handle> faces() const
  {
    std::vector<Face_handle> result;
    auto face = m_triangulation.incident_faces(m_vertex);
    const auto first = face;
    do
      result.push_back(face);
    while(++face != first);
    return result;
  }

  // Calls `function` with a face, without neighbours, that is what the last three triangles would become.
  template <class Function>
  auto with_last_face(const Function& function)
  {
    std::array<Vertex_handle, 3> corners;
    auto corner = m_triangulation.incident_vertices(m_vertex);
    for(Vertex_handle& v : corners)
      v = corner++;
    const Face_handle face = m_triangulation.tds().create_face(corners[0], corners[1], corners[2]);
    face->set_constraints(true, true, true); // the criteria have judged these edges in the neighbours
    face->set_in_domain(true);
    const auto result = function(face);
    m_triangulation.tds().delete_face(face);
    return result;
  }

  // Replaces the last three triangles by one, which is returned, and deletes the vertex.
  Face_handle remove()
  {
    const Face_handle face = m_vertex->face();
    m_triangulation.tds().remove_degree_3(m_vertex, face);
    for(int i = 0; i < 3; ++i)
      face->set_constraint(i, face->neighbor(i)->is_constrained(m_triangulation.mirror_index(face, i)));
    face->touch();
    for(int i = 0; i < 3; ++i)
      face->vertex(i)->set_settled(false);
    return face;
  }

private:
  template <class MetricField, class Quality>
  bool cut_best_ear(const MetricField& metric, const Quality& quality, double bound)
  {
    Face_handle best;
    for(Face_handle face : faces()) {
      const Edge_flip<Triangulation> flip = flip_of_spoke(face);
      const double ear = flip.quality_of_ear(metric, quality);
      if(ear > bound && flip.is_valid()) {
        bound = ear;
        best = face;
      }
    }
    if(best == Face_handle())
      return false;
    m_transaction.flip(flip_of_spoke(best));
    return true;
  }

  // The flip of the edge between a face at the vertex and the next one.
  Edge_flip<Triangulation> flip_of_spoke(Face_handle face) const
  {
    return Edge_flip<Triangulation>(m_triangulation, face, Triangulation::ccw(face->index(m_vertex)));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_VERTEX_REMOVAL_H
