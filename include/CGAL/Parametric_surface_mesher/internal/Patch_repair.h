// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_REPAIR_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_REPAIR_H

#include <CGAL/Mesh_2/Face_badness.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/Edge_flip.h>
#include <CGAL/Parametric_surface_mesher/internal/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/Point_placement.h>
#include <CGAL/Parametric_surface_mesher/internal/Vertex_removal.h>
#include <CGAL/Parametric_surface_mesher/internal/Vertex_star.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
What insertion of points could not make good, and what has an angle below the one aimed at: edges of such faces are
flipped and their inner vertices moved, where that raises the smallest angle around and makes no face too large or too far
from the surface. If neither helps a face that fails the angle, one of its inner vertices is taken out, on the same terms:
beside a piece of boundary that is longer than the edges around, there often is one too many. The boundary stays. Most of
these faces lie beside it, where a vertex is a little off the one place that suits its neighbours, or where fronts have met.
*/
template <class Evaluator, class IsBad>
class Patch_repair
{
  typedef typename Evaluator::Kernel Kernel;
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Point Point;
  typedef typename Kernel::Point_2 Point_2;
  typedef Vertex_star<Triangulation, typename Evaluator::Oracle::Metric_field> Star;

  static constexpr double share_of_far_below = 0.15; // of the squared sine: 11 degrees, for a criterion of 30

  Triangulation& m_triangulation;
  const Evaluator& m_evaluate;
  const IsBad& m_is_bad;
  double m_squared_sine, m_squared_sine_of_criterion, m_squared_min_edge;
  bool m_is_full; // of vertices: then none is removed, so that the limit stays to be seen
  Star m_star;
  std::vector<Face_state> m_states; // of its faces
  std::deque<Face_handle> m_queue;
  std::unordered_set<Face_handle> m_waiting; // those in the queue
  std::vector<Point_2> m_positions;

public:
  Patch_repair(Triangulation& triangulation, const Evaluator& evaluate, const IsBad& is_bad,
               const Parametric_surface_mesh_criteria& criteria)
    : m_triangulation(triangulation), m_evaluate(evaluate), m_is_bad(is_bad),
      m_squared_sine(square(std::sin(criteria.improvement_angle() * std::atan(1.) / 45))),
      m_squared_sine_of_criterion(square(std::sin(criteria.angle() * std::atan(1.) / 45))),
      m_squared_min_edge(square(criteria.min_edge())),
      m_is_full(triangulation.number_of_vertices() >= criteria.max_number_of_vertices()), m_star(triangulation, evaluate.oracle().metric())
  {}

  // Each change raises the smallest angle of some faces; the work is bounded all the same. Where the criteria ask for more
  // than can be, bad faces are many and improvement would take longer than refinement: some are left as they are. A face
  // that could not be repaired is tried again once something beside it has changed, and not before.
  template <class GoFurther>
  void operator()(const GoFurther& go_further)
  {
    std::size_t attempts_left = 1000 + m_triangulation.number_of_faces() / 20;
    for(Face_handle face : m_triangulation.finite_face_handles())
      if(face->is_in_domain())
        add_if_poor(face);
    while(!m_queue.empty() && attempts_left > 0 && go_further()) {
      const Face_handle face = m_queue.front();
      m_queue.pop_front();
      if(m_waiting.erase(face) == 0)
        continue; // it is gone
      if(is_poor(face)) {
        repair(face);
        --attempts_left;
      }
    }
  }

private:
  // \pre the state of the face is known
  bool is_poor(Face_handle face) const { return face->state() == Face_state::BLOCKED || squared_sine(face) < m_squared_sine; }

  Mesh_2::Face_badness badness(Face_handle face) const
  {
    typename IsBad::Quality quality;
    return is_collapsed(face) ? Mesh_2::NOT_BAD : m_is_bad(face, quality);
  }

  double squared_sine(Face_handle face) const
  {
    return is_collapsed(face) ? 1 : face_measures(face, m_evaluate.oracle().metric()).squared_smallest_sine;
  }

  void add_if_poor(Face_handle face)
  {
    if(is_poor(face) && m_waiting.insert(face).second)
      m_queue.push_back(face);
  }

  void repair(Face_handle face)
  {
    for(int i = 0; i < 3; ++i)
      if(flip_if_better(face, i))
        return;
    for(int i = 0; i < 3; ++i)
      if(!face->vertex(i)->is_on_boundary() && move_if_better(face->vertex(i)))
        return;
    if(!m_is_full && squared_sine(face) < m_squared_sine_of_criterion)
      for(int i = 0; i < 3; ++i)
        if(!face->vertex(i)->is_on_boundary() && remove_if_better(face->vertex(i)))
          return;
  }

  // Notes the state of changed faces; these and their neighbours are looked at again.
  template <class Faces>
  void note(const Faces& changed)
  {
    for(Face_handle face : changed) {
      face->touch();
      face->set_state(badness(face) == Mesh_2::NOT_BAD ? Face_state::GOOD : Face_state::BLOCKED);
    }
    for(Face_handle face : changed) {
      add_if_poor(face);
      for(int i = 0; i < 3; ++i)
        if(!face->is_constrained(i))
          add_if_poor(face->neighbor(i));
    }
  }

  // How many fail a criterion; one that fails another one than the angle counts more than a whole star that fails that. To
  // raise a smallest angle far below the criterion, others may get below it.
  template <class Faces>
  std::size_t number_of_failures(const Faces& faces, double squared_smallest_sine) const
  {
    const bool is_far_below = squared_smallest_sine < share_of_far_below * m_squared_sine_of_criterion;
    std::size_t result = 0;
    for(Face_handle face : faces) {
      const Mesh_2::Face_badness found = badness(face);
      result += found == Mesh_2::IMPERATIVELY_BAD ? 1000 : found == Mesh_2::BAD && !is_far_below ? 1 : 0;
    }
    return result;
  }

  bool flip_if_better(Face_handle face, int i)
  {
    if(face->is_constrained(i))
      return false;
    Edge_flip<Triangulation> edge(m_triangulation, face, i);
    const auto& metric = m_evaluate.oracle().metric();
    const auto sine = [](const std::array<double, 3>& lengths) { return face_measures(lengths).squared_smallest_sine; };
    const double worst = edge.worst_before(metric, sine);
    if(!(edge.worst_after(metric, sine) > 1.01 * worst) || !edge.is_valid())
      return false;
    const auto faces = edge.faces();
    const Face_state states[] = {faces[0]->state(), faces[1]->state()};
    const std::size_t failures = number_of_failures(faces, worst);
    edge.flip();
    if(number_of_failures(faces, worst) <= failures) {
      note(faces);
      return true;
    }
    edge.undo();
    for(int k = 0; k < 2; ++k)
      faces[k]->set_state(states[k]);
    return false;
  }

  // Collects the star of a vertex, with the states of its faces.
  void collect_star(Vertex_handle vertex)
  {
    m_star.collect(vertex);
    m_states.clear();
    for(Face_handle face : m_star.faces())
      m_states.push_back(face->state());
  }

  void restore_states()
  {
    for(std::size_t k = 0; k < m_states.size(); ++k)
      m_star.faces()[k]->set_state(m_states[k]);
  }

  bool move_if_better(Vertex_handle vertex)
  {
    collect_star(vertex);
    const Point old_point = vertex->point();
    if(find_better_place(vertex)) {
      note(m_star.faces());
      return true;
    }
    m_star.move_to(old_point);
    restore_states();
    return false;
  }

  bool remove_if_better(Vertex_handle vertex)
  {
    collect_star(vertex);
    const double worst = m_star.squared_smallest_sine(vertex->point());
    const std::size_t failures = number_of_failures(m_star.faces(), worst);
    const auto sine = [](const std::array<double, 3>& lengths) { return face_measures(lengths).squared_smallest_sine; };
    Vertex_removal<Triangulation> removal(m_triangulation, vertex);
    if(removal.cut_ears(m_evaluate.oracle().metric(), sine, 1.01 * worst)
       && is_better_without(vertex, removal, worst, failures)) {
      remove(vertex, removal);
      return true;
    }
    removal.undo();
    restore_states();
    return false;
  }

  // \pre three faces are left at the vertex
  bool is_better_without(Vertex_handle vertex, Vertex_removal<Triangulation>& removal, double worst, std::size_t failures) const
  {
    std::vector<Face_handle> faces = faces_without(vertex);
    return removal.with_last_face([&](Face_handle last) {
      faces.push_back(last);
      return !is_collapsed(last) && squared_sine(last) > 1.01 * worst && number_of_failures(faces, worst) <= failures;
    });
  }

  // \pre three faces are left at the vertex
  void remove(Vertex_handle vertex, Vertex_removal<Triangulation>& removal)
  {
    std::vector<Face_handle> changed = faces_without(vertex);
    for(Face_handle face : removal.faces())
      m_waiting.erase(face);
    changed.push_back(removal.remove());
    note(changed);
  }

  // those of the star that are no longer at its centre
  std::vector<Face_handle> faces_without(Vertex_handle vertex) const
  {
    std::vector<Face_handle> result;
    std::copy_if(m_star.faces().begin(), m_star.faces().end(), std::back_inserter(result),
                 [&](Face_handle face) { return !face->has_vertex(vertex); });
    return result;
  }

  bool find_better_place(Vertex_handle vertex)
  {
    const Point old_point = vertex->point();
    Point best_point = old_point;
    const double worst = m_star.squared_smallest_sine(old_point);
    double best_sine = worst;
    const std::size_t failures = number_of_failures(m_star.faces(), worst);
    collect_positions(vertex);
    for(const Point_2& position : m_positions) {
      if(!m_star.is_around(position))
        continue;
      const Point point = m_evaluate.position(position, vertex->spacing()).point;
      const double sine = m_star.squared_smallest_sine(point);
      if(!(sine > 1.01 * best_sine) || !is_far_enough(point, old_point))
        continue;
      m_star.move_to(point);
      if(number_of_failures(m_star.faces(), worst) <= failures) {
        best_sine = sine;
        best_point = point;
      }
    }
    m_star.move_to(best_point);
    return !(best_point == old_point);
  }

  // from its neighbours, or no closer to them than now
  bool is_far_enough(const Point& point, const Point& old_point) const
  {
    const double squared_distance = m_star.squared_distance_to_ring(point);
    return squared_distance >= m_squared_min_edge || squared_distance >= m_star.squared_distance_to_ring(old_point);
  }

  // Towards the apices of equilateral triangles over the edges of the star, and towards their mean, by shares of the way.
  void collect_positions(Vertex_handle vertex)
  {
    m_positions.clear();
    std::vector<Point_2> apices;
    double x = 0, y = 0;
    for(Face_handle face : m_star.faces()) {
      const int i = face->index(vertex);
      apices.push_back(Point_placement<Kernel>::apex(face->vertex((i + 1) % 3)->point(),
                                                     face->vertex((i + 2) % 3)->point(), 0.87));
      x += apices.back().x();
      y += apices.back().y();
    }
    apices.emplace_back(x / double(m_star.faces().size()), y / double(m_star.faces().size()));
    const Point& p = vertex->point();
    for(const Point_2& apex : apices)
      for(double share : {1., 0.5, 0.25, 0.1})
        m_positions.emplace_back(p.x() + share * (apex.x() - p.x()), p.y() + share * (apex.y() - p.y()));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_REPAIR_H
