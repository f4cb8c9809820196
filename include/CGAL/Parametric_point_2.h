// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_POINT_2_H
#define CGAL_PARAMETRIC_POINT_2_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Metric_tensor_2.h>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherTraits

A point `(u,v)` of the parameter domain that carries its point `S(u,v)` on the surface and the metric tensor there,
both evaluated once, when the point is made. As a `Point_2` it is the domain point, so that it compares,
and takes part in the predicates and constructions of `Kernel`, by its coordinates alone.

\tparam Kernel a model of `Kernel` with `double` as number type
*/
template <class Kernel>
class Parametric_point_2
  : public Kernel::Point_2
{
  typedef typename Kernel::Point_2 Base;

public:
  typedef typename Kernel::Point_2 Domain_point_2;
  typedef typename Kernel::Point_3 Surface_point_3;

private:
  Surface_point_3 m_surface_point;
  Metric_tensor_2 m_tensor;

public:
  Parametric_point_2() : Base(0, 0), m_surface_point(0, 0, 0) {}

  /// the domain point `p` in the plane: `S(u,v) = (u,v,0)` and the Euclidean metric.
  explicit Parametric_point_2(const Domain_point_2& p)
    : Base(p), m_surface_point(p.x(), p.y(), 0)
  {}

  /// the point `(x,y)` in the plane.
  Parametric_point_2(double x, double y)
    : Base(x, y), m_surface_point(x, y, 0)
  {}

  /// the domain point `p` with its surface point and metric tensor.
  Parametric_point_2(const Domain_point_2& p, const Surface_point_3& s, const Metric_tensor_2& tensor)
    : Base(p), m_surface_point(s), m_tensor(tensor)
  {}

  /// `(u,v)`
  const Domain_point_2& domain_point() const { return *this; }

  /// `S(u,v)`
  const Surface_point_3& surface_point() const { return m_surface_point; }

  /// the metric tensor at `(u,v)`
  const Metric_tensor_2& tensor() const { return m_tensor; }
};

} // namespace CGAL

#endif // CGAL_PARAMETRIC_POINT_2_H
