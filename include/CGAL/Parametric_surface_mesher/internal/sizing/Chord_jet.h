// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_CHORD_JET_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_CHORD_JET_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Surface_jet_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Whether first derivatives change, within the surface, by as much as they are over a length in space. (A large deviation
// ratio allows edges along which those of a regular surface do: then it takes more.)
template <class Kernel>
bool changes_within(const Surface_jet_3<Kernel>& jet, double length, double gamma)
{
  typedef typename Kernel::Vector_3 Vector_3;
  const double e = jet.du.squared_length(), g = jet.dv.squared_length();
  const double squared_length = square(length * (std::min)(1., 1 / (14 * gamma)));
  if(!(jet.duu.squared_length() * squared_length > e * e || jet.dvv.squared_length() * squared_length > g * g
       || jet.duv.squared_length() * squared_length > e * g))
    return false;
  Vector_3 normal = cross_product(jet.du, jet.dv);
  if(normal.squared_length() > 0)
    normal = normal / std::sqrt(normal.squared_length());
  const auto squared_part_within = [&](const Vector_3& d) { return d.squared_length() - square(d * normal); };
  return squared_part_within(jet.duu) * squared_length > e * e || squared_part_within(jet.dvv) * squared_length > g * g
         || squared_part_within(jet.duv) * squared_length > e * g;
}

// First derivatives tell nothing about the distances between the points of a mesh where they change by as much as they are
// within one edge: where the parametrisation is singular, or nearly. There the slopes of chords as long as an edge replace
// them.
template <class Surface>
class Chord_jet
{
  typedef typename Surface::Geom_traits Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_2 Vector_2;
  typedef typename Kernel::Vector_3 Vector_3;

  static constexpr double smallest_share = 1e-3; // of the domain, that a chord begins with

  const Surface& m_surface;
  Bbox_2 m_box;

public:
  // no point outside `box` is evaluated
  Chord_jet(const Surface& surface, const Bbox_2& box) : m_surface(surface), m_box(box) {}

  // `jet`, that of the surface at `uv`, with the slopes of chords of about the given length as first derivatives
  Surface_jet_3<Kernel> operator()(const Point_2& uv, const Surface_jet_3<Kernel>& jet, double length) const
  {
    Surface_jet_3<Kernel> result = jet;
    result.du = slope(uv, Vector_2(1, 0), jet.du, 0.5 * m_box.x_span(), length);
    result.dv = slope(uv, Vector_2(0, 1), jet.dv, 0.5 * m_box.y_span(), length);
    return result;
  }

private:
  // From short chords to longer ones, to the first that is long enough. (From long to short ones a surface that closes on
  // itself would mislead: its longest chords have no length.)
  Vector_3 slope(const Point_2& uv, const Vector_2& direction, const Vector_3& derivative, double longest_step,
                 double length) const
  {
    double step = (std::min)(0.5 * length / std::sqrt(derivative.squared_length()), smallest_share * longest_step);
    step = (std::max)(step, 1e-9 * longest_step); // above the rounding errors of the domain's points
    for(;; step *= 1.6) {
      step = (std::min)(step, longest_step);
      const Point_2 p = in_box(uv - step * direction), q = in_box(uv + step * direction);
      const Vector_3 chord = m_surface.point(q.x(), q.y()) - m_surface.point(p.x(), p.y());
      if(!std::isfinite(chord.squared_length())) // outside the loops the surface need not be defined
        return derivative;
      if(step == longest_step || chord.squared_length() > 0.36 * length * length)
        return chord / ((q - p) * direction);
    }
  }

  Point_2 in_box(const Point_2& p) const
  {
    return Point_2((std::min)((std::max)(p.x(), m_box.xmin()), m_box.xmax()),
                   (std::min)((std::max)(p.y(), m_box.ymin()), m_box.ymax()));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_CHORD_JET_H
