// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_LINEAR_TENSOR_FIELD_2_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_LINEAR_TENSOR_FIELD_2_H

#include <CGAL/Metric_tensor_2.h>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The metric around a triangle as its corners tell it: the linear function with their tensors. Outside it need not be
// positive definite, and that of a triangle without area in the domain is not finite.
template <class Point>
class Linear_tensor_field_2
{
  const Point &m_p, &m_q, &m_r;

public:
  // refers to the points
  Linear_tensor_field_2(const Point& p, const Point& q, const Point& r) : m_p(p), m_q(q), m_r(r) {}

  // at (u,v)
  Metric_tensor_2 operator()(double u, double v) const
  {
    const double qu = m_q.x() - m_p.x(), qv = m_q.y() - m_p.y(), ru = m_r.x() - m_p.x(), rv = m_r.y() - m_p.y();
    const double xu = u - m_p.x(), xv = v - m_p.y(), area = qu * rv - qv * ru;
    const double of_q = (xu * rv - xv * ru) / area, of_r = (qu * xv - qv * xu) / area; // barycentric coordinates
    return (1 - of_q - of_r) * m_p.tensor() + of_q * m_q.tensor() + of_r * m_r.tensor();
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_LINEAR_TENSOR_FIELD_2_H
