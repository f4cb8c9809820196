// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_DOMAIN_WALK_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_DOMAIN_WALK_H

#include <CGAL/enum.h>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The place of a point, found by a walk from a face of the domain.
template <class Triangulation>
struct Location
{
  enum Kind
  {
    IN_FACE,           // strictly inside `face`
    ON_EDGE,           // strictly inside edge `index` of `face`
    ON_VERTEX,         // at a vertex of `face`
    BEHIND_CONSTRAINT, // the way crosses edge `index` of `face`, which is constrained
    LOST               // the walk gave up
  };

  Kind kind;
  typename Triangulation::Face_handle face;
  int index;
};

// Walks are short: they lead from a triangle to the place of a point that makes it better.
const int max_number_of_steps_of_walk = 500;

// Visibility walk from `start` to `p` that does not cross constraints. In a triangulation that is not Delaunay under one metric
// such a walk need not end, so its length is bounded.
template <class Triangulation, class Point>
Location<Triangulation> walk_in_domain(const Triangulation& triangulation, typename Triangulation::Face_handle start,
                                       const Point& p, int max_number_of_steps = max_number_of_steps_of_walk)
{
  typedef typename Triangulation::Face_handle Face_handle;
  typedef Location<Triangulation> Location;
  const auto orientation = triangulation.geom_traits().orientation_2_object();
  Face_handle face = start, previous;
  for(int step = 0; step < max_number_of_steps; ++step) {
    Face_handle next;
    int on_edge = -1, blocked_by = -1, zeros = 0;
    for(int k = 0; k < 3 && next == Face_handle(); ++k) {
      const int i = (k + step) % 3; // starting with a different edge at each step avoids most cycles
      if(face->neighbor(i) == previous && previous != Face_handle())
        continue;
      const Orientation side = orientation(face->vertex((i + 1) % 3)->point(), face->vertex((i + 2) % 3)->point(), p);
      if(side == COLLINEAR) {
        on_edge = i;
        ++zeros;
      }
      else if(side == RIGHT_TURN) {
        if(face->is_constrained(i))
          blocked_by = i;
        else
          next = face->neighbor(i);
      }
    }
    if(next != Face_handle()) {
      previous = face;
      face = next;
    }
    else if(blocked_by >= 0)
      return {Location::BEHIND_CONSTRAINT, face, blocked_by};
    else if(zeros == 2)
      return {Location::ON_VERTEX, face, -1};
    else if(zeros == 1)
      return {Location::ON_EDGE, face, on_edge};
    else
      return {Location::IN_FACE, face, -1};
  }
  return {Location::LOST, face, -1};
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_DOMAIN_WALK_H
