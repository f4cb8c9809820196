// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REPAIR_OPEN_CASCADE_SHAPE_H
#define CGAL_REPAIR_OPEN_CASCADE_SHAPE_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>

#include <BRepBuilderAPI_Copy.hxx>
#include <ShapeFix_Shape.hxx>
#include <TopoDS_Shape.hxx>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

returns a copy of a shape that `ShapeFix_Shape` of Open CASCADE has repaired: it orders and closes wires, adds seams and
degenerated edges, rebuilds curves in domains, and joins tiny edges to others. Numbers of faces and edges may change.

\throws Parametric_surface_mesh_error if Open CASCADE fails
*/
inline TopoDS_Shape repair_open_cascade_shape(const TopoDS_Shape& shape)
{
  return Parametric_surface_mesher::internal::guarded([&] {
    ShapeFix_Shape fix(BRepBuilderAPI_Copy(shape).Shape());
    fix.Perform();
    return fix.Shape();
  });
}

} // namespace CGAL

#endif // CGAL_REPAIR_OPEN_CASCADE_SHAPE_H
