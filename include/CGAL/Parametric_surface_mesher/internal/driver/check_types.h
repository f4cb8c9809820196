// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_CHECK_TYPES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_CHECK_TYPES_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_parameters.h>
#include <CGAL/Parametric_surface_mesh_visitor.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Types of a user that are no model of their concept get one sentence, in place of the errors of what would use them.

template <class Surface, class = void>
struct Is_surface : std::false_type {};

template <class Surface>
struct Is_surface<Surface, std::void_t<typename Surface::Geom_traits, decltype(std::declval<const Surface&>().point(0., 0.)),
                                       decltype(std::declval<const Surface&>().jet(0., 0.))>>
  : std::true_type {};

template <class Visitor, class = void>
struct Is_visitor : std::false_type {};

template <class Visitor>
struct Is_visitor<Visitor, std::void_t<decltype(std::declval<Visitor&>().on_phase("")),
                                       decltype(std::declval<Visitor&>().on_progress(std::size_t(), std::size_t())),
                                       decltype(bool(std::declval<Visitor&>().go_further()))>>
  : std::true_type {};

template <class Visitor>
struct Is_visitor<std::reference_wrapper<Visitor>> : Is_visitor<Visitor> {};

// the type of the visitor that named parameters have, or of that which does nothing
template <class NamedParameters>
using Visitor_of_parameters = std::decay_t<decltype(parameters::choose_parameter(
  parameters::get_parameter(std::declval<const NamedParameters&>(), internal_np::visitor), Parametric_surface_mesh_visitor()))>;

template <class Kernel>
constexpr bool has_double()
{
  return std::is_same<typename Kernel::FT, double>::value;
}

// The surface, and the kernel of the domain or of the surface.
template <class Surface, class Kernel>
constexpr bool check_surface()
{
  constexpr bool is_surface = Is_surface<Surface>::value;
  static_assert(is_surface, "The surface must be a model of ParametricSurface_3: it has a type Geom_traits and the functions "
                            "point(u, v) and jet(u, v), both const.");
  if constexpr(is_surface) {
    constexpr bool has_one_kernel = std::is_same<typename Surface::Geom_traits, Kernel>::value;
    static_assert(has_one_kernel, "The surface and its domain must have the same kernel.");
    static_assert(has_double<typename Surface::Geom_traits>(),
                  "The kernel of a parametric surface must have 'double' as its number type FT.");
    return has_one_kernel && has_double<Kernel>();
  }
  return false;
}

template <class Criteria, class NamedParameters>
constexpr bool check_options()
{
  constexpr bool is_criteria = std::is_same<Parametric_surface_mesh_criteria, Criteria>::value;
  static_assert(is_criteria, "The criteria must be a Parametric_surface_mesh_criteria; a criterion of your own is passed by the "
                             "named parameter triangle_criterion.");
  constexpr bool is_visitor = Is_visitor<Visitor_of_parameters<NamedParameters>>::value;
  static_assert(is_visitor, "The visitor must be a model of ParametricSurfaceMeshVisitor: it has the functions on_phase(name), "
                            "on_progress(number_of_vertices, number_of_bad_faces) and go_further().");
  return is_criteria && is_visitor;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_CHECK_TYPES_H
