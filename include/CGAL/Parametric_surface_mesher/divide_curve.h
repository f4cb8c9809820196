// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_DIVIDE_CURVE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_DIVIDE_CURVE_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Domain_curve_2.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/curves/Arc_length.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Surface_jet_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {

/*!
\ingroup PkgParametricSurfaceMesherDomain

The curve on a surface over a curve in its domain, `t -> S(c(t))`.

\cgalModels{ParametricCurve_3}

\tparam Surface a model of `ParametricSurface_3`
*/
template <class Surface>
class Curve_on_surface_3
{
public:
  typedef typename Surface::Geom_traits Geom_traits;
  typedef typename Geom_traits::Point_3 Point_3;
  typedef typename Geom_traits::Vector_3 Vector_3;
  typedef Domain_curve_2<Geom_traits> Domain_curve;

private:
  const Surface& m_surface;
  const Domain_curve& m_curve;

public:
  /// refers to both arguments.
  Curve_on_surface_3(const Surface& surface, const Domain_curve& curve) : m_surface(surface), m_curve(curve) {}

  double begin() const { return m_curve.begin(); }
  double end() const { return m_curve.end(); }

  /// the point at `t`.
  Point_3 point(double t) const
  {
    const auto uv = m_curve.point(t);
    const Point_3 p = m_surface.point(uv.x(), uv.y());
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      throw_not_finite(uv);
    return p;
  }

  /// the length of the derivative by `t`.
  double speed(double t) const
  {
    const typename Domain_curve::Jet c = m_curve.jet(t);
    const Surface_jet_3<Geom_traits> s = m_surface.jet(c.point.x(), c.point.y());
    const double speed = std::sqrt((c.first.x() * s.du + c.first.y() * s.dv).squared_length());
    if(!std::isfinite(speed))
      throw_not_finite(c.point);
    return speed;
  }

  /// the curvature radius in space at `t`; infinite where the curve is straight.
  double curvature_radius(double t) const
  {
    const typename Domain_curve::Jet c = m_curve.jet(t);
    const Surface_jet_3<Geom_traits> s = m_surface.jet(c.point.x(), c.point.y());
    const double u = c.first.x(), v = c.first.y();
    const Vector_3 first = u * s.du + v * s.dv;
    const Vector_3 second = u * u * s.duu + 2 * u * v * s.duv + v * v * s.dvv + c.second.x() * s.du + c.second.y() * s.dv;
    const double bend = std::sqrt(cross_product(first, second).squared_length());
    return bend > 0 ? std::pow(first.squared_length(), 1.5) / bend : std::numeric_limits<double>::infinity();
  }

private:
  template <class Point_2>
  static void throw_not_finite(const Point_2& uv)
  {
    std::ostringstream message;
    message << "the surface or its derivative is not finite on the boundary at (u,v) = (" << uv.x() << ", " << uv.y()
            << ")";
    throw Parametric_surface_mesh_error(message.str());
  }
};

namespace internal {

// The heights of a piece of a curve over its chord.
template <class Curve>
class Curve_heights
{
  typedef typename Curve::Geom_traits Kernel;
  typedef typename Kernel::Point_3 Point_3;

  static constexpr int number_of_places = 32;

  const Curve& m_curve;
  const double m_from, m_to; // parameters
  const Point_3 m_source, m_target;

public:
  Curve_heights(const Curve& curve, double from, double to)
    : m_curve(curve), m_from(from), m_to(to), m_source(curve.point(from)), m_target(curve.point(to))
  {}

  double chord() const { return std::sqrt(squared_distance(m_source, m_target)); }

  // \pre `chord() > 0`
  double largest_at_quarters() const { return std::sqrt((std::max)({squared_at(0.25), squared_at(0.5), squared_at(0.75)})); }

  // \pre `chord() > 0`
  double largest_at_eighths() const
  {
    return (std::max)(largest_at_quarters(), std::sqrt((std::max)({squared_at(0.125), squared_at(0.375), squared_at(0.625),
                                                                   squared_at(0.875)})));
  }

  // At places that no period has in common.
  // \pre `chord() > 0`
  double largest_at_many_places() const
  {
    const double golden_ratio = 0.6180339887498949;
    double result = 0;
    for(int i = 1; i <= number_of_places; ++i)
      result = (std::max)(result, squared_at(i * golden_ratio - std::floor(i * golden_ratio)));
    return (std::max)(std::sqrt(result), largest_at_quarters());
  }

private:
  double squared_at(double share) const
  {
    return squared_distance(m_curve.point(m_from + share * (m_to - m_from)), typename Kernel::Line_3(m_source, m_target));
  }
};

// The positions, as arc lengths, that divide one curve (paper, section "Curve Division").
template <class Curve, class ArcLength, class Size>
class Curve_division
{
  // Heights closer to the limit than this are looked at more closely: the largest need not be at a quarter.
  static constexpr double share_for_closer_look = 0.8;
  static constexpr double largest_ratio_to_height = 1.5; // of the half width of the ellipse around a piece

  const Curve& m_curve;
  const ArcLength& m_arc_length;
  const Size& m_size;
  const Parametric_surface_mesh_criteria& m_criteria;
  std::vector<Curve_position> m_positions;
  mutable std::unordered_map<double, double> m_sizes; // as far as they were asked for

public:
  Curve_division(const Curve& curve, const ArcLength& arc_length, const Size& size,
                 const Parametric_surface_mesh_criteria& criteria)
    : m_curve(curve), m_arc_length(arc_length), m_size(size), m_criteria(criteria)
  {}

  void divide_equally(std::size_t n)
  {
    for(std::size_t i = 0; i <= n; ++i)
      m_positions.push_back(m_arc_length.position_at(m_arc_length.length() * (double(i) / double(n))));
  }

  // halving by deviation and size, then until no piece is more than twice as long as its neighbour
  void halve()
  {
    const std::vector<Curve_position> positions(std::move(m_positions));
    m_positions.assign(1, positions.front());
    for(std::size_t i = 0; i + 1 < positions.size(); ++i)
      append_halves(positions[i], positions[i + 1]);
    halve_long_neighbors();
  }

  std::vector<double> parameters() const
  {
    std::vector<double> result;
    for(const Curve_position& position : m_positions)
      result.push_back(position.parameter);
    return result;
  }

private:
  double length(std::size_t i) const { return m_positions[i + 1].length - m_positions[i].length; }

  // of two on either side: so that pieces do not double twice in a row
  double shortest_neighbor(std::size_t i) const
  {
    double result = length(i);
    for(std::size_t k = i < 2 ? 0 : i - 2; k <= i + 2 && k + 1 < m_positions.size(); ++k)
      result = (std::min)(result, length(k));
    return result;
  }

  Curve_position middle(const Curve_position& from, const Curve_position& to) const
  {
    return m_arc_length.position_between(from, to, from.length + 0.5 * (to.length - from.length));
  }

  bool is_divisible(const Curve_position& from, const Curve_position& to) const
  {
    return to.length - from.length >= 2 * m_criteria.min_edge();
  }

  // appends the points of a piece but for its first one
  void append_halves(const Curve_position& from, const Curve_position& to)
  {
    if(is_divisible(from, to) && (deviates(from, to) || is_oversized(from, to))) {
      const Curve_position between = middle(from, to);
      append_halves(from, between);
      append_halves(between, to);
    }
    else {
      m_positions.push_back(to);
      check_number();
    }
  }

  void halve_long_neighbors()
  {
    for(bool changed = true; changed;) {
      changed = false;
      std::vector<Curve_position> finer(1, m_positions.front());
      for(std::size_t i = 0; i + 1 < m_positions.size(); ++i) {
        if(is_divisible(m_positions[i], m_positions[i + 1]) && length(i) > 2.01 * shortest_neighbor(i)) {
          finer.push_back(middle(m_positions[i], m_positions[i + 1]));
          changed = true;
        }
        finer.push_back(m_positions[i + 1]);
      }
      m_positions.swap(finer);
      check_number();
    }
  }

  void check_number() const
  {
    if(m_positions.size() > m_criteria.max_number_of_vertices())
      throw Parametric_surface_mesh_error("a boundary curve is divided into more than the allowed number of "
                                          + std::to_string(m_criteria.max_number_of_vertices())
                                          + " vertices; a larger minimum edge length than "
                                          + describe(m_criteria.min_edge()) + " would help");
  }

  static double interpolate(const Curve_position& from, const Curve_position& to, double share)
  {
    return from.parameter + share * (to.parameter - from.parameter);
  }

  // halving a piece of up to 1.4 times the wanted size would be further off than not
  bool is_oversized(const Curve_position& from, const Curve_position& to) const
  {
    for(double share : {0., 0.5, 1.})
      if(to.length - from.length > 1.4 * size(interpolate(from, to, share)))
        return true;
    return false;
  }

  // It costs much, and pieces share their ends.
  double size(double t) const
  {
    const auto found = m_sizes.emplace(t, 0);
    if(found.second)
      found.first->second = m_size(t);
    return found.first->second;
  }

  // The arc height is taken at the quarters too: at an inflection the middle lies on the chord.
  bool deviates(const Curve_position& from, const Curve_position& to) const
  {
    const Curve_heights<Curve> heights(m_curve, from.parameter, to.parameter);
    if(!(heights.chord() > 0))
      return true;
    const double limit = largest_height(heights, interpolate(from, to, 0.5));
    double height = heights.largest_at_quarters();
    if(height <= limit && may_hide_height(from, to, heights.chord(), height, limit))
      height = heights.largest_at_many_places();
    else if(height <= limit && height > share_for_closer_look * limit)
      height = heights.largest_at_eighths();
    return height > limit;
  }

  double largest_height(const Curve_heights<Curve>& heights, double middle) const
  {
    const double reference = m_criteria.curve_deviation() == Curve_deviation::HEIGHT_OVER_CHORD
                               ? heights.chord() : m_curve.curvature_radius(middle);
    const double by_ratio = m_criteria.gamma() * reference;
    return (std::min)(by_ratio, m_criteria.distance().value_or(by_ratio));
  }

  // Whether the arc length leaves room for more height than was found. A piece of length `s` between ends at distance `c` is
  // within an ellipse of half width sqrt(s^2 - c^2) / 2 around them, 1.15 times the height if it is a circular arc.
  static bool may_hide_height(const Curve_position& from, const Curve_position& to, double chord, double height, double limit)
  {
    const double s = to.length - from.length, squared_half_width = (s * s - chord * chord) / 4;
    return squared_half_width > limit * limit && squared_half_width > square(largest_ratio_to_height * height);
  }
};

} // namespace internal

/*!
\ingroup PkgParametricSurfaceMesherDomain

divides a curve in space (paper, section "Curve Division"): into `N = length / max_edge` pieces of equal length (eq. 1),
rounded up; then each piece in halves while its deviation is above `gamma`, or its arc height above `distance`, and the
half is not shorter than `min_edge`.

Two rules go beyond the paper, so that triangles along the curve can be well shaped: a piece is halved too while it is more
than 1.4 times as long as `size` wants, and after that pieces more than twice as long as a neighbour are.

Lengths are arc lengths in space, integrals of the speed's expansions in Legendre polynomials. A curve of length 0 (a
collapsed side of a patch) is one piece.

\param curve the curve: a model of `ParametricCurve_3`
\param criteria gives `max_edge`, `min_edge` (both must have been set), `gamma` and the deviation measure
\param size a callable: the wanted edge length at a parameter of the curve
\param min_number_of_edges a lower bound of the number of pieces: 3 for a curve that closes on itself
\param number_of_edges if not 0, the curve gets exactly this number of equal pieces instead
\return the parameters of the points, from `curve.begin()` to `curve.end()`, both included
\throws Parametric_surface_mesh_error if the curve is not finite, or `max_edge` or `min_edge` has not been set

\tparam Curve a model of `ParametricCurve_3`
*/
template <class Curve, class Size>
std::vector<double> divide_curve(const Curve& curve, const Parametric_surface_mesh_criteria& criteria, const Size& size,
                                 std::size_t min_number_of_edges = 1, std::size_t number_of_edges = 0)
{
  const auto speed = [&curve](double t) { return curve.speed(t); };
  typedef internal::Arc_length<decltype(speed)> Arc_length;
  Arc_length arc_length(speed, curve.begin(), curve.end(), 4);
  arc_length.refine(std::size_t((std::min)(arc_length.length() / (8 * criteria.max_edge()), 1e5)));
  if(!(arc_length.length() > 0))
    return {curve.begin(), curve.end()};

  internal::Curve_division<Curve, Arc_length, Size> division(curve, arc_length, size, criteria);
  if(number_of_edges > criteria.max_number_of_vertices())
    throw Parametric_surface_mesh_error("a boundary curve is to be divided into " + std::to_string(number_of_edges)
                                        + " pieces, which is more than the allowed number of vertices, "
                                        + std::to_string(criteria.max_number_of_vertices()));
  if(number_of_edges > 0) {
    division.divide_equally(number_of_edges);
    return division.parameters();
  }
  // the tolerance keeps a length of exactly n edges from becoming n + 1
  const double pieces = std::ceil(arc_length.length() / criteria.max_edge() * (1 - 1e-9));
  if(!(pieces <= double(criteria.max_number_of_vertices())))
    throw Parametric_surface_mesh_error("the maximum edge length " + internal::describe(criteria.max_edge())
                                        + " divides a boundary curve into more pieces than the allowed number of vertices");
  division.divide_equally((std::max)(std::size_t(pieces), min_number_of_edges));
  division.halve();
  return division.parameters();
}

/// \ingroup PkgParametricSurfaceMesherDomain
/// divides a curve as above, without wanted sizes.
template <class Curve>
std::vector<double> divide_curve(const Curve& curve, const Parametric_surface_mesh_criteria& criteria)
{
  return divide_curve(curve, criteria, [](double) { return std::numeric_limits<double>::infinity(); });
}

} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_DIVIDE_CURVE_H
