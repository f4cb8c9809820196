// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_TRIANGLE_VIEW_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_TRIANGLE_VIEW_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_oracle_3.h>

namespace CGAL {
namespace Parametric_surface_mesher {

/*!
\ingroup PkgParametricSurfaceMesherRef

A triangle of a mesh that is being made, as a criterion of the user sees it: see `CGAL::parameters::triangle_criterion()`.
Its corners have the numbers 0, 1, 2, counterclockwise in the parameter domain.

\tparam Face_handle the handle of a face of the triangulation
\tparam Oracle a `Parametric_surface_oracle_3`
*/
template <class Face_handle, class Oracle>
class Triangle_view
{
  Face_handle m_face;
  const Oracle& m_oracle;

public:
  typedef typename Oracle::Geom_traits::Point_2 Point_2; ///< a point of the parameter domain
  typedef typename Oracle::Geom_traits::Point_3 Point_3; ///< a point of the surface

  /// \cond SKIP_IN_MANUAL
  Triangle_view(Face_handle face, const Oracle& oracle) : m_face(face), m_oracle(oracle) {}
  /// \endcond

  /// the corner `i` in space.
  const Point_3& point(int i) const { return m_face->vertex(i)->point().surface_point(); }

  /// the corner `i` in the parameter domain.
  Point_2 domain_point(int i) const
  {
    return Parametric_surface_mesher::internal::place_in_domain(m_oracle.surface(), m_face->vertex(i)->point().domain_point());
  }

  /// the wanted edge length at corner `i`.
  double spacing(int i) const { return m_face->vertex(i)->spacing(); }

  /// tells whether the edge opposite to corner `i` is on the boundary of the patch, and so is never divided.
  bool is_on_boundary(int i) const { return m_face->is_constrained(i); }
};

} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_TRIANGLE_VIEW_H
