// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_READ_BEZIER_PATCHES_H
#define CGAL_IO_READ_BEZIER_PATCHES_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Bezier_surface_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <fstream>
#include <istream>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Reads lines of numbers and says where one is not as expected.
class Number_line_reader
{
  std::istream& m_input;
  std::string m_name;
  std::string m_text;
  std::size_t m_line = 0;

public:
  Number_line_reader(std::istream& input, const std::string& name) : m_input(input), m_name(name) {}

  // Reads the next line that is not blank: as many numbers as there are arguments, and nothing else.
  template <class... Number>
  void read(const std::string& expected, Number&... numbers)
  {
    if(!next_line())
      refuse(expected, m_input.bad() ? "a read error" : "the end of the file");
    std::istringstream tokens(m_text);
    tokens.imbue(std::locale::classic());
    if(!(tokens >> ... >> numbers) || !(tokens >> std::ws).eof())
      refuse(expected);
  }

  void expect_end()
  {
    if(next_line())
      refuse("the end of the file");
    if(m_input.bad())
      refuse("the end of the file", "a read error");
  }

  [[noreturn]] void refuse(const std::string& expected) const { refuse(expected, '"' + m_text + '"'); }

private:
  [[noreturn]] void refuse(const std::string& expected, const std::string& found) const
  {
    throw Parametric_surface_mesh_error(m_name + ", line " + std::to_string(m_line)
                                        + ": expected " + expected + ", found " + found);
  }

  bool next_line()
  {
    do {
      ++m_line;
      if(!std::getline(m_input, m_text))
        return false;
      m_text.erase(m_text.find_last_not_of(" \t\r") + 1);
    } while(m_text.empty());
    return true;
  }
};

template <class Kernel>
Bezier_surface_3<Kernel> read_bezier_patch(Number_line_reader& reader, const std::string& of_patch)
{
  const std::string two_degrees = "two degrees from 1 to " + std::to_string(max_degree) + of_patch;
  int degree_u = 0, degree_v = 0;
  reader.read(two_degrees, degree_u, degree_v);
  for(int degree : { degree_u, degree_v })
    if(degree < 1 || degree > max_degree)
      reader.refuse(two_degrees);

  const int count = (degree_u + 1) * (degree_v + 1);
  std::vector<typename Kernel::Point_3> points;
  for(int i = 0; i < count; ++i) {
    double x = 0, y = 0, z = 0;
    reader.read("three finite coordinates of control point " + std::to_string(i + 1)
                + " of " + std::to_string(count) + of_patch, x, y, z);
    points.emplace_back(x, y, z);
  }
  return Bezier_surface_3<Kernel>(degree_u, degree_v, points);
}

} // namespace internal
} // namespace Parametric_surface_mesher

namespace IO {

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

reads Bezier patches in the `.bpt` format, known from the Utah teapot: the number of patches, then for each patch a
line with the degrees in the `u` and `v` direction and a line for each control point, where the number in the `u`
direction runs fastest. Blank lines are skipped.

\tparam Kernel a model of `Kernel` with `double` as number type

\param input the stream
\param name the name of the stream in messages

\throws Parametric_surface_mesh_error if the stream holds anything else; the message names the line and what was
        expected there
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel>
std::vector<Bezier_surface_3<Kernel> > read_bezier_patches(std::istream& input, const std::string& name)
{
  namespace internal = Parametric_surface_mesher::internal;
  internal::Number_line_reader reader(input, name);
  const std::string positive_count = "a positive number of patches";
  int count = 0;
  reader.read(positive_count, count);
  if(count < 1)
    reader.refuse(positive_count);

  std::vector<Bezier_surface_3<Kernel> > patches; // not reserved: the count may be wrong
  for(int i = 0; i < count; ++i)
    patches.push_back(internal::read_bezier_patch<Kernel>(
      reader, " of patch " + std::to_string(i + 1) + " of " + std::to_string(count)));
  reader.expect_end();
  return patches;
}

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

reads Bezier patches from the file with the name `file_name`.

\throws Parametric_surface_mesh_error also if the file cannot be opened
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel>
std::vector<Bezier_surface_3<Kernel> > read_bezier_patches(const std::string& file_name)
{
  std::ifstream input(file_name);
  if(!input)
    throw Parametric_surface_mesh_error(file_name + ": cannot open the file");
  return read_bezier_patches<Kernel>(input, file_name);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_READ_BEZIER_PATCHES_H
