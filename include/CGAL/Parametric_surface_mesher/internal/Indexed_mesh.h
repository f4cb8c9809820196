// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_INDEXED_MESH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_INDEXED_MESH_H

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The mesh of one or several patches before it goes to the user's data structure.
template <class Kernel>
struct Indexed_mesh
{
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;

  std::vector<Point_3> points;
  std::vector<Point_2> domain_points; // of a vertex on several patches: in one of their domains
  std::vector<std::array<std::size_t, 3>> faces;
  std::vector<std::size_t> patches;   // of the faces

  bool keeps_corner_points = false;
  std::vector<std::array<Point_2, 3>> corner_points; // of the faces, in the domain of their patch, if kept

  // turns all faces from number `first` on to the other side
  void reverse_faces(std::size_t first)
  {
    for(std::size_t i = first; i < faces.size(); ++i)
      std::swap(faces[i][1], faces[i][2]);
    for(std::size_t i = first; i < corner_points.size(); ++i)
      std::swap(corner_points[i][1], corner_points[i][2]);
  }
};

// The property maps that the output fills.
template <class VertexPointMap, class VertexUvMap, class HalfedgeUvMap, class FacePatchIdMap>
struct Output_maps
{
  VertexPointMap vertex_point_map;
  VertexUvMap vertex_uv_map;
  HalfedgeUvMap halfedge_uv_map;
  FacePatchIdMap face_patch_id_map;
};

template <class VertexPointMap, class VertexUvMap, class HalfedgeUvMap, class FacePatchIdMap>
Output_maps<VertexPointMap, VertexUvMap, HalfedgeUvMap, FacePatchIdMap>
make_output_maps(const VertexPointMap& vertex_point_map, const VertexUvMap& vertex_uv_map,
                 const HalfedgeUvMap& halfedge_uv_map, const FacePatchIdMap& face_patch_id_map)
{
  return {vertex_point_map, vertex_uv_map, halfedge_uv_map, face_patch_id_map};
}

template <class Kernel, class Triangles, class Face, class TriangleMesh, class Maps>
void put_face_properties(const Indexed_mesh<Kernel>& mesh, std::size_t i, const Triangles& triangles, Face f,
                         TriangleMesh& tm, const Maps& maps)
{
  put(maps.face_patch_id_map, f, mesh.patches[i]);
  if(!mesh.keeps_corner_points)
    return;
  for(const auto h : halfedges_around_face(halfedge(f, tm), tm))
    for(int k = 0; k < 3; ++k)
      if(triangles[i][k] == target(h, tm))
        put(maps.halfedge_uv_map, h, mesh.corner_points[i][k]);
}

// Adds an indexed mesh to a face graph: vertices and faces in their order.
template <class Kernel, class TriangleMesh, class Maps>
void add_to_face_graph(const Indexed_mesh<Kernel>& mesh, TriangleMesh& tm, const Maps& maps)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  std::vector<vertex_descriptor> vertices;
  vertices.reserve(mesh.points.size());
  for(std::size_t i = 0; i < mesh.points.size(); ++i) {
    const vertex_descriptor v = add_vertex(tm);
    put(maps.vertex_point_map, v, mesh.points[i]);
    put(maps.vertex_uv_map, v, mesh.domain_points[i]);
    vertices.push_back(v);
  }
  std::vector<std::array<vertex_descriptor, 3>> triangles;
  triangles.reserve(mesh.faces.size());
  for(const auto& f : mesh.faces)
    triangles.push_back({vertices[f[0]], vertices[f[1]], vertices[f[2]]});
  const std::size_t number_of_old_faces = num_faces(tm);
  Euler::add_faces(triangles, tm);
  std::size_t position = 0;
  for(const auto f : faces(tm)) // the new ones come last, in their order
    if(position++ >= number_of_old_faces)
      put_face_properties(mesh, position - 1 - number_of_old_faces, triangles, f, tm, maps);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_INDEXED_MESH_H
