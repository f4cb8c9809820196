// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_PAGE_NAMES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_PAGE_NAMES_H

#include <CGAL/Mesh_page_3.h>
#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Open_cascade_names_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Entities_of_shape.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Carries the names of a shape over to the page of its mesh.
class Page_names
{
  const Open_cascade_model_3& m_shape;
  const Open_cascade_names_3& m_names;
  Mesh_page_3& m_page;
  std::map<std::size_t, std::size_t> m_parts; // indices in the page by those in the names

public:
  Page_names(const Open_cascade_model_3& shape, const Open_cascade_names_3& names, Mesh_page_3& page)
    : m_shape(shape), m_names(names), m_page(page)
  {}

  void operator()()
  {
    name_faces();
    number_lines();
    add_missing_faces();
  }

private:
  static std::optional<Mesh_page_3::Color> color_of(const std::optional<Open_cascade_names_3::Color>& color)
  {
    if(!color)
      return std::nullopt;
    return Mesh_page_3::Color{{color->red, color->green, color->blue}};
  }

  void name_faces()
  {
    const auto parts = parts_of_model_faces(m_shape, m_names);
    for(std::size_t f = 0; f < m_page.faces.size(); ++f) {
      Mesh_page_3::Face& face = m_page.faces[f];
      const std::size_t shape_face = m_shape.shape_faces[f];
      face.number = shape_face + 1;
      if(shape_face < m_names.face_names.size())
        face.name = m_names.face_names[shape_face];
      if(shape_face < m_names.face_colors.size())
        face.color = color_of(m_names.face_colors[shape_face]);
      if(parts[f] != Open_cascade_names_3::none)
        face.part = part_of_page(parts[f]);
    }
  }

  std::size_t part_of_page(std::size_t part)
  {
    const auto found = m_parts.emplace(part, m_page.parts.size());
    if(found.second)
      m_page.parts.push_back({short_name(m_names, part), color_of(m_names.parts[part].color)});
    return found.first->second;
  }

  void number_lines()
  {
    const std::vector<std::size_t> shape_edges = shape_edges_of_model(m_shape);
    for(Mesh_page_3::Line& line : m_page.lines)
      if(line.number > 0 && line.number <= shape_edges.size()) {
        const std::size_t edge = shape_edges[line.number - 1];
        line.number = edge == Open_cascade_model_3::none ? 0 : edge + 1;
      }
  }

  // Faces that have lost their triangles are in the list already.
  void add_missing_faces()
  {
    std::set<std::size_t> known;
    for(const auto& finding : m_page.findings)
      if(finding.kind == "simplified")
        for(const std::size_t f : finding.faces)
          known.insert(m_page.faces[f].number);
    for(const auto& face : m_shape.left_out)
      m_page.findings.push_back({"left out", numbered("face", face.shape_face), face.reason});
    for(const auto& face : m_shape.closed_up)
      if(known.count(face.shape_face + 1) == 0)
        m_page.findings.push_back({"simplified", numbered("face", face.shape_face) + " closed up",
                                   "it is nowhere wider than " + describe(face.width)});
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_PAGE_NAMES_H
