// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_CHECKED_METRIC_FIELD_2_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_CHECKED_METRIC_FIELD_2_H

#include <CGAL/First_fundamental_form_metric_2.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <limits>
#include <string>
#include <utility>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A user's metric field, whose lengths are refused where they cannot be compared. Tensors are looked at where they are asked
// for: see `regular_tensor()`.
template <class MetricField>
class Checked_metric_field_2
{
  MetricField m_field;

public:
  explicit Checked_metric_field_2(const MetricField& field) : m_field(field) {}

  // by the jet alone, or by the jet and (u,v), as the field has it
  template <class Jet, class... Parameters>
  auto tensor(const Jet& jet, Parameters... uv) const -> decltype(std::declval<const MetricField&>().tensor(jet, uv...))
  {
    return m_field.tensor(jet, uv...);
  }

  template <class Point>
  double squared_length(const Point& p, const Point& q) const
  {
    const double result = m_field.squared_length(p, q);
    if(!(result >= 0 && result <= (std::numeric_limits<double>::max)()))
      throw Parametric_surface_mesh_error("the squared length of the edge from " + describe(p.surface_point()) + " to "
                                          + describe(q.surface_point())
                                          + " by the metric field must be at least 0 and finite, and is " + describe(result));
    return result;
  }

private:
  template <class Point_3>
  static std::string describe(const Point_3& p)
  {
    return "(" + internal::describe(p.x()) + ", " + internal::describe(p.y()) + ", " + internal::describe(p.z()) + ")";
  }

  static std::string describe(double x) { return internal::describe(x); }
};

template <class MetricField>
Checked_metric_field_2<MetricField> checked_metric_field(const MetricField& field)
{
  return Checked_metric_field_2<MetricField>(field);
}

// Its lengths are distances of points that have been checked.
template <class Kernel>
First_fundamental_form_metric_2<Kernel> checked_metric_field(const First_fundamental_form_metric_2<Kernel>& field)
{
  return field;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_CHECKED_METRIC_FIELD_2_H
