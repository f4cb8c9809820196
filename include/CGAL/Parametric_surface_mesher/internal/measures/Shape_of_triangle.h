// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_SHAPE_OF_TRIANGLE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_SHAPE_OF_TRIANGLE_H

#include <CGAL/Parametric_surface_mesher/internal/support/has_finite_coordinates.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Shape measures of a triangle in space. The initial values are those of a degenerate triangle.
struct Shape_of_triangle
{
  double min_angle = 0, max_angle = 180, radius_ratio = 0, area = 0;
  bool is_degenerate = true;
};

template <class Geom_traits>
Shape_of_triangle shape_of_triangle(const typename Geom_traits::Point_3& p,
                                    const typename Geom_traits::Point_3& q,
                                    const typename Geom_traits::Point_3& r,
                                    const Geom_traits& traits)
{
  Shape_of_triangle shape;
  if(!has_finite_coordinates(p) || !has_finite_coordinates(q) || !has_finite_coordinates(r)
     || traits.collinear_3_object()(p, q, r))
    return shape;

  const auto vector = traits.construct_vector_3_object();
  const std::array<typename Geom_traits::Vector_3, 3> side = {{vector(q, r), vector(r, p), vector(p, q)}};
  std::array<double, 3> length;
  for(std::size_t i = 0; i < 3; ++i)
    length[i] = std::sqrt(traits.compute_squared_length_3_object()(side[i]));

  // the product of the two shorter sides loses least to rounding, which a needle needs
  const std::size_t longest = std::max_element(length.begin(), length.end()) - length.begin();
  const std::size_t i = (longest + 1) % 3, j = (longest + 2) % 3;
  const double twice_area = std::sqrt(traits.compute_squared_length_3_object()(
    traits.construct_cross_product_vector_3_object()(side[i], side[j])));

  shape = {180, 0, 0, twice_area / 2, false};
  for(std::size_t k = 0; k < 3; ++k)
  {
    const double cosine_part = -traits.compute_scalar_product_3_object()(side[(k + 1) % 3], side[(k + 2) % 3]);
    const double angle = std::atan2(twice_area, cosine_part) * 180 / CGAL_PI;
    shape.min_angle = (std::min)(shape.min_angle, angle);
    shape.max_angle = (std::max)(shape.max_angle, angle);
  }
  // 2r/R = 16 area^2 / (perimeter * product of the sides), as two factors that stay in the range of double
  const double perimeter = length[0] + length[1] + length[2];
  shape.radius_ratio = 4 * (twice_area / (length[i] * length[j])) * (twice_area / (length[longest] * perimeter));
  return shape;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_SHAPE_OF_TRIANGLE_H
