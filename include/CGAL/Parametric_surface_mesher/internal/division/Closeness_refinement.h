// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_CLOSENESS_REFINEMENT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_CLOSENESS_REFINEMENT_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Crossing_refinement.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Model_division.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Strip_division.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Strip_staggering.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Thin_strips.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Triangulated_boundary.h>
#include <CGAL/Parametric_surface_mesher/internal/division/divide_thin_strips.h>
#include <CGAL/Parametric_surface_mesher/internal/model/name_face.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Mesh_progress.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Where a face is narrower than the pieces of its boundary are long, triangles across it are flat, and no point inside can
// help. This class halves such pieces, as far as the minimum edge allows. It also halves pieces that are much longer than a
// neighbour on the loop, and pieces so much longer than those across the face that triangles cannot grow from one side to the
// other. The pieces at the tip of a cusp stay.
// Where angles below 10 degrees are left, pieces become shorter than the minimum edge, if that is cheap (`divide_thin_strips.h`).
// Where pieces cannot be divided, points are moved along the edges of the strip (`Strip_division.h`, `Strip_staggering.h`).
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

  // A piece with the vertex at its other end.
  struct Piece_at_vertex
  {
    Vertex_handle other;
    Measured_piece piece;
  };

  static constexpr int max_number_of_rounds = 16;
  // The largest ratio of the lengths of neighbours on a loop.
  static constexpr double max_ratio = 2.5;
  // Of two pieces opposite to each other the longer one may exceed the shorter by this share of the distance between them.
  static constexpr double gradation = 1;
  // The largest width of the tip of a cusp, in minimum edges: pieces at wider tips can be divided.
  static constexpr double largest_tip = 4;
  // The largest ratio of width and length of the tip of a cusp, which is that of an angle of 18 degrees.
  static constexpr double sharpness = 0.32;
  // Pieces at a tip whose lengths differ by less than this factor count as equally long.
  static constexpr double tolerated_ratio_at_tip = 1.4;
  // What is narrower than this share of the minimum edge stays as it is: pieces of the minimum edge would still be four times as
  // long as the face is wide.
  static constexpr double hopeless_share = 0.25;

  Division& m_division;
  const std::vector<Oracle>& m_oracles; // by face
  const Parametric_surface_mesh_criteria& m_criteria;
  std::vector<Boundary>& m_boundaries; // by face
  Crossing_refinement<Oracle>& m_refine_crossings;
  Patch_progress& m_progress;
  std::set<std::size_t> m_faces_with_strips; // those narrower than pieces that cannot be halved
  std::set<std::size_t> m_faces_with_thin_strips; // those so narrow that pieces may become shorter than the minimum edge
  Divided_thin_strips m_thin_strips;

public:
  // `boundaries` has the boundary of each face; these are kept up to date with the division. `refine_crossings` is called
  // whenever the division has changed: pieces may cross then, and only those that do not can be triangulated.
  Closeness_refinement(Division& division, const std::vector<Oracle>& oracles, const Parametric_surface_mesh_criteria& criteria,
                       std::vector<Boundary>& boundaries, Crossing_refinement<Oracle>& refine_crossings,
                       Patch_progress& progress)
    : m_division(division), m_oracles(oracles), m_criteria(criteria), m_boundaries(boundaries),
      m_refine_crossings(refine_crossings), m_progress(progress)
  {
    m_boundaries.resize(oracles.size());
  }

  // Returns the number of pieces that were halved. After a stop the division stays as it is.
  std::size_t operator()()
  {
    std::vector<std::size_t> faces(m_oracles.size());
    std::iota(faces.begin(), faces.end(), 0);
    std::size_t result = halve(faces);
    if(!m_faces_with_thin_strips.empty() && m_progress.go_further()) {
      m_thin_strips = divide_thin_strips(m_division, m_oracles, m_criteria, m_boundaries, m_faces_with_thin_strips);
      m_refine_crossings();
      result += halve({m_thin_strips.faces.begin(), m_thin_strips.faces.end()});
    }
    divide_strips();
    stagger_strips();
    return result;
  }

  const Divided_thin_strips& thin_strips() const { return m_thin_strips; }

private:
  // Halves pieces of these faces, and of those that use the same edges, until none is too long.
  std::size_t halve(std::vector<std::size_t> faces)
  {
    std::size_t result = 0;
    for(int round = 0; round < max_number_of_rounds && !faces.empty() && m_progress.go_further(); ++round) {
      std::set<Piece> pieces;
      for(std::size_t face : faces)
        if(m_progress.go_further())
          is_done_for(face, [&] { collect(face, pieces); });
      for(auto piece = pieces.begin(); piece != pieces.end();)
        piece = m_division.is_kept(*piece) ? pieces.erase(piece) : std::next(piece);
      result += pieces.size();
      m_division.split(pieces);
      faces = m_division.faces_at(pieces);
      m_refine_crossings();
    }
    return result;
  }

  template <class Function>
  bool is_done_for(std::size_t face, const Function& function)
  {
    return m_division.is_done_for(face, [&] { with_name_of_face(m_division.model(), face, function); });
  }

  void divide_strips()
  {
    std::set<std::size_t> done; // edges
    for(std::size_t face : m_faces_with_strips)
      if(m_progress.go_further()) {
        is_done_for(face, [&] { done.merge(divide_strips(face, done)); });
        m_refine_crossings();
      }
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

  // Notes a piece that would have to be halved and is too short for it.
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

  // The points of an edge are moved for the first face with strips that uses it; not if pieces would cross then.
  void stagger_strips()
  {
    std::set<std::size_t> done; // edges
    for(std::size_t face : m_faces_with_strips)
      if(m_progress.go_further())
        is_done_for(face, [&] { done.merge(stagger_strips(face, done)); });
    m_refine_crossings(); // of which staggering makes none
  }

  std::set<std::size_t> stagger_strips(std::size_t face, const std::set<std::size_t>& done)
  {
    Strip_staggering<Division, Triangulation> stagger(m_division, face, m_criteria.min_edge());
    for_each_loop(face, [&](std::size_t l, const auto& segments, const auto& vertices, const auto& triangulation) {
      stagger.collect(l, segments, vertices, triangulation, [&](std::size_t edge) {
        return done.count(edge) == 0 && !is_used_twice(face, edge);
      });
    });
    const auto former = stagger();
    std::set<std::size_t> edges, faces;
    for(const auto& edge : former) {
      edges.insert(edge.first);
      for(const auto& use : m_division.uses()[edge.first])
        faces.insert(use.face);
    }
    if(std::any_of(faces.begin(), faces.end(), [this](std::size_t f) { return m_refine_crossings.has_crossings(f); }))
      for(const auto& edge : former)
        m_division.set_parameters(edge.first, edge.second);
    return edges;
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
    even_out_tips_at_touches(face, pieces);
  }

  // Where loops touch, or a loop touches itself, the pieces at a tip do not follow each other in a loop.
  // \pre the boundary is up to date
  void even_out_tips_at_touches(std::size_t face, std::set<Piece>& pieces)
  {
    const Boundary& boundary = m_boundaries[face];
    if(!has_touches(boundary))
      return;
    std::map<Vertex_handle, std::vector<Piece_at_vertex>> pieces_at;
    for(std::size_t l = 0; l < boundary.loops().size(); ++l) {
      const auto& loop = boundary.loops()[l];
      for(std::size_t i = 0; i < loop.vertices.size(); ++i) {
        const Vertex_handle v = loop.vertices[i], w = loop.vertices[(i + 1) % loop.vertices.size()];
        const Measured_piece piece{m_division.piece(face, l, loop.segments[i]), length(v, w)};
        pieces_at[v].push_back({w, piece});
        pieces_at[w].push_back({v, piece});
      }
    }
    for(const auto& at_vertex : pieces_at)
      if(at_vertex.second.size() > 2)
        for(const Piece_at_vertex& a : at_vertex.second)
          for(const Piece_at_vertex& b : at_vertex.second)
            if(is_tip(a.other, at_vertex.first, b.other, boundary.triangulation()))
              even_out_tip(a.piece, b.piece, pieces);
  }

  // Whether a vertex comes more than once in the loops, which is so at a pole, too.
  static bool has_touches(const Boundary& boundary)
  {
    std::vector<std::size_t> indices;
    for(const auto& loop : boundary.loops())
      for(Vertex_handle v : loop.vertices)
        indices.push_back(v->index());
    std::sort(indices.begin(), indices.end());
    return std::adjacent_find(indices.begin(), indices.end()) != indices.end();
  }

  // For each loop of a face, calls `function` with its index, its segments and vertices, and the triangulation of all loops.
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
      if(!m_progress.go_further())
        return;
      lengths[i] = length(loop[i], loop[(i + 1) % n]);
      sizes[i] = graded_size(loop[i], triangulation);
    }
    for(std::size_t i = 0; i < n; ++i) {
      const std::size_t next = (i + 1) % n;
      const Vertex_handle v = loop[i], w = loop[next];
      const double l = lengths[i], width = this->width(v, w, triangulation);
      if(Thin_strips<Oracle>::is_thin(l, width, m_criteria.min_edge(), hopeless_share * m_criteria.min_edge()))
        m_faces_with_thin_strips.insert(face);
      if(!(l >= 2 * m_criteria.min_edge())) {
        if(l > width)
          m_faces_with_strips.insert(face);
        continue;
      }
      const double neighbor = (std::min)(lengths[(i + n - 1) % n], lengths[next]);
      if(is_longer(l, max_ratio * neighbor) || is_longer(l, *m_criteria.closeness() * width)
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
    Face_handle face;
    return base > 0 && base < largest_tip * m_criteria.min_edge()
           && base < sharpness * (std::min)(length(u, v), length(v, w)) && triangulation.is_face(u, v, w, face)
           && face->is_in_domain()
           && triangulation.geom_traits().orientation_2_object()(u->point(), v->point(), w->point()) == LEFT_TURN;
  }

  // If the two pieces at a tip have about the same length, the smallest angle there is that of the corner. Halving both would only
  // add more triangles that are as sharp.
  void even_out_tip(const Measured_piece& a, const Measured_piece& b, std::set<Piece>& pieces) const
  {
    const Measured_piece &longer = a.length > b.length ? a : b, &shorter = a.length > b.length ? b : a;
    if(longer.length > tolerated_ratio_at_tip * shorter.length && longer.length >= 2 * m_criteria.min_edge()
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

  // The largest length of a piece at `v` that lets triangles grow to the pieces at the other ends of edges across the face: the
  // length of these, plus a share of the distance. Where the face is narrower than the minimum edge there is no such bound, since
  // it would not help.
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

  // The distance in space between the segment and the third corner of its triangle. It is not the distance from the line through
  // the segment: the triangles at the boundary of a round hole are flat, but its points are not close to other pieces. If the
  // next segment of the loop is a side of the triangle, it counts as a neighbour and not as close.
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

  // The distance along the surface: points on opposite sides of a thin closed surface are far from each other, however close they
  // are in space.
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
