// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_COMPLEX_IN_MESH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_COMPLEX_IN_MESH_H

#include <CGAL/Parametric_surface_mesher/internal/curing/Triangle_complex.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Place_in_model.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The part of a mesh around some triangles, taken out as a complex that can be changed, and put back.
template <class Kernel>
class Complex_in_mesh
{
  typedef Indexed_mesh<Kernel> Mesh;
  typedef typename Mesh::Part Part;
  typedef typename Part::Index Part_index;
  typedef Triangle_complex<Kernel> Complex;
  typedef typename Complex::Triangle Triangle;
  typedef std::size_t Index;

  // Vertices up to so many edges away from the given triangles may change.
  static const unsigned char width_of_free_part = 3;
  static const unsigned char far = 255;

  Mesh& m_mesh;
  Complex m_complex;
  std::vector<Index> m_numbers;                    // of the vertices, in the mesh
  std::vector<Place_in_model> m_places;            // of the vertices, before they were changed
  std::vector<Index> m_owners;                     // of the vertices: the part that has them as its own, or none
  std::vector<std::pair<Index, Index>> m_sources;  // of the first triangles: part, and face in the part
  std::vector<std::vector<bool>> m_are_taken_away; // by part and face: whether the face was changed
  std::vector<Index> m_new_numbers;                // of the points: as indices for parts
  std::vector<std::vector<Index>> m_added;         // by part: triangles of the complex

public:
  static constexpr Index none = Index(-1);

  std::vector<Index> new_faces;   // by old face, numbered over all parts: the new one, or none if it was changed
  std::vector<Index> added_faces; // by triangle of the complex: the new face, or none
  std::vector<Index> new_points;  // of the points that parts shared

  // How far points have moved already, by their places: no place changes.
  typedef std::map<typename Kernel::Point_3, Displacement> Moves;

  // `faces`: numbered over all parts, in ascending order. `shells`: by patch, on both sides
  // \pre the parts have no place in the mesh yet
  Complex_in_mesh(Mesh& mesh, const std::vector<std::array<Index, 2>>& shells, const Moves& moves, const std::vector<Index>& faces)
    : m_mesh(mesh)
  {
    const std::vector<unsigned char> levels = this->levels(faces);
    std::vector<Index> vertices(levels.size(), Index(none)); // of the complex
    for(Index p = 0; p < mesh.parts.size(); ++p)
      for(Index f = 0; f < mesh.parts[p].faces.size(); ++f)
        if(smallest_level(p, f, levels) <= width_of_free_part) {
          add_vertices(p, f, moves, levels, vertices);
          add_triangle(p, f, shells, vertices);
        }
  }

  Complex& complex() { return m_complex; }
  const Complex& complex() const { return m_complex; }

  // The number that a vertex of the complex has among the points that parts share, or `none`.
  // \pre the complex is put back
  Index shared_point(Index vertex) const
  {
    const Index n = m_new_numbers[m_numbers[vertex]];
    return n < Part::first_cut_point ? n : Index(none);
  }

  // Where a vertex of the complex lies now.
  Place_in_model place(Index vertex) const
  {
    const int dimension = m_complex.vertex(vertex).dimension;
    return dimension == m_places[vertex].dimension ? m_places[vertex]
                                                   : Place_in_model{dimension, Place_in_model::none, Place_in_model::none};
  }

  // The corners of a face of a part that has no place in the mesh yet.
  static std::array<typename Kernel::Point_3, 3> corners(const Mesh& mesh, const Part& part, Index f)
  {
    std::array<typename Kernel::Point_3, 3> result;
    for(std::size_t k = 0; k < 3; ++k) {
      const Part_index v = part.faces[f][k];
      result[k] = v >= Part::first_own_point ? part.points[v - Part::first_own_point]
                                             : mesh.points[v < Part::first_cut_point ? v : part.place_of_cuts + (v - Part::first_cut_point)];
    }
    return result;
  }

  // Puts the changed triangles back. Points that no triangle has any more vanish; the others keep their order.
  void put_back()
  {
    find_changes();
    number_points();
    std::vector<Part> parts;
    Index number_of_faces = 0;
    new_faces.clear();
    added_faces.assign(m_complex.triangles().size(), Index(none));
    for(Index p = 0; p < m_mesh.parts.size(); ++p) {
      parts.push_back(new_part(p, number_of_faces));
      number_of_faces += parts.back().faces.size();
    }
    take_shared_points();
    m_mesh.replace_parts(std::move(parts));
  }

private:
  Index number(const Part& part, Part_index v) const
  {
    return v < Part::first_cut_point   ? v
           : v < Part::first_own_point ? part.place_of_cuts + (v - Part::first_cut_point)
                                       : m_mesh.points.size() + part.first_point + (v - Part::first_own_point);
  }

  unsigned char smallest_level(Index p, Index f, const std::vector<unsigned char>& levels) const
  {
    unsigned char result = far;
    for(Part_index v : m_mesh.parts[p].faces[f])
      result = (std::min)(result, levels[number(m_mesh.parts[p], v)]);
    return result;
  }

  // The distances of points, in edges, from the faces.
  std::vector<unsigned char> levels(const std::vector<Index>& faces) const
  {
    std::vector<unsigned char> result(m_mesh.number_of_points(), static_cast<unsigned char>(far));
    Index p = 0;
    for(Index face : faces) { // in ascending order
      while(face >= m_mesh.parts[p].first_face + m_mesh.parts[p].faces.size())
        ++p;
      for(Part_index v : m_mesh.parts[p].faces[face - m_mesh.parts[p].first_face])
        result[number(m_mesh.parts[p], v)] = 0;
    }
    for(unsigned char level = 1; level <= width_of_free_part; ++level)
      for(Index q = 0; q < m_mesh.parts.size(); ++q)
        for(Index f = 0; f < m_mesh.parts[q].faces.size(); ++f)
          if(smallest_level(q, f, result) < level)
            for(Part_index v : m_mesh.parts[q].faces[f])
              result[number(m_mesh.parts[q], v)] = (std::min)(result[number(m_mesh.parts[q], v)], level);
    return result;
  }

  void add_vertices(Index p, Index f, const Moves& moves, const std::vector<unsigned char>& levels,
                    std::vector<Index>& vertices)
  {
    const Part& part = m_mesh.parts[p];
    for(Part_index v : part.faces[f]) {
      const Index n = number(part, v);
      if(vertices[n] != none)
        continue;
      const bool is_own = n >= m_mesh.points.size();
      const Place_in_model place = is_own ? Place_in_model{2, part.patch, Place_in_model::none} : m_mesh.places[n];
      m_places.push_back(place);
      const auto& point = is_own ? part.points[v - Part::first_own_point] : m_mesh.points[n];
      const auto moved = moves.find(point);
      vertices[n] = m_complex.add_vertex({point, place.dimension, place.entity, levels[n] > width_of_free_part || place.is_inside_face,
                                          moved != moves.end() ? moved->second : Displacement()});
      m_numbers.push_back(n);
      m_owners.push_back(is_own ? p : Index(none));
    }
  }

  void add_triangle(Index p, Index f, const std::vector<std::array<Index, 2>>& shells, const std::vector<Index>& vertices)
  {
    const Part& part = m_mesh.parts[p];
    Triangle triangle{{}, part.corner_points[f], part.patch, shells[part.patch], p};
    for(std::size_t k = 0; k < 3; ++k)
      triangle.vertices[k] = vertices[number(part, part.faces[f][k])];
    m_complex.add_triangle(triangle);
    m_sources.emplace_back(p, f);
  }

  void find_changes()
  {
    m_are_taken_away.clear();
    for(const Part& part : m_mesh.parts)
      m_are_taken_away.emplace_back(part.faces.size(), false);
    m_added.assign(m_mesh.parts.size(), {});
    for(Index t = 0; t < m_complex.triangles().size(); ++t) {
      const Triangle& triangle = m_complex.triangle(t);
      if(t < m_sources.size())
        m_are_taken_away[m_sources[t].first][m_sources[t].second] = triangle.is_removed;
      else if(!triangle.is_removed)
        m_added[triangle.part].push_back(t);
    }
  }

  // Points that several parts have, now, become shared ones after the others.
  void number_points()
  {
    std::vector<bool> are_used(m_mesh.number_of_points(), false), are_promoted(m_mesh.number_of_points(), false);
    for(Index p = 0; p < m_mesh.parts.size(); ++p) {
      const Part& part = m_mesh.parts[p];
      for(Index f = 0; f < part.faces.size(); ++f)
        if(!m_are_taken_away[p][f])
          for(Part_index v : part.faces[f])
            are_used[number(part, v)] = true;
      for(Index t : m_added[p])
        for(Index v : m_complex.triangle(t).vertices) {
          are_used[m_numbers[v]] = true;
          are_promoted[m_numbers[v]] = are_promoted[m_numbers[v]] || (m_owners[v] != none && m_owners[v] != p);
        }
    }
    m_new_numbers.assign(are_used.size(), Index(none));
    Index number = 0;
    for(Index n = 0; n < m_mesh.points.size(); ++n)
      if(are_used[n])
        m_new_numbers[n] = number++;
    new_points.assign(m_new_numbers.begin(), m_new_numbers.begin() + std::ptrdiff_t(m_mesh.points.size()));
    for(Index n = m_mesh.points.size(); n < are_used.size(); ++n)
      if(are_promoted[n])
        m_new_numbers[n] = number++;
    for(const Part& part : m_mesh.parts) {
      Index own = Part::first_own_point;
      for(Index n = m_mesh.points.size() + part.first_point, end = n + part.points.size(); n < end; ++n)
        if(are_used[n] && !are_promoted[n])
          m_new_numbers[n] = own++;
    }
  }

  // \pre the parts are still the old ones
  void take_shared_points()
  {
    std::vector<typename Mesh::Point_3> points;
    std::vector<typename Mesh::Point_2> domain_points;
    for(Index n = 0; n < m_mesh.points.size(); ++n)
      if(m_new_numbers[n] != none) {
        points.push_back(m_mesh.points[n]);
        domain_points.push_back(m_mesh.domain_points[n]);
      }
    for(const Part& part : m_mesh.parts)
      for(Index i = 0; i < part.points.size(); ++i)
        if(m_new_numbers[m_mesh.points.size() + part.first_point + i] < Part::first_cut_point) {
          points.push_back(part.points[i]);
          domain_points.push_back(i < part.domain_points.size() ? part.domain_points[i] : typename Mesh::Point_2(0, 0));
        }
    m_mesh.points.swap(points);
    m_mesh.domain_points.swap(domain_points);
  }

  Part new_part(Index p, Index first_face)
  {
    const Part& old = m_mesh.parts[p];
    Part result;
    result.patch = old.patch;
    for(Index i = 0; i < old.points.size(); ++i) {
      const Index n = m_new_numbers[m_mesh.points.size() + old.first_point + i];
      if(n == none || n < Part::first_own_point)
        continue;
      result.points.push_back(old.points[i]);
      if(i < old.domain_points.size())
        result.domain_points.push_back(old.domain_points[i]);
    }
    take_kept_faces(p, first_face, result);
    for(Index t : m_added[p]) {
      const Triangle& triangle = m_complex.triangle(t);
      added_faces[t] = first_face + result.faces.size();
      for(std::size_t k = 0; k < 3; ++k)
        result.border.push_back(Part_index(3 * result.faces.size() + k));
      result.halfedges.push_back({});
      result.faces.push_back({new_number(triangle, 0), new_number(triangle, 1), new_number(triangle, 2)});
      result.corner_points.push_back(triangle.uv);
    }
    return result;
  }

  Part_index new_number(const Triangle& triangle, std::size_t corner) const
  {
    return Part_index(m_new_numbers[m_numbers[triangle.vertices[corner]]]);
  }

  // Sides whose neighbour has changed are looked for among those of all parts.
  void take_kept_faces(Index p, Index first_face, Part& result)
  {
    const Part& old = m_mesh.parts[p];
    std::vector<bool> is_border(3 * old.faces.size(), false);
    for(Part_index side : old.border)
      is_border[side] = true;
    std::vector<unsigned char> number_of_sides(old.number_of_edges, 0);
    for(Index side = 0; side < is_border.size(); ++side)
      if(!is_border[side] && !m_are_taken_away[p][side / 3])
        ++number_of_sides[old.halfedge(side) / 2];
    std::vector<Index> edges(old.number_of_edges);
    for(Index e = 0; e < edges.size(); ++e) {
      edges[e] = result.number_of_edges;
      result.number_of_edges += number_of_sides[e] == 2;
    }
    for(Index f = 0; f < old.faces.size(); ++f) {
      new_faces.push_back(m_are_taken_away[p][f] ? Index(none) : first_face + result.faces.size());
      if(m_are_taken_away[p][f])
        continue;
      std::array<Part_index, 3> halfedges = {}, face;
      for(std::size_t k = 0; k < 3; ++k) {
        const Index halfedge = old.halfedges[f][k];
        face[k] = Part_index(m_new_numbers[number(old, old.faces[f][k])]);
        if(is_border[3 * f + k] || number_of_sides[halfedge / 2] < 2)
          result.border.push_back(Part_index(3 * result.faces.size() + k));
        else
          halfedges[k] = Part_index(2 * edges[halfedge / 2] + halfedge % 2);
      }
      result.halfedges.push_back(halfedges);
      result.faces.push_back(face);
      result.corner_points.push_back(old.corner_points[f]);
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_COMPLEX_IN_MESH_H
