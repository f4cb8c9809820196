// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_VTU_READER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_VTU_READER_H

#include <CGAL/Parametric_surface_mesher/internal/files/Node_values_builder.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Vtk_data_array.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Reads point data on an unstructured grid of VTK. Binary data at the end of the file are no XML; they are cut off before it is parsed.
class Vtu_reader
{
  typedef boost::property_tree::ptree Tree;

  std::string m_file_name, m_appended;
  bool m_is_appended_base64 = false;
  Tree m_file;
  Vtk_encoding m_encoding;
  Node_values_builder m_builder;

public:
  explicit Vtu_reader(const std::string& file_name) : m_file_name(file_name), m_builder(file_name)
  {
    std::ifstream in(file_name, std::ios::binary);
    if(!in)
      throw_file_error(file_name, "the file cannot be opened");
    std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    cut_appended_data(text);
    std::istringstream xml(text);
    try {
      Tree whole;
      boost::property_tree::read_xml(xml, whole);
      m_file = whole.get_child("VTKFile", Tree());
    }
    catch(const boost::property_tree::xml_parser_error& error) {
      throw_file_error(file_name, "it is no XML file, because of line " + std::to_string(error.line()) + ": " + error.message());
    }
    if(attribute(m_file, "type") != "UnstructuredGrid")
      throw_file_error(file_name, "it is no unstructured grid of VTK");
    m_encoding = {file_name, attribute(m_file, "byte_order") == "BigEndian", attribute(m_file, "header_type") == "UInt64",
                  attribute(m_file, "compressor")};
  }

  Node_values_3 read(const std::string& name)
  {
    for(const auto& piece : m_file.get_child("UnstructuredGrid", Tree()))
      if(piece.first == "Piece")
        read_piece(piece.second, name);
    return m_builder.mesh();
  }

private:
  static std::string attribute(const Tree& element, const std::string& name) { return element.get("<xmlattr>." + name, std::string()); }

  void cut_appended_data(std::string& text)
  {
    const std::size_t tag = text.find("<AppendedData");
    if(tag == std::string::npos)
      return;
    const std::size_t end_of_tag = text.find('>', tag), begin = text.find('_', end_of_tag);
    if(begin == std::string::npos)
      throw_file_error(m_file_name, "the binary data at its end are missing");
    m_is_appended_base64 = text.substr(tag, end_of_tag - tag).find("base64") != std::string::npos;
    m_appended = text.substr(begin + 1);
    text = text.substr(0, tag) + "</VTKFile>";
  }

  std::vector<double> numbers(const Tree& array) const
  {
    const Vtk_data_array decoder(m_encoding, attribute(array, "type"));
    const std::string format = attribute(array, "format");
    if(format == "appended") {
      const std::size_t offset = array.get<std::size_t>("<xmlattr>.offset", 0);
      return decoder.numbers(Byte_source(m_appended, offset, m_is_appended_base64));
    }
    return format == "binary" ? decoder.numbers(Byte_source(array.data(), 0, true)) : decoder.numbers_in_text(array.data());
  }

  // Whole numbers, for indices.
  std::vector<std::size_t> indices(const Tree& cells, const std::string& name) const
  {
    for(const auto& array : cells)
      if(array.first == "DataArray" && attribute(array.second, "Name") == name) {
        std::vector<std::size_t> result;
        for(const double value : numbers(array.second)) {
          if(!(value >= 0 && value < 1e15))
            throw_file_error(m_file_name, "an index in '" + name + "' is out of range");
          result.push_back(std::size_t(value));
        }
        return result;
      }
    throw_file_error(m_file_name, "the array '" + name + "' of cells is missing");
  }

  void read_piece(const Tree& piece, const std::string& name)
  {
    const std::size_t first = m_builder.number_of_nodes();
    const auto points = piece.get_child("Points", Tree());
    for(const auto& array : points)
      if(array.first == "DataArray") {
        const std::vector<double> coordinates = numbers(array.second);
        for(std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
          m_builder.add_node(first + i / 3, coordinates[i], coordinates[i + 1], coordinates[i + 2]);
      }
    read_values(piece.get_child("PointData", Tree()), name, first);
    const auto cells = piece.get_child("Cells", Tree());
    std::vector<std::size_t> nodes = indices(cells, "connectivity");
    const std::vector<std::size_t> ends = indices(cells, "offsets"), types = indices(cells, "types");
    for(std::size_t& node : nodes)
      node += first;
    for(std::size_t i = 0, begin = 0; i < ends.size(); begin = ends[i++]) {
      if(i >= types.size() || ends[i] < begin || ends[i] > nodes.size())
        throw_file_error(m_file_name, "the arrays of cells do not fit together");
      add_cell(types[i], nodes.data() + begin, ends[i] - begin);
    }
  }

  void read_values(const Tree& point_data, const std::string& name, std::size_t first)
  {
    std::vector<Named_node_values> all;
    std::vector<const Tree*> arrays;
    for(const auto& array : point_data)
      if(array.first == "DataArray") {
        all.push_back({attribute(array.second, "Name"), array.second.get<std::size_t>("<xmlattr>.NumberOfComponents", 1)});
        arrays.push_back(&array.second);
      }
    const std::vector<double> values = numbers(*arrays[chosen_values(m_file_name, all, name)]);
    if(values.size() != m_builder.number_of_nodes() - first)
      throw_file_error(m_file_name, "there are " + std::to_string(values.size()) + " values for "
                                      + std::to_string(m_builder.number_of_nodes() - first) + " nodes");
    for(std::size_t i = 0; i < values.size(); ++i)
      m_builder.set_value(first + i, values[i]);
  }

  // Cells of higher order begin with their corners.
  void add_cell(std::size_t type, const std::size_t* nodes, std::size_t number)
  {
    const auto is_one_of
      = [type](std::initializer_list<std::size_t> types) { return std::find(types.begin(), types.end(), type) != types.end(); };
    if(is_one_of({1, 2, 3, 4, 21})) // points and lines
      return;
    const bool is_triangle = is_one_of({5, 22, 34}), is_quadrilateral = is_one_of({9, 23, 28}), is_tetrahedron = is_one_of({10, 24});
    if(!is_triangle && !is_quadrilateral && !is_tetrahedron)
      m_builder.refuse_element("type " + std::to_string(type));
    if(number < (is_triangle ? 3u : 4u))
      throw_file_error(m_file_name, "a cell has too few nodes");
    if(is_triangle)
      m_builder.add_triangle(nodes);
    else if(is_tetrahedron)
      m_builder.add_tetrahedron(nodes);
    else
      m_builder.add_quadrilateral(nodes);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_VTU_READER_H
