// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines that the summaries of mesh_cad, mesh_patch and the Python module have in common.
#ifndef SUMMARY_LINES_H
#define SUMMARY_LINES_H

#include "Usage_error.h"
#include "text_of_numbers.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Triangle_mesh_quality.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace mesh_patch {

// The lengths of the sides of a box.
inline std::array<double, 3> sides(const CGAL::Bbox_3& box)
{
  const auto side = [](double from, double to) { return to < from ? 0. : to - from; }; // a box of nothing is turned inside out
  return {side(box.xmin(), box.xmax()), side(box.ymin(), box.ymax()), side(box.zmin(), box.zmax())};
}

template <class Mesh>
CGAL::Bbox_3 box_of(const Mesh& mesh)
{
  CGAL::Bbox_3 box;
  for(const auto v : mesh.vertices())
    box += mesh.point(v).bbox();
  return box;
}

// `why_open`: words for a mesh that is not closed, or empty
inline void print_triangles(std::ostream& out, const CGAL::Triangle_mesh_quality& q, const std::string& why_open = "")
{
  out << "  " << plural(q.number_of_faces, "triangle") << ", " << plural(q.number_of_vertices, "vertex", "vertices");
  if(q.is_closed)
    out << ", closed\n";
  else
    out << ", open" << why_open << ": it has " << plural(q.number_of_boundary_cycles, "border") << "\n";
}

const double negligible_share_of_size = 1e-12; // what is shorter is rounding

// Lengths in the unit of a surface, of a mesh with this box.
inline Text_of_length text_of_length(const CGAL::Bbox_3& box)
{
  const auto s = sides(box);
  return {"", negligible_share_of_size * (s[0] + s[1] + s[2])};
}

// `shape`: what it is called; `measured`, `allowed`: null if it is not known, or not bounded
inline void print_distance(std::ostream& out, const std::string& shape, const double* measured, const double* allowed,
                           const Text_of_length& length)
{
  out << "  distance from the " << shape << ": " << (measured != nullptr ? "at most " + length(*measured) + " measured" : "not measured");
  if(allowed != nullptr)
    out << ", " << length(*allowed) << " allowed";
  out << "\n";
}

inline std::string text_of_angle(double angle)
{
  const int digits = 3;
  return text_of(angle, digits);
}

// `details`: words behind the minimum, and behind the number of triangles below 10 degrees
inline void print_angles(std::ostream& out, const CGAL::Triangle_mesh_quality& q, std::size_t number_below_10,
                         const std::array<std::string, 2>& details = {})
{
  out << "  angles: minimum " << text_of_angle(q.min_angle) << details[0] << ", mean " << text_of_angle(q.mean_min_angle) << " degrees; "
      << (number_below_10 == 0 ? "none" : plural(number_below_10, "triangle")) << " below 10" << details[1] << "\n";
}

inline std::size_t number_below_10_degrees(const CGAL::Triangle_mesh_quality& q)
{
  return std::size_t(std::lround(q.share_below_10_degrees * double(q.number_of_faces)));
}

// The sum of some times, then those that are not next to nothing.
inline void print_seconds(std::ostream& out, const std::vector<std::pair<const char*, double>>& seconds)
{
  const int digits = 2;
  const double share_worth_telling = 0.01;
  double sum = 0;
  for(const auto& phase : seconds)
    sum += phase.second;
  out << "  processor time: " << text_of(sum, digits) << " s";
  const char* separator = ", of which ";
  for(const auto& phase : seconds)
    if(seconds.size() > 1 && phase.second > share_worth_telling * sum) {
      out << separator << phase.first << " " << text_of(phase.second, digits);
      separator = ", ";
    }
  out << "\n";
}

} // namespace mesh_patch

#endif // SUMMARY_LINES_H
