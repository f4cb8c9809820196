// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_MEDIT_READER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_MEDIT_READER_H

#include <CGAL/Parametric_surface_mesher/internal/files/Node_values_builder.h>

#include <cctype>
#include <cstddef>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The keywords and numbers of an ASCII file of Medit.
class Medit_words
{
  std::string m_file_name;
  std::ifstream m_in;

public:
  explicit Medit_words(const std::string& file_name) : m_file_name(file_name), m_in(file_name)
  {
    if(!m_in)
      throw_file_error(file_name, "the file cannot be opened");
  }

  const std::string& file_name() const { return m_file_name; }

  // The next keyword, after what is left of the one before; false at the end.
  bool next_keyword(std::string& keyword)
  {
    while(m_in >> keyword) {
      if(keyword.front() == '#')
        m_in.ignore((std::numeric_limits<std::streamsize>::max)(), '\n');
      else if(std::isalpha(static_cast<unsigned char>(keyword.front())))
        return keyword != "End";
    }
    return false;
  }

  double number()
  {
    double result;
    skip_comments();
    if(!(m_in >> result))
      throw_file_error(m_file_name, "a number is missing, or the file ends too early");
    return result;
  }

  std::size_t count()
  {
    std::size_t result;
    skip_comments();
    if(m_in.peek() == '-' || !(m_in >> result))
      throw_file_error(m_file_name, "a whole number is missing, or the file ends too early");
    return result;
  }

private:
  void skip_comments()
  {
    while(m_in >> std::ws && m_in.peek() == '#')
      m_in.ignore((std::numeric_limits<std::streamsize>::max)(), '\n');
  }
};

inline void read_medit_mesh(const std::string& file_name, Node_values_builder& builder)
{
  Medit_words words(file_name);
  std::string keyword;
  std::size_t dimension = 3;
  const auto for_each_element = [&](std::size_t number_of_nodes, const auto& function) {
    std::vector<std::size_t> nodes(number_of_nodes);
    for(std::size_t n = words.count(); n > 0; --n) {
      for(std::size_t& node : nodes)
        node = words.count();
      words.number(); // a reference, which may be negative
      function(nodes.data());
    }
  };
  while(words.next_keyword(keyword)) {
    if(keyword == "Dimension")
      dimension = words.count();
    else if(keyword == "Vertices")
      for(std::size_t i = 0, n = words.count(); i < n; ++i) {
        const double x = words.number(), y = words.number(), z = dimension == 2 ? 0 : words.number();
        words.number();
        builder.add_node(i + 1, x, y, z);
      }
    else if(keyword == "Triangles")
      for_each_element(3, [&](const std::size_t* nodes) { builder.add_triangle(nodes); });
    else if(keyword == "Quadrilaterals")
      for_each_element(4, [&](const std::size_t* nodes) { builder.add_quadrilateral(nodes); });
    else if(keyword == "Tetrahedra")
      for_each_element(4, [&](const std::size_t* nodes) { builder.add_tetrahedron(nodes); });
    else if((keyword == "Hexahedra" || keyword == "Prisms" || keyword == "Pyramids") && words.count() > 0)
      builder.refuse_element("the kind " + keyword);
  }
}

inline void read_medit_values(const std::string& file_name, Node_values_builder& builder)
{
  Medit_words words(file_name);
  std::string keyword;
  while(words.next_keyword(keyword)) {
    if(keyword != "SolAtVertices")
      continue;
    const std::size_t number = words.count();
    if(words.count() != 1 || words.count() != 1)
      throw_file_error(file_name, "there are other values at the nodes than one scalar; metric tensors are not read");
    if(number != builder.number_of_nodes())
      throw_file_error(file_name, "there are " + std::to_string(number) + " values for " + std::to_string(builder.number_of_nodes())
                                    + " nodes");
    for(std::size_t i = 0; i < number; ++i)
      builder.set_value(i + 1, words.number());
    return;
  }
  throw_file_error(file_name, "there are no values at the nodes");
}

// Reads a mesh from a .mesh file, and the values at its nodes from a .sol file.
inline Node_values_3 read_medit(const std::string& mesh_file_name, const std::string& values_file_name)
{
  Node_values_builder builder(mesh_file_name);
  read_medit_mesh(mesh_file_name, builder);
  read_medit_values(values_file_name, builder);
  return builder.mesh();
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_MEDIT_READER_H
