// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_STRIP_STAGGERING_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_STRIP_STAGGERING_H

#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
In a strip so narrow that no point has room inside, triangles are best where the points of either side lie opposite to the
middles of the other one's pieces. Where the minimum edge forbids shorter pieces, points of the division are moved along
their edges for that. No piece gets shorter than the minimum edge, or as long as two of it, as it would be halved.
*/
template <class Division, class Triangulation>
class Strip_staggering
{
public:
  typedef std::map<std::size_t, std::vector<double>> Parameters; // by edge

private:
  typedef typename Division::Kernel::Point_3 Point_3;
  typedef typename Division::Piece Piece;
  typedef typename Triangulation::Vertex_handle Vertex_handle;

  // An inner point of an edge, by its place in the division of the edge and its index in the mesh.
  struct Slider
  {
    std::size_t edge, number, index;
    std::array<std::size_t, 2> neighbors;                   // indices of the points beside it on the edge
    std::vector<std::pair<std::size_t, std::size_t>> sides; // the sides opposite to it in its triangles, by indices
  };

  // The quality of the triangles around a point. The product is included because the smallest angle alone would not move a row of
  // points of which each can move only together with the others.
  struct Fan_quality
  {
    double smallest = 1, product = 1; // among the squared sines of the smallest angles of the triangles
  };

  static constexpr int max_number_of_sweeps = 40;
  // A move must improve the product of qualities by this factor, so that moves come to an end.
  static constexpr double least_improvement = 1.005;
  // The moves that are tried, as shares of the way to a neighbour on the edge.
  static constexpr double shares_of_way[] = {0.3, 0.1, 0.03};
  // Added to qualities, so that a degenerate triangle does not hide the others in the product.
  static constexpr double quality_of_degenerate = 1e-12;
  static constexpr double squared_sine_aimed_at = 0.33; // that of 35 degrees
  static constexpr double tolerated_loss = 0.8;         // the smallest squared sine may shrink by this factor if all others gain

  Division& m_division;
  std::size_t m_face;
  double m_min_edge;
  std::map<std::size_t, Point_3> m_points; // by index
  Parameters m_parameters;
  std::vector<Slider> m_sliders;

public:
  Strip_staggering(Division& division, std::size_t face, double min_edge)
    : m_division(division), m_face(face), m_min_edge(min_edge)
  {}

  // Finds the points to move in the triangulation of the boundary. `is_free(e)` tells whether the points of edge `e` may be moved.
  template <class IsFree>
  void collect(std::size_t number, const std::vector<std::size_t>& segments, const std::vector<Vertex_handle>& loop,
               const Triangulation& triangulation, const IsFree& is_free)
  {
    const std::size_t n = loop.size();
    for(std::size_t i = 0; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n;
      m_points[loop[i]->index()] = loop[i]->point().surface_point();
      const Piece p = m_division.piece(m_face, number, segments[before]), q = m_division.piece(m_face, number, segments[i]);
      if(p.edge != q.edge || !is_free(p.edge) || !is_slidable(p) || !is_slidable(q))
        continue;
      Slider slider{p.edge, (std::max)(p.number, q.number), loop[i]->index(),
                    {loop[before]->index(), loop[(i + 1) % n]->index()}, {}};
      if(slider.number == (std::min)(p.number, q.number) + 1 && add_sides(loop, i, triangulation, slider)) {
        m_sliders.push_back(slider);
        m_parameters.emplace(p.edge, m_division.parameters(p.edge));
      }
    }
  }

  // Moves the points as long as the smallest angle of all does not lose much. Returns the former parameters of the edges that have
  // changed.
  Parameters operator()()
  {
    const Parameters old = m_parameters;
    Parameters best = old;
    const double least_sine = tolerated_loss * squared_smallest_sine();
    for(int sweep = 0; sweep < max_number_of_sweeps; ++sweep) {
      bool is_any_moved = false;
      for(const Slider& slider : m_sliders)
        is_any_moved |= move(slider);
      if(!is_any_moved)
        break;
      if(squared_smallest_sine() >= least_sine)
        best = m_parameters;
    }
    Parameters former;
    for(const auto& edge : best)
      if(edge.second != old.at(edge.first)) {
        m_division.set_parameters(edge.first, edge.second);
        former.insert(*old.find(edge.first));
      }
    return former;
  }

private:
  bool is_slidable(const Piece& piece) const { return m_division.can_be_split(piece) && !m_division.is_kept(piece); }

  static double distance(const Point_3& p, const Point_3& q) { return std::sqrt(squared_distance(p, q)); }

  // Returns false if the strip is not narrow, or its pieces are not short.
  bool add_sides(const std::vector<Vertex_handle>& loop, std::size_t i, const Triangulation& triangulation,
                 Slider& slider)
  {
    const std::size_t n = loop.size();
    const Vertex_handle v = loop[i], before = loop[(i + n - 1) % n], after = loop[(i + 1) % n];
    const Point_3& p = v->point().surface_point();
    const double a = distance(p, before->point().surface_point()), b = distance(p, after->point().surface_point());
    if(!((std::max)(a, b) < 2 * m_min_edge))
      return false;
    double nearest = std::numeric_limits<double>::infinity();
    auto face = triangulation.incident_faces(v);
    const auto first = face;
    do
      if(face->is_in_domain()) {
        const int k = face->index(v);
        const Vertex_handle x = face->vertex(Triangulation::ccw(k)), y = face->vertex(Triangulation::cw(k));
        slider.sides.emplace_back(x->index(), y->index());
        for(Vertex_handle w : {x, y}) {
          m_points.emplace(w->index(), w->point().surface_point()); // a single point inside the face is on no loop with segments
          if(w != before && w != after)
            nearest = (std::min)(nearest, distance(p, w->point().surface_point()));
        }
      }
    while(++face != first);
    return nearest < (std::min)(a, b);
  }

  double squared_smallest_sine() const
  {
    double result = 1;
    for(const Slider& slider : m_sliders)
      result = (std::min)(result, quality(slider, m_points.at(slider.index)).smallest);
    return result;
  }

  Fan_quality quality(const Slider& slider, const Point_3& p) const
  {
    Fan_quality result;
    for(const auto& side : slider.sides) {
      const Point_3 &q = m_points.at(side.first), &r = m_points.at(side.second);
      const double sine
        = face_measures({squared_distance(q, r), squared_distance(r, p), squared_distance(p, q)}).squared_smallest_sine;
      result.smallest = (std::min)(result.smallest, sine);
      result.product *= sine + quality_of_degenerate;
    }
    return result;
  }

  bool move(const Slider& slider)
  {
    std::vector<double>& parameters = m_parameters.at(slider.edge);
    double& t = parameters[slider.number];
    Point_3& p = m_points.at(slider.index);
    const Fan_quality before = quality(slider, p);
    if(before.smallest > squared_sine_aimed_at)
      return false;
    const double old_t = t, ends[] = {parameters[slider.number - 1], parameters[slider.number + 1]};
    const Point_3 old_point = p;
    double best = least_improvement * before.product;
    for(const double end : ends)
      for(const double share : shares_of_way) {
        const double moved_t = old_t + share * (end - old_t);
        const Point_3 moved = m_division.point(slider.edge, moved_t);
        const double found = is_allowed(slider, old_point, moved) ? quality(slider, moved).product : 0;
        if(found > best) {
          best = found;
          t = moved_t;
          p = moved;
        }
      }
    return t != old_t;
  }

  // Pieces must not be shorter than the minimum edge, and must stay too short to be halved.
  bool is_allowed(const Slider& slider, const Point_3& from, const Point_3& to) const
  {
    for(const std::size_t neighbor : slider.neighbors) {
      const Point_3& q = m_points.at(neighbor);
      const double length = distance(to, q), before = distance(from, q);
      if(length < before ? length < m_min_edge : length >= 2 * m_min_edge)
        return false;
    }
    return true;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_STRIP_STAGGERING_H
