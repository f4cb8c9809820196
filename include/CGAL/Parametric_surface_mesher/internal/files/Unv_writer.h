// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_UNV_WRITER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_UNV_WRITER_H

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Element_sets.h>

#include <cstddef>
#include <cstdio>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Writes universal files of I-DEAS: nodes, shell elements, and groups of both.
class Unv_writer
{
  std::ostream& m_out;
  const Element_mesh_3& m_mesh;

public:
  Unv_writer(std::ostream& out, const Element_mesh_3& mesh) : m_out(out), m_mesh(mesh) {}

  void write()
  {
    const int nodes = 2411, elements = 2412, groups = 2467; // datasets
    write_dataset(nodes, [this] { write_nodes(); });
    write_dataset(elements, [this] { write_elements(); });
    write_dataset(groups, [this] { write_groups(); });
  }

private:
  template <class Function>
  void write_dataset(int number, const Function& write_lines)
  {
    m_out << "    -1\n";
    write_numbers({std::size_t(number)}, 6);
    write_lines();
    m_out << "    -1\n";
  }

  void write_numbers(const std::vector<std::size_t>& numbers, int width = 10)
  {
    char field[32];
    for(const std::size_t number : numbers) {
      std::snprintf(field, sizeof(field), "%*zu", width, number);
      m_out << field;
    }
    m_out << '\n';
  }

  void write_nodes()
  {
    char line[128];
    for(std::size_t i = 0; i < m_mesh.nodes.size(); ++i) {
      const auto& p = m_mesh.nodes[i];
      write_numbers({i + 1, 1, 1, 11}); // coordinate systems, and a colour
      std::snprintf(line, sizeof(line), "%25.16E%25.16E%25.16E\n", p[0], p[1], p[2]);
      for(char* c = line; *c != '\0'; ++c)
        if(*c == 'E')
          *c = 'D';
      m_out << line;
    }
  }

  // The nodes of a triangle of second order are told along its sides.
  void write_elements()
  {
    const std::size_t linear_shell = 91, parabolic_shell = 92;
    for(std::size_t i = 0; i < m_mesh.triangles.size(); ++i) {
      const auto& t = m_mesh.triangles[i];
      write_numbers({i + 1, m_mesh.is_second_order ? parabolic_shell : linear_shell, m_mesh.surfaces[m_mesh.triangle_surfaces[i]].number, 1, 7,
                     m_mesh.nodes_of_triangle()});
      if(m_mesh.is_second_order)
        write_numbers({t[0] + 1, t[3] + 1, t[1] + 1, t[4] + 1, t[2] + 1, t[5] + 1});
      else
        write_numbers({t[0] + 1, t[1] + 1, t[2] + 1});
    }
  }

  void write_groups()
  {
    const std::size_t of_nodes = 7, of_elements = 8;
    const Elements_of_entities elements(m_mesh);
    Unique_names names(one_line);
    std::size_t number = 0;
    for(const auto& set : element_sets(m_mesh)) {
      std::vector<std::size_t> members;
      if(set.dimension == 2)
        for(const std::size_t s : set.entities)
          members.insert(members.end(), elements.triangles[s].begin(), elements.triangles[s].end());
      else
        members = elements.nodes(set);
      write_numbers({++number, 0, 0, 0, 0, 0, 0, members.size()});
      m_out << names(set.name) << '\n';
      for(std::size_t i = 0; i < members.size(); i += 2) { // two in a line
        std::vector<std::size_t> line;
        for(std::size_t k = i; k < members.size() && k < i + 2; ++k)
          line.insert(line.end(), {set.dimension == 2 ? of_elements : of_nodes, members[k] + 1, 0, 0});
        write_numbers(line);
      }
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_UNV_WRITER_H
