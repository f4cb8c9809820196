// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_BAD_FACE_BUCKETS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_BAD_FACE_BUCKETS_H

#include <CGAL/Parametric_surface_mesher/internal/triangulation/Stamped_face.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/for_each_with_lookahead.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

enum class Urgency : std::uint8_t
{
  LAST,
  NORMAL,
  FIRST
};

// A bad face with the power of two of its badness.
template <class Face_handle>
struct Bad_face
  : public Stamped_face<Face_handle>
{
  static constexpr int number_of_octaves = 32;

  std::uint8_t octave; // a factor of sqrt(2) in lengths, since badness is a squared ratio
  Urgency urgency;

  Bad_face(Face_handle f, double badness, Urgency u)
    : Stamped_face<Face_handle>(f),
      octave(std::uint8_t(badness < 1e9 ? std::ilogb((std::max)(badness, 1.)) : number_of_octaves - 1)), urgency(u)
  {}
};

/*
Bad faces, by urgency, then worst first: buckets of similar badness, last in first out inside a bucket, which keeps
neighbouring faces together in memory. A face that has changed since is skipped.
*/
template <class Face_handle>
class Bad_face_buckets
{
  typedef internal::Bad_face<Face_handle> Bad_face;

  std::array<std::vector<Bad_face>, 3 * Bad_face::number_of_octaves> m_buckets;
  int m_top = -1; // buckets above it have no face
  std::size_t m_size = 0;

public:
  void push(const Bad_face& bad)
  {
    const int bucket = int(bad.urgency) * Bad_face::number_of_octaves + bad.octave;
    m_buckets[bucket].push_back(bad);
    m_top = (std::max)(m_top, bucket);
    ++m_size;
  }

  // Removes and returns one of the worst faces; a default constructed handle if there is none.
  Face_handle pop()
  {
    for(; m_top >= 0; --m_top)
      while(!m_buckets[m_top].empty()) {
        const Bad_face bad = m_buckets[m_top].back();
        m_buckets[m_top].pop_back();
        --m_size;
        if(!m_buckets[m_top].empty())
          prefetch(*m_buckets[m_top].back().face);
        if(bad.is_up_to_date())
          return bad.face;
      }
    return Face_handle();
  }

  // The number of entries, an upper bound of the number of faces that wait.
  std::size_t size() const { return m_size; }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_BAD_FACE_BUCKETS_H
