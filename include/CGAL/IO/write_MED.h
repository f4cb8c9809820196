// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_WRITE_MED_H
#define CGAL_IO_WRITE_MED_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Med_writer.h>

#include <string>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgParametricSurfaceMesherFiles

writes a mesh as a file of Salome and Code_Aster: triangles, lines and points, with a family for each face, edge and vertex, and groups as of
`IO::write_MSH()`; vertices have groups of nodes, too. This header needs the MED library (`libmedc-dev` of Debian; link with the target
`Parametric_surface_mesher::Med_support`).

\param file_name the name of the file
\param mesh the mesh

\throws Parametric_surface_mesh_error if the arrays of the mesh do not fit together, or if the file cannot be written
*/
inline void write_MED(const std::string& file_name, const Element_mesh_3& mesh)
{
  Parametric_surface_mesher::internal::check_element_mesh(mesh);
  Parametric_surface_mesher::internal::Med_writer(file_name, mesh).write();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_WRITE_MED_H
