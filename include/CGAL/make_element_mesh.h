// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MAKE_ELEMENT_MESH_H
#define CGAL_MAKE_ELEMENT_MESH_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Open_cascade_names_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Element_mesh_maker.h>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherFiles

makes an element mesh of the mesh of a CAD shape: triangles with their faces and parts, lines along edges, points at vertices, the places of
nodes, and groups of what has names, colours, layers, or is an assembly. Its nodes are the vertices of `tm`, its triangles
the faces of `tm`, in their order. Where pieces of `tm` meet in a vertex, an edge or a face of the model, their copies of a point are one node, and of the triangles on
both sides of a face between two parts those of the first part stay: the element mesh is one conforming complex.

\tparam TriangleMesh a model of `FaceListGraph`, `EdgeListGraph` and `VertexListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param shape the model of the shape
\param names its names
\param tm the mesh of `shape.model`
\param np the maps that `make_parametric_surface_mesh()` has filled: `halfedge_uv_map`, `face_patch_id_map`, `vertex_place_map`,
          `edge_place_map`, and, if it is not the default one, `vertex_point_map`
*/
template <class TriangleMesh, class NamedParameters>
Element_mesh_3 make_element_mesh(const Open_cascade_model_3& shape, const Open_cascade_names_3& names, const TriangleMesh& tm,
                                 const NamedParameters& np)
{
  return Parametric_surface_mesher::internal::Element_mesh_maker<TriangleMesh, NamedParameters>(shape, names, tm, np)();
}

/*!
\ingroup PkgParametricSurfaceMesherFiles

makes a mesh of elements of second order, as above. The nodes in the middles of the sides come after those at the vertices of `tm`.

\tparam MidSidePointMap a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and
        `%Point_3` as value type

\param shape the model of the shape
\param names its names
\param tm the mesh of `shape.model`
\param points the node in the middle of each edge
\param np maps, as above
*/
template <class TriangleMesh, class MidSidePointMap, class NamedParameters>
Element_mesh_3 make_second_order_element_mesh(const Open_cascade_model_3& shape, const Open_cascade_names_3& names, const TriangleMesh& tm,
                                              const MidSidePointMap& points, const NamedParameters& np)
{
  return Parametric_surface_mesher::internal::Element_mesh_maker<TriangleMesh, NamedParameters>(shape, names, tm, np)
    .with_mid_side_nodes(points);
}

} // namespace CGAL

#endif // CGAL_MAKE_ELEMENT_MESH_H
