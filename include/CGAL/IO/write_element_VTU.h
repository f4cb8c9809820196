// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_WRITE_ELEMENT_VTU_H
#define CGAL_IO_WRITE_ELEMENT_VTU_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Vtu_writer.h>

#include <ostream>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgParametricSurfaceMesherFiles

writes a mesh as an unstructured grid of VTK, for ParaView: triangles, lines and points in binary data at the end of the file, compressed if
`CGAL_LINKED_WITH_BOOST_IOSTREAMS` is defined (link with the target `CGAL::Boost_iostreams_support`). The stream must have been opened
with `std::ios::binary`.

The cells have `face_id`, `edge_id`, `vertex_id` (0 if they are of another kind), `part_id`, `part_id_in_front` (of a part that the triangle
faces to), `color` and what is in
`Element_mesh_3::triangle_data`; the points have what is in `Element_mesh_3::node_data` and, if parameters are known, `place_dimension`, `place_id` and
`place_parameters`. Names are field data: text with a number and a name in each line.

\return whether the stream is good
\throws Parametric_surface_mesh_error if the arrays of the mesh do not fit together
*/
inline bool write_VTU(std::ostream& out, const Element_mesh_3& mesh)
{
  Parametric_surface_mesher::internal::check_element_mesh(mesh);
  Parametric_surface_mesher::internal::Vtu_writer(mesh).write(out);
  return out.good();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_WRITE_ELEMENT_VTU_H
