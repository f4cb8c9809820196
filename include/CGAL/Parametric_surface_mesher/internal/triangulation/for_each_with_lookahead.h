// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_FOR_EACH_WITH_LOOKAHEAD_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_FOR_EACH_WITH_LOOKAHEAD_H

#include <array>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Prefetches the memory of an object. This has no effect but on speed.
template <class T>
void prefetch(const T& object)
{
#if defined(__GNUC__) || defined(__clang__)
  const char* const begin = reinterpret_cast<const char*>(&object);
  for(std::size_t offset = 0; offset < sizeof(T); offset += 64)
    __builtin_prefetch(begin + offset);
#else
  (void)object;
#endif
}

// Visits the handles of a range in their order. For each handle first `announce_early` is called and, some steps later, `announce`:
// these prefetch what the visit will need, since otherwise sweeps over a large triangulation wait for memory half of their time.
// Visits must not change the range.
template <class Handle, class Range, class AnnounceEarly, class Announce, class Visit>
void for_each_with_lookahead(const Range& handles, const AnnounceEarly& announce_early, const Announce& announce,
                             const Visit& visit)
{
  const std::size_t distance = 4; // steps between the three calls
  std::array<Handle, 2 * distance> waiting;
  std::size_t n = 0;
  for(const Handle handle : handles) {
    announce_early(handle);
    if(n >= distance)
      announce(waiting[(n - distance) % waiting.size()]);
    if(n >= 2 * distance)
      visit(waiting[n % waiting.size()]);
    waiting[n++ % waiting.size()] = handle;
  }
  for(std::size_t k = n < 2 * distance ? 0 : n - 2 * distance; k < n; ++k)
    visit(waiting[k % waiting.size()]);
}

// Visits the finite faces; the memory of their vertices and neighbours is prefetched.
template <class Triangulation, class Visit>
void for_each_face_with_lookahead(const Triangulation& triangulation, const Visit& visit)
{
  typedef typename Triangulation::Face_handle Face_handle;
  for_each_with_lookahead<Face_handle>(triangulation.finite_face_handles(), [](Face_handle) {},
                                       [](Face_handle face) {
                                         for(int i = 0; i < 3; ++i) {
                                           prefetch(*face->vertex(i));
                                           prefetch(*face->neighbor(i));
                                         }
                                       },
                                       visit);
}

// Visits the finite vertices; the memory of most of the faces and vertices around them is prefetched.
template <class Triangulation, class Visit>
void for_each_vertex_with_lookahead(const Triangulation& triangulation, const Visit& visit)
{
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  for_each_with_lookahead<Vertex_handle>(triangulation.finite_vertex_handles(),
                                         [](Vertex_handle vertex) { prefetch(*vertex->face()); },
                                         [](Vertex_handle vertex) {
                                           for(int i = 0; i < 3; ++i) {
                                             prefetch(*vertex->face()->neighbor(i));
                                             prefetch(*vertex->face()->vertex(i));
                                           }
                                         },
                                         visit);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_FOR_EACH_WITH_LOOKAHEAD_H
