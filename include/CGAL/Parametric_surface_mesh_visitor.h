// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESH_VISITOR_H
#define CGAL_PARAMETRIC_SURFACE_MESH_VISITOR_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherRef

The default visitor of the meshing functions, which does nothing. Derive from it to show progress or to stop early.

\cgalModels{ParametricSurfaceMeshVisitor}
*/
struct Parametric_surface_mesh_visitor
{
  /// called when a phase begins: `"division"`, `"triangulation"`, `"refinement"`, `"smoothing"`, `"improvement"`,
  /// `"polishing"`, `"curing"`, `"intersections"`, `"output"`.
  void on_phase(const char* /* name */) {}

  /// called when a face begins, the `number`-th, from 1, of `number_of_faces`.
  void on_face(std::size_t /* number */, std::size_t /* number_of_faces */) {}

  /// called during refinement, once for some hundred new vertices, with the number of vertices so far and an upper bound
  /// of the number of triangles still waiting.
  void on_progress(std::size_t /* number_of_vertices */, std::size_t /* number_of_bad_faces */) {}

  /// asked in all phases, every few milliseconds; `false` stops meshing, with the valid mesh of that moment.
  bool go_further() { return true; }
};

} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESH_VISITOR_H
