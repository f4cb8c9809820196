// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_NAME_OPEN_CASCADE_BODIES_H
#define CGAL_NAME_OPEN_CASCADE_BODIES_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Open_cascade_names_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Part_builder.h>

#include <TopoDS_Shape.hxx>

#include <string>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

returns the names of a shape of which nothing but the geometry is known: a part for it, and parts for its bodies (solids, shells outside
of solids, faces outside of shells), if there are several, with their numbers for names. The lists of names and colours have their lengths, and are to be filled.

\param shape a shape
\param name what it is called

\throws Parametric_surface_mesh_error if Open CASCADE fails
*/
inline Open_cascade_names_3 name_open_cascade_bodies(const TopoDS_Shape& shape, const std::string& name)
{
  using namespace Parametric_surface_mesher::internal;
  return guarded([&] { return names_of_bodies(shape, name); });
}

} // namespace CGAL

#endif // CGAL_NAME_OPEN_CASCADE_BODIES_H
