// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_APPEND_MESHES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_APPEND_MESHES_H

#include <CGAL/Parametric_surface_mesher/internal/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/Triangle_twins.h>
#include <CGAL/Parametric_surface_mesher/internal/for_each_index.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Appends meshes, at the same time. In each the indices from `first_index` on are those of its own points; others are points
// of `mesh` already. The meshes are used up.
template <class ConcurrencyTag, class Kernel>
void append_meshes(std::vector<Indexed_mesh<Kernel>>& meshes, std::size_t first_index, Indexed_mesh<Kernel>& mesh)
{
  std::vector<std::size_t> points(1, mesh.points.size()), faces(1, mesh.faces.size()); // where each mesh begins
  for(const auto& other : meshes) {
    points.push_back(points.back() + other.points.size());
    faces.push_back(faces.back() + other.faces.size());
  }
  mesh.points.resize(points.back());
  mesh.domain_points.resize(points.back());
  mesh.faces.resize(faces.back());
  mesh.twins.resize(3 * faces.front(), std::size_t(Triangle_twins::none));
  mesh.twins.resize(3 * faces.back());
  if(mesh.keeps_corner_points)
    mesh.corner_points.resize(faces.back());
  for_each_index<ConcurrencyTag>(meshes.size(), [&](std::size_t i) {
    const Indexed_mesh<Kernel> other = std::move(meshes[i]);
    std::copy(other.points.begin(), other.points.end(), mesh.points.begin() + points[i]);
    std::copy(other.domain_points.begin(), other.domain_points.end(), mesh.domain_points.begin() + points[i]);
    if(mesh.keeps_corner_points)
      std::copy(other.corner_points.begin(), other.corner_points.end(), mesh.corner_points.begin() + faces[i]);
    for(std::size_t f = 0; f < other.faces.size(); ++f)
      for(std::size_t k = 0; k < 3; ++k) {
        const std::size_t v = other.faces[f][k], twin = other.twins[3 * f + k];
        mesh.faces[faces[i] + f][k] = v < first_index ? v : v - first_index + points[i];
        mesh.twins[3 * (faces[i] + f) + k] = twin == Triangle_twins::none ? twin : twin + 3 * faces[i];
      }
  });
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_APPEND_MESHES_H
