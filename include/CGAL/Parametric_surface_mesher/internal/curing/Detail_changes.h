// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_DETAIL_CHANGES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_DETAIL_CHANGES_H

#include <CGAL/Parametric_surface_mesher/internal/curing/Triangle_complex.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The changes around a triangle that keep the topology of each shell: vertices that are joined, vertices that are put into an
// edge close by, and flips. How far points move is added up: a change is a map, linear on each triangle, from the surface
// before to that after it, and no point moves farther than the vertices of its triangle. So both surfaces are, in either
// direction, no farther apart than the displacements of their vertices are long.
template <class Kernel>
class Detail_changes
{
  typedef Triangle_complex<Kernel> Complex;
  typedef typename Complex::Triangle Triangle;
  typedef typename Complex::Neighbors Neighbors;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;
  typedef std::size_t Index;

public:
  typedef typename Complex::Change Change;

private:
  const Complex& m_complex;
  double m_width; // the largest distance that a point may move

public:
  Detail_changes(const Complex& complex, double width) : m_complex(complex), m_width(width) {}

  // All changes that may remove a triangle and move points by no more than the width.
  std::vector<Change> around(Index t) const
  {
    std::vector<Change> result;
    const auto add = [&](const std::optional<Change>& change) {
      if(change)
        result.push_back(*change);
    };
    const std::array<Index, 3> v = m_complex.triangle(t).vertices;
    for(std::size_t i = 0; i < 3; ++i) {
      add(collapse(v[i], v[(i + 1) % 3]));
      add(collapse(v[(i + 1) % 3], v[i]));
      add(insertion(t, i));
      add(flip(t, i));
      for(const Index x : vertices_beside(t, i))
        for(const Index end : {v[i], v[(i + 1) % 3]}) {
          add(collapse(x, end));
          add(collapse(end, x));
        }
    }
    return result;
  }

  // Those that move points farther, along edges of the model and inside faces, where points of the mesh are too dense.
  std::vector<Change> slides_around(Index t) const
  {
    std::vector<Change> result;
    const std::array<Index, 3> v = m_complex.triangle(t).vertices;
    for(std::size_t i = 0; i < 3; ++i)
      for(const auto& change : {slide(v[i], v[(i + 1) % 3]), slide(v[(i + 1) % 3], v[i])})
        if(change)
          result.push_back(*change);
    return result;
  }

private:
  const Point_3& point(Index v) const { return m_complex.vertex(v).point; }
  const Displacement& displacement(Index v) const { return m_complex.vertex(v).displacement; }

  // The third corners of the triangles on the other side of a short side. Where several vertices are close to each other, as at the ends of
  // short edges, it may be these that have to be joined first: the triangle itself would fold.
  std::vector<Index> vertices_beside(Index t, std::size_t i) const
  {
    std::vector<Index> result;
    const Index a = m_complex.triangle(t).vertices[i], b = m_complex.triangle(t).vertices[(i + 1) % 3];
    if(squared_distance(point(a), point(b)) <= m_width * m_width)
      for(const Index other : m_complex.triangles_at(a, b))
        if(other != t)
          result.push_back(m_complex.triangle(other).apex(a, b));
    return result;
  }

  // Vertex `a` moves to `b`, which is close.
  std::optional<Change> collapse(Index a, Index b) const
  {
    const auto &from = m_complex.vertex(a), &to = m_complex.vertex(b);
    const Displacement displacement = to.displacement.joined_with(from.displacement.moved(from.point, to.point));
    if(!can_be_joined(a, b) || !(displacement.length() <= m_width) || !keeps_topology(a, b))
      return std::nullopt;
    Change result = joined(a, b);
    result.removes_detail = from.dimension < 2 && to.dimension < 2 && are_on_different_entities(a, b);
    result.displacements = {{b, displacement}};
    return result;
  }

  // Vertex `a` vanishes by a move to `b`, at any distance, along an edge of the model or inside a face. What matters is how far it
  // was from the edge, or the triangle, that is there now.
  std::optional<Change> slide(Index a, Index b) const
  {
    const auto &from = m_complex.vertex(a), &to = m_complex.vertex(b);
    if(!can_be_joined(a, b) || squared_distance(from.point, to.point) <= m_width * m_width || from.dimension == 0
       || !keeps_topology(a, b) || !knows_all_places(a, b))
      return std::nullopt;
    Change result = joined(a, b);
    const std::set<Index> along = neighbors_on_patch_borders(a);
    const bool is_found = along.empty() ? place_in_triangles(a, result)
                                        : along.size() == 2 && along.count(b) > 0
                                            && place_on_edge(a, b, *along.begin() == b ? *along.rbegin() : *along.begin(), result);
    return is_found ? std::optional<Change>(result) : std::nullopt;
  }

  bool can_be_joined(Index a, Index b) const
  {
    const auto &from = m_complex.vertex(a), &to = m_complex.vertex(b);
    return !from.is_fixed && !to.is_fixed && from.dimension >= to.dimension;
  }

  Change joined(Index a, Index b) const
  {
    Change result{{}, {}, b, m_complex.vertex(b).dimension, false, {}};
    for(Index t : m_complex.vertex(a).triangles) {
      result.removed.push_back(t);
      if(m_complex.triangle(t).has(b))
        continue;
      Triangle triangle = m_complex.triangle(t);
      const std::size_t i = triangle.corner(a);
      triangle.uv[i] = uv_of_other(t, a, b).value_or(triangle.uv[i]); // `b` is close to `a`, if its place is not known
      triangle.vertices[i] = b;
      triangle.replaced = t;
      result.added.push_back(triangle);
    }
    return result;
  }

  bool are_on_different_entities(Index a, Index b) const
  {
    const auto &v = m_complex.vertex(a), &w = m_complex.vertex(b);
    return v.dimension != w.dimension || v.dimension == 0 || v.entity != w.entity;
  }

  // The place of `b` in the domain that triangle `t` at `a` lies in, if it is known there.
  std::optional<Point_2> uv_of_other(Index t, Index a, Index b) const
  {
    const Triangle& triangle = m_complex.triangle(t);
    for(Index at_edge : m_complex.triangles_at(a, b)) {
      const Triangle& other = m_complex.triangle(at_edge);
      if(other.patch == triangle.patch && other.uv[other.corner(a)] == triangle.uv[triangle.corner(a)])
        return other.uv[other.corner(b)];
    }
    return std::nullopt;
  }

  bool knows_all_places(Index a, Index b) const
  {
    const auto& triangles = m_complex.vertex(a).triangles;
    return std::all_of(triangles.begin(), triangles.end(), [&](Index t) { return bool(uv_of_other(t, a, b)); });
  }

  std::set<Index> neighbors_on_patch_borders(Index v) const
  {
    std::set<Index> result;
    for(Index t : m_complex.vertex(v).triangles) {
      const std::size_t i = m_complex.triangle(t).corner(v);
      if(m_complex.is_on_patch_border(t, i))
        result.insert(m_complex.triangle(t).vertices[(i + 1) % 3]);
      if(m_complex.is_on_patch_border(t, (i + 2) % 3))
        result.insert(m_complex.triangle(t).vertices[(i + 2) % 3]);
    }
    return result;
  }

  // Vertex `a` moves into the edge from `b` to `c`.
  bool place_on_edge(Index a, Index b, Index c, Change& change) const
  {
    const double share = share_of_foot(b, c, a);
    if(!(share > 0 && share < 1))
      return false;
    const Displacement displacement = this->displacement(a).moved(point(a), between(b, c, share));
    return add_displacements({b, c}, displacement, change);
  }

  // Vertex `a` moves into the first of the new triangles that it is over.
  bool place_in_triangles(Index a, Change& change) const
  {
    for(const Triangle& triangle : change.added) {
      const auto& v = triangle.vertices;
      const Vector_3 normal = cross_product(point(v[1]) - point(v[0]), point(v[2]) - point(v[0]));
      bool is_inside = normal.squared_length() > 0;
      for(std::size_t i = 0; i < 3 && is_inside; ++i)
        is_inside = cross_product(point(v[(i + 1) % 3]) - point(v[i]), point(a) - point(v[i])) * normal >= 0;
      if(!is_inside)
        continue;
      const Point_3 foot = point(a) - ((point(a) - point(v[0])) * normal / normal.squared_length()) * normal;
      return add_displacements({v[0], v[1], v[2]}, displacement(a).moved(point(a), foot), change);
    }
    return false;
  }

  // returns whether no point moves too far
  bool add_displacements(const std::vector<Index>& vertices, const Displacement& displacement, Change& change) const
  {
    for(Index v : vertices) {
      change.displacements.emplace_back(v, this->displacement(v).joined_with(displacement));
      if(!(change.displacements.back().second.length() <= m_width))
        return false;
    }
    return true;
  }

  // The link condition, in each shell: common neighbours of the two are those in triangles with both. The border, and edges with
  // more than two triangles, are joined along themselves only.
  bool keeps_topology(Index a, Index b) const
  {
    for(Index shell : m_complex.shells_at(a)) {
      const Neighbors at_a = m_complex.neighbors(a, shell), at_b = m_complex.neighbors(b, shell);
      if(at_b.empty())
        continue;
      const auto edge = at_a.find(b);
      if(edge == at_a.end())
        return false;
      int number_of_common = 0;
      const bool are_singular = is_singular(at_a) && is_singular(at_b);
      if(are_singular && edge->second == 2)
        return false;
      for(const auto& neighbor : at_a) {
        const auto other = at_b.find(neighbor.first);
        if(other == at_b.end())
          continue;
        ++number_of_common;
        if(are_singular && neighbor.second != 2 && other->second != 2)
          return false;
      }
      if(number_of_common != edge->second || have_common_opposite_side(a, b, shell))
        return false;
    }
    return true;
  }

  static bool is_singular(const Neighbors& neighbors)
  {
    return std::any_of(neighbors.begin(), neighbors.end(), [](const auto& neighbor) { return neighbor.second != 2; });
  }

  bool have_common_opposite_side(Index a, Index b, Index shell) const
  {
    for(Index t : m_complex.vertex(a).triangles) {
      const Triangle& triangle = m_complex.triangle(t);
      if(!triangle.is_in(shell) || triangle.has(b))
        continue;
      const std::size_t i = triangle.corner(a);
      for(Index other : m_complex.triangles_at(triangle.vertices[(i + 1) % 3], triangle.vertices[(i + 2) % 3]))
        if(m_complex.triangle(other).is_in(shell) && m_complex.triangle(other).has(b))
          return true;
    }
    return false;
  }

  // Corner `i` of a triangle is put into the opposite edge; the triangles on the other side of it are split.
  std::optional<Change> insertion(Index t, std::size_t i) const
  {
    const Triangle& triangle = m_complex.triangle(t);
    const Index c = triangle.vertices[i], a = triangle.vertices[(i + 1) % 3], b = triangle.vertices[(i + 2) % 3];
    const double share = share_of_foot(a, b, c);
    if(!(share > 0 && share < 1))
      return std::nullopt;
    const Point_3 foot = between(a, b, share);
    if(m_complex.vertex(c).is_fixed || (m_complex.vertex(a).is_fixed && m_complex.vertex(b).is_fixed) || !can_be_inserted(a, b, c))
      return std::nullopt;
    const bool is_edge_of_model = m_complex.is_on_patch_border(t, (i + 1) % 3);
    const int dimension = m_complex.vertex(c).dimension;
    Change result{m_complex.triangles_at(a, b), {}, c, is_edge_of_model ? (std::min)(dimension, 1) : dimension, is_edge_of_model, {}};
    if(!add_displacements({c}, Displacement::between(displacement(a), displacement(b), share).moved(foot, point(c)), result))
      return std::nullopt;
    for(Index other : result.removed)
      if(!m_complex.triangle(other).has(c))
        split(other, a, b, c, share, result);
    return result;
  }

  double share_of_foot(Index a, Index b, Index c) const
  {
    const Vector_3 side = point(b) - point(a);
    return (point(c) - point(a)) * side / side.squared_length();
  }

  // In each shell with the edge and the vertex, one triangle must have both, and no other edge may lead from the vertex to the
  // triangles on the other side.
  bool can_be_inserted(Index a, Index b, Index c) const
  {
    for(Index shell : m_complex.shells_at(c)) {
      const Neighbors at_c = m_complex.neighbors(c, shell);
      int number_of_triangles = 0, number_with_vertex = 0;
      for(Index t : m_complex.triangles_at(a, b)) {
        const Triangle& triangle = m_complex.triangle(t);
        if(!triangle.is_in(shell))
          continue;
        ++number_of_triangles;
        if(triangle.has(c))
          ++number_with_vertex;
        else if(at_c.count(triangle.apex(a, b)) > 0)
          return false;
      }
      if(number_of_triangles > 0 && (number_with_vertex != 1 || (number_of_triangles != 2 && is_singular(at_c))))
        return false;
    }
    return true;
  }

  void split(Index t, Index a, Index b, Index c, double share, Change& result) const
  {
    const Triangle& triangle = m_complex.triangle(t);
    const std::size_t i = triangle.corner(a), j = triangle.corner(b);
    const Point_2 uv(triangle.uv[i].x() + share * (triangle.uv[j].x() - triangle.uv[i].x()),
                     triangle.uv[i].y() + share * (triangle.uv[j].y() - triangle.uv[i].y()));
    for(std::size_t k : {i, j}) {
      Triangle half = triangle;
      half.vertices[k] = c;
      half.uv[k] = uv;
      half.replaced = t;
      result.added.push_back(half);
    }
  }

  // The edge between corners `i` and `i + 1`, inside a patch, is replaced by that between the corners opposite to it.
  std::optional<Change> flip(Index t, std::size_t i) const
  {
    const Triangle& triangle = m_complex.triangle(t);
    const Index a = triangle.vertices[i], b = triangle.vertices[(i + 1) % 3], c = triangle.vertices[(i + 2) % 3];
    const std::vector<Index> both = m_complex.triangles_at(a, b);
    if(both.size() != 2 || m_complex.vertex(c).is_fixed || m_complex.vertex(a).is_fixed)
      return std::nullopt;
    const Triangle& other = m_complex.triangle(both[0] == t ? both[1] : both[0]);
    if(other.patch != triangle.patch || other.uv[other.corner(a)] != triangle.uv[i]
       || other.uv[other.corner(b)] != triangle.uv[(i + 1) % 3])
      return std::nullopt;
    const Index d = other.apex(a, b);
    const auto shares = shares_of_crossing(a, b, c, d);
    if(d == c || !shares || !m_complex.triangles_at(c, d).empty())
      return std::nullopt;
    const Displacement at_crossing
      = Displacement::between(displacement(a), displacement(b), shares->first).moved(between(a, b, shares->first), between(c, d, shares->second));
    Change result{both, {triangle, triangle}, c, m_complex.vertex(c).dimension, false, {}};
    if(!add_displacements({c, d}, at_crossing, result))
      return std::nullopt;
    const Point_2 uv = other.uv[other.corner(d)];
    for(std::size_t k : {std::size_t(0), std::size_t(1)}) {
      result.added[k].replaced = both[k];
      result.added[k].vertices[(i + k) % 3] = d;
      result.added[k].uv[(i + k) % 3] = uv;
    }
    return result;
  }

  Point_3 between(Index a, Index b, double share) const { return point(a) + share * (point(b) - point(a)); }

  // Where the edge from `a` to `b` is closest to the line from `c` to `d`, and the other way round; none if that is not between
  // the vertices.
  std::optional<std::pair<double, double>> shares_of_crossing(Index a, Index b, Index c, Index d) const
  {
    const Vector_3 first = point(b) - point(a), second = point(d) - point(c), apart = point(c) - point(a),
                   normal = cross_product(first, second);
    const double squared_length = normal.squared_length();
    if(!(squared_length > 0))
      return std::nullopt;
    const double of_first = cross_product(apart, second) * normal / squared_length,
                 of_second = cross_product(apart, first) * normal / squared_length;
    if(!(of_first > 0 && of_first < 1 && of_second > 0 && of_second < 1))
      return std::nullopt;
    return std::make_pair(of_first, of_second);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_DETAIL_CHANGES_H
