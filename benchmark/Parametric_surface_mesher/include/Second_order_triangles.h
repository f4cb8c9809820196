// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Six-node triangles of any program on the faces of a CAD model, and what is measured on them.
#ifndef SECOND_ORDER_TRIANGLES_H
#define SECOND_ORDER_TRIANGLES_H

#include "Mesh_cad_result.h"

#include <CGAL/Parametric_surface_mesher/internal/second_order/Distance_from_surface.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Scaled_jacobian.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// A six-node triangle, and the number of its face in the shape, from 0.
struct Second_order_triangle
{
  typedef mesh_cad::Kernel Kernel;

  CGAL::Parametric_surface_mesher::internal::Quadratic_triangle_3<Kernel> triangle;
  std::size_t shape_face;
};

struct Second_order_quality
{
  double largest = 0, mean = 0;                   // distance of triangles from their surfaces
  double straight_largest = 0, straight_mean = 0; // the same for straight sides
  double smallest_jacobian = std::numeric_limits<double>::infinity();
  std::size_t number_of_triangles = 0;
  std::size_t number_of_invalid_ones = 0; // those whose scaled Jacobian is not proved to be positive
};

// Measures triangles with the surfaces of a model. Where they lie in the domains follows from the closest vertices of a mesh of it.
class Second_order_judge
{
  typedef mesh_cad::Kernel Kernel;
  typedef boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian> Place;

  typedef std::pair<Place, Kernel::Point_2> Known_place; // a vertex of the mesh, with its parameters
  typedef boost::geometry::index::rtree<Known_place, boost::geometry::index::quadratic<16>> Tree;
  typedef CGAL::Parametric_surface_mesher::internal::Quadratic_triangle_3<Kernel> Triangle;

  static const unsigned int subdivisions = 6;

  const Mesh_cad_result& m_result;
  std::map<std::size_t, Tree> m_trees;                            // by face of the model
  std::map<std::size_t, std::vector<std::size_t>> m_model_faces; // by face of the shape: with creases it is several

public:
  // \pre the mesh has the unit of the model
  explicit Second_order_judge(const Mesh_cad_result& result) : m_result(result)
  {
    std::map<std::size_t, std::vector<Known_place>> places;
    const auto& mesh = result.mesh.mesh;
    for(const auto f : mesh.faces())
      for(const auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
        places[result.mesh.patch[f]].emplace_back(place(mesh.point(mesh.target(h))), result.mesh.uv[h]);
    for(const auto& face : places) {
      m_trees.emplace(face.first, Tree(face.second.begin(), face.second.end()));
      m_model_faces[result.shape.shape_faces[face.first]].push_back(face.first);
    }
  }

  // Triangles on faces that the mesh does not have are not measured.
  Second_order_quality operator()(const std::vector<Second_order_triangle>& triangles) const
  {
    Second_order_quality result;
    for(const Second_order_triangle& t : triangles) {
      const auto faces = m_model_faces.find(t.shape_face);
      if(faces == m_model_faces.end())
        continue;
      ++result.number_of_triangles;
      add_jacobian(t.triangle, result);
      add_distances(t.triangle, faces->second, result);
    }
    result.mean /= double(result.number_of_triangles);
    result.straight_mean /= double(result.number_of_triangles);
    return result;
  }

private:
  static Place place(const Kernel::Point_3& p) { return Place(p.x(), p.y(), p.z()); }

  static void add_jacobian(const Triangle& triangle, Second_order_quality& result)
  {
    const double jacobian = CGAL::Parametric_surface_mesher::internal::scaled_jacobian(triangle, triangle.straight_normal());
    result.number_of_invalid_ones += !(jacobian > 0);
    result.smallest_jacobian = (std::min)(result.smallest_jacobian, jacobian);
  }

  void add_distances(const Triangle& triangle, const std::vector<std::size_t>& faces, Second_order_quality& result) const
  {
    using CGAL::Parametric_surface_mesher::internal::straight_middle;
    const auto& p = triangle.nodes();
    const Triangle straight({p[0], p[1], p[2], straight_middle(p[0], p[1]), straight_middle(p[1], p[2]), straight_middle(p[2], p[0])});
    const double curved_distance = distance(triangle, faces), straight_distance = distance(straight, faces);
    result.largest = (std::max)(result.largest, curved_distance);
    result.straight_largest = (std::max)(result.straight_largest, straight_distance);
    result.mean += curved_distance;
    result.straight_mean += straight_distance;
  }

  // From the closest one of some faces.
  double distance(const Triangle& triangle, const std::vector<std::size_t>& faces) const
  {
    using namespace CGAL::Parametric_surface_mesher::internal;
    double result = std::numeric_limits<double>::infinity();
    for(const std::size_t face : faces) {
      const auto& surface = m_result.shape.model.faces()[face].surface;
      std::array<Kernel::Point_2, 3> uv;
      for(std::size_t i = 0; i < 3; ++i)
        uv[i] = parameters(triangle, i, surface, m_trees.find(face)->second);
      result = (std::min)(result, Distance_from_surface<CGAL::Open_cascade_surface_3>(surface, subdivisions)(triangle, uv));
    }
    return result;
  }

  // Those of a corner.
  static Kernel::Point_2 parameters(const Triangle& triangle, std::size_t corner, const CGAL::Open_cascade_surface_3& surface, const Tree& tree)
  {
    using namespace CGAL::Parametric_surface_mesher::internal;
    const Kernel::Point_3& p = triangle.nodes()[corner];
    const Kernel::Point_2 start = tree.qbegin(boost::geometry::index::nearest(place(p), 1))->second;
    const double size = std::sqrt(CGAL::squared_distance(p, triangle.nodes()[(corner + 1) % 3]));
    const auto foot = find_on_surface(surface, start, p, size, Tangent_directions());
    const auto squared = [&](const Kernel::Point_2& uv) { return CGAL::squared_distance(p, surface.point(uv.x(), uv.y())); };
    return foot && squared(*foot) < squared(start) ? *foot : start;
  }
};

// The six-node triangles in a file of Gmsh, version 2.2: their entity is the face.
inline std::vector<Second_order_triangle> read_second_order_msh(const std::string& file_name)
{
  const int type_of_triangle = 9;
  std::vector<Second_order_triangle> result;
  std::map<std::size_t, mesh_cad::Kernel::Point_3> nodes;
  std::ifstream in(file_name);
  std::string line;
  const auto skip_to = [&](const char* title) {
    while(std::getline(in, line) && line.compare(0, std::string(title).size(), title) != 0) {
    }
    std::size_t number = 0;
    in >> number;
    return number;
  };
  for(std::size_t n = skip_to("$Nodes"), number = 0; n > 0; --n) {
    double x, y, z;
    in >> number >> x >> y >> z;
    nodes[number] = {x, y, z};
  }
  const std::size_t number_of_elements = skip_to("$Elements");
  std::getline(in, line);
  for(std::size_t n = number_of_elements; n > 0 && std::getline(in, line); --n) {
    std::istringstream element(line);
    std::size_t number, number_of_tags, group, entity, node;
    int type;
    element >> number >> type >> number_of_tags >> group >> entity;
    if(type != type_of_triangle)
      continue;
    for(std::size_t ignored; number_of_tags > 2; --number_of_tags)
      element >> ignored;
    std::array<mesh_cad::Kernel::Point_3, 6> points;
    for(auto& p : points) {
      element >> node;
      p = nodes[node];
    }
    result.push_back({CGAL::Parametric_surface_mesher::internal::Quadratic_triangle_3<mesh_cad::Kernel>(points), entity - 1});
  }
  return result;
}

#endif // SECOND_ORDER_TRIANGLES_H
