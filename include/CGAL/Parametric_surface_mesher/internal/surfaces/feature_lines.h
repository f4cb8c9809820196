// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_FEATURE_LINES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_FEATURE_LINES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Lines of the domain, by their u and by their v, in ascending order: no feature of a surface is narrower than they are apart.
// A surface with none at all has no features: it is made of lines, circles, or the like.
typedef std::array<std::vector<double>, 2> Feature_lines;

template <class Surface, class = void>
struct Has_feature_lines : std::false_type
{};

template <class Surface>
struct Has_feature_lines<Surface, std::void_t<decltype(std::declval<const Surface&>().feature_lines())>> : std::true_type
{};

// n lines between `min` and `max`, with half a gap at either end.
inline std::vector<double> even_lines(double min, double max, std::size_t n)
{
  std::vector<double> result;
  for(std::size_t i = 0; i < n; ++i)
    result.push_back(min + (max - min) * (double(i) + 0.5) / double(n));
  return result;
}

// The lines of a surface that knows them, else `n` in each direction of `box`.
template <class Surface, class Box>
Feature_lines feature_lines(const Surface& surface, const Box& box, std::size_t n)
{
  if constexpr(Has_feature_lines<Surface>::value)
    return surface.feature_lines();
  else
    return {even_lines(box.xmin(), box.xmax(), n), even_lines(box.ymin(), box.ymax(), n)};
}

// Those of a piecewise polynomial: as many as its degree for each piece, its beginning among them.
inline std::vector<double> polynomial_lines(const std::vector<double>& ends_of_pieces, int degree)
{
  std::vector<double> result;
  for(std::size_t i = 0; i + 1 < ends_of_pieces.size(); ++i)
    if(ends_of_pieces[i] < ends_of_pieces[i + 1])
      for(int k = 0; k < degree; ++k)
        result.push_back(ends_of_pieces[i] + (ends_of_pieces[i + 1] - ends_of_pieces[i]) * k / degree);
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_FEATURE_LINES_H
