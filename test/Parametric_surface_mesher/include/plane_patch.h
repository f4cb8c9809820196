// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the improvement asks of a patch, where that is a plane: for triangulations made by hand.
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_PLANE_PATCH_H
#define PARAMETRIC_SURFACE_MESHER_TEST_PLANE_PATCH_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/First_fundamental_form_metric_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Plane_kernel;
typedef CGAL::Parametric_surface_mesher::internal::Patch_triangulation_2<Plane_kernel> Plane_triangulation;

inline Plane_triangulation::Point at(const Plane_kernel::Point_2& p)
{
  return Plane_triangulation::Point(p, Plane_kernel::Point_3(p.x(), p.y(), 0), CGAL::Metric_tensor_2(1, 0, 1));
}

struct Plane_oracle
{
  typedef CGAL::First_fundamental_form_metric_2<Plane_kernel> Metric_field;

  Metric_field field;

  const Metric_field& metric() const { return field; }

  template <class Point>
  bool is_inverted(const Point&, const Point&, const Point&) const
  {
    return false;
  }
};

struct Plane_evaluator
{
  typedef Plane_kernel Kernel;
  typedef Plane_oracle Oracle;

  struct Position
  {
    Plane_triangulation::Point point;
  };

  Plane_oracle plane;

  const Oracle& oracle() const { return plane; }
  Position position(const Plane_kernel::Point_2& p, double) const { return {at(p)}; }
};

#endif // PARAMETRIC_SURFACE_MESHER_TEST_PLANE_PATCH_H
