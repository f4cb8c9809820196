// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_BAD_FACE_QUEUE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_BAD_FACE_QUEUE_H

#include <CGAL/Parametric_surface_mesher/internal/refinement/Bad_face_buckets.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Balanced_cells_2.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Bad faces in the order of their refinement. First those that are far too large, worst first, wherever they are; then all
others, cell by cell of the domain and worst first in each: so the memory of a cell stays in the processor's cache until the
cell is done, and what is close in the mesh is close in memory ever after. A face is in the cell of its vertex 0, the one
inserted last. Small meshes are one cell.
*/
template <class Face_handle>
class Bad_face_queue
{
  typedef internal::Bad_face<Face_handle> Bad_face;
  typedef std::decay_t<decltype(std::declval<Face_handle>()->vertex(0)->point().domain_point())> Point_2;
  typedef Balanced_cells_2<Point_2> Cells;

  // Faces with a badness of 2^9 and more do not wait by cells. The badness is about the number of triangles that a face is refined
  // to.
  static constexpr int first_octave_of_coarse = 9;
  static constexpr double triangles_in_cell = 32000; // on average; they take 4 MB

  Bad_face_buckets<Face_handle> m_at_hand;
  Cells m_cells;
  std::vector<std::vector<Bad_face>> m_waiting; // by cell
  std::size_t m_cell = 0;                       // the cell whose faces are at hand
  std::size_t m_number_of_waiting = 0;
  bool m_has_cells = false;

public:
  Bad_face_queue() : m_waiting(1) {}

  void push(Face_handle face, double badness, Urgency urgency)
  {
    const Bad_face bad(face, badness, urgency);
    if(bad.octave >= first_octave_of_coarse)
      m_at_hand.push(bad);
    else
      push_by_place(bad);
  }

  // Removes and returns the next face; a default constructed handle if there is none.
  Face_handle pop()
  {
    for(;;) {
      const Face_handle face = m_at_hand.pop();
      if(face != Face_handle() || m_number_of_waiting == 0)
        return face;
      if(m_has_cells)
        take_next_cell();
      else
        make_cells();
    }
  }

  // The number of entries, an upper bound of the number of faces that wait.
  std::size_t size() const { return m_at_hand.size() + m_number_of_waiting; }

private:
  static const Point_2& place(const Bad_face& bad) { return bad.face->vertex(0)->point().domain_point(); }

  void push_by_place(const Bad_face& bad)
  {
    const std::size_t cell = m_cells(place(bad));
    if(m_has_cells && cell == m_cell)
      m_at_hand.push(bad);
    else {
      m_waiting[cell].push_back(bad);
      ++m_number_of_waiting;
    }
  }

  // Makes the cells, when no coarse face is left.
  void make_cells()
  {
    const std::vector<Bad_face> all = std::move(m_waiting[0]);
    std::vector<typename Cells::Weighted_point> points;
    for(const Bad_face& bad : all)
      if(bad.is_up_to_date())
        points.push_back({place(bad), std::ldexp(1., bad.octave)});
    m_cells.divide(std::move(points), triangles_in_cell);
    m_waiting.assign(m_cells.size(), {});
    m_number_of_waiting = 0;
    m_has_cells = true;
    for(const Bad_face& bad : all)
      if(bad.is_up_to_date())
        push_by_place(bad);
  }

  // \pre at least one face waits
  void take_next_cell()
  {
    while(m_waiting[m_cell].empty())
      m_cell = m_cell + 1 < m_waiting.size() ? m_cell + 1 : 0;
    for(const Bad_face& bad : m_waiting[m_cell])
      m_at_hand.push(bad);
    m_number_of_waiting -= m_waiting[m_cell].size();
    m_waiting[m_cell].clear();
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_BAD_FACE_QUEUE_H
