// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MAKE_MESH_PAGE_H
#define CGAL_MAKE_MESH_PAGE_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Mesh_page_3.h>
#include <CGAL/Parametric_domain_2.h>
#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/model/model_of_patch.h>
#include <CGAL/Parametric_surface_mesher/internal/page/Page_maker.h>
#include <CGAL/Parametric_surface_model_3.h>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherFiles

makes a page of the mesh of a model: its triangles, in the order of `tm`, with their places in the domains of its faces, lines along its
edges, distances from the surfaces, curvatures, metric tensors, and what the report says was not met or removed. Faces and edges have
their numbers in the model, from 1. Title, unit and names are left to the caller, as are the parts.

\tparam Surface a model of `ParametricSurface_3`
\tparam TriangleMesh a model of `FaceListGraph`, `EdgeListGraph` and `VertexListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param model the model that the mesh was made of
\param tm the mesh, which contains nothing else
\param report what `make_parametric_surface_mesh()` returned
\param np the maps that `make_parametric_surface_mesh()` has filled: `halfedge_uv_map`, which must be given, `face_patch_id_map`,
          `edge_place_map`, and `vertex_point_map`, if it is not the default one; and the `metric_field` that it was called with
*/
template <class Surface, class TriangleMesh, class NamedParameters>
Mesh_page_3 make_mesh_page(const Parametric_surface_model_3<Surface>& model, const TriangleMesh& tm,
                           const Parametric_surface_mesh_report& report, const NamedParameters& np)
{
  return Parametric_surface_mesher::internal::make_page(model, tm, report, np);
}

/*!
\ingroup PkgParametricSurfaceMesherFiles

makes a page, as above, of the mesh of one surface. The edges of the model are the curves of `domain`, loop by loop.
*/
template <class Surface, class Kernel, class TriangleMesh, class NamedParameters>
Mesh_page_3 make_mesh_page(const Surface& surface, const Parametric_domain_2<Kernel>& domain, const TriangleMesh& tm,
                           const Parametric_surface_mesh_report& report, const NamedParameters& np)
{
  return make_mesh_page(Parametric_surface_mesher::internal::model_of_patch(surface, domain), tm, report, np);
}

} // namespace CGAL

#endif // CGAL_MAKE_MESH_PAGE_H
