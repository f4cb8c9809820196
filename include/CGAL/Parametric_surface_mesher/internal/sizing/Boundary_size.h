// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_BOUNDARY_SIZE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_BOUNDARY_SIZE_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Domain_curve_2.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Spacing_limit.h>
#include <CGAL/Surface_jet_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Some points of a curve with both its ends, for boxes and areas. A loop may run against its curves, so that neither end is
// sure to begin another one.
template <class Kernel>
std::vector<typename Kernel::Point_2> sample(const Domain_curve_2<Kernel>& curve)
{
  const int n = curve.is_straight() ? 1 : 32;
  std::vector<typename Kernel::Point_2> result;
  for(int i = 0; i <= n; ++i)
    result.push_back(curve.point(curve.begin() + (curve.end() - curve.begin()) * i / n));
  return result;
}

// Twice the signed area between a curve and the point `origin`: summed over a loop, twice its area.
template <class Kernel>
double double_area_seen_from(const typename Kernel::Point_2& origin, const Domain_curve_2<Kernel>& curve)
{
  const auto points = sample(curve);
  double sum = 0;
  for(std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto p = points[i] - origin, q = points[i + 1] - origin;
    sum += p.x() * q.y() - p.y() * q.x();
  }
  return sum;
}

// The box around the curves of a loop.
template <class Loop, class CurveOf>
Bbox_2 loop_box(const Loop& loop, CurveOf curve_of)
{
  Bbox_2 box;
  for(const auto& item : loop)
    for(const auto& p : sample(curve_of(item)))
      box += p.bbox();
  return box;
}

// The box around the curves of loops.
template <class Loops, class CurveOf>
Bbox_2 domain_box(const Loops& loops, CurveOf curve_of)
{
  Bbox_2 box;
  for(const auto& loop : loops)
    box += loop_box(loop, curve_of);
  return box;
}

// The edge length wanted on a boundary curve: the spacing limit of the patch there, and farther inside as much as can be
// graded. Without the look inside, a curve beside a sharp fold would be divided too coarsely for the triangles between them.
template <class Oracle>
class Boundary_size
{
  typedef typename Oracle::Geom_traits Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Vector_2 Vector_2;

  static constexpr double gradation = 0.3; // by how much the spacing may grow per distance

  const Oracle& m_oracle;
  Spacing_limit<Oracle> m_limit;
  Bbox_2 m_box;

public:
  // no point outside `box` is evaluated
  Boundary_size(const Oracle& oracle, const Parametric_surface_mesh_criteria& criteria, const Bbox_2& box)
    : m_oracle(oracle), m_limit(oracle, criteria, box), m_box(box)
  {}

  const Bbox_2& box() const { return m_box; }

  // at the parameter `t` of a curve with the domain on its left, or on its right
  double operator()(const Domain_curve_2<Kernel>& curve, double t, bool is_domain_left) const
  {
    const auto c = curve.jet(t);
    const Surface_jet_3<Kernel> jet = m_oracle.surface().jet(c.point.x(), c.point.y());
    double size = m_limit(c.point, jet);
    const Vector_2 inward = unit_vector_across(jet, is_domain_left ? c.first : -c.first);
    for(double share : {1., 0.5, 0.25}) {
      const double distance = share * size;
      const Point_2 p = c.point + distance * inward;
      if(is_in_box(p))
        size = (std::min)(size, limit_inside(p) + gradation * distance);
    }
    return size;
  }

private:
  // The domain vector whose image has length 1 and is to the left of, and perpendicular to, that of `d`.
  static Vector_2 unit_vector_across(const Surface_jet_3<Kernel>& jet, const Vector_2& d)
  {
    const double e = jet.du * jet.du, f = jet.du * jet.dv, g = jet.dv * jet.dv;
    const double squared_length = e * d.x() * d.x() + 2 * f * d.x() * d.y() + g * d.y() * d.y();
    const double scale = 1 / std::sqrt((e * g - f * f) * squared_length);
    return std::isfinite(scale) ? scale * Vector_2(-f * d.x() - g * d.y(), e * d.x() + f * d.y()) : Vector_2(0, 0);
  }

  bool is_in_box(const Point_2& p) const
  {
    return m_box.xmin() <= p.x() && p.x() <= m_box.xmax() && m_box.ymin() <= p.y() && p.y() <= m_box.ymax();
  }

  // where the surface is trimmed away it need not be defined
  double limit_inside(const Point_2& p) const
  {
    const Surface_jet_3<Kernel> jet = m_oracle.surface().jet(p.x(), p.y());
    const double sum = (jet.du + jet.dv + jet.duu + jet.duv + jet.dvv).squared_length();
    return std::isfinite(sum) ? m_limit.by_curvature(p, jet) : std::numeric_limits<double>::infinity();
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_BOUNDARY_SIZE_H
