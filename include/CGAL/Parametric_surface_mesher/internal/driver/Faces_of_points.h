// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_FACES_OF_POINTS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_FACES_OF_POINTS_H

#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Which faces of a model have a point of the division on their boundary.
class Faces_of_points
{
  std::vector<std::pair<std::size_t, std::size_t>> m_faces; // point and face, in order

public:
  template <class Vertex>
  void add(std::size_t face, const std::vector<std::vector<Vertex>>& loops)
  {
    for(const auto& loop : loops)
      for(const Vertex& vertex : loop)
        m_faces.emplace_back(vertex.index, face);
  }

  // to be called when all faces are there
  void finish() { std::sort(m_faces.begin(), m_faces.end()); }

  // whether another face has both points; logarithmic
  bool have_other_common_face(std::size_t point, std::size_t other_point, std::size_t face) const
  {
    auto a = first(point), b = first(other_point);
    while(a != m_faces.end() && b != m_faces.end() && a->first == point && b->first == other_point)
      if(a->second == b->second && a->second != face)
        return true;
      else
        a->second < b->second ? ++a : ++b;
    return false;
  }

private:
  std::vector<std::pair<std::size_t, std::size_t>>::const_iterator first(std::size_t point) const
  {
    return std::lower_bound(m_faces.begin(), m_faces.end(), std::make_pair(point, std::size_t(0)));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_FACES_OF_POINTS_H
