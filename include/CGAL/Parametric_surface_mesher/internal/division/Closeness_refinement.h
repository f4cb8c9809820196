// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_CLOSENESS_REFINEMENT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_CLOSENESS_REFINEMENT_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Model_division.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Strip_division.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Strip_staggering.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Triangulated_boundary.h>
#include <CGAL/Parametric_surface_mesher/internal/model/name_face.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Where a face is narrower than the pieces of its boundary are long, triangles across it are flat, and no point inside can
// help. Such pieces are halved, as far as the minimum edge allows; so are those much longer than a neighbour on the loop,
// and those so much longer than the pieces across the face that triangles cannot grow from the ones to the others. The
// pieces at the tip of a cusp stay. Where pieces cannot be halved, points are moved along the edges of the strip.
template <class Oracle>
class Closeness_refinement
{
  typedef Model_division<Oracle> Division;
  typedef typename Division::Kernel Kernel;
  typedef typename Division::Piece Piece;
  typedef Triangulated_boundary<Oracle> Boundary;
  typedef typename Boundary::Triangulation Triangulation;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Face_handle Face_handle;

  struct Measured_piece
  {
    Piece piece;
    double length;
  };

  static const int max_number_of_rounds = 16;
  static constexpr double max_ratio = 2.5;      // of neighbours on a loop
  static constexpr double gradation = 1;        // by how much longer pieces across a face may be per distance
  static constexpr double largest_tip = 4;      // width of a cusp's tip, in minimum edges
  static constexpr double sharpness = 0.32;     // width of a cusp's tip over its length
  static constexpr double hopeless_share = 0.25; // of the minimum edge: what is narrower stays as it is

  Division& m_division;
  const std::vector<Oracle>& m_oracles; // of the faces
  const Parametric_surface_mesh_criteria& m_criteria;
  std::vector<Boundary>& m_boundaries; // of the faces
  std::set<std::size_t> m_faces_with_strips; // narrower than pieces of their edges that cannot be halved

public:
  // `boundaries`: of the faces; they follow the division
  Closeness_refinement(Division& division, const std::vector<Oracle>& oracles, const Parametric_surface_mesh_criteria& criteria,
                       std::vector<Boundary>& boundaries)
    : m_division(division), m_oracles(oracles), m_criteria(criteria), m_boundaries(boundaries)
  {
    m_boundaries.resize(oracles.size());
  }

  // returns how many pieces were halved
  std::size_t operator()()
  {
    std::size_t number_of_splits = 0;
    std::vector<std::size_t> faces(m_oracles.size());
    std::iota(faces.begin(), faces.end(), 0);
    for(int round = 0; round < max_number_of_rounds && !faces.empty(); ++round) {
      std::set<Piece> pieces;
      for(std::size_t face : faces)
        if(!m_division.model().faces()[face].loops.empty())
          with_name_of_face(m_division.model(), face, [&] { collect(face, pieces); });
      for(auto piece = pieces.begin(); piece != pieces.end();)
        piece = m_division.is_kept(*piece) ? pieces.erase(piece) : std::next(piece);
      number_of_splits += pieces.size();
      m_division.split(pieces);
      faces = m_division.faces_at(pieces);
    }
    divide_strips();
    stagger_strips();
    return number_of_splits;
  }

private:
  void divide_strips()
  {
    std::set<std::size_t> done; // edges
    for(std::size_t face : m_faces_with_strips)
      with_name_of_face(m_division.model(), face, [&] { done.merge(divide_strips(face, done)); });
  }

  std::set<std::size_t> divide_strips(std::size_t face, const std::set<std::size_t>& done)
  {
    Strip_division<Division> divide(m_division, m_criteria.min_edge());
    for_each_loop(face, [&](std::size_t l, const auto& segments, const auto& vertices, const auto& triangulation) {
      for(std::size_t i = 0; i < vertices.size(); ++i) {
        const Piece piece = m_division.piece(face, l, segments[i]);
        if(done.count(piece.edge) == 0 && !is_used_twice(face, piece.edge))
          collect_along_strip(piece, vertices[i], vertices[(i + 1) % vertices.size()], triangulation, divide);
      }
    });
    return divide();
  }

  // if the piece ought to be halved, and cannot be
  void collect_along_strip(const Piece& piece, Vertex_handle v, Vertex_handle w, const Triangulation& triangulation,
                           Strip_division<Division>& divide) const
  {
    const double l = length(v, w), width = this->width(v, w, triangulation);
    if(!(l < 2 * m_criteria.min_edge()))
      return;
    if(std::isinf(width))
      divide.collect_in_corner(piece);
    else if(l > *m_criteria.closeness() * width && width > hopeless_share * m_criteria.min_edge())
      divide.collect(piece);
  }

  // Points of an edge are moved for the first face that asks for it.
  void stagger_strips()
  {
    std::set<std::size_t> done; // edges
    for(std::size_t face : m_faces_with_strips)
      with_name_of_face(m_division.model(), face, [&] { done.merge(stagger_strips(face, done)); });
  }

  std::set<std::size_t> stagger_strips(std::size_t face, const std::set<std::size_t>& done)
  {
    Strip_staggering<Division, Triangulation> stagger(m_division, face, m_criteria.min_edge());
    for_each_loop(face, [&](std::size_t l, const auto& segments, const auto& vertices, const auto& triangulation) {
      stagger.collect(l, segments, vertices, triangulation, [&](std::size_t edge) {
        return done.count(edge) == 0 && !is_used_twice(face, edge);
      });
    });
    return stagger();
  }

  bool is_used_twice(std::size_t face, std::size_t edge) const
  {
    const auto& uses = m_division.uses()[edge];
    return std::count_if(uses.begin(), uses.end(), [=](const auto& use) { return use.face == face; }) > 1;
  }

  void collect(std::size_t face, std::set<Piece>& pieces)
  {
    for_each_loop(face, [&](std::size_t l, const auto& segments, const auto& vertices, const auto& triangulation) {
      collect(face, l, segments, vertices, triangulation, pieces);
    });
  }

  // Calls `function` with the number of each loop of a face, its segments and vertices, and a triangulation of all loops.
  template <class Function>
  void for_each_loop(std::size_t face, const Function& function)
  {
    Boundary& boundary = m_boundaries[face];
    boundary.update(m_oracles[face], m_division.boundary_loops(face));
    for(std::size_t l = 0; l < boundary.loops().size(); ++l)
      function(l, boundary.loops()[l].segments, boundary.loops()[l].vertices, boundary.triangulation());
  }

  void collect(std::size_t face, std::size_t number, const std::vector<std::size_t>& segments,
               const std::vector<Vertex_handle>& loop, const Triangulation& triangulation, std::set<Piece>& pieces)
  {
    const std::size_t n = loop.size();
    std::vector<double> lengths(n), sizes(n);
    for(std::size_t i = 0; i < n; ++i) {
      lengths[i] = length(loop[i], loop[(i + 1) % n]);
      sizes[i] = graded_size(loop[i], triangulation);
    }
    for(std::size_t i = 0; i < n; ++i) {
      const std::size_t next = (i + 1) % n;
      const Vertex_handle v = loop[i], w = loop[next];
      const double l = lengths[i];
      if(!(l >= 2 * m_criteria.min_edge())) {
        if(l > width(v, w, triangulation))
          m_faces_with_strips.insert(face);
        continue;
      }
      const double neighbor = (std::min)(lengths[(i + n - 1) % n], lengths[next]);
      if(is_longer(l, max_ratio * neighbor) || is_longer(l, *m_criteria.closeness() * width(v, w, triangulation))
         || l > (std::min)(sizes[i], sizes[next])) {
        const Piece piece = m_division.piece(face, number, segments[i]);
        if(m_division.can_be_split(piece))
          pieces.insert(piece);
      }
    }
    for(std::size_t i = 0; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n;
      if(is_tip(loop[before], loop[i], loop[(i + 1) % n], triangulation))
        even_out_tip({m_division.piece(face, number, segments[before]), lengths[before]},
                     {m_division.piece(face, number, segments[i]), lengths[i]}, pieces);
    }
  }

  // Whether the triangle of three vertices of a loop is the tip of a cusp, where two edges of the model meet.
  bool is_tip(Vertex_handle u, Vertex_handle v, Vertex_handle w, const Triangulation& triangulation) const
  {
    const double base = length(u, w);
    return base > 0 && base < largest_tip * m_criteria.min_edge()
           && base < sharpness * (std::min)(length(u, v), length(v, w)) && triangulation.is_face(u, v, w)
           && triangulation.geom_traits().orientation_2_object()(u->point(), v->point(), w->point()) == LEFT_TURN;
  }

  // In a tip the smallest angle is that of its corner, if the two pieces have much the same length. Halving both would but
  // add triangles as sharp as that.
  void even_out_tip(const Measured_piece& a, const Measured_piece& b, std::set<Piece>& pieces) const
  {
    const Measured_piece &longer = a.length > b.length ? a : b, &shorter = a.length > b.length ? b : a;
    if(longer.length > 1.4 * shorter.length && longer.length >= 2 * m_criteria.min_edge()
       && m_division.can_be_split(longer.piece))
      pieces.insert(longer.piece);
    else {
      m_division.keep(a.piece);
      m_division.keep(b.piece);
    }
  }

  bool is_longer(double length, double limit) const
  {
    return length > limit && limit > hopeless_share * m_criteria.min_edge();
  }

  // How long a piece at `v` may be for the sake of the pieces that edges across the face reach from there: as long as these,
  // and longer by a share of the distance. Where the face is narrower than the minimum edge this would not help.
  double graded_size(Vertex_handle v, const Triangulation& triangulation) const
  {
    double result = std::numeric_limits<double>::infinity();
    auto face = triangulation.incident_faces(v);
    const auto first = face;
    do
      if(face->is_in_domain())
        for(int i : {triangulation.cw(face->index(v)), triangulation.ccw(face->index(v))}) {
          const Vertex_handle x = face->vertex(i);
          const double d = distance(v, x);
          if(!face->is_constrained(3 - i - face->index(v)) && d >= m_criteria.min_edge())
            result = (std::min)(result, (std::max)(x->spacing(), m_criteria.min_edge()) + gradation * d);
        }
    while(++face != first);
    return result;
  }

  // The distance in space of the segment from the third corner of its triangle. (Not from its line: the triangles of a
  // round hole's boundary are flat, but none of its points is close to another piece.) Where the triangle has the next
  // segment for a side, that counts as a neighbour.
  static double width(Vertex_handle v, Vertex_handle w, const Triangulation& triangulation)
  {
    Face_handle face;
    int i = 0;
    double result = std::numeric_limits<double>::infinity();
    if(!triangulation.is_edge(v, w, face, i))
      return result;
    for(const auto& side : {std::make_pair(face, i), std::make_pair(face->neighbor(i), triangulation.mirror_index(face, i))}) {
      const Face_handle f = side.first;
      if(!f->is_in_domain() || f->is_constrained(triangulation.cw(side.second)) || f->is_constrained(triangulation.ccw(side.second)))
        continue;
      const typename Kernel::Segment_3 segment(v->point().surface_point(), w->point().surface_point());
      result = (std::min)(result, std::sqrt(squared_distance(f->vertex(side.second)->point().surface_point(), segment)));
    }
    return result;
  }

  // On the surface: points on either side of a closed surface are far from each other, however close they are in space.
  static double distance(Vertex_handle v, Vertex_handle w)
  {
    const auto &p = v->point(), &q = w->point();
    const double du = q.x() - p.x(), dv = q.y() - p.y();
    const double in_domain = std::sqrt((0.5 * (p.tensor() + q.tensor())).squared_length(du, dv));
    return (std::max)(in_domain, length(v, w));
  }

  static double length(Vertex_handle v, Vertex_handle w) { return Boundary::length(v, w); }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_CLOSENESS_REFINEMENT_H
