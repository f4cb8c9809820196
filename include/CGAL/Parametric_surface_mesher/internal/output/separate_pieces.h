// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_SEPARATE_PIECES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_SEPARATE_PIECES_H

#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/support/for_each_index.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Makes a mesh manifold where several pieces of it meet in a vertex: each piece gets its own copy. Two triangles belong to the
// same piece if they run through a common edge in opposite directions and no third triangle of their shell has it; or if the edge lies
// inside the face that both of them belong to.
template <class Kernel>
class Piece_separator
{
  typedef typename Indexed_mesh<Kernel>::Part Part;
  typedef typename Part::Index Index;

  // A corner of a triangle at one of the vertices.
  struct Corner
  {
    std::size_t part, face, number;
  };

  Indexed_mesh<Kernel>& m_mesh;
  const std::vector<std::size_t>& m_shells; // by patch
  std::vector<Corner> m_corners;            // those of one vertex

public:
  Piece_separator(Indexed_mesh<Kernel>& mesh, const std::vector<std::size_t>& shells) : m_mesh(mesh), m_shells(shells) {}

  // Separates the pieces at those of the given vertices where several meet.
  template <class ConcurrencyTag>
  void separate(const std::vector<std::size_t>& vertices)
  {
    const auto corners = corners_at<ConcurrencyTag>(vertices);
    std::vector<std::pair<Corner, std::size_t>> changes; // made at the end, since the search needs the old indices
    for(const auto& vertex : corners) {
      m_corners = vertex.second;
      append_changes(vertex.first, changes);
    }
    for(const auto& change : changes)
      m_mesh.parts[change.first.part].faces[change.first.face][change.first.number] = Index(change.second);
  }

private:
  // Collects the corners at the vertices, in the order of the faces.
  template <class ConcurrencyTag>
  std::map<std::size_t, std::vector<Corner>> corners_at(const std::vector<std::size_t>& vertices) const
  {
    std::vector<bool> is_wanted(m_mesh.points.size(), false);
    for(std::size_t v : vertices)
      is_wanted[v] = true;
    std::vector<std::vector<Corner>> corners(m_mesh.parts.size()); // by part
    for_each_index<ConcurrencyTag>(corners.size(), [&](std::size_t p) {
      const auto& faces = m_mesh.parts[p].faces;
      for(std::size_t f = 0; f < faces.size(); ++f)
        for(std::size_t k = 0; k < 3; ++k)
          if(faces[f][k] < is_wanted.size() && is_wanted[faces[f][k]])
            corners[p].push_back({p, f, k});
    });
    std::map<std::size_t, std::vector<Corner>> result;
    for(const auto& corners_of_part : corners)
      for(const Corner& corner : corners_of_part)
        result[m_mesh.parts[corner.part].faces[corner.face][corner.number]].push_back(corner);
    return result;
  }

  void append_changes(std::size_t vertex, std::vector<std::pair<Corner, std::size_t>>& changes)
  {
    std::vector<std::size_t> ranks(m_corners.size()), parents(m_corners.size());
    boost::disjoint_sets<std::size_t*, std::size_t*> pieces(ranks.data(), parents.data());
    for(std::size_t i = 0; i < m_corners.size(); ++i)
      pieces.make_set(i);
    for(const auto& side : sides())
      if(side.second[0].size() == 1 && side.second[1].size() == 1)
        pieces.union_set(side.second[0][0], side.second[1][0]);
    std::map<std::size_t, std::size_t> copies; // by representative
    for(std::size_t i = 0; i < m_corners.size(); ++i) {
      const std::size_t piece = pieces.find_set(i);
      if(copies.count(piece) == 0)
        copies[piece] = copies.empty() ? vertex : m_mesh.copy_of(vertex);
      if(copies[piece] != vertex)
        changes.emplace_back(m_corners[i], copies[piece]);
    }
  }

  // Tells the edges at the vertex apart: whether one lies inside a patch; that patch, or else the shell; and the vertex at its other end.
  typedef std::tuple<bool, std::size_t, std::size_t> Key_of_edge;

  // For each edge at the vertex: the corners whose triangle runs along the edge away from the vertex, and those whose triangle runs
  // back to it.
  std::map<Key_of_edge, std::array<std::vector<std::size_t>, 2>> sides() const
  {
    std::map<Key_of_edge, std::array<std::vector<std::size_t>, 2>> result;
    for(std::size_t i = 0; i < m_corners.size(); ++i) {
      const Part& part = m_mesh.parts[m_corners[i].part];
      const auto& face = part.faces[m_corners[i].face];
      const std::size_t k = m_corners[i].number;
      result[key(part.patch, face[k], face[(k + 1) % 3])][0].push_back(i);
      result[key(part.patch, face[k], face[(k + 2) % 3])][1].push_back(i);
    }
    return result;
  }

  Key_of_edge key(std::size_t patch, std::size_t vertex, std::size_t other_end) const
  {
    const bool is_inside = is_inside_face(vertex) && is_inside_face(other_end) && number_of_triangles(patch, other_end) == 2;
    return {is_inside, is_inside ? patch : m_shells[patch], other_end};
  }

  // Whether a vertex lies on an edge inside a face.
  bool is_inside_face(std::size_t vertex) const { return vertex < m_mesh.places.size() && m_mesh.places[vertex].is_inside_face; }

  // The number of triangles of a patch at an edge of the vertex.
  std::size_t number_of_triangles(std::size_t patch, std::size_t other_end) const
  {
    return std::size_t(std::count_if(m_corners.begin(), m_corners.end(), [&](const Corner& corner) {
      const Part& part = m_mesh.parts[corner.part];
      const auto& face = part.faces[corner.face];
      return part.patch == patch && std::find(face.begin(), face.end(), other_end) != face.end();
    }));
  }
};

template <class ConcurrencyTag, class Kernel>
void separate_pieces(Indexed_mesh<Kernel>& mesh, const std::vector<std::size_t>& shells,
                     const std::vector<std::size_t>& vertices)
{
  Piece_separator<Kernel> separator(mesh, shells);
  separator.template separate<ConcurrencyTag>(vertices);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_SEPARATE_PIECES_H
