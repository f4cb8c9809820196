// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_SIZES_BESIDE_STRIPS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_SIZES_BESIDE_STRIPS_H

#include <algorithm>
#include <cstddef>
#include <map>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The sizes of faces that have edges of a thin strip, with pieces shorter than the minimum edge. Edges inside these faces may be as short
// as the pieces, and grow with the distance from the strip.
class Sizes_beside_strips
{
  std::map<std::size_t, double> m_lengths; // of the shortest pieces that are wanted, by face

public:
  static constexpr double growth = 0.2; // the most that leaves room for angles of 30 degrees

  void add(std::size_t face, double length)
  {
    double& known = m_lengths.emplace(face, length).first->second;
    known = (std::min)(known, length);
  }

  // Sets the minimum edge and the growth of a face.
  template <class Criteria>
  void set(std::size_t face, Criteria& criteria) const
  {
    const auto found = m_lengths.find(face);
    if(found == m_lengths.end())
      return;
    criteria.set_min_edge((std::min)(criteria.min_edge(), found->second / 2));
    criteria.set_growth((std::max)(criteria.growth(), growth));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_SIZES_BESIDE_STRIPS_H
