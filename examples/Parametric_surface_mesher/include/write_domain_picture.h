// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_WRITE_DOMAIN_PICTURE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_WRITE_DOMAIN_PICTURE_H

/*!
\file write_domain_picture.h

`write_domain_picture()` draws the triangulation of a mesh in the parameter domain as an SVG file, for the example
programs and the benchmark. It takes plain arrays or a `CGAL::Surface_mesh`, and a file name or a stream. Meshes of
more than `mesh_picture::max_triangles_with_edges` triangles are drawn without inner edges, so that the file stays
usable.
*/

#include "Picture_layout.h"
#include "Picture_triangles.h"
#include "Svg_writer.h"

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

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
  bool is_range_shown = true;           ///< whether the caption gives the ranges of `u` and `v`
};

namespace mesh_picture {

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
    Svg_writer svg(out, width, m_height);
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

  // 0 stands for what rounding errors make of it
  std::string bound(const Point_2& corner, int i) const
  {
    return compact(std::abs(corner[i]) < 1e-9 * (m_high[i] - m_low[i]) ? 0 : corner[i]);
  }

  void write_caption(Svg_writer& svg) const
  {
    std::vector<std::string> parts{std::to_string(m_triangles.size()) + " triangles"};
    if(m_options.is_range_shown) {
      parts.push_back("u " + bound(m_low, 0) + " to " + bound(m_high, 0));
      parts.push_back("v " + bound(m_low, 1) + " to " + bound(m_high, 1));
    }
    if(m_scale_ratio != 1)
      parts.push_back(m_scale_ratio > 1 ? "v drawn " + compact(m_scale_ratio) + " times larger than u"
                                        : "u drawn " + compact(1 / m_scale_ratio) + " times larger than v");
    write_caption_line(svg, m_options.title, parts, width - 2 * margin);
  }
};

} // namespace mesh_picture

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

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_WRITE_DOMAIN_PICTURE_H
