// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_MSH_READER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_MSH_READER_H

#include <CGAL/Parametric_surface_mesher/internal/files/Node_values_builder.h>

#include <cstddef>
#include <fstream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Reads node data on the mesh of an ASCII file of Gmsh, version 2.2 or 4.1. Of several steps of the same data the last one counts.
class Msh_reader
{
  struct Data : Named_node_values
  {
    std::vector<std::pair<std::size_t, double>> values; // with the numbers of the nodes
  };

  std::string m_file_name;
  std::ifstream m_in;
  bool m_is_version_2 = false;
  Node_values_builder m_builder;
  std::vector<Data> m_data;

public:
  explicit Msh_reader(const std::string& file_name) : m_file_name(file_name), m_in(file_name, std::ios::binary), m_builder(file_name)
  {
    if(!m_in)
      throw_file_error(file_name, "the file cannot be opened");
  }

  Node_values_3 read(const std::string& name)
  {
    for(std::string word; m_in >> word;) {
      if(word == "$MeshFormat")
        read_format();
      else if(word == "$Nodes")
        m_is_version_2 ? read_nodes_2() : read_nodes();
      else if(word == "$Elements")
        m_is_version_2 ? read_elements_2() : read_elements();
      else if(word == "$NodeData")
        read_data();
    }
    const std::vector<Named_node_values> all(m_data.begin(), m_data.end());
    for(const auto& value : m_data[chosen_values(m_file_name, all, name)].values)
      m_builder.set_value(value.first, value.second);
    return m_builder.mesh();
  }

private:
  template <class T = std::size_t>
  T next()
  {
    T result;
    if(!(m_in >> result))
      throw_file_error(m_file_name, "a number is missing, or the file ends too early");
    return result;
  }

  void skip(std::size_t number_of_words)
  {
    for(std::string word; number_of_words > 0; --number_of_words)
      if(!(m_in >> word))
        throw_file_error(m_file_name, "the file ends too early");
  }

  void read_format()
  {
    const std::string version = next<std::string>();
    if(version != "2.2" && version != "4.1")
      throw_file_error(m_file_name, "its version is " + version + "; 2.2 and 4.1 are read");
    if(next() != 0)
      throw_file_error(m_file_name, "it is a binary file; ASCII files are read");
    m_is_version_2 = version == "2.2";
  }

  void read_node(std::size_t number)
  {
    const double x = next<double>(), y = next<double>(), z = next<double>();
    m_builder.add_node(number, x, y, z);
  }

  void read_nodes_2()
  {
    for(std::size_t n = next(); n > 0; --n)
      read_node(next());
  }

  void read_elements_2()
  {
    for(std::size_t n = next(); n > 0; --n) {
      skip(1);
      const std::size_t type = next(), number_of_tags = next();
      skip(number_of_tags);
      read_element(type);
    }
  }

  void read_nodes()
  {
    std::size_t number_of_blocks = next();
    skip(3);
    for(; number_of_blocks > 0; --number_of_blocks) {
      const std::size_t dimension = next();
      skip(1);
      const bool has_parameters = next() != 0;
      std::vector<std::size_t> numbers;
      for(std::size_t n = next(); n > 0; --n)
        numbers.push_back(next());
      for(const std::size_t number : numbers) {
        read_node(number);
        skip(has_parameters ? dimension : 0);
      }
    }
  }

  void read_elements()
  {
    std::size_t number_of_blocks = next();
    skip(3);
    for(; number_of_blocks > 0; --number_of_blocks) {
      skip(2);
      const std::size_t type = next();
      for(std::size_t n = next(); n > 0; --n) {
        skip(1);
        read_element(type);
      }
    }
  }

  void read_element(std::size_t type)
  {
    const std::size_t line = 1, triangle = 2, quadrilateral = 3, tetrahedron = 4, line_2 = 8, triangle_2 = 9, quadrilateral_2 = 10,
                      tetrahedron_2 = 11, point = 15, quadrilateral_8 = 16;
    const std::pair<std::size_t, std::size_t> numbers_of_nodes[]
      = {{line, 2},       {triangle, 3},        {quadrilateral, 4},  {tetrahedron, 4}, {line_2, 3},
         {triangle_2, 6}, {quadrilateral_2, 9}, {tetrahedron_2, 10}, {point, 1},       {quadrilateral_8, 8}};
    std::size_t number = 0;
    for(const auto& of_type : numbers_of_nodes)
      if(of_type.first == type)
        number = of_type.second;
    if(number == 0)
      m_builder.refuse_element("type " + std::to_string(type));
    std::size_t nodes[10];
    for(std::size_t i = 0; i < number; ++i)
      nodes[i] = next();
    if(type == triangle || type == triangle_2)
      m_builder.add_triangle(nodes);
    else if(type == tetrahedron || type == tetrahedron_2)
      m_builder.add_tetrahedron(nodes);
    else if(type == quadrilateral || type == quadrilateral_2 || type == quadrilateral_8)
      m_builder.add_quadrilateral(nodes);
  }

  // The first text is the name; the integers are the step, the number of components and that of the nodes.
  void read_data()
  {
    Data data;
    std::size_t number_of_texts = next();
    m_in.ignore((std::numeric_limits<std::streamsize>::max)(), '\n');
    for(std::size_t i = 0; i < number_of_texts; ++i) {
      std::string text;
      if(!std::getline(m_in, text))
        throw_file_error(m_file_name, "the file ends too early");
      const std::size_t begin = text.find('"'), end = text.rfind('"');
      if(i == 0 && end > begin)
        data.name = text.substr(begin + 1, end - begin - 1);
    }
    skip(next());
    std::vector<std::size_t> numbers;
    for(std::size_t n = next(); n > 0; --n)
      numbers.push_back(next());
    if(numbers.size() < 3 || numbers[1] == 0)
      throw_file_error(m_file_name, "node data without the number of components or of nodes");
    data.number_of_components = numbers[1];
    for(std::size_t n = numbers[2]; n > 0; --n) {
      const std::size_t node = next();
      data.values.emplace_back(node, next<double>());
      skip(data.number_of_components - 1);
    }
    for(Data& before : m_data)
      if(before.name == data.name) {
        before = std::move(data);
        return;
      }
    m_data.push_back(std::move(data));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_MSH_READER_H
