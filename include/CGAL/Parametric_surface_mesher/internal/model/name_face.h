// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_NAME_FACE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_NAME_FACE_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Calls `function`; its errors get the index of the face, unless they have one already.
template <class Function>
auto about_face(std::size_t face, Function function)
{
  try {
    return function();
  }
  catch(const Parametric_surface_mesh_error& error) {
    throw Parametric_surface_mesh_error(error.what(), error.face().value_or(face));
  }
}

// Calls `function`; its errors get the index of the face, and their messages name the face if the model has several.
template <class Model, class Function>
auto with_name_of_face(const Model& model, std::size_t face, Function function)
{
  try {
    return function();
  }
  catch(const Parametric_surface_mesh_error& error) {
    const std::string name = model.faces().size() == 1 ? "" : numbered("face", face) + ": ";
    throw Parametric_surface_mesh_error(name + error.what(), face);
  }
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_NAME_FACE_H
