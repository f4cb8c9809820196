// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_EVALUATED_POINT_2_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_EVALUATED_POINT_2_H

#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_point_2.h>
#include <CGAL/Surface_jet_3.h>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A point of the surface with its metric tensor.
template <class Kernel>
struct Evaluated_position
{
  Patch_point_2<Kernel> point;
  Surface_jet_3<Kernel> jet;
  bool is_tensor_replaced;
  bool is_degenerate; // whether no positive definite tensor was found, not even by chords
};

// A point of the mesh: also with the largest spacing that the curvature and the sizing field allow there.
template <class Kernel>
struct Evaluated_point
  : Evaluated_position<Kernel>
{
  double spacing_limit;
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_EVALUATED_POINT_2_H
