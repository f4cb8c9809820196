// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MESH_FACE_OF_MODEL_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MESH_FACE_OF_MODEL_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/divide_model.h>
#include <CGAL/Parametric_surface_mesher/internal/mesh_divided_patch.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Meshes one face of a divided model into `mesh`, facing as the model says. Errors name the face.
template <class Face, class Oracle, class Criteria, class Visitor, class Mesh>
void mesh_face_of_model(const Face& face, std::size_t number, const Oracle& oracle,
                        const Model_division<Oracle>& division, const Criteria& criteria, Visitor& visitor, Mesh& mesh,
                        Parametric_surface_mesh_report& report)
{
  const std::size_t first = mesh.faces.size();
  try {
    mesh_divided_patch(oracle, criteria, division.boundary_loops(face, mesh), visitor, mesh, report);
  }
  catch(const Parametric_surface_mesh_error& error) {
    throw Parametric_surface_mesh_error("face " + std::to_string(number) + ": " + error.what());
  }
  if(face.is_reversed)
    mesh.reverse_faces(first);
  mesh.patches.resize(mesh.faces.size(), number);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MESH_FACE_OF_MODEL_H
