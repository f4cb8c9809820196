// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_WRITE_PNG_PICTURE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_WRITE_PNG_PICTURE_H

/*!
\file write_png_picture.h

`write_png_picture()` draws a triangle mesh in space as a PNG file, by a z-buffer: what is hidden is hidden exactly.
*/

#include "Offscreen_canvas.h"
#include "write_surface_picture.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace mesh_picture {

const std::size_t width_of_image = 1600; // pixels
const std::size_t samples = 3;           // rows and columns of samples in each pixel

/// the image with a pixel in place of `samples` rows and columns.
inline Image smoothed(const Image& image)
{
  Image result{image.width / samples, image.height / samples, {}};
  result.bytes.reserve(3 * result.width * result.height);
  for(std::size_t y = 0; y < result.height; ++y)
    for(std::size_t x = 0; x < result.width; ++x)
      for(std::size_t c = 0; c < 3; ++c) {
        std::size_t sum = 0;
        for(std::size_t j = 0; j < samples; ++j)
          for(std::size_t i = 0; i < samples; ++i)
            sum += image.bytes[3 * ((samples * y + j) * image.width + samples * x + i) + c];
        result.bytes.push_back(std::uint8_t(sum / (samples * samples)));
      }
  return result;
}

/// the image as a file.
inline std::vector<char> png_of(const Image& image)
{
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  header.format = PNG_FORMAT_RGB;
  header.width = png_uint_32(image.width);
  header.height = png_uint_32(image.height);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::vector<char> result(size);
  if(!png_image_write_to_memory(&header, result.data(), &size, 0, image.bytes.data(), 0, nullptr))
    throw std::runtime_error(std::string("the picture cannot be written: ") + header.message);
  result.resize(size);
  return result;
}

// Normals at the corners of triangles. Each is the mean of those of all triangles of the same face at the point, so that faces look
// smooth and their edges sharp.
inline std::vector<Point_3> corner_normals(const std::vector<Point_3>& points, const std::vector<Triangle>& triangles,
                                           const std::vector<std::size_t>& faces)
{
  std::vector<std::size_t> order(3 * triangles.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  const auto key = [&](std::size_t i) { return std::make_pair(triangles[i / 3][i % 3], faces.empty() ? 0 : faces[i / 3]); };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
  std::vector<Point_3> result(order.size());
  for(std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    Point_3 sum{0, 0, 0};
    for(; end < order.size() && key(order[end]) == key(order[begin]); ++end) {
      const Triangle& t = triangles[order[end] / 3];
      const Point_3 n = normal(points[t[0]], points[t[1]], points[t[2]]);
      for(std::size_t k = 0; k < 3; ++k)
        sum[k] += n[k];
    }
    for(std::size_t i = begin; i < end; ++i)
      result[order[i]] = normalized(sum);
  }
  return result;
}

// Draws a mesh in space into a z-buffer.
class Image_painter
{
  const std::vector<Point_3>& m_points;
  const std::vector<Triangle>& m_triangles;
  const Surface_picture_options& m_options;
  View m_view;
  Point_3 m_low, m_high; // of the mesh, in the directions of the view
  double m_scale;        // pixels to a unit

public:
  Image_painter(const std::vector<Point_3>& points, const std::vector<Triangle>& triangles, const Surface_picture_options& options)
    : m_points(points), m_triangles(triangles), m_options(options), m_view(chosen_view(points, triangles, options))
  {
    m_low.fill((std::numeric_limits<double>::infinity)());
    m_high.fill(-(std::numeric_limits<double>::infinity)());
    for(const Point_3& p : points)
      for(std::size_t i = 0; i < 3; ++i) {
        m_low[i] = (std::min)(m_low[i], coordinate(p, i));
        m_high[i] = (std::max)(m_high[i], coordinate(p, i));
      }
    const double inner = (1 - 2 * margin / width) * double(width_of_image);
    m_scale = inner / (std::max)({m_high[0] - m_low[0], m_high[1] - m_low[1], 1e-300});
  }

  Image image() const
  {
    const double room = 2 * margin / width * double(width_of_image);
    const auto pixels = [&](std::size_t i) { return std::size_t(std::ceil(m_scale * (m_high[i] - m_low[i]) + room)); };
    const std::array<double, 2> size{{double(pixels(0)), double(pixels(1))}};
    Offscreen_canvas canvas(samples * pixels(0), samples * pixels(1));
    std::vector<float> corners;
    corners.reserve(9 * m_triangles.size());
    for(const Triangle& t : m_triangles)
      for(const std::size_t p : t)
        append(m_points[p], size, corners);
    canvas.draw_triangles(corners, colors());
    if(const double line = width_of_edges())
      canvas.draw_edges(corners, float(samples * line), 0.3f);
    std::vector<float> ends;
    for(const auto& l : lines())
      for(const std::size_t p : l)
        append(m_points[p], size, ends);
    canvas.draw_lines(ends, float(1.7 * samples));
    return smoothed(canvas.image());
  }

private:
  double coordinate(const Point_3& p, std::size_t i) const { return dot(i == 0 ? m_view.right : i == 1 ? m_view.up : m_view.to_viewer, p); }

  // In the coordinates of the canvas, which is `size` pixels large.
  void append(const Point_3& p, const std::array<double, 2>& size, std::vector<float>& result) const
  {
    for(std::size_t i = 0; i < 2; ++i)
      result.push_back(float(2 * m_scale * (coordinate(p, i) - 0.5 * (m_low[i] + m_high[i])) / size[i]));
    const double depth = m_high[2] - m_low[2], in_front = 0.98; // a little away from both ends of the z-buffer
    result.push_back(float(depth > 0 ? in_front * (m_low[2] + m_high[2] - 2 * coordinate(p, 2)) / depth : 0));
  }

  // Edges of triangles that are not much larger than pixels would be all that is seen.
  double width_of_edges() const
  {
    double area = 0;
    for(const Triangle& t : m_triangles)
      area += 0.5 * std::abs(dot(normal(m_points[t[0]], m_points[t[1]], m_points[t[2]]), m_view.to_viewer));
    const double length = m_scale * std::sqrt(area / double((std::max)(m_triangles.size(), std::size_t(1))));
    const double least_length = 4; // pixels
    return length < least_length ? 0 : (std::min)(0.08 * length, 1.2);
  }

  // Edges of the model, or else those with one triangle.
  std::vector<std::array<std::size_t, 2>> lines() const
  {
    if(!m_options.lines.empty())
      return m_options.lines;
    std::vector<std::array<std::size_t, 2>> result;
    const std::vector<int> border = border_edges(m_triangles);
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
      for(std::size_t i = 0; i < 3; ++i)
        if(border[t] & (1 << i))
          result.push_back({{m_triangles[t][i], m_triangles[t][(i + 1) % 3]}});
    return result;
  }

  // Two lights beside the viewer, and light from all sides. The back of a triangle has the colour of sand, as in other pictures.
  std::vector<std::uint8_t> colors() const
  {
    const std::vector<Point_3> normals = corner_normals(m_points, m_triangles, m_options.faces);
    std::vector<std::uint8_t> result;
    result.reserve(9 * m_triangles.size());
    for(std::size_t t = 0; t < m_triangles.size(); ++t) {
      const auto& c = m_triangles[t];
      const bool is_front = dot(normal(m_points[c[0]], m_points[c[1]], m_points[c[2]]), m_view.to_viewer) >= 0;
      const Color color = m_options.color_of(t, is_front);
      for(std::size_t i = 0; i < 3; ++i)
        for(const double channel : lit(color, normals[3 * t + i], is_front ? 1 : -1))
          result.push_back(std::uint8_t((std::min)((std::max)(channel, 0.), 255.) + 0.5));
    }
    return result;
  }

  std::array<double, 3> lit(const Color& color, const Point_3& n, double side) const
  {
    const auto amount = [&](const Point_3& light) {
      return (std::max)(0., side * (light[0] * dot(n, m_view.right) + light[1] * dot(n, m_view.up) + light[2] * dot(n, m_view.to_viewer)));
    };
    const double light = 0.46 + 0.5 * amount(normalized({-0.45, 0.6, 0.66})) + 0.12 * amount(normalized({0.7, 0.1, 0.5}));
    const Color result = shaded(color, light);
    return {{result.red, result.green, result.blue}};
  }
};

} // namespace mesh_picture

/*!
writes a picture of a mesh in space as a PNG file: a parallel projection with smooth faces and the edges of the model, by a z-buffer.
\throws std::invalid_argument if a coordinate is not finite or a triangle has an index out of range
\throws std::runtime_error if there is no driver that draws without a window
*/
inline void write_png_picture(std::ostream& out, const std::vector<std::array<double, 3>>& points,
                              const std::vector<std::array<std::size_t, 3>>& triangles, const Surface_picture_options& options = {})
{
  mesh_picture::check_input(points, triangles);
  const std::vector<char> file = mesh_picture::png_of(mesh_picture::Image_painter(points, triangles, options).image());
  out.write(file.data(), std::streamsize(file.size()));
}

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_WRITE_PNG_PICTURE_H
