// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_STAR_LIMITS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_STAR_LIMITS_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Vertex_star.h>
#include <CGAL/number_utils.h>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The limits that smoothing respects: no triangle becomes larger than its spacing allows, no edge shorter than the minimum, and in
// stars without small angles none longer than the diagonal of a square with the spacing as its side.
class Star_limits
{
  static constexpr double squared_longest_edge = 0.5; // square of the diagonal of a square over the sum of two of its sides

  double m_squared_size, m_squared_min_edge;

public:
  explicit Star_limits(const Parametric_surface_mesh_criteria& criteria)
    : m_squared_size(square(criteria.size_factor())), m_squared_min_edge(square(criteria.min_edge()))
  {}

  // Whether the limits are met, or missed by no more than before. `shape_before()` is called only if they are missed.
  template <class ShapeBefore>
  bool allow(const Star_shape& after, const ShapeBefore& shape_before) const
  {
    const bool is_too_large = after.squared_size > m_squared_size,
               is_too_long = after.squared_length > squared_longest_edge && after.quality.is_good(),
               is_too_close = after.squared_distance < m_squared_min_edge;
    if(!is_too_large && !is_too_long && !is_too_close)
      return true;
    const Star_shape before = shape_before();
    return (!is_too_large || after.squared_size <= before.squared_size)
           && (!is_too_long || after.squared_length <= before.squared_length)
           && (!is_too_close || after.squared_distance >= before.squared_distance);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_STAR_LIMITS_H
