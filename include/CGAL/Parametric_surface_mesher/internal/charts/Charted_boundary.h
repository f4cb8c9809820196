// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_CHARTED_BOUNDARY_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_CHARTED_BOUNDARY_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Patch_chart_2.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/find_chart.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>

#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The divided boundary of a patch in the coordinates of its chart. It also keeps the points in the domain, since computing them
// back through the chart would round them.
template <class Kernel>
class Charted_boundary
{
public:
  typedef typename Kernel::Point_2 Point_2;
  typedef Patch_chart_2<Kernel> Chart;

private:
  Chart m_chart;
  Boundary_loops<Kernel> m_loops;
  std::map<Point_2, Point_2> m_domain_points; // by the points in the chart; empty if the chart is the identity

public:
  // The loops are in the domain.
  template <class Surface>
  Charted_boundary(const Surface& surface, const Boundary_loops<Kernel>& loops)
    : m_chart(find_chart(surface, loops)), m_loops(chart_loops(loops, m_chart))
  {
    if(m_chart.is_identity())
      return;
    const Boundary_loops<Kernel> in_domain = without_collapsed_sides(loops);
    for(std::size_t l = 0; l < m_loops.size(); ++l)
      for(std::size_t i = 0; i < m_loops[l].size(); ++i)
        m_domain_points.emplace(m_loops[l][i].domain_point, in_domain[l][i].domain_point);
  }

  const Chart& chart() const { return m_chart; }
  const Boundary_loops<Kernel>& loops() const { return m_loops; }
  Bbox_2 box() const { return box_of_loops(m_loops); }

  // The domain point of the chart point `z`: exact for points of the boundary, rounded for others.
  Point_2 domain_point(const Point_2& z) const
  {
    const auto found = m_domain_points.find(z);
    return found != m_domain_points.end() ? found->second : m_chart.domain_point(z);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_CHARTED_BOUNDARY_H
