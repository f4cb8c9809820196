// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_SVG_WRITER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_SVG_WRITER_H

/*!
\file Svg_writer.h

The elements of an SVG file that pictures of meshes consist of.
*/

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <string>

namespace mesh_picture {

typedef std::array<double, 2> Point_2;

struct Color
{
  double red, green, blue; // 0 to 255
};

// Writes SVG elements with two decimals of a pixel.
class Svg_writer
{
  std::ostream& m_out;

public:
  Svg_writer(std::ostream& out, double width, double height) : m_out(out)
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
    m_out << "<path " << (color ? "color=\"" + hexadecimal(*color) + "\" " : "") << "d=\"M" << number((*first)[0])
          << " " << number((*first)[1]) << "l";
    for(const Point_2* p = first + 1; p != last; ++p) // steps are shorter than positions
      m_out << (p == first + 1 ? "" : " ") << number(p[0][0] - p[-1][0]) << " " << number(p[0][1] - p[-1][1]);
    m_out << "z\"/>\n";
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

} // namespace mesh_picture

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_SVG_WRITER_H
