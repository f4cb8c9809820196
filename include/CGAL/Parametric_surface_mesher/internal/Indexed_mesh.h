// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_INDEXED_MESH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_INDEXED_MESH_H

#include <CGAL/Parametric_surface_mesher/internal/Triangle_adder.h>
#include <CGAL/Parametric_surface_mesher/internal/Triangle_twins.h>

#include <array>
#include <cstddef>
#include <map>
#include <set>
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
  std::vector<std::size_t> twins;     // of the sides of the faces, as far as known: see `Triangle_twins`

  // for each shell the pairs of boundary vertices that are joined by an edge already, smaller index first
  typedef std::set<std::pair<std::size_t, std::size_t>> Chords;
  std::map<std::size_t, Chords> chords;

  bool keeps_corner_points = false;
  std::vector<std::array<Point_2, 3>> corner_points; // of the faces, in the domain of their patch, if kept

  // turns all faces from number `first` on to the other side
  void reverse_faces(std::size_t first)
  {
    for(std::size_t i = first; i < faces.size(); ++i)
      std::swap(faces[i][1], faces[i][2]);
    for(std::size_t i = first; i < corner_points.size(); ++i)
      std::swap(corner_points[i][1], corner_points[i][2]);
    // of a face that is turned, the first side and the last one change their places
    for(std::size_t side = 3 * first; side < twins.size(); ++side)
      if(twins[side] != Triangle_twins::none)
        twins[side] = 3 * (twins[side] / 3) + 2 - twins[side] % 3;
    for(std::size_t side = 3 * first; side < twins.size(); side += 3)
      std::swap(twins[side], twins[side + 2]);
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

// Adds an indexed mesh to a face graph: vertices and faces in their order.
// The mesh loses its twins.
// throws Parametric_surface_mesh_error, before anything is added, if the triangles cannot be faces of one
template <class Kernel, class TriangleMesh, class Maps>
void add_to_face_graph(Indexed_mesh<Kernel>& mesh, TriangleMesh& tm, const Maps& maps)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  const Triangle_twins twins(mesh.faces, std::move(mesh.twins));
  reserve(tm, num_vertices(tm) + mesh.points.size(), num_edges(tm) + twins.number_of_edges(),
          num_faces(tm) + mesh.faces.size());
  std::vector<vertex_descriptor> vertices;
  vertices.reserve(mesh.points.size());
  for(std::size_t i = 0; i < mesh.points.size(); ++i) {
    const vertex_descriptor v = add_vertex(tm);
    put(maps.vertex_point_map, v, mesh.points[i]);
    put(maps.vertex_uv_map, v, mesh.domain_points[i]);
    vertices.push_back(v);
  }
  Triangle_adder<TriangleMesh> add(twins, vertices, tm);
  const auto faces = add(mesh.faces.size());
  for(std::size_t f = 0; f < faces.size(); ++f) {
    put(maps.face_patch_id_map, faces[f], mesh.patches[f]);
    if(mesh.keeps_corner_points)
      for(std::size_t k = 0; k < 3; ++k)
        put(maps.halfedge_uv_map, add.halfedge_of_side(3 * f + k), mesh.corner_points[f][(k + 1) % 3]);
  }
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_INDEXED_MESH_H
