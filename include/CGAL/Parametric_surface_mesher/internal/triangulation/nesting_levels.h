// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_NESTING_LEVELS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_NESTING_LEVELS_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The ends of segments of loops that lie inside the domain, in either order; see `lies_inside()`.
typedef std::set<std::pair<const void*, const void*>> Inner_segments;

// Adds the segments of a loop inside the domain, by its vertices.
template <class Vertex_iterator>
void add_inner_segments(Vertex_iterator begin, Vertex_iterator end, Inner_segments& segments)
{
  for(auto v = begin; v != end; ++v) {
    const auto w = std::next(v) != end ? std::next(v) : begin;
    segments.emplace(&**v, &**w); // the way back has the other order
  }
}

// Sets for all faces how many loops are around them, from outside inwards. The constraints are the segments of the loops, of which
// some lie inside the domain and are around nothing.
template <class Triangulation>
void set_nesting_levels(Triangulation& triangulation, const Inner_segments& inner_segments)
{
  typedef typename Triangulation::Face_handle Face_handle;
  const int unknown = Triangulation::Face::largest_nesting_level;
  for(Face_handle face : triangulation.all_face_handles())
    face->set_nesting_level(unknown);
  std::vector<Face_handle> level(1, triangulation.infinite_face()), next;
  for(int depth = 0; !level.empty(); depth = (std::min)(depth + 1, unknown - 1), level.swap(next), next.clear())
    while(!level.empty()) {
      const Face_handle face = level.back();
      level.pop_back();
      if(face->nesting_level() != unknown)
        continue;
      face->set_nesting_level(depth);
      for(int i = 0; i < 3; ++i)
        if(face->neighbor(i)->nesting_level() == unknown) {
          const bool is_border
            = face->is_constrained(i)
              && (inner_segments.empty()
                  || inner_segments.count({&*face->vertex((i + 1) % 3), &*face->vertex((i + 2) % 3)}) == 0);
          (is_border ? next : level).push_back(face->neighbor(i));
        }
    }
}

// Refuses a loop that is to lie inside the domain if it does not, at one of its vertices. Its segments cross no others, so they are inside
// if all vertices are.
template <class Triangulation, class Loop>
void check_is_inside(const Triangulation& triangulation, const Loop& loop, std::size_t l, typename Triangulation::Vertex_handle v)
{
  if(l == 0)
    throw Parametric_surface_mesh_error("loop 1, the outer loop, encloses nothing: it runs back on itself");
  bool is_any_inside = false, is_any_outside = false;
  auto face = triangulation.incident_faces(v);
  const auto first = face;
  do
    (face->is_in_domain() ? is_any_inside : is_any_outside) = true;
  while(++face != first);
  if(!is_any_inside || (is_any_outside && is_single_point(loop)))
    throw Parametric_surface_mesh_error((is_single_point(loop) ? "an inner point" : numbered("loop", l) + ", an inner edge,")
                                        + " is not inside the face at (u,v) = " + describe(v->point()));
}

// Refuses a loop around the domain, by one of its segments, if it is not the outer one or a hole in that.
template <class Triangulation>
void check_nesting(const Triangulation& triangulation, std::size_t l, typename Triangulation::Vertex_handle a,
                   typename Triangulation::Vertex_handle b)
{
  typename Triangulation::Face_handle face;
  int i = 0;
  triangulation.is_edge(a, b, face, i);
  const int level = (std::min)(face->nesting_level(), face->neighbor(i)->nesting_level());
  if(l == 0 && level != 0)
    throw Parametric_surface_mesh_error("loop 1, the outer loop, lies inside another loop, at (u,v) = "
                                        + describe(a->point()));
  if(l > 0 && level != 1)
    throw Parametric_surface_mesh_error(numbered("loop", l) + ", a hole, lies "
                                        + (level == 0 ? "outside the outer loop" : "inside another hole")
                                        + ", at (u,v) = " + describe(a->point()));
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_NESTING_LEVELS_H
