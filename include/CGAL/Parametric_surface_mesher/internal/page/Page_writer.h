// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PAGE_PAGE_WRITER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PAGE_PAGE_WRITER_H

#include <CGAL/Mesh_page_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Shape_of_triangle.h>
#include <CGAL/Parametric_surface_mesher/internal/page/Page_text.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Throws if arrays have different lengths, or indices are out of range.
inline void check_page(const Mesh_page_3& page)
{
  const auto check = [](bool is_good, const std::string& what) {
    if(!is_good)
      throw Parametric_surface_mesh_error("page of a mesh: " + what);
  };
  const std::size_t n = page.triangles.size();
  check(n > 0, "there is no triangle");
  check(page.triangle_faces.size() == n, "triangle_faces has not one value for each triangle");
  check(page.corner_parameters.empty() || page.corner_parameters.size() == n, "corner_parameters has not one value for each triangle");
  for(const auto& corners : page.corner_parameters)
    for(const auto& uv : corners)
      check(std::isfinite(uv[0]) && std::isfinite(uv[1]), "a parameter of a corner is not finite");
  check(page.metric_tensors.empty() || page.metric_tensors.size() == n, "metric_tensors has not one value for each triangle");
  for(std::size_t t = 0; t < n; ++t) {
    check(page.triangle_faces[t] < page.faces.size(), numbered("triangle", t) + " lies on a face that does not exist");
    for(const std::size_t corner : page.triangles[t])
      check(corner < page.points.size(), numbered("triangle", t) + " has a corner that does not exist");
  }
  for(const auto& point : page.points)
    for(const double coordinate : point)
      check(std::isfinite(coordinate), "a coordinate is not finite");
  for(const auto& face : page.faces)
    check(face.part == Mesh_page_3::none || face.part < page.parts.size(),
          "face " + std::to_string(face.number) + " belongs to a part that does not exist");
  for(const auto& line : page.lines)
    for(const std::size_t end : line.points)
      check(end < page.points.size(), "a line has an end that does not exist");
  for(const auto& values : page.values)
    check(values.values.size() == n, "'" + values.name + "' has not one value for each triangle");
  for(const auto& finding : page.findings) {
    for(const std::size_t t : finding.triangles)
      check(t < n, "'" + finding.text + "' is said of a triangle that does not exist");
    for(const std::size_t f : finding.faces)
      check(f < page.faces.size(), "'" + finding.text + "' is said of a face that does not exist");
    for(const auto& place : finding.places)
      for(const double coordinate : place)
        check(std::isfinite(coordinate), "'" + finding.text + "' is said of a place that is not finite");
  }
}

/*
Writes the mesh of a page as JSON, with its arrays as bytes in base64. A point is a vertex of the page once for each face and each pair
of parameters that it has at corners of triangles, so that each vertex has one normal and one place in one domain.
*/
class Page_writer
{
  static constexpr int bytes_of_coordinate = 3, bytes_of_value = 2;

  struct Vertex
  {
    std::size_t point, face;
    std::array<double, 2> uv;
  };

  const Mesh_page_3& m_page;
  std::ostream& m_out;
  std::vector<Vertex> m_vertices;
  std::vector<std::array<std::size_t, 3>> m_triangles; // of vertices
  // Of each point the vertex that was made last, and of each vertex the one with the same point that was made before it.
  std::vector<std::size_t> m_last_vertices, m_vertices_before;

public:
  Page_writer(const Mesh_page_3& page, std::ostream& out) : m_page(page), m_out(out) { find_vertices(); }

  void write()
  {
    m_out << "{\"title\":" << json_text(m_page.title) << ",\n\"unit\":" << json_text(m_page.unit)
          << ",\n\"closed\":" << (m_page.is_closed ? "true" : "false") << ",\n\"numberOfPoints\":" << m_page.points.size();
    write_list("summary", m_page.summary, [&](const std::string& line) { m_out << json_text(line); });
    write_positions();
    write_triangles();
    if(!m_page.corner_parameters.empty())
      write_parameters();
    if(!m_page.metric_tensors.empty())
      write_tensors();
    write_lines();
    write_list("faces", m_page.faces, [&](const Mesh_page_3::Face& face) { write_face(face); });
    write_list("parts", m_page.parts, [&](const Mesh_page_3::Part& part) {
      m_out << "{\"name\":" << json_text(part.name);
      write_color(part.color);
      m_out << "}";
    });
    write_all_values();
    write_list("findings", m_page.findings, [&](const Mesh_page_3::Finding& finding) { write_finding(finding); });
    m_out << "}";
  }

private:
  void find_vertices()
  {
    m_last_vertices.assign(m_page.points.size(), Mesh_page_3::none);
    m_triangles.resize(m_page.triangles.size());
    for(std::size_t t = 0; t < m_page.triangles.size(); ++t)
      for(std::size_t i = 0; i < 3; ++i) {
        const Vertex vertex{m_page.triangles[t][i], m_page.triangle_faces[t],
                            m_page.corner_parameters.empty() ? std::array<double, 2>{{0, 0}} : m_page.corner_parameters[t][i]};
        m_triangles[t][i] = index_of(vertex);
      }
  }

  std::size_t index_of(const Vertex& vertex)
  {
    std::size_t& last = m_last_vertices[vertex.point];
    for(std::size_t v = last; v != Mesh_page_3::none; v = m_vertices_before[v])
      if(m_vertices[v].face == vertex.face && m_vertices[v].uv == vertex.uv)
        return v;
    m_vertices_before.push_back(last);
    last = m_vertices.size();
    m_vertices.push_back(vertex);
    return last;
  }

  template <class List, class Function>
  void write_list(const char* name, const List& list, const Function& write_item)
  {
    m_out << ",\n\"" << name << "\":[";
    const char* separator = "";
    for(const auto& item : list) {
      m_out << separator;
      write_item(item);
      separator = ",";
    }
    m_out << "]";
  }

  void write_bytes(const char* name, const Page_bytes& bytes)
  {
    m_out << ",\n\"" << name << "\":";
    bytes.write(m_out);
  }

  void write_color(const std::optional<Mesh_page_3::Color>& color)
  {
    if(color)
      m_out << ",\"color\":[" << json_number((*color)[0]) << "," << json_number((*color)[1]) << "," << json_number((*color)[2]) << "]";
  }

  void write_positions()
  {
    Mesh_page_3::Point low, high;
    low.fill((std::numeric_limits<double>::infinity)());
    high.fill(-(std::numeric_limits<double>::infinity)());
    for(const Vertex& vertex : m_vertices)
      for(std::size_t i = 0; i < 3; ++i) {
        low[i] = (std::min)(low[i], m_page.points[vertex.point][i]);
        high[i] = (std::max)(high[i], m_page.points[vertex.point][i]);
      }
    write_list("low", low, [&](double x) { m_out << json_number(x); });
    write_list("high", high, [&](double x) { m_out << json_number(x); });
    Page_bytes bytes;
    bytes.reserve(3 * bytes_of_coordinate * m_vertices.size());
    for(const Vertex& vertex : m_vertices)
      for(std::size_t i = 0; i < 3; ++i)
        bytes.add_share(share(m_page.points[vertex.point][i], low[i], high[i]), bytes_of_coordinate);
    write_bytes("positions", bytes);
  }

  static double share(double value, double low, double high) { return high > low ? (value - low) / (high - low) : 0; }

  void write_triangles()
  {
    Page_bytes corners, faces;
    corners.reserve(6 * m_triangles.size());
    for(std::size_t t = 0; t < m_triangles.size(); ++t) {
      for(const std::size_t corner : m_triangles[t])
        corners.add_difference(corner);
      faces.add_difference(m_page.triangle_faces[t]);
    }
    write_bytes("triangles", corners);
    write_bytes("triangleFaces", faces);
  }

  // Parameters are shares of the box of their face in its domain.
  void write_parameters()
  {
    typedef std::array<double, 4> Box; // both lower ends, both upper ends
    const double infinity = (std::numeric_limits<double>::infinity)();
    std::vector<Box> boxes(m_page.faces.size(), Box{{infinity, infinity, -infinity, -infinity}});
    for(const Vertex& vertex : m_vertices)
      for(std::size_t i = 0; i < 2; ++i) {
        boxes[vertex.face][i] = (std::min)(boxes[vertex.face][i], vertex.uv[i]);
        boxes[vertex.face][2 + i] = (std::max)(boxes[vertex.face][2 + i], vertex.uv[i]);
      }
    write_list("domains", boxes, [&](const Box& box) {
      m_out << "[" << json_number(box[0]) << "," << json_number(box[1]) << "," << json_number(box[2]) << "," << json_number(box[3]) << "]";
    });
    Page_bytes bytes;
    bytes.reserve(2 * bytes_of_coordinate * m_vertices.size());
    for(const Vertex& vertex : m_vertices)
      for(std::size_t i = 0; i < 2; ++i)
        bytes.add_share(share(vertex.uv[i], boxes[vertex.face][i], boxes[vertex.face][2 + i]), bytes_of_coordinate);
    write_bytes("parameters", bytes);
  }

  // A circumellipse depends on its tensor up to a factor: on log(E / G), and on F / sqrt(E G), which is between -1 and 1.
  void write_tensors()
  {
    std::vector<double> stretches, skews;
    for(const auto& tensor : m_page.metric_tensors) {
      stretches.push_back(std::log(tensor[0] / tensor[2]));
      skews.push_back(std::atanh(tensor[1] / std::sqrt(tensor[0] * tensor[2])));
    }
    m_out << ",\n\"tensorStretches\":";
    write_values(stretches, false);
    m_out << ",\n\"tensorSkews\":";
    write_values(skews, false);
  }

  void write_lines()
  {
    Page_bytes ends, numbers;
    for(const Mesh_page_3::Line& line : m_page.lines) {
      const std::size_t a = m_last_vertices[line.points[0]], b = m_last_vertices[line.points[1]];
      if(a == Mesh_page_3::none || b == Mesh_page_3::none)
        continue;
      ends.add_difference(a);
      ends.add_difference(b);
      numbers.add_difference(line.number);
    }
    write_bytes("lines", ends);
    write_bytes("lineNumbers", numbers);
  }

  void write_face(const Mesh_page_3::Face& face)
  {
    m_out << "{\"number\":" << face.number;
    if(!face.name.empty())
      m_out << ",\"name\":" << json_text(face.name);
    if(face.part != Mesh_page_3::none)
      m_out << ",\"part\":" << face.part;
    write_color(face.color);
    m_out << "}";
  }

  void write_values(const std::vector<double>& values, bool is_logarithmic)
  {
    const Rounded_values rounded(values, is_logarithmic);
    Page_bytes bytes;
    bytes.reserve(bytes_of_value * values.size());
    for(const double value : values)
      bytes.add(rounded(value), bytes_of_value);
    m_out << "{";
    rounded.write_range(m_out);
    m_out << ",\"data\":";
    bytes.write(m_out);
    m_out << "}";
  }

  // Angles and ratios of radii are those of the exact points, not of the rounded ones.
  void write_all_values()
  {
    typedef Simple_cartesian<double> Kernel;
    const auto point = [&](std::size_t p) { return Kernel::Point_3(m_page.points[p][0], m_page.points[p][1], m_page.points[p][2]); };
    std::vector<double> angles, ratios;
    for(const auto& t : m_page.triangles) {
      const Shape_of_triangle shape = shape_of_triangle(point(t[0]), point(t[1]), point(t[2]), Kernel());
      angles.push_back(shape.min_angle);
      ratios.push_back(shape.radius_ratio);
    }
    m_out << ",\n\"angles\":";
    write_values(angles, false);
    m_out << ",\n\"ratios\":";
    write_values(ratios, false);
    write_list("values", m_page.values, [&](const Mesh_page_3::Values& values) {
      const char* const dimension = values.dimension == Mesh_page_3::Dimension::LENGTH              ? "length"
                                    : values.dimension == Mesh_page_3::Dimension::RECIPROCAL_LENGTH ? "reciprocal"
                                                                                                     : "number";
      const bool is_positive = std::none_of(values.values.begin(), values.values.end(), [](double value) { return value < 0; });
      m_out << "{\"name\":" << json_text(values.name) << ",\"dimension\":\"" << dimension << "\",\"range\":";
      write_values(values.values, is_positive && values.dimension != Mesh_page_3::Dimension::NUMBER);
      m_out << "}";
    });
  }

  void write_finding(const Mesh_page_3::Finding& finding)
  {
    m_out << "{\"kind\":" << json_text(finding.kind) << ",\"text\":" << json_text(finding.text)
          << ",\"detail\":" << json_text(finding.detail);
    write_list("faces", finding.faces, [&](std::size_t f) { m_out << f; });
    Page_bytes triangles;
    for(const std::size_t t : finding.triangles)
      triangles.add_difference(t);
    write_bytes("triangles", triangles);
    write_list("places", finding.places, [&](const Mesh_page_3::Point& p) {
      m_out << "[" << json_number(p[0]) << "," << json_number(p[1]) << "," << json_number(p[2]) << "]";
    });
    m_out << "}";
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PAGE_PAGE_WRITER_H
