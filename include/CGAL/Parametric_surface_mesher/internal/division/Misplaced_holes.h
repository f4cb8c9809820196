// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_MISPLACED_HOLES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_MISPLACED_HOLES_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Model_division.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>

#include <cstddef>
#include <set>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Finds holes that the division misplaces. A hole that lies between a curve of another loop and the straight pieces into which
// that curve is divided crosses none of them. But it is outside the polygon of the outer loop, or inside that of another hole,
// though the curves are nested rightly. Such pieces are to be halved.
template <class Oracle>
class Misplaced_holes
{
  typedef Model_division<Oracle> Division;
  typedef typename Division::Kernel Kernel;
  typedef typename Division::Piece Piece;
  typedef typename Kernel::Point_2 Point_2;
  typedef std::vector<Point_2> Polygon;

  // The curve of a piece is judged by the polygon of so many points more. A hole even closer to the curve is refused.
  static constexpr int number_of_samples = 16;

  const Division& m_division;
  const std::size_t m_face;
  const Boundary_loops<Kernel>& m_loops;

public:
  // `loops` is the divided boundary of the face.
  // \pre no segments cross
  Misplaced_holes(const Division& division, std::size_t face, const Boundary_loops<Kernel>& loops)
    : m_division(division), m_face(face), m_loops(loops)
  {}

  // Adds the pieces that are to be halved.
  void operator()(std::set<Piece>& pieces) const
  {
    for(std::size_t l = 0; m_loops.size() > 1 && l < m_loops.size(); ++l) {
      const Polygon polygon = polygon_of_loop(l);
      const Bbox_2 box = bbox_2(polygon.begin(), polygon.end());
      for(std::size_t hole = 1; hole < m_loops.size(); ++hole) {
        // In a vertex loops may touch.
        const Point_2 p = midpoint(m_loops[hole][0].domain_point, m_loops[hole][1].domain_point);
        const bool is_inside = do_overlap(box, p.bbox()) && Misplaced_holes::is_inside(polygon, p);
        if(hole != l && is_inside != (l == 0))
          collect_beside(l, p, pieces);
      }
    }
  }

private:
  Polygon polygon_of_loop(std::size_t l) const
  {
    Polygon result;
    for(const auto& vertex : m_loops[l])
      result.push_back(vertex.domain_point);
    return result;
  }

  // Adds the pieces of a loop that have the point between them and their curve.
  void collect_beside(std::size_t l, const Point_2& p, std::set<Piece>& pieces) const
  {
    for(std::size_t i = 0; i < m_loops[l].size(); ++i) {
      const Piece piece = m_division.piece(m_face, l, i);
      if(m_division.can_be_split(piece) && is_beside(piece, p))
        pieces.insert(piece);
    }
  }

  bool is_beside(const Piece& piece, const Point_2& p) const
  {
    const double begin = m_division.parameters(piece.edge)[piece.number],
                 end = m_division.parameters(piece.edge)[piece.number + 1];
    for(const auto& use : m_division.uses()[piece.edge]) {
      if(use.face != m_face || use.use->curve.is_straight())
        continue;
      Polygon polygon;
      for(int k = 0; k <= number_of_samples; ++k)
        polygon.push_back(use.use->curve.point(k == number_of_samples ? end : begin + (end - begin) * k / number_of_samples));
      if(is_inside(polygon, p))
        return true;
    }
    return false;
  }

  // Counts the edges to the right of a point. CGAL's functions ask for a simple polygon, and that of a curve and its chord need
  // not be one.
  static bool is_inside(const Polygon& polygon, const Point_2& p)
  {
    bool result = false;
    for(std::size_t i = 0; i < polygon.size(); ++i) {
      const Point_2 &a = polygon[i], &b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
      const bool is_upward = b.y() > a.y();
      if((a.y() > p.y()) != (b.y() > p.y()) && orientation(a, b, p) == (is_upward ? LEFT_TURN : RIGHT_TURN))
        result = !result;
    }
    return result;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_MISPLACED_HOLES_H
