// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_LEAVE_OUT_BAD_FACES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_LEAVE_OUT_BAD_FACES_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesh_parameters.h>
#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Parametric_surface_mesher/validate.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// An error without the name of the face that it begins with.
inline std::string without_name_of_face(const Parametric_surface_mesh_error& error)
{
  const std::string what = error.what(), name = numbered("face", *error.face());
  const bool has_name = what.compare(0, name.size(), name) == 0 && what.size() > name.size() + 2;
  return !has_name ? what : what.substr(name.size() + (what[name.size()] == ' ' ? 1 : 2));
}

// Meshes the faces that can be meshed. One that is the cause of an error loses its loops, and meshing begins anew: the
// division of edges must not depend on what is left out.
template <class Model, class Mesh>
Parametric_surface_mesh_report mesh_without_bad_faces(const Model& model, Mesh mesh)
{
  Model rest; // a copy, once a face is left out
  std::vector<Parametric_surface_mesh_report::Left_out_face> left_out;
  const auto leave_out = [&](std::size_t face, const std::string& reason) {
    if(left_out.empty())
      rest = model;
    rest.faces()[face].loops.clear();
    left_out.push_back({face, reason});
  };
  for(std::size_t f = 0; f < model.faces().size(); ++f)
    if(model.faces()[f].loops.empty())
      leave_out(f, "has no loop");
  for(;;)
    try {
      if(left_out.size() == model.faces().size())
        throw Parametric_surface_mesh_error(left_out.empty() ? "the model has no faces"
                                                             : "no face can be meshed; " + numbered("face", left_out.front().face)
                                                                 + ": " + left_out.front().reason);
      const Model& meshed = left_out.empty() ? model : rest;
      Model_validation<typename Model::Surface_3> check(meshed, true);
      check();
      Parametric_surface_mesh_report report = mesh(meshed);
      std::sort(left_out.begin(), left_out.end(), [](const auto& a, const auto& b) { return a.face < b.face; });
      report.left_out = std::move(left_out);
      return report;
    }
    catch(const Parametric_surface_mesh_error& error) {
      if(!error.face() || (!left_out.empty() && rest.faces()[*error.face()].loops.empty()))
        throw;
      leave_out(*error.face(), without_name_of_face(error));
    }
}

// Checks a model and meshes it, by a function of a model.
template <class Model, class NamedParameters, class Mesh>
Parametric_surface_mesh_report mesh_valid_model(const Model& model, const NamedParameters& np, Mesh mesh)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  if(choose_parameter(get_parameter(np, Leaves_out_bad_faces_t()), false))
    return mesh_without_bad_faces(model, mesh);
  validate(model);
  return mesh(model);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_LEAVE_OUT_BAD_FACES_H
