// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_FIRST_FUNDAMENTAL_FORM_METRIC_2_H
#define CGAL_FIRST_FUNDAMENTAL_FORM_METRIC_2_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Parametric_point_2.h>
#include <CGAL/Surface_jet_3.h>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherMetrics

The default metric field: the first fundamental form `M = J^T J` of the surface, the pull-back of
length in space. Its ellipses in the domain are the images of circles on the surface, so
triangles come out equilateral in 3D.

\cgalModels{ParametricSurfaceMetricField_2}

\tparam Kernel a model of `Kernel` with `double` as number type
*/
template <class Kernel>
class First_fundamental_form_metric_2
{
public:
  /// `(S_u.S_u  S_u.S_v; S_u.S_v  S_v.S_v)`
  Metric_tensor_2 tensor(const Surface_jet_3<Kernel>& jet) const
  {
    return Metric_tensor_2(jet.du * jet.du, jet.du * jet.dv, jet.dv * jet.dv);
  }

  /// the squared length of the chord in 3D.
  double squared_length(const Parametric_point_2<Kernel>& p, const Parametric_point_2<Kernel>& q) const
  {
    const auto &a = p.surface_point(), &b = q.surface_point();
    const double x = b.x() - a.x(), y = b.y() - a.y(), z = b.z() - a.z();
    return x * x + y * y + z * z;
  }
};

} // namespace CGAL

#endif // CGAL_FIRST_FUNDAMENTAL_FORM_METRIC_2_H
