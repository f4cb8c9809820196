// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_MIDDLE_OF_CURVE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_MIDDLE_OF_CURVE_H

#include <CGAL/Parametric_surface_mesher/internal/curves/Arc_length.h>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The middle, by length in space, of the piece of a curve between two of its parameters.
template <class Curve>
typename Curve::Point_3 middle_of_piece(const Curve& curve, double from, double to)
{
  const auto speed = [&](double t) { return curve.speed(t); };
  const Arc_length<decltype(speed)> arc_length(speed, from, to, 1);
  const double length = arc_length.length();
  return curve.point(length > 0 ? arc_length.position_at(length / 2).parameter : from + (to - from) / 2);
}

// The point of a curve that is closest to `place`: the best of a row of points, made better between its neighbours.
template <class Curve>
typename Curve::Point_3 closest_point(const Curve& curve, const typename Curve::Point_3& place)
{
  const int number_of_places = 64, number_of_bits = std::numeric_limits<double>::digits / 2;
  const auto squared = [&](double t) { return squared_distance(curve.point(t), place); };
  const auto parameter = [&](int i) { return curve.begin() + double(i) / number_of_places * (curve.end() - curve.begin()); };
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for(int i = 0; i <= number_of_places; ++i) {
    const double value = squared(parameter(i));
    if(value < least) {
      least = value;
      best = i;
    }
  }
  const double a = parameter((std::max)(best - 1, 0)), b = parameter((std::min)(best + 1, number_of_places));
  std::uintmax_t max_number_of_steps = 50;
  const auto found
    = boost::math::tools::brent_find_minima(squared, (std::min)(a, b), (std::max)(a, b), number_of_bits, max_number_of_steps);
  return curve.point(found.second < least ? found.first : parameter(best));
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_MIDDLE_OF_CURVE_H
