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

// The coordinates that a patch is meshed in: those of its domain or, if sides of it collapse, those of a chart.
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

  // Whether deviation and sizes go by straight lines of the domain. Where two sides collapse in a corner these bend all over
  // the patch, and lines of the chart count.
  bool keeps_domain_lines() const { return m_kind != CORNER; }

  // whether `z` is a collapsed side, or several
  bool is_pole(const Point_2& z) const
  {
    return m_kind == POLAR ? m_polar.is_pole(z) : m_kind == CORNER && m_corner.is_pole(z);
  }

  // a point at a distance from the pole `z`, inside the patch
  Point_2 beside_pole(const Point_2& z, double distance) const
  {
    return m_kind == POLAR ? m_polar.beside_pole(z, distance) : m_corner.beside_pole(z, distance);
  }

  // the angle that the surface has in space at the pole `z`; 0 if not known
  double angle_at_pole(const Point_2& z) const { return m_kind == POLAR ? m_polar.angle_at_pole(z) : 0; }

  // from the domain to the chart
  Point_2 chart_point(const Point_2& uv) const
  {
    return m_kind == POLAR ? m_polar.chart_point(uv) : m_kind == CORNER ? m_corner.chart_point(uv) : uv;
  }

  // from the chart to the domain; at a pole, some point of a collapsed side
  Point_2 domain_point(const Point_2& z) const
  {
    return m_kind == POLAR ? m_polar.domain_point(z) : m_kind == CORNER ? m_corner.domain_point(z) : z;
  }

  // `pole`, a domain point of a pole, moved along its side to where `other` is
  Point_2 on_collapsed_side(const Point_2& pole, const Point_2& other) const
  {
    return m_kind == POLAR ? m_polar.on_collapsed_side(pole, other) : m_corner.on_collapsed_side(other);
  }

  // the jet by the chart's coordinates of a surface with this jet by the domain's, at the chart point `z`, no pole
  Surface_jet_3<Kernel> chart_jet(const Surface_jet_3<Kernel>& jet, const Point_2& z) const
  {
    return m_kind == POLAR ? m_polar.chart_jet(jet, z) : m_kind == CORNER ? m_corner.chart_jet(jet, z) : jet;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_PATCH_CHART_2_H
