// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_DOMAIN_2_H
#define CGAL_PARAMETRIC_DOMAIN_2_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Domain_curve_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherDomain

The trimmed part of the parameter domain: one outer boundary loop and any number of holes. A loop is a sequence of
curves, each starting where the one before ends. Loops may have either orientation.

\tparam Kernel a model of `Kernel` with `double` as number type
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel>
class Parametric_domain_2
{
public:
  typedef typename Kernel::Point_2 Point_2;
  typedef Domain_curve_2<Kernel> Curve;
  typedef std::vector<Curve> Loop;

private:
  std::vector<Loop> m_loops;

public:
  /// the domain inside `outer`.
  explicit Parametric_domain_2(Loop outer) { m_loops.push_back(std::move(outer)); }

  /// the domain inside the polygon `outer`.
  explicit Parametric_domain_2(const std::vector<Point_2>& outer)
    : Parametric_domain_2(polygon(outer))
  {}

  /// `[u_min, u_max] x [v_min, v_max]`; its curves in counterclockwise order from the side `v = v_min`.
  static Parametric_domain_2 rectangle(double u_min, double u_max, double v_min, double v_max)
  {
    return Parametric_domain_2(polygon({Point_2(u_min, v_min), Point_2(u_max, v_min),
                                        Point_2(u_max, v_max), Point_2(u_min, v_max)}));
  }

  /// the closed loop of segments through `points` (the last is joined to the first).
  static Loop polygon(const std::vector<Point_2>& points)
  {
    Loop loop;
    for(std::size_t i = 0; i < points.size(); ++i)
      loop.push_back(Curve::segment(points[i], points[(i + 1) % points.size()]));
    return loop;
  }

  /// cuts out the inside of `loop`.
  void add_hole(Loop loop) { m_loops.push_back(std::move(loop)); }

  /// the loops, the outer one first.
  const std::vector<Loop>& loops() const { return m_loops; }

  /// the loops, the outer one first: to prescribe divisions, for instance.
  std::vector<Loop>& loops() { return m_loops; }
};

} // namespace CGAL

#endif // CGAL_PARAMETRIC_DOMAIN_2_H
