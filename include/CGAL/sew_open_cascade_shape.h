// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEW_OPEN_CASCADE_SHAPE_H
#define CGAL_SEW_OPEN_CASCADE_SHAPE_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Shape_sewing.h>

#include <BRepTools_History.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include <cstddef>

namespace CGAL {

/// \ingroup PkgParametricSurfaceMesherOpenCascade
/// A shape that was sewn, and what became of it.
struct Sewn_open_cascade_shape
{
  TopoDS_Shape shape;
  std::size_t number_of_sewn_edges = 0;  ///< edges that are each the place of two or more edges of before
  std::size_t number_of_free_edges = 0;  ///< edges that have remained without a partner
  std::size_t number_of_lost_faces = 0;  ///< faces of before that are not in the result: as small as the tolerance
  opencascade::handle<BRepTools_History> history; ///< what has become of faces, edges and vertices
};

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

joins the faces of a shape, by `BRepBuilderAPI_Sewing` of Open CASCADE: edges without a second face that are no farther apart
than a tolerance become one, and the faces at them a shell. The faces of an IGES file have edges of their own, so that
a solid comes as loose faces, and its mesh with as many borders; sewn, it is closed. Solids and shells that are closed stay as
they are, and a solid that is open is sewn for itself: several solids remain several. The given shape is not changed.
Numbers of faces and edges may change.

\param shape a shape with faces
\param tolerance the largest distance of edges that are joined

\throws Parametric_surface_mesh_error if the tolerance is not positive, or if Open CASCADE fails
*/
inline Sewn_open_cascade_shape sew_open_cascade_shape(const TopoDS_Shape& shape, double tolerance)
{
  if(!(tolerance > 0))
    throw Parametric_surface_mesh_error("the tolerance of sewing must be greater than 0");
  const auto number_of_faces = [](const TopoDS_Shape& s) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(s, TopAbs_FACE, faces);
    return std::size_t(faces.Extent());
  };
  return Parametric_surface_mesher::internal::guarded([&] {
    const Parametric_surface_mesher::internal::Shape_sewing sewing(shape, tolerance);
    Sewn_open_cascade_shape result;
    result.shape = sewing.shape();
    result.history = sewing.history();
    result.number_of_sewn_edges = sewing.number_of_sewn_edges();
    result.number_of_free_edges = sewing.number_of_free_edges();
    const std::size_t before = number_of_faces(shape), after = number_of_faces(result.shape);
    result.number_of_lost_faces = before > after ? before - after : 0;
    return result;
  });
}

} // namespace CGAL

#endif // CGAL_SEW_OPEN_CASCADE_SHAPE_H
