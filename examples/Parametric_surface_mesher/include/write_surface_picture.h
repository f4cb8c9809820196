// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_WRITE_SURFACE_PICTURE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_WRITE_SURFACE_PICTURE_H

/*!
\file write_surface_picture.h

`write_surface_picture()` draws a triangle mesh in space as an SVG file, for the example programs and the benchmark. It
takes plain arrays or a `CGAL::Surface_mesh`, and a file name or a stream. Meshes of more than
`mesh_picture::max_triangles_with_edges` triangles are drawn without inner edges, so that the file stays usable.
*/

#include "Picture_layout.h"
#include "Picture_triangles.h"
#include "Svg_writer.h"

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <vector>

/// How `write_surface_picture()` draws.
struct Surface_picture_options
{
  std::string title;                ///< the beginning of the caption
  std::optional<double> azimuth;    ///< degrees from the x axis to the viewer; by default beside the front side
  std::optional<double> elevation;  ///< degrees of the viewer above the xy plane; by default 25 to 40 above or below
  bool is_colored_by_angle = false; ///< colours each face by its smallest angle, from red over yellow to blue
  std::vector<std::array<std::size_t, 2>> lines; ///< edges of the model, by their ends, drawn as strong as borders are
  std::vector<std::size_t> faces;                ///< for each triangle the index of the face that it lies on
  std::vector<std::optional<mesh_picture::Color>> face_colors; ///< for each of these its own colour, if it has one

  /// the colour of the front or the back of a triangle, unless it is coloured by its angle.
  mesh_picture::Color color_of(std::size_t triangle, bool is_front) const
  {
    static const mesh_picture::Color front{160, 196, 230}, back{240, 205, 160};
    if(!is_front || triangle >= faces.size() || faces[triangle] >= face_colors.size())
      return is_front ? front : back;
    return face_colors[faces[triangle]].value_or(front);
  }
};

namespace mesh_picture {

typedef std::array<double, 3> Point_3;

inline Point_3 operator-(const Point_3& p, const Point_3& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

inline double dot(const Point_3& p, const Point_3& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

inline Point_3 cross(const Point_3& p, const Point_3& q)
{
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

inline Point_3 normalized(const Point_3& p)
{
  const double length = std::sqrt(dot(p, p));
  return length > 0 ? Point_3{p[0] / length, p[1] / length, p[2] / length} : Point_3{0, 0, 0};
}

inline Point_3 normal(const Point_3& p, const Point_3& q, const Point_3& r) { return cross(q - p, r - p); }

// The smallest angle in degrees.
inline double min_angle(const Point_3& p, const Point_3& q, const Point_3& r)
{
  const Point_3 n = normal(p, q, r);
  const double twice_area = std::sqrt(dot(n, n));
  return std::min({std::atan2(twice_area, dot(q - p, r - p)), std::atan2(twice_area, dot(r - q, p - q)),
                   std::atan2(twice_area, dot(p - r, q - r))}) * 180 / pi;
}

inline Color mixed(const Color& a, const Color& b, double share_of_b)
{
  const double s = share_of_b;
  return {a.red + s * (b.red - a.red), a.green + s * (b.green - a.green), a.blue + s * (b.blue - a.blue)};
}

// `light` from 0 to 1 darkens towards a bluish shadow, never to black.
inline Color shaded(const Color& color, double light)
{
  return mixed({0.36 * color.red, 0.38 * color.green, 0.46 * color.blue}, color, light);
}

// Red, orange, yellow, green, blue for smallest angles of 0, 15, 30, 45, 60 degrees.
inline Color color_of_angle(double degrees)
{
  static const std::array<Color, 5> colors
    = {{{196, 40, 48}, {240, 136, 60}, {250, 220, 120}, {126, 200, 164}, {70, 138, 196}}};
  const double position = std::min(std::max(degrees / 15, 0.), 3.999);
  const std::size_t i = static_cast<std::size_t>(position);
  return mixed(colors[i], colors[i + 1], position - i);
}

// Directions of the picture in space: two unit vectors in its plane, and one towards the viewer.
struct View
{
  Point_3 right, up, to_viewer;

  View(double azimuth, double elevation)
  {
    const double a = azimuth * pi / 180, e = elevation * pi / 180;
    to_viewer = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
    right = {-std::sin(a), std::cos(a), 0};
    up = cross(to_viewer, right);
  }

  Point_2 image(const Point_3& p) const { return {dot(right, p), dot(up, p)}; }
};

// Looks at the front side of the mesh from 30 degrees beside its mean normal, and never level or straight down.
inline View chosen_view(const std::vector<Point_3>& points, const std::vector<Triangle>& triangles,
                        const Surface_picture_options& options)
{
  Point_3 sum{0, 0, 0};
  double twice_area = 0;
  for(const Triangle& t : triangles)
  {
    const Point_3 n = normal(points[t[0]], points[t[1]], points[t[2]]);
    twice_area += std::sqrt(dot(n, n));
    for(int i = 0; i < 3; ++i)
      sum[i] += n[i];
  }
  const double horizontal = std::hypot(sum[0], sum[1]);
  const bool has_horizontal_side = horizontal > 0.1 * twice_area;
  const bool is_seen_from_below = -sum[2] > std::max(horizontal, 0.1 * twice_area);
  const double azimuth = has_horizontal_side ? std::atan2(sum[1], sum[0]) * 180 / pi - 30 : -60;
  const double steepness = std::atan2(std::abs(sum[2]), horizontal) * 180 / pi;
  const double elevation = (is_seen_from_below ? -1 : 1) * std::min(std::max(steepness - 30, 25.), 40.);
  return View(options.azimuth.value_or(azimuth), options.elevation.value_or(elevation));
}

// Draws a mesh in space back to front.
class Surface_painter
{
  // What is painted in one go: the triangle, or one of its border edges.
  struct Item
  {
    double depth; // larger is nearer
    std::size_t triangle;
    int border_edge; // -1 for the triangle itself
  };

  const std::vector<Point_3>& m_points;
  const std::vector<Triangle>& m_triangles;
  const Surface_picture_options& m_options;
  View m_view;
  std::vector<Point_2> m_images;
  double m_height;
  bool m_has_edges;

public:
  Surface_painter(const std::vector<Point_3>& points, const std::vector<Triangle>& triangles,
                  const Surface_picture_options& options)
    : m_points(points), m_triangles(triangles), m_options(options), m_view(chosen_view(points, triangles, options)),
      m_has_edges(triangles.size() <= max_triangles_with_edges)
  {
    for(const Point_3& p : points)
      m_images.push_back(m_view.image(p));
    const Viewport viewport(m_images, width);
    m_images = viewport.images(m_images);
    m_height = viewport.height();
  }

  void write(std::ostream& out) const
  {
    Svg_writer svg(out, width, m_height);
    write_caption(svg);
    const double line = edge_width(m_images, m_triangles);
    const std::string border_line
      = "fill=\"none\" stroke=\"#1c2733\" stroke-width=\"" + Svg_writer::number(std::max(1.3, 2 * line)) + "\"";
    // without edges the stroke has the face's own colour, which closes the gaps of the renderer
    svg.begin_group("fill=\"currentColor\" stroke=\"" + std::string(m_has_edges ? "#26323f" : "currentColor")
                    + "\" stroke-width=\"" + Svg_writer::number(m_has_edges ? line : 0.4) + "\"");
    for(const Item& item : items_back_to_front())
    {
      const Triangle& t = m_triangles[item.triangle];
      if(item.border_edge >= 0)
        svg.segment(m_images[t[item.border_edge]], m_images[t[(item.border_edge + 1) % 3]], border_line);
      else
        write_triangle(svg, item.triangle);
    }
    svg.end_group();
  }

private:
  std::vector<Item> items_back_to_front() const
  {
    std::vector<Item> items;
    std::vector<int> border = border_edges(m_triangles);
    add_lines(border);
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
    {
      std::array<double, 3> depth;
      for(int i = 0; i < 3; ++i)
        depth[i] = dot(m_view.to_viewer, m_points[m_triangles[t][i]]);
      items.push_back({(depth[0] + depth[1] + depth[2]) / 3, t, -1});
      const double nearest = *std::max_element(depth.begin(), depth.end()); // after the triangles beside the edge
      for(int i = 0; i < 3; ++i)
        if(border[t] & (1 << i))
          items.push_back({nearest, t, i});
    }
    std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.depth < b.depth; });
    return items;
  }

  // Of the two triangles beside a line one has it from the smaller index to the larger one.
  void add_lines(std::vector<int>& border) const
  {
    std::set<std::array<std::size_t, 2>> lines;
    for(const auto& line : m_options.lines)
      lines.insert({std::min(line[0], line[1]), std::max(line[0], line[1])});
    for(std::size_t t = 0; !lines.empty() && t < m_triangles.size(); ++t)
      for(int i = 0; i < 3; ++i)
        if(lines.count({m_triangles[t][i], m_triangles[t][(i + 1) % 3]}) > 0)
          border[t] |= 1 << i;
  }

  void write_triangle(Svg_writer& svg, std::size_t triangle) const
  {
    static const Color back{240, 205, 160};
    const Triangle& t = m_triangles[triangle];
    const Point_3 &p = m_points[t[0]], &q = m_points[t[1]], &r = m_points[t[2]];
    const Point_3 n = normalized(normal(p, q, r));
    const bool is_front = dot(n, m_view.to_viewer) >= 0;
    const double side = is_front ? 1 : -1;
    // the light stands at the viewer's upper left
    const Point_3 light = normalized({-0.45, 0.6, 0.66});
    const double lit = side * (light[0] * dot(n, m_view.right) + light[1] * dot(n, m_view.up)
                               + light[2] * dot(n, m_view.to_viewer));
    Color color = m_options.color_of(triangle, is_front);
    if(m_options.is_colored_by_angle)
      color = is_front ? color_of_angle(min_angle(p, q, r)) : mixed(color_of_angle(min_angle(p, q, r)), back, 0.4);
    const double contrast = m_options.is_colored_by_angle ? 0.25 : 0.5; // weak shadows leave the colours readable
    color = shaded(color, 1 - contrast + contrast * lit);
    const std::array<Point_2, 3> corners{{m_images[t[0]], m_images[t[1]], m_images[t[2]]}};
    svg.polygon(corners.data(), corners.data() + 3, &color);
  }

  void write_caption(Svg_writer& svg) const
  {
    double smallest = m_triangles.empty() ? 0 : 60;
    for(const Triangle& t : m_triangles)
      smallest = std::min(smallest, min_angle(m_points[t[0]], m_points[t[1]], m_points[t[2]]));
    const double legend_width = m_options.is_colored_by_angle ? 190 : 0;
    write_caption_line(svg, m_options.title,
                       {std::to_string(m_points.size()) + " vertices",
                        std::to_string(m_triangles.size()) + " triangles",
                        "smallest angle " + compact(smallest) + "\xc2\xb0"},
                       width - 2 * margin - legend_width);
    if(m_options.is_colored_by_angle)
      write_legend(svg);
  }

  // the colours of the smallest angles from 0 to 60 degrees, at the right of the caption
  void write_legend(Svg_writer& svg) const
  {
    const double length = 120, left = width - margin - length - 26;
    for(int i = 0; i < 60; ++i)
      svg.rectangle({left + i * length / 60, 20}, length / 60 + 0.3, 12, color_of_angle(i + 0.5));
    svg.text({left - 6, 31}, 13, "end", "0\xc2\xb0");
    svg.text({left + length + 6, 31}, 13, "start", "60\xc2\xb0");
  }
};

} // namespace mesh_picture

/*!
writes a picture of a mesh in space to `out`: a parallel projection, painted back to front and shaded. Front sides, with
counterclockwise corners, are blue, back sides sand-coloured. Border edges are drawn stronger. The
caption gives the numbers of vertices and triangles and the smallest angle in space.
\throws std::invalid_argument if a coordinate is not finite or a triangle has an index out of range
*/
inline void write_surface_picture(std::ostream& out, const std::vector<std::array<double, 3>>& points,
                                  const std::vector<std::array<std::size_t, 3>>& triangles,
                                  const Surface_picture_options& options = {})
{
  mesh_picture::check_input(points, triangles);
  mesh_picture::Surface_painter(points, triangles, options).write(out);
}

/// writes the picture to a file. \throws std::runtime_error with its name if that fails
inline void write_surface_picture(const std::string& file_name, const std::vector<std::array<double, 3>>& points,
                                  const std::vector<std::array<std::size_t, 3>>& triangles,
                                  const Surface_picture_options& options = {})
{
  mesh_picture::write_file(file_name, [&](std::ostream& out)
                           { write_surface_picture(out, points, triangles, options); });
}

/// writes the picture of a triangle mesh to a file.
template <class Point>
void write_surface_picture(const std::string& file_name, const CGAL::Surface_mesh<Point>& mesh,
                           const Surface_picture_options& options = {})
{
  const auto arrays = mesh_picture::arrays<3>(mesh, [&](auto v) { return mesh.point(v); });
  write_surface_picture(file_name, arrays.first, arrays.second, options);
}

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_WRITE_SURFACE_PICTURE_H
