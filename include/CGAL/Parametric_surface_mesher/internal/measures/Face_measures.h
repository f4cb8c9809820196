// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_FACE_MEASURES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_FACE_MEASURES_H

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The measures of a triangle that criteria and placement use, all computed from the squared lengths of its edges under the metric.
// With the default metric these are the measures of the triangle in space.
struct Face_measures
{
  std::array<double, 3> squared_lengths; // entry i: of the edge opposite to vertex i
  double squared_circumradius;
  double squared_smallest_sine; // squared sine of the smallest angle
};

// 16 times the squared area, by Heron's formula.
inline double squared_area_16(const std::array<double, 3>& l)
{
  return 2 * (l[0] * l[1] + l[1] * l[2] + l[2] * l[0]) - (l[0] * l[0] + l[1] * l[1] + l[2] * l[2]);
}

inline double squared_circumradius(const std::array<double, 3>& l)
{
  const double area = squared_area_16(l);
  return area > 0 ? l[0] * l[1] * l[2] / area : std::numeric_limits<double>::infinity();
}

// The squared sine of the smallest angle.
inline double squared_smallest_sine(const std::array<double, 3>& l)
{
  const double area = squared_area_16(l);
  return area > 0 ? (std::min)(l[0], (std::min)(l[1], l[2])) * area / (4 * (l[0] * l[1] * l[2])) : 0;
}

inline double squared_sine_of_degrees(double angle)
{
  const double sine = std::sin(angle * CGAL_PI / 180);
  return sine * sine;
}

inline Face_measures face_measures(const std::array<double, 3>& l)
{
  const double product = l[0] * l[1] * l[2];
  const double area = squared_area_16(l);
  const double shortest = (std::min)(l[0], (std::min)(l[1], l[2]));
  if(area > 0)
    return {l, product / area, shortest * area / (4 * product)};
  return {l, std::numeric_limits<double>::infinity(), 0};
}

template <class Face_handle, class MetricField>
std::array<double, 3> squared_lengths(Face_handle f, const MetricField& metric)
{
  const auto &p = f->vertex(0)->point(), &q = f->vertex(1)->point(), &r = f->vertex(2)->point();
  return {metric.squared_length(q, r), metric.squared_length(r, p), metric.squared_length(p, q)};
}

template <class Face_handle, class MetricField>
Face_measures face_measures(Face_handle f, const MetricField& metric)
{
  return face_measures(squared_lengths(f, metric));
}

// Whether a face is on the wrong side, see the oracle.
template <class Face_handle, class Oracle>
bool is_inverted(Face_handle f, const Oracle& oracle)
{
  return oracle.is_inverted(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
}

// How far the surface may be from a triangle.
struct Deviation_limits
{
  double gamma;                  // largest H/L of an edge
  double squared_distance;       // 0 for no limit
  double squared_divisible_edge; // edges that are not longer cannot be refined
};

// How far the surface is from a triangle or an edge.
struct Squared_deviation
{
  double ratio = 0;  // (H/L)^2
  double height = 0; // H^2

  void include(const Squared_deviation& other)
  {
    ratio = (std::max)(ratio, other.ratio);
    height = (std::max)(height, other.height);
  }

  bool has_ratio_within(const Deviation_limits& limits) const { return ratio <= limits.gamma * limits.gamma; }

  bool has_height_within(const Deviation_limits& limits) const
  {
    return !(limits.squared_distance > 0) || height <= limits.squared_distance;
  }
};

// Notes an edge as close to the surface, in both its faces if both are in the domain.
template <class Face_handle>
void set_close(Face_handle f, int i)
{
  f->set_close(i);
  if(!f->is_constrained(i))
    f->neighbor(i)->set_close(f->neighbor(i)->index(f));
}

template <class Face_handle>
double squared_length_in_space(Face_handle f, int i)
{
  return squared_distance(f->vertex((i + 1) % 3)->point().surface_point(), f->vertex((i + 2) % 3)->point().surface_point());
}

// Whether an edge is long enough to be divided.
template <class Face_handle>
bool has_divisible_edge(Face_handle f, const Deviation_limits& limits)
{
  return squared_length_in_space(f, 0) > limits.squared_divisible_edge
         || squared_length_in_space(f, 1) > limits.squared_divisible_edge
         || squared_length_in_space(f, 2) > limits.squared_divisible_edge;
}

// Close to the limit of the distance more places are looked at: the largest height of a curved surface need not be at the middle
// of an edge or at a centroid. It is most often less than 1/0.7 of that: on the CAD models that were tried no distance at a
// thousandth of the diagonal was missed by this share, and half as many heights are looked at closely as by 1/2.
constexpr double squared_share_for_closer_look = 0.7 * 0.7;

// by which the largest height may be above that of the places of a closer look
constexpr double squared_safety_of_closer_look = 1.01;

inline bool needs_closer_look(double squared_height, const Deviation_limits& limits)
{
  return squared_height > squared_share_for_closer_look * limits.squared_distance && squared_height <= limits.squared_distance;
}

// The height over an edge, given that at its middle: if that is close to the limit of the distance also at its quarters, and
// between them by the polynomial that has these heights, and none at the ends.
template <class Point, class Oracle>
double squared_height_of_edge(double middle, const Point& p, const Point& q, const Oracle& oracle, const Deviation_limits& limits)
{
  if(!needs_closer_look(middle, limits))
    return middle;
  const double first = oracle.squared_height_at(0.25, p, q, limits.gamma),
               last = oracle.squared_height_at(0.75, p, q, limits.gamma);
  const double a = std::sqrt(first), b = std::sqrt(middle), c = std::sqrt(last);
  // Lagrange's polynomials of the places 0, 1/4, 1/2, 3/4 and 1 at 3/8, and mirrored at 5/8
  constexpr double near = 15. / 32, center = 45. / 64, far = -5. / 32;
  const double between = (std::max)(near * a + center * b + far * c, far * a + center * b + near * c);
  return (std::max)({middle, squared_safety_of_closer_look * first, squared_safety_of_closer_look * last,
                     squared_safety_of_closer_look * between * between});
}

// The deviation at an edge, which is noted in both its faces if it is within the limits, and not evaluated again.
template <class Face_handle, class Oracle>
Squared_deviation squared_deviation_of_edge(Face_handle f, int i, double squared_length, const Oracle& oracle,
                                            const Deviation_limits& limits)
{
  Squared_deviation result;
  const auto &p = f->vertex((i + 1) % 3)->point(), &q = f->vertex((i + 2) % 3)->point();
  const double middle = oracle.squared_height(p, q, limits.gamma);
  result.height = squared_height_of_edge(middle, p, q, oracle, limits);
  if(middle > 0)
    result.ratio = middle / squared_length;
  if(result.has_ratio_within(limits) && result.has_height_within(limits))
    set_close(f, i);
  return result;
}

// The largest deviation at the edges for which a triangle can be refined: neither on the boundary nor, for the sake of the
// ratio, too short to be divided. A triangle whose edges are all too short is left alone.
template <class Face_handle, class Oracle>
Squared_deviation squared_deviation_to_refine(Face_handle f, const Oracle& oracle, const Deviation_limits& limits)
{
  Squared_deviation worst;
  if(!has_divisible_edge(f, limits))
    return worst;
  for(int i = 0; i < 3; ++i) {
    if(f->is_constrained(i) || f->is_close(i))
      continue;
    const double squared_length = squared_length_in_space(f, i);
    const bool is_divisible = squared_length > limits.squared_divisible_edge;
    if(!is_divisible && !(limits.squared_distance > 0))
      continue;
    Squared_deviation found = squared_deviation_of_edge(f, i, squared_length, oracle, limits);
    if(!is_divisible)
      found.ratio = 0;
    worst.include(found);
  }
  return worst;
}

// The largest deviation at all edges that are not known to be close to the surface.
template <class Face_handle, class Oracle>
Squared_deviation squared_deviation_of_edges(Face_handle f, const Oracle& oracle, const Deviation_limits& limits)
{
  Squared_deviation worst;
  for(int i = 0; i < 3; ++i)
    if(!f->is_close(i))
      worst.include(squared_deviation_of_edge(f, i, squared_length_in_space(f, i), oracle, limits));
  return worst;
}

// Heights of the surface over the plane of a triangle, at places given by barycentric coordinates.
template <class Face_handle, class Oracle>
class Heights_over_face
{
  typedef typename Oracle::Geom_traits Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef std::array<double, 3> Barycentric;

  const Face_handle m_face;
  const Oracle& m_oracle;
  const typename Kernel::Vector_3 m_normal;
  const double m_squared_length; // of the normal

public:
  Heights_over_face(Face_handle f, const Oracle& oracle)
    : m_face(f), m_oracle(oracle), m_normal(cross_product(corner(1) - corner(0), corner(2) - corner(0))),
      m_squared_length(m_normal * m_normal)
  {}

  bool has_area() const { return m_squared_length > 0; }

  // times the length of the normal
  double operator()(double x, double y, double z) const
  {
    const auto &a = m_face->vertex(0)->point(), &b = m_face->vertex(1)->point(), &c = m_face->vertex(2)->point();
    const Point_2 place(x * a.x() + y * b.x() + z * c.x(), x * a.y() + y * b.y() + z * c.y());
    return at(place);
  }

  // the same at the centroid
  double at_centroid() const
  {
    const auto &a = m_face->vertex(0)->point(), &b = m_face->vertex(1)->point(), &c = m_face->vertex(2)->point();
    return at(Point_2((a.x() + b.x() + c.x()) / 3, (a.y() + b.y() + c.y()) / 3));
  }

  double squared(double height) const { return height * height / m_squared_length; }

  // The largest squared height, given that at the centroid: of the middles of the edges, and of the place where that is
  // largest of a polynomial which has all these heights.
  double largest_square(double at_centroid) const
  {
    const double m0 = (*this)(0, 0.5, 0.5), m1 = (*this)(0.5, 0, 0.5), m2 = (*this)(0.5, 0.5, 0);
    const double bubble = 27 * (at_centroid - (m0 + m1 + m2) * 4 / 9);
    Barycentric best = {1. / 3, 1. / 3, 1. / 3};
    double largest = std::fabs(at_centroid);
    const auto look_at = [&](double x, double y, double z) {
      const double height = std::fabs(4 * (m0 * y * z + m1 * z * x + m2 * x * y) + bubble * x * y * z);
      if(height > largest) {
        largest = height;
        best = {x, y, z};
      }
    };
    for(const double x : {8. / 12, 2. / 12}) { // towards the corners, and towards the middles of the edges
      const double y = (1 - x) / 2;
      look_at(x, y, y);
      look_at(y, x, y);
      look_at(y, y, x);
    }
    // that of the polynomial without the bubble, where its three derivatives are the same
    const double x = m0 * (m1 + m2 - m0), y = m1 * (m2 + m0 - m1), z = m2 * (m0 + m1 - m2), sum = x + y + z;
    if(sum != 0 && x / sum > 0 && y / sum > 0 && z / sum > 0)
      look_at(x / sum, y / sum, z / sum);
    const double result
      = (std::max)({square(at_centroid), square(m0), square(m1), square(m2), square((*this)(best[0], best[1], best[2]))});
    return squared_safety_of_closer_look * result / m_squared_length;
  }

private:
  const typename Kernel::Point_3& corner(int i) const { return m_face->vertex(i)->point().surface_point(); }

  double at(const Point_2& place) const
  {
    const double height = m_normal * (m_oracle.surface().point(place.x(), place.y()) - corner(0));
    if(!std::isfinite(height))
      throw_not_finite(m_oracle.surface(), place);
    return height;
  }
};

// The largest squared distance of the surface inside a triangle from its plane: at its centroid, and if that is close to the limit
// at more places. (A height that is quadratic over a triangle, and within the limit at the middles of its edges, is beyond it
// nowhere unless that at the centroid is above 8/9 of the limit.)
template <class Face_handle, class Oracle>
double squared_distance_inside(Face_handle f, const Oracle& oracle, const Deviation_limits& limits)
{
  const Heights_over_face<Face_handle, Oracle> heights(f, oracle);
  if(!heights.has_area())
    return 0;
  const double at_centroid = heights.at_centroid(), squared = heights.squared(at_centroid);
  return needs_closer_look(squared, limits) ? heights.largest_square(at_centroid) : squared;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_FACE_MEASURES_H
