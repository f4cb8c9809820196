// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_REPAIR_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_REPAIR_H

#include <CGAL/Mesh_2/Face_badness.h>
#include <CGAL/Parametric_surface_mesher/internal/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/Point_placement.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
What insertion of points could not make good: edges of bad faces are flipped and their inner vertices moved, where that
raises the smallest angle around and makes no face too large or too far from the surface. The boundary stays. Most bad
faces lie beside it, where a vertex is a little off the one place that suits its neighbours.
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

  static const int max_number_of_passes = 8;

  Triangulation& m_triangulation;
  const Evaluator& m_evaluate;
  const IsBad& m_is_bad;
  std::vector<Face_handle> m_star;
  std::vector<Point_2> m_positions;

public:
  Patch_repair(Triangulation& triangulation, const Evaluator& evaluate, const IsBad& is_bad)
    : m_triangulation(triangulation), m_evaluate(evaluate), m_is_bad(is_bad)
  {}

  // Each change raises the smallest angle of some faces; the work is bounded all the same. Where the criteria ask for more
  // than can be, bad faces are many and improvement would take longer than refinement: some are left as they are.
  void operator()()
  {
    std::size_t attempts_left = 1000 + m_triangulation.number_of_faces() / 20;
    std::vector<Face_handle> bad;
    for(Face_handle face : m_triangulation.finite_face_handles())
      if(face->is_in_domain() && face->state() == Face_state::BLOCKED)
        bad.push_back(face);
    bool is_changed = !bad.empty();
    for(int pass = 0; is_changed && pass < max_number_of_passes; ++pass) {
      is_changed = false;
      for(std::size_t i = 0; i < bad.size() && attempts_left > 0; ++i) // grows
        if(badness(bad[i]) != Mesh_2::NOT_BAD) {
          is_changed |= repair(bad[i], bad);
          --attempts_left;
        }
    }
  }

private:
  Mesh_2::Face_badness badness(Face_handle face) const
  {
    typename IsBad::Quality quality;
    return is_collapsed(face) ? Mesh_2::NOT_BAD : m_is_bad(face, quality);
  }

  double squared_sine(Face_handle face) const
  {
    return is_collapsed(face) ? 1 : face_measures(face, m_evaluate.oracle().metric()).squared_smallest_sine;
  }

  bool repair(Face_handle face, std::vector<Face_handle>& bad)
  {
    for(int i = 0; i < 3; ++i)
      if(flip_if_better(face, i, bad))
        return true;
    for(int i = 0; i < 3; ++i)
      if(!face->vertex(i)->is_on_boundary() && move_if_better(face->vertex(i), bad))
        return true;
    return false;
  }

  // Notes the state of changed faces; those that are bad now are looked at again.
  void note(const std::vector<Face_handle>& changed, std::vector<Face_handle>& bad)
  {
    for(Face_handle face : changed) {
      const bool was_blocked = face->state() == Face_state::BLOCKED;
      face->touch();
      face->set_state(badness(face) == Mesh_2::NOT_BAD ? Face_state::GOOD : Face_state::BLOCKED);
      if(face->state() == Face_state::BLOCKED && !was_blocked)
        bad.push_back(face);
    }
  }

  // the smallest squared sine of faces, and how many of them fail for another reason than their angles
  struct Measure
  {
    double squared_sine = 1;
    std::size_t number_of_failures = 0;

    bool is_better_than(const Measure& other) const
    {
      return squared_sine > 1.01 * other.squared_sine && number_of_failures <= other.number_of_failures;
    }
  };

  Measure measure(const std::vector<Face_handle>& faces) const
  {
    Measure result;
    for(Face_handle face : faces) {
      result.squared_sine = (std::min)(result.squared_sine, squared_sine(face));
      result.number_of_failures += badness(face) == Mesh_2::IMPERATIVELY_BAD;
    }
    return result;
  }

  bool flip_if_better(Face_handle face, int i, std::vector<Face_handle>& bad)
  {
    if(face->is_constrained(i))
      return false;
    const Face_handle across = face->neighbor(i);
    const Point &p = face->vertex(i)->point(), &q = face->vertex((i + 1) % 3)->point(),
                &r = m_triangulation.mirror_vertex(face, i)->point(), &s = face->vertex((i + 2) % 3)->point();
    const auto orientation = m_triangulation.geom_traits().orientation_2_object();
    if(orientation(p, q, r) != LEFT_TURN || orientation(r, s, p) != LEFT_TURN)
      return false;
    const std::vector<Face_handle> both = {face, across};
    const Measure before = measure(both);
    flip_diagonal(face, across);
    if(measure(both).is_better_than(before)) {
      note(both, bad);
      return true;
    }
    // each flip turns the two triangles by a quarter: three more bring both back to their faces
    for(int k = 0; k < 3; ++k)
      flip_diagonal(face, across);
    return false;
  }

  void flip_diagonal(Face_handle face, Face_handle across) { m_triangulation.flip(face, face->index(across)); }

  bool move_if_better(Vertex_handle vertex, std::vector<Face_handle>& bad)
  {
    collect_star(vertex);
    const Point old_point = vertex->point();
    Point best_point = old_point;
    Measure best = measure(m_star);
    collect_positions(vertex);
    for(const Point_2& position : m_positions) {
      if(!is_star_around(position, vertex))
        continue;
      vertex->set_point(m_evaluate(position, vertex->spacing()).point);
      const Measure found = measure(m_star);
      if(found.is_better_than(best)) {
        best = found;
        best_point = vertex->point();
      }
    }
    vertex->set_point(best_point);
    if(best_point == old_point)
      return false;
    note(m_star, bad);
    return true;
  }

  void collect_star(Vertex_handle vertex)
  {
    m_star.clear();
    auto face = m_triangulation.incident_faces(vertex), done = face;
    do
      m_star.push_back(face);
    while(++face != done);
  }

  // Whether all faces of the star stay positively oriented with their centre there; exact.
  bool is_star_around(const Point_2& position, Vertex_handle vertex) const
  {
    const auto orientation = m_triangulation.geom_traits().orientation_2_object();
    return std::all_of(m_star.begin(), m_star.end(), [&](Face_handle face) {
      const int i = face->index(vertex);
      return orientation(face->vertex((i + 1) % 3)->point(), face->vertex((i + 2) % 3)->point(), position) == LEFT_TURN;
    });
  }

  // Towards the apices of equilateral triangles over the edges of the star, and towards their mean, by shares of the way.
  void collect_positions(Vertex_handle vertex)
  {
    m_positions.clear();
    std::vector<Point_2> apices;
    double x = 0, y = 0;
    for(Face_handle face : m_star) {
      const int i = face->index(vertex);
      apices.push_back(Point_placement<Kernel>::apex(face->vertex((i + 1) % 3)->point(),
                                                     face->vertex((i + 2) % 3)->point(), 0.87));
      x += apices.back().x();
      y += apices.back().y();
    }
    apices.emplace_back(x / double(m_star.size()), y / double(m_star.size()));
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
