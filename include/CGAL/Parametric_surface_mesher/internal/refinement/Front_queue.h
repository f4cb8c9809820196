// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_FRONT_QUEUE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_FRONT_QUEUE_H

#include <CGAL/Parametric_surface_mesher/internal/triangulation/Stamped_face.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
The faces on the front, those with the largest circumradius over the wanted size first, by octaves of its square, so that the
front advances evenly and sizes grow with the distance from a finely divided boundary. Inside an octave they come tile by
tile of the domain, and there first in first out: what is made one after the other is near in space and in memory, which
halves the time of large meshes. (To finish one tile before the next whatever the octave makes up to five times as many
triangles around a finely divided hole.) An entry whose face has changed since is skipped.
*/
template <class Face_handle>
class Front_queue
{
  typedef Stamped_face<Face_handle> Entry;

  // The entries of a tile, of which those from `first` on wait.
  struct Tile
  {
    std::vector<Entry> entries;
    std::size_t first = 0;
    bool is_waiting = false;
  };

  // The tiles of one octave. The tile that got an entry last comes next.
  struct Octave
  {
    std::vector<Tile> tiles;
    std::vector<std::size_t> waiting; // the tiles with entries, except for the current one
    std::size_t current = 0;
  };

  static constexpr int highest_octave = 10; // all ratios of radii above 32 wait together

  std::array<Octave, highest_octave + 1> m_octaves;
  int m_top = -1; // octaves above it have no entry
  std::size_t m_number_of_tiles, m_size = 0;

public:
  explicit Front_queue(std::size_t number_of_tiles) : m_number_of_tiles(number_of_tiles) {}

  // `squared_ratio` is that of the circumradius to the wanted one.
  void push(Face_handle face, double squared_ratio, std::size_t tile_number)
  {
    const int n = squared_ratio < 1 << highest_octave ? std::ilogb((std::max)(squared_ratio, 1.)) : highest_octave;
    Octave& octave = m_octaves[n];
    octave.tiles.resize(m_number_of_tiles);
    Tile& tile = octave.tiles[tile_number];
    tile.entries.emplace_back(face);
    m_top = (std::max)(m_top, n);
    ++m_size;
    if(tile_number != octave.current && !tile.is_waiting) {
      tile.is_waiting = true;
      octave.waiting.push_back(tile_number);
    }
  }

  // Removes and returns the next face; a default constructed handle if there is none.
  Face_handle pop()
  {
    for(; m_top >= 0; --m_top) {
      const Face_handle face = pop(m_octaves[m_top]);
      if(face != Face_handle())
        return face;
    }
    return Face_handle();
  }

  // The number of entries, an upper bound of the number of faces that wait.
  std::size_t size() const { return m_size; }

private:
  Face_handle pop(Octave& octave)
  {
    while(!octave.tiles.empty()) {
      const Face_handle face = pop(octave.tiles[octave.current]);
      if(face != Face_handle() || octave.waiting.empty())
        return face;
      octave.current = octave.waiting.back();
      octave.waiting.pop_back();
      octave.tiles[octave.current].is_waiting = false;
    }
    return Face_handle();
  }

  Face_handle pop(Tile& tile)
  {
    while(tile.first < tile.entries.size()) {
      const Entry entry = tile.entries[tile.first++];
      --m_size;
      if(entry.is_up_to_date())
        return entry.face;
    }
    tile = Tile(); // releases its memory
    return Face_handle();
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_FRONT_QUEUE_H
