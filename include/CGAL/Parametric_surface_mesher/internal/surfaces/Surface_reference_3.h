// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_SURFACE_REFERENCE_3_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_SURFACE_REFERENCE_3_H

#include <CGAL/Surface_jet_3.h>

#include <utility>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Refers to a surface that must not be copied into the model that is made of it: the surfaces of users may be large, or may not be
// copyable at all. `std::reference_wrapper` has no `Geom_traits`, `point()` and `jet()`.
template <class Surface>
class Surface_reference_3
{
public:
  typedef typename Surface::Geom_traits Geom_traits;

private:
  const Surface* m_surface;

public:
  explicit Surface_reference_3(const Surface& surface) : m_surface(&surface) {}

  typename Geom_traits::Point_3 point(double u, double v) const { return m_surface->point(u, v); }
  Surface_jet_3<Geom_traits> jet(double u, double v) const { return m_surface->jet(u, v); }

  template <class S = Surface>
  auto feature_lines() const -> decltype(std::declval<const S&>().feature_lines())
  {
    return m_surface->feature_lines();
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_SURFACE_REFERENCE_3_H
