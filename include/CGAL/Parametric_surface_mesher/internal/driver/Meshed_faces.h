// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_MESHED_FACES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_MESHED_FACES_H

#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Meshed_patch.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Vertex_allowances.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// What meshing a face gave.
template <class Kernel>
struct Meshed_face
{
  std::vector<double> values_of_criteria;       // those it was meshed with
  typename Indexed_mesh<Kernel>::Chords chords; // inner edges between boundary vertices
  Vertex_allowances allowances;
  bool is_of_earlier_run = false;
  std::size_t max_number_of_vertices = 0, number_of_inner_vertices = 0;
  Meshed_patch<Kernel> patch; // once the triangles are collected

  // Whether the mesh would be another one if no more vertices were allowed than `limit`.
  bool is_limited_by(std::size_t limit) const { return limit != max_number_of_vertices && allowances.is_limited_by(limit); }

  // Gives points of the division other indices.
  template <class Indices>
  void renumber_division(const Indices& indices)
  {
    typename Indexed_mesh<Kernel>::Chords renumbered;
    for(const auto& chord : chords)
      renumbered.insert(std::minmax(index(chord.first, indices), index(chord.second, indices)));
    chords = std::move(renumbered);
    for(auto& part : patch.parts)
      part.mesh.renumber_division(indices);
  }

private:
  template <class Indices>
  static std::size_t index(std::size_t point, const Indices& indices)
  {
    return point < Partial_mesh<Kernel>::first_cut_point ? indices.at(point) : point;
  }
};

// Faces as they were meshed, for another round or run in which they are the same: a face is if its boundary, the values of its criteria
// and its sizes are. The sizes that functions give are compared by others, who forget the faces where these differ.
template <class Kernel>
class Meshed_faces
{
public:
  struct Face
  {
    Boundary_loops<Kernel> loops;
    Meshed_face<Kernel> meshed;
  };

private:
  std::map<std::size_t, Face> m_faces;

public:
  // A face that a limit of vertices has cut short is not kept: the next run may have more left for it.
  void keep(std::size_t face, const Boundary_loops<Kernel>& loops, const Meshed_face<Kernel>& meshed)
  {
    if(meshed.allowances.is_limited_by(meshed.max_number_of_vertices))
      return;
    Face& kept = m_faces[face];
    kept = {loops, meshed};
    kept.meshed.patch.report.seconds = {};
    for(auto& part : kept.meshed.patch.parts)
      part.report.seconds = {};
  }

  void forget(std::size_t face) { m_faces.erase(face); }

  // Forgets faces that a predicate holds for. `predicate`: takes the index of a face, and the face
  template <class Predicate>
  void forget_if(const Predicate& predicate)
  {
    for(auto face = m_faces.begin(); face != m_faces.end();)
      face = predicate(face->first, std::as_const(face->second)) ? m_faces.erase(face) : std::next(face);
  }

  template <class Function>
  void for_each(const Function& function) const
  {
    for(const auto& face : m_faces)
      function(face.first, face.second);
  }

  // All faces that are there are of an earlier run then.
  void begin_run()
  {
    for(auto& face : m_faces)
      face.second.meshed.is_of_earlier_run = true;
  }

  std::size_t number_of_kept_faces() const
  {
    return std::count_if(m_faces.begin(), m_faces.end(), [](const auto& face) { return face.second.meshed.is_of_earlier_run; });
  }

  // Hands a face over, with the indices of these loops, if it has the same boundary and was meshed with these values of the criteria; else
  // it is forgotten.
  std::optional<Meshed_face<Kernel>> take(std::size_t face, const Boundary_loops<Kernel>& loops,
                                          const std::vector<double>& values_of_criteria)
  {
    const auto found = m_faces.find(face);
    if(found == m_faces.end())
      return std::nullopt;
    std::unordered_map<std::size_t, std::size_t> indices;
    std::optional<Meshed_face<Kernel>> result;
    if(found->second.meshed.values_of_criteria == values_of_criteria && match(found->second.loops, loops, indices)) {
      result = std::move(found->second.meshed);
      result->renumber_division(indices);
    }
    m_faces.erase(found);
    return result;
  }

private:
  // `indices`: becomes the new index of each vertex
  static bool match(const Boundary_loops<Kernel>& before, const Boundary_loops<Kernel>& now,
                    std::unordered_map<std::size_t, std::size_t>& indices)
  {
    if(before.size() != now.size())
      return false;
    std::unordered_map<std::size_t, std::size_t> back;
    for(std::size_t l = 0; l < now.size(); ++l) {
      if(before[l].size() != now[l].size())
        return false;
      for(std::size_t i = 0; i < now[l].size(); ++i) {
        const auto &v = before[l][i], &w = now[l][i];
        if(v.domain_point != w.domain_point || v.surface_point != w.surface_point
           || indices.emplace(v.index, w.index).first->second != w.index || back.emplace(w.index, v.index).first->second != v.index)
          return false;
      }
    }
    return true;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_MESHED_FACES_H
