// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The six-node triangles of mesh_patch, for solvers.
#ifndef WRITE_SECOND_ORDER_PATCH_H
#define WRITE_SECOND_ORDER_PATCH_H

#include "Mesh_patch_result.h"

#include <CGAL/Element_mesh_3.h>
#include <CGAL/IO/write_BDF.h>
#include <CGAL/IO/write_INP.h>
#include <CGAL/IO/write_MSH.h>
#include <CGAL/IO/write_element_VTU.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace mesh_patch {

inline std::vector<std::string> endings_for_second_order() { return {".vtu", ".msh", ".inp", ".bdf"}; }

// The nodes of the edges come after the vertices. Each patch is a surface with its number.
inline CGAL::Element_mesh_3 second_order_elements(const Mesh_patch_result& result)
{
  const Mesh& mesh = result.mesh;
  CGAL::Element_mesh_3 elements;
  elements.is_second_order = true;
  const auto add_node = [&](const auto& p) { elements.nodes.push_back({{p.x(), p.y(), p.z()}}); };
  for(const auto v : mesh.vertices())
    add_node(mesh.point(v));
  for(const auto e : mesh.edges())
    add_node(result.mid_side_nodes[e]);
  for(std::size_t patch = 0; patch < result.patches.size(); ++patch) {
    elements.surfaces.emplace_back();
    elements.surfaces.back().number = patch + 1;
  }
  for(const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f), next = mesh.next(h), prev = mesh.prev(h);
    const auto node = [&](auto side) { return mesh.number_of_vertices() + std::size_t(mesh.edge(side)); };
    elements.triangles.push_back({{std::size_t(mesh.source(h)), std::size_t(mesh.target(h)), std::size_t(mesh.target(next)), node(h), node(next), node(prev)}});
    elements.triangle_surfaces.push_back(result.patch_of_face[f]);
  }
  return elements;
}

inline void write_second_order(std::ostream& out, const std::string& file_name, const Mesh_patch_result& result)
{
  const CGAL::Element_mesh_3 elements = second_order_elements(result);
  if(has_ending(file_name, ".vtu"))
    CGAL::IO::write_VTU(out, elements);
  else if(has_ending(file_name, ".msh"))
    CGAL::IO::write_MSH(out, elements);
  else if(has_ending(file_name, ".inp"))
    CGAL::IO::write_INP(out, elements);
  else
    CGAL::IO::write_BDF(out, elements);
}

} // namespace mesh_patch

#endif // WRITE_SECOND_ORDER_PATCH_H
