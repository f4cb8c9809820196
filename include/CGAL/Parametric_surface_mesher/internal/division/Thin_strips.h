// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_THIN_STRIPS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_THIN_STRIPS_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Model_division.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Triangulated_boundary.h>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// What lies opposite to a piece in a thin strip.
template <class Division>
struct Place_in_strip
{
  typedef typename Division::Kernel::Point_3 Point_3;

  struct Foot
  {
    double parameter, squared_distance;
  };

  std::size_t opposite_edge;
  double from, to; // the parameters of the opposite edge between which feet are looked for
  double length = 0, width = 0, wanted_length = 0;

  // The closest point of the opposite edge.
  Foot foot(const Division& division, const Point_3& p) const
  {
    const int number_of_samples = 8, bits = 20;
    const auto at = [&](double t) { return CGAL::squared_distance(p, division.point(opposite_edge, t)); };
    const double step = (to - from) / number_of_samples;
    Foot best{from, at(from)};
    for(int i = 1; i <= number_of_samples; ++i) {
      const double t = i < number_of_samples ? from + i * step : to, squared = at(t);
      if(squared < best.squared_distance)
        best = {t, squared};
    }
    const double low = (std::max)(best.parameter - step, from), high = (std::min)(best.parameter + step, to);
    const auto found = boost::math::tools::brent_find_minima(at, low, high, bits);
    return found.second < best.squared_distance ? Foot{found.first, found.second} : best;
  }
};

// The places along thin strips, by edge and number of the piece.
template <class Division>
using Places_in_strips = std::map<std::size_t, std::map<std::size_t, Place_in_strip<Division>>>;

/*
Finds thin strips: places of faces so narrow that pieces along them, as short as the minimum edge allows, make triangles with angles below
10 degrees. Where detail may vanish that is as wide as the strip, it counts only if it cannot vanish: between sheets that face each other or
face away from each other, as at the bottom of a narrow gap and at the rim of a thin wall.
*/
template <class Oracle>
class Thin_strips
{
public:
  typedef Model_division<Oracle> Division;
  typedef Place_in_strip<Division> Place;
  typedef Places_in_strips<Division> Places;

private:
  typedef typename Division::Kernel Kernel;
  typedef typename Division::Piece Piece;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;
  typedef Triangulated_boundary<Oracle> Boundary;
  typedef typename Boundary::Triangulation Triangulation;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Face_handle Face_handle;

  // A piece as long as so many widths makes triangles of 11 degrees where points are opposite to each other.
  static constexpr double harmless_ratio = 5;
  // No strip is narrower than this share of the minimum edge: there, two boundaries touch.
  static constexpr double least_width = 1. / 64;
  // The cosine of the largest angle between the normal of a sheet and the direction to the other one, if they face each other.
  static constexpr double cosine_of_facing = 0.5;

  Division& m_division;
  const std::vector<Oracle>& m_oracles;
  const Parametric_surface_mesh_criteria& m_criteria;

public:
  Thin_strips(Division& division, const std::vector<Oracle>& oracles, const Parametric_surface_mesh_criteria& criteria)
    : m_division(division), m_oracles(oracles), m_criteria(criteria)
  {}

  // Whether a piece is much longer than its face is wide there, and closeness does not help, since halves would be too short.
  static bool is_thin(double length, double width, double min_edge, double hopeless_width)
  {
    return length > harmless_ratio * width && (length < 2 * min_edge || width <= hopeless_width);
  }

  // The places of a face.
  // \pre the boundary is up to date
  Places operator()(std::size_t face, const Boundary& boundary) const
  {
    Places result;
    std::map<Vertex_handle, std::pair<std::size_t, std::size_t>> positions; // loop and number
    for(std::size_t l = 0; l < boundary.loops().size(); ++l)
      for(std::size_t i = 0; i < boundary.loops()[l].vertices.size(); ++i)
        positions.emplace(boundary.loops()[l].vertices[i], std::make_pair(l, i));
    for(std::size_t l = 0; l < boundary.loops().size(); ++l) {
      const auto& loop = boundary.loops()[l];
      for(std::size_t i = 0; i < loop.vertices.size(); ++i) {
        const Piece piece = m_division.piece(face, l, loop.segments[i]);
        const Vertex_handle v = loop.vertices[i], w = loop.vertices[(i + 1) % loop.vertices.size()],
                            across = vertex_across(v, w, boundary.triangulation());
        if(across == Vertex_handle() || !m_division.can_be_split(piece) || m_division.is_kept(piece))
          continue;
        const auto position = positions.find(across);
        if(position == positions.end())
          continue; // a single point inside the face
        const std::optional<Place> place = this->place(face, boundary, piece, position->second);
        if(place)
          result[piece.edge].emplace(piece.number, *place);
      }
    }
    return result;
  }

private:
  // The third corner of the triangle in the domain at a piece; none if that is in a corner of the domain, with the next piece of the loop
  // as a side. If this is short, it is the end of a strip, and no corner.
  static Vertex_handle vertex_across(Vertex_handle v, Vertex_handle w, const Triangulation& triangulation)
  {
    Face_handle face;
    int i = 0;
    if(!triangulation.is_edge(v, w, face, i))
      return Vertex_handle();
    if(!face->is_in_domain()) {
      const int mirrored = triangulation.mirror_index(face, i);
      face = face->neighbor(i);
      i = mirrored;
    }
    if(!face->is_in_domain())
      return Vertex_handle();
    const int before = triangulation.cw(i), after = triangulation.ccw(i);
    const Vertex_handle across = face->vertex(i), left = face->vertex(after), right = face->vertex(before);
    const double largest_end = Boundary::length(left, right) / harmless_ratio;
    const auto is_end = [&](Vertex_handle x) { return Boundary::length(across, x) < largest_end; };
    const bool is_in_corner = (face->is_constrained(before) && !is_end(left)) || (face->is_constrained(after) && !is_end(right));
    return is_in_corner ? Vertex_handle() : across;
  }

  // `across`: the loop and the number of the vertex across
  std::optional<Place> place(std::size_t face, const Boundary& boundary, const Piece& piece,
                             const std::pair<std::size_t, std::size_t>& across) const
  {
    const std::vector<double>& parameters = m_division.parameters(piece.edge);
    const double t = 0.5 * (parameters[piece.number] + parameters[piece.number + 1]);
    const auto &points = m_division.points(piece.edge);
    const double chord = std::sqrt(squared_distance(points[piece.number], points[piece.number + 1]));
    const Point_3 middle = m_division.point(piece.edge, t);
    const auto& loop = boundary.loops()[across.first];
    const std::size_t n = loop.vertices.size();
    std::optional<Place> result;
    for(const std::size_t i : {across.second, (across.second + n - 1) % n}) {
      const Piece opposite = m_division.piece(face, across.first, loop.segments[i]);
      if(opposite.edge == piece.edge)
        continue;
      Place place = place_around(opposite);
      place.width = std::sqrt(place.foot(m_division, middle).squared_distance);
      if(!result || place.width < result->width)
        result = place;
    }
    if(!result || !(result->width > least_width * m_criteria.min_edge()) || !(chord > harmless_ratio * result->width)
       || may_vanish(face, piece.edge, t, middle, *result))
      return std::nullopt;
    result->length = std::sqrt(squared_distance(points[piece.number], middle))
                     + std::sqrt(squared_distance(middle, points[piece.number + 1]));
    return result;
  }

  // Feet are looked for on a piece and those beside it.
  Place place_around(const Piece& opposite) const
  {
    const std::vector<double>& t = m_division.parameters(opposite.edge);
    const double first = t[opposite.number == 0 ? 0 : opposite.number - 1],
                 last = t[(std::min)(opposite.number + 2, t.size() - 1)];
    Place result;
    result.opposite_edge = opposite.edge;
    result.from = (std::min)(first, last);
    result.to = (std::max)(first, last);
    return result;
  }

  bool may_vanish(std::size_t face, std::size_t edge, double t, const Point_3& p, const Place& place) const
  {
    if(!m_criteria.detail() || place.width > *m_criteria.detail())
      return false;
    const auto foot = place.foot(m_division, p);
    const Vector_3 across = (m_division.point(place.opposite_edge, foot.parameter) - p) / std::sqrt(foot.squared_distance);
    const double here = normal_of_other_face(face, edge, t) * across,
                 there = -(normal_of_other_face(face, place.opposite_edge, foot.parameter) * across);
    return !((std::min)(here, there) > cosine_of_facing || (std::max)(here, there) < -cosine_of_facing);
  }

  // The unit normal, at a point of an edge, of another face that uses the edge, on the side that it faces to; 0 if there is none.
  Vector_3 normal_of_other_face(std::size_t face, std::size_t edge, double t) const
  {
    for(const auto& use : m_division.uses()[edge])
      if(use.face != face) {
        const auto uv = use.use->curve.point(t);
        const auto jet = m_oracles[use.face].surface().jet(uv.x(), uv.y());
        const Vector_3 normal = cross_product(jet.du, jet.dv);
        const double length = std::sqrt(normal * normal);
        if(length > 0)
          return (m_division.model().faces()[use.face].is_reversed ? -1 / length : 1 / length) * normal;
      }
    return NULL_VECTOR;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_THIN_STRIPS_H
