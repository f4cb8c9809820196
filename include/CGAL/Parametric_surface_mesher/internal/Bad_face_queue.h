// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_BAD_FACE_QUEUE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_BAD_FACE_QUEUE_H

#include <CGAL/Parametric_surface_mesher/internal/for_each_with_lookahead.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

enum class Urgency
{
  LAST,
  NORMAL,
  FIRST
};

/*
Bad faces, by urgency, then worst first: buckets of similar badness (half octaves, as badness is a squared ratio), last in
first out inside a bucket, which keeps neighbouring faces together in memory. An entry whose face has changed since is
skipped.
*/
template <class Face_handle>
class Bad_face_queue
{
  struct Entry
  {
    Face_handle face;
    std::uint32_t stamp;
  };

  static const int buckets_per_urgency = 32, number_of_buckets = 3 * buckets_per_urgency;
  std::array<std::vector<Entry>, number_of_buckets> m_buckets;
  int m_top = -1; // no bucket above it holds an entry
  std::size_t m_size = 0;

public:
  void push(Face_handle face, double badness, Urgency urgency)
  {
    const int octave = badness < 1e9 ? std::ilogb((std::max)(badness, 1.)) : buckets_per_urgency - 1;
    const int bucket = int(urgency) * buckets_per_urgency + octave;
    m_buckets[bucket].push_back({face, face->stamp()});
    m_top = (std::max)(m_top, bucket);
    ++m_size;
  }

  // the worst face, or a default constructed handle if there is none
  Face_handle pop()
  {
    for(; m_top >= 0; --m_top)
      while(!m_buckets[m_top].empty()) {
        const Entry entry = m_buckets[m_top].back();
        m_buckets[m_top].pop_back();
        --m_size;
        if(!m_buckets[m_top].empty())
          prefetch(*m_buckets[m_top].back().face);
        if(entry.face->stamp() == entry.stamp)
          return entry.face;
      }
    return Face_handle();
  }

  // the number of entries, an upper bound of the number of faces waiting
  std::size_t size() const { return m_size; }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_BAD_FACE_QUEUE_H
