// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_STL_WRITER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_STL_WRITER_H

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Element_sets.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Sides_of_parts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Writes STL files, as text or binary.
class Stl_writer
{
  typedef Side_of_part Side;

  std::ostream& m_out;
  const Element_mesh_3& m_mesh;

public:
  Stl_writer(std::ostream& out, const Element_mesh_3& mesh) : m_out(out), m_mesh(mesh) {}

  void write_text() const
  {
    const std::vector<std::vector<Side>> triangles = sides_by_part(m_mesh);
    Unique_names names(one_line);
    for(std::size_t p = 0; p < triangles.size(); ++p) {
      if(triangles[p].empty())
        continue;
      const std::string name = names(p < m_mesh.parts.size() ? m_mesh.parts[p].name : "faces");
      m_out << "solid " << name << '\n';
      for(const Side& side : triangles[p])
        write_triangle(side);
      m_out << "endsolid " << name << '\n';
    }
  }

  void write_binary() const
  {
    std::string header = "binary STL; attributes are numbers of parts"; // must not begin with "solid"
    header.resize(80, ' ');
    m_out.write(header.data(), std::streamsize(header.size()));
    const std::vector<Side> all = sides_of_parts(m_mesh);
    write_bytes(all.size(), 4);
    const std::size_t largest_attribute = 0x7fff; // larger ones are colours for some programs
    for(const Side& side : all) {
      write_point(normal(side));
      for(const std::size_t node : side.nodes)
        write_point(m_mesh.nodes[node]);
      const std::size_t number = side.part < m_mesh.parts.size() ? m_mesh.parts[side.part].number : 0;
      write_bytes(number <= largest_attribute ? number : 0, 2);
    }
  }

private:
  typedef Element_mesh_3::Point Point;

  Point normal(const Side& side) const
  {
    const Point &a = m_mesh.nodes[side.nodes[0]], &b = m_mesh.nodes[side.nodes[1]], &c = m_mesh.nodes[side.nodes[2]];
    Point result;
    double square = 0;
    for(std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      result[i] = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
      square += result[i] * result[i];
    }
    for(double& x : result)
      x = square > 0 ? x / std::sqrt(square) : 0;
    return result;
  }

  void write_triangle(const Side& side) const
  {
    const Point n = normal(side);
    m_out << "facet normal " << n[0] << ' ' << n[1] << ' ' << n[2] << "\nouter loop\n";
    for(const std::size_t node : side.nodes) {
      const Point& p = m_mesh.nodes[node];
      m_out << "vertex " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
    m_out << "endloop\nendfacet\n";
  }

  // The lowest byte first, on all machines.
  void write_bytes(std::uint64_t value, int number) const
  {
    for(int i = 0; i < number; ++i)
      m_out.put(char((value >> (8 * i)) & 0xff));
  }

  void write_point(const Point& p) const
  {
    for(const double x : p) {
      const float f = float(x);
      std::uint32_t bits = 0;
      static_assert(sizeof(bits) == sizeof(f), "STL files have numbers of four bytes");
      std::memcpy(&bits, &f, sizeof(f));
      write_bytes(bits, 4);
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_STL_WRITER_H
