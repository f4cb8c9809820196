// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_ELEMENT_SETS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_ELEMENT_SETS_H

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

inline void check_indices(const std::vector<std::size_t>& indices, std::size_t number, const char* what)
{
  for(const std::size_t i : indices)
    if(i >= number)
      throw Parametric_surface_mesh_error("an element mesh has no " + std::string(what) + " of index " + std::to_string(i) + "; there are "
                                          + std::to_string(number));
}

// Refuses arrays that do not fit together.
inline void check_element_mesh(const Element_mesh_3& mesh)
{
  if(mesh.triangle_surfaces.size() != mesh.triangles.size() || mesh.line_curves.size() != mesh.lines.size()
     || mesh.point_vertices.size() != mesh.points.size() || (!mesh.places.empty() && mesh.places.size() != mesh.nodes.size()))
    throw Parametric_surface_mesh_error("the arrays of an element mesh have sizes that do not fit together");
  check_indices(mesh.triangle_surfaces, mesh.surfaces.size(), "surface");
  check_indices(mesh.line_curves, mesh.curves.size(), "curve");
  check_indices(mesh.point_vertices, mesh.vertices.size(), "vertex");
  check_indices(mesh.points, mesh.nodes.size(), "node");
  for(const auto& triangle : mesh.triangles)
    check_indices({triangle.begin(), triangle.begin() + std::ptrdiff_t(mesh.nodes_of_triangle())}, mesh.nodes.size(), "node");
  for(const auto& line : mesh.lines)
    check_indices({line.begin(), line.begin() + std::ptrdiff_t(mesh.nodes_of_line())}, mesh.nodes.size(), "node");
}

// Elements by entity: [i] are the indices of those of the i-th entity.
inline std::vector<std::vector<std::size_t>> elements_of(const std::vector<std::size_t>& entities, std::size_t number)
{
  std::vector<std::vector<std::size_t>> result(number);
  for(std::size_t i = 0; i < entities.size(); ++i)
    result[entities[i]].push_back(i);
  return result;
}

// A name without the ends of lines and other characters that have no picture.
inline std::string one_line(std::string name)
{
  for(char& c : name)
    if(c >= 0 && c < ' ')
      c = '_';
  return name;
}

// A name with an underscore for each letter of UTF-8 that is not one of ASCII.
inline std::string ascii_name(const std::string& name)
{
  std::string result;
  for(const char c : name) {
    const unsigned char byte = static_cast<unsigned char>(c);
    if(byte < 0x80 || byte >= 0xc0) // the first one of a letter
      result += byte < 0x80 ? c : '_';
  }
  return result;
}

// Names that are all different. `allowed` makes of a name one that the format bears.
class Unique_names
{
  std::function<std::string(const std::string&)> m_allowed;
  std::set<std::string> m_used;

public:
  explicit Unique_names(std::function<std::string(const std::string&)> allowed) : m_allowed(std::move(allowed)) {}

  std::string operator()(const std::string& name)
  {
    const std::string first = m_allowed(name);
    std::string result = first;
    for(std::size_t i = 2; !m_used.insert(result).second; ++i)
      result = first + "_" + std::to_string(i);
    return result;
  }
};

// A set of entities of one dimension that files have under one name; of dimension 2 it may stand for a part.
struct Element_set
{
  std::string name;
  int dimension;
  std::vector<std::size_t> entities;
  std::size_t number; // in the model if it is a face, an edge or a vertex of it, else 0
};

// Adds sets like "face_3" with all entities of one number.
inline void add_sets_by_number(const std::vector<Element_mesh_3::Entity>& entities, int dimension, const std::string& kind,
                               std::vector<Element_set>& sets)
{
  std::map<std::size_t, std::vector<std::size_t>> by_number;
  for(std::size_t i = 0; i < entities.size(); ++i)
    by_number[entities[i].number].push_back(i);
  for(const auto& entry : by_number)
    sets.push_back({kind + "_" + std::to_string(entry.first), dimension, entry.second, entry.first});
}

// The surfaces of some parts.
inline std::vector<std::size_t> surfaces_of_parts(const Element_mesh_3& mesh, const std::vector<std::size_t>& parts)
{
  std::vector<std::size_t> result;
  for(std::size_t s = 0; s < mesh.surfaces.size(); ++s)
    for(const std::size_t part : mesh.surfaces[s].parts)
      if(part != Element_mesh_3::none && std::find(parts.begin(), parts.end(), part) != parts.end()) {
        result.push_back(s);
        break;
      }
  return result;
}

// All sets of a mesh: faces, edges and vertices by their numbers, parts (as sets of surfaces), and groups.
inline std::vector<Element_set> element_sets(const Element_mesh_3& mesh)
{
  std::vector<Element_set> result;
  add_sets_by_number(mesh.surfaces, 2, "face", result);
  add_sets_by_number(mesh.curves, 1, "edge", result);
  add_sets_by_number(mesh.vertices, 0, "vertex", result);
  for(std::size_t p = 0; p < mesh.parts.size(); ++p)
    result.push_back({mesh.parts[p].name, 2, surfaces_of_parts(mesh, {p}), 0});
  for(const auto& group : mesh.groups)
    result.push_back({group.name, (std::min)(group.dimension, 2),
                      group.dimension == 3 ? surfaces_of_parts(mesh, group.entities) : group.entities, 0});
  return result;
}

// For each entity of a dimension a number of its own: that of the model, if no other entity before it has it.
inline std::vector<std::size_t> unique_numbers(const std::vector<Element_mesh_3::Entity>& entities)
{
  std::size_t next = 1;
  for(const auto& entity : entities)
    next = (std::max)(next, entity.number + 1);
  std::set<std::size_t> used;
  std::vector<std::size_t> result;
  for(const auto& entity : entities)
    result.push_back(entity.number > 0 && used.insert(entity.number).second ? entity.number : next++);
  return result;
}

// Where each node lies. Nodes of unknown places are on the curve or the surface of one of their elements.
inline std::vector<Element_mesh_3::Place> known_places(const Element_mesh_3& mesh)
{
  std::vector<Element_mesh_3::Place> result(mesh.nodes.size());
  if(!mesh.places.empty())
    result = mesh.places;
  const auto set = [&](std::size_t node, int dimension, std::size_t entity) {
    if(result[node].entity == Element_mesh_3::none) {
      result[node] = Element_mesh_3::Place();
      result[node].dimension = dimension;
      result[node].entity = entity;
    }
  };
  for(std::size_t i = 0; i < mesh.points.size(); ++i)
    set(mesh.points[i], 0, mesh.point_vertices[i]);
  for(std::size_t i = 0; i < mesh.lines.size(); ++i)
    for(std::size_t k = 0; k < mesh.nodes_of_line(); ++k)
      set(mesh.lines[i][k], 1, mesh.line_curves[i]);
  for(std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for(std::size_t k = 0; k < mesh.nodes_of_triangle(); ++k)
      set(mesh.triangles[i][k], 2, mesh.triangle_surfaces[i]);
  return result;
}

// The elements of each entity.
class Elements_of_entities
{
  const Element_mesh_3& m_mesh;

public:
  std::vector<std::vector<std::size_t>> points, lines, triangles;

  explicit Elements_of_entities(const Element_mesh_3& mesh)
    : m_mesh(mesh), points(elements_of(mesh.point_vertices, mesh.vertices.size())), lines(elements_of(mesh.line_curves, mesh.curves.size())),
      triangles(elements_of(mesh.triangle_surfaces, mesh.surfaces.size()))
  {}

  // The nodes of a set, in ascending order.
  std::vector<std::size_t> nodes(const Element_set& set) const
  {
    std::set<std::size_t> result;
    for(const std::size_t entity : set.entities)
      if(set.dimension == 0)
        for(const std::size_t i : points[entity])
          result.insert(m_mesh.points[i]);
      else if(set.dimension == 1)
        for(const std::size_t i : lines[entity])
          result.insert(m_mesh.lines[i].begin(), m_mesh.lines[i].begin() + std::ptrdiff_t(m_mesh.nodes_of_line()));
      else
        for(const std::size_t i : triangles[entity])
          result.insert(m_mesh.triangles[i].begin(), m_mesh.triangles[i].begin() + std::ptrdiff_t(m_mesh.nodes_of_triangle()));
    return {result.begin(), result.end()};
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_ELEMENT_SETS_H
