// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_WRITE_MSH_H
#define CGAL_IO_WRITE_MSH_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Msh_writer.h>

#include <boost/io/ios_state.hpp>

#include <ostream>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgParametricSurfaceMesherFiles

writes a mesh as a file of Gmsh, version 4.1: the faces, edges and vertices of the model as entities, with what bounds them; triangles,
lines and points; nodes with the entity that they lie on, and their parameters there as far as they are known; and physical groups. The groups are `face_<number>`,
`edge_<number>`, `vertex_<number>`, the names of parts (groups of surfaces), and those of `Element_mesh_3::groups`.

\return whether the stream is good
\throws Parametric_surface_mesh_error if the arrays of the mesh do not fit together
*/
inline bool write_MSH(std::ostream& out, const Element_mesh_3& mesh)
{
  Parametric_surface_mesher::internal::check_element_mesh(mesh);
  const boost::io::ios_precision_saver precision(out);
  out.precision(17);
  Parametric_surface_mesher::internal::Msh_writer(out, mesh).write_version_4();
  return out.good();
}

/*!
\ingroup PkgParametricSurfaceMesherFiles

writes a mesh as a file of Gmsh, version 2.2, which more programs read. Each element has one group, that of its face, edge or vertex; the
other groups are in the list of names only.

\return whether the stream is good
\throws Parametric_surface_mesh_error if the arrays of the mesh do not fit together
*/
inline bool write_MSH_2(std::ostream& out, const Element_mesh_3& mesh)
{
  Parametric_surface_mesher::internal::check_element_mesh(mesh);
  const boost::io::ios_precision_saver precision(out);
  out.precision(17);
  Parametric_surface_mesher::internal::Msh_writer(out, mesh).write_version_2();
  return out.good();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_WRITE_MSH_H
