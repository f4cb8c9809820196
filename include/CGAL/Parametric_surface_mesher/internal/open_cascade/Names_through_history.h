// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_NAMES_THROUGH_HISTORY_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_NAMES_THROUGH_HISTORY_H

#include <CGAL/Open_cascade_names_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Part_builder.h>

#include <BRepTools_History.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The names of a shape that was made of another one.
class Names_through_history
{
  typedef std::vector<std::vector<std::size_t>> Images; // by index before: the indices after

  const Open_cascade_names_3& m_names;
  const Shape_index m_before, m_after;
  opencascade::handle<BRepTools_History> m_history;

public:
  Names_through_history(const Open_cascade_names_3& names, const TopoDS_Shape& before,
                        const opencascade::handle<BRepTools_History>& history, const TopoDS_Shape& after)
    : m_names(names), m_before(before), m_after(after), m_history(history)
  {}

  Open_cascade_names_3 operator()() const
  {
    Open_cascade_names_3 result;
    result.parts = m_names.parts;
    result.unit = m_names.unit;
    result.faults = m_names.faults;
    const Images solids = images(m_before.solids, m_after.solids), faces = images(m_before.faces, m_after.faces),
                 edges = images(m_before.edges, m_after.edges);
    carry_over(m_names.solid_names, solids, m_after.solids, result.solid_names);
    carry_over(m_names.face_names, faces, m_after.faces, result.face_names);
    carry_over(m_names.edge_names, edges, m_after.edges, result.edge_names);
    carry_over(m_names.vertex_names, images(m_before.vertices, m_after.vertices), m_after.vertices, result.vertex_names);
    carry_over(m_names.face_colors, faces, m_after.faces, result.face_colors);
    carry_over(m_names.edge_colors, edges, m_after.edges, result.edge_colors);
    carry_over(m_names.face_layers, faces, m_after.faces, result.face_layers);
    result.shell_names.resize(std::size_t(m_after.shells.Extent())); // histories do not tell of shells
    for(auto& part : result.parts) {
      part.faces = images(faces, part.faces);
      part.solids = images(solids, part.solids);
      if(part.solids.empty()) // else one that fills a cavity of this part would be taken for it
        part.solids = bodies_of(m_after.solids, part.faces);
      part.shells = shells_of(part.solids, bodies_of(m_after.shells, part.faces));
    }
    return result;
  }

private:
  // An operation that does not know a shape may have left it as it is.
  Images images(const TopTools_IndexedMapOfShape& before, const TopTools_IndexedMapOfShape& after) const
  {
    Images result(std::size_t(before.Extent()));
    for(int i = 1; i <= before.Extent(); ++i) {
      const auto add_image = [&](const TopoDS_Shape& image) {
        const int index = after.FindIndex(image);
        if(index > 0)
          result[std::size_t(i) - 1].push_back(std::size_t(index) - 1);
      };
      if(m_history.IsNull() || m_history->Modified(before(i)).IsEmpty())
        add_image(before(i));
      else
        for(const TopoDS_Shape& image : m_history->Modified(before(i)))
          add_image(image);
    }
    return result;
  }

  template <class T>
  static void carry_over(const std::vector<T>& before, const Images& images, const TopTools_IndexedMapOfShape& shapes, std::vector<T>& after)
  {
    after.resize(std::size_t(shapes.Extent()));
    for(std::size_t i = 0; i < (std::min)(before.size(), images.size()); ++i)
      for(const std::size_t image : images[i])
        if(after[image] == T())
          after[image] = before[i];
  }

  static std::vector<std::size_t> images(const Images& images, const std::vector<std::size_t>& indices)
  {
    std::set<std::size_t> result;
    for(const std::size_t i : indices)
      if(i < images.size())
        result.insert(images[i].begin(), images[i].end());
    return {result.begin(), result.end()};
  }

  // The indices of the solids, or shells, with faces among some, and no others.
  std::vector<std::size_t> bodies_of(const TopTools_IndexedMapOfShape& bodies, const std::vector<std::size_t>& faces) const
  {
    std::vector<std::size_t> result;
    for(int i = 1; i <= bodies.Extent(); ++i) {
      const auto own = Shape_index::members(m_after.faces, bodies(i), TopAbs_FACE);
      if(!own.empty() && std::includes(faces.begin(), faces.end(), own.begin(), own.end()))
        result.push_back(std::size_t(i) - 1);
    }
    return result;
  }

  // The shells of some solids, and those among `candidates` that no solid has.
  std::vector<std::size_t> shells_of(const std::vector<std::size_t>& solids, const std::vector<std::size_t>& candidates) const
  {
    std::set<std::size_t> result, in_any_solid;
    for(int i = 1; i <= m_after.solids.Extent(); ++i)
      for(std::size_t shell : Shape_index::members(m_after.shells, m_after.solids(i), TopAbs_SHELL)) {
        in_any_solid.insert(shell);
        if(std::binary_search(solids.begin(), solids.end(), std::size_t(i) - 1))
          result.insert(shell);
      }
    for(std::size_t shell : candidates)
      if(in_any_solid.count(shell) == 0)
        result.insert(shell);
    return {result.begin(), result.end()};
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_NAMES_THROUGH_HISTORY_H
