// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_ADVANCING_FRONT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_ADVANCING_FRONT_H

#include <CGAL/Parametric_surface_mesher/internal/Domain_tiles.h>
#include <CGAL/Parametric_surface_mesher/internal/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/Front_queue.h>
#include <CGAL/Parametric_surface_mesher/internal/Inner_points.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/Point_placement.h>

#include <algorithm>
#include <cmath>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Frontal placement (Rebay 1993; for surfaces Engwirda and Ivers 2016): a face is done when its circumradius is near that of
the equilateral triangle of the wanted size, and an edge between a face that is done, or the boundary, and one that is not
is on the front. A new point makes a triangle of the wanted size with such an edge, as far as the circumcentre of the face
behind it allows; its distances in space to the ends of the edge are set right by Newton steps in the domain. What the
front leaves is for the refinement at circumcentres.
*/
template <class Evaluator, class Visitor>
class Advancing_front
{
  typedef typename Evaluator::Kernel Kernel;
  typedef internal::Inner_points<Evaluator> Inner_points;
  typedef typename Inner_points::Triangulation Triangulation;
  typedef typename Inner_points::Face_handle Face_handle;
  typedef typename Inner_points::Vertex_handle Vertex_handle;
  typedef typename Inner_points::Point Point;
  typedef typename Inner_points::Candidate Candidate;
  typedef typename Kernel::Point_2 Point_2;

  static constexpr double squared_done_ratio = 1.3 * 1.3; // of the circumradius to that of the equilateral triangle
  static constexpr double squared_accepted_error = 0.01 * 0.01;
  static constexpr double share_of_spacing = 0.8;
  static constexpr double smallest_height = 0.3; // of a new triangle, by its side
  static const int max_number_of_corrections = 2;

  Triangulation& m_triangulation;
  Inner_points& m_points;
  Visitor& m_visitor;
  const Domain_tiles m_tiles;
  Front_queue<Face_handle> m_queue;
  std::vector<double> m_ratios; // by face of the newest star
  std::size_t m_max_number_of_vertices;
  bool m_is_stopped = false;

public:
  Advancing_front(Triangulation& triangulation, Inner_points& points, std::size_t max_number_of_vertices, Visitor& visitor)
    : m_triangulation(triangulation), m_points(points), m_visitor(visitor),
      m_tiles(triangulation), m_queue(m_tiles.size()),
      m_max_number_of_vertices(max_number_of_vertices)
  {}

  // `faces`: all of them, in the order in which those on the first front come
  template <class Faces>
  void operator()(const Faces& faces)
  {
    for(Face_handle face : faces)
      if(face->is_in_domain() && !is_collapsed(face))
        set_state(face, squared_size_ratio(face));
    for(Face_handle face : faces)
      if(face->state() == Face_state::ACTIVE)
        push_if_on_front(face, squared_size_ratio(face));
    for(std::size_t n = 1; !m_is_stopped && m_triangulation.number_of_vertices() < m_max_number_of_vertices; ++n) {
      const Face_handle face = m_queue.pop();
      if(face == Face_handle())
        break;
      advance(face);
      if(n % 512 == 0)
        report_progress();
    }
  }

  bool is_stopped() const { return m_is_stopped; }

private:
  void report_progress()
  {
    m_visitor.on_progress(m_triangulation.number_of_vertices(), m_queue.size());
    m_is_stopped = !m_visitor.go_further();
  }

  static void set_state(Face_handle face, double squared_ratio)
  {
    face->set_state(squared_ratio < squared_done_ratio ? Face_state::GOOD : Face_state::ACTIVE);
  }

  // of the circumradius to that of the equilateral triangle with the mean spacing of the corners
  static double squared_size_ratio(Face_handle face, const std::array<double, 3>& squared_lengths)
  {
    const double sum = face->vertex(0)->spacing() + face->vertex(1)->spacing() + face->vertex(2)->spacing();
    return 27 * squared_circumradius(squared_lengths) / (sum * sum);
  }

  double squared_size_ratio(Face_handle face) const
  {
    return squared_size_ratio(face, squared_lengths(face, m_points.evaluate().oracle().metric()));
  }

  static bool is_on_front(Face_handle face, int i)
  {
    return face->is_constrained(i) || face->neighbor(i)->state() == Face_state::GOOD;
  }

  void push_if_on_front(Face_handle face, double squared_ratio)
  {
    if(face->state() != Face_state::ACTIVE)
      return;
    for(int i = 0; i < 3; ++i)
      if(is_on_front(face, i)) {
        const Point &p = face->vertex((i + 1) % 3)->point(), &q = face->vertex((i + 2) % 3)->point();
        m_queue.push(face, squared_ratio, m_tiles(0.5 * (p.x() + q.x()), 0.5 * (p.y() + q.y())));
        face->set_state(Face_state::QUEUED);
        return;
      }
  }

  void advance(Face_handle face)
  {
    const Face_measures measures = face_measures(face, m_points.evaluate().oracle().metric());
    const int front = edge_on_front(face, measures);
    Candidate candidate;
    if((front >= 0 && place(face, front, measures, candidate) && !is_too_close(candidate))
       || (place_at_circumcenter(face, measures, candidate) && !is_too_close(candidate)))
      insert(candidate);
    else
      face->set_state(Face_state::BLOCKED);
  }

  // Where an edge has no good place over it, so that the front goes on: next to an obtuse angle, or close to other edges.
  bool place_at_circumcenter(Face_handle face, const Face_measures& measures, Candidate& candidate) const
  {
    typedef Point_placement<Kernel> Placement;
    return m_points.locate(face, Placement::barycentric(face, Placement::circumcenter_weights(measures)), candidate);
  }

  // of several, that with the length closest to the spacing
  static int edge_on_front(Face_handle face, const Face_measures& measures)
  {
    const double spacing = (face->vertex(0)->spacing() + face->vertex(1)->spacing() + face->vertex(2)->spacing()) / 3;
    int result = -1;
    double smallest_ratio = 0;
    for(int i = 0; i < 3; ++i) {
      if(!is_on_front(face, i))
        continue;
      const double ratio = measures.squared_lengths[i] / (spacing * spacing), change = (std::max)(ratio, 1 / ratio);
      if(result < 0 || change < smallest_ratio) {
        result = i;
        smallest_ratio = change;
      }
    }
    return result;
  }

  // Where the surface allows less than the spacing of the edge's ends, the sides are to be between the two.
  bool place(Face_handle face, int front, const Face_measures& measures, Candidate& candidate) const
  {
    const double spacing = 0.5 * (face->vertex((front + 1) % 3)->spacing() + face->vertex((front + 2) % 3)->spacing());
    if(!place(face, front, measures, spacing, candidate))
      return false;
    const double limit = m_points.spacing_limit(candidate);
    Candidate closer;
    if(limit < share_of_spacing * spacing && place(face, front, measures, 0.5 * (spacing + limit), closer))
      candidate = closer;
    return true;
  }

  bool place(Face_handle face, int front, const Face_measures& measures, double side, Candidate& candidate) const
  {
    const Point &p = face->vertex((front + 1) % 3)->point(), &q = face->vertex((front + 2) % 3)->point();
    const double quarter = measures.squared_lengths[front] / 4; // the square of half the edge
    const double height = (std::min)(std::sqrt((std::max)(side * side - quarter, quarter)), height_of_circumcenter(measures, front));
    if(!(height > smallest_height * side))
      return false;
    if(!m_points.locate(face, Point_placement<Kernel>::apex(p, q, height / (2 * std::sqrt(quarter))), candidate))
      return false;
    correct(p, q, height * height + quarter, candidate);
    return true;
  }

  // by Newton steps, as long as they bring it closer
  void correct(const Point& p, const Point& q, double squared_side, Candidate& candidate) const
  {
    double error = squared_error(candidate, p, q, squared_side);
    for(int step = 0; step < max_number_of_corrections && error > squared_accepted_error; ++step) {
      Candidate corrected;
      if(!m_points.locate(candidate.location.face, corrected_position(candidate.position.point, p, q, squared_side), corrected))
        break;
      const double corrected_error = squared_error(corrected, p, q, squared_side);
      if(!(corrected_error < error))
        break;
      candidate = corrected;
      error = corrected_error;
    }
  }

  // over the edge opposite to corner `i`; negative if the angle there is obtuse
  static double height_of_circumcenter(const Face_measures& measures, int i)
  {
    const std::array<double, 3>& l = measures.squared_lengths;
    const double height = std::sqrt((std::max)(0., measures.squared_circumradius - l[i] / 4));
    return l[(i + 1) % 3] + l[(i + 2) % 3] > l[i] ? height : -height;
  }

  // of the distances to `p` and `q`, relative
  double squared_error(const Candidate& candidate, const Point& p, const Point& q, double squared_side) const
  {
    const double a = m_points.squared_length(p, candidate.position.point) / squared_side - 1,
                 b = m_points.squared_length(q, candidate.position.point) / squared_side - 1;
    return 0.25 * (std::max)(a * a, b * b);
  }

  // A Newton step for the squared distances in space to `p` and `q`, whose derivatives the tensor gives: by half, M(x - p)
  // and M(x - q).
  Point_2 corrected_position(const Point& x, const Point& p, const Point& q, double squared_side) const
  {
    const Metric_tensor_2& m = x.tensor();
    const double pu = x.x() - p.x(), pv = x.y() - p.y(), qu = x.x() - q.x(), qv = x.y() - q.y();
    const double a0 = m.e() * pu + m.f() * pv, a1 = m.f() * pu + m.g() * pv;
    const double b0 = m.e() * qu + m.f() * qv, b1 = m.f() * qu + m.g() * qv;
    const double determinant = a0 * b1 - a1 * b0;
    const double a = 0.5 * (squared_side - m_points.squared_length(p, x)),
                 b = 0.5 * (squared_side - m_points.squared_length(q, x));
    return Point_2(x.x() + (a * b1 - b * a1) / determinant, x.y() + (b * a0 - a * b0) / determinant);
  }

  // to a vertex, or an edge of the boundary
  bool is_too_close(Candidate& candidate)
  {
    const auto& location = candidate.location;
    double spacing = m_points.spacing_limit(candidate);
    for(int i = 0; i < 3; ++i)
      spacing = (std::min)(spacing, location.face->vertex(i)->spacing());
    if(!m_points.is_far_enough(candidate, 0.36 * spacing * spacing))
      return true;
    if(!Inner_points::is_near_boundary(candidate))
      return false;
    for(const auto& edge : m_points.star_of(candidate))
      if(edge.first->is_constrained(edge.second)
         && m_points.encroaches(candidate, edge.first->vertex((edge.second + 1) % 3)->point(),
                                edge.first->vertex((edge.second + 2) % 3)->point()))
        return true;
    return false;
  }

  void insert(Candidate& candidate)
  {
    m_points.insert(candidate);
    const auto& star = m_points.star();
    m_ratios.clear();
    for(std::size_t i = 0; i < star.size(); ++i) {
      m_ratios.push_back(squared_size_ratio(star[i], m_points.squared_lengths(i)));
      set_state(star[i], m_ratios.back());
    }
    for(std::size_t i = 0; i < star.size(); ++i) {
      push_if_on_front(star[i], m_ratios[i]);
      const Face_handle across = star[i]->neighbor(0);
      if(star[i]->state() == Face_state::GOOD && across->state() == Face_state::ACTIVE)
        push_if_on_front(across, squared_size_ratio(across));
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_ADVANCING_FRONT_H
