// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_DISPLACEMENT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_DISPLACEMENT_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// How far, and in which directions, points may have moved that are at one place now: a box of vectors. The box of a point between
// two others lies between their boxes, if all moves are linear there.
struct Displacement
{
  std::array<double, 3> smallest = {0, 0, 0}, largest = {0, 0, 0};

  double length() const
  {
    double result = 0;
    for(std::size_t i = 0; i < 3; ++i)
      result += (std::max)(smallest[i] * smallest[i], largest[i] * largest[i]);
    return std::sqrt(result);
  }

  // Where the points may be after one move more.
  template <class Point_3>
  Displacement moved(const Point_3& from, const Point_3& to) const
  {
    Displacement result = *this;
    for(int i = 0; i < 3; ++i) {
      result.smallest[i] += to[i] - from[i];
      result.largest[i] += to[i] - from[i];
    }
    return result;
  }

  Displacement joined_with(const Displacement& other) const
  {
    Displacement result = *this;
    for(std::size_t i = 0; i < 3; ++i) {
      result.smallest[i] = (std::min)(smallest[i], other.smallest[i]);
      result.largest[i] = (std::max)(largest[i], other.largest[i]);
    }
    return result;
  }

  // That of the point at a share of the way from `a` to `b`.
  static Displacement between(const Displacement& a, const Displacement& b, double share)
  {
    Displacement result;
    for(std::size_t i = 0; i < 3; ++i) {
      result.smallest[i] = (1 - share) * a.smallest[i] + share * b.smallest[i];
      result.largest[i] = (1 - share) * a.largest[i] + share * b.largest[i];
    }
    return result;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_DISPLACEMENT_H
