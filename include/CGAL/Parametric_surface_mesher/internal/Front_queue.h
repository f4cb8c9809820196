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

/*
The faces on the front, tile by tile of the domain: what is made one after the other is near in space and in memory, at
half the time of a front that advances everywhere at once. The tile that had an entry last comes next, so that the front
goes on from what is finished. Inside a tile faces with much free space come first, by octaves of the squared circumradius
over the wanted one, first in first out. An entry whose face has changed since is skipped.
*/
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

  // The circumcircle of a face of more than four times the wanted radius does not limit what goes there.
  static const int highest_octave = 4;

  struct Tile
  {
    std::array<Bucket, highest_octave + 1> buckets;
    int top = -1; // no bucket above it holds an entry
    bool is_waiting = false;
  };

  std::vector<Tile> m_tiles;
  std::vector<std::size_t> m_waiting; // other tiles with entries
  std::size_t m_current = 0;
  std::size_t m_size = 0;

public:
  explicit Front_queue(std::size_t number_of_tiles) : m_tiles(number_of_tiles) {}

  // `squared_ratio`: of the circumradius to the wanted one
  void push(Face_handle face, double squared_ratio, std::size_t tile_number)
  {
    Tile& tile = m_tiles[tile_number];
    const int octave = squared_ratio < 1 << highest_octave ? std::ilogb((std::max)(squared_ratio, 1.)) : highest_octave;
    tile.buckets[octave].entries.push_back({face, face->stamp()});
    tile.top = (std::max)(tile.top, octave);
    ++m_size;
    if(tile_number != m_current && !tile.is_waiting) {
      tile.is_waiting = true;
      m_waiting.push_back(tile_number);
    }
  }

  // the next face, or a default constructed handle if there is none
  Face_handle pop()
  {
    for(;;) {
      const Face_handle face = pop(m_tiles[m_current]);
      if(face != Face_handle() || m_waiting.empty())
        return face;
      m_tiles[m_current] = Tile(); // gives its memory back
      m_current = m_waiting.back();
      m_waiting.pop_back();
      m_tiles[m_current].is_waiting = false;
    }
  }

  // the number of entries, an upper bound of the number of faces waiting
  std::size_t size() const { return m_size; }

private:
  Face_handle pop(Tile& tile)
  {
    for(; tile.top >= 0; --tile.top) {
      Bucket& bucket = tile.buckets[tile.top];
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
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FRONT_QUEUE_H
