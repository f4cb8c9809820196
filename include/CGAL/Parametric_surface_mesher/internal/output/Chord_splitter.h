// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_CHORD_SPLITTER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_CHORD_SPLITTER_H

#include <CGAL/Kernel/global_functions_2.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Vertex_insertion.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A chord is an inner edge of a patch between two boundary vertices. Where patches are as narrow as their edges are long,
// two of them (or one, across its seam) can have chords between the same two vertices, and the mesh would not be manifold.
// The same is true of an inner vertex that is joined to two copies of a vertex on a seam. The first such edge stays; others are
// split in the middle. Edges to copies of a vertex at both ends of a collapsed side, with nothing but a collapsed triangle
// between them, are one edge.
template <class Evaluator>
class Chord_splitter
{
  typedef typename Evaluator::Kernel Kernel;
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef std::pair<Vertex_handle, Vertex_handle> Chord;
  typedef std::pair<Face_handle, int> Edge;
  typedef typename Indexed_mesh<Kernel>::Chords Chords;

  static constexpr int max_number_of_passes = 10;

  Triangulation& m_triangulation;
  const Evaluator& m_evaluate;
  Chords& m_chords_of_shell;
  Chords m_chords; // those of this patch
  Vertex_insertion<Triangulation> m_insertion;
  bool m_has_copies = false; // whether vertices have copies, so that an inner vertex may be joined to two of them
  // Only looked up and never iterated over, so that addresses do not influence the mesh. The chords are those by indices.
  std::map<std::pair<const void*, std::size_t>, Chord> m_spokes;
  std::map<std::pair<std::size_t, std::size_t>, Chord> m_first_chords;

public:
  Chord_splitter(Triangulation& triangulation, const Evaluator& evaluate, Chords& chords)
    : m_triangulation(triangulation), m_evaluate(evaluate), m_chords_of_shell(chords), m_insertion(triangulation)
  {}

  // The search is repeated, since a split flips edges around the new vertex, which may create new duplicates.
  void operator()()
  {
    std::vector<Chord> repeated;
    for(int pass = 0; pass < max_number_of_passes; ++pass) {
      repeated = find_repeated();
      if(repeated.empty())
        break;
      for(const Chord& chord : repeated)
        split(chord);
    }
    m_chords_of_shell.insert(m_chords.begin(), m_chords.end());
  }

private:
  std::vector<Chord> find_repeated()
  {
    m_chords.clear();
    m_spokes.clear();
    m_first_chords.clear();
    std::vector<Vertex_handle> boundary;
    for(Vertex_handle vertex : m_triangulation.finite_vertex_handles())
      if(vertex->is_on_boundary()) // that of the patch, or of the part of it
        boundary.push_back(vertex);
    m_has_copies = have_copies(boundary);
    std::vector<Chord> result;
    for(Vertex_handle vertex : boundary)
      find_repeated_around(vertex, result);
    return result;
  }

  // Whether several vertices have the same index, as on both sides of a seam.
  static bool have_copies(const std::vector<Vertex_handle>& vertices)
  {
    std::vector<std::size_t> indices;
    for(Vertex_handle vertex : vertices)
      indices.push_back(vertex->index());
    std::sort(indices.begin(), indices.end());
    return std::adjacent_find(indices.begin(), indices.end()) != indices.end();
  }

  void find_repeated_around(Vertex_handle vertex, std::vector<Chord>& repeated)
  {
    auto face = m_triangulation.incident_faces(vertex);
    const auto first = face;
    do {
      const int i = Triangulation::ccw(face->index(vertex)); // the edge that ends at the vertex
      if(face->is_in_domain() && !face->is_constrained(i))
        collect(face, i, repeated);
    } while(++face != first);
  }

  // Edge `i`, which ends at a boundary vertex.
  void collect(Face_handle face, int i, std::vector<Chord>& repeated)
  {
    const Vertex_handle v = face->vertex(Triangulation::ccw(i)), w = face->vertex(Triangulation::cw(i));
    if(!v->is_on_boundary()) {
      if(m_has_copies)
        collect_spoke(face, i, repeated);
    }
    else if(v->index() < w->index()) // each chord is visited from both sides; one of them counts
      collect_chord(face, i, repeated);
    else if(v->index() == w->index())
      repeated.emplace_back(v, w);
  }

  void collect_spoke(Face_handle face, int i, std::vector<Chord>& repeated)
  {
    const Chord edge = end_points(face, i), first = end_points(last_of_same_edge(face, i));
    if(m_spokes.emplace(std::make_pair(&*edge.first, edge.second->index()), first).first->second != first)
      repeated.push_back(edge);
  }

  void collect_chord(Face_handle face, int i, std::vector<Chord>& repeated)
  {
    const Chord edge = end_points(face, i);
    const std::pair<std::size_t, std::size_t> indices(edge.first->index(), edge.second->index());
    Chord first = edge;
    if(m_has_copies) {
      const Edge last = last_of_same_edge(face, i),
                 last_on_other_side = last_of_same_edge(face->neighbor(i), m_triangulation.mirror_index(face, i));
      if(last.first->is_constrained(last.second) || last_on_other_side.first->is_constrained(last_on_other_side.second))
        return; // it is an edge of the boundary
      first = end_points(last);
    }
    if(m_chords_of_shell.count(indices) > 0 || m_first_chords.emplace(indices, first).first->second != first)
      repeated.push_back(edge);
    else
      m_chords.insert(indices);
  }

  // Returns the ends of an edge with the face on its left.
  static Chord end_points(Face_handle face, int i)
  {
    return {face->vertex(Triangulation::ccw(i)), face->vertex(Triangulation::cw(i))};
  }
  static Chord end_points(const Edge& edge) { return end_points(edge.first, edge.second); }

  // Edges with a collapsed triangle between them are one edge of the mesh. The last of those on the left of edge `i`.
  Edge last_of_same_edge(Face_handle face, int i) const
  {
    const Edge start(face, i);
    for(bool is_first = true; !face->is_constrained(i) && (is_first || Edge(face, i) != start); is_first = false) {
      const Vertex_handle v = face->vertex(Triangulation::ccw(i)), w = face->vertex(Triangulation::cw(i)), apex = face->vertex(i);
      if(!face->is_in_domain() || !apex->is_on_boundary() || (apex->index() != v->index() && apex->index() != w->index()))
        break;
      const int next = apex->index() == w->index() ? Triangulation::cw(i) : Triangulation::ccw(i);
      const Face_handle beyond = face->neighbor(next);
      i = m_triangulation.mirror_index(face, next);
      face = beyond;
    }
    return {face, i};
  }

  void split(const Chord& chord)
  {
    Face_handle face;
    int i = 0;
    if(!m_triangulation.is_edge(chord.first, chord.second, face, i))
      return; // the split of another edge has removed it
    const auto middle = midpoint(chord.first->point().domain_point(), chord.second->point().domain_point());
    if(!is_inside(middle, face, i))
      return;
    const double spacing = 0.5 * (chord.first->spacing() + chord.second->spacing());
    const Vertex_handle vertex = m_insertion.insert_in_edge(m_evaluate.position(middle, spacing).point, face, i);
    vertex->set_spacing(spacing);
  }

  // Whether `p`, the rounded middle of edge `i`, makes four triangles of positive orientation, by exact tests.
  template <class Point_2>
  bool is_inside(const Point_2& p, Face_handle face, int i) const
  {
    const auto orientation = m_triangulation.geom_traits().orientation_2_object();
    for(Face_handle side : {face, face->neighbor(i)}) {
      const int j = side == face ? i : m_triangulation.mirror_index(face, i);
      for(int k : {(j + 1) % 3, (j + 2) % 3})
        if(orientation(side->vertex((k + 1) % 3)->point(), side->vertex((k + 2) % 3)->point(), p) != LEFT_TURN)
          return false;
    }
    return true;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_CHORD_SPLITTER_H
