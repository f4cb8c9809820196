// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_UNIT_EVALUATOR_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_UNIT_EVALUATOR_H

#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Evaluated_point_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_point_2.h>
#include <CGAL/Surface_jet_3.h>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Gives all boundary vertices the unit tensor, without evaluating the surface: for a patch whose shapes do not matter, since
// the run was stopped before it was meshed.
template <class Surface>
class Unit_evaluator
{
  const Surface& m_surface;

public:
  typedef typename Surface::Geom_traits Kernel;

  explicit Unit_evaluator(const Surface& surface) : m_surface(surface) {}

  Evaluated_point<Kernel> operator()(const typename Kernel::Point_2& uv, const typename Kernel::Point_3& surface_point,
                                     double spacing) const
  {
    Patch_point_2<Kernel> point(uv, surface_point, Metric_tensor_2(1, 0, 1));
    set_line_point(m_surface, point);
    return {{point, Surface_jet_3<Kernel>(), false, false}, spacing};
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_UNIT_EVALUATOR_H
