// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_WRITE_INP_H
#define CGAL_IO_WRITE_INP_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Inp_writer.h>

#include <ostream>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgParametricSurfaceMesherFiles

writes a mesh as an input file of Abaqus and CalculiX: shell elements S3 or S6. Each face and part, and each group of them, is an element set, a node set
and a surface (the outer sides of its elements) of the same name; each edge and vertex, and each group of them, is a node set. Names are in
capitals; characters that these programs do not know become underscores. Coordinates have as many digits as fit in the 20 characters that they read. `EALL` and `NALL` are all elements and all nodes.

\return whether the stream is good
\throws Parametric_surface_mesh_error if the arrays of the mesh do not fit together
*/
inline bool write_INP(std::ostream& out, const Element_mesh_3& mesh)
{
  Parametric_surface_mesher::internal::check_element_mesh(mesh);
  Parametric_surface_mesher::internal::Inp_writer(out, mesh).write();
  return out.good();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_WRITE_INP_H
