// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_POINT_PLACEMENTS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_POINT_PLACEMENTS_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {

/// \ingroup PkgParametricSurfaceMesherRef
/// barycentric coordinates of a point in a triangle, by corner; also three numbers for the sides opposite to the corners.
typedef std::array<double, 3> Triangle_weights;

/*!
\ingroup PkgParametricSurfaceMesherRef

places a point at the centre of the circumellipse of a triangle (paper, section "Procedure"); of a triangle without area, in its centroid.

\cgalModels{ParametricSurfacePointPlacement}
*/
class Circumcenter_placement
{
  static constexpr double rounding_of_area = 1e-12; // relative, of 16 times the squared area

public:
  /// returns the place, of the squared lengths of the sides.
  Triangle_weights operator()(const Triangle_weights& squared_lengths, double /* spacing */) const
  {
    const Triangle_weights& l = squared_lengths;
    const Triangle_weights w = {l[0] * (l[1] + l[2] - l[0]), l[1] * (l[2] + l[0] - l[1]), l[2] * (l[0] + l[1] - l[2])};
    const double sum = w[0] + w[1] + w[2]; // 16 times the squared area
    if(!(sum > rounding_of_area * (std::max)({l[0], l[1], l[2]}) * (std::max)({l[0], l[1], l[2]})))
      return {1. / 3, 1. / 3, 1. / 3};
    return {w[0] / sum, w[1] / sum, w[2] / sum};
  }
};

/*!
\ingroup PkgParametricSurfaceMesherRef

places a point between the middle of the shortest side of a triangle and its circumcentre, where the triangle with that side has a given angle
(Ungor 2004), or the wanted size if that is farther away.

\cgalModels{ParametricSurfacePointPlacement}
*/
class Off_center_placement
{
  static constexpr double height_of_equilateral = 0.87; // over the side; sqrt(3) / 2 is 0.866

  double m_angle;

public:
  /// `angle`: in radians, above 0 and below pi
  explicit Off_center_placement(double angle) : m_angle(angle) {}

  /// returns the place, of the squared lengths of the sides and the wanted edge length.
  Triangle_weights operator()(const Triangle_weights& squared_lengths, double spacing) const
  {
    const Triangle_weights& l = squared_lengths;
    const std::size_t shortest = std::size_t(std::min_element(l.begin(), l.end()) - l.begin());
    const double squared_sum = 2 * (l[0] * l[1] + l[1] * l[2] + l[2] * l[0]) - l[0] * l[0] - l[1] * l[1] - l[2] * l[2];
    const double squared_circumradius = l[0] * l[1] * l[2] / squared_sum;
    const double height = (std::max)(0.5 * std::sqrt(l[shortest]) / std::tan(0.5 * m_angle), height_of_equilateral * spacing);
    const double distance = std::sqrt((std::max)(0., squared_circumradius - l[shortest] / 4));
    const Triangle_weights center = Circumcenter_placement()(l, spacing);
    return height < distance ? on_axis(shortest, height / distance, center) : center;
  }

  /// the point at a share of the way from the middle of the side opposite to a corner to a centre on the axis of that side.
  static Triangle_weights on_axis(std::size_t corner, double share, const Triangle_weights& center)
  {
    Triangle_weights weights = {0.5, 0.5, 0.5};
    weights[corner] = 0;
    for(std::size_t i = 0; i < 3; ++i)
      weights[i] += share * (center[i] - weights[i]);
    return weights;
  }
};

} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_POINT_PLACEMENTS_H
