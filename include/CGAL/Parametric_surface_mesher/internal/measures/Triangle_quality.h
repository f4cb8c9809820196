// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_TRIANGLE_QUALITY_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_TRIANGLE_QUALITY_H

#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Qualities of a triangle by the squared lengths of its edges: 1 for an equilateral triangle, 0 for a degenerate one.

// 48 area^2 / (sum of the squared lengths)^2
struct Squared_mean_ratio
{
  double operator()(const std::array<double, 3>& squared_lengths) const
  {
    const double sum = squared_lengths[0] + squared_lengths[1] + squared_lengths[2];
    return 3 * squared_area_16(squared_lengths) / (sum * sum);
  }
};

// The squared mean ratio and, at half its weight, 4/3 of the squared sine of the smallest angle.
struct Mean_ratio_and_angle
{
  static constexpr double weight_of_angle = 0.5;

  double operator()(const std::array<double, 3>& squared_lengths) const
  {
    return (mean_ratio(squared_lengths) + weight_of_angle / 0.75 * squared_smallest_sine(squared_lengths))
           / (1 + weight_of_angle);
  }

  // by squared lengths 1 and 2; where two edges are the shortest, those of one branch. 0 for a degenerate triangle
  std::array<double, 2> derivatives(const std::array<double, 3>& l) const
  {
    const double area = squared_area_16(l), sum = l[0] + l[1] + l[2];
    if(!(area > 0))
      return {0, 0};
    const double ratio = mean_ratio(l) / (1 + weight_of_angle),
                 angle = weight_of_angle / 0.75 * squared_smallest_sine(l) / (1 + weight_of_angle);
    const auto shortest = std::min_element(l.begin(), l.end()) - l.begin();
    const auto derivative = [&](int i) {
      const double of_log_area = 2 * (sum - 2 * l[i]) / area;
      return ratio * (of_log_area - 2 / sum) + angle * (of_log_area - (shortest == i ? 0 : 1 / l[i]));
    };
    return {derivative(1), derivative(2)};
  }

private:
  static double mean_ratio(const std::array<double, 3>& squared_lengths) { return Squared_mean_ratio()(squared_lengths); }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_TRIANGLE_QUALITY_H
