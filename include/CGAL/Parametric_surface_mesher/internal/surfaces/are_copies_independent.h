// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_ARE_COPIES_INDEPENDENT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_ARE_COPIES_INDEPENDENT_H

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

template <class Surface, class = void>
struct Tells_whether_copies_are_independent : std::false_type
{};

template <class Surface>
struct Tells_whether_copies_are_independent<
  Surface, std::void_t<decltype(bool(std::declval<const Surface&>().has_independent_copies()))>> : std::true_type
{};

// Whether a surface and its copies may be evaluated by several threads at the same time, one object by each: see
// `ParametricSurface_3`.
template <class Surface>
bool are_copies_independent(const Surface& surface)
{
  if constexpr(Tells_whether_copies_are_independent<Surface>::value)
    return surface.has_independent_copies();
  return true;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_ARE_COPIES_INDEPENDENT_H
