// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_INNER_POINTS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_INNER_POINTS_H

#include <CGAL/Parametric_surface_mesher/internal/Domain_walk.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/Star_of_point.h>
#include <CGAL/Parametric_surface_mesher/internal/Vertex_insertion.h>

#include <algorithm>
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
  std::size_t m_number_of_replaced_tensors = 0;

public:
  Inner_points(Triangulation& triangulation, const Evaluator& evaluate)
    : m_triangulation(triangulation), m_evaluate(evaluate), m_insertion(triangulation), m_star(triangulation)
  {}

  const Evaluator& evaluate() const { return m_evaluate; }
  std::size_t number_of_replaced_tensors() const { return m_number_of_replaced_tensors; }

  // Walks from `from` to `uv` and evaluates the surface there. Returns whether the point can be inserted: neither behind the
  // boundary nor on it, nor at a vertex. The location is that of where the walk came to, in any case.
  bool locate(Face_handle from, const Point_2& uv, Candidate& candidate) const
  {
    candidate.spacing_limit = -1;
    candidate.location = walk_in_domain(m_triangulation, from, uv);
    if(candidate.location.kind != Location::IN_FACE && candidate.location.kind != Location::ON_EDGE)
      return false;
    if(candidate.location.kind == Location::ON_EDGE
       && candidate.location.face->is_constrained(candidate.location.index))
      return false;
    const Face_handle face = candidate.location.face;
    candidate.position = m_evaluate.position(uv, (face->vertex(0)->spacing() + face->vertex(1)->spacing() + face->vertex(2)->spacing()) / 3);
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
    return m_star.compute(candidate.position.point, candidate.location.face);
  }

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
    vertex->set_spacing((std::min)(spacing_of_star(vertex), spacing_limit(candidate)));
    return vertex;
  }

  // the faces around the vertex inserted last
  const std::vector<Face_handle>& star() const { return m_insertion.star(); }

  double squared_length(const Point& p, const Point& q) const { return m_evaluate.oracle().metric().squared_length(p, q); }

private:
  // Paper, eq. (2), the mean of the spacing of the neighbours weighted by their inverse distances, as an integral along
  // the star polygon: each neighbour also weighs as the polygon's edges beside it are long. Otherwise many close
  // neighbours on a finely divided curve outweigh all others, and the mesh never coarsens away from it. If it may grow, each
  // neighbour gives what it has grown to on the way.
  double spacing_of_star(Vertex_handle vertex) const
  {
    const std::vector<Face_handle>& star = m_insertion.star();
    double sum = 0, weights = 0;
    double previous_edge = distance(left_of(star.back(), vertex), left_of(star.front(), vertex));
    for(std::size_t i = 0; i < star.size(); ++i) {
      const Vertex_handle neighbor = left_of(star[i], vertex), next = left_of(star[(i + 1) % star.size()], vertex);
      const double edge = distance(neighbor, next);
      const double length = distance(vertex, neighbor), weight = (previous_edge + edge) / length;
      sum += weight * (neighbor->spacing() + m_evaluate.growth() * length);
      weights += weight;
      previous_edge = edge;
    }
    return sum / weights;
  }

  static Vertex_handle left_of(Face_handle face, Vertex_handle vertex) { return face->vertex((face->index(vertex) + 1) % 3); }

  double distance(Vertex_handle v, Vertex_handle w) const { return std::sqrt(squared_length(v->point(), w->point())); }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_INNER_POINTS_H
