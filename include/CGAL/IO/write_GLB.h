// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_WRITE_GLB_H
#define CGAL_IO_WRITE_GLB_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Element_sets.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Document_of_elements.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>

#include <Message_ProgressRange.hxx>
#include <RWGltf_CafWriter.hxx>
#include <RWMesh_CoordinateSystem.hxx>
#include <TColStd_IndexedDataMapOfStringString.hxx>

#include <string>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgParametricSurfaceMesherFiles

writes a mesh as a binary glTF file, for viewers, with a node for each part and a material for each colour. It is written by Open CASCADE. Coordinates are
converted to metres, with the y-axis upward, as the format demands. The nodes in the middles of sides are left out.

\param file_name the name of the file
\param mesh the mesh
\param unit the length of a unit of the coordinates in metres
\param title the name of the root

\return whether the file is written
\throws Parametric_surface_mesh_error if the arrays of the mesh do not fit together, or if Open CASCADE fails
*/
inline bool write_GLB(const std::string& file_name, const Element_mesh_3& mesh, double unit = 1e-3, const std::string& title = "mesh")
{
  using namespace Parametric_surface_mesher::internal;
  check_element_mesh(mesh);
  return guarded([&] {
    const Document_of_elements elements(mesh, title);
    RWGltf_CafWriter writer(file_name.c_str(), true);
    writer.ChangeCoordinateSystemConverter().SetInputLengthUnit(unit);
    writer.ChangeCoordinateSystemConverter().SetInputCoordinateSystem(RWMesh_CoordinateSystem_Zup);
    return bool(writer.Perform(elements.document(), TColStd_IndexedDataMapOfStringString(), Message_ProgressRange()));
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_WRITE_GLB_H
