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
#include <BRepTools_History.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Shape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Shape.hxx>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

returns a copy of a shape that `ShapeFix_Shape` of Open CASCADE has repaired: it orders and closes wires, adds seams and
degenerated edges, rebuilds curves in domains, and joins tiny edges to others. Numbers of faces and edges may change.

\param shape a shape
\param history takes what has become of solids, faces, edges and vertices

\throws Parametric_surface_mesh_error if Open CASCADE fails
*/
inline TopoDS_Shape repair_open_cascade_shape(const TopoDS_Shape& shape, opencascade::handle<BRepTools_History>& history)
{
  return Parametric_surface_mesher::internal::guarded([&] {
    BRepBuilderAPI_Copy copy(shape);
    ShapeFix_Shape fix(copy.Shape());
    fix.Perform();
    TopTools_ListOfShape shapes;
    shapes.Append(shape);
    history = new BRepTools_History(shapes, copy);
    history->Merge(fix.Context()->History());
    return fix.Shape();
  });
}

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

repairs a shape as above, without its history.
*/
inline TopoDS_Shape repair_open_cascade_shape(const TopoDS_Shape& shape)
{
  opencascade::handle<BRepTools_History> history;
  return repair_open_cascade_shape(shape, history);
}

} // namespace CGAL

#endif // CGAL_REPAIR_OPEN_CASCADE_SHAPE_H
