// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far the mesh of a CAD model is from its shape.
#ifndef DISTANCE_FROM_SHAPE_H
#define DISTANCE_FROM_SHAPE_H

#include "Cad_mesh.h"
#include "distance_over_triangle.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/pieces_of_patches.h>
#include <CGAL/Parametric_surface_mesher/internal/support/for_each_index.h>

#include <CGAL/Open_cascade_model_3.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace mesh_cad {

using mesh_patch::Triangle_tree;

// The largest distance from points of surfaces and edges to the mesh, and the box of these points.
struct Distance_from_shape
{
  double squared = 0;
  CGAL::Bbox_3 box;

  Distance_from_shape& operator+=(const Distance_from_shape& other)
  {
    squared = (std::max)(squared, other.squared);
    box += other.box;
    return *this;
  }
};

// Takes the surface points over the middles of the sides and the centroid of a triangle. What is no more than `negligible`, as the
// rounding of planes, counts as no distance: else all points of planes were searched for.
inline void add_surface_over(const Triangle_corners& c, const CGAL::Open_cascade_surface_3& surface, const Triangle_tree& tree,
                             double negligible, Distance_from_shape& result)
{
  const Kernel::Triangle_3 triangle(c.points[0], c.points[1], c.points[2]);
  for(const auto& w : places_in_triangle()) {
    const Kernel::Point_2 uv = at(c, w);
    const Kernel::Point_3 p = surface.point(uv.x(), uv.y());
    result.box += p.bbox();
    const double found = (std::max)(result.squared, negligible * negligible);
    result.squared = (std::max)(result.squared, mesh_patch::squared_distance_above(found, p, triangle, tree));
  }
}

// Points of the edges of meshed faces.
inline std::vector<Kernel::Point_3> points_of_edges(const Cad_mesh& mesh, const CGAL::Open_cascade_model_3::Model& model)
{
  const int number_of_samples = 64;
  std::set<std::size_t> edges;
  for(const std::size_t face : std::set<std::size_t>(mesh.patch.begin(), mesh.patch.end()))
    for(const auto& loop : model.faces()[face].loops)
      for(const auto& use : loop)
        edges.insert(use.edge);
  std::vector<Kernel::Point_3> result;
  for(const std::size_t e : edges)
    if(model.edges()[e].curve)
      for(int i = 1; i < number_of_samples; ++i)
        result.push_back(model.edges()[e].curve->point(double(i) / number_of_samples));
  return result;
}

template <class ConcurrencyTag>
Distance_from_shape distance_of_points(const std::vector<Kernel::Point_3>& points, const Triangle_tree& tree)
{
  const std::size_t size_of_job = 512;
  std::vector<Distance_from_shape> results((points.size() + size_of_job - 1) / size_of_job);
  CGAL::Parametric_surface_mesher::internal::for_each_index<ConcurrencyTag>(results.size(), [&](std::size_t i) {
    for(std::size_t j = i * size_of_job; j < (std::min)(points.size(), (i + 1) * size_of_job); ++j)
      results[i] += {tree.squared_distance(points[j]), points[j].bbox()};
  });
  Distance_from_shape sum;
  for(const Distance_from_shape& result : results)
    sum += result;
  return sum;
}

// The result does not depend on the number of threads, as the pieces that are measured at the same time do not.
template <class ConcurrencyTag>
Distance_from_shape distance_from_shape(const Cad_mesh& mesh, const CGAL::Open_cascade_model_3& shape)
{
  using namespace CGAL::Parametric_surface_mesher::internal;
  const double negligible = 1e-12 * shape.diagonal;
  if(mesh.mesh.number_of_faces() == 0)
    return {};
  Triangle_tree tree(faces(mesh.mesh).first, faces(mesh.mesh).second, mesh.mesh);
  tree.build();
  tree.accelerate_distance_queries(); // else the first of the threads would do it, and the others wait
  // Curves may not be asked by several threads at the same time.
  const Distance_from_shape of_edges = distance_of_points<ConcurrencyTag>(points_of_edges(mesh, shape.model), tree);
  const auto pieces = pieces_of_patches(mesh.mesh.faces(), [&](auto f) { return mesh.patch[f]; });
  std::vector<Distance_from_shape> results(pieces.size(), of_edges);
  for_each_piece<ConcurrencyTag>(shape.model, pieces, [&](const auto& piece, std::size_t i, const CGAL::Open_cascade_surface_3& surface) {
    for(const auto f : piece.faces)
      add_surface_over(corners(mesh, f), surface, tree, negligible, results[i]);
  });
  Distance_from_shape sum = of_edges;
  for(const Distance_from_shape& result : results)
    sum += result;
  return sum;
}

} // namespace mesh_cad

#endif // DISTANCE_FROM_SHAPE_H
