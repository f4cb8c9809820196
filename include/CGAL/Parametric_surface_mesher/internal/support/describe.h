// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_DESCRIBE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_DESCRIBE_H

#include <cstddef>
#include <sstream>
#include <string>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A number for an error message, with the digits that matter.
inline std::string describe(double x)
{
  std::ostringstream text;
  text << x;
  return text.str();
}

// A point of the domain for an error message, with all digits.
template <class Point_2>
std::string describe(const Point_2& p)
{
  std::ostringstream text;
  text.precision(17);
  text << "(" << p.x() << ", " << p.y() << ")";
  return text.str();
}

// A point in space.
template <class Point_3>
std::string describe_place(const Point_3& p)
{
  return "(" + describe(p.x()) + ", " + describe(p.y()) + ", " + describe(p.z()) + ")";
}

// "face 3" for the face with index 2: messages and files count from 1, as CAD programs do, indices of the interface from 0.
inline std::string numbered(const char* what, std::size_t index)
{
  return what + (" " + std::to_string(index + 1));
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_DESCRIBE_H
