// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_WITH_GOOD_FACES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_WITH_GOOD_FACES_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/model/Bad_faces.h>
#include <CGAL/Parametric_surface_mesher/validate.h>

#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Checks a model, and calls `function` with it and its bad faces. If these are left out, they have no loops.
template <class Model, class Function>
auto with_good_faces(const Model& model, bool leaves_out_bad_faces, const Function& function)
{
  Bad_faces bad_faces(leaves_out_bad_faces);
  if(!leaves_out_bad_faces) {
    validate(model);
    return function(model, bad_faces);
  }
  Model rest; // a copy, once a face is left out
  const auto leave_out = [&](const Parametric_surface_mesh_error& error) {
    if(bad_faces.is_empty())
      rest = model;
    rest.faces()[bad_faces.add(error)].loops.clear();
  };
  for(std::size_t f = 0; f < model.faces().size(); ++f)
    if(model.faces()[f].loops.empty())
      leave_out(Parametric_surface_mesh_error("has no loop", f));
  const auto checked = [&]() -> const Model& { return bad_faces.is_empty() ? model : rest; };
  Model_validation<typename Model::Surface_3>(model, true).check_elements();
  Model_validation<typename Model::Surface_3>(checked(), true).check_loops(leave_out);
  bad_faces.check_that_some_are_good(model.faces().size());
  Model_validation<typename Model::Surface_3>(checked(), true).check_uses(leave_out);
  bad_faces.check_that_some_are_good(model.faces().size());
  return function(checked(), bad_faces);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_WITH_GOOD_FACES_H
