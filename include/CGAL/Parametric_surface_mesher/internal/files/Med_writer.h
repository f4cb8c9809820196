// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_MED_WRITER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_MED_WRITER_H

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Element_sets.h>

#include <med.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Writes MED files with the library of Salome and Code_Aster. Each surface, curve and vertex is a family, with the names of its groups.
class Med_writer
{
  typedef std::pair<int, std::size_t> Entity; // dimension and index

  const std::string m_file_name;
  const Element_mesh_3& m_mesh;
  const char* m_name = "mesh";
  med_idt m_file;
  std::map<Entity, std::vector<std::string>> m_groups;

public:
  Med_writer(const std::string& file_name, const Element_mesh_3& mesh)
    : m_file_name(file_name), m_mesh(mesh), m_file(MEDfileOpen(file_name.c_str(), MED_ACC_CREAT))
  {
    check(m_file < 0 ? -1 : 0);
    Unique_names names([](const std::string& name) { return ascii_name(one_line(name)).substr(0, std::size_t(MED_LNAME_SIZE) - 8); });
    for(const auto& set : element_sets(mesh)) {
      const std::string name = names(set.name);
      for(const std::size_t entity : set.entities)
        m_groups[{set.dimension, entity}].push_back(name);
    }
  }
  ~Med_writer()
  {
    if(m_file >= 0)
      MEDfileClose(m_file);
  }
  Med_writer(const Med_writer&) = delete;
  Med_writer& operator=(const Med_writer&) = delete;

  void write()
  {
    const std::string axes = padded({"x", "y", "z"}, MED_SNAME_SIZE), units = padded({"", "", ""}, MED_SNAME_SIZE);
    check(MEDmeshCr(m_file, m_name, 3, 2, MED_UNSTRUCTURED_MESH, "", "", MED_SORT_DTIT, MED_CARTESIAN, axes.c_str(), units.c_str()));
    write_families();
    write_nodes();
    write_elements(m_mesh.triangles, m_mesh.triangle_surfaces, 2, m_mesh.is_second_order ? MED_TRIA6 : MED_TRIA3, m_mesh.nodes_of_triangle());
    write_elements(m_mesh.lines, m_mesh.line_curves, 1, m_mesh.is_second_order ? MED_SEG3 : MED_SEG2, m_mesh.nodes_of_line());
    std::vector<std::array<std::size_t, 1>> points;
    for(const std::size_t node : m_mesh.points)
      points.push_back({{node}});
    write_elements(points, m_mesh.point_vertices, 0, MED_POINT1, 1);
    const med_err result = MEDfileClose(m_file);
    m_file = -1;
    check(result);
  }

private:
  void check(med_err result) const
  {
    if(result < 0)
      throw Parametric_surface_mesh_error("the MED library cannot write " + m_file_name);
  }

  // Words of one length, one after the other.
  static std::string padded(const std::vector<std::string>& words, std::size_t length)
  {
    std::string result;
    for(std::string word : words) {
      word.resize(length, word.empty() || length != std::size_t(MED_LNAME_SIZE) ? ' ' : '\0');
      result += word;
    }
    return result;
  }

  // Those of elements are negative, and different for all dimensions.
  med_int family(int dimension, std::size_t entity) const
  {
    const std::size_t before = dimension == 2 ? 0 : dimension == 1 ? m_mesh.surfaces.size() : m_mesh.surfaces.size() + m_mesh.curves.size();
    return -med_int(before + entity + 1);
  }

  void write_families()
  {
    check(MEDfamilyCr(m_file, m_name, "FAMILLE_ZERO", 0, 0, ""));
    for(const auto& entity : m_groups)
      write_family(family(entity.first.first, entity.first.second), entity.second);
    for(std::size_t v = 0; v < m_mesh.vertices.size(); ++v) // of nodes
      write_family(med_int(v) + 1, m_groups[{0, v}]);
  }

  void write_family(med_int number, const std::vector<std::string>& groups)
  {
    const std::string name = "family_" + std::to_string(number), all = padded(groups, std::size_t(MED_LNAME_SIZE));
    check(MEDfamilyCr(m_file, m_name, name.c_str(), number, med_int(groups.size()), all.c_str()));
  }

  void write_nodes()
  {
    std::vector<med_float> coordinates;
    for(const auto& p : m_mesh.nodes)
      coordinates.insert(coordinates.end(), p.begin(), p.end());
    check(MEDmeshNodeCoordinateWr(m_file, m_name, MED_NO_DT, MED_NO_IT, 0, MED_FULL_INTERLACE, med_int(m_mesh.nodes.size()), coordinates.data()));
    std::vector<med_int> families(m_mesh.nodes.size(), 0);
    for(std::size_t i = 0; i < m_mesh.points.size(); ++i)
      families[m_mesh.points[i]] = med_int(m_mesh.point_vertices[i]) + 1;
    check(MEDmeshEntityFamilyNumberWr(m_file, m_name, MED_NO_DT, MED_NO_IT, MED_NODE, MED_NONE, med_int(families.size()), families.data()));
  }

  template <class Element>
  void write_elements(const std::vector<Element>& elements, const std::vector<std::size_t>& entities, int dimension, med_geometry_type type,
                      std::size_t number_of_nodes)
  {
    if(elements.empty())
      return;
    std::vector<med_int> nodes, families;
    for(std::size_t i = 0; i < elements.size(); ++i) {
      for(std::size_t k = 0; k < number_of_nodes; ++k)
        nodes.push_back(med_int(elements[i][k]) + 1);
      families.push_back(family(dimension, entities[i]));
    }
    check(MEDmeshElementConnectivityWr(m_file, m_name, MED_NO_DT, MED_NO_IT, 0, MED_CELL, type, MED_NODAL, MED_FULL_INTERLACE,
                                       med_int(elements.size()), nodes.data()));
    check(MEDmeshEntityFamilyNumberWr(m_file, m_name, MED_NO_DT, MED_NO_IT, MED_CELL, type, med_int(families.size()), families.data()));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_MED_WRITER_H
