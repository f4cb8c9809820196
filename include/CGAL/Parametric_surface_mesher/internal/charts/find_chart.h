// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_FIND_CHART_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_FIND_CHART_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Patch_chart_2.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Pointed_apex.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Radial_stretch.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Finds the chart for a patch. It has one if one or two sides of the patch collapse and are straight along `u` or `v`; otherwise
// its chart is the identity.
template <class Surface>
class Chart_finder
{
  typedef typename Surface::Geom_traits Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef Patch_chart_2<Kernel> Chart;
  typedef Polar_chart_2<Kernel> Polar_chart;

  // In radians, at a pole in space: with less the surface folds onto itself, and a chart would not make it regular.
  static constexpr double least_angle = 0.01;
  // The largest extent of the domain along a collapsed side, in lengths of the side: beyond its ends the chart goes on turning
  // around the pole, by three quarters of a turn at most, and gets more and more distorted.
  static constexpr double largest_reach = 2.5;

  const Surface& m_surface;
  const Boundary_loops<Kernel>& m_loops;
  Bbox_2 m_box;

public:
  Chart_finder(const Surface& surface, const Boundary_loops<Kernel>& loops) : m_surface(surface), m_loops(loops), m_box(box_of_loops(loops))
  {}

  Chart operator()() const
  {
    std::vector<Collapsed_side> sides;
    for(const auto& loop : m_loops)
      for(std::size_t i = 0; i < loop.size(); ++i)
        if(is_collapsed_side(loop, i) && !goes_on_before(loop, i)) {
          std::size_t last = i;
          while(last + 1 < i + loop.size() && goes_on_before(loop, last + 1))
            ++last;
          sides.push_back(side(loop[i].domain_point, loop[(last + 1) % loop.size()].domain_point));
        }
    for(const Collapsed_side& side : sides)
      if(!(side.extent > 0) || !(side.angle > least_angle) || !fits(side))
        return Chart();
    if(sides.size() == 1)
      return Polar_chart(sides[0], Radial_stretch<Surface>(m_surface, sides[0]).scale());
    if(sides.size() != 2)
      return Chart();
    if(sides[0].is_on_v_line != sides[1].is_on_v_line)
      return corner_chart(sides[0].is_on_v_line ? sides[0] : sides[1], sides[0].is_on_v_line ? sides[1] : sides[0]);
    if(sides[0].is_lower == sides[1].is_lower)
      return Chart();
    return sides[0].is_lower ? Polar_chart(sides[0], sides[1]) : Polar_chart(sides[1], sides[0]);
  }

private:
  // Whether segment `i` of a loop continues a collapsed side before it, from which an edge inside the patch goes out.
  static bool goes_on_before(const std::vector<Boundary_vertex<Kernel>>& loop, std::size_t i)
  {
    const std::size_t n = loop.size();
    if(!is_collapsed_side(loop, (i + n - 1) % n) || !is_collapsed_side(loop, i % n))
      return false;
    const Point_2 &p = loop[(i + n - 1) % n].domain_point, &q = loop[i % n].domain_point, &r = loop[(i + 1) % n].domain_point;
    return (p.y() == q.y() && q.y() == r.y()) || (p.x() == q.x() && q.x() == r.x());
  }

  // The side from `p` to `q`. Its extent is 0 if it is not on the border of the domain's bounding box.
  Collapsed_side side(const Point_2& p, const Point_2& q) const
  {
    Collapsed_side result;
    result.is_on_v_line = p.y() == q.y();
    result.from = result.is_on_v_line ? p.x() : p.y();
    result.to = result.is_on_v_line ? q.x() : q.y();
    result.level = result.is_on_v_line ? p.y() : p.x();
    result.low = result.is_on_v_line ? m_box.xmin() : m_box.ymin();
    result.high = result.is_on_v_line ? m_box.xmax() : m_box.ymax();
    const double low = result.is_on_v_line ? m_box.ymin() : m_box.xmin();
    const double high = result.is_on_v_line ? m_box.ymax() : m_box.xmax();
    const bool is_straight = result.is_on_v_line || p.x() == q.x();
    result.is_lower = result.level == low;
    result.extent = is_straight && (result.is_lower || result.level == high) ? high - low : 0;
    result.angle = angle_at_collapsed_side(m_surface, p, q);
    return result;
  }

  // The chart for two sides that meet, on a line `v = constant` and on a line `u = constant`; the identity if they are not whole
  // sides of the domain's bounding box.
  Chart corner_chart(const Collapsed_side& v_side, const Collapsed_side& u_side) const
  {
    for(const Collapsed_side& side : {v_side, u_side})
      if((std::min)(side.from, side.to) != side.low || (std::max)(side.from, side.to) != side.high)
        return Chart();
    const auto opposite = [](const Collapsed_side& side) { return side.is_lower ? side.level + side.extent : side.level - side.extent; };
    return Corner_chart_2<Kernel>(Point_2(u_side.level, v_side.level), Point_2(opposite(u_side), opposite(v_side)));
  }

  // If the domain reaches far beyond the ends of the side, the chart would be too distorted.
  static bool fits(const Collapsed_side& side)
  {
    return side.high - side.low < largest_reach * std::fabs(side.to - side.from);
  }
};

template <class Surface>
Patch_chart_2<typename Surface::Geom_traits> find_chart(const Surface& surface,
                                                        const Boundary_loops<typename Surface::Geom_traits>& loops)
{
  return Chart_finder<Surface>(surface, loops)();
}

// The divided boundary with a single point for each collapsed side.
template <class Kernel>
Boundary_loops<Kernel> without_collapsed_sides(const Boundary_loops<Kernel>& loops)
{
  Boundary_loops<Kernel> result;
  for(const auto& loop : loops) {
    result.emplace_back();
    for(std::size_t i = 0; i < loop.size(); ++i)
      if(!is_collapsed_side(loop, i))
        result.back().push_back(loop[i]);
  }
  return result;
}

// The divided boundary in the coordinates of a chart, in which a collapsed side is one point.
template <class Kernel>
Boundary_loops<Kernel> chart_loops(const Boundary_loops<Kernel>& loops, const Patch_chart_2<Kernel>& chart)
{
  if(chart.is_identity())
    return loops;
  Boundary_loops<Kernel> result = without_collapsed_sides(loops);
  for(auto& loop : result)
    for(Boundary_vertex<Kernel>& vertex : loop)
      vertex.domain_point = chart.chart_point(vertex.domain_point);
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_FIND_CHART_H
