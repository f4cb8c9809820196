// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers in the sentences of the programs.
#ifndef TEXT_OF_NUMBERS_H
#define TEXT_OF_NUMBERS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

namespace mesh_patch {

// A number with so many digits, or more if the part before the point has more: there is no exponent but for very small and very large ones.
inline std::string text_of(double x, int digits = 4)
{
  const int most_digits = 15;
  const int before_point = std::abs(x) >= 1 && std::isfinite(x) ? int(std::log10(std::abs(x))) + 1 : 0;
  std::ostringstream text;
  text.precision((std::max)(digits, (std::min)(before_point, most_digits)));
  text << x;
  return text.str();
}

// A point, as "(1, 2.5, 0)".
inline std::string text_of(const std::array<double, 3>& p)
{
  return "(" + text_of(p[0]) + ", " + text_of(p[1]) + ", " + text_of(p[2]) + ")";
}

// The lengths of the sides of a box.
inline std::string text_of_size(const std::array<double, 3>& sides)
{
  const int digits = 3; // a mesh is a little smaller than its shape
  return text_of(sides[0], digits) + " x " + text_of(sides[1], digits) + " x " + text_of(sides[2], digits);
}

// Lengths with their unit.
struct Text_of_length
{
  std::string unit;      // as "mm"; empty if it is not known
  double negligible = 0; // shorter ones are written as 0: they are rounding

  std::string operator()(double length) const
  {
    return text_of(std::abs(length) < negligible ? 0. : length) + (unit.empty() ? "" : " " + unit);
  }
};

} // namespace mesh_patch

#endif // TEXT_OF_NUMBERS_H
