// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LEAST_SIZING_FIELD_3_H
#define CGAL_LEAST_SIZING_FIELD_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesher/internal/sizing/least_length.h>

#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherSizing

Several sizing fields, of which the least edge length counts at each point.

\cgalModels{ParametricSurfaceSizingField_3}

\tparam Point_3 the type of points

\sa `CGAL::Parametric_surface_model_3::set_sizing_field()`
*/
template <class Point_3>
class Least_sizing_field_3
{
  std::vector<std::function<double(const Point_3&)>> m_fields;

public:
  /// adds a model of `ParametricSurfaceSizingField_3`.
  Least_sizing_field_3& add(std::function<double(const Point_3&)> field)
  {
    m_fields.push_back(std::move(field));
    return *this;
  }

  /// whether there is no field.
  bool is_empty() const { return m_fields.empty(); }

  /// the least of the lengths that the fields ask for at a point; infinity if there is no field, NaN if one of them gives that.
  double operator()(const Point_3& p) const
  {
    double result = std::numeric_limits<double>::infinity();
    for(const auto& field : m_fields)
      result = Parametric_surface_mesher::internal::least_length(result, field(p));
    return result;
  }
};

} // namespace CGAL

#endif // CGAL_LEAST_SIZING_FIELD_3_H
