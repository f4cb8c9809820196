// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_PICTURE_LAYOUT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_PICTURE_LAYOUT_H

/*!
\file Picture_layout.h

Where things are in a picture of a mesh: its frame, the caption and the scale.
*/

#include "Picture_triangles.h"
#include "Svg_writer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace mesh_picture {

const std::size_t max_triangles_with_edges = 50000;
const double width = 1000, margin = 28, caption_height = 44; // pixels
const double pi = 3.14159265358979323846;

// A box of the plane and its image: the `y` axis of the picture points down.
class Viewport
{
  Point_2 m_low, m_scale;
  double m_left, m_bottom, m_height;

public:
  // shows the points in a picture of `width`; the scales of x and y are `scale_ratio` apart
  Viewport(const std::vector<Point_2>& points, double max_height, double scale_ratio = 1)
    : m_low{0, 0}
  {
    Point_2 size{1, 1};
    if(!points.empty())
      for(int i = 0; i < 2; ++i)
      {
        const auto less = [i](const Point_2& p, const Point_2& q) { return p[i] < q[i]; };
        const auto range = std::minmax_element(points.begin(), points.end(), less);
        m_low[i] = (*range.first)[i];
        size[i] = std::max((*range.second)[i] - m_low[i], 1e-300); // for a single point
      }
    const double inner_width = width - 2 * margin, inner_height = max_height - 2 * margin - caption_height;
    const double scale = std::min(inner_width / size[0], inner_height / (size[1] * scale_ratio));
    m_scale = {scale, scale * scale_ratio};
    m_left = (width - size[0] * m_scale[0]) / 2;
    m_bottom = caption_height + margin + size[1] * m_scale[1];
    m_height = m_bottom + margin;
  }

  // rounded to what is written, so that differences of images are written without a further error
  Point_2 image(const Point_2& p) const
  {
    return {std::round(100 * (m_left + (p[0] - m_low[0]) * m_scale[0])) / 100,
            std::round(100 * (m_bottom - (p[1] - m_low[1]) * m_scale[1])) / 100};
  }

  std::vector<Point_2> images(const std::vector<Point_2>& points) const
  {
    std::vector<Point_2> result;
    for(const Point_2& p : points)
      result.push_back(image(p));
    return result;
  }

  double height() const { return m_height; }
};

// The width in pixels of lines between triangles of this many square pixels in all.
inline double edge_width(const std::vector<Point_2>& images, const std::vector<Triangle>& triangles)
{
  double area = 0;
  for(const Triangle& t : triangles)
  {
    const Point_2 &p = images[t[0]], &q = images[t[1]], &r = images[t[2]];
    area += std::abs((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
  }
  const double typical_length = std::sqrt(area / std::max<std::size_t>(triangles.size(), 1));
  return std::min(std::max(0.04 * typical_length, 0.1), 0.9);
}

inline std::string compact(double x)
{
  std::ostringstream out;
  out.precision(3);
  out << x;
  return out.str();
}

// Writes the line `title · part · part`, in smaller letters if it is long.
inline void write_caption_line(Svg_writer& svg, const std::string& title, const std::vector<std::string>& parts,
                               double max_width)
{
  std::string line = title;
  for(const std::string& part : parts)
    line += (line.empty() ? "" : " \xc2\xb7 ") + part;
  const double size = std::min(17., max_width / (0.6 * line.size())); // a letter is 0.6 times as wide as high
  svg.text({margin, 32}, size, "start", line);
}

} // namespace mesh_picture

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_PICTURE_LAYOUT_H
