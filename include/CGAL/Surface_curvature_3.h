// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_CURVATURE_3_H
#define CGAL_SURFACE_CURVATURE_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Surface_jet_3.h>

#include <cmath>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

The two fundamental forms of a surface at a point, from its jet, and the principal curvatures.

Where the parametrisation is singular (`S_u x S_v = 0`) there is no normal and `is_defined()` is `false`.

\tparam Kernel a model of `Kernel` with `double` as number type
*/
template <class Kernel>
class Surface_curvature_3
{
public:
  typedef typename Kernel::Vector_3 Vector_3;

  double e, f, g;            ///< first fundamental form
  double l = 0, m = 0, n = 0; ///< second fundamental form

  explicit Surface_curvature_3(const Surface_jet_3<Kernel>& jet)
    : e(jet.du * jet.du), f(jet.du * jet.dv), g(jet.dv * jet.dv)
  {
    const double determinant = e * g - f * f;
    // below this the determinant is rounding noise
    if(!(determinant > 1e-14 * e * g))
      return;
    const Vector_3 normal = cross_product(jet.du, jet.dv) / std::sqrt(determinant);
    l = jet.duu * normal;
    m = jet.duv * normal;
    n = jet.dvv * normal;
    m_is_defined = true;
    m_mean = 0.5 * (e * n - 2 * f * m + g * l) / determinant;
    m_gauss = (l * n - m * m) / determinant;
  }

  /// tells whether the parametrisation is regular here.
  bool is_defined() const { return m_is_defined; }

  /// the mean curvature; 0 if not defined.
  double mean_curvature() const { return m_mean; }

  /// the Gauss curvature; 0 if not defined.
  double gauss_curvature() const { return m_gauss; }

  /// the larger absolute value of the two principal curvatures; 0 if not defined.
  double max_absolute_curvature() const { return std::fabs(m_mean) + half_difference(); }

  /// the smaller absolute value of the two principal curvatures; 0 if not defined.
  double min_absolute_curvature() const { return std::fabs(std::fabs(m_mean) - half_difference()); }

private:
  double m_mean = 0, m_gauss = 0;
  bool m_is_defined = false;

  // half the difference of the principal curvatures
  double half_difference() const
  {
    const double square = m_mean * m_mean - m_gauss;
    return square > 0 ? std::sqrt(square) : 0;
  }
};

} // namespace CGAL

#endif // CGAL_SURFACE_CURVATURE_3_H
