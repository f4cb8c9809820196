// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_BETTER_PLACE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_BETTER_PLACE_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Star_limits.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Vertex_star.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Triangle_quality.h>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Tells whether a place is better for a vertex: whether the triangles around it would have a better quality, keep their limits, and
// face to the same side as the surface.
template <class Evaluator, class Star>
class Better_place
{
  typedef typename Star::Point Point;
  typedef typename Star::Point_2 Point_2;

  const Evaluator& m_evaluate;
  const Star& m_star;
  const Star_limits m_limits;
  Point m_point;

public:
  Better_place(const Evaluator& evaluate, const Star& star, const Parametric_surface_mesh_criteria& criteria)
    : m_evaluate(evaluate), m_star(star), m_limits(criteria)
  {}

  // `before` is the quality of the star as it is.
  template <class TriangleQuality = Squared_mean_ratio>
  bool is_found_at(const Point_2& target, const Star_quality& before,
                   const TriangleQuality& triangle_quality = TriangleQuality())
  {
    if(!m_star.is_around(target))
      return false;
    m_point = m_evaluate.position(target, m_star.spacing()).point;
    const Star_shape after = m_star.shape(m_point, triangle_quality);
    return after.quality.is_better_than(before) && m_limits.allow(after, [&] { return m_star.shape(m_star.center()); })
           && !m_star.is_inverted(m_point, m_evaluate.oracle());
  }

  // The point that was found.
  const Point& point() const { return m_point; }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_BETTER_PLACE_H
