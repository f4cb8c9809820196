// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_OUTPUT_MAPS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_OUTPUT_MAPS_H

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A property map that ignores all values.
template <class Key, class Value>
struct Ignoring_property_map
{
  typedef Key key_type;
  typedef Value value_type;
  typedef Value reference;
  typedef boost::writable_property_map_tag category;
  friend void put(const Ignoring_property_map&, const Key&, const Value&) {}
};

template <class Map>
struct Is_ignoring_map : std::false_type
{};

template <class Key, class Value>
struct Is_ignoring_map<Ignoring_property_map<Key, Value>> : std::true_type
{};

// Whether several threads may put values of different keys into a map at the same time. They must not for `bool`, whose maps may
// be arrays of bits.
template <class TriangleMesh, class Map>
struct Is_concurrent_map : std::false_type
{};

template <class TriangleMesh, class Key, class Value>
struct Is_concurrent_map<TriangleMesh, Ignoring_property_map<Key, Value>> : std::true_type
{};

template <class Point, class Key, class Value>
struct Is_concurrent_map<Surface_mesh<Point>, Ignoring_property_map<Key, Value>> : std::true_type
{};

template <class Point, class Map>
struct Is_concurrent_map<Surface_mesh<Point>, Map>
{
  typedef typename boost::property_traits<Map>::key_type Key;
  typedef typename boost::property_traits<Map>::value_type Value;
  typedef typename Surface_mesh<Point>::template Property_map<Key, Value> Array;
  static constexpr bool value = std::is_same<Map, Array>::value && !std::is_same<Value, bool>::value;
};

// The property maps that the output fills.
template <class VertexPointMap, class VertexUvMap, class HalfedgeUvMap, class FacePatchIdMap, class VertexPlaceMap, class EdgePlaceMap>
struct Output_maps
{
  VertexPointMap vertex_point_map;
  VertexUvMap vertex_uv_map;
  HalfedgeUvMap halfedge_uv_map;
  FacePatchIdMap face_patch_id_map;
  VertexPlaceMap vertex_place_map;
  EdgePlaceMap edge_place_map;

  static constexpr bool has_edge_places = !Is_ignoring_map<EdgePlaceMap>::value;

  template <class TriangleMesh>
  static constexpr bool are_concurrent()
  {
    return Is_concurrent_map<TriangleMesh, VertexPointMap>::value && Is_concurrent_map<TriangleMesh, VertexUvMap>::value
           && Is_concurrent_map<TriangleMesh, HalfedgeUvMap>::value
           && Is_concurrent_map<TriangleMesh, FacePatchIdMap>::value && Is_concurrent_map<TriangleMesh, VertexPlaceMap>::value
           && Is_concurrent_map<TriangleMesh, EdgePlaceMap>::value;
  }
};

template <class VertexPointMap, class VertexUvMap, class HalfedgeUvMap, class FacePatchIdMap, class VertexPlaceMap, class EdgePlaceMap>
Output_maps<VertexPointMap, VertexUvMap, HalfedgeUvMap, FacePatchIdMap, VertexPlaceMap, EdgePlaceMap>
make_output_maps(const VertexPointMap& vertex_point_map, const VertexUvMap& vertex_uv_map,
                 const HalfedgeUvMap& halfedge_uv_map, const FacePatchIdMap& face_patch_id_map,
                 const VertexPlaceMap& vertex_place_map, const EdgePlaceMap& edge_place_map)
{
  return {vertex_point_map, vertex_uv_map, halfedge_uv_map, face_patch_id_map, vertex_place_map, edge_place_map};
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_OUTPUT_MAPS_H
