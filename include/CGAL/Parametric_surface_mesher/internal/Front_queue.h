// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FRONT_QUEUE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FRONT_QUEUE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The faces on the front, those with the largest circumradius over wanted size first: buckets of half octaves, first in
// first out inside a bucket, so that the front advances evenly. An entry whose face has changed since is skipped.
template <class Face_handle>
class Front_queue
{
  struct Entry
  {
    Face_handle face;
    std::uint32_t stamp;
  };

  // entries from `first` on wait
  struct Bucket
  {
    std::vector<Entry> entries;
    std::size_t first = 0;
  };

  static const int number_of_buckets = 48;
  std::array<Bucket, number_of_buckets> m_buckets;
  int m_top = -1; // no bucket above it holds an entry
  std::size_t m_size = 0;

public:
  // `squared_ratio`: of the circumradius to the wanted one
  void push(Face_handle face, double squared_ratio)
  {
    const int octave = squared_ratio < 1e12 ? std::ilogb((std::max)(squared_ratio, 1.)) : number_of_buckets - 1;
    m_buckets[octave].entries.push_back({face, face->stamp()});
    m_top = (std::max)(m_top, octave);
    ++m_size;
  }

  // the next face, or a default constructed handle if there is none
  Face_handle pop()
  {
    for(; m_top >= 0; --m_top) {
      Bucket& bucket = m_buckets[m_top];
      while(bucket.first < bucket.entries.size()) {
        const Entry entry = bucket.entries[bucket.first++];
        --m_size;
        if(entry.face->stamp() == entry.stamp)
          return entry.face;
      }
      bucket.entries.clear();
      bucket.first = 0;
    }
    return Face_handle();
  }

  // the number of entries, an upper bound of the number of faces waiting
  std::size_t size() const { return m_size; }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FRONT_QUEUE_H
