// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_MSH_WRITER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_MSH_WRITER_H

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Element_sets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Names in files of Gmsh are between quotation marks.
inline std::string msh_name(std::string name)
{
  const std::size_t max_length = 120; // of Gmsh, 128
  std::replace(name.begin(), name.end(), '"', '_');
  return one_line(name).substr(0, max_length);
}

// Writes files of Gmsh, version 4.1 or 2.2. A set of entities is a physical group; entities have the tags of the model, if no other one
// has them. There are no volumes: Gmsh does not mesh those of a file.
class Msh_writer
{
  typedef std::pair<int, std::size_t> Tag; // dimension and tag
  typedef Element_mesh_3::Place Place;

  std::ostream& m_out;
  const Element_mesh_3& m_mesh;
  const Elements_of_entities m_elements;
  const std::vector<Element_set> m_sets;
  const std::vector<Place> m_places;
  std::array<std::vector<std::size_t>, 3> m_tags; // by dimension and entity
  std::vector<std::size_t> m_set_tags;
  std::map<Tag, std::vector<std::size_t>> m_sets_of_entity; // by dimension and index: tags of sets

public:
  Msh_writer(std::ostream& out, const Element_mesh_3& mesh)
    : m_out(out), m_mesh(mesh), m_elements(mesh), m_sets(element_sets(mesh)), m_places(known_places(mesh)),
      m_tags{{unique_numbers(mesh.vertices), unique_numbers(mesh.curves), unique_numbers(mesh.surfaces)}}
  {
    std::array<std::size_t, 3> next{{1, 1, 1}}; // after the numbers of the model
    for(const auto& set : m_sets)
      next[std::size_t(set.dimension)] = (std::max)(next[std::size_t(set.dimension)], set.number + 1);
    for(const auto& set : m_sets) {
      m_set_tags.push_back(set.number > 0 ? set.number : next[std::size_t(set.dimension)]++);
      for(const std::size_t entity : set.entities)
        m_sets_of_entity[{set.dimension, entity}].push_back(m_set_tags.back());
    }
  }

  void write_version_4()
  {
    m_out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    write_physical_names();
    write_entities();
    write_nodes();
    write_elements();
  }

  // An element has one group, that of its face, edge or vertex.
  void write_version_2()
  {
    m_out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    write_physical_names();
    m_out << "$Nodes\n" << m_mesh.nodes.size() << '\n';
    for(std::size_t i = 0; i < m_mesh.nodes.size(); ++i) {
      m_out << i + 1;
      write_point(m_mesh.nodes[i]);
      m_out << '\n';
    }
    m_out << "$EndNodes\n$Elements\n" << number_of_elements() << '\n';
    for_each_block([&](int dimension, std::size_t entity, int type, std::size_t first, const auto& elements, const auto& nodes) {
      for(const std::size_t i : elements) {
        m_out << first + i << ' ' << type << " 2 " << m_sets_of_entity[{dimension, entity}].front() << ' '
              << m_tags[std::size_t(dimension)][entity];
        nodes(i);
      }
    });
    m_out << "$EndElements\n";
  }

private:
  std::size_t number_of_elements() const { return m_mesh.triangles.size() + m_mesh.lines.size() + m_mesh.points.size(); }

  void write_point(const Element_mesh_3::Point& p) { m_out << ' ' << p[0] << ' ' << p[1] << ' ' << p[2]; }

  void write_physical_names()
  {
    Unique_names names[3] = {Unique_names(msh_name), Unique_names(msh_name), Unique_names(msh_name)};
    m_out << "$PhysicalNames\n" << m_sets.size() << '\n';
    for(std::size_t i = 0; i < m_sets.size(); ++i)
      m_out << m_sets[i].dimension << ' ' << m_set_tags[i] << " \"" << names[m_sets[i].dimension](m_sets[i].name) << "\"\n";
    m_out << "$EndPhysicalNames\n";
  }

  // Calls `write(dimension, entity, type, first, elements, nodes)` for each entity with elements: element `i` has the number
  // `first + i`, and `nodes(i)` writes its nodes.
  template <class Function>
  void for_each_block(const Function& write)
  {
    const int type_of_point = 15, type_of_line = m_mesh.is_second_order ? 8 : 1, type_of_triangle = m_mesh.is_second_order ? 9 : 2;
    const std::size_t first_line = m_mesh.triangles.size() + 1, first_point = first_line + m_mesh.lines.size();
    const auto write_nodes_of = [&](const auto& nodes, std::size_t number) {
      for(std::size_t k = 0; k < number; ++k)
        m_out << ' ' << nodes[k] + 1;
      m_out << '\n';
    };
    const auto write_all = [&](int dimension, int type, std::size_t first, const auto& elements, const auto& nodes) {
      for(std::size_t entity = 0; entity < elements.size(); ++entity)
        if(!elements[entity].empty())
          write(dimension, entity, type, first, elements[entity], nodes);
    };
    write_all(0, type_of_point, first_point, m_elements.points, [&](std::size_t i) { write_nodes_of(std::array<std::size_t, 1>{{m_mesh.points[i]}}, 1); });
    write_all(1, type_of_line, first_line, m_elements.lines, [&](std::size_t i) { write_nodes_of(m_mesh.lines[i], m_mesh.nodes_of_line()); });
    write_all(2, type_of_triangle, 1, m_elements.triangles,
              [&](std::size_t i) { write_nodes_of(m_mesh.triangles[i], m_mesh.nodes_of_triangle()); });
  }

  void write_box(int dimension, std::size_t entity)
  {
    const double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 6> box{{infinity, infinity, infinity, -infinity, -infinity, -infinity}};
    for(const std::size_t node : m_elements.nodes({"", dimension, {entity}, 0}))
      for(std::size_t i = 0; i < 3; ++i) {
        box[i] = (std::min)(box[i], m_mesh.nodes[node][i]);
        box[3 + i] = (std::max)(box[3 + i], m_mesh.nodes[node][i]);
      }
    for(const double x : box)
      m_out << ' ' << (std::isfinite(x) ? x : 0);
  }

  void write_sets(int dimension, std::size_t entity)
  {
    const auto& sets = m_sets_of_entity[{dimension, entity}];
    m_out << ' ' << sets.size();
    for(const std::size_t set : sets)
      m_out << ' ' << set;
  }

  void write_entities()
  {
    m_out << "$Entities\n" << m_mesh.vertices.size() << ' ' << m_mesh.curves.size() << ' ' << m_mesh.surfaces.size() << " 0\n";
    for(std::size_t v = 0; v < m_mesh.vertices.size(); ++v) {
      m_out << m_tags[0][v];
      write_point(m_elements.points[v].empty() ? Element_mesh_3::Point{{0, 0, 0}} : m_mesh.nodes[m_mesh.points[m_elements.points[v].front()]]);
      write_sets(0, v);
      m_out << '\n';
    }
    write_entities_with_boundary(1, ends_of_curves());
    write_entities_with_boundary(2, curves_of_surfaces());
    m_out << "$EndEntities\n";
  }

  void write_entities_with_boundary(int dimension, const std::vector<std::set<std::pair<std::size_t, int>>>& boundaries)
  {
    const auto& tags = m_tags[std::size_t(dimension)];
    for(std::size_t i = 0; i < tags.size(); ++i) {
      m_out << tags[i];
      write_box(dimension, i);
      write_sets(dimension, i);
      m_out << ' ' << boundaries[i].size();
      for(const auto& bound : boundaries[i])
        m_out << ' ' << (bound.second < 0 ? "-" : "") << m_tags[std::size_t(dimension) - 1][bound.first];
      m_out << '\n';
    }
  }

  // For each curve its vertices: where it begins, with a plus, and where it ends, with a minus.
  std::vector<std::set<std::pair<std::size_t, int>>> ends_of_curves() const
  {
    std::vector<std::set<std::pair<std::size_t, int>>> result(m_mesh.curves.size());
    for(std::size_t i = 0; i < m_mesh.lines.size(); ++i)
      for(std::size_t k = 0; k < 2; ++k) {
        const Place& place = m_places[m_mesh.lines[i][k]];
        if(place.dimension == 0)
          result[m_mesh.line_curves[i]].insert({place.entity, k == 0 ? 1 : -1});
      }
    return result;
  }

  // For each surface the curves around it, with a minus if their lines go the other way than the sides of its triangles. A seam
  // goes both ways.
  std::vector<std::set<std::pair<std::size_t, int>>> curves_of_surfaces() const
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> curves; // by both ends of a line
    for(std::size_t i = 0; i < m_mesh.lines.size(); ++i)
      curves[{m_mesh.lines[i][0], m_mesh.lines[i][1]}] = m_mesh.line_curves[i];
    std::vector<std::set<std::pair<std::size_t, int>>> result(m_mesh.surfaces.size());
    for(std::size_t i = 0; i < m_mesh.triangles.size(); ++i)
      for(std::size_t k = 0; k < 3; ++k)
        for(int sign : {1, -1}) {
          const std::size_t a = m_mesh.triangles[i][k], b = m_mesh.triangles[i][(k + 1) % 3];
          const auto found = curves.find(sign > 0 ? std::make_pair(a, b) : std::make_pair(b, a));
          if(found != curves.end())
            result[m_mesh.triangle_surfaces[i]].insert({found->second, sign});
        }
    return result;
  }

  // Nodes of an entity whose parameters are known, and others, are in blocks of their own.
  void write_nodes()
  {
    std::map<std::tuple<int, std::size_t, bool>, std::vector<std::size_t>> blocks;
    for(std::size_t i = 0; i < m_places.size(); ++i) {
      const Place& place = m_places[i];
      const bool is_parametric = place.dimension > 0 && std::isfinite(place.u) && (place.dimension == 1 || std::isfinite(place.v));
      if(place.entity != Element_mesh_3::none)
        blocks[{place.dimension, place.entity, is_parametric}].push_back(i);
    }
    std::size_t number_of_nodes = 0;
    for(const auto& block : blocks)
      number_of_nodes += block.second.size();
    m_out << "$Nodes\n" << blocks.size() << ' ' << number_of_nodes << " 1 " << m_mesh.nodes.size() << '\n';
    for(const auto& block : blocks) {
      const int dimension = std::get<0>(block.first);
      const bool is_parametric = std::get<2>(block.first);
      m_out << dimension << ' ' << m_tags[std::size_t(dimension)][std::get<1>(block.first)] << ' ' << is_parametric << ' ' << block.second.size()
            << '\n';
      for(const std::size_t i : block.second)
        m_out << i + 1 << '\n';
      for(const std::size_t i : block.second) {
        const auto& p = m_mesh.nodes[i];
        m_out << p[0] << ' ' << p[1] << ' ' << p[2];
        if(is_parametric)
          m_out << ' ' << m_places[i].u;
        if(is_parametric && dimension == 2)
          m_out << ' ' << m_places[i].v;
        m_out << '\n';
      }
    }
    m_out << "$EndNodes\n";
  }

  void write_elements()
  {
    std::size_t number_of_blocks = 0;
    for(const auto* entities : {&m_elements.points, &m_elements.lines, &m_elements.triangles})
      for(const auto& elements : *entities)
        number_of_blocks += !elements.empty();
    m_out << "$Elements\n" << number_of_blocks << ' ' << number_of_elements() << " 1 " << number_of_elements() << '\n';
    for_each_block([&](int dimension, std::size_t entity, int type, std::size_t first, const auto& elements, const auto& nodes) {
      m_out << dimension << ' ' << m_tags[std::size_t(dimension)][entity] << ' ' << type << ' ' << elements.size() << '\n';
      for(const std::size_t i : elements) {
        m_out << first + i;
        nodes(i);
      }
    });
    m_out << "$EndElements\n";
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_MSH_WRITER_H
