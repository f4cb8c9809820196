// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What mesh_cad measures on its mesh beyond CGAL::triangle_mesh_quality().
#ifndef MEASURE_CAD_MESH_H
#define MEASURE_CAD_MESH_H

#include "Aabb_tree_types.h"
#include "sharp_corners.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_surface_mesh_parameters.h>
#include <CGAL/Parametric_surface_mesher/Model_places.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/model/inner_elements.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

// A mesh with the face of the model that each triangle lies on, its corners in the domain of that face, and the pieces of edges.
struct Cad_mesh
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

  Mesh mesh;
  Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2> uv
    = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  Mesh::Property_map<Mesh::Face_index, std::size_t> patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;
  Mesh::Property_map<Mesh::Vertex_index, CGAL::Parametric_surface_mesher::Vertex_place> vertex_place
    = mesh.add_property_map<Mesh::Vertex_index, CGAL::Parametric_surface_mesher::Vertex_place>("v:place").first;
  Mesh::Property_map<Mesh::Edge_index, CGAL::Parametric_surface_mesher::Edge_place> edge_place
    = mesh.add_property_map<Mesh::Edge_index, CGAL::Parametric_surface_mesher::Edge_place>("e:place").first;
  Mesh::Property_map<Mesh::Edge_index, Kernel::Point_3> mid_side_nodes; // there are some if the elements are of second order

  // Where its elements lie in the model, as named parameters, with others.
  template <class... NamedParameters>
  auto places(const NamedParameters&... others) const
  {
    namespace parameters = CGAL::parameters;
    return parameters::halfedge_uv_map(
      uv, parameters::face_patch_id_map(patch, parameters::vertex_place_map(vertex_place, parameters::edge_place_map(edge_place, others...))));
  }
};

struct Cad_mesh_measures
{
  double distance = 0; // the largest one from sampled points of surfaces and edges to the mesh
  double min_angle_apart = 180; // the smallest angle, apart from those in sharp corners of faces
  std::size_t below_10 = 0, below_10_at_corners = 0; // triangles with an angle below 10 degrees
  std::size_t border_edges = 0;
  std::vector<std::size_t> tiny_edges;   // edges of the model that are shorter than 1e-3 of the diagonal
  std::vector<std::size_t> sliver_faces; // faces of the model with 4 pi area / perimeter^2 below 0.01
};

namespace mesh_cad {

typedef Cad_mesh::Kernel Kernel;
typedef Aabb_tree<Kernel, CGAL::AABB_face_graph_triangle_primitive<Cad_mesh::Mesh>> Tree;

// The corners of a triangle: in space, and in the domain of its face.
struct Triangle_corners
{
  std::array<Kernel::Point_3, 3> points;
  std::array<Kernel::Point_2, 3> uv;
};

inline Triangle_corners corners(const Cad_mesh& mesh, Cad_mesh::Mesh::Face_index face)
{
  Triangle_corners result;
  std::size_t i = 0;
  for(const auto h : mesh.mesh.halfedges_around_face(mesh.mesh.halfedge(face))) {
    result.points[i] = mesh.mesh.point(mesh.mesh.target(h));
    result.uv[i++] = mesh.uv[h];
  }
  return result;
}

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

// The middles of the sides and the centroid of a triangle, in barycentric coordinates.
inline std::array<std::array<double, 3>, 4> places_in_triangle()
{
  return {{{0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {1. / 3, 1. / 3, 1. / 3}}};
}

inline Kernel::Point_2 at(const Triangle_corners& c, const std::array<double, 3>& w)
{
  return Kernel::Point_2(w[0] * c.uv[0].x() + w[1] * c.uv[1].x() + w[2] * c.uv[2].x(), w[0] * c.uv[0].y() + w[1] * c.uv[1].y() + w[2] * c.uv[2].y());
}

// The largest squared distance, if it is above `known`, between the mesh and the surface points over the middles of the sides and the
// centroid. The distance to the triangle itself is usually short enough; around poles another triangle may be closer.
inline double squared_distance_to_surface(const Triangle_corners& c, const CGAL::Open_cascade_surface_3& surface,
                                          const Tree& tree, double known)
{
  const Kernel::Triangle_3 triangle(c.points[0], c.points[1], c.points[2]);
  double result = known;
  for(const auto& w : places_in_triangle()) {
    const Kernel::Point_2 uv = at(c, w);
    const Kernel::Point_3 p = surface.point(uv.x(), uv.y());
    if(CGAL::squared_distance(p, triangle) > result)
      result = (std::max)(result, tree.squared_distance(p));
  }
  return result;
}

// The largest squared distance of points of the edges of meshed faces to the mesh.
inline double squared_distance_to_edges(const Cad_mesh& mesh, const Model& model, const Tree& tree)
{
  const int number_of_samples = 64;
  std::set<std::size_t> edges;
  for(const std::size_t face : std::set<std::size_t>(mesh.patch.begin(), mesh.patch.end()))
    for(const auto& loop : model.faces()[face].loops)
      for(const auto& use : loop)
        edges.insert(use.edge);
  double result = 0;
  for(const std::size_t e : edges)
    if(model.edges()[e].curve)
      for(int i = 1; i < number_of_samples; ++i)
        result = (std::max)(result, tree.squared_distance(model.edges()[e].curve->point(double(i) / number_of_samples)));
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

inline Cad_mesh_measures measure(const Cad_mesh& mesh, const CGAL::Open_cascade_model_3& shape, double min_edge)
{
  const double small_angle = 10, sharp_angle = 30; // degrees
  Cad_mesh_measures result;
  const Sharp_corners sharp = sharp_corners(shape.model, sharp_angle, min_edge);
  const Tree tree(faces(mesh.mesh).first, faces(mesh.mesh).second, mesh.mesh);
  double squared_distance = squared_distance_to_edges(mesh, shape.model, tree);
  for(const auto face : mesh.mesh.faces()) {
    const Triangle_corners c = corners(mesh, face);
    const std::size_t patch = mesh.patch[face];
    squared_distance = squared_distance_to_surface(c, shape.model.faces()[patch].surface, tree, squared_distance);
    const auto smallest = smallest_angle(c.points);
    const auto corner = sharp.find({patch, c.points[smallest.first]});
    if(smallest.second < small_angle) {
      ++result.below_10;
      result.below_10_at_corners += corner != sharp.end() && corner->second <= small_angle;
    }
    if(corner == sharp.end() || smallest.second < 0.8 * corner->second) // a corner that is divided has more than one triangle
      result.min_angle_apart = (std::min)(result.min_angle_apart, smallest.second);
  }
  result.distance = std::sqrt(squared_distance);
  measure_shape(mesh, shape, result);
  for(const auto h : mesh.mesh.halfedges())
    result.border_edges += mesh.mesh.is_border(h);
  return result;
}

} // namespace mesh_cad

#endif // MEASURE_CAD_MESH_H
