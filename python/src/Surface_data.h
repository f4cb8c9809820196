// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What surfaces and curves of Python are inside.
#ifndef PYTHON_SURFACE_DATA_H
#define PYTHON_SURFACE_DATA_H

#include "Surface_mesher.h"

#include <CGAL/Any_parametric_surface_3.h>
#include <CGAL/Domain_curve_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <optional>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Any_parametric_surface_3<Kernel> Any_surface;
typedef CGAL::Domain_curve_2<Kernel> Domain_curve;

struct Surface::Data
{
  Any_surface surface;
  std::optional<Rectangle> domain;
};

struct Curve::Data
{
  Domain_curve curve;
};

inline Point_3 to_point(const Triple& p) { return Point_3(p[0], p[1], p[2]); }

template <class Vector>
Triple to_triple(const Vector& v)
{
  return {v.x(), v.y(), v.z()};
}

#endif // PYTHON_SURFACE_DATA_H
