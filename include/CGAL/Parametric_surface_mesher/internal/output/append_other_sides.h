// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_APPEND_OTHER_SIDES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_APPEND_OTHER_SIDES_H

#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/model/Other_sides.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Appends the triangles of faces that are the other sides of others: copies, turned over, with the points of the boundary in common and
// points of their own inside.
template <class Kernel>
class Other_side_appender
{
  typedef Indexed_mesh<Kernel> Mesh;
  typedef typename Mesh::Part Part;
  typedef typename Part::Index Index;

  Mesh& m_mesh;
  Parametric_surface_mesh_report& m_report;
  std::map<std::size_t, Index> m_copies; // of points inside faces that parts share

public:
  Other_side_appender(Mesh& mesh, Parametric_surface_mesh_report& report) : m_mesh(mesh), m_report(report) {}

  // `are_reversed`: by face, whether its triangles face against `S_u x S_v`
  // \pre the parts have no place in the mesh yet
  void append(const Other_sides& other_sides, const std::vector<bool>& are_reversed)
  {
    for(std::size_t p = 0, number = m_mesh.parts.size(); p < number; ++p) {
      const std::size_t front = m_mesh.parts[p].patch, back = other_sides.back(front);
      if(back == Other_sides::none)
        continue;
      Part part = m_mesh.parts[p];
      part.patch = back;
      copy_inner_points(part);
      if(are_reversed[back] != are_reversed[front])
        part.reverse();
      repeat_unmet(part.first_face, part.faces.size());
      m_mesh.append(std::move(part));
    }
  }

private:
  void copy_inner_points(Part& part)
  {
    for(auto& face : part.faces)
      for(Index& v : face) {
        const std::size_t n = v < Part::first_cut_point ? v : part.place_of_cuts + (v - Part::first_cut_point);
        if(v < Part::first_own_point && m_mesh.places[n].dimension == 2)
          v = copy_of(n, part.patch);
      }
  }

  Index copy_of(std::size_t n, std::size_t patch)
  {
    const auto copy = m_copies.emplace(n, Index(m_mesh.points.size()));
    if(copy.second) {
      m_mesh.points.push_back(typename Mesh::Point_3(m_mesh.points[n]));
      m_mesh.domain_points.push_back(typename Mesh::Point_2(m_mesh.domain_points[n]));
      m_mesh.places.push_back({2, patch, Place_in_model::none});
    }
    return copy.first->second;
  }

  // The triangles of the part that comes next fail what those at the same places of a part before it fail.
  void repeat_unmet(std::size_t first_face, std::size_t number_of_faces)
  {
    const auto is_before = [](const Parametric_surface_mesh_report::Unmet& unmet, std::size_t face) { return unmet.face < face; };
    const auto first = std::lower_bound(m_report.unmet.begin(), m_report.unmet.end(), first_face, is_before),
               last = std::lower_bound(first, m_report.unmet.end(), first_face + number_of_faces, is_before);
    std::vector<Parametric_surface_mesh_report::Unmet> repeated(first, last);
    for(auto& unmet : repeated)
      unmet.face += m_mesh.number_of_faces() - first_face;
    m_report.unmet.insert(m_report.unmet.end(), repeated.begin(), repeated.end());
  }
};

template <class Kernel>
void append_other_sides(const Other_sides& other_sides, const std::vector<bool>& are_reversed, Indexed_mesh<Kernel>& mesh,
                        Parametric_surface_mesh_report& report)
{
  Other_side_appender<Kernel>(mesh, report).append(other_sides, are_reversed);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_APPEND_OTHER_SIDES_H
