// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_VTU_WRITER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_VTU_WRITER_H

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Element_sets.h>

#ifdef CGAL_LINKED_WITH_BOOST_IOSTREAMS
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/zlib.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#endif

#include <boost/predef/other/endian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The binary data at the end of an XML file of VTK, compressed in blocks if Boost.Iostreams is there.
class Vtk_appended_data
{
  static constexpr std::size_t size_of_block = 1 << 15; // in bytes; that of VTK
  std::string m_data;

public:
  std::size_t size() const { return m_data.size(); }
  const std::string& data() const { return m_data; }

#ifdef CGAL_LINKED_WITH_BOOST_IOSTREAMS
  static const char* attribute_of_file() { return " compressor=\"vtkZLibDataCompressor\""; }

  void add(const std::string& bytes)
  {
    std::string blocks;
    std::vector<std::uint64_t> header{0, size_of_block, bytes.size() % size_of_block};
    for(std::size_t begin = 0; begin < bytes.size(); begin += size_of_block) {
      const std::size_t before = blocks.size();
      boost::iostreams::filtering_ostream out;
      out.push(boost::iostreams::zlib_compressor());
      out.push(boost::iostreams::back_inserter(blocks));
      out.write(bytes.data() + begin, std::streamsize((std::min)(size_of_block, bytes.size() - begin)));
      out.reset();
      header.push_back(blocks.size() - before);
      ++header.front();
    }
    add_numbers(header);
    m_data += blocks;
  }
#else
  static const char* attribute_of_file() { return ""; }

  void add(const std::string& bytes)
  {
    add_numbers({bytes.size()});
    m_data += bytes;
  }
#endif

private:
  void add_numbers(const std::vector<std::uint64_t>& numbers)
  {
    m_data.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(std::uint64_t));
  }
};

// Writes unstructured grids of VTK: triangles, then lines, then points. Lists of names are text, one name a line, as the numbers of its
// characters: meshio does not read a file with strings.
class Vtu_writer
{
  const Element_mesh_3& m_mesh;
  Vtk_appended_data m_data;
  std::ostringstream m_header;

public:
  explicit Vtu_writer(const Element_mesh_3& mesh) : m_mesh(mesh) {}

  void write(std::ostream& out)
  {
    m_header << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\""
             << (BOOST_ENDIAN_BIG_BYTE ? "BigEndian" : "LittleEndian") << "\" header_type=\"UInt64\"" << Vtk_appended_data::attribute_of_file()
             << ">\n<UnstructuredGrid>\n";
    add_names();
    m_header << "<Piece NumberOfPoints=\"" << m_mesh.nodes.size() << "\" NumberOfCells=\"" << number_of_cells() << "\">\n<Points>\n";
    std::vector<double> coordinates;
    for(const auto& p : m_mesh.nodes)
      coordinates.insert(coordinates.end(), p.begin(), p.end());
    add("points", 3, coordinates);
    m_header << "</Points>\n";
    add_cells();
    add_cell_data();
    add_node_data();
    m_header << "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
    out << m_header.str();
    out.write(m_data.data().data(), std::streamsize(m_data.size()));
    out << "\n</AppendedData>\n</VTKFile>\n";
  }

private:
  std::size_t number_of_cells() const { return m_mesh.triangles.size() + m_mesh.lines.size() + m_mesh.points.size(); }

  static const char* type_name(double) { return "Float64"; }
  static const char* type_name(std::int64_t) { return "Int64"; }
  static const char* type_name(std::uint8_t) { return "UInt8"; }
  static const char* type_name(char) { return "Int8"; }

  template <class T>
  void add(const std::string& name, std::size_t number_of_components, const std::vector<T>& values)
  {
    add_array("NumberOfComponents", name, number_of_components, values);
  }

  // In field data.
  template <class T>
  void add_array(const char* size_name, const std::string& name, std::size_t size, const std::vector<T>& values)
  {
    m_header << "<DataArray type=\"" << type_name(T()) << "\" Name=\"" << xml_text(name) << "\" " << size_name << "=\"" << size
             << "\" format=\"appended\" offset=\"" << m_data.size() << "\"/>\n";
    m_data.add(std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)));
  }

  static std::string xml_text(const std::string& text)
  {
    std::string result;
    for(const char c : text)
      result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
    return result;
  }

  void add_text(const std::string& name, const std::string& text)
  {
    if(!text.empty())
      add_array("NumberOfTuples", name, text.size(), std::vector<char>(text.begin(), text.end()));
  }

  void add_names()
  {
    std::string parts;
    for(const auto& part : m_mesh.parts)
      parts += std::to_string(part.number) + " " + part.name + "\n";
    m_header << "<FieldData>\n";
    add_text("part_names", parts);
    add_text("face_names", names_of(m_mesh.surfaces));
    add_text("edge_names", names_of(m_mesh.curves));
    add_text("vertex_names", names_of(m_mesh.vertices));
    m_header << "</FieldData>\n";
  }

  static std::string names_of(const std::vector<Element_mesh_3::Entity>& entities)
  {
    std::string result;
    for(const auto& entity : entities)
      if(!entity.name.empty())
        result += std::to_string(entity.number) + " " + entity.name + "\n";
    return result;
  }

  void add_cells()
  {
    std::vector<std::int64_t> connectivity, offsets;
    std::vector<std::uint8_t> types;
    const auto add_cell = [&](const auto& nodes, std::size_t number, std::uint8_t type) {
      for(std::size_t k = 0; k < number; ++k)
        connectivity.push_back(std::int64_t(nodes[k]));
      offsets.push_back(std::int64_t(connectivity.size()));
      types.push_back(type);
    };
    // VTK_TRIANGLE and VTK_QUADRATIC_TRIANGLE, VTK_LINE and VTK_QUADRATIC_EDGE, VTK_VERTEX
    for(const auto& triangle : m_mesh.triangles)
      add_cell(triangle, m_mesh.nodes_of_triangle(), m_mesh.is_second_order ? 22 : 5);
    for(const auto& line : m_mesh.lines)
      add_cell(line, m_mesh.nodes_of_line(), m_mesh.is_second_order ? 21 : 3);
    for(const auto& point : m_mesh.points)
      add_cell(&point, 1, 1);
    m_header << "<Cells>\n";
    add("connectivity", 1, connectivity);
    add("offsets", 1, offsets);
    add("types", 1, types);
    m_header << "</Cells>\n";
  }

  // The numbers of the entities of some elements, and zeros for all other elements.
  std::vector<std::int64_t> numbers_of(const std::vector<Element_mesh_3::Entity>& entities, const std::vector<std::size_t>& of_elements,
                                       std::size_t first) const
  {
    std::vector<std::int64_t> result(number_of_cells(), 0);
    for(std::size_t i = 0; i < of_elements.size(); ++i)
      result[first + i] = std::int64_t(entities[of_elements[i]].number);
    return result;
  }

  void add_cell_data()
  {
    const std::size_t first_line = m_mesh.triangles.size(), first_point = first_line + m_mesh.lines.size();
    m_header << "<CellData Scalars=\"face_id\">\n";
    add("face_id", 1, numbers_of(m_mesh.surfaces, m_mesh.triangle_surfaces, 0));
    add("edge_id", 1, numbers_of(m_mesh.curves, m_mesh.line_curves, first_line));
    add("vertex_id", 1, numbers_of(m_mesh.vertices, m_mesh.point_vertices, first_point));
    std::vector<std::int64_t> parts[2];
    std::vector<std::uint8_t> colors;
    const auto add_entity = [&](const Element_mesh_3::Entity& entity) {
      const Element_mesh_3::Color gray{0.75, 0.75, 0.75, 1}, color = entity.color.value_or(gray);
      for(std::size_t i = 0; i < 2; ++i)
        parts[i].push_back(entity.parts[i] == Element_mesh_3::none ? 0 : std::int64_t(m_mesh.parts[entity.parts[i]].number));
      for(const double c : {color.red, color.green, color.blue})
        colors.push_back(std::uint8_t((std::min)((std::max)(255 * c + 0.5, 0.), 255.)));
    };
    for(const std::size_t s : m_mesh.triangle_surfaces)
      add_entity(m_mesh.surfaces[s]);
    for(const std::size_t c : m_mesh.line_curves)
      add_entity(m_mesh.curves[c]);
    for(const std::size_t v : m_mesh.point_vertices)
      add_entity(m_mesh.vertices[v]);
    add("part_id", 1, parts[0]);
    add("part_id_in_front", 1, parts[1]);
    add("color", 3, colors);
    for(const auto& data : m_mesh.triangle_data) {
      std::vector<double> values = data.values;
      values.resize(data.number_of_components * number_of_cells(), std::numeric_limits<double>::quiet_NaN());
      add(data.name, data.number_of_components, values);
    }
    m_header << "</CellData>\n";
  }

  void add_node_data()
  {
    m_header << "<PointData>\n";
    for(const auto& data : m_mesh.node_data)
      add(data.name, data.number_of_components, data.values);
    const auto is_known = [](const auto& place) { return std::isfinite(place.u); };
    if(std::any_of(m_mesh.places.begin(), m_mesh.places.end(), is_known))
      add_places();
    m_header << "</PointData>\n";
  }

  void add_places()
  {
    std::vector<std::int64_t> dimensions, numbers;
    std::vector<double> parameters;
    const std::vector<Element_mesh_3::Entity>* entities[3] = {&m_mesh.vertices, &m_mesh.curves, &m_mesh.surfaces};
    for(const auto& place : m_mesh.places) {
      dimensions.push_back(place.dimension);
      numbers.push_back(place.entity == Element_mesh_3::none ? 0 : std::int64_t((*entities[place.dimension])[place.entity].number));
      parameters.push_back(place.u);
      parameters.push_back(place.v);
    }
    add("place_dimension", 1, dimensions);
    add("place_id", 1, numbers);
    add("place_parameters", 2, parameters);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_VTU_WRITER_H
