// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_WRITE_MESH_PICTURE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_WRITE_MESH_PICTURE_H

/*!
\file write_mesh_picture.h

Pictures of triangle meshes as SVG files, for the example programs and the benchmark:
- `write_surface_picture()` shows a mesh in space,
- `write_domain_picture()` shows its triangulation in the parameter domain.

Both take plain arrays or a `CGAL::Surface_mesh`, and a file name or a stream. Meshes of more than
`mesh_picture::max_triangles_with_edges` triangles are drawn without inner edges, so that the file stays usable.
*/

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <limits>
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// How `write_surface_picture()` draws.
struct Surface_picture_options
{
  std::string title;                ///< the beginning of the caption
  std::optional<double> azimuth;    ///< degrees from the x axis to the viewer; by default beside the front side
  std::optional<double> elevation;  ///< degrees of the viewer above the xy plane; by default 25 to 45 above or below
  bool is_colored_by_angle = false; ///< colours each face by its smallest angle, from red over yellow to blue
};

/// An ellipse in the parameter domain.
struct Domain_ellipse
{
  std::array<double, 2> center;
  double a, b;  ///< the half axes, as lengths in the domain
  double alpha; ///< the angle of the axis `a` to the `u` axis, in radians
};

/// How `write_domain_picture()` draws.
struct Domain_picture_options
{
  std::string title;                    ///< the beginning of the caption
  std::vector<Domain_ellipse> ellipses; ///< drawn over the triangulation
};

namespace mesh_picture {

typedef std::array<double, 2> Point_2;
typedef std::array<double, 3> Point_3;
typedef std::array<std::size_t, 3> Triangle;

const std::size_t max_triangles_with_edges = 30000;
const double width = 1000, margin = 28, caption_height = 44; // pixels
const double pi = 3.14159265358979323846;

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

template <std::size_t dimension>
void check_input(const std::vector<std::array<double, dimension>>& points, const std::vector<Triangle>& triangles)
{
  for(const auto& p : points)
    for(const double x : p)
      if(!std::isfinite(x))
        throw std::invalid_argument("a mesh picture needs finite coordinates");
  for(const Triangle& t : triangles)
    if(*std::max_element(t.begin(), t.end()) >= points.size())
      throw std::invalid_argument("a mesh picture needs triangles of existing points");
}

// For each triangle a bit `1 << i` for each border edge from its point `i` to the next.
inline std::vector<int> border_edges(const std::vector<Triangle>& triangles)
{
  struct Use
  {
    std::pair<std::size_t, std::size_t> ends;
    std::size_t triangle;
    int bit;
  };
  std::vector<Use> uses;
  for(std::size_t t = 0; t < triangles.size(); ++t)
    for(int i = 0; i < 3; ++i)
      uses.push_back({std::minmax({triangles[t][i], triangles[t][(i + 1) % 3]}), t, 1 << i});
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) { return a.ends < b.ends; });

  std::vector<int> bits(triangles.size(), 0);
  for(std::size_t i = 0; i < uses.size(); ++i)
    if((i == 0 || uses[i - 1].ends != uses[i].ends) && (i + 1 == uses.size() || uses[i + 1].ends != uses[i].ends))
      bits[uses[i].triangle] |= uses[i].bit;
  return bits;
}

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
        size[i] = std::max((*range.second)[i] - m_low[i], std::numeric_limits<double>::min());
      }
    const double inner_width = width - 2 * margin, inner_height = max_height - 2 * margin - caption_height;
    const double scale = std::min(inner_width / size[0], inner_height / (size[1] * scale_ratio));
    m_scale = {scale, scale * scale_ratio};
    m_left = (width - size[0] * m_scale[0]) / 2;
    m_bottom = caption_height + margin + size[1] * m_scale[1];
    m_height = m_bottom + margin;
  }

  Point_2 image(const Point_2& p) const
  {
    return {m_left + (p[0] - m_low[0]) * m_scale[0], m_bottom - (p[1] - m_low[1]) * m_scale[1]};
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

struct Color
{
  double red, green, blue; // 0 to 255
};

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

// Writes SVG elements with two decimals of a pixel.
class Svg_writer
{
  std::ostream& m_out;

public:
  Svg_writer(std::ostream& out, double height) : m_out(out)
  {
    m_out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << number(width) << "\" height=\"" << number(height)
          << "\" viewBox=\"0 0 " << number(width) << " " << number(height) << "\" stroke-linejoin=\"round\" "
          << "stroke-linecap=\"round\" font-family=\"DejaVu Sans,Helvetica,Arial,sans-serif\">\n"
          << "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  }

  ~Svg_writer() { m_out << "</svg>\n"; }

  Svg_writer(const Svg_writer&) = delete;
  Svg_writer& operator=(const Svg_writer&) = delete;

  void begin_group(const std::string& attributes) { m_out << "<g " << attributes << ">\n"; }
  void end_group() { m_out << "</g>\n"; }

  // The inherited fill or stroke is set to "currentColor" to have `color`.
  void polygon(const Point_2* first, const Point_2* last, const Color* color = nullptr)
  {
    m_out << "<path " << (color ? "color=\"" + hexadecimal(*color) + "\" " : "") << "d=\"";
    for(const Point_2* p = first; p != last; ++p)
      m_out << (p == first ? "M" : "L") << number((*p)[0]) << " " << number((*p)[1]);
    m_out << "Z\"/>\n";
  }

  void segment(const Point_2& p, const Point_2& q, const std::string& attributes = std::string())
  {
    m_out << "<path " << attributes << (attributes.empty() ? "" : " ") << "d=\"M" << number(p[0]) << " " << number(p[1])
          << "L" << number(q[0]) << " " << number(q[1]) << "\"/>\n";
  }

  void disk(const Point_2& center, double radius)
  {
    m_out << "<circle cx=\"" << number(center[0]) << "\" cy=\"" << number(center[1]) << "\" r=\"" << number(radius)
          << "\"/>\n";
  }

  void rectangle(const Point_2& corner, double w, double h, const Color& color)
  {
    m_out << "<rect x=\"" << number(corner[0]) << "\" y=\"" << number(corner[1]) << "\" width=\"" << number(w)
          << "\" height=\"" << number(h) << "\" fill=\"" << hexadecimal(color) << "\"/>\n";
  }

  void text(const Point_2& p, double size, const std::string& anchor, const std::string& what)
  {
    m_out << "<text x=\"" << number(p[0]) << "\" y=\"" << number(p[1]) << "\" font-size=\"" << number(size)
          << "\" text-anchor=\"" << anchor << "\" fill=\"#333333\">" << escaped(what) << "</text>\n";
  }

  // At most two decimals, without trailing zeros.
  static std::string number(double x)
  {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.2f", x);
    std::string digits(buffer);
    digits.erase(digits.find_last_not_of('0') + 1);
    if(digits.back() == '.')
      digits.pop_back();
    return digits == "-0" ? "0" : digits;
  }

private:
  static std::string hexadecimal(const Color& color)
  {
    char buffer[8];
    const auto byte = [](double x) { return static_cast<unsigned int>(std::min(std::max(x, 0.), 255.) + 0.5) & 0xffu; };
    std::snprintf(buffer, sizeof buffer, "#%02x%02x%02x", byte(color.red), byte(color.green), byte(color.blue));
    return buffer;
  }

  static std::string escaped(const std::string& what)
  {
    std::string result;
    for(const char c : what)
      result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
    return result;
  }
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

// `title · part · part`
inline std::string caption(const std::string& title, const std::vector<std::string>& parts)
{
  std::string result = title;
  for(const std::string& part : parts)
    result += (result.empty() ? "" : " \xc2\xb7 ") + part;
  return result;
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
    Svg_writer svg(out, m_height);
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
        write_triangle(svg, t);
    }
    svg.end_group();
  }

private:
  std::vector<Item> items_back_to_front() const
  {
    std::vector<Item> items;
    const std::vector<int> border = border_edges(m_triangles);
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

  void write_triangle(Svg_writer& svg, const Triangle& t) const
  {
    static const Color front{160, 196, 230}, back{240, 205, 160};
    const Point_3 &p = m_points[t[0]], &q = m_points[t[1]], &r = m_points[t[2]];
    const Point_3 n = normalized(normal(p, q, r));
    const bool is_front = dot(n, m_view.to_viewer) >= 0;
    const double side = is_front ? 1 : -1;
    // the light stands at the viewer's upper left
    const Point_3 light = normalized({-0.45, 0.6, 0.66});
    const double lit = side * (light[0] * dot(n, m_view.right) + light[1] * dot(n, m_view.up)
                               + light[2] * dot(n, m_view.to_viewer));
    Color color = is_front ? front : back;
    if(m_options.is_colored_by_angle)
      color = is_front ? color_of_angle(min_angle(p, q, r)) : mixed(color_of_angle(min_angle(p, q, r)), back, 0.4);
    color = shaded(color, 0.5 + 0.5 * lit);
    const std::array<Point_2, 3> corners{{m_images[t[0]], m_images[t[1]], m_images[t[2]]}};
    svg.polygon(corners.data(), corners.data() + 3, &color);
  }

  void write_caption(Svg_writer& svg) const
  {
    double smallest = m_triangles.empty() ? 0 : 60;
    for(const Triangle& t : m_triangles)
      smallest = std::min(smallest, min_angle(m_points[t[0]], m_points[t[1]], m_points[t[2]]));
    svg.text({margin, 32}, 17, "start",
             caption(m_options.title, {std::to_string(m_points.size()) + " vertices",
                                       std::to_string(m_triangles.size()) + " triangles",
                                       "smallest angle " + compact(smallest) + "\xc2\xb0"}));
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

// Draws a triangulation of the parameter domain.
class Domain_painter
{
  const std::vector<Triangle>& m_triangles;
  const Domain_picture_options& m_options;
  Point_2 m_low{0, 0}, m_high{0, 0};
  double m_scale_ratio = 1; // of v to u
  std::vector<Point_2> m_images;
  std::vector<std::vector<Point_2>> m_ellipses; // as polygons, each behind its centre
  double m_height;

public:
  Domain_painter(const std::vector<Point_2>& points, const std::vector<Triangle>& triangles,
                 const Domain_picture_options& options)
    : m_triangles(triangles), m_options(options)
  {
    find_range(points);
    std::vector<Point_2> shown = points; // the ellipses may reach out of the domain
    for(const Domain_ellipse& e : options.ellipses)
    {
      m_ellipses.push_back(polygon_of(e));
      shown.insert(shown.end(), m_ellipses.back().begin(), m_ellipses.back().end());
    }
    const Viewport viewport(shown, width, m_scale_ratio);
    m_images = viewport.images(points);
    for(std::vector<Point_2>& ellipse : m_ellipses)
      ellipse = viewport.images(ellipse);
    m_height = viewport.height();
  }

  void write(std::ostream& out) const
  {
    Svg_writer svg(out, m_height);
    write_caption(svg);
    const bool has_edges = m_triangles.size() <= max_triangles_with_edges;
    const double line = edge_width(m_images, m_triangles);
    svg.begin_group("fill=\"#e6eff8\" stroke=\"" + std::string(has_edges ? "#3d5a78" : "#e6eff8")
                    + "\" stroke-width=\"" + Svg_writer::number(has_edges ? line : 0.4) + "\"");
    for(const Triangle& t : m_triangles)
    {
      const std::array<Point_2, 3> corners{{m_images[t[0]], m_images[t[1]], m_images[t[2]]}};
      svg.polygon(corners.data(), corners.data() + 3);
    }
    svg.end_group();
    write_border(svg, std::max(1.6, 2.5 * line));
    write_ellipses(svg);
  }

private:
  void find_range(const std::vector<Point_2>& points)
  {
    if(points.empty())
      return;
    m_low = m_high = points.front();
    for(const Point_2& p : points)
      for(int i = 0; i < 2; ++i)
      {
        m_low[i] = std::min(m_low[i], p[i]);
        m_high[i] = std::max(m_high[i], p[i]);
      }
    // a domain of more than four times its width is drawn two to one
    const double ratio = (m_high[1] - m_low[1]) / (m_high[0] - m_low[0]);
    if(std::isfinite(ratio) && ratio > 0 && (ratio > 4 || ratio < 0.25))
      m_scale_ratio = (ratio > 1 ? 2 : 0.5) / ratio;
  }

  static std::vector<Point_2> polygon_of(const Domain_ellipse& e)
  {
    const int corners = 96;
    std::vector<Point_2> result{e.center};
    for(int i = 0; i < corners; ++i)
    {
      const double x = e.a * std::cos(2 * pi * i / corners), y = e.b * std::sin(2 * pi * i / corners);
      result.push_back({e.center[0] + x * std::cos(e.alpha) - y * std::sin(e.alpha),
                        e.center[1] + x * std::sin(e.alpha) + y * std::cos(e.alpha)});
    }
    return result;
  }

  void write_border(Svg_writer& svg, double line) const
  {
    const std::vector<int> border = border_edges(m_triangles);
    svg.begin_group("fill=\"none\" stroke=\"#1c2733\" stroke-width=\"" + Svg_writer::number(line) + "\"");
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
      for(int i = 0; i < 3; ++i)
        if(border[t] & (1 << i))
          svg.segment(m_images[m_triangles[t][i]], m_images[m_triangles[t][(i + 1) % 3]]);
    svg.end_group();
  }

  void write_ellipses(Svg_writer& svg) const
  {
    if(m_ellipses.empty())
      return;
    svg.begin_group("fill=\"#d1495b\" fill-opacity=\"0.07\" stroke=\"#d1495b\" stroke-width=\"1.2\"");
    for(const std::vector<Point_2>& ellipse : m_ellipses)
      svg.polygon(ellipse.data() + 1, ellipse.data() + ellipse.size());
    svg.end_group();
    svg.begin_group("fill=\"#d1495b\"");
    for(const std::vector<Point_2>& ellipse : m_ellipses)
      svg.disk(ellipse.front(), 1.8);
    svg.end_group();
  }

  void write_caption(Svg_writer& svg) const
  {
    std::vector<std::string> parts{std::to_string(m_triangles.size()) + " triangles",
                                   "u " + compact(m_low[0]) + " to " + compact(m_high[0]),
                                   "v " + compact(m_low[1]) + " to " + compact(m_high[1])};
    if(m_scale_ratio != 1)
      parts.push_back(m_scale_ratio > 1 ? "v drawn " + compact(m_scale_ratio) + " times larger than u"
                                        : "u drawn " + compact(1 / m_scale_ratio) + " times larger than v");
    svg.text({margin, 32}, 17, "start", caption(m_options.title, parts));
  }
};

// Calls `write` with the stream of a new file.
template <class Write>
void write_file(const std::string& file_name, const Write& write)
{
  std::ofstream out(file_name);
  if(out)
    write(out);
  out.close();
  if(!out)
    throw std::runtime_error("cannot write " + file_name);
}

// The points, or other values for the vertices, and triangles of a mesh, without what is marked as removed.
template <std::size_t dimension, class Point, class Vertex_map>
std::pair<std::vector<std::array<double, dimension>>, std::vector<Triangle>>
arrays(const CGAL::Surface_mesh<Point>& mesh, const Vertex_map& coordinates)
{
  std::pair<std::vector<std::array<double, dimension>>, std::vector<Triangle>> result;
  std::vector<std::size_t> position(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  for(const auto v : mesh.vertices())
  {
    position[std::size_t(v)] = result.first.size();
    std::array<double, dimension> p;
    for(std::size_t i = 0; i < dimension; ++i)
      p[i] = coordinates(v)[static_cast<int>(i)];
    result.first.push_back(p);
  }
  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    result.second.push_back({{position[std::size_t(mesh.source(h))], position[std::size_t(mesh.target(h))],
                              position[std::size_t(mesh.target(mesh.next(h)))]}});
  }
  return result;
}

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

/*!
writes a picture of a triangulation of the parameter domain to `out`, with strong border edges and with
the ellipses of `options` over it. A domain of more than four times its width is drawn with two scales, which the
caption tells.
\throws std::invalid_argument if a parameter is not finite or a triangle has an index out of range
*/
inline void write_domain_picture(std::ostream& out, const std::vector<std::array<double, 2>>& parameters,
                                 const std::vector<std::array<std::size_t, 3>>& triangles,
                                 const Domain_picture_options& options = {})
{
  mesh_picture::check_input(parameters, triangles);
  mesh_picture::Domain_painter(parameters, triangles, options).write(out);
}

/// writes the picture to a file. \throws std::runtime_error with its name if that fails
inline void write_domain_picture(const std::string& file_name, const std::vector<std::array<double, 2>>& parameters,
                                 const std::vector<std::array<std::size_t, 3>>& triangles,
                                 const Domain_picture_options& options = {})
{
  mesh_picture::write_file(file_name, [&](std::ostream& out)
                           { write_domain_picture(out, parameters, triangles, options); });
}

/// writes the picture of a triangle mesh to a file; `uv_map` maps its vertices to points `(u,v)`.
template <class Point, class ParameterMap>
void write_domain_picture(const std::string& file_name, const CGAL::Surface_mesh<Point>& mesh,
                          const ParameterMap& uv_map, const Domain_picture_options& options = {})
{
  const auto arrays = mesh_picture::arrays<2>(mesh, [&](auto v) { return get(uv_map, v); });
  write_domain_picture(file_name, arrays.first, arrays.second, options);
}

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_WRITE_MESH_PICTURE_H
