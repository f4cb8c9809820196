// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_PART_BUILDER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_PART_BUILDER_H

#include <CGAL/Open_cascade_names_3.h>

#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The solids, shells, faces, edges and vertices of a shape, with their indices.
struct Shape_index
{
  TopTools_IndexedMapOfShape solids, shells, faces, edges, vertices;

  explicit Shape_index(const TopoDS_Shape& shape)
  {
    TopExp::MapShapes(shape, TopAbs_SOLID, solids);
    TopExp::MapShapes(shape, TopAbs_SHELL, shells);
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
  }

  // The indices of all shapes of a kind in a part of the shape, in ascending order.
  static std::vector<std::size_t> members(const TopTools_IndexedMapOfShape& index, const TopoDS_Shape& part, TopAbs_ShapeEnum kind)
  {
    std::set<std::size_t> result;
    for(TopExp_Explorer member(part, kind); member.More(); member.Next()) {
      const int i = index.FindIndex(member.Current());
      if(i > 0)
        result.insert(std::size_t(i) - 1);
    }
    return {result.begin(), result.end()};
  }
};

// Builds the parts of a shape: those that a file tells of, and below a part with several bodies (solids, shells outside of solids,
// faces outside of shells) one for each of these.
class Part_builder
{
  typedef Open_cascade_names_3::Part Part;

  const Shape_index& m_index;
  Open_cascade_names_3& m_names;
  std::set<std::string> m_paths;

public:
  Part_builder(const Shape_index& index, Open_cascade_names_3& names) : m_index(index), m_names(names)
  {
    m_names.solid_names.resize(std::size_t(index.solids.Extent()));
    m_names.shell_names.resize(std::size_t(index.shells.Extent()));
    m_names.face_names.resize(std::size_t(index.faces.Extent()));
    m_names.edge_names.resize(std::size_t(index.edges.Extent()));
    m_names.vertex_names.resize(std::size_t(index.vertices.Extent()));
    m_names.face_colors.resize(m_names.face_names.size());
    m_names.edge_colors.resize(m_names.edge_names.size());
    m_names.face_layers.resize(m_names.face_names.size());
  }

  // Adds a part without its contents, and returns its index. Siblings of the same name get numbers in their paths.
  std::size_t add(Part part)
  {
    const std::string path = (part.parent == Open_cascade_names_3::none ? "" : m_names.parts[part.parent].path + "/")
                             + (part.instance.empty() ? part.name : part.instance);
    part.path = path;
    for(std::size_t i = 2; !m_paths.insert(part.path).second; ++i)
      part.path = path + "#" + std::to_string(i);
    m_names.parts.push_back(std::move(part));
    return m_names.parts.size() - 1;
  }

  // Adds a shape to the contents of a part and of all that it belongs to, and its bodies as parts, if there are several.
  void fill(std::size_t part, const TopoDS_Shape& shape)
  {
    add_contents(part, shape);
    const auto solids = Shape_index::members(m_index.solids, shape, TopAbs_SOLID);
    std::vector<TopoDS_Shape> shells, faces;
    for(TopExp_Explorer shell(shape, TopAbs_SHELL, TopAbs_SOLID); shell.More(); shell.Next())
      shells.push_back(shell.Current());
    for(TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SHELL); face.More(); face.Next())
      faces.push_back(face.Current());
    if(solids.size() + shells.size() + (faces.empty() ? 0 : 1) < 2)
      return;
    for(const std::size_t solid : solids)
      add_body(part, name_of_body(m_names.solid_names[solid], "solid_", solid), m_index.solids(int(solid) + 1));
    for(const TopoDS_Shape& shell : shells) {
      const int number = m_index.shells.FindIndex(shell);
      if(number > 0)
        add_body(part, name_of_body(m_names.shell_names[std::size_t(number) - 1], "shell_", std::size_t(number) - 1), shell);
    }
    if(!faces.empty()) {
      const std::size_t rest = add(body_of(part, "faces"));
      for(const TopoDS_Shape& face : faces)
        add_contents(rest, face);
    }
  }

  // A part for the faces that no part has, if there are any.
  void add_rest()
  {
    const auto parts = m_names.parts_of_faces();
    std::size_t rest = Open_cascade_names_3::none;
    for(std::size_t f = 0; f < parts.size(); ++f)
      if(parts[f] == Open_cascade_names_3::none) {
        if(rest == Open_cascade_names_3::none) {
          Part part;
          part.name = "others";
          rest = add(std::move(part));
        }
        m_names.parts[rest].faces.push_back(f);
      }
  }

private:
  static std::string name_of_body(const std::string& given, const char* kind, std::size_t index)
  {
    return given.empty() ? kind + std::to_string(index + 1) : given;
  }

  Part body_of(std::size_t parent, const std::string& name) const
  {
    Part result;
    result.name = name;
    result.parent = parent;
    result.location = m_names.parts[parent].location;
    return result;
  }

  void add_body(std::size_t parent, const std::string& name, const TopoDS_Shape& shape)
  {
    const std::size_t body = add(body_of(parent, name));
    add_contents(body, shape);
  }

  void add_contents(std::size_t part, const TopoDS_Shape& shape)
  {
    const auto solids = Shape_index::members(m_index.solids, shape, TopAbs_SOLID),
               shells = Shape_index::members(m_index.shells, shape, TopAbs_SHELL),
               faces = Shape_index::members(m_index.faces, shape, TopAbs_FACE);
    for(; part != Open_cascade_names_3::none; part = m_names.parts[part].parent) {
      merge(m_names.parts[part].solids, solids);
      merge(m_names.parts[part].shells, shells);
      merge(m_names.parts[part].faces, faces);
    }
  }

  static void merge(std::vector<std::size_t>& all, const std::vector<std::size_t>& more)
  {
    std::vector<std::size_t> result;
    std::set_union(all.begin(), all.end(), more.begin(), more.end(), std::back_inserter(result));
    all.swap(result);
  }
};

// The names of a shape of which nothing but the geometry is known: its root, and its bodies with their numbers.
inline Open_cascade_names_3 names_of_bodies(const TopoDS_Shape& shape, const std::string& root_name)
{
  const Shape_index index(shape);
  Open_cascade_names_3 result;
  Part_builder builder(index, result);
  Open_cascade_names_3::Part root;
  root.name = root_name;
  const std::size_t number = builder.add(std::move(root));
  builder.fill(number, shape);
  result.parts.front().is_assembly = result.parts.size() > 1;
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_PART_BUILDER_H
