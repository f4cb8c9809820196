// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_MESH_WITH_DOMAIN_H
#define PARAMETRIC_SURFACE_MESHER_TEST_MESH_WITH_DOMAIN_H

#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>

// A mesh with all that the mesher tells of it.
template <class Kernel>
struct Mesh_with_domain
{
  typedef typename Kernel::Point_2 Point_2;
  typedef CGAL::Surface_mesh<typename Kernel::Point_3> Mesh;
  typedef typename Mesh::Vertex_index Vertex_index;
  typedef typename Mesh::Halfedge_index Halfedge_index;
  typedef typename Mesh::Face_index Face_index;
  typedef typename Mesh::template Property_map<Halfedge_index, Point_2> Halfedge_uv_map;
  typedef typename Mesh::template Property_map<Face_index, std::size_t> Face_patch_id_map;

  Mesh mesh;
  Halfedge_uv_map halfedge_uv = mesh.template add_property_map<Halfedge_index, Point_2>("h:uv", Point_2(0, 0)).first;
  Face_patch_id_map patch_id = mesh.template add_property_map<Face_index, std::size_t>("f:patch", 0).first;
  CGAL::Parametric_surface_mesh_report report;

  Mesh_with_domain() = default;
  Mesh_with_domain(const Mesh_with_domain&) = delete; // the maps refer to the mesh
  Mesh_with_domain& operator=(const Mesh_with_domain&) = delete;

  std::array<Halfedge_index, 3> halfedges(Face_index f) const
  {
    const Halfedge_index h = mesh.halfedge(f);
    return {h, mesh.next(h), mesh.next(mesh.next(h))};
  }
};

#endif // PARAMETRIC_SURFACE_MESHER_TEST_MESH_WITH_DOMAIN_H
