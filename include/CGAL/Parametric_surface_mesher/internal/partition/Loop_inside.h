// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_LOOP_INSIDE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_LOOP_INSIDE_H

#include <CGAL/Parametric_surface_mesher/internal/partition/Patch_region.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Tells whether points are inside a loop; for points on the loop either answer is possible. Locating points in the triangulation of
// the sketch would not do, since it knows nothing of cuts; CGAL's bounded_side_2() looks at all edges for each point.
template <class Kernel>
class Loop_inside
{
  typedef typename Kernel::Point_2 Point_2;

  const std::vector<Region_node<Kernel>>& m_loop;
  double m_first, m_width;          // where the first slice begins, and how wide slices are, in the second coordinate
  std::vector<std::size_t> m_edges; // those that meet each slice, slice by slice
  std::vector<std::size_t> m_ends;  // where each slice ends among these

public:
  // Takes linear time, since an edge meets two slices on average.
  explicit Loop_inside(const std::vector<Region_node<Kernel>>& loop) : m_loop(loop)
  {
    const auto ends = std::minmax_element(loop.begin(), loop.end(), [](const auto& a, const auto& b) {
      return a.domain_point.y() < b.domain_point.y();
    });
    m_first = ends.first->domain_point.y();
    const double height = ends.second->domain_point.y() - m_first;
    double way = 0; // the total way up and down
    for(std::size_t i = 0; i < loop.size(); ++i)
      way += std::fabs(target(i).y() - loop[i].domain_point.y());
    m_ends.resize(2 + std::size_t(way > 0 ? height / way * double(loop.size()) : 0), 0);
    m_width = height / double(m_ends.size() - 1);
    for_each_edge_and_slice([this](std::size_t, std::size_t k) { ++m_ends[k + 1]; });
    std::partial_sum(m_ends.begin(), m_ends.end(), m_ends.begin());
    m_edges.resize(m_ends.back());
    for_each_edge_and_slice([this](std::size_t i, std::size_t k) { m_edges[m_ends[k]++] = i; }); // from the slice's begin
  }

  bool operator()(const Point_2& p) const
  {
    bool result = false;
    const std::size_t k = slice(p);
    for(std::size_t n = k == 0 ? 0 : m_ends[k - 1]; n < m_ends[k]; ++n) {
      const std::size_t i = m_edges[n];
      const Point_2 &a = m_loop[i].domain_point, &b = target(i);
      if((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
        result = !result;
    }
    return result;
  }

private:
  const Point_2& target(std::size_t i) const { return m_loop[i + 1 < m_loop.size() ? i + 1 : 0].domain_point; }

  template <class Visit>
  void for_each_edge_and_slice(const Visit& visit) const
  {
    for(std::size_t i = 0; i < m_loop.size(); ++i) {
      const auto slices = std::minmax({slice(m_loop[i].domain_point), slice(target(i))});
      for(std::size_t k = slices.first; k <= slices.second; ++k)
        visit(i, k);
    }
  }

  std::size_t slice(const Point_2& p) const
  {
    return std::size_t((std::min)((std::max)((p.y() - m_first) / m_width, 0.), double(m_ends.size() - 2)));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_LOOP_INSIDE_H
