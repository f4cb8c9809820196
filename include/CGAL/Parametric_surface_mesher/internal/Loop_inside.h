// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_LOOP_INSIDE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_LOOP_INSIDE_H

#include <CGAL/Parametric_surface_mesher/internal/Patch_region.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Tells whether points are inside a loop, roughly: on the loop itself either answer is possible.
template <class Kernel>
class Loop_inside
{
  typedef typename Kernel::Point_2 Point_2;

  static const int number_of_slices = 256;

  const std::vector<Region_node<Kernel>>& m_loop;
  double m_first, m_width; // of the slices by the second coordinate
  std::vector<std::vector<std::size_t>> m_edges; // that meet each slice

public:
  explicit Loop_inside(const std::vector<Region_node<Kernel>>& loop) : m_loop(loop), m_edges(number_of_slices)
  {
    const auto ends = std::minmax_element(loop.begin(), loop.end(), [](const auto& a, const auto& b) {
      return a.domain_point.y() < b.domain_point.y();
    });
    m_first = ends.first->domain_point.y();
    m_width = (ends.second->domain_point.y() - m_first) / number_of_slices;
    for(std::size_t i = 0; i < loop.size(); ++i) {
      const auto slices = std::minmax({slice(loop[i].domain_point), slice(target(i))});
      for(std::size_t k = slices.first; k <= slices.second; ++k)
        m_edges[k].push_back(i);
    }
  }

  bool operator()(const Point_2& p) const
  {
    bool result = false;
    for(std::size_t i : m_edges[slice(p)]) {
      const Point_2 &a = m_loop[i].domain_point, &b = target(i);
      if((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
        result = !result;
    }
    return result;
  }

private:
  const Point_2& target(std::size_t i) const { return m_loop[i + 1 < m_loop.size() ? i + 1 : 0].domain_point; }

  std::size_t slice(const Point_2& p) const
  {
    return std::size_t((std::min)((std::max)((p.y() - m_first) / m_width, 0.), number_of_slices - 1.));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_LOOP_INSIDE_H
