// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_CHECK_VALUE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_CHECK_VALUE_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <cmath>
#include <string>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

[[noreturn]] inline void throw_out_of_range(const std::string& name, const std::string& range, double value)
{
  throw Parametric_surface_mesh_error("the " + name + " must be " + range + ", and is " + describe(value));
}

// Values that a user sets. `name`: without the article. A value that is not a number is in no range.

inline void check_positive(const char* name, double value)
{
  if(!(value > 0))
    throw_out_of_range(name, "positive", value);
}

inline void check_positive_and_finite(const char* name, double value)
{
  if(!(value > 0 && std::isfinite(value)))
    throw_out_of_range(name, "positive and finite", value);
}

inline void check_not_negative(const char* name, double value)
{
  if(!(value >= 0))
    throw_out_of_range(name, "at least 0", value);
}

inline void check_not_negative_and_finite(const char* name, double value)
{
  if(!(value >= 0 && std::isfinite(value)))
    throw_out_of_range(name, "at least 0 and finite", value);
}

// No triangle has a smallest angle above 60 degrees.
inline void check_smallest_angle(const char* name, double degrees)
{
  if(!(degrees >= 0 && degrees < 60))
    throw_out_of_range(name, "at least 0 and below 60 degrees", degrees);
}

// the parameters of a curve
inline void check_range_of_curve(double begin, double end)
{
  if(!std::isfinite(begin) || !std::isfinite(end) || begin == end)
    throw Parametric_surface_mesh_error("the parameters of a curve must be finite and differ, and are " + describe(begin)
                                        + " and " + describe(end));
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_CHECK_VALUE_H
