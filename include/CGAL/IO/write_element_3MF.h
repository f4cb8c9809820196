// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_WRITE_ELEMENT_3MF_H
#define CGAL_IO_WRITE_ELEMENT_3MF_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Element_sets.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Three_mf_writer.h>

#include <string>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgParametricSurfaceMesherFiles

writes a mesh as a 3MF file, for 3D printing: an object for each part with its name, and the colours of faces as materials. It is
written by the library lib3mf, version 1; link with the target `Parametric_surface_mesher::3mf_support`. The triangles of a face between
two parts belong to both of them. An object that is not closed is a surface for the format. Coordinates are in single precision, and the
nodes in the middles of sides are left out.

\param file_name the name of the file
\param mesh the mesh
\param unit the length of a unit of the coordinates in millimetres

\throws Parametric_surface_mesh_error if the arrays of the mesh do not fit together, or if the file cannot be written
*/
inline void write_3MF(const std::string& file_name, const Element_mesh_3& mesh, double unit = 1)
{
  Parametric_surface_mesher::internal::check_element_mesh(mesh);
  Parametric_surface_mesher::internal::Three_mf_writer(file_name, mesh, unit).write();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_WRITE_ELEMENT_3MF_H
