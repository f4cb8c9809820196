// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs that must not compile, one for each macro, with the sentence that tells why: see `check_compile_error.cmake`.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_function_surface_3.h>

#include <array>
#include <cmath>
#include <tuple>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;

template <class Function>
Kernel::Point_3 evaluate(Function function)
{
  return CGAL::make_parametric_function_surface(function).jet(0.1, 0.2).point;
}

#ifdef STANDARD_FUNCTION
const auto p = evaluate([](auto u, auto v) { return CGAL::parametric_surface_point(u, v, std::sin(u)); });
#elif defined(STANDARD_HYPOT)
const auto p = evaluate([](auto u, auto v) { return CGAL::parametric_surface_point(u, v, std::hypot(u, v)); });
#elif defined(DOUBLE_PARAMETER)
const auto p = evaluate([](auto u, double v) { return CGAL::parametric_surface_point(u, v, u * v); });
#elif defined(ARRAY_OF_DOUBLE)
const auto p = evaluate([](auto u, auto v) { return std::array<double, 3>{u, v, u * v}; });
#elif defined(NOT_GENERIC)
const auto p = evaluate([](double u, double v) { return CGAL::parametric_surface_point(u, v, u * v); });
#elif defined(TWO_COORDINATES)
const auto p = evaluate([](auto u, auto v) { return std::make_tuple(u, v); });
#elif defined(EXACT_KERNEL)
#  include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#  include <CGAL/Parametric_primitive_surfaces_3.h>
const auto p = CGAL::Parametric_plane_3<CGAL::Exact_predicates_exact_constructions_kernel>().jet(0.1, 0.2);
#elif defined(PLAIN_NUMBERS)
const auto p = evaluate([](auto, auto) { return CGAL::parametric_surface_point(0, 1, 2); });
#else

#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_parametric_surface_mesh.h>

typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

struct Incomplete
{
  typedef Kernel Geom_traits;
};

template <class Surface, class Criteria, class Parameters>
void mesh(const Surface& surface, const Criteria& criteria, const Parameters& parameters)
{
  Mesh mesh;
  CGAL::make_parametric_surface_mesh(surface, CGAL::Parametric_domain_2<Kernel>::rectangle(0, 1, 0, 1), criteria, mesh,
                                     parameters);
}

void mesh()
{
  const CGAL::Parametric_surface_mesh_criteria criteria;
  const CGAL::Parametric_plane_3<Kernel> plane;
  const auto none = CGAL::parameters::default_values();
#  ifdef NO_SURFACE
  mesh(Incomplete(), criteria, none);
#  elif defined(NO_CRITERIA)
  mesh(plane, 0.1, none);
#  elif defined(NO_VISITOR)
  mesh(plane, criteria, CGAL::parameters::visitor(Incomplete()));
#  endif
}
#endif
