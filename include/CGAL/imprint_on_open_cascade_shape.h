// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IMPRINT_ON_OPEN_CASCADE_SHAPE_H
#define CGAL_IMPRINT_ON_OPEN_CASCADE_SHAPE_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/license/Parametric_surface_mesher.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Imprinting.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>
#include <CGAL/Parametric_surface_mesher/internal/support/check_value.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <BRepTools_History.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {

/// \ingroup PkgParametricSurfaceMesherOpenCascade
/// A shape with points and curves on its faces, and how far they were from these.
struct Imprinted_open_cascade_shape
{
  /// what has become of a point or a curve.
  struct Imprint
  {
    double distance;         ///< the largest distance between it and its projection
    double length;           ///< of the curve; 0 for a point
    double projected_length; ///< of its projection: less if a part of the curve is beyond the faces, or too far from them
    std::vector<TopoDS_Shape> shapes; ///< the vertex, or the edges, of the shape that it has become
  };

  TopoDS_Shape shape;
  /// what has become of solids, faces, edges and vertices; null if there were no points and curves
  opencascade::handle<BRepTools_History> history;
  std::vector<Imprint> points; ///< in the order of the given points
  std::vector<Imprint> curves; ///< in the order of `TopExp::MapShapes()` of the edges of the given curves
};

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

puts points and curves on the faces of a shape: sensors, welds, lines along which a load acts. Each point is projected onto the closest
face, and each curve onto the faces that are closest to it, across their edges. A curve that cuts a face in two divides it into two faces.
Other curves become edges inside the face, and points become vertices there. The model of the shape has these, too, and the mesh follows
them. Edges of the shape are divided where a curve crosses them. The operation is that of `BOPAlgo_Splitter` of Open CASCADE. What is
closer to each other than a thousandth of `reach`, and than 2e-5 of the diagonal of the shape's bounding box, is taken to meet. The given
shape is not changed. Faces, edges and vertices may have other numbers in the new shape.

\param shape a shape with faces
\param points the points
\param curves a shape with edges, as wires of a file; null for none
\param reach the largest distance between a point, or a curve, and its projection

\throws Parametric_surface_mesh_error if `reach` is not positive and finite, if a point is not finite or farther from the faces than
`reach`, if a curve has no projection within `reach`, or if Open CASCADE fails

\sa `CGAL::make_model_of_open_cascade_shape()`
\sa `CGAL::carry_over_open_cascade_names()`
*/
inline Imprinted_open_cascade_shape imprint_on_open_cascade_shape(const TopoDS_Shape& shape, const std::vector<gp_Pnt>& points,
                                                                  const TopoDS_Shape& curves, double reach)
{
  using namespace Parametric_surface_mesher::internal;
  check_positive_and_finite("reach of points and curves", reach);
  return guarded([&] {
    Imprinted_open_cascade_shape result;
    Imprinting imprinting(shape, reach);
    std::vector<Imprinting::Result> imprints; // of the points, then of the curves
    for(std::size_t i = 0; i < points.size(); ++i) {
      if(!std::isfinite(points[i].X() + points[i].Y() + points[i].Z()))
        throw Parametric_surface_mesh_error(numbered("point", i) + " is not finite");
      imprints.push_back(imprinting.add_point(points[i], numbered("point", i)));
    }
    TopTools_IndexedMapOfShape edges;
    if(!curves.IsNull())
      TopExp::MapShapes(curves, TopAbs_EDGE, edges);
    for(int i = 1; i <= edges.Extent(); ++i) {
      const bool is_point = BRep_Tool::Degenerated(TopoDS::Edge(edges(i)));
      imprints.push_back(is_point ? Imprinting::Result()
                                  : imprinting.add_curve(TopoDS::Edge(edges(i)), numbered("curve", std::size_t(i) - 1)));
    }
    imprinting();
    for(std::size_t i = 0; i < imprints.size(); ++i)
      (i < points.size() ? result.points : result.curves)
        .push_back({imprints[i].distance, imprints[i].length, imprints[i].projected_length, imprinting.images(imprints[i])});
    result.shape = imprinting.shape();
    result.history = imprinting.history();
    return result;
  });
}

} // namespace CGAL

#endif // CGAL_IMPRINT_ON_OPEN_CASCADE_SHAPE_H
