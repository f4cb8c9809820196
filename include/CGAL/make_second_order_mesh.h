// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MAKE_SECOND_ORDER_MESH_H
#define CGAL_MAKE_SECOND_ORDER_MESH_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_domain_2.h>
#include <CGAL/Parametric_surface_mesh_parameters.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/pieces_of_patches.h>
#include <CGAL/Parametric_surface_mesher/internal/model/model_of_patch.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Distance_from_surface.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Mesh_in_model.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Second_order_maker.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Second_order_mesh_report.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherSecondOrder

makes second-order elements of the triangles of a mesh: six-node triangles, curved as the shape is. Each edge of the mesh gets one
node between its ends, which the triangles on both sides share.

- The node of an edge that is a piece of an edge of the model lies on its curve, in the middle by length in space.
- The node of any other edge lies on the surface of its face, equally far from both ends, where the surface is closest to the middle of
  the straight edge. So poles, seams and unequal parameters do not matter.
- Where triangles are folded by this, or nearly so, nodes are moved towards the middles of the straight edges. Of each triangle a
  lower bound of its scaled Jacobian is proved by Bezier coefficients (see `Second_order_mesh_report`). It is at least 0.1
  for all triangles but those that the report lists, which have no area.

The same mesh and model give the same nodes.

\tparam Surface a model of `ParametricSurface_3`
\tparam TriangleMesh a model of `FaceListGraph` and `EdgeListGraph`
\tparam MidSidePointMap a model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `%Point_3` as
        value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param model the model that the mesh was made of
\param tm the mesh
\param points takes the node of each edge
\param np a sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below: the maps that
       `make_parametric_surface_mesh()` has filled

\cgalNamedParamsBegin
  \cgalParamNBegin{halfedge_uv_map}
    \cgalParamDescription{the domain point of the target of each halfedge; it must be given}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%halfedge_descriptor`
                   as key type and `%Point_2` as value type}
  \cgalParamNEnd
  \cgalParamNBegin{face_patch_id_map}
    \cgalParamDescription{the index of the face of the model that each face of the mesh lies on}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor`
                   as key type and `std::size_t` as value type}
    \cgalParamDefault{0 for all}
  \cgalParamNEnd
  \cgalParamNBegin{edge_place_map}
    \cgalParamDescription{the edge of the model that each edge of the mesh is a piece of. Without it, the nodes along edges of the
                          model lie on the surface of one of the faces there}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor`
                   as key type and `Parametric_surface_mesher::Edge_place` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
                   as key type and `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre all faces of `tm` are triangles

\sa `CGAL::second_order_mesh_distance()`
*/
template <class Surface, class TriangleMesh, class MidSidePointMap, class NamedParameters>
Second_order_mesh_report make_second_order_mesh(const Parametric_surface_model_3<Surface>& model, const TriangleMesh& tm,
                                                const MidSidePointMap& points, const NamedParameters& np)
{
  using namespace Parametric_surface_mesher::internal;
  const auto mesh = make_mesh_in_model(tm, np);
  return Second_order_maker<Surface, decltype(mesh)>(model, mesh).make(points);
}

/*!
\ingroup PkgParametricSurfaceMesherSecondOrder

makes second-order elements, as above, of the mesh of one surface. The edges of a model are the curves of `domain`, loop by loop.
*/
template <class Surface, class Kernel, class TriangleMesh, class MidSidePointMap, class NamedParameters>
Second_order_mesh_report make_second_order_mesh(const Surface& surface, const Parametric_domain_2<Kernel>& domain,
                                                const TriangleMesh& tm, const MidSidePointMap& points,
                                                const NamedParameters& np)
{
  return make_second_order_mesh(Parametric_surface_mesher::internal::model_of_patch(surface, domain), tm, points, np);
}

/*!
\ingroup PkgParametricSurfaceMesherSecondOrder

measures the largest distance from points of six-node triangles to the surfaces of their faces. With the middles of the straight edges
as nodes, it measures that of the straight triangles.

The points are those whose barycentric coordinates are multiples of `1/subdivisions`. The closest points are looked for nearby: the
result is never less than the distance of one of the points, of the whole surface.

\tparam ConcurrencyTag `Sequential_tag` (default), `Parallel_tag` or `Parallel_if_available_tag`. With threads the result is the same. `tm` and
the maps are read by all of them, copies of surfaces are evaluated as `ParametricSurface_3` tells

\param model the model that the mesh was made of
\param tm the mesh
\param points the node of each edge: a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and
       `%Point_3` as value type
\param np a sequence of named parameters, as for `make_second_order_mesh()`
\param subdivisions the number of pieces into which a side of a triangle is cut
*/
template <class ConcurrencyTag = Sequential_tag, class Surface, class TriangleMesh, class MidSidePointMap, class NamedParameters>
double second_order_mesh_distance(const Parametric_surface_model_3<Surface>& model, const TriangleMesh& tm,
                                  const MidSidePointMap& points, const NamedParameters& np, unsigned int subdivisions = 6)
{
  using namespace Parametric_surface_mesher::internal;
  const auto mesh = make_mesh_in_model(tm, np);
  const auto pieces = pieces_of_patches(faces(tm), [&](auto f) { return mesh.patch(f); });
  std::vector<double> distances(pieces.size());
  for_each_piece<ConcurrencyTag>(model, pieces, [&](const auto& piece, std::size_t i, const Surface& surface) {
    const Distance_from_surface<Surface> distance(surface, subdivisions);
    for(const auto f : piece.faces) {
      const auto [h, j, k] = mesh.sides(f);
      distances[i] = (std::max)(distances[i], distance(mesh.template curved_triangle<typename Surface::Geom_traits>(f, points),
                                                       {mesh.source_uv(h), mesh.source_uv(j), mesh.source_uv(k)}));
    }
  });
  return std::accumulate(distances.begin(), distances.end(), 0., [](double a, double b) { return (std::max)(a, b); });
}

/*!
\ingroup PkgParametricSurfaceMesherSecondOrder

measures the distance, as above, of the mesh of one surface.
*/
template <class ConcurrencyTag = Sequential_tag, class Surface, class Kernel, class TriangleMesh, class MidSidePointMap, class NamedParameters>
double second_order_mesh_distance(const Surface& surface, const Parametric_domain_2<Kernel>& domain, const TriangleMesh& tm,
                                  const MidSidePointMap& points, const NamedParameters& np, unsigned int subdivisions = 6)
{
  return second_order_mesh_distance<ConcurrencyTag>(Parametric_surface_mesher::internal::model_of_patch(surface, domain), tm, points, np,
                                                    subdivisions);
}

} // namespace CGAL

#endif // CGAL_MAKE_SECOND_ORDER_MESH_H
