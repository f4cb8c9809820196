// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WRITE_TRIANGULATION_ONTO_OPEN_CASCADE_SHAPE_H
#define CGAL_WRITE_TRIANGULATION_ONTO_OPEN_CASCADE_SHAPE_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Shape_triangulator.h>

#include <BRepTools.hxx>
#include <TopoDS_Shape.hxx>

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

What `write_triangulation_onto_open_cascade_shape()` has written.
*/
struct Open_cascade_triangulation_report
{
  std::size_t number_of_faces = 0; ///< of the shape that have triangles now
  /// edges of these faces that got no nodes. The mesh does not follow them all along, since detail was removed there, or since the sphere
  /// that they lie on was meshed across them
  std::size_t number_of_bare_edges = 0;
};

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

writes the mesh of a shape onto the shape, as the mesher of Open CASCADE does: a `Poly_Triangulation` with parameters of its nodes for
each face, and a `Poly_PolygonOnTriangulation` for each edge of a face. Writers of STL, VRML and glTF, and viewers, then take this mesh,
and `BRepMesh_IncrementalMesh` keeps it unless it is asked for a smaller deflection. The deflection of a face is the measured
distance of its triangles from the surface.

Triangulations that the shape has are removed. Of faces that differ in their places alone, as those of a part that an assembly has twice,
the triangles of the first one count. A face that the mesh is without gets none.

\tparam TriangleMesh a model of `FaceListGraph`, `EdgeListGraph` and `VertexListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param model the model of the shape
\param tm the mesh of `model.model`, in the unit of the shape
\param np the maps that `make_parametric_surface_mesh()` has filled: `halfedge_uv_map`, `face_patch_id_map`, `vertex_place_map`,
          `edge_place_map`, and, if it is not the default one, `vertex_point_map`
\param shape the shape that the model was made of

\throws Parametric_surface_mesh_error if Open CASCADE fails
*/
template <class TriangleMesh, class NamedParameters>
Open_cascade_triangulation_report write_triangulation_onto_open_cascade_shape(const Open_cascade_model_3& model, const TriangleMesh& tm,
                                                                              const NamedParameters& np, const TopoDS_Shape& shape)
{
  using namespace Parametric_surface_mesher::internal;
  return guarded([&] {
    BRepTools::Clean(shape);
    const auto numbers = Shape_triangulator<TriangleMesh, NamedParameters>(model, tm, np, shape)();
    return Open_cascade_triangulation_report{numbers.first, numbers.second};
  });
}

} // namespace CGAL

#endif // CGAL_WRITE_TRIANGULATION_ONTO_OPEN_CASCADE_SHAPE_H
