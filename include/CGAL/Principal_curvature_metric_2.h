// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PRINCIPAL_CURVATURE_METRIC_2_H
#define CGAL_PRINCIPAL_CURVATURE_METRIC_2_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Parametric_point_2.h>
#include <CGAL/Parametric_surface_mesher/internal/support/check_value.h>
#include <CGAL/Surface_curvature_3.h>
#include <CGAL/Surface_jet_3.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherMetrics

A metric field that stretches triangles along the direction of least curvature, which is the paper's definition taken
literally: the ellipse has its major axis along the direction of least principal curvature, and the ratio of its
half axes is that of the principal curvatures, `k = |kappa_max| / |kappa_min|`.

Direction and ratio are those of the ellipse *in the tangent plane*, and the tensor is its pull-back to the domain, so that
the metric does not depend on the parametrisation. Where that is an isometry, the tensor is that of eq. (5) of the paper.

The metric has the area of the surface: a triangle equilateral in it is stretched in 3D by `sqrt(k)` along
the direction of least curvature and compressed by `sqrt(k)` across. The criteria measure
angles and sizes in it, so a mesh of this metric has small angles in 3D where `k` is large: fewer
triangles for the same deviation.

`k` is bounded by `max_ratio`, since it is infinite at parabolic points, for instance on cylinders. At umbilics, flat points and
singular points of the parametrisation no direction is distinguished; there `k` is 1 and the tensor is the first
fundamental form. Near an umbilic `k` tends to 1, so the field is continuous there; at a flat
point it need not be.

\cgalModels{ParametricSurfaceMetricField_2}

\tparam Kernel a model of `Kernel` with `double` as number type
*/
template <class Kernel>
class Principal_curvature_metric_2
{
  double m_max_ratio;

public:
  /// \param max_ratio the bound on `k`
  /// \throws Parametric_surface_mesh_error if it is not finite or below 1
  explicit Principal_curvature_metric_2(double max_ratio = 4)
    : m_max_ratio(max_ratio)
  {
    if(!(max_ratio >= 1 && std::isfinite(max_ratio)))
      Parametric_surface_mesher::internal::throw_out_of_range("bound of the ratio of curvatures", "at least 1 and finite", max_ratio);
  }

  /// the bound on `k`.
  double max_ratio() const { return m_max_ratio; }

  /// the ratio `k` in `[1, max_ratio()]` that is used for a surface with these curvatures.
  double ratio(const Surface_curvature_3<Kernel>& curvature) const
  {
    const double large = curvature.max_absolute_curvature(), small = curvature.min_absolute_curvature();
    if(!(large > 0))
      return 1;
    return large < m_max_ratio * small ? large / small : m_max_ratio;
  }

  /// the pull-back of the ellipse in the tangent plane.
  Metric_tensor_2 tensor(const Surface_jet_3<Kernel>& jet) const
  {
    const Surface_curvature_3<Kernel> c(jet);
    const double k = ratio(c);
    if(k == 1)
      return Metric_tensor_2(c.e, c.f, c.g);

    Eigen::Matrix2d first, second;
    first << c.e, c.f, c.f, c.g;
    second << c.l, c.m, c.m, c.n;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> principal(second, first);
    const int most = std::fabs(principal.eigenvalues()[0]) > std::fabs(principal.eigenvalues()[1]) ? 0 : 1;
    // dual basis of the principal directions, which are orthonormal under the first form
    const Eigen::Vector2d across = first * principal.eigenvectors().col(most);
    const Eigen::Vector2d along = first * principal.eigenvectors().col(1 - most);
    const Eigen::Matrix2d metric = k * across * across.transpose() + (1 / k) * along * along.transpose();
    return Metric_tensor_2(metric(0, 0), 0.5 * (metric(0, 1) + metric(1, 0)), metric(1, 1));
  }

  /// the squared length of `q - p` under the mean of the two tensors.
  double squared_length(const Parametric_point_2<Kernel>& p, const Parametric_point_2<Kernel>& q) const
  {
    const double du = q.x() - p.x(), dv = q.y() - p.y();
    return 0.5 * (p.tensor().squared_length(du, dv) + q.tensor().squared_length(du, dv));
  }
};

} // namespace CGAL

#endif // CGAL_PRINCIPAL_CURVATURE_METRIC_2_H
