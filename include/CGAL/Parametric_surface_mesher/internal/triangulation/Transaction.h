// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_TRANSACTION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_TRANSACTION_H

#include <CGAL/Parametric_surface_mesher/internal/triangulation/Edge_flip.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Verdict.h>

#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Moves of inner vertices and flips of edges, done to see what comes of them: they can be taken back, the last one first, and
// with them the verdicts on the faces that have changed.
template <class Triangulation>
class Transaction
{
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Point Point;

  struct Move
  {
    Vertex_handle vertex;
    Point old_point;
  };

  std::vector<std::variant<Move, Edge_flip<Triangulation>>> m_changes;
  std::vector<std::pair<Face_handle, Verdict>> m_verdicts;

public:
  // `faces`: all that will change; what has changed before stays
  template <class Faces>
  void begin(const Faces& faces)
  {
    m_changes.clear();
    m_verdicts.clear();
    for(Face_handle face : faces)
      m_verdicts.emplace_back(face, face->verdict());
  }

  void flip(const Edge_flip<Triangulation>& edge)
  {
    m_changes.emplace_back(edge);
    std::get<1>(m_changes.back()).flip();
  }

  void move(Vertex_handle vertex, const Point& point)
  {
    m_changes.emplace_back(Move{vertex, vertex->point()});
    move_to(vertex, point);
  }

  void roll_back()
  {
    for(; !m_changes.empty(); m_changes.pop_back())
      if(Edge_flip<Triangulation>* const edge = std::get_if<1>(&m_changes.back()))
        edge->undo();
      else {
        const Move& move = std::get<0>(m_changes.back());
        move_to(move.vertex, move.old_point);
      }
    for(const auto& kept : m_verdicts)
      kept.first->set_verdict(kept.second);
  }

private:
  static void move_to(Vertex_handle vertex, const Point& point)
  {
    vertex->set_point(point);
    const Face_handle first = vertex->face();
    Face_handle face = first;
    do {
      const int i = face->index(vertex);
      face->touch_by_vertex(i);
      face = face->neighbor(Triangulation::ccw(i));
    } while(face != first);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_TRANSACTION_H
