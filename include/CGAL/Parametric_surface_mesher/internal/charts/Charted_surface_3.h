// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_CHARTED_SURFACE_3_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_CHARTED_SURFACE_3_H

#include <CGAL/Parametric_surface_mesher/internal/charts/Patch_chart_2.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Last_value.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_point_2.h>
#include <CGAL/Surface_jet_3.h>

#include <array>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A surface in the coordinates of a chart: a model of `ParametricSurface_3`. Computing a domain point from a chart point costs
// as much as an evaluation of the surface, and callers ask for the same point several times; therefore the last domain point
// and the last jet are remembered. An object must be used by one thread only; it has a copy of the surface.
template <class Surface>
class Charted_surface_3
{
public:
  typedef Surface Domain_surface;
  typedef typename Surface::Geom_traits Geom_traits;
  typedef typename Geom_traits::Point_2 Point_2;
  typedef typename Geom_traits::Point_3 Point_3;
  typedef Patch_chart_2<Geom_traits> Chart;

private:
  Surface m_surface;
  Chart m_chart;
  mutable Last_value<Point_2, Point_2> m_domain_point;
  mutable Last_value<Point_2, Surface_jet_3<Geom_traits>> m_domain_jet;

public:
  Charted_surface_3(const Surface& surface, const Chart& chart) : m_surface(surface), m_chart(chart) {}

  const Chart& chart() const { return m_chart; }
  const Surface& surface_in_domain() const { return m_surface; }

  // in the coordinates of the domain
  const Surface& domain_surface() const { return m_surface; }

  // The domain point of the chart point `z`.
  // \pre the chart is not the identity
  const Point_2& domain_point(const Point_2& z) const
  {
    return m_domain_point(z, [this](const Point_2& p) { return m_chart.domain_point(p); });
  }

  // Whether the edges of the mesh stand for straight lines of the domain, which are bent in the chart.
  bool has_bent_edges() const { return !m_chart.is_identity() && m_chart.keeps_domain_lines(); }

  Point_3 point(double x, double y) const
  {
    if(m_chart.is_identity())
      return m_surface.point(x, y);
    const Point_2 uv = domain_point(Point_2(x, y));
    return m_surface.point(uv.x(), uv.y());
  }

  Point_3 point_in_domain(const Point_2& uv) const { return m_surface.point(uv.x(), uv.y()); }

  // At a pole the derivatives depend on the direction; there the jet of a point close to the pole is returned.
  Surface_jet_3<Geom_traits> jet(double x, double y) const
  {
    if(m_chart.is_identity())
      return m_surface.jet(x, y);
    Point_2 z(x, y);
    if(m_chart.is_pole(z))
      z = m_chart.beside_pole(z, distance_from_pole);
    return m_chart.chart_jet(domain_jet(domain_point(z)), z);
  }

  // The jet by the coordinates in which edges are straight: those of the domain or of the chart.
  Surface_jet_3<Geom_traits> line_jet(const Point_2& z) const
  {
    if(!m_chart.keeps_domain_lines())
      return jet(z.x(), z.y());
    return domain_jet(domain_point(z));
  }

private:
  // In the chart, whose extent is about 1: far enough for derivatives that are not rounded away, close enough to stand for
  // those in the limit.
  static constexpr double distance_from_pole = 1e-4;

  const Surface_jet_3<Geom_traits>& domain_jet(const Point_2& uv) const
  {
    return m_domain_jet(uv, [this](const Point_2& p) { return m_surface.jet(p.x(), p.y()); });
  }
};

template <class Surface, class Kernel>
void set_line_point(const Charted_surface_3<Surface>& surface, Patch_point_2<Kernel>& point)
{
  if(surface.has_bent_edges())
    point.set_line_point(surface.domain_point(point.domain_point()));
}

template <class Surface, class Point_2>
Point_2 place_in_domain(const Charted_surface_3<Surface>& surface, const Point_2& z)
{
  return surface.chart().domain_point(z);
}

// The ends, in the domain, of an edge between two points of the chart. A pole is a whole side of the domain; of that side the
// point opposite to the other end of the edge is taken.
// \pre `surface.has_bent_edges()`
template <class Surface, class Kernel>
std::array<typename Kernel::Point_2, 2> ends_in_domain(const Charted_surface_3<Surface>& surface,
                                                       const Patch_point_2<Kernel>& p, const Patch_point_2<Kernel>& q)
{
  const auto& chart = surface.chart();
  typename Kernel::Point_2 a = p.line_point(), b = q.line_point();
  if(chart.is_pole(p))
    a = chart.on_collapsed_side(a, b);
  if(chart.is_pole(q))
    b = chart.on_collapsed_side(b, a);
  return {a, b};
}

// \pre `surface.has_bent_edges()`
template <class Surface, class Kernel>
typename Kernel::Point_2 middle_in_domain(const Charted_surface_3<Surface>& surface, const Patch_point_2<Kernel>& p,
                                          const Patch_point_2<Kernel>& q)
{
  const auto ends = ends_in_domain(surface, p, q);
  return midpoint(ends[0], ends[1]);
}

// The point of an edge at a share of the way from `p`, in the coordinates whose straight lines count, as a point of the chart.
template <class Surface, class Kernel>
typename Kernel::Point_2 edge_point(const Charted_surface_3<Surface>& surface, const Patch_point_2<Kernel>& p,
                                    const Patch_point_2<Kernel>& q, double share)
{
  if(!surface.has_bent_edges())
    return p.domain_point() + share * (q.domain_point() - p.domain_point());
  const auto ends = ends_in_domain(surface, p, q);
  return surface.chart().chart_point(ends[0] + share * (ends[1] - ends[0]));
}

// The middle of an edge in the coordinates in which it is straight, as a point of the chart.
template <class Surface, class Kernel>
typename Kernel::Point_2 edge_middle(const Charted_surface_3<Surface>& surface, const Patch_point_2<Kernel>& p,
                                     const Patch_point_2<Kernel>& q)
{
  return surface.has_bent_edges() ? surface.chart().chart_point(middle_in_domain(surface, p, q))
                                  : midpoint(p.domain_point(), q.domain_point());
}

// The surface point at that middle, computed without a detour through the chart.
template <class Surface, class Kernel>
auto edge_middle_in_space(const Charted_surface_3<Surface>& surface, const Patch_point_2<Kernel>& p,
                          const Patch_point_2<Kernel>& q)
{
  if(surface.has_bent_edges())
    return surface.point_in_domain(middle_in_domain(surface, p, q));
  const auto middle = midpoint(p.domain_point(), q.domain_point());
  return surface.point(middle.x(), middle.y());
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_CHARTED_SURFACE_3_H
