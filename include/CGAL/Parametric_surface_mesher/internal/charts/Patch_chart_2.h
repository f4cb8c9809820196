// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_PATCH_CHART_2_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_PATCH_CHART_2_H

#include <CGAL/Parametric_surface_mesher/internal/charts/Corner_chart_2.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Polar_chart_2.h>
#include <CGAL/Surface_jet_3.h>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The coordinates in which a patch is meshed: those of its domain or, if sides of it collapse, those of a chart.
template <class Kernel>
class Patch_chart_2
{
public:
  typedef typename Kernel::Point_2 Point_2;

private:
  enum Kind { IDENTITY, POLAR, CORNER };

  Kind m_kind = IDENTITY;
  Polar_chart_2<Kernel> m_polar;
  Corner_chart_2<Kernel> m_corner;

public:
  Patch_chart_2() = default;
  Patch_chart_2(const Polar_chart_2<Kernel>& chart) : m_kind(POLAR), m_polar(chart) {}
  Patch_chart_2(const Corner_chart_2<Kernel>& chart) : m_kind(CORNER), m_corner(chart) {}

  bool is_identity() const { return m_kind == IDENTITY; }

  // Whether edges stand for straight lines of the domain, in deviation and sizes. If two sides collapse in a corner, the images
  // of these lines bend all over the patch, and edges are straight in the chart instead.
  bool keeps_domain_lines() const { return m_kind != CORNER; }

  // Whether the chart point `z` stands for one or more collapsed sides.
  bool is_pole(const Point_2& z) const
  {
    return m_kind == POLAR ? m_polar.is_pole(z) : m_kind == CORNER && m_corner.is_pole(z);
  }

  // A point of the patch at about this distance from the pole `z`.
  Point_2 beside_pole(const Point_2& z, double distance) const
  {
    return m_kind == POLAR ? m_polar.beside_pole(z, distance) : m_corner.beside_pole(z, distance);
  }

  // The angle that the surface has in space at the pole `z`, or 0 if it is not known.
  double angle_at_pole(const Point_2& z) const { return m_kind == POLAR ? m_polar.angle_at_pole(z) : 0; }

  // The chart point of a domain point.
  Point_2 chart_point(const Point_2& uv) const
  {
    return m_kind == POLAR ? m_polar.chart_point(uv) : m_kind == CORNER ? m_corner.chart_point(uv) : uv;
  }

  // The domain point of a chart point; for a pole, some point of a collapsed side.
  Point_2 domain_point(const Point_2& z) const
  {
    return m_kind == POLAR ? m_polar.domain_point(z) : m_kind == CORNER ? m_corner.domain_point(z) : z;
  }

  // Moves `pole`, a domain point on a collapsed side, along that side to the place opposite to `other`.
  Point_2 on_collapsed_side(const Point_2& pole, const Point_2& other) const
  {
    return m_kind == POLAR ? m_polar.on_collapsed_side(pole, other) : m_corner.on_collapsed_side(other);
  }

  // Converts the jet of a surface from coordinates of the domain to those of the chart, at the chart point `z`.
  // \pre `z` is not a pole
  Surface_jet_3<Kernel> chart_jet(const Surface_jet_3<Kernel>& jet, const Point_2& z) const
  {
    return m_kind == POLAR ? m_polar.chart_jet(jet, z) : m_kind == CORNER ? m_corner.chart_jet(jet, z) : jet;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_PATCH_CHART_2_H
