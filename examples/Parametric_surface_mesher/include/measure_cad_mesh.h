// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What mesh_cad measures on its mesh beyond CGAL::triangle_mesh_quality().
#ifndef MEASURE_CAD_MESH_H
#define MEASURE_CAD_MESH_H

#include "Cad_mesh.h"
#include "Distance_from_shape.h"
#include "sharp_corners.h"

#include <CGAL/Bbox_3.h>

#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/model/inner_elements.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

struct Cad_mesh_measures
{
  double distance = 0; // the largest one from sampled points of surfaces and edges to the mesh, if it was measured
  CGAL::Bbox_3 box;    // of the mesh and of these points
  double min_angle_apart = 180; // the smallest angle, apart from those in sharp corners of faces
  std::size_t below_10 = 0, below_10_at_corners = 0; // triangles with an angle below 10 degrees
  std::size_t border_edges = 0;
  std::vector<std::size_t> tiny_edges;   // edges of the model that are shorter than 1e-3 of the diagonal
  std::vector<std::size_t> sliver_faces; // faces of the model with 4 pi area / perimeter^2 below 0.01
};

namespace mesh_cad {

// The number and size of the smallest angle.
inline std::pair<std::size_t, double> smallest_angle(const std::array<Kernel::Point_3, 3>& p)
{
  std::pair<std::size_t, double> result(0, 180);
  for(std::size_t i = 0; i < 3; ++i) {
    const double a = angle(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
    if(a < result.second)
      result = {i, a};
  }
  return result;
}

inline double length(const Kernel::Vector_3& v) { return std::sqrt(v.squared_length()); }

// The length of an edge, by the chords between some of its points.
inline double length(const Model::Edge& edge)
{
  const int number_of_samples = 32;
  double result = 0;
  if(edge.curve)
    for(int i = 0; i < number_of_samples; ++i)
      result += length(edge.curve->point(double(i + 1) / number_of_samples) - edge.curve->point(double(i) / number_of_samples));
  return result;
}

// Finds what makes small angles unavoidable.
inline void measure_shape(const Cad_mesh& mesh, const CGAL::Open_cascade_model_3& shape, Cad_mesh_measures& result)
{
  const Model& model = shape.model;
  std::vector<double> lengths, areas(model.faces().size()), perimeters(model.faces().size());
  for(const auto& edge : model.edges())
    lengths.push_back(length(edge));
  for(const auto face : mesh.mesh.faces()) {
    const auto p = corners(mesh, face).points;
    areas[mesh.patch[face]] += 0.5 * length(CGAL::cross_product(p[1] - p[0], p[2] - p[0]));
  }
  std::set<std::size_t> tiny;
  for(std::size_t f = 0; f < model.faces().size(); ++f) {
    for(const auto& loop : model.faces()[f].loops)
      for(const auto& use : loop) {
        if(!CGAL::Parametric_surface_mesher::internal::is_inner_edge(loop))
          perimeters[f] += lengths[use.edge];
        if(!model.edges()[use.edge].is_collapsed && lengths[use.edge] < 1e-3 * shape.diagonal)
          tiny.insert(use.edge);
      }
    if(16 * std::atan(1.) * areas[f] < 0.01 * CGAL::square(perimeters[f]))
      result.sliver_faces.push_back(f);
  }
  result.tiny_edges.assign(tiny.begin(), tiny.end());
}

// Angles, and what is small. The distance from the shape is measured apart from this.
inline Cad_mesh_measures measure(const Cad_mesh& mesh, const CGAL::Open_cascade_model_3& shape, double min_edge)
{
  const double small_angle = 10, sharp_angle = 30; // degrees
  Cad_mesh_measures result;
  const Sharp_corners sharp = sharp_corners(shape.model, sharp_angle, min_edge);
  for(const auto v : mesh.mesh.vertices())
    result.box += mesh.mesh.point(v).bbox();
  for(const auto face : mesh.mesh.faces()) {
    const Triangle_corners c = corners(mesh, face);
    const auto smallest = smallest_angle(c.points);
    const auto corner = sharp.find({mesh.patch[face], c.points[smallest.first]});
    if(smallest.second < small_angle) {
      ++result.below_10;
      result.below_10_at_corners += corner != sharp.end() && corner->second <= small_angle;
    }
    if(corner == sharp.end() || smallest.second < 0.8 * corner->second) // a corner that is divided has more than one triangle
      result.min_angle_apart = (std::min)(result.min_angle_apart, smallest.second);
  }
  measure_shape(mesh, shape, result);
  for(const auto h : mesh.mesh.halfedges())
    result.border_edges += mesh.mesh.is_border(h);
  return result;
}

// The largest distance of surfaces and edges from the mesh. Their points count for the box, too, which the vertices do not fill.
template <class ConcurrencyTag>
void measure_distance(const Cad_mesh& mesh, const CGAL::Open_cascade_model_3& shape, Cad_mesh_measures& result)
{
  const Distance_from_shape distance = distance_from_shape<ConcurrencyTag>(mesh, shape);
  result.distance = std::sqrt(distance.squared);
  result.box += distance.box;
}

} // namespace mesh_cad

#endif // MEASURE_CAD_MESH_H
