// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_CROSSING_REFINEMENT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_CROSSING_REFINEMENT_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/find_chart.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Misplaced_holes.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Model_division.h>
#include <CGAL/Parametric_surface_mesher/internal/model/name_face.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Mesh_progress.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>

#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Boundary curves may be disjoint although the straight segments between the points of their divisions cross or touch. Such
// pieces are halved, for all faces that use the edge, until no segments cross. If halving does not help, the curves themselves
// cross and are refused.
template <class Oracle>
class Crossing_refinement
{
  typedef Model_division<Oracle> Division;
  typedef typename Division::Kernel Kernel;
  typedef typename Division::Piece Piece;
  typedef Boundary_check<Kernel> Check;
  typedef typename Check::Segment_id Segment_id;

  // An edge some of whose pieces were halved.
  struct Halved_edge
  {
    std::vector<double> former_parameters;
    std::set<std::size_t> causes; // the faces for which they were
  };

  Division& m_division;
  const std::vector<Oracle>& m_oracles; // by face
  Patch_progress& m_progress;
  std::size_t m_number_of_splits = 0;

public:
  Crossing_refinement(Division& division, const std::vector<Oracle>& oracles, Patch_progress& progress)
    : m_division(division), m_oracles(oracles), m_progress(progress)
  {}

  // Checks the faces whose boundary has changed since the last call. After a stop it goes on: there is no mesh without it.
  void operator()()
  {
    std::map<std::size_t, Halved_edge> halved;
    for(auto faces = m_division.take_changed_faces(); !faces.empty(); faces = m_division.take_changed_faces()) {
      std::set<Piece> pieces;
      for(std::size_t face : faces) {
        std::set<Piece> pieces_of_face;
        const bool is_good = m_division.is_done_for(face, [&] {
          m_progress.go_further();
          with_name_of_face(m_division.model(), face, [&] { collect(face, pieces_of_face); });
        });
        if(is_good) {
          note(face, pieces_of_face, halved);
          pieces.merge(pieces_of_face);
        }
        else
          restore(face, halved, pieces);
      }
      m_number_of_splits += pieces.size();
      m_division.split(pieces);
    }
  }

  // Whether segments of a face cross as its edges are divided now, or one of its holes is misplaced by its pieces.
  bool has_crossings(std::size_t face) const
  {
    std::set<Piece> pieces;
    try {
      collect(face, pieces);
    }
    catch(const Parametric_surface_mesh_error&) {
      return true; // of pieces that cannot be halved
    }
    return !pieces.empty();
  }

  // the number of pieces that were halved so far
  std::size_t number_of_splits() const { return m_number_of_splits; }

private:
  // Notes the edges of pieces that are to be halved for a face.
  void note(std::size_t face, const std::set<Piece>& pieces, std::map<std::size_t, Halved_edge>& halved) const
  {
    for(const Piece& piece : pieces) {
      auto edge = halved.find(piece.edge);
      if(edge == halved.end())
        edge = halved.emplace(piece.edge, Halved_edge{m_division.parameters(piece.edge), {}}).first;
      edge->second.causes.insert(face);
    }
  }

  // Takes back what was done for a face that is left out now, and what is to be done: halving pieces did not help it, and would harm
  // its neighbours.
  void restore(std::size_t face, std::map<std::size_t, Halved_edge>& halved, std::set<Piece>& pieces)
  {
    for(auto edge = halved.begin(); edge != halved.end();)
      if(edge->second.causes == std::set<std::size_t>{face}) {
        for(auto piece = pieces.begin(); piece != pieces.end();)
          piece = piece->edge == edge->first ? pieces.erase(piece) : std::next(piece);
        if(!m_division.uses()[edge->first].empty())
          m_division.set_parameters(edge->first, edge->second.former_parameters);
        edge = halved.erase(edge);
      }
      else
        ++edge;
  }

  // Segments must not cross in the coordinates in which they are straight, those of the domain or of the chart.
  void collect(std::size_t face, std::set<Piece>& pieces) const
  {
    const Boundary_loops<Kernel> loops = m_division.boundary_loops(face);
    const Check check(loops);
    check.check_segments();
    const auto crossings = check.crossings();
    for(const auto& crossing : crossings) {
      bool is_any_halved = false;
      for(const Segment_id& segment : {crossing.first, crossing.second})
        is_any_halved |= !is_single_point(loops[segment.first]) && !is_straight(face, piece(face, segment).edge)
                         && insert_if_possible(piece(face, segment), pieces);
      if(!is_any_halved)
        throw Parametric_surface_mesh_error(check.describe_crossing(crossing));
    }
    if(crossings.empty()) {
      const Misplaced_holes<Oracle> collect_at_misplaced_holes(m_division, face, loops);
      collect_at_misplaced_holes(pieces);
      if(pieces.empty())
        collect_in_chart(face, loops, pieces);
    }
  }

  void collect_in_chart(std::size_t face, const Boundary_loops<Kernel>& loops, std::set<Piece>& pieces) const
  {
    const auto chart = find_chart(m_oracles[face].surface(), loops);
    if(chart.is_identity())
      return;
    const Boundary_loops<Kernel> charted_loops = chart_loops(loops, chart);
    const Check check(charted_loops);
    check.check_segments();
    for(const auto& crossing : check.crossings()) {
      bool is_any_halved = false;
      for(const Segment_id& segment : {crossing.first, crossing.second})
        is_any_halved |= !is_single_point(loops[segment.first])
                         && insert_if_possible(piece(face, segment_in_domain(loops, segment)), pieces);
      if(!is_any_halved)
        throw Parametric_surface_mesh_error("around a pole, in polar coordinates, " + check.describe_crossing(crossing));
    }
  }

  // Returns whether the piece can be halved.
  bool insert_if_possible(const Piece& piece, std::set<Piece>& pieces) const
  {
    if(!m_division.can_be_split(piece))
      return false;
    pieces.insert(piece);
    return true;
  }

  Piece piece(std::size_t face, const Segment_id& segment) const
  {
    return m_division.piece(face, segment.first, segment.second);
  }

  // Whether the edge is straight in the domain of the face, so that halving a piece does not change the boundary.
  bool is_straight(std::size_t face, std::size_t edge) const
  {
    for(const auto& use : m_division.uses()[edge])
      if(use.face == face && use.use->curve.is_straight())
        return true;
    return false;
  }

  // Converts a segment of the chart, which has none between copies of a pole.
  static Segment_id segment_in_domain(const Boundary_loops<Kernel>& loops, const Segment_id& in_chart)
  {
    const auto& loop = loops[in_chart.first];
    std::size_t left = in_chart.second, i = 0;
    for(;; ++i)
      if(!is_collapsed_side(loop, i) && left-- == 0)
        return {in_chart.first, i};
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_CROSSING_REFINEMENT_H
