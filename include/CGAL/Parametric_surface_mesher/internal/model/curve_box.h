// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_CURVE_BOX_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_CURVE_BOX_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Parametric_surface_mesher/internal/model/name_face.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Parametric_surface_mesher/divide_curve.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The bounding box of some points on the image of a curve.
template <class Surface>
Bbox_3 curve_box(const Surface& surface, const Domain_curve_2<typename Surface::Geom_traits>& curve)
{
  Bbox_3 box;
  const Curve_on_surface_3<Surface> curve_on_surface(surface, curve);
  for(int i = 0; i <= 8; ++i)
    box += curve_on_surface.point(curve.begin() + (curve.end() - curve.begin()) * i / 8).bbox();
  return box;
}

inline double diagonal(const Bbox_3& box)
{
  return std::sqrt(square(box.x_span()) + square(box.y_span()) + square(box.z_span()));
}

// The box around the images of the loops of a face.
template <class Surface>
Bbox_3 boundary_box(const Parametric_surface_model_3<Surface>& model, std::size_t face)
{
  Bbox_3 box;
  with_name_of_face(model, face, [&] {
    for(const auto& loop : model.faces()[face].loops)
      for(const auto& use : loop)
        box += curve_box(model.faces()[face].surface, use.curve);
  });
  return box;
}

// The diagonal of the bounding box of the images of all loops.
template <class Surface>
double model_diagonal(const Parametric_surface_model_3<Surface>& model)
{
  Bbox_3 box;
  for(std::size_t f = 0; f < model.faces().size(); ++f)
    box += boundary_box(model, f);
  return diagonal(box);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_CURVE_BOX_H
