// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_WRITE_ELEMENT_STL_H
#define CGAL_IO_WRITE_ELEMENT_STL_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Stl_writer.h>

#include <CGAL/IO/io.h>

#include <boost/io/ios_state.hpp>

#include <ostream>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgParametricSurfaceMesherFiles

writes the triangles of a mesh as an STL file. As text it has a solid for each part, with the name of the part; Gmsh and MeshLab read all of
them. The binary format, which is taken after `IO::set_binary_mode()`, knows one solid only, and coordinates in single precision; the two bytes
after each triangle are the number of the part there. The nodes in the middles of sides are left out.

\return whether the stream is good
\throws Parametric_surface_mesh_error if the arrays of the mesh do not fit together
*/
inline bool write_STL(std::ostream& out, const Element_mesh_3& mesh)
{
  Parametric_surface_mesher::internal::check_element_mesh(mesh);
  const boost::io::ios_precision_saver precision(out);
  out.precision(17);
  const Parametric_surface_mesher::internal::Stl_writer writer(out, mesh);
  if(is_binary(out))
    writer.write_binary();
  else
    writer.write_text();
  return out.good();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_WRITE_ELEMENT_STL_H
