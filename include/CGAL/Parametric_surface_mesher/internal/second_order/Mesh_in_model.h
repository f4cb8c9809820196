// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_MESH_IN_MODEL_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_MESH_IN_MODEL_H

#include <CGAL/Parametric_surface_mesh_parameters.h>
#include <CGAL/Parametric_surface_mesher/Model_places.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Quadratic_triangle_3.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A mesh that was made of a model, with where its elements lie in it. Refers to the mesh.
template <class TriangleMesh, class VertexPointMap, class HalfedgeUvMap, class FacePatchIdMap, class EdgePlaceMap>
struct Mesh_in_model
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;

  const TriangleMesh& mesh;
  VertexPointMap vertex_point_map;
  HalfedgeUvMap halfedge_uv_map;
  FacePatchIdMap face_patch_id_map;
  EdgePlaceMap edge_place_map;

  decltype(auto) target_point(halfedge_descriptor h) const { return get(vertex_point_map, target(h, mesh)); }
  decltype(auto) source_point(halfedge_descriptor h) const { return get(vertex_point_map, source(h, mesh)); }
  decltype(auto) target_uv(halfedge_descriptor h) const { return get(halfedge_uv_map, h); }
  // in the domain of the face at the halfedge
  decltype(auto) source_uv(halfedge_descriptor h) const { return get(halfedge_uv_map, prev(h, mesh)); }
  std::size_t patch(face_descriptor f) const { return get(face_patch_id_map, f); }
  Edge_place place(edge_descriptor e) const { return get(edge_place_map, e); }
  bool is_on_border(halfedge_descriptor h) const { return face(h, mesh) == Graph_traits::null_face(); }

  // The halfedges of a face, from one whose source counts as the first corner.
  std::array<halfedge_descriptor, 3> sides(face_descriptor f) const
  {
    const halfedge_descriptor h = halfedge(f, mesh);
    return {h, next(h, mesh), next(next(h, mesh), mesh)};
  }

  // A face with the nodes of its sides.
  template <class Kernel, class MidSidePointMap>
  Quadratic_triangle_3<Kernel> curved_triangle(face_descriptor f, const MidSidePointMap& points) const
  {
    const auto [h, i, k] = sides(f);
    return Quadratic_triangle_3<Kernel>({source_point(h), source_point(i), source_point(k), get(points, edge(h, mesh)),
                                         get(points, edge(i, mesh)), get(points, edge(k, mesh))});
  }
};

// The mesh with the maps among named parameters.
template <class TriangleMesh, class NamedParameters>
auto make_mesh_in_model(const TriangleMesh& mesh, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  static_assert(!parameters::is_default_parameter<NamedParameters, Halfedge_uv_map_t>::value,
                "The named parameter halfedge_uv_map is needed: it tells where triangles lie on their surfaces.");
  const auto vertex_point_map
    = choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, mesh));
  const auto halfedge_uv_map = get_parameter(np, Halfedge_uv_map_t());
  const auto face_patch_id_map
    = choose_parameter(get_parameter(np, Face_patch_id_map_t()),
                       Constant_property_map<typename Graph_traits::face_descriptor, std::size_t>(0));
  const auto edge_place_map
    = choose_parameter(get_parameter(np, Edge_place_map_t()),
                       Constant_property_map<typename Graph_traits::edge_descriptor, Edge_place>(Edge_place()));
  return Mesh_in_model<TriangleMesh, std::decay_t<decltype(vertex_point_map)>, std::decay_t<decltype(halfedge_uv_map)>,
                       std::decay_t<decltype(face_patch_id_map)>, std::decay_t<decltype(edge_place_map)>>{
    mesh, vertex_point_map, halfedge_uv_map, face_patch_id_map, edge_place_map};
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_MESH_IN_MODEL_H
