// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_ENTITIES_OF_SHAPE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_ENTITIES_OF_SHAPE_H

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Open_cascade_names_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// For each face of the model the smallest part that it belongs to, or `none`. A face that two solids share is in the model twice,
// in the shell of either.
inline std::vector<std::size_t> parts_of_model_faces(const Open_cascade_model_3& shape, const Open_cascade_names_3& names)
{
  const std::size_t none = Open_cascade_names_3::none;
  const auto parts_of_faces = names.parts_of_faces(), parts_of_shells = names.parts_of_shells();
  std::vector<std::size_t> result;
  for(std::size_t f = 0; f < shape.shape_faces.size(); ++f) {
    const std::size_t shell = shape.model.faces()[f].shell, face = shape.shape_faces[f];
    result.push_back(shell < parts_of_shells.size() ? parts_of_shells[shell] : none);
    if(result.back() == none && face < parts_of_faces.size())
      result.back() = parts_of_faces[face];
  }
  return result;
}

// For each edge of the model the first edge of the shape that it is a part of, or `none`.
inline std::vector<std::size_t> shape_edges_of_model(const Open_cascade_model_3& shape)
{
  std::vector<std::size_t> result(shape.model.edges().size(), Open_cascade_model_3::none);
  for(std::size_t e = shape.model_edges.size(); e-- > 0;)
    for(const std::size_t edge : shape.model_edges[e])
      result[edge] = e;
  return result;
}

// Six hexadecimal digits, two for each of red, green and blue.
inline std::string hexadecimal(const Open_cascade_names_3::Color& color)
{
  char text[7];
  const auto byte = [](double value) { return unsigned((std::min)((std::max)(255 * value + 0.5, 0.), 255.)); };
  std::snprintf(text, sizeof(text), "%02x%02x%02x", byte(color.red), byte(color.green), byte(color.blue));
  return text;
}

// The name of a part, or its path if others have the name, too.
inline std::string short_name(const Open_cascade_names_3& names, std::size_t part)
{
  const auto own_name = [](const Open_cascade_names_3::Part& p) -> const std::string& { return p.instance.empty() ? p.name : p.instance; };
  const std::string& name = own_name(names.parts[part]);
  const auto has_same = [&](const auto& other) { return own_name(other) == name; };
  return std::count_if(names.parts.begin(), names.parts.end(), has_same) > 1 ? names.parts[part].path : name;
}

// The faces, edges and vertices of a shape as entities of an element mesh, in the order in which they are first asked for.
class Entities_of_shape
{
  typedef std::pair<std::size_t, std::size_t> Key; // index in the shape, and in the list of parts of the mesh

  const Open_cascade_names_3& m_names;
  Element_mesh_3& m_mesh;
  std::map<std::size_t, std::size_t> m_parts; // by index in the names
  std::map<Key, std::size_t> m_surfaces;
  std::map<std::size_t, std::size_t> m_vertices, m_curves; // by index in the shape

public:
  Entities_of_shape(const Open_cascade_names_3& names, Element_mesh_3& mesh) : m_names(names), m_mesh(mesh) {}

  // `part`: in the names, or `none`
  std::size_t surface(std::size_t shape_face, std::size_t part)
  {
    const std::size_t own_part = part_of_mesh(part);
    const auto found = add(m_surfaces, Key(shape_face, own_part), shape_face, own_part, m_names.face_names, m_mesh.surfaces);
    auto& color = m_mesh.surfaces[found].color;
    if(shape_face < m_names.face_colors.size() && m_names.face_colors[shape_face])
      color = m_names.face_colors[shape_face];
    else if(own_part != Element_mesh_3::none)
      color = m_mesh.parts[own_part].color;
    return found;
  }

  // The part that the other sides of the triangles of a surface belong to.
  void set_part_in_front(std::size_t surface, std::size_t part) { m_mesh.surfaces[surface].parts[1] = part_of_mesh(part); }

  // Of the part of a surface beside it.
  std::size_t curve(std::size_t shape_edge, std::size_t surface)
  {
    return add(m_curves, shape_edge, shape_edge, m_mesh.surfaces[surface].parts[0], m_names.edge_names, m_mesh.curves);
  }

  std::size_t vertex(std::size_t shape_vertex, std::size_t surface)
  {
    return add(m_vertices, shape_vertex, shape_vertex, m_mesh.surfaces[surface].parts[0], m_names.vertex_names, m_mesh.vertices);
  }

  void add_groups()
  {
    add_groups_of(m_mesh.surfaces, 2);
    add_groups_of(m_mesh.curves, 1);
    add_groups_of(m_mesh.vertices, 0);
    std::map<std::string, std::vector<std::size_t>> colors, layers;
    for(std::size_t s = 0; s < m_mesh.surfaces.size(); ++s) {
      if(m_mesh.surfaces[s].color)
        colors["color_" + hexadecimal(*m_mesh.surfaces[s].color)].push_back(s);
      for(const std::string& layer : layers_of(s))
        layers["layer_" + layer].push_back(s);
    }
    for(const auto* groups : {&colors, &layers})
      for(const auto& group : *groups)
        m_mesh.groups.push_back({group.first, 2, group.second});
    add_assemblies();
  }

private:
  std::size_t part_of_mesh(std::size_t part)
  {
    if(part == Open_cascade_names_3::none)
      return Element_mesh_3::none;
    const auto found = m_parts.emplace(part, m_mesh.parts.size());
    if(found.second)
      m_mesh.parts.push_back({part + 1, short_name(m_names, part), m_names.parts[part].color});
    return found.first->second;
  }

  template <class KeyOfEntity>
  static std::size_t add(std::map<KeyOfEntity, std::size_t>& known, const KeyOfEntity& key, std::size_t index, std::size_t part,
                         const std::vector<std::string>& names, std::vector<Element_mesh_3::Entity>& entities)
  {
    const auto found = known.emplace(key, entities.size());
    if(found.second) {
      Element_mesh_3::Entity entity;
      entity.number = index + 1;
      entity.parts[0] = part;
      if(index < names.size())
        entity.name = names[index];
      entities.push_back(entity);
    }
    return found.first->second;
  }

  void add_groups_of(const std::vector<Element_mesh_3::Entity>& entities, int dimension)
  {
    std::map<std::string, std::vector<std::size_t>> groups;
    for(std::size_t i = 0; i < entities.size(); ++i)
      if(!entities[i].name.empty())
        groups[entities[i].name].push_back(i);
    for(const auto& group : groups)
      m_mesh.groups.push_back({group.first, dimension, group.second});
  }

  std::vector<std::string> layers_of(std::size_t surface) const
  {
    const auto& entity = m_mesh.surfaces[surface];
    std::vector<std::string> result;
    if(entity.number <= m_names.face_layers.size())
      result = m_names.face_layers[entity.number - 1];
    if(entity.parts[0] != Element_mesh_3::none)
      for(std::size_t p = m_mesh.parts[entity.parts[0]].number - 1; p != Open_cascade_names_3::none; p = m_names.parts[p].parent)
        for(const std::string& layer : m_names.parts[p].layers)
          if(std::find(result.begin(), result.end(), layer) == result.end())
            result.push_back(layer);
    return result;
  }

  // Groups of parts for assemblies that consist of several.
  void add_assemblies()
  {
    std::map<std::size_t, std::vector<std::size_t>> assemblies;
    for(std::size_t i = 0; i < m_mesh.parts.size(); ++i)
      for(std::size_t p = m_mesh.parts[i].number - 1; (p = m_names.parts[p].parent) != Open_cascade_names_3::none;)
        assemblies[p].push_back(i);
    for(const auto& assembly : assemblies)
      if(assembly.second.size() > 1)
        m_mesh.groups.push_back({short_name(m_names, assembly.first), 3, assembly.second});
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_ENTITIES_OF_SHAPE_H
