// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_WRITE_BDF_H
#define CGAL_IO_WRITE_BDF_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Bdf_writer.h>

#include <ostream>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgParametricSurfaceMesherFiles

writes a mesh as bulk data of Nastran: `GRID*`, and `CTRIA3` or `CTRIA6`. The property of an element is the number of its face (a number
of its own for each further part that has the face); comments tell the names of faces and parts. Sets of nodes and elements are in the case control
section, which is for the user to write, and so are properties and materials.

\return whether the stream is good
\throws Parametric_surface_mesh_error if the arrays of the mesh do not fit together
*/
inline bool write_BDF(std::ostream& out, const Element_mesh_3& mesh)
{
  Parametric_surface_mesher::internal::check_element_mesh(mesh);
  Parametric_surface_mesher::internal::write_bulk_data(out, mesh);
  return out.good();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_WRITE_BDF_H
