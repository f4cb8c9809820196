// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sizing field in space: edge lengths in spheres, that grow with the distance from them.
#ifndef SIZE_SPHERES_H
#define SIZE_SPHERES_H

#include "Usage_error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

struct Size_sphere
{
  double x, y, z, radius, length;
};

class Size_spheres
{
  static constexpr double growth = 0.2; // of the length per distance, outside

  std::vector<Size_sphere> m_spheres;

public:
  bool is_empty() const { return m_spheres.empty(); }

  double smallest_length() const
  {
    double result = std::numeric_limits<double>::infinity();
    for(const Size_sphere& sphere : m_spheres)
      result = (std::min)(result, sphere.length);
    return result;
  }

  void scale(double factor)
  {
    for(Size_sphere& s : m_spheres)
      for(double* length : {&s.x, &s.y, &s.z, &s.radius, &s.length})
        *length *= factor;
  }

  // the wanted edge length at a point
  template <class Point_3>
  double operator()(const Point_3& p) const
  {
    double result = std::numeric_limits<double>::max();
    for(const Size_sphere& s : m_spheres) {
      const double distance = std::sqrt((p.x() - s.x) * (p.x() - s.x) + (p.y() - s.y) * (p.y() - s.y) + (p.z() - s.z) * (p.z() - s.z));
      result = (std::min)(result, s.length + growth * (std::max)(0., distance - s.radius));
    }
    return result;
  }

  // `item` is like "10,0,2.5,3:0.1": centre, radius, a colon and the length
  void add(const std::string& option, const std::string& item)
  {
    std::string words = item;
    const bool has_format = std::count(words.begin(), words.end(), ',') == 3 && std::count(words.begin(), words.end(), ':') == 1
                            && words.find(':') > words.rfind(',') && words.find_first_of(" \t") == std::string::npos;
    std::replace_if(words.begin(), words.end(), [](char c) { return c == ',' || c == ':'; }, ' ');
    std::istringstream in(words);
    Size_sphere s;
    const bool is_read = has_format && bool(in >> s.x >> s.y >> s.z >> s.radius >> s.length) && (in >> std::ws).eof();
    if(!is_read || !(s.radius >= 0) || !(s.length > 0)
       || !std::isfinite(s.x + s.y + s.z + s.radius + s.length))
      throw Usage_error("--" + option + ": '" + item
                        + "' must be X,Y,Z,R:L, with a radius R of at least 0 and a positive length L");
    m_spheres.push_back(s);
  }
};

#endif // SIZE_SPHERES_H
