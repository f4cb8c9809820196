// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_REPAIR_PLACES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_REPAIR_PLACES_H

#include <algorithm>
#include <initializer_list>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The places to which repair might move a vertex: some way towards the apices over the sides of its star, where the triangles there
// would be equilateral.
template <class Evaluator, class Star>
class Repair_places
{
  typedef typename Evaluator::Kernel::Point_2 Point_2;

  // a place, and the smallest angle that it would give, as far as the surface can be told from the vertex
  struct Candidate
  {
    Point_2 position;
    double squared_sine;
  };

  const Evaluator& m_evaluate;
  Star& m_star;
  std::vector<Point_2> m_apices;
  std::vector<Candidate> m_candidates;

public:
  // They follow `star`.
  Repair_places(const Evaluator& evaluate, Star& star) : m_evaluate(evaluate), m_star(star) {}

  // The places that may give a smallest angle above that of `least`, the best first. `shares`: of the way to apices
  template <class Vertex_handle>
  const std::vector<Candidate>& operator()(Vertex_handle vertex, double least, std::initializer_list<double> shares)
  {
    m_star.apices(m_apices);
    m_candidates.clear();
    const auto& p = vertex->point();
    const auto jet = m_evaluate.position(p, vertex->spacing()).jet;
    for(const Point_2& apex : m_apices)
      for(double share : shares) {
        const double u = share * (apex.x() - p.x()), v = share * (apex.y() - p.y());
        const Point_2 position(p.x() + u, p.y() + v);
        const auto move = u * jet.du + v * jet.dv + (0.5 * u * u) * jet.duu + (u * v) * jet.duv + (0.5 * v * v) * jet.dvv;
        const typename Star::Point point(position, p.surface_point() + move, p.tensor());
        const double sine = m_star.squared_smallest_sine(point, least);
        if(sine > least)
          m_candidates.push_back({position, sine});
      }
    std::stable_sort(m_candidates.begin(), m_candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.squared_sine > b.squared_sine; });
    return m_candidates;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_REPAIR_PLACES_H
