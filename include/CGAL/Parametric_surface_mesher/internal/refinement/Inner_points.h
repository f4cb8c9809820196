// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_INNER_POINTS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_INNER_POINTS_H

#include <CGAL/Parametric_surface_mesher/internal/triangulation/Domain_walk.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Star_of_point.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Vertex_insertion.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/for_each_with_lookahead.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The inner points of a patch: a position is located and evaluated, looked at by whoever has proposed it, and inserted with
// the spacing of its neighbours.
template <class Evaluator>
class Inner_points
{
public:
  typedef typename Evaluator::Kernel Kernel;
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Point Point;
  typedef typename Kernel::Point_2 Point_2;
  typedef internal::Location<Triangulation> Location;

  // a position that has been looked at
  struct Candidate
  {
    Location location;
    typename Evaluator::Position position;
    double spacing_limit = -1; // not yet evaluated
  };

private:
  Triangulation& m_triangulation;
  const Evaluator& m_evaluate;
  Vertex_insertion<Triangulation> m_insertion;
  Star_of_point<Triangulation> m_star;
  // of the vertex inserted last: by face of its star, from it to vertex 1, and from there to vertex 2
  std::vector<double> m_squared_spokes, m_squared_rims;
  std::size_t m_number_of_replaced_tensors = 0, m_number_of_work_limits = 0;

public:
  Inner_points(Triangulation& triangulation, const Evaluator& evaluate)
    : m_triangulation(triangulation), m_evaluate(evaluate), m_insertion(triangulation), m_star(triangulation)
  {}

  const Evaluator& evaluate() const { return m_evaluate; }
  std::size_t number_of_replaced_tensors() const { return m_number_of_replaced_tensors; }

  // how many walks and stars were given up
  std::size_t number_of_work_limits() const { return m_number_of_work_limits; }

  // Walks from `from` to `uv` and evaluates the surface there. Returns whether the point can be inserted: neither behind the
  // boundary nor on it, nor at a vertex. The location is that of where the walk came to, in any case.
  bool locate(Face_handle from, const Point_2& uv, Candidate& candidate)
  {
    candidate.spacing_limit = -1;
    if(!std::isfinite(uv.x() + uv.y())) // computed from a flat triangle
      return false;
    candidate.location = walk_in_domain(m_triangulation, from, uv);
    m_number_of_work_limits += candidate.location.kind == Location::LOST;
    if(candidate.location.kind != Location::IN_FACE && candidate.location.kind != Location::ON_EDGE)
      return false;
    if(candidate.location.kind == Location::ON_EDGE
       && candidate.location.face->is_constrained(candidate.location.index))
      return false;
    const Face_handle face = candidate.location.face;
    for(int i = 0; i < 3; ++i)
      prefetch(*face->neighbor(i)); // for the insertion, while the surface is evaluated
    const double spacing = (face->vertex(0)->spacing() + face->vertex(1)->spacing() + face->vertex(2)->spacing()) / 3;
    candidate.position = m_evaluate.position(uv, spacing);
    return true;
  }

  // no closer to a vertex of the face that holds it than the distance
  bool is_far_enough(const Candidate& candidate, double squared_distance) const
  {
    for(int i = 0; i < 3; ++i)
      if(squared_length(candidate.location.face->vertex(i)->point(), candidate.position.point) < squared_distance)
        return false;
    return true;
  }

  static bool is_near_boundary(const Candidate& candidate)
  {
    const Face_handle face = candidate.location.face;
    for(int i = 0; i < 3; ++i)
      if(face->vertex(i)->is_on_boundary())
        return true;
    return false;
  }

  // what the surface allows there
  double spacing_limit(Candidate& candidate) const
  {
    if(candidate.spacing_limit < 0)
      candidate.spacing_limit = m_evaluate.spacing_limit(candidate.position);
    return candidate.spacing_limit;
  }

  // the edges of the star that the candidate would get
  const std::vector<typename Star_of_point<Triangulation>::Edge>& star_of(const Candidate& candidate)
  {
    const auto& result = m_star.compute(candidate.position.point, candidate.location.face);
    m_number_of_work_limits += m_star.is_cut_short();
    return result;
  }

  // Whether the last one of them was.
  bool is_star_cut_short() const { return m_star.is_cut_short(); }

  // Whether the candidate sees this constrained edge under an angle above 120 degrees: from within the lens where the
  // triangle with that edge would have angles below 30 degrees.
  bool encroaches(const Candidate& candidate, const Point& p, const Point& q) const
  {
    const double a = squared_length(p, candidate.position.point), b = squared_length(q, candidate.position.point);
    return a + b + std::sqrt(a * b) < squared_length(p, q);
  }

  // its faces are `star()`
  Vertex_handle insert(Candidate& candidate)
  {
    const Vertex_handle vertex = candidate.location.kind == Location::IN_FACE
                                   ? m_insertion.insert_in_face(candidate.position.point, candidate.location.face)
                                   : m_insertion.insert_in_edge(candidate.position.point, candidate.location.face,
                                                                candidate.location.index);
    m_number_of_replaced_tensors += candidate.position.is_tensor_replaced;
    measure_star(vertex->point());
    vertex->set_spacing((std::min)(spacing_of_star(), spacing_limit(candidate)));
    return vertex;
  }

  // the faces around the vertex inserted last, counterclockwise; it is vertex 0 of each
  const std::vector<Face_handle>& star() const { return m_insertion.star(); }

  // of face `i` of the star
  std::array<double, 3> squared_lengths(std::size_t i) const
  {
    return {m_squared_rims[i], m_squared_spokes[i + 1 < m_squared_spokes.size() ? i + 1 : 0], m_squared_spokes[i]};
  }

  double squared_length(const Point& p, const Point& q) const { return m_evaluate.oracle().metric().squared_length(p, q); }

private:
  void measure_star(const Point& p)
  {
    m_squared_spokes.clear();
    m_squared_rims.clear();
    for(Face_handle face : star()) {
      m_squared_spokes.push_back(squared_length(p, face->vertex(1)->point()));
      m_squared_rims.push_back(squared_length(face->vertex(1)->point(), face->vertex(2)->point()));
    }
  }

  // Paper, eq. (2), the mean of the spacing of the neighbours weighted by their inverse distances, as an integral along
  // the star polygon: each neighbour also weighs as the polygon's edges beside it are long. Otherwise many close
  // neighbours on a finely divided curve outweigh all others, and the mesh never coarsens away from it. If it may grow, each
  // neighbour gives what it has grown to on the way.
  double spacing_of_star() const
  {
    double sum = 0, weights = 0;
    double previous_rim = std::sqrt(m_squared_rims.back());
    for(std::size_t i = 0; i < star().size(); ++i) {
      const double spoke = std::sqrt(m_squared_spokes[i]), rim = std::sqrt(m_squared_rims[i]);
      const double weight = (previous_rim + rim) / spoke;
      sum += weight * (star()[i]->vertex(1)->spacing() + m_evaluate.growth() * spoke);
      weights += weight;
      previous_rim = rim;
    }
    return sum / weights;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_INNER_POINTS_H
