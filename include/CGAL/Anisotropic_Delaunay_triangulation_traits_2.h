// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_DELAUNAY_TRIANGULATION_TRAITS_2_H
#define CGAL_ANISOTROPIC_DELAUNAY_TRIANGULATION_TRAITS_2_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_point_2.h>
#include <CGAL/Parametric_surface_mesher/internal/predicates/In_ellipse_predicate.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/assertions.h>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherTraits

Traits class for the Delaunay triangulation of points in a parameter domain whose empty-circle
property is that of the *surface*: the in-circle predicate is replaced by the exact in-ellipse predicate.

The points carry their metric tensor. For four points the predicate uses the sum of the four tensors, added
so that the result is the same to the last bit in whatever order the points are given, and returns the
exact sign of the in-circle determinant with `|x|^2` replaced by `x^T M x`. All other predicates are
those of `Kernel` on the domain points.

For any positive definite tensors a point that lies inside the ellipse of the triangle across an edge forms a strictly
convex quadrilateral with it, so every flip keeps the triangulation valid. Where the
tensors vary, the empty-ellipse property is a local one, and
- the triangulation may depend on the order of insertion;
- do not call `remove()`, which assumes one global metric.

\cgalModels{DelaunayTriangulationTraits_2,ConstrainedDelaunayTriangulationTraits_2}

\tparam Kernel a model of `Kernel` with exact predicates on `double` coordinates
\tparam Point `Parametric_point_2<Kernel>`, or a class that derives from it

\sa `CGAL::Delaunay_triangulation_2`
\sa `CGAL::Constrained_Delaunay_triangulation_2`
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel, class Point = Parametric_point_2<Kernel>>
class Anisotropic_Delaunay_triangulation_traits_2
  : public Kernel
{
public:
  /// the point type, which carries domain point, surface point and metric tensor.
  typedef Point Point_2;

  // The triangulations pass every point through this functor before a predicate sees it. That of `Kernel`
  // would return a bare domain point: the tensor would be lost.
  class Construct_point_2
    : public Kernel::Construct_point_2
  {
    typedef typename Kernel::Construct_point_2 Base;

  public:
    using Base::operator();

    const Point_2& operator()(const Point_2& p) const { return p; }
  };

  // That of `Kernel`, which takes its static filter for its own points only: for the derived ones it would go through
  // interval arithmetic, at several times the cost.
  class Orientation_2
    : public Kernel::Orientation_2
  {
    typedef typename Kernel::Orientation_2 Base;
    typedef typename Kernel::Point_2 Domain_point_2;

  public:
    typedef CGAL::Orientation result_type;

    CGAL::Orientation operator()(const Domain_point_2& p, const Domain_point_2& q, const Domain_point_2& r) const
    {
      return Base::operator()(p, q, r);
    }
  };

  /// the exact in-ellipse predicate.
  class Side_of_oriented_circle_2
  {
  public:
    typedef Oriented_side result_type;

    /*!
    the side of `t` with respect to the ellipse through `p`, `q`, `r` under the common tensor of the four points:
    `ON_POSITIVE_SIDE` iff `t` is inside and the triangle is counterclockwise, or outside and clockwise.
    \pre the tensors of the points are positive definite
    */
    Oriented_side operator()(const Point_2& p, const Point_2& q, const Point_2& r, const Point_2& t) const
    {
      CGAL_precondition(p.tensor().is_positive_definite() && q.tensor().is_positive_definite()
                        && r.tensor().is_positive_definite() && t.tensor().is_positive_definite());
      return Parametric_surface_mesher::internal::sign_of_in_ellipse(p, q, r, t);
    }
  };

  Construct_point_2 construct_point_2_object() const { return Construct_point_2(); }

  Orientation_2 orientation_2_object() const { return Orientation_2(); }

  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return Side_of_oriented_circle_2(); }

  Anisotropic_Delaunay_triangulation_traits_2(const Kernel& kernel = Kernel()) : Kernel(kernel) {}
};

} // namespace CGAL

#endif // CGAL_ANISOTROPIC_DELAUNAY_TRIANGULATION_TRAITS_2_H
