// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_LOOP_CLOSER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_LOOP_CLOSER_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Boundary_size.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Open_cascade_surface_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Domain_periods.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/convert_curves.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Makes the curves of a loop meet exactly in the domain of a face. In a file they meet only up to tolerances, and do not meet at poles
// whose collapsed edge is missing. ShapeFix_Wire of Open CASCADE also closes loops, but changes edges, which faces share, and keeps
// gaps within the tolerances.
class Loop_closer
{
  typedef Parametric_surface_model_3<Open_cascade_surface_3> Model;
  typedef Model::Edge_use Edge_use;
  typedef Model::Loop Loop;
  typedef Model::Curve Curve;
  typedef Model::Geom_traits Kernel;
  typedef Kernel::Point_2 Point_2;
  typedef Kernel::Vector_2 Vector_2;

  // Ends of curves are joined up to so many times the tolerances of the file, which are often exceeded.
  static constexpr double tolerance_factor = 10;
  // A collapsed side whose other coordinate changes by less than this share is parallel to an axis up to rounding; one with less
  // than the second share, if the surface collapses on the side parallel to the axis, too.
  static constexpr double slope_of_straight_side = 1e-6, slope_of_slanted_side = 1e-2;
  // A surface collapses on a segment of its domain whose image is shorter than this share of what the segment would be long at
  // the mean speed of the parameters along the boundary. On a pole the share is 0, in a gap between curves it is about 1.
  static constexpr double collapsed_share = 0.05;
  // Limits, as shares of the domain, of a tolerance that is converted to the domain: roundings are above the first, and points
  // farther apart than the second are never joined.
  static constexpr double least_share_of_domain = 1e-9, largest_share_of_domain = 1e-2;
  // Points are joined although they are farther apart in space than in the domain by this factor, where parameters run slowly.
  static constexpr double factor_of_slow_parameters = 1e3;
  // Ends of curves that are farther apart than this share of the widest gap meet at the vertex, and not where one of them ends. It is a
  // hundredth of the minimum edge that mesh_cad takes by default, so that no piece is much changed by less.
  static constexpr double share_of_wide_gap = 0.1;
  static constexpr int number_of_samples = 8, number_of_newton_steps = 4;

  Model& m_model;
  const Open_cascade_surface_3& m_surface;
  const std::vector<double>& m_vertex_tolerances;
  double m_least_tolerance, m_widest_gap;
  double m_tolerance_u = 0, m_tolerance_v = 0; // lengths in the domain of a length of 1 in space
  Bbox_2 m_box;
  std::map<std::size_t, std::vector<Point_2>> m_corners; // by vertex

public:
  // Both distances are in space. Points closer than `least_tolerance` are the same point whatever the tolerance of their vertex is,
  // and the ends of successive curves are joined if they are closer than `widest_gap`.
  Loop_closer(Model& model, const Open_cascade_surface_3& surface, const std::vector<double>& vertex_tolerances,
              double least_tolerance, double widest_gap)
    : m_model(model), m_surface(surface), m_vertex_tolerances(vertex_tolerances), m_least_tolerance(least_tolerance),
      m_widest_gap(widest_gap)
  {}

  // \pre each use of a loop begins at the vertex where the one before it ends, with no whole periods between the curves
  void operator()(std::vector<Loop>& loops)
  {
    for(const Loop& loop : loops)
      check_periods(loop);
    measure(loops);
    for(Loop& loop : loops)
      for(Edge_use& use : loop)
        straighten_collapsed(use);
    for(Loop& loop : loops) {
      remove_short_collapsed(loop);
      close(loop);
    }
    put_outer_loop_first(loops);
    move_holes_inside(loops);
  }

  // Makes the ends of the curve of an edge inside the face meet loops, and other such edges, exactly.
  // \pre the loops are closed
  // \throws Parametric_surface_mesh_error if an end is farther from its vertex in the domain than tolerances allow
  void attach(Edge_use& use, const std::vector<Loop>& loops)
  {
    std::map<std::size_t, std::vector<Point_2>> corners; // those in the map of the loops may have been moved by periods
    for(const Loop& loop : loops)
      for(const Edge_use& of_loop : loop)
        corners[begin_vertex(of_loop)].push_back(begin_point(of_loop));
    move_inside(use, loops.front());
    set_begin_point(use, attached(begin_vertex(use), begin_point(use), corners));
    corners[begin_vertex(use)].push_back(begin_point(use)); // where it may end, too
    set_end_point(use, attached(end_vertex(use), end_point(use), corners));
  }

private:
  const Model::Edge& edge(const Edge_use& use) const { return m_model.edges()[use.edge]; }
  std::size_t begin_vertex(const Edge_use& use) const { return use.is_reversed ? edge(use).target : edge(use).source; }
  std::size_t end_vertex(const Edge_use& use) const { return use.is_reversed ? edge(use).source : edge(use).target; }

  static Point_2 begin_point(const Edge_use& use) { return use.is_reversed ? use.curve.target() : use.curve.source(); }
  static Point_2 end_point(const Edge_use& use) { return use.is_reversed ? use.curve.source() : use.curve.target(); }

  static void set_begin_point(Edge_use& use, const Point_2& p)
  {
    use.is_reversed ? use.curve.set_end_points(use.curve.source(), p) : use.curve.set_end_points(p, use.curve.target());
  }

  static void set_end_point(Edge_use& use, const Point_2& p)
  {
    use.is_reversed ? use.curve.set_end_points(p, use.curve.target()) : use.curve.set_end_points(use.curve.source(), p);
  }

  // Makes a collapsed side exactly parallel to an axis if it is so up to rounding, or up to the tolerance of its vertex.
  void straighten_collapsed(Edge_use& use) const
  {
    if(!edge(use).is_collapsed)
      return;
    const Point_2 p = use.curve.source(), q = use.curve.target();
    const double du = std::fabs(q.x() - p.x()), dv = std::fabs(q.y() - p.y());
    if(dv < slope_of_straight_side * du)
      use.curve = Curve::segment(p, Point_2(q.x(), p.y()));
    else if(du < slope_of_straight_side * dv)
      use.curve = Curve::segment(p, Point_2(p.x(), q.y()));
    else if(dv < slope_of_slanted_side * du)
      straighten_slanted(use, {Curve::segment(p, Point_2(q.x(), p.y())), Curve::segment(Point_2(p.x(), q.y()), q)});
    else if(du < slope_of_slanted_side * dv)
      straighten_slanted(use, {Curve::segment(p, Point_2(p.x(), q.y())), Curve::segment(Point_2(q.x(), p.y()), q)});
    else
      use.curve = Curve::segment(p, q);
  }

  // Of the sides through either end of a slanted one takes that which is shorter in space, if it is a pole.
  void straighten_slanted(Edge_use& use, const std::array<Curve, 2>& sides) const
  {
    const auto length = [this](const Curve& c) { return length_in_space(c.source(), c.target()); };
    const Curve& side = length(sides[1]) < length(sides[0]) ? sides[1] : sides[0];
    const bool is_pole = is_at_vertex(side.source(), side.target(), edge(use).source)
                         && is_collapsed(side.source(), side.target());
    use.curve = is_pole ? side : Curve::segment(use.curve.source(), use.curve.target());
  }

  void check_periods(const Loop& loop) const
  {
    const Point_2 p = end_point(loop.back()), q = begin_point(loop.front());
    if(Domain_periods(m_surface).between(p, q) != Vector_2(0, 0))
      throw Parametric_surface_mesh_error("a loop runs once around a periodic surface, from (u,v) = " + describe(q) + " to "
                                          + describe(p) + ", and there is no seam");
  }

  // Measures how far apart, in the domain, points are whose distance in space is 1, as a mean over the boundary.
  void measure(const std::vector<Loop>& loops)
  {
    const auto curve = [](const Edge_use& use) -> const auto& { return use.curve; };
    m_box = domain_box(loops, curve);
    double length_u = 0, length_v = 0, n = 0;
    for(const Loop& loop : loops)
      for(const Edge_use& use : loop)
        for(double t : {0.25, 0.5, 0.75}) {
          const Point_2 p = use.curve.point(t);
          const auto jet = m_surface.jet(p.x(), p.y());
          length_u += std::sqrt(jet.du.squared_length());
          length_v += std::sqrt(jet.dv.squared_length());
          ++n;
        }
    m_tolerance_u = length_u > 0 ? n / length_u : 0;
    m_tolerance_v = length_v > 0 ? n / length_v : 0;
  }

  double tolerance(std::size_t vertex) const
  {
    return (std::max)(tolerance_factor * m_vertex_tolerances[vertex], m_least_tolerance);
  }

  bool are_close(const Point_2& p, const Point_2& q, double tolerance) const
  {
    const auto limit = [=](double per_length, double span) {
      return (std::min)((std::max)(tolerance * per_length, least_share_of_domain * span), largest_share_of_domain * span);
    };
    return std::fabs(p.x() - q.x()) <= limit(m_tolerance_u, m_box.x_span())
           && std::fabs(p.y() - q.y()) <= limit(m_tolerance_v, m_box.y_span());
  }

  // Removes collapsed sides that are not longer, in the domain, than the tolerance, or on which the surface does not collapse.
  void remove_short_collapsed(Loop& loop) const
  {
    const auto is_short = [this](const Edge_use& use) {
      const Point_2 &p = use.curve.source(), &q = use.curve.target();
      return edge(use).is_collapsed
             && (are_close(p, q, tolerance(edge(use).source)) || (is_at_vertex(p, q, edge(use).source) && !is_collapsed(p, q)));
    };
    loop.erase(std::remove_if(loop.begin(), loop.end(), is_short), loop.end());
    if(loop.empty())
      throw Parametric_surface_mesh_error("a loop is a point in space");
  }

  void close(Loop& loop)
  {
    Loop result;
    for(std::size_t i = 0; i < loop.size(); ++i) {
      result.push_back(loop[i]);
      Edge_use& next = loop[(i + 1) % loop.size()];
      join(result, i + 1 < loop.size() ? next : result.front());
    }
    loop.swap(result);
  }

  // Joins the last use of `loop` to `next`, with a collapsed edge between them if there is a pole. Any other gap that is in the
  // tolerance of the vertex is closed, however large it is in the domain.
  void join(Loop& loop, Edge_use& next)
  {
    const std::size_t vertex = end_vertex(loop.back());
    Point_2 p = end_point(loop.back()), q = begin_point(next);
    const bool is_gap = !are_close(p, q, tolerance(vertex)), is_gap_in_tolerance = is_gap && is_at_vertex(p, q, vertex);
    if(is_gap_in_tolerance && is_collapsed(p, q)) {
      p = corner(vertex, p);
      q = corner(vertex, q);
      set_end_point(loop.back(), p);
      set_begin_point(next, q);
      const std::size_t number = m_model.add_edge(vertex, vertex, true);
      loop.push_back({number, false, Curve::segment(p, q)});
      straighten_collapsed(loop.back());
      set_begin_point(next, end_point(loop.back()));
      return;
    }
    if(!is_gap_in_tolerance)
      check_gap(p, q, vertex);
    const int rank_before = rank(loop.back()), rank_after = rank(next);
    const bool is_beside_pole = (std::max)(rank_before, rank_after) == 2;
    const bool is_wide = !is_beside_pole && !are_close(p, q, share_of_wide_gap * m_widest_gap);
    const Point_2 r = corner(vertex, is_wide ? foot_of_vertex(p, q, vertex) : rank_after > rank_before ? q : p);
    set_end_point(loop.back(), r);
    set_begin_point(next, r);
  }

  // The point of the surface that is closest to a vertex. It is searched for from the closer one of two points; if that comes to
  // nothing, the result is this one.
  Point_2 foot_of_vertex(const Point_2& p, const Point_2& q, std::size_t vertex) const
  {
    const auto squared = [&](const Point_2& x) { return squared_distance(m_surface.point(x.x(), x.y()), m_model.vertices()[vertex]); };
    Point_2 result = squared(q) < squared(p) ? q : p;
    for(int i = 0; i < number_of_newton_steps; ++i) {
      const auto jet = m_surface.jet(result.x(), result.y());
      const auto d = m_model.vertices()[vertex] - jet.point;
      const double e = jet.du * jet.du, f = jet.du * jet.dv, g = jet.dv * jet.dv, determinant = e * g - f * f, du = d * jet.du, dv = d * jet.dv;
      const Point_2 next = result + Vector_2((g * du - f * dv) / determinant, (e * dv - f * du) / determinant);
      if(!(squared(next) < squared(result)))
        break;
      result = next;
    }
    return result;
  }

  // Of two curves that meet with no wide gap, or beside a pole, the end of the one with the higher rank is kept.
  int rank(const Edge_use& use) const { return edge(use).is_collapsed ? 2 : use.curve.is_straight() ? 1 : 0; }

  // Makes loops that touch in a vertex have exactly the same point there.
  Point_2 corner(std::size_t vertex, const Point_2& p)
  {
    for(const Point_2& q : m_corners[vertex])
      if(are_close(p, q, tolerance(vertex)))
        return q;
    m_corners[vertex].push_back(p);
    return p;
  }

  // The length of the image of a segment.
  double length_in_space(const Point_2& p, const Point_2& q) const
  {
    double result = 0;
    const auto point = [&](int i) {
      const Point_2 x = p + (double(i) / number_of_samples) * (q - p);
      return m_surface.point(x.x(), x.y());
    };
    for(int i = 0; i < number_of_samples; ++i)
      result += std::sqrt(squared_distance(point(i), point(i + 1)));
    return result;
  }

  // Whether the surface makes a segment much shorter than it makes the boundary.
  bool is_collapsed(const Point_2& p, const Point_2& q) const
  {
    const auto length = [](double difference, double per_length) { return per_length > 0 ? std::fabs(difference) / per_length : 0; };
    return length_in_space(p, q) < collapsed_share * (length(q.x() - p.x(), m_tolerance_u) + length(q.y() - p.y(), m_tolerance_v));
  }

  // Whether the segment between two domain points is at a vertex in space, up to its tolerance.
  bool is_at_vertex(const Point_2& p, const Point_2& q, std::size_t vertex) const
  {
    const double squared_tolerance = square(tolerance(vertex));
    for(int i = 0; i <= number_of_samples; ++i) {
      const Point_2 x = p + (double(i) / number_of_samples) * (q - p);
      if(!(squared_distance(m_surface.point(x.x(), x.y()), m_model.vertices()[vertex]) <= squared_tolerance))
        return false;
    }
    return true;
  }

  void check_gap(const Point_2& p, const Point_2& q, std::size_t vertex) const
  {
    const double gap = std::sqrt(squared_distance(m_surface.point(p.x(), p.y()), m_surface.point(q.x(), q.y())));
    if(!(gap <= (std::max)(tolerance(vertex), m_widest_gap)) || !are_close(p, q, (std::max)(tolerance(vertex), factor_of_slow_parameters * gap)))
      throw Parametric_surface_mesh_error("a loop is open in the domain, between (u,v) = " + describe(p) + " and "
                                          + describe(q) + ", " + describe(gap) + " apart in space");
  }

  static double double_area(const Loop& loop)
  {
    double result = 0;
    for(const Edge_use& use : loop)
      result += (use.is_reversed ? -1 : 1) * double_area_seen_from(loop.front().curve.source(), use.curve);
    return result;
  }

  static void put_outer_loop_first(std::vector<Loop>& loops)
  {
    std::size_t outer = 0;
    for(std::size_t l = 1; l < loops.size(); ++l)
      if(std::fabs(double_area(loops[l])) > std::fabs(double_area(loops[outer])))
        outer = l;
    std::rotate(loops.begin(), loops.begin() + outer, loops.begin() + outer + 1);
  }

  void move_holes_inside(std::vector<Loop>& loops) const
  {
    for(std::size_t l = 1; l < loops.size(); ++l) {
      const Vector_2 d = Domain_periods(m_surface).into(box(loops[l]), box(loops.front()));
      if(d != Vector_2(0, 0))
        for(Edge_use& use : loops[l])
          use.curve = translated(use.curve, d);
    }
  }

  void move_inside(Edge_use& use, const Loop& outer) const
  {
    const Vector_2 d = Domain_periods(m_surface).into(box({use}), box(outer));
    if(d != Vector_2(0, 0))
      use.curve = translated(use.curve, d);
  }

  // The corner at which an edge inside the face ends: the closest one of its vertex, or a new one.
  Point_2 attached(std::size_t vertex, const Point_2& p, const std::map<std::size_t, std::vector<Point_2>>& corners) const
  {
    const auto found = corners.find(vertex);
    if(found == corners.end())
      return p;
    const Point_2 corner = *std::min_element(found->second.begin(), found->second.end(), [&](const Point_2& a, const Point_2& b) {
      return squared_distance(a, p) < squared_distance(b, p);
    });
    if(!are_close(p, corner, tolerance(vertex)))
      check_gap(p, corner, vertex);
    return corner;
  }

  static Bbox_2 box(const Loop& loop)
  {
    return loop_box(loop, [](const Edge_use& use) -> const auto& { return use.curve; });
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_LOOP_CLOSER_H
