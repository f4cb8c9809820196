// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_FACE_MEASURES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_FACE_MEASURES_H

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The measures of a triangle that criteria and placement use, all computed from the squared lengths of its edges under the metric.
// With the default metric these are the measures of the triangle in space.
struct Face_measures
{
  std::array<double, 3> squared_lengths; // entry i: of the edge opposite to vertex i
  double squared_circumradius;
  double squared_smallest_sine; // squared sine of the smallest angle
};

// 16 times the squared area, by Heron's formula.
inline double squared_area_16(const std::array<double, 3>& l)
{
  return 2 * (l[0] * l[1] + l[1] * l[2] + l[2] * l[0]) - (l[0] * l[0] + l[1] * l[1] + l[2] * l[2]);
}

inline double squared_circumradius(const std::array<double, 3>& l)
{
  const double area = squared_area_16(l);
  return area > 0 ? l[0] * l[1] * l[2] / area : std::numeric_limits<double>::infinity();
}

// The squared sine of the smallest angle.
inline double squared_smallest_sine(const std::array<double, 3>& l)
{
  const double area = squared_area_16(l);
  return area > 0 ? (std::min)(l[0], (std::min)(l[1], l[2])) * area / (4 * (l[0] * l[1] * l[2])) : 0;
}

inline double squared_sine_of_degrees(double angle)
{
  const double sine = std::sin(angle * CGAL_PI / 180);
  return sine * sine;
}

inline Face_measures face_measures(const std::array<double, 3>& l)
{
  const double product = l[0] * l[1] * l[2];
  const double area = squared_area_16(l);
  const double shortest = (std::min)(l[0], (std::min)(l[1], l[2]));
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

// Whether a face is on the wrong side, see the oracle.
template <class Face_handle, class Oracle>
bool is_inverted(Face_handle f, const Oracle& oracle)
{
  return oracle.is_inverted(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
}

// How far the surface may be from a triangle.
struct Deviation_limits
{
  double gamma;                  // largest H/L of an edge
  double squared_distance;       // 0 for no limit
  double squared_divisible_edge; // edges that are not longer cannot be refined
};

// How far the surface is from a triangle or an edge.
struct Squared_deviation
{
  double ratio = 0;  // (H/L)^2
  double height = 0; // H^2

  void include(const Squared_deviation& other)
  {
    ratio = (std::max)(ratio, other.ratio);
    height = (std::max)(height, other.height);
  }

  bool has_ratio_within(const Deviation_limits& limits) const { return ratio <= limits.gamma * limits.gamma; }

  bool has_height_within(const Deviation_limits& limits) const
  {
    return !(limits.squared_distance > 0) || height <= limits.squared_distance;
  }
};

// Notes an edge as close to the surface, in both its faces if both are in the domain.
template <class Face_handle>
void set_close(Face_handle f, int i)
{
  f->set_close(i);
  if(f->is_constrained(i))
    return;
  const Face_handle across = f->neighbor(i);
  across->set_close(across->index(f));
}

template <class Face_handle>
double squared_length_in_space(Face_handle f, int i)
{
  return squared_distance(f->vertex((i + 1) % 3)->point().surface_point(), f->vertex((i + 2) % 3)->point().surface_point());
}

// Whether an edge is long enough to be divided.
template <class Face_handle>
bool has_divisible_edge(Face_handle f, const Deviation_limits& limits)
{
  return squared_length_in_space(f, 0) > limits.squared_divisible_edge
         || squared_length_in_space(f, 1) > limits.squared_divisible_edge
         || squared_length_in_space(f, 2) > limits.squared_divisible_edge;
}

// The deviation at an edge, which is noted in both its faces if it is within the limits, and not evaluated again.
template <class Face_handle, class Oracle>
Squared_deviation squared_deviation_of_edge(Face_handle f, int i, double squared_length, const Oracle& oracle,
                                            const Deviation_limits& limits)
{
  Squared_deviation result;
  result.height = oracle.squared_height(f->vertex((i + 1) % 3)->point(), f->vertex((i + 2) % 3)->point(), limits.gamma);
  if(result.height > 0)
    result.ratio = result.height / squared_length;
  if(result.has_ratio_within(limits) && result.has_height_within(limits))
    set_close(f, i);
  return result;
}

// The largest deviation at the edges for which a triangle can be refined: neither on the boundary nor, for the sake of the
// ratio, too short to be divided. A triangle whose edges are all too short is left alone.
template <class Face_handle, class Oracle>
Squared_deviation squared_deviation_to_refine(Face_handle f, const Oracle& oracle, const Deviation_limits& limits)
{
  Squared_deviation worst;
  if(!has_divisible_edge(f, limits))
    return worst;
  for(int i = 0; i < 3; ++i) {
    if(f->is_constrained(i) || f->is_close(i))
      continue;
    const double squared_length = squared_length_in_space(f, i);
    const bool is_divisible = squared_length > limits.squared_divisible_edge;
    if(!is_divisible && !(limits.squared_distance > 0))
      continue;
    Squared_deviation found = squared_deviation_of_edge(f, i, squared_length, oracle, limits);
    if(!is_divisible)
      found.ratio = 0;
    worst.include(found);
  }
  return worst;
}

// The largest deviation at all edges that are not known to be close to the surface.
template <class Face_handle, class Oracle>
Squared_deviation squared_deviation_of_edges(Face_handle f, const Oracle& oracle, const Deviation_limits& limits)
{
  Squared_deviation worst;
  for(int i = 0; i < 3; ++i)
    if(!f->is_close(i))
      worst.include(squared_deviation_of_edge(f, i, squared_length_in_space(f, i), oracle, limits));
  return worst;
}

// The squared distance of the surface at the centroid from the plane of the triangle.
template <class Face_handle, class Oracle>
double squared_distance_at_centroid(Face_handle f, const Oracle& oracle)
{
  const auto &a = f->vertex(0)->point(), &b = f->vertex(1)->point(), &c = f->vertex(2)->point();
  const auto &p = a.surface_point(), &q = b.surface_point(), &r = c.surface_point();
  const auto normal = cross_product(q - p, r - p);
  const double area = normal * normal;
  if(!(area > 0))
    return 0;
  const typename Oracle::Geom_traits::Point_2 centroid((a.x() + b.x() + c.x()) / 3, (a.y() + b.y() + c.y()) / 3);
  const double height = normal * (oracle.surface().point(centroid.x(), centroid.y()) - p);
  if(!std::isfinite(height))
    throw_not_finite(oracle.surface(), centroid);
  return height * height / area;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_FACE_MEASURES_H
