// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MAKE_MODEL_OF_OPEN_CASCADE_SHAPE_H
#define CGAL_MAKE_MODEL_OF_OPEN_CASCADE_SHAPE_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Crease_division.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Shape_model_builder.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/in_numbers_of_shape.h>

#include <TopoDS_Shape.hxx>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

makes a model of the faces of a shape: its vertices, its edges with their curves in space, and its faces with their curves
in the domain. The shape is not changed.

- Seams, degenerated edges, reversed faces, and locations are respected. The faces of each shell become a shell of
the model; faces outside of shells become one shell together, without those that are in a shell, too. A face between two solids is in
both of their shells: the second time as the other side of the first (`Parametric_surface_model_3::Face::other_side_of`).
- Faces of a shell are reversed where neighbours do not face to the same side. Where this is not possible, as on a Moebius
strip, the shell is open, and the edges are listed in `Open_cascade_model_3::turned_edges`.
- Vertices and edges are trusted within their tolerances. The distances between curves in domains and their edges are
measured; edges with distances above the tolerance are listed in `Open_cascade_model_3::gaps`.
- Curves in domains that are missing, or farther off than 1e-4 of the diagonal (and ten times the tolerance), are replaced
by projections of the edge.
- A face of a sphere without a seam, or with a boundary through a pole, gets the parameters of a stereographic projection
instead of those of the file.
- A face that is nowhere wider than a millionth of the diagonal is closed up, so that its neighbours meet without a gap: of
two edges side by side one takes the place of both, or several that of one along them, and shorter edges become a vertex.
The face is listed in `Open_cascade_model_3::closed_up` and is not in the model. It stays and is meshed, like those beside
it, if several edges on one side end at other places than several on the other one, if a neighbour would be left with an
edge there and back, or if it is wider than this together with others that are closed up.
- Other edges that are no longer than this become a vertex, too, unless nothing, or two edges side by side, would be left
of a loop.
- A face with a crease, a line of constant `u` or `v` across which its tangent plane turns by more than 11 degrees, becomes several faces of
the model, so that the crease is an edge of them. All of them have the number of the face.
- Edges and vertices with the orientation `TopAbs_INTERNAL` in a face are inner edges and inner points of it. Those that do not fit are listed with
the reason in `Open_cascade_model_3::inner_edges` and `inner_vertices`, as are all others.
- A face that cannot be built, or for which Open CASCADE throws an exception, is left out and listed with the reason. The
other faces do not depend on it.

\param shape a shape with faces
\param closed_up_width the largest width of faces that are closed up, and length of edges that become a vertex, over the
diagonal; 0 for none

\throws Parametric_surface_mesh_error if the shape has no extent
*/
inline Open_cascade_model_3 make_model_of_open_cascade_shape(const TopoDS_Shape& shape, double closed_up_width = 1e-6)
{
  using namespace Parametric_surface_mesher::internal;
  return guarded([&] {
    if(!shape.IsNull()) {
      const Crease_division division(shape);
      if(division.is_divided())
        return in_numbers_of_shape(Shape_model_builder(division.shape())(division.shape(), closed_up_width), division);
    }
    return Shape_model_builder(shape)(shape, closed_up_width);
  });
}

} // namespace CGAL

#endif // CGAL_MAKE_MODEL_OF_OPEN_CASCADE_SHAPE_H
