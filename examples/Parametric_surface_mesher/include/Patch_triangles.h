// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The triangles of one patch of a mesh, with vertices of their own.
#ifndef PATCH_TRIANGLES_H
#define PATCH_TRIANGLES_H

#include "Sample_surfaces.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Circumellipse_2.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

typedef CGAL::Surface_mesh<Sample_kernel::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, Sample_kernel::Point_2> Vertex_uv_map;
typedef Mesh::Property_map<Mesh::Halfedge_index, Sample_kernel::Point_2> Halfedge_uv_map;
typedef Mesh::Property_map<Mesh::Face_index, std::size_t> Face_patch_map;

// Every vertex has one domain point: a pole is as many vertices as it has domain points. All triangles are
// counterclockwise in the domain, whatever side they face in the whole mesh.
struct Patch_triangles
{
  Mesh mesh;
  Vertex_uv_map uv;

  Patch_triangles() : uv(mesh.add_property_map<Mesh::Vertex_index, Sample_kernel::Point_2>("v:uv").first) {}
};

namespace mesh_patch {

// a vertex of the whole mesh with one of its domain points
typedef std::tuple<Mesh::Vertex_index, double, double> Corner;

inline std::array<Corner, 3> corners(const Mesh& mesh, const Halfedge_uv_map& uv, Mesh::Face_index face)
{
  std::array<Corner, 3> result;
  std::size_t i = 0;
  for(const auto h : mesh.halfedges_around_face(mesh.halfedge(face)))
    result[i++] = {mesh.target(h), uv[h].x(), uv[h].y()};
  return result;
}

inline std::vector<std::vector<Mesh::Face_index>> faces_of_patches(const Mesh& mesh, const Face_patch_map& patch,
                                                                   std::size_t number_of_patches)
{
  std::vector<std::vector<Mesh::Face_index>> result(number_of_patches);
  for(const auto face : mesh.faces())
    result[patch[face]].push_back(face);
  return result;
}

// The triangles of the patch, in the order of `faces`; vertices in the order of the mesh.
inline void append_triangles(const Mesh& mesh, const Halfedge_uv_map& uv, const std::vector<Mesh::Face_index>& faces,
                             bool is_reversed, Patch_triangles& result)
{
  std::vector<Corner> vertices;
  for(const auto face : faces)
    for(const Corner& corner : corners(mesh, uv, face))
      vertices.push_back(corner);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for(const Corner& v : vertices)
    result.uv[result.mesh.add_vertex(mesh.point(std::get<0>(v)))] = {std::get<1>(v), std::get<2>(v)};

  const auto index = [&](const Corner& c) {
    return Mesh::Vertex_index(std::lower_bound(vertices.begin(), vertices.end(), c) - vertices.begin());
  };
  for(const auto face : faces) {
    std::array<Corner, 3> c = corners(mesh, uv, face);
    if(is_reversed)
      std::swap(c[1], c[2]);
    if(result.mesh.add_face(index(c[0]), index(c[1]), index(c[2])) == Mesh::null_face())
      throw std::logic_error("the triangles of a patch form no mesh in its domain");
  }
}

// The patches of a model side by side in the domain plane, in rows from the top.
struct Uv_layout
{
  std::size_t columns = 1;
  double shift = 0;             // from one patch to the next
  double width = 1, height = 1; // of the box around all of them

  explicit Uv_layout(const std::deque<Patch_triangles>& patches)
  {
    while(columns * columns < patches.size())
      ++columns;
    width = height = 0;
    for(const Patch_triangles& patch : patches) {
      CGAL::Bbox_2 box;
      for(const auto v : patch.mesh.vertices())
        box += patch.uv[v].bbox();
      width = (std::max)(width, box.x_span());
      height = (std::max)(height, box.y_span());
    }
    if(patches.size() > 1) {
      shift = 1.1 * (std::max)(width, height);
      width = height = shift * double(columns);
    }
  }

  // what to add to the parameters of patch `i`
  std::array<double, 2> translation(std::size_t i) const
  {
    return {shift * double(i % columns), -shift * double(i / columns)};
  }
};

// Appends the circumellipse of a triangle under the sum of the tensors at its corners, if there is one: there is none at a
// pole, where no tensor is positive definite.
template <class Metric>
void append_circumellipse(const Patch_triangles& triangles, const Sample_surface& surface, const Metric& metric,
                   Mesh::Face_index face, std::vector<CGAL::Circumellipse_2<Sample_kernel>>& ellipses)
{
  std::array<Sample_kernel::Point_2, 3> p;
  double e = 0, f = 0, g = 0;
  std::size_t i = 0;
  for(const auto v : triangles.mesh.vertices_around_face(triangles.mesh.halfedge(face))) {
    p[i] = triangles.uv[v];
    const CGAL::Metric_tensor_2 tensor = metric.tensor(surface.jet(p[i].x(), p[i].y()));
    e += tensor.e(), f += tensor.f(), g += tensor.g();
    ++i;
  }
  const CGAL::Metric_tensor_2 sum(e, f, g);
  if(!sum.is_positive_definite() || CGAL::collinear(p[0], p[1], p[2]))
    return;
  ellipses.emplace_back(p[0], p[1], p[2], sum);
}

} // namespace mesh_patch

#endif // PATCH_TRIANGLES_H
