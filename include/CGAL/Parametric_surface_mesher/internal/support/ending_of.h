// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_ENDING_OF_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_ENDING_OF_H

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The part of a file name after its last dot, in small letters.
inline std::string ending_of(const std::string& file_name)
{
  const std::size_t dot = file_name.find_last_of("./");
  std::string result = dot == std::string::npos || file_name[dot] == '/' ? "" : file_name.substr(dot + 1);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_ENDING_OF_H
