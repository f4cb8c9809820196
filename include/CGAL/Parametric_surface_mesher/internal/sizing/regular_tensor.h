// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_REGULAR_TENSOR_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_REGULAR_TENSOR_H

#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Parametric_surface_oracle_3.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A tensor that predicates may use: positive definite, and so are its sums with others, whatever is rounded.
struct Regular_tensor
{
  Metric_tensor_2 tensor;
  bool is_replaced; // it is not the one that was given
  bool is_singular; // nor is any with eigenvalues of the same absolute values
};

// Below this ratio of the eigenvalues the determinant is rounding noise.
constexpr double smallest_ratio_of_eigenvalues = 1e-14;

inline bool is_well_conditioned(const Metric_tensor_2& m)
{
  return m.is_positive_definite() && m.determinant() > smallest_ratio_of_eigenvalues * m.trace() * m.trace();
}

// The tensor with the same eigenvectors and the absolute values of its eigenvalues, as is usual for metrics made of second
// derivatives; but none below a millionth of the larger one. A tensor that is zero becomes a small multiple of the identity.
// \pre the components are finite, and their squares do not overflow
inline Regular_tensor replaced_tensor(const Metric_tensor_2& m)
{
  constexpr double smallest_ratio = 1e-6, smallest_size = 1e-90, size_of_zero = 1e-100;
  const double half_trace = 0.5 * m.trace(), half_difference = 0.5 * (m.e() - m.g());
  const double radius = std::hypot(half_difference, m.f()); // half the difference of the eigenvalues
  const double size = std::fabs(half_trace) + radius;       // the larger absolute value of an eigenvalue
  const double least = size > smallest_size ? smallest_ratio * size : size_of_zero;
  const double first = (std::max)(std::fabs(half_trace + radius), least),
               second = (std::max)(std::fabs(half_trace - radius), least);
  const double mean = 0.5 * (first + second), scale = radius > 0 ? 0.5 * (first - second) / radius : 0;
  return {Metric_tensor_2(mean + scale * half_difference, scale * m.f(), mean - scale * half_difference), true,
          first == least || second == least};
}

// The tensor itself, to the last bit, where it is well conditioned.
inline Regular_tensor regular_tensor(const Metric_tensor_2& m)
{
  return is_well_conditioned(m) ? Regular_tensor{m, false, false} : replaced_tensor(m);
}

template <class MetricField, class Jet, class = void>
struct Sees_parameters : std::false_type {};

template <class MetricField, class Jet>
struct Sees_parameters<
  MetricField, Jet, std::void_t<decltype(std::declval<const MetricField&>().tensor(std::declval<const Jet&>(), 0., 0.))>>
  : std::true_type {};

template <class Oracle, class Point_2>
void check_tensor(const Oracle& oracle, const Point_2& uv, const Metric_tensor_2& m)
{
  constexpr double largest = 1e150; // its square is a `double`
  const double size = std::fabs(m.e()) + std::fabs(m.f()) + std::fabs(m.g());
  if(!(size < largest))
    throw Parametric_surface_mesh_error((std::isfinite(size) ? "the metric tensor is too large to compute with at (u,v) = "
                                                             : "the metric tensor is not finite at (u,v) = ")
                                        + describe(place_in_domain(oracle.surface(), uv)));
}

// The tensor of the metric field at the point `uv` of a surface, or of a chart of it, which has this jet there. It is finite;
// it need not be positive definite.
template <class Oracle, class Point_2, class Jet>
Metric_tensor_2 tensor_of_field(const Oracle& oracle, const Point_2& uv, const Jet& jet)
{
  const auto tensor = [&]() -> Metric_tensor_2 {
    if constexpr(Sees_parameters<typename Oracle::Metric_field, Jet>::value) {
      const Point_2 place = place_in_domain(oracle.surface(), uv);
      return oracle.metric().tensor(jet, place.x(), place.y());
    }
    else
      return oracle.metric().tensor(jet);
  };
  const Metric_tensor_2 result = tensor();
  check_tensor(oracle, uv, result);
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_REGULAR_TENSOR_H
