// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_SURFACE_FOOT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_SURFACE_FOOT_H

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Surface_jet_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Two directions in space, perpendicular to each other, in which a point of a surface is to have the same coordinates as another one.
template <class Kernel>
struct Two_directions
{
  typename Kernel::Vector_3 first, second;
};

// Looks for the point of a surface that differs from `target` in no direction of `directions(jet)`, by Gauss-Newton steps from the
// parameters `start`; `scale` is a length of about the distance of the start from it.
// \return its parameters; none if there is no such point nearby
template <class Surface, class Directions>
std::optional<typename Surface::Geom_traits::Point_2>
find_on_surface(const Surface& surface, const typename Surface::Geom_traits::Point_2& start,
                const typename Surface::Geom_traits::Point_3& target, double scale, const Directions& directions)
{
  typedef typename Surface::Geom_traits Kernel;
  const int max_number_of_steps = 25;
  const double exactness = 1e-10; // of the last step, as a share of the scale
  double u = start.x(), v = start.y();
  for(int step = 0; step < max_number_of_steps; ++step) {
    const Surface_jet_3<Kernel> jet = surface.jet(u, v);
    const Two_directions<Kernel> d = directions(jet);
    const auto to_target = target - surface.point(u, v); // (a patch may give the derivatives at the side of its domain outside)
    const double a = jet.du * d.first, b = jet.dv * d.first, e = to_target * d.first,
                 a2 = jet.du * d.second, b2 = jet.dv * d.second, e2 = to_target * d.second, determinant = a * b2 - b * a2;
    double du = (e * b2 - b * e2) / determinant, dv = (a * e2 - e * a2) / determinant;
    const double length = std::sqrt((du * jet.du + dv * jet.dv).squared_length());
    if(!std::isfinite(length))
      return std::nullopt;
    const double share = length > scale ? scale / length : 1;
    u += share * du;
    v += share * dv;
    if(length <= exactness * scale)
      return typename Kernel::Point_2(u, v);
  }
  return std::nullopt;
}

// For the closest point: that from which `target` is seen along the normal.
struct Tangent_directions
{
  template <class Kernel>
  Two_directions<Kernel> operator()(const Surface_jet_3<Kernel>& jet) const
  {
    const auto u = jet.du / std::sqrt(jet.du.squared_length()), v = jet.dv - (jet.dv * u) * u;
    return {u, v / std::sqrt(v.squared_length())};
  }
};

// For the point in the plane through the target that `axis`, a unit vector, is normal to, as close there to the target as possible.
template <class Kernel>
struct Directions_in_section
{
  typename Kernel::Vector_3 axis;

  Two_directions<Kernel> operator()(const Surface_jet_3<Kernel>& jet) const
  {
    const auto along = cross_product(axis, cross_product(jet.du, jet.dv));
    return {axis, along / std::sqrt(along.squared_length())};
  }
};

// Where to look for the middle of an edge: the middle of its line in the domain, and, since this is far off where a parameter has
// no meaning, as around a pole, also with a coordinate of one of the ends.
template <class Point_2>
std::vector<Point_2> places_between(const Point_2& p, const Point_2& q)
{
  const double u = 0.5 * (p.x() + q.x()), v = 0.5 * (p.y() + q.y());
  return {Point_2(u, v), Point_2(p.x(), v), Point_2(q.x(), v), Point_2(u, p.y()), Point_2(u, q.y())};
}

// Calls `find(start)` from several places in the domain until it is true: from the first one, unless its point is much farther from
// `target` than that of another one, then from all of them, the closest first. Two ways around an apex may be about as long; the first
// place tells which one is meant.
template <class Surface, class Find>
bool find_near(const Surface& surface, const typename Surface::Geom_traits::Point_3& target,
               const std::vector<typename Surface::Geom_traits::Point_2>& places, double close, const Find& find)
{
  const double squared_ratio_of_much_farther = 4;
  std::vector<std::pair<double, std::size_t>> order;
  for(std::size_t i = 0; i < places.size(); ++i) {
    const double squared = squared_distance(surface.point(places[i].x(), places[i].y()), target);
    if(i == 0 && squared <= close * close && find(places[0]))
      return true;
    order.emplace_back(std::isnan(squared) ? std::numeric_limits<double>::infinity() : squared, i);
  }
  if(order.front().first <= squared_ratio_of_much_farther * (std::min_element(order.begin(), order.end())->first))
    order.front().first = 0;
  std::sort(order.begin(), order.end());
  return std::any_of(order.begin(), order.end(), [&](const auto& place) { return find(places[place.second]); });
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_SURFACE_FOOT_H
