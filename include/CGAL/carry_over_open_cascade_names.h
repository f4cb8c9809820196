// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CARRY_OVER_OPEN_CASCADE_NAMES_H
#define CGAL_CARRY_OVER_OPEN_CASCADE_NAMES_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Open_cascade_names_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Names_through_history.h>

#include <BRepTools_History.hxx>
#include <TopoDS_Shape.hxx>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

returns the names of a shape that an operation of Open CASCADE has made of another one. What has become of solids, faces, edges and vertices
is told by the history of the operation, as `sew_open_cascade_shape()`, `repair_open_cascade_shape()` and the Boolean
operations of Open CASCADE have it. Where several are joined the name of the first one that has one stays.

\param names the names of the shape before
\param before the shape before
\param history the history of the operation
\param after the shape after it

\throws Parametric_surface_mesh_error if Open CASCADE fails
*/
inline Open_cascade_names_3 carry_over_open_cascade_names(const Open_cascade_names_3& names, const TopoDS_Shape& before,
                                                          const opencascade::handle<BRepTools_History>& history, const TopoDS_Shape& after)
{
  using namespace Parametric_surface_mesher::internal;
  return guarded([&] { return Names_through_history(names, before, history, after)(); });
}

} // namespace CGAL

#endif // CGAL_CARRY_OVER_OPEN_CASCADE_NAMES_H
