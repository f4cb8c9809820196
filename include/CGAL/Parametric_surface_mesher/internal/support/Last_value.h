// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_LAST_VALUE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_LAST_VALUE_H

#include <limits>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Remembers the value of a costly function at the last point at which it was evaluated.
template <class Point_2, class Value>
class Last_value
{
  Point_2 m_point = Point_2(std::numeric_limits<double>::quiet_NaN(), 0); // not equal to any point
  Value m_value;

public:
  template <class Function>
  const Value& operator()(const Point_2& p, const Function& function)
  {
    if(!(m_point == p)) {
      m_value = function(p);
      m_point = p;
    }
    return m_value;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_LAST_VALUE_H
