// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESH_PARAMETERS_H
#define CGAL_PARAMETRIC_SURFACE_MESH_PARAMETERS_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {

namespace Parametric_surface_mesher {
namespace internal {

// tags of the named parameters that are not CGAL's
enum Vertex_uv_map_t { vertex_uv_map_tag };
enum Halfedge_uv_map_t { halfedge_uv_map_tag };
enum Face_patch_id_map_t { face_patch_id_map_tag };
enum Vertex_place_map_t { vertex_place_map_tag };
enum Edge_place_map_t { edge_place_map_tag };
enum Metric_field_t { metric_field_tag };
enum Leaves_out_bad_faces_t { leaves_out_bad_faces_tag };
enum Triangle_criterion_t { triangle_criterion_tag };
enum Kept_faces_t { kept_faces_tag };

template <class Tag, class T>
Named_function_parameters<T, Tag> named_parameter(const T& value)
{
  return Named_function_parameters<T, Tag>(value);
}

template <class Tag, class T, class V, class W, class Base>
Named_function_parameters<T, Tag, Named_function_parameters<V, W, Base>>
named_parameter(const T& value, const Named_function_parameters<V, W, Base>& others)
{
  return Named_function_parameters<T, Tag, Named_function_parameters<V, W, Base>>(value, others);
}

} // namespace internal
} // namespace Parametric_surface_mesher

namespace parameters {

/*!
\ingroup PkgParametricSurfaceMesherRef

the named parameter for the property map that takes the domain point `(u,v)` of each vertex: a model of
`WritablePropertyMap` with value type `Kernel::Point_2`.

The parameters of this package start a sequence, to which those of CGAL are chained, or take the others as second argument:
`vertex_uv_map(uv).visitor(v)`, `vertex_uv_map(uv, metric_field(m))`.
*/
template <class VertexUvMap, class... Others>
auto vertex_uv_map(const VertexUvMap& map, const Others&... others)
{
  return Parametric_surface_mesher::internal::named_parameter<
    Parametric_surface_mesher::internal::Vertex_uv_map_t>(map, others...);
}

/*!
\ingroup PkgParametricSurfaceMesherRef

the named parameter for the property map that takes, for each halfedge that is not on the border, the domain point of its
target in the domain of the patch that its face lies on: a model of `WritablePropertyMap` with value type
`Kernel::Point_2`. A vertex on several patches has a domain point on each. See `vertex_uv_map()` on how to combine it.
*/
template <class HalfedgeUvMap, class... Others>
auto halfedge_uv_map(const HalfedgeUvMap& map, const Others&... others)
{
  return Parametric_surface_mesher::internal::named_parameter<
    Parametric_surface_mesher::internal::Halfedge_uv_map_t>(map, others...);
}

/*!
\ingroup PkgParametricSurfaceMesherRef

the named parameter for the property map that takes, for each face of the mesh, the index, from 0, of the patch that it lies on: a model
of `WritablePropertyMap` with value type `std::size_t`. See `vertex_uv_map()` on how to combine it.
*/
template <class FacePatchIdMap, class... Others>
auto face_patch_id_map(const FacePatchIdMap& map, const Others&... others)
{
  return Parametric_surface_mesher::internal::named_parameter<
    Parametric_surface_mesher::internal::Face_patch_id_map_t>(map, others...);
}

/*!
\ingroup PkgParametricSurfaceMesherRef

the named parameter for the property map that takes, for each vertex, what it lies on in the model: a model of `WritablePropertyMap` with
value type `Parametric_surface_mesher::Vertex_place`. See `vertex_uv_map()` on how to combine it.
*/
template <class VertexPlaceMap, class... Others>
auto vertex_place_map(const VertexPlaceMap& map, const Others&... others)
{
  return Parametric_surface_mesher::internal::named_parameter<
    Parametric_surface_mesher::internal::Vertex_place_map_t>(map, others...);
}

/*!
\ingroup PkgParametricSurfaceMesherRef

the named parameter for the property map that takes, for each edge of the mesh, the edge of the model that it is a piece of: a model of
`WritablePropertyMap` with value type `Parametric_surface_mesher::Edge_place`. See `vertex_uv_map()` on how to combine it.
*/
template <class EdgePlaceMap, class... Others>
auto edge_place_map(const EdgePlaceMap& map, const Others&... others)
{
  return Parametric_surface_mesher::internal::named_parameter<
    Parametric_surface_mesher::internal::Edge_place_map_t>(map, others...);
}

/*!
\ingroup PkgParametricSurfaceMesherRef

the named parameter for the metric field, a model of `ParametricSurfaceMetricField_2`. See `vertex_uv_map()` on how to
combine it.
*/
template <class MetricField, class... Others>
auto metric_field(const MetricField& field, const Others&... others)
{
  return Parametric_surface_mesher::internal::named_parameter<
    Parametric_surface_mesher::internal::Metric_field_t>(field, others...);
}

/*!
\ingroup PkgParametricSurfaceMesherRef

the named parameter for a criterion of the user, which all triangles are to meet beside those of
`Parametric_surface_mesh_criteria`: a model of `ParametricSurfaceTriangleCriterion`. See `vertex_uv_map()` on how to combine
it.
*/
template <class TriangleCriterion, class... Others>
auto triangle_criterion(const TriangleCriterion& criterion, const Others&... others)
{
  return Parametric_surface_mesher::internal::named_parameter<
    Parametric_surface_mesher::internal::Triangle_criterion_t>(criterion, others...);
}

/*!
\ingroup PkgParametricSurfaceMesherRef

the named parameter, a `bool`, that decides what happens if a face of a model cannot be meshed. With `true` the mesh is made
without it, as if it had no boundary, and `Parametric_surface_mesh_report::left_out` tells why; with `false`, the default, an
exception is thrown. The edges that it shares are divided for the other faces. See `vertex_uv_map()` on how to combine it.
*/
template <class... Others>
auto leaves_out_bad_faces(bool b, const Others&... others)
{
  return Parametric_surface_mesher::internal::named_parameter<
    Parametric_surface_mesher::internal::Leaves_out_bad_faces_t>(b, others...);
}

/*!
\ingroup PkgParametricSurfaceMesherRef

the named parameter for the faces of an earlier run of the same model, which keep their triangles where nothing has changed, and then become
those of this run: `std::ref` of a `Parametric_surface_mesher::Kept_faces`. See `vertex_uv_map()` on how to combine it.
*/
template <class KeptFaces, class... Others>
auto kept_faces(const KeptFaces& faces, const Others&... others)
{
  return Parametric_surface_mesher::internal::named_parameter<
    Parametric_surface_mesher::internal::Kept_faces_t>(faces, others...);
}

} // namespace parameters
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESH_PARAMETERS_H
