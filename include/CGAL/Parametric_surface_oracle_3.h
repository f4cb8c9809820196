// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_ORACLE_3_H
#define CGAL_PARAMETRIC_SURFACE_ORACLE_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Chord_jet.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Surface_jet_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {

namespace Parametric_surface_mesher {
namespace internal {

// The middle of an edge, straight in the domain. A surface in other coordinates than those of its domain has overloads of
// this and the next three functions.
template <class Surface, class ParametricPoint>
auto edge_middle(const Surface&, const ParametricPoint& p, const ParametricPoint& q)
{
  return typename Surface::Geom_traits::Point_2(0.5 * (p.x() + q.x()), 0.5 * (p.y() + q.y()));
}

// the point of the surface there
template <class Surface, class ParametricPoint>
auto edge_middle_in_space(const Surface& surface, const ParametricPoint& p, const ParametricPoint& q)
{
  const auto middle = edge_middle(surface, p, q);
  return surface.point(middle.x(), middle.y());
}

// The point of an edge at a share of the way from `p`.
template <class Surface, class ParametricPoint>
auto edge_point(const Surface&, const ParametricPoint& p, const ParametricPoint& q, double share)
{
  return typename Surface::Geom_traits::Point_2(p.x() + share * (q.x() - p.x()), p.y() + share * (q.y() - p.y()));
}

// What the user knows of a point: its place in the domain.
template <class Surface, class Point_2>
Point_2 place_in_domain(const Surface&, const Point_2& p)
{
  return p;
}

template <class Surface, class Point_2>
void throw_not_finite(const Surface& surface, const Point_2& p)
{
  throw Parametric_surface_mesh_error("the surface is not finite at (u,v) = " + describe(place_in_domain(surface, p)));
}

} // namespace internal
} // namespace Parametric_surface_mesher

/*!
\ingroup PkgParametricSurfaceMesherRef

What the criteria may ask of a patch: its surface, its metric field, and how far the surface is from the mesh.

Deviation is measured as in the paper: `H` is the distance of the surface point at the domain's middle of an edge to
the edge. On a regular parametrisation that bounds the distance from the mesh, and how far the image of the straight domain
line bends within the surface. Around a singular point (a pole, where a side of the domain collapses) those images
bend however small the edges are: at a distance `r` the ratio is `L / 8r`. Closer to such a point than `L / 6 gamma`
only the part of `H` along the surface normal counts. It is the same with edges at an end of which
the first derivatives change, within the surface, by as much as they are over the length of the edge, and with edges between
the ends of which the derivative along them changes by as much as it is at the slower end, as long as `H/L` is below 0.3:
there the parametrisation is singular, or nearly so, or derivatives jump across a line, and edges bend however short
they are.

\tparam Surface_ a model of `ParametricSurface_3`
\tparam MetricField a model of `ParametricSurfaceMetricField_2`
*/
template <class Surface_, class MetricField>
class Parametric_surface_oracle_3
{
public:
  typedef Surface_ Surface;
  typedef MetricField Metric_field;
  typedef typename Surface::Geom_traits Geom_traits;
  typedef typename Geom_traits::Point_3 Point_3;
  typedef typename Geom_traits::Vector_3 Vector_3;

private:
  const Surface& m_surface;
  const MetricField& m_metric;
  std::vector<Point_3> m_singular_points;

public:
  /// refers to `surface` and `metric`. `singular_points` are the images of collapsed sides.
  Parametric_surface_oracle_3(const Surface& surface, const MetricField& metric,
                              std::vector<Point_3> singular_points = std::vector<Point_3>())
    : m_surface(surface), m_metric(metric), m_singular_points(std::move(singular_points))
  {}

  /// the surface.
  const Surface& surface() const { return m_surface; }

  /// the metric field.
  const MetricField& metric() const { return m_metric; }

  /// the images of collapsed sides.
  const std::vector<Point_3>& singular_points() const { return m_singular_points; }

  /// tells whether `p` is closer to a singular point than `distance`.
  bool is_near_singular_point(const Point_3& p, double distance) const
  {
    return std::any_of(m_singular_points.begin(), m_singular_points.end(), [&](const Point_3& s) {
      return squared_distance(p, s) < distance * distance;
    });
  }

  /*!
  the squared height `H` of the surface over the edge from `p` to `q`.
  \throws Parametric_surface_mesh_error if the surface is not finite there
  \param gamma the deviation ratio that it will be compared with
  */
  template <class ParametricPoint>
  double squared_height(const ParametricPoint& p, const ParametricPoint& q, double gamma) const
  {
    using namespace Parametric_surface_mesher::internal;
    const Vector_3 height = vector_from_line(edge_middle_in_space(m_surface, p, q), p.surface_point(), q.surface_point());
    double result = height.squared_length();
    if(counts_along_normal_only(p, q, result, gamma))
      result = squared_height_along_normal(edge_middle(m_surface, p, q), height);
    if(!std::isfinite(result))
      throw_not_finite(m_surface, edge_middle(m_surface, p, q));
    return result;
  }

  /*!
  the same over the point of the edge at a share of the way from `p` to `q`.
  \throws Parametric_surface_mesh_error if the surface is not finite there
  */
  template <class ParametricPoint>
  double squared_height_at(double share, const ParametricPoint& p, const ParametricPoint& q, double gamma) const
  {
    using namespace Parametric_surface_mesher::internal;
    const auto place = edge_point(m_surface, p, q, share);
    const Vector_3 height = vector_from_line(m_surface.point(place.x(), place.y()), p.surface_point(), q.surface_point());
    double result = height.squared_length();
    if(counts_along_normal_only(p, q, result, gamma))
      result = squared_height_along_normal(place, height);
    if(!std::isfinite(result))
      throw_not_finite(m_surface, place);
    return result;
  }

  /*!
  tells whether a triangle, given by its corners counterclockwise in the domain, lies on the wrong side: facing away from
  the surface at its centroid. That can be only where the parametrisation changes its speed within the triangle.
  */
  template <class ParametricPoint>
  bool is_inverted(const ParametricPoint& p, const ParametricPoint& q, const ParametricPoint& r) const
  {
    if(is_nearly_uniform(p, q, 1.5) && is_nearly_uniform(q, r, 1.5) && is_nearly_uniform(r, p, 1.5))
      return false;
    const Surface_jet_3<Geom_traits> jet = m_surface.jet((p.x() + q.x() + r.x()) / 3, (p.y() + q.y() + r.y()) / 3);
    return cross_product(jet.du, jet.dv)
             * cross_product(q.surface_point() - p.surface_point(), r.surface_point() - p.surface_point()) < 0;
  }

private:
  template <class ParametricPoint>
  bool counts_along_normal_only(const ParametricPoint& p, const ParametricPoint& q, double squared_height, double gamma) const
  {
    const Point_3 &a = p.surface_point(), &b = q.surface_point();
    const double squared_length = squared_distance(a, b);
    if(squared_height <= gamma * gamma * squared_length)
      return false;
    if(!m_singular_points.empty() && is_near_singular_point(midpoint(a, b), std::sqrt(squared_length) / (6 * gamma)))
      return true;
    return squared_height < 0.09 * squared_length
           && (is_singular_over(p, squared_length, gamma) || is_singular_over(q, squared_length, gamma) || has_jump_between(p, q));
  }

  // Whether the derivative along an edge changes by as much as it is: if first derivatives jump across a line, shorter edges
  // across it bend as much.
  template <class ParametricPoint>
  bool has_jump_between(const ParametricPoint& p, const ParametricPoint& q) const
  {
    const Surface_jet_3<Geom_traits> at_p = m_surface.jet(p.x(), p.y()), at_q = m_surface.jet(q.x(), q.y());
    const double du = q.x() - p.x(), dv = q.y() - p.y();
    const Vector_3 from_p = du * at_p.du + dv * at_p.dv, from_q = du * at_q.du + dv * at_q.dv;
    return (from_p - from_q).squared_length() > (std::min)(from_p.squared_length(), from_q.squared_length());
  }

  // Whether, at the end `p` of an edge, first derivatives change within the surface by as much as they are over its length.
  template <class ParametricPoint>
  bool is_singular_over(const ParametricPoint& p, double squared_length, double gamma) const
  {
    return Parametric_surface_mesher::internal::changes_within(m_surface.jet(p.x(), p.y()), std::sqrt(squared_length), gamma);
  }

  // Whether the squared speed of the parametrisation changes by less than a factor along an edge.
  template <class ParametricPoint>
  bool is_nearly_uniform(const ParametricPoint& p, const ParametricPoint& q, double factor) const
  {
    const double du = q.x() - p.x(), dv = q.y() - p.y();
    const double at_p = p.tensor().squared_length(du, dv), at_q = q.tensor().squared_length(du, dv),
                 between = m_metric.squared_length(p, q);
    return (std::max)({at_p, at_q, between}) < factor * (std::min)({at_p, at_q, between});
  }

  template <class Point_2>
  double squared_height_along_normal(const Point_2& middle, const Vector_3& height) const
  {
    const Surface_jet_3<Geom_traits> jet = m_surface.jet(middle.x(), middle.y());
    const Vector_3 normal = cross_product(jet.du, jet.dv);
    const double along = height * normal, length = normal.squared_length();
    return length > 0 ? along * along / length : height.squared_length();
  }

  // from the line through `a` and `b` to `x`, perpendicular
  static Vector_3 vector_from_line(const Point_3& x, const Point_3& a, const Point_3& b)
  {
    const Vector_3 d = b - a, e = x - a;
    const double length = d.squared_length();
    return length > 0 ? e - (e * d / length) * d : e;
  }
};

/// \ingroup PkgParametricSurfaceMesherRef
/// the oracle of a patch; refers to `surface` and `metric`.
template <class Surface, class MetricField>
Parametric_surface_oracle_3<Surface, MetricField>
make_parametric_surface_oracle(const Surface& surface, const MetricField& metric,
            std::vector<typename Surface::Geom_traits::Point_3> singular_points)
{
  return Parametric_surface_oracle_3<Surface, MetricField>(surface, metric, std::move(singular_points));
}

} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_ORACLE_3_H
