// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_MAKE_ORACLES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_MAKE_ORACLES_H

#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Parametric_surface_oracle_3.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

template <class Surface>
std::vector<Surface> copy_surfaces(const Parametric_surface_model_3<Surface>& model)
{
  std::vector<Surface> result;
  for(const auto& face : model.faces())
    result.push_back(face.surface);
  return result;
}

// The oracles of the faces of a model, which refer to `surfaces`.
template <class Surface, class MetricField>
std::vector<Parametric_surface_oracle_3<Surface, MetricField>>
make_oracles(const Parametric_surface_model_3<Surface>& model, const std::vector<Surface>& surfaces, const MetricField& metric)
{
  std::vector<Parametric_surface_oracle_3<Surface, MetricField>> result;
  for(std::size_t f = 0; f < surfaces.size(); ++f) {
    const auto& face = model.faces()[f];
    std::vector<typename Surface::Geom_traits::Point_3> singular_points;
    for(const auto& loop : face.loops)
      for(const auto& use : loop)
        if(model.edges()[use.edge].is_collapsed)
          singular_points.push_back(model.vertices()[model.edges()[use.edge].source]);
    result.emplace_back(surfaces[f], metric, std::move(singular_points));
  }
  return result;
}


} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_MAKE_ORACLES_H
