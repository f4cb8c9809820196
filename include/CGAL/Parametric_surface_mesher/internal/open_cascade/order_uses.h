// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_ORDER_USES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_ORDER_USES_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Open_cascade_surface_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Domain_periods.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/convert_curves.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Sorts the edge uses of a wire, which a file may store in any order, into loops, and moves their curves by whole periods to where
// they continue each other: only then is it clear which one does where a loop comes to a vertex again. (ShapeAnalysis_WireOrder of
// Open CASCADE sorts by points in space or in the domain, and knows neither vertices nor periods.)
class Use_order
{
  typedef Parametric_surface_model_3<Open_cascade_surface_3> Model;
  typedef Model::Edge_use Edge_use;
  typedef Model::Loop Loop;
  typedef Model::Geom_traits::Point_2 Point_2;
  typedef Model::Geom_traits::Vector_2 Vector_2;

  // Curves are the same if their points differ by less than 1e-6 of their size, far below any slit that bounds something.
  static constexpr double squared_rounding = 1e-12;
  // A distance must be smaller by this factor to change the order of the file, so that rounding cannot.
  static constexpr double certainly_less = 0.999;
  // Small enough for distances without periods to decide only between equal ones.
  static constexpr double weight_of_periods = 1e-3;

  const Model& m_model;
  const Open_cascade_surface_3& m_surface;
  const Domain_periods m_periods;

public:
  Use_order(const Model& model, const Open_cascade_surface_3& surface) : m_model(model), m_surface(surface), m_periods(surface) {}

  // Returns closed loops: one, or several if these were joined by slits, which are removed.
  std::vector<Loop> operator()(Loop uses) const
  {
    remove_slits(uses);
    std::vector<Loop> result;
    while(!uses.empty())
      result.push_back(take_loop(uses));
    return result;
  }

private:
  std::size_t begin_vertex(const Edge_use& use) const
  {
    return use.is_reversed ? m_model.edges()[use.edge].target : m_model.edges()[use.edge].source;
  }

  std::size_t end_vertex(const Edge_use& use) const
  {
    return use.is_reversed ? m_model.edges()[use.edge].source : m_model.edges()[use.edge].target;
  }

  static Point_2 begin_point(const Edge_use& use) { return use.is_reversed ? use.curve.target() : use.curve.source(); }
  static Point_2 end_point(const Edge_use& use) { return use.is_reversed ? use.curve.source() : use.curve.target(); }

  // Removes pairs of uses that run along the same curve in opposite directions, since these bound nothing.
  static void remove_slits(Loop& uses)
  {
    for(std::size_t i = 0; i < uses.size(); ++i)
      for(std::size_t k = i + 1; k < uses.size(); ++k)
        if(are_slit(uses[i], uses[k])) {
          uses.erase(uses.begin() + k);
          uses.erase(uses.begin() + i);
          --i;
          break;
        }
  }

  static bool are_slit(const Edge_use& a, const Edge_use& b)
  {
    if(a.edge != b.edge || a.is_reversed == b.is_reversed)
      return false;
    const double squared_size = squared_distance(a.curve.source(), a.curve.target())
                                + squared_distance(a.curve.source(), a.curve.point(0.5));
    for(double t : {0., 0.5, 1.})
      if(squared_distance(a.curve.point(t), b.curve.point(t)) > squared_rounding * squared_size)
        return false;
    return true;
  }

  // The loop begins with the first use; but it is followed from a use of a seam, since these two are where they are, and others
  // may be any number of periods away.
  Loop take_loop(Loop& uses) const
  {
    const std::size_t start = find_seam(uses);
    Loop loop(1, uses[start]);
    uses.erase(uses.begin() + start);
    std::size_t place = start < uses.size() ? start : 0; // where the last use was found
    std::size_t first = 0; // the place in the loop of the first use
    for(;;) {
      const std::size_t next = find_next(loop.back(), uses, place);
      if(next == uses.size())
        break;
      if(start > 0 && next == 0 && first == 0)
        first = loop.size();
      append(uses[next], loop);
      uses.erase(uses.begin() + next);
      place = next;
    }
    if(end_vertex(loop.back()) != begin_vertex(loop.front()))
      throw Parametric_surface_mesh_error("a loop is open: it begins at " + numbered("vertex", begin_vertex(loop.front()))
                                          + " and ends at " + numbered("vertex", end_vertex(loop.back())));
    std::rotate(loop.begin(), loop.begin() + first, loop.end());
    return loop;
  }

  // The first use of an edge that is used again; 0 if there is none.
  static std::size_t find_seam(const Loop& uses)
  {
    for(std::size_t i = 0; i < uses.size(); ++i)
      for(std::size_t k = i + 1; k < uses.size(); ++k)
        if(uses[i].edge == uses[k].edge)
          return i;
    return 0;
  }

  void append(const Edge_use& use, Loop& loop) const
  {
    const Vector_2 d = m_periods.between(end_point(loop.back()), begin_point(use));
    loop.push_back(use);
    if(d != Vector_2(0, 0))
      loop.back().curve = translated(use.curve, -d);
  }

  // Among the uses that begin at the vertex where `use` ends, the one closest to it in the domain; of several such, the first one from
  // `place` on that is not the way back on the same edge.
  std::size_t find_next(const Edge_use& use, const Loop& uses, std::size_t place) const
  {
    std::size_t best = uses.size();
    double least = 0;
    for(std::size_t k = 0; k < uses.size(); ++k) {
      const std::size_t i = (place + k) % uses.size();
      if(begin_vertex(uses[i]) != end_vertex(use))
        continue;
      const double d = domain_distance(end_point(use), begin_point(uses[i]));
      if(best == uses.size() || d < certainly_less * least
         || (uses[best].edge == use.edge && certainly_less * d <= least && uses[i].edge != use.edge)) {
        best = i;
        least = d;
      }
    }
    return best;
  }

  // The distance up to whole periods. Of two that are equal up to periods, the one without periods is smaller.
  double domain_distance(const Point_2& p, const Point_2& q) const
  {
    const double du = q.x() - p.x(), dv = q.y() - p.y();
    return std::fabs(remainder(du, m_surface.u_period())) + std::fabs(remainder(dv, m_surface.v_period()))
           + weight_of_periods * (std::fabs(du) + std::fabs(dv));
  }

  static double remainder(double x, double period) { return period > 0 ? std::remainder(x, period) : x; }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_ORDER_USES_H
