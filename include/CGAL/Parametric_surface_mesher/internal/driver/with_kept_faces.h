// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_WITH_KEPT_FACES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_WITH_KEPT_FACES_H

#include <CGAL/First_fundamental_form_metric_2.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/Meshed_faces.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/set_default_sizes.h>
#include <CGAL/Parametric_surface_mesher/internal/model/curve_box.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Checked_metric_field_2.h>

#include <functional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Calls `function` with the faces that are kept from an earlier run: none.
template <class Model, class Criteria, class MetricField, class NotFound, class Function>
void with_kept_faces(const Model&, const Criteria&, const MetricField&, const NotFound&, const Function& function)
{
  function(nullptr);
}

// Calls `function` with those faces of an earlier run that may be meshed in the same way; it replaces them by those of this run. No face is
// kept if a metric field, a criterion or a placement of the user decides the triangles, since functions cannot be compared.
template <class Model, class Criteria, class MetricField, class KeptFaces, class Function>
void with_kept_faces(const Model& model, const Criteria& criteria, const MetricField&, std::reference_wrapper<KeptFaces> kept_faces,
                     const Function& function)
{
  typedef typename Model::Geom_traits Kernel;
  const bool is_comparable = std::is_same<Criteria, Parametric_surface_mesh_criteria>::value && !criteria.own_placement()
                             && std::is_same<MetricField, First_fundamental_form_metric_2<Kernel>>::value;
  KeptFaces faces; // if the run fails, none are kept
  std::swap(faces, kept_faces.get());
  if(!is_comparable)
    faces.clear();
  Criteria with_sizes = criteria;
  set_default_sizes(with_sizes, model_diagonal(model));
  faces.begin(model, with_sizes);
  function(&faces.meshed_faces());
  faces.end(model, with_sizes);
  if(!is_comparable)
    faces.clear();
  std::swap(faces, kept_faces.get());
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_WITH_KEPT_FACES_H
