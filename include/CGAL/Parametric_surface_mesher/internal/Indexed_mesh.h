// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_INDEXED_MESH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_INDEXED_MESH_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The mesh of one or several patches before it goes to the user's data structure.
template <class Kernel>
struct Indexed_mesh
{
  std::vector<typename Kernel::Point_3> points;
  std::vector<typename Kernel::Point_2> domain_points; // of a vertex on several patches: in one of their domains
  std::vector<std::array<std::size_t, 3>> faces;
};

// Adds an indexed mesh to a face graph: vertices and faces in their order. `patches` has the patch of each face.
template <class Kernel, class TriangleMesh, class VertexPointMap, class VertexUvMap, class FacePatchIdMap>
void add_to_face_graph(const Indexed_mesh<Kernel>& mesh, const std::vector<std::size_t>& patches, TriangleMesh& tm,
                       VertexPointMap vertex_point_map, VertexUvMap vertex_uv_map, FacePatchIdMap face_patch_id_map)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  std::vector<vertex_descriptor> vertices;
  vertices.reserve(mesh.points.size());
  for(std::size_t i = 0; i < mesh.points.size(); ++i) {
    const vertex_descriptor v = add_vertex(tm);
    put(vertex_point_map, v, mesh.points[i]);
    put(vertex_uv_map, v, mesh.domain_points[i]);
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
      put(face_patch_id_map, f, patches[position - 1 - number_of_old_faces]);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_INDEXED_MESH_H
