// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_FLAT_PIECES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_FLAT_PIECES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Box_hierarchy.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Pieces of a part of a mesh, each of which is connected and has normals within 60 degrees of one direction. Seen along that, all
// triangles of a piece have the same orientation. If, seen so, no two sides of the border of a piece meet but at their ends, and one of the
// border's loops runs counterclockwise, no point is behind two triangles: then none of them pass through each other.
template <class Part>
class Flat_pieces
{
public:
  typedef Exact_predicates_inexact_constructions_kernel::Point_3 Point_3;
  typedef Exact_predicates_inexact_constructions_kernel::Vector_3 Vector_3;
  typedef std::uint32_t Index;

  struct Piece
  {
    std::vector<Index> faces;
    bool is_apart; // whether it is known that none of its triangles pass through each other
  };

private:
  static constexpr Index none = Index(-1);
  static constexpr double least_cosine = 0.5;
  // Distances and areas in the plane that are below this share of the lengths they are computed from may be rounding errors.
  static constexpr double rounding = 1e-12;

  struct Point_in_plane
  {
    double x, y, z; // z is 0: boxes have three coordinates

    double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  };

  // A side of a triangle on the border of a piece.
  struct Border_side
  {
    Index source, target;
    Point_in_plane p, q;
  };

  const Part& m_part;
  std::vector<Index> m_opposite;    // by side, the side opposite to it, or none
  std::vector<Vector_3> m_normals;  // of length 1, by face
  std::vector<Index> m_piece_of_face;

public:
  // \pre the part has its place in the mesh
  explicit Flat_pieces(const Part& part) : m_part(part), m_piece_of_face(part.faces.size(), Index(none)) { find_opposite_sides(); }

  // `point`: gives the point of a vertex
  template <class Point_of_vertex>
  std::vector<Piece> operator()(const Point_of_vertex& point)
  {
    for(const auto& face : m_part.faces) {
      const Point_3 p = point(face[0]);
      const Vector_3 normal = cross_product(point(face[1]) - p, point(face[2]) - p);
      const double length = std::sqrt(normal * normal);
      m_normals.push_back(length > 0 ? normal / length : normal);
    }
    std::vector<Piece> result;
    for(Index f = 0; f < m_part.faces.size(); ++f)
      if(m_piece_of_face[f] == none) {
        result.push_back({connected_faces(f, Index(result.size())), false});
        result.back().is_apart = is_apart(result.back().faces, m_normals[f], point);
      }
    return result;
  }

private:
  void find_opposite_sides()
  {
    std::vector<bool> is_border(3 * m_part.faces.size(), false);
    for(const auto side : m_part.border)
      is_border[side] = true;
    std::vector<Index> sides(2 * m_part.number_of_edges, Index(none)); // by halfedge
    const auto halfedge = [&](std::size_t side) { return m_part.halfedge(side) - 2 * m_part.first_edge; };
    for(std::size_t side = 0; side < is_border.size(); ++side)
      if(!is_border[side])
        sides[halfedge(side)] = Index(side);
    m_opposite.assign(is_border.size(), Index(none));
    for(std::size_t side = 0; side < is_border.size(); ++side)
      if(!is_border[side])
        m_opposite[side] = sides[halfedge(side) ^ 1];
  }

  // The faces around one, as long as their normals are close to its.
  std::vector<Index> connected_faces(Index first, Index piece)
  {
    std::vector<Index> result(1, first);
    m_piece_of_face[first] = piece;
    for(std::size_t i = 0; i < result.size(); ++i)
      for(Index side = 3 * result[i]; side < 3 * result[i] + 3; ++side) {
        const Index neighbor = m_opposite[side] == none ? Index(none) : m_opposite[side] / 3;
        if(neighbor != none && m_piece_of_face[neighbor] == none && m_normals[neighbor] * m_normals[first] > least_cosine) {
          m_piece_of_face[neighbor] = piece;
          result.push_back(neighbor);
        }
      }
    return result;
  }

  template <class Point_of_vertex>
  bool is_apart(const std::vector<Index>& faces, const Vector_3& normal, const Point_of_vertex& point) const
  {
    if(!(normal * normal > 0))
      return false;
    const Vector_3 axis = std::fabs(normal.x()) < 0.6 ? Vector_3(1, 0, 0) : Vector_3(0, 1, 0);
    const Vector_3 across = cross_product(normal, axis), x = across / std::sqrt(across * across), y = cross_product(normal, x);
    const Point_3 origin = point(m_part.faces[faces[0]][0]);
    std::vector<Border_side> border;
    const auto in_plane = [&](Index v) {
      const Vector_3 d = point(v) - origin;
      return Point_in_plane{d * x, d * y, 0};
    };
    for(const Index f : faces)
      for(Index side = 3 * f; side < 3 * f + 3; ++side)
        if(m_opposite[side] == none || m_piece_of_face[m_opposite[side] / 3] != m_piece_of_face[f]) {
          const Index v = Index(m_part.source(side)), w = Index(m_part.target(side));
          border.push_back({v, w, in_plane(v), in_plane(w)});
        }
    std::sort(border.begin(), border.end(), [](const Border_side& a, const Border_side& b) { return a.source < b.source; });
    return has_one_outer_loop(border) && is_simple(border);
  }

  static const Border_side* side_from(Index vertex, const std::vector<Border_side>& border)
  {
    const auto found = std::lower_bound(border.begin(), border.end(), vertex,
                                        [](const Border_side& side, Index v) { return side.source < v; });
    return found == border.end() || found->source != vertex ? nullptr : &*found;
  }

  // Whether the sides form loops, one of which runs counterclockwise.
  static bool has_one_outer_loop(const std::vector<Border_side>& border)
  {
    for(std::size_t i = 0; i + 1 < border.size(); ++i)
      if(border[i].source == border[i + 1].source)
        return false;
    std::vector<bool> is_done(border.size(), false);
    int number_of_outer_loops = 0;
    for(std::size_t first = 0; first < border.size(); ++first) {
      double area = 0;
      for(std::size_t i = first; !is_done[i];) {
        is_done[i] = true;
        area += border[i].p.x * border[i].q.y - border[i].p.y * border[i].q.x;
        const Border_side* next = side_from(border[i].target, border);
        if(next == nullptr)
          return false;
        i = std::size_t(next - border.data());
      }
      number_of_outer_loops += area > 0;
    }
    return number_of_outer_loops == 1;
  }

  static bool is_simple(const std::vector<Border_side>& border)
  {
    std::vector<Small_box> boxes(border.size());
    for(std::size_t i = 0; i < border.size(); ++i) {
      boxes[i].add(border[i].p);
      boxes[i].add(border[i].q);
    }
    bool result = true;
    Box_hierarchy(std::move(boxes)).for_each_overlapping_pair([&](std::size_t i, std::size_t k) {
      result = result && are_apart(border[i], border[k]);
    });
    return result;
  }

  // Whether two sides certainly have no point in common but an end where one follows the other.
  static bool are_apart(const Border_side& a, const Border_side& b)
  {
    if(a.target == b.source || b.target == a.source) {
      const Border_side &first = a.target == b.source ? a : b, &second = a.target == b.source ? b : a;
      return first.source != second.target
             && (std::fabs(area(first.p, first.q, second.q)) > bound(first.p, first.q, second.q) || product(first, second) > 0);
    }
    return is_on_one_side(a, b) || is_on_one_side(b, a);
  }

  static double product(const Border_side& a, const Border_side& b)
  {
    return (a.q.x - a.p.x) * (b.q.x - b.p.x) + (a.q.y - a.p.y) * (b.q.y - b.p.y);
  }

  // Whether the ends of `b` are on the same side of the line through `a`.
  static bool is_on_one_side(const Border_side& a, const Border_side& b)
  {
    const double p = area(a.p, a.q, b.p), q = area(a.p, a.q, b.q);
    return std::fabs(p) > bound(a.p, a.q, b.p) && std::fabs(q) > bound(a.p, a.q, b.q) && (p > 0) == (q > 0);
  }

  static double area(const Point_in_plane& a, const Point_in_plane& b, const Point_in_plane& c)
  {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }

  static double bound(const Point_in_plane& a, const Point_in_plane& b, const Point_in_plane& c)
  {
    const double extent = std::fabs(a.x) + std::fabs(a.y) + std::fabs(b.x) + std::fabs(b.y) + std::fabs(c.x) + std::fabs(c.y);
    return rounding * extent * (std::fabs(b.x - a.x) + std::fabs(b.y - a.y) + std::fabs(c.x - a.x) + std::fabs(c.y - a.y));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_FLAT_PIECES_H
