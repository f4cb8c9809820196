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
// split in the middle.
template <class Evaluator>
class Chord_splitter
{
  typedef typename Evaluator::Kernel Kernel;
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef std::pair<Vertex_handle, Vertex_handle> Chord;
  typedef typename Indexed_mesh<Kernel>::Chords Chords;

  static const int max_number_of_passes = 10;

  Triangulation& m_triangulation;
  const Evaluator& m_evaluate;
  Chords& m_chords_of_shell;
  Chords m_chords; // those of this patch
  Vertex_insertion<Triangulation> m_insertion;
  bool m_has_copies = false; // whether vertices have copies, so that an inner vertex may be joined to two of them
  // Only looked up and never iterated over, so that addresses do not influence the mesh.
  std::map<std::pair<const void*, std::size_t>, Vertex_handle> m_spokes;

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
        collect(face->vertex(Triangulation::ccw(i)), vertex, repeated);
    } while(++face != first);
  }

  void collect(Vertex_handle v, Vertex_handle w, std::vector<Chord>& repeated)
  {
    if(!v->is_on_boundary()) {
      if(m_has_copies)
        collect_spoke(v, w, repeated);
    }
    else if(v->index() <= w->index()) // each chord is visited from both sides; one of them counts
      if(v->index() == w->index() || m_chords_of_shell.count({v->index(), w->index()}) > 0
         || !m_chords.emplace(v->index(), w->index()).second)
        repeated.emplace_back(v, w);
  }

  void collect_spoke(Vertex_handle inner, Vertex_handle w, std::vector<Chord>& repeated)
  {
    const Vertex_handle first = m_spokes.emplace(std::make_pair(&*inner, w->index()), w).first->second;
    if(first != w)
      repeated.emplace_back(inner, w);
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
