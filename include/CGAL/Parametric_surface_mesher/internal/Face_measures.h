// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FACE_MEASURES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FACE_MEASURES_H

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// What the criteria and the placement need of a triangle, all from the squared lengths of its edges under
// the metric: for the default metric these are the measures of the triangle in space.
struct Face_measures
{
  std::array<double, 3> squared_lengths; // of the edge opposite to vertex i
  double squared_circumradius;
  double squared_smallest_sine; // of the smallest angle
};

// 16 times the squared area (Heron)
inline double squared_area_16(const std::array<double, 3>& l)
{
  return 2 * (l[0] * l[1] + l[1] * l[2] + l[2] * l[0]) - (l[0] * l[0] + l[1] * l[1] + l[2] * l[2]);
}

inline double squared_circumradius(const std::array<double, 3>& l)
{
  const double area = squared_area_16(l);
  return area > 0 ? l[0] * l[1] * l[2] / area : std::numeric_limits<double>::infinity();
}

inline Face_measures face_measures(const std::array<double, 3>& l)
{
  const double product = l[0] * l[1] * l[2];
  const double area = squared_area_16(l);
  const double shortest = (std::min)({l[0], l[1], l[2]});
  if(area > 0)
    return {l, product / area, shortest * area / (4 * product)};
  return {l, std::numeric_limits<double>::infinity(), 0};
}

template <class Face_handle, class MetricField>
std::array<double, 3> squared_lengths(Face_handle f, const MetricField& metric)
{
  const auto &p = f->vertex(0)->point(), &q = f->vertex(1)->point(), &r = f->vertex(2)->point();
  return {metric.squared_length(q, r), metric.squared_length(r, p), metric.squared_length(p, q)};
}

template <class Face_handle, class MetricField>
Face_measures face_measures(Face_handle f, const MetricField& metric)
{
  return face_measures(squared_lengths(f, metric));
}

// Notes an edge as close to the surface, in both its faces.
template <class Face_handle>
void set_close(Face_handle f, int i)
{
  const Face_handle across = f->neighbor(i);
  f->set_close(i);
  across->set_close(across->index(f));
}

// The largest (H/L)^2 over the edges that are not constrained, and long enough to be divided. An edge below `gamma` is noted
// in both its faces, and not evaluated again.
template <class Face_handle, class Oracle>
double squared_deviation(Face_handle f, const Oracle& oracle, double gamma, double squared_divisible_edge)
{
  double worst = 0;
  for(int i = 0; i < 3; ++i) {
    if(f->is_constrained(i) || f->is_close(i))
      continue;
    const auto &p = f->vertex((i + 1) % 3)->point(), &q = f->vertex((i + 2) % 3)->point();
    const double squared_length = squared_distance(p.surface_point(), q.surface_point());
    const double deviation
      = squared_length > squared_divisible_edge ? oracle.squared_height(p, q, gamma) / squared_length : 0;
    if(deviation <= gamma * gamma)
      set_close(f, i);
    worst = (std::max)(worst, deviation);
  }
  return worst;
}

// The largest squared distance from the surface, at the middles of the edges that are not constrained and
// at the centroid. A triangle whose edges are all too short to be divided is left alone.
template <class Face_handle, class Oracle>
double squared_distance_to_surface(Face_handle f, const Oracle& oracle, double gamma, double squared_divisible_edge)
{
  const auto &a = f->vertex(0)->point(), &b = f->vertex(1)->point(), &c = f->vertex(2)->point();
  const auto &p = a.surface_point(), &q = b.surface_point(), &r = c.surface_point();
  double worst = 0, longest = 0;
  for(int i = 0; i < 3; ++i) {
    const auto &s = f->vertex((i + 1) % 3)->point(), &t = f->vertex((i + 2) % 3)->point();
    longest = (std::max)(longest, squared_distance(s.surface_point(), t.surface_point()));
    if(!f->is_constrained(i))
      worst = (std::max)(worst, oracle.squared_height(s, t, gamma));
  }
  if(longest <= squared_divisible_edge)
    return 0;
  const auto normal = cross_product(q - p, r - p);
  const double area = normal * normal;
  if(area > 0) {
    const typename Oracle::Geom_traits::Point_2 centroid((a.x() + b.x() + c.x()) / 3, (a.y() + b.y() + c.y()) / 3);
    const double height = normal * (oracle.surface().point(centroid.x(), centroid.y()) - p);
    if(!std::isfinite(height))
      throw_not_finite(oracle.surface(), centroid);
    worst = (std::max)(worst, height * height / area);
  }
  return worst;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FACE_MEASURES_H
