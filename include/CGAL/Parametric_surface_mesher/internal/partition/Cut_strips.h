// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_CUT_STRIPS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_CUT_STRIPS_H

#include <CGAL/Parametric_surface_mesher/internal/partition/Patch_parts.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Strip_triangulation.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
The strips along the cuts between the meshed parts of a patch: all triangles within some rings around the points of a cut, which
leave the parts. In a strip the points of the cut are inner vertices like others. What is fixed are the boundary of the patch and
the *border*: vertices that a strip shares with a part or with another strip, including points of cuts that lie there. Smoothing
does not move vertices beside the border.

The functions must be called in this order: `take_out()` for each part, by several threads if wanted; `connect()`;
`triangulate()` for each strip, by several threads if wanted; `close()` for each part.
*/
template <class Kernel>
class Cut_strips
{
public:
  typedef Patch_triangulation_2<Kernel> Triangulation;

private:
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Point Point;
  typedef Strip_triangulation<Kernel> Strip_maker;

  // So many rings of triangles on either side of a cut are refined and smoothed anew, which removes its trace from the angles.
  static constexpr int number_of_rings = 4;

  // A triangle that has left its part.
  struct Taken
  {
    Face_handle face;
    std::size_t strip, number; // the strip, and the index of the triangle in it
  };

  struct Side
  {
    std::size_t part;
    Face_handle face;
    int i;
  };

  typedef std::map<std::pair<std::size_t, std::size_t>, std::vector<Side>> Sides; // the sides along each edge of a cut, by its vertices

  const Patch_parts<Kernel>& m_parts;
  std::vector<Triangulation*> m_triangulations; // by part
  std::vector<std::vector<Taken>> m_taken;       // by part
  std::vector<std::vector<std::pair<std::size_t, Face_handle>>> m_strips; // part and face of each triangle
  Sides m_sides;
  std::unordered_map<const void*, const void*> m_copies; // of vertices; never iterated over
  std::vector<bool> m_is_on_border; // by point of a cut
  std::vector<Point> m_border;      // by index less the first one; points of cuts inside strips are not set

public:
  Cut_strips(const Patch_parts<Kernel>& parts, std::vector<Triangulation*> triangulations)
    : m_parts(parts), m_triangulations(std::move(triangulations)), m_taken(m_triangulations.size()),
      m_strips(parts.number_of_strips()), m_is_on_border(parts.number_of_cut_points(), false)
  {}

  // The numbers of triangles of the strips.
  // \pre `connect()` was called
  std::vector<double> sizes() const
  {
    std::vector<double> result;
    for(const auto& strip : m_strips)
      result.push_back(double(strip.size()));
    return result;
  }

  // Takes triangles out of a part, ring by ring; a triangle belongs to the strip from which it is reached first.
  void take_out(std::size_t part)
  {
    Triangulation& triangulation = *m_triangulations[part];
    std::vector<std::pair<Vertex_handle, std::size_t>> ring, next; // with their strips
    std::unordered_set<Vertex_handle> is_reached;                  // never iterated over
    for(Vertex_handle vertex : triangulation.finite_vertex_handles())
      if(is_of_cut(vertex)) {
        ring.emplace_back(vertex, m_parts.strip(vertex->index() - m_parts.first_index()));
        is_reached.insert(vertex);
      }
    for(int k = 0; k < number_of_rings; ++k, ring.swap(next), next.clear())
      for(const auto& from : ring) {
        auto face = triangulation.incident_faces(from.first);
        const auto first = face;
        do
          if(face->is_in_domain()) {
            take(part, face, from.second);
            for(int i = 0; i < 3; ++i)
              if(is_reached.insert(face->vertex(i)).second)
                next.emplace_back(face->vertex(i), from.second);
          }
        while(++face != first);
      }
    keep_chords_inside(part);
  }

  void connect()
  {
    for(std::size_t part = 0; part < m_taken.size(); ++part)
      for(Taken& taken : m_taken[part]) {
        taken.number = m_strips[taken.strip].size();
        m_strips[taken.strip].emplace_back(part, taken.face);
        for(int i = 0; i < 3; ++i)
          if(taken.face->is_constrained(i) && !is_on_boundary(taken.face, i))
            m_sides[ends(taken.face, i)].push_back({part, taken.face, i});
      }
    find_copies();
    for(std::size_t part = 0; part < m_taken.size(); ++part)
      for(const Taken& taken : m_taken[part])
        for(int i = 0; i < 3; ++i)
          if(!is_on_boundary(taken.face, i) && neighbor(part, taken, i) < 0) {
            put_on_border(taken.face->vertex((i + 1) % 3));
            put_on_border(taken.face->vertex((i + 2) % 3));
          }
    number_border();
  }

  // Makes the triangulation of a strip; returns the number of its vertices that are not inner ones.
  std::size_t triangulate(std::size_t strip, Triangulation& triangulation) const
  {
    Strip_maker make(triangulation, m_strips[strip].size());
    for(const auto& from : m_strips[strip])
      make.add_face([&](int i) { return add_vertex(from.second->vertex(i), make); });
    for(std::size_t k = 0; k < m_strips[strip].size(); ++k) {
      const auto& from = m_strips[strip][k];
      for(int i = 0; i < 3; ++i)
        make.set_neighbor(k, i, neighbor(from.first, m_taken[from.first][from.second->number()], i));
    }
    make.close();
    keep_beside_border(triangulation);
    return make.number_of_vertices_on_boundary();
  }

  // Reduces a part to its triangles that are in no strip, with the border as their boundary. Returns the number of inner vertices
  // that the part loses.
  std::size_t close(std::size_t part)
  {
    std::size_t result = 0;
    for(const Taken& taken : m_taken[part])
      for(int i = 0; i < 3; ++i) {
        const Face_handle across = taken.face->neighbor(i);
        if(!taken.face->is_constrained(i) && across->is_in_domain())
          across->set_constraint(m_triangulations[part]->mirror_index(taken.face, i), true);
        result += !taken.face->vertex(i)->is_on_boundary();
        taken.face->vertex(i)->set_on_boundary(true);
      }
    return result;
  }

  // The points on the border, by index less the first one.
  const std::vector<Point>& border() const { return m_border; }

  // Whether this point is on the border. Others are points of cuts that have become inner vertices.
  bool is_on_border(std::size_t i) const { return i >= m_is_on_border.size() || m_is_on_border[i]; }

private:
  void take(std::size_t part, Face_handle face, std::size_t strip)
  {
    face->set_in_domain(false);
    face->set_number(m_taken[part].size());
    m_taken[part].push_back({face, strip, 0});
  }

  // No chord becomes a side of the border, where it could not be split if it repeats another one: triangles that are joined by
  // chords are in one strip, that of the first of them.
  void keep_chords_inside(std::size_t part)
  {
    std::vector<bool> is_done;
    std::vector<std::size_t> joined;
    for(std::size_t first = 0; first < m_taken[part].size(); ++first) {
      is_done.resize(m_taken[part].size(), false);
      if(is_done[first])
        continue;
      is_done[first] = true;
      joined.assign(1, first);
      while(!joined.empty()) {
        const Face_handle face = m_taken[part][joined.back()].face;
        joined.pop_back();
        for(int i = 0; i < 3; ++i) {
          const Face_handle beyond = face->neighbor(i);
          if(!is_chord(face, i))
            continue;
          if(beyond->is_in_domain())
            take(part, beyond, m_taken[part][first].strip);
          is_done.resize(m_taken[part].size(), false);
          if(is_done[beyond->number()])
            continue;
          is_done[beyond->number()] = true;
          m_taken[part][beyond->number()].strip = m_taken[part][first].strip;
          joined.push_back(beyond->number());
        }
      }
    }
  }

  // Whether side `i` is inside the part, between two vertices of its boundary.
  static bool is_chord(Face_handle face, int i)
  {
    return !face->is_constrained(i) && face->vertex((i + 1) % 3)->is_on_boundary() && face->vertex((i + 2) % 3)->is_on_boundary();
  }

  bool is_of_cut(Vertex_handle vertex) const
  {
    return vertex->is_on_boundary() && vertex->index() >= m_parts.first_index();
  }

  static std::pair<std::size_t, std::size_t> ends(Face_handle face, int i)
  {
    return std::minmax<std::size_t>({face->vertex((i + 1) % 3)->index(), face->vertex((i + 2) % 3)->index()});
  }

  // Finds the copies of vertices where cuts end on the boundary: such a vertex is in at least two parts.
  void find_copies()
  {
    for(const auto& edge : m_sides)
      if(edge.first.first < m_parts.first_index() && edge.second.size() == 2) {
        const void *a = key(end(edge.second[0], edge.first.first)), *b = key(end(edge.second[1], edge.first.first));
        if(a != b)
          m_copies[b] = a;
      }
  }

  static Vertex_handle end(const Side& side, std::size_t index)
  {
    const Vertex_handle v = side.face->vertex((side.i + 1) % 3);
    return v->index() == index ? v : side.face->vertex((side.i + 2) % 3);
  }

  const void* key(Vertex_handle vertex) const
  {
    const void* result = &*vertex;
    for(auto copy = m_copies.find(result); copy != m_copies.end(); copy = m_copies.find(result))
      result = copy->second;
    return result;
  }

  // Whether edge `i` is on the boundary of the patch.
  bool is_on_boundary(Face_handle face, int i) const
  {
    return face->is_constrained(i) && ends(face, i).second < m_parts.first_index();
  }

  // The index in its strip of the triangle across an edge, or -1 if that is not in the strip.
  std::ptrdiff_t neighbor(std::size_t part, const Taken& taken, int i) const
  {
    Side across{part, taken.face->neighbor(i), 0};
    if(taken.face->is_constrained(i)) {
      if(is_on_boundary(taken.face, i))
        return -1;
      const std::vector<Side>& sides = m_sides.at(ends(taken.face, i));
      if(sides.size() != 2)
        return -1;
      across = sides[0].face == taken.face ? sides[1] : sides[0];
    }
    else if(across.face->is_in_domain())
      return -1;
    const Taken& other = m_taken[across.part][across.face->number()];
    return other.strip == taken.strip ? std::ptrdiff_t(other.number) : -1;
  }

  void put_on_border(Vertex_handle vertex)
  {
    if(is_of_cut(vertex))
      m_is_on_border[vertex->index() - m_parts.first_index()] = true;
    else if(!vertex->is_on_boundary())
      vertex->set_index(no_vertex_index); // `number_border()` gives it one
  }

  void number_border()
  {
    m_border.resize(m_is_on_border.size());
    for(const auto& taken_from_part : m_taken)
      for(const Taken& taken : taken_from_part)
        for(int i = 0; i < 3; ++i) {
          const Vertex_handle vertex = taken.face->vertex(i);
          if(is_of_cut(vertex))
            m_border[vertex->index() - m_parts.first_index()] = vertex->point();
          else if(vertex->index() == no_vertex_index) {
            vertex->set_on_cut(true);
            vertex->set_index(m_parts.first_index() + m_border.size());
            m_border.push_back(vertex->point());
          }
        }
  }

  // The border is jagged. Triangles with a vertex on it are good when they leave their parts, but if smoothing moved their inner
  // vertices, a few could not be repaired.
  void keep_beside_border(Triangulation& triangulation) const
  {
    for(Face_handle face : triangulation.finite_face_handles())
      for(int i = 0; i < 3; ++i)
        if(face->vertex(i)->is_on_boundary() && face->vertex(i)->index() >= m_parts.first_index()) {
          face->vertex(Triangulation::cw(i))->set_kept(true);
          face->vertex(Triangulation::ccw(i))->set_kept(true);
        }
  }

  // A point of a cut has a copy in each part; the first one stands for all of them.
  Vertex_handle add_vertex(Vertex_handle vertex, Strip_maker& make) const
  {
    if(!is_of_cut(vertex))
      return make.vertex(key(vertex), *vertex, vertex->is_on_boundary() || vertex->index() >= m_parts.first_index());
    const std::size_t i = vertex->index() - m_parts.first_index();
    return make.vertex(&m_border[i], *vertex, m_is_on_border[i]);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_CUT_STRIPS_H
