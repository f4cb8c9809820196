// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESH_ERROR_H
#define CGAL_PARAMETRIC_SURFACE_MESH_ERROR_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherRef

The exception for input that cannot be meshed. The message names the place (face, loop, segment, parameter values, file and
line) and what is wrong with it. It is thrown before any output is written, with and without `NDEBUG`.

Messages count faces, edges, vertices, loops, curves and segments from 1. Indices in the interface, that of `face()` too,
begin at 0.
*/
class Parametric_surface_mesh_error
  : public std::runtime_error
{
  std::optional<std::size_t> m_face;

public:
  explicit Parametric_surface_mesh_error(const std::string& what) : std::runtime_error(what) {}

  /// an error that concerns one face of a model.
  Parametric_surface_mesh_error(const std::string& what, std::size_t face) : std::runtime_error(what), m_face(face) {}

  /// the index of the face of the model that cannot be meshed, if the error concerns a single one.
  std::optional<std::size_t> face() const { return m_face; }
};

} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESH_ERROR_H
