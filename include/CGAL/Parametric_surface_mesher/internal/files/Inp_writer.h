// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_INP_WRITER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_INP_WRITER_H

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Element_sets.h>

#include <cctype>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Abaqus and CalculiX know names of letters, digits and underscores, which begin with a letter, in capitals.
inline std::string inp_name(const std::string& name)
{
  const std::size_t max_length = 60; // of both, 80
  std::string result;
  for(const char c : ascii_name(name))
    result += std::isalnum(static_cast<unsigned char>(c)) ? char(std::toupper(static_cast<unsigned char>(c))) : '_';
  if(result.empty() || !std::isalpha(static_cast<unsigned char>(result.front())))
    result = "N_" + result;
  return result.substr(0, max_length);
}

// A number in no more than the 20 characters that both programs read: with all its digits if there is room for them.
inline std::string inp_number(double x)
{
  const std::size_t max_length = 20;
  char text[32];
  for(const char* format : {"%.17g", "%.13e", "%.12e"}) { // the last one leaves room for an exponent of three digits
    std::snprintf(text, sizeof(text), format, x);
    if(std::strlen(text) <= max_length)
      break;
  }
  return text;
}

// Writes input files of Abaqus and CalculiX: nodes, shell elements, and sets of both.
class Inp_writer
{
  std::ostream& m_out;
  const Element_mesh_3& m_mesh;
  const Elements_of_entities m_elements;
  const std::vector<Element_set> m_sets;
  const std::vector<std::size_t> m_numbers; // by surface

public:
  Inp_writer(std::ostream& out, const Element_mesh_3& mesh)
    : m_out(out), m_mesh(mesh), m_elements(mesh), m_sets(element_sets(mesh)), m_numbers(unique_numbers(mesh.surfaces))
  {}

  void write()
  {
    m_out << "*HEADING\nTriangles of the faces of a shape\n*NODE, NSET=NALL\n";
    for(std::size_t i = 0; i < m_mesh.nodes.size(); ++i)
      m_out << i + 1 << ", " << inp_number(m_mesh.nodes[i][0]) << ", " << inp_number(m_mesh.nodes[i][1]) << ", "
            << inp_number(m_mesh.nodes[i][2]) << '\n';
    std::vector<std::string> blocks;
    Unique_names names(inp_name);
    names("EALL");
    names("NALL");
    std::map<std::size_t, std::size_t> numbers_of_parts; // by the numbers of faces
    for(const auto& surface : m_mesh.surfaces)
      ++numbers_of_parts[surface.number];
    for(std::size_t s = 0; s < m_mesh.surfaces.size(); ++s)
      blocks.push_back(names(block_name(s, numbers_of_parts[m_mesh.surfaces[s].number] > 1)));
    for(std::size_t s = 0; s < m_mesh.surfaces.size(); ++s)
      write_elements(s, blocks[s]);
    write_list("*ELSET, ELSET=EALL", blocks);
    for(const auto& set : m_sets)
      write_set(set, set.number > 0 && set.dimension == 2 && set.entities.size() == 1 ? blocks[set.entities.front()] : names(set.name), blocks);
  }

private:
  // The name of the face or, if it is in several parts, that of one of its sheets.
  std::string block_name(std::size_t surface, bool is_in_several_parts) const
  {
    return "FACE_" + std::to_string(m_mesh.surfaces[surface].number)
           + (is_in_several_parts ? "_SHEET_" + std::to_string(m_numbers[surface]) : "");
  }

  void write_elements(std::size_t surface, const std::string& name)
  {
    if(m_elements.triangles[surface].empty())
      return;
    m_out << "*ELEMENT, TYPE=" << (m_mesh.is_second_order ? "S6" : "S3") << ", ELSET=" << name << '\n';
    for(const std::size_t i : m_elements.triangles[surface]) {
      m_out << i + 1;
      for(std::size_t k = 0; k < m_mesh.nodes_of_triangle(); ++k)
        m_out << ", " << m_mesh.triangles[i][k] + 1;
      m_out << '\n';
    }
  }

  // As many in a line as all programs read.
  template <class List>
  void write_list(const std::string& keyword, const List& list)
  {
    const std::size_t length_of_line = 12;
    m_out << keyword << '\n';
    for(std::size_t i = 0; i < list.size(); ++i)
      m_out << list[i] << (i + 1 == list.size() || (i + 1) % length_of_line == 0 ? ",\n" : ", ");
  }

  void write_set(const Element_set& set, const std::string& name, const std::vector<std::string>& blocks)
  {
    std::vector<std::size_t> nodes = m_elements.nodes(set);
    for(std::size_t& node : nodes)
      ++node;
    if(nodes.empty())
      return;
    if(set.dimension == 2) {
      std::vector<std::string> members;
      for(const std::size_t s : set.entities)
        members.push_back(blocks[s]);
      if(members != std::vector<std::string>{name})
        write_list("*ELSET, ELSET=" + name, members);
    }
    write_list("*NSET, NSET=" + name, nodes);
    if(set.dimension == 2)
      m_out << "*SURFACE, NAME=" << name << ", TYPE=ELEMENT\n" << name << ", SPOS\n";
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_INP_WRITER_H
