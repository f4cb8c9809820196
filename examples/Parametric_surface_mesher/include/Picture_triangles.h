// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_PICTURE_TRIANGLES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_PICTURE_TRIANGLES_H

/*!
\file Picture_triangles.h

Points and triangles as plain arrays, the input of pictures of meshes.
*/

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace mesh_picture {

typedef std::array<std::size_t, 3> Triangle;

template <std::size_t dimension>
void check_input(const std::vector<std::array<double, dimension>>& points, const std::vector<Triangle>& triangles)
{
  for(const auto& p : points)
    for(const double x : p)
      if(!std::isfinite(x))
        throw std::invalid_argument("a mesh picture needs finite coordinates");
  for(const Triangle& t : triangles)
    if(*std::max_element(t.begin(), t.end()) >= points.size())
      throw std::invalid_argument("a mesh picture needs triangles of existing points");
}

// For each triangle a bit `1 << i` for each border edge from its point `i` to the next.
inline std::vector<int> border_edges(const std::vector<Triangle>& triangles)
{
  struct Use
  {
    std::pair<std::size_t, std::size_t> ends;
    std::size_t triangle;
    int bit;
  };
  std::vector<Use> uses;
  for(std::size_t t = 0; t < triangles.size(); ++t)
    for(int i = 0; i < 3; ++i)
      uses.push_back({std::minmax({triangles[t][i], triangles[t][(i + 1) % 3]}), t, 1 << i});
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) { return a.ends < b.ends; });

  std::vector<int> bits(triangles.size(), 0);
  for(std::size_t i = 0; i < uses.size(); ++i)
    if((i == 0 || uses[i - 1].ends != uses[i].ends) && (i + 1 == uses.size() || uses[i + 1].ends != uses[i].ends))
      bits[uses[i].triangle] |= uses[i].bit;
  return bits;
}

// The points, or other values for the vertices, and triangles of a mesh, without what is marked as removed.
template <std::size_t dimension, class Point, class Vertex_map>
std::pair<std::vector<std::array<double, dimension>>, std::vector<Triangle>>
arrays(const CGAL::Surface_mesh<Point>& mesh, const Vertex_map& coordinates)
{
  std::pair<std::vector<std::array<double, dimension>>, std::vector<Triangle>> result;
  std::vector<std::size_t> position(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  for(const auto v : mesh.vertices())
  {
    position[std::size_t(v)] = result.first.size();
    std::array<double, dimension> p;
    for(std::size_t i = 0; i < dimension; ++i)
      p[i] = coordinates(v)[static_cast<int>(i)];
    result.first.push_back(p);
  }
  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    result.second.push_back({{position[std::size_t(mesh.source(h))], position[std::size_t(mesh.target(h))],
                              position[std::size_t(mesh.target(mesh.next(h)))]}});
  }
  return result;
}

} // namespace mesh_picture

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_PICTURE_TRIANGLES_H
