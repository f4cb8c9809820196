// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_ADVANCING_FRONT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_ADVANCING_FRONT_H

#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Domain_tiles.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Front_queue.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Frontal_placement.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Inner_points.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Point_placement.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Mesh_progress.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>

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
is on the front. A new point makes a triangle of the wanted size with such an edge. What the front leaves is for the
refinement at circumcentres.
*/
template <class Evaluator>
class Advancing_front
{
  typedef typename Evaluator::Kernel Kernel;
  typedef internal::Inner_points<Evaluator> Inner_points;
  typedef typename Inner_points::Triangulation Triangulation;
  typedef typename Inner_points::Face_handle Face_handle;
  typedef typename Inner_points::Point Point;
  typedef typename Inner_points::Candidate Candidate;

  static constexpr double squared_done_ratio = 1.3 * 1.3; // of the circumradius to that of the equilateral triangle

  Triangulation& m_triangulation;
  Inner_points& m_points;
  const Frontal_placement<Inner_points> m_place;
  Patch_progress& m_progress;
  const Domain_tiles m_tiles;
  Front_queue<Face_handle> m_queue;
  std::vector<double> m_ratios; // by face of the newest star
  std::size_t m_max_number_of_vertices;

public:
  Advancing_front(Triangulation& triangulation, Inner_points& points, std::size_t max_number_of_vertices,
                  Patch_progress& progress)
    : m_triangulation(triangulation), m_points(points), m_place(points), m_progress(progress),
      m_tiles(triangulation), m_queue(m_tiles.size()),
      m_max_number_of_vertices(max_number_of_vertices)
  {}

  // `faces`: all of them, in the order in which those on the first front come
  template <class Faces>
  void operator()(const Faces& faces)
  {
    for(Face_handle face : faces)
      if(face->is_in_domain() && !is_collapsed(face) && m_progress.go_further())
        set_mark(face, squared_size_ratio(face));
    for(Face_handle face : faces)
      if(face->front_mark() == Front_mark::ACTIVE)
        push_if_on_front(face, squared_size_ratio(face));
    for(std::size_t n = 1; m_progress.go_further() && m_triangulation.number_of_vertices() < m_max_number_of_vertices; ++n) {
      const Face_handle face = m_queue.pop();
      if(face == Face_handle())
        break;
      advance(face);
      if(n % 512 == 0)
        m_progress.on_progress(m_triangulation.number_of_vertices(), m_queue.size());
    }
  }

private:
  static void set_mark(Face_handle face, double squared_ratio)
  {
    face->set_front_mark(squared_ratio < squared_done_ratio ? Front_mark::DONE : Front_mark::ACTIVE);
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
    return face->is_constrained(i) || face->neighbor(i)->front_mark() == Front_mark::DONE;
  }

  void push_if_on_front(Face_handle face, double squared_ratio)
  {
    if(face->front_mark() != Front_mark::ACTIVE)
      return;
    for(int i = 0; i < 3; ++i)
      if(is_on_front(face, i)) {
        const Point &p = face->vertex((i + 1) % 3)->point(), &q = face->vertex((i + 2) % 3)->point();
        m_queue.push(face, squared_ratio, m_tiles(0.5 * (p.x() + q.x()), 0.5 * (p.y() + q.y())));
        face->set_front_mark(Front_mark::QUEUED);
        return;
      }
  }

  void advance(Face_handle face)
  {
    const Face_measures measures = face_measures(face, m_points.evaluate().oracle().metric());
    const int front = edge_on_front(face, measures);
    Candidate candidate;
    if((front >= 0 && m_place(face, front, measures, candidate) && !is_too_close(candidate))
       || (place_at_circumcenter(face, measures, candidate) && !is_too_close(candidate)))
      insert(candidate);
    else
      face->set_front_mark(Front_mark::GIVEN_UP);
  }

  // Where an edge has no good place over it, so that the front goes on: next to an obtuse angle, or close to other edges.
  bool place_at_circumcenter(Face_handle face, const Face_measures& measures, Candidate& candidate) const
  {
    typedef Point_placement<Kernel> Placement;
    return m_points.locate(face, Placement::barycentric(face, Circumcenter_placement()(measures.squared_lengths, 0)), candidate);
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
      set_mark(star[i], m_ratios.back());
    }
    for(std::size_t i = 0; i < star.size(); ++i) {
      push_if_on_front(star[i], m_ratios[i]);
      const Face_handle across = star[i]->neighbor(0);
      if(star[i]->front_mark() == Front_mark::DONE && across->front_mark() == Front_mark::ACTIVE)
        push_if_on_front(across, squared_size_ratio(across));
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_ADVANCING_FRONT_H
