// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_WRITE_UNV_H
#define CGAL_IO_WRITE_UNV_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Unv_writer.h>

#include <ostream>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgParametricSurfaceMesherFiles

writes a mesh as a universal file of I-DEAS, for Salome and others: shell elements, whose property is the number of their face; groups of elements for
faces, parts and groups of them; groups of nodes for edges, vertices and groups of them.

\return whether the stream is good
\throws Parametric_surface_mesh_error if the arrays of the mesh do not fit together
*/
inline bool write_UNV(std::ostream& out, const Element_mesh_3& mesh)
{
  Parametric_surface_mesher::internal::check_element_mesh(mesh);
  Parametric_surface_mesher::internal::Unv_writer(out, mesh).write();
  return out.good();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_WRITE_UNV_H
