// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_SIMPLEX_LOCATION_3_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_SIMPLEX_LOCATION_3_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Node_values_3.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Distances_3.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Piece_tree_3.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Values between the nodes of a mesh of triangles and tetrahedra.
// Whether a point is in a tetrahedron is decided by an exact predicate. With rounded numbers, a point between two tetrahedra could be in
// none of them, and would get the value of a point on the boundary of the mesh.
// Degenerate triangles and tetrahedra are left out, since others have their nodes.
class Simplex_location_3
{
  typedef Exact_predicates_inexact_constructions_kernel Exact_kernel;
  typedef std::array<std::size_t, 3> Triangle;
  typedef std::array<std::size_t, 4> Tetrahedron;
  typedef Piece_tree_3<Exact_kernel, Exact_kernel::Tetrahedron_3> Tetrahedron_tree;

  std::vector<double> m_values;
  std::vector<Distance_kernel::Point_3> m_nodes;
  std::vector<Triangle> m_triangles;     // those in the tree
  std::vector<Tetrahedron> m_tetrahedra; // those in the tree
  Piece_tree_3<Distance_kernel, Distance_kernel::Triangle_3> m_triangle_tree;
  Tetrahedron_tree m_tetrahedron_tree;

public:
  explicit Simplex_location_3(const Node_values_3& mesh) : m_values(mesh.values)
  {
    for(std::size_t i = 0; i < mesh.nodes.size(); ++i)
      m_nodes.push_back(node<Distance_kernel>(mesh, i));
    add_tetrahedra(mesh);
    add_triangles(mesh, mesh.triangles);
    add_triangles(mesh, boundary_of(mesh.tetrahedra));
    m_triangle_tree.build();
    m_triangle_tree.accelerate_distance_queries();
  }

  Simplex_location_3(const Simplex_location_3&) = delete;
  Simplex_location_3& operator=(const Simplex_location_3&) = delete;

  // Whether there is no place with a value.
  bool is_empty() const { return m_triangles.empty(); }

  double value(const std::array<double, 3>& p) const
  {
    if(!m_tetrahedra.empty()) {
      const Exact_kernel::Point_3 q(p[0], p[1], p[2]);
      Any_piece_traversal<Tetrahedron_tree> traversal(m_tetrahedron_tree);
      m_tetrahedron_tree.traversal(q, traversal);
      if(traversal.is_found())
        return value_in_tetrahedron(traversal.number(), distance_point(q));
    }
    const auto closest = m_triangle_tree.closest_point_and_primitive(Distance_kernel::Point_3(p[0], p[1], p[2]));
    return value_on_triangle(closest.second, closest.first);
  }

private:
  template <class Kernel>
  static typename Kernel::Point_3 node(const Node_values_3& mesh, std::size_t i)
  {
    return typename Kernel::Point_3(mesh.nodes[i][0], mesh.nodes[i][1], mesh.nodes[i][2]);
  }

  void add_tetrahedra(const Node_values_3& mesh)
  {
    for(const Tetrahedron& t : mesh.tetrahedra) {
      const Exact_kernel::Tetrahedron_3 piece(node<Exact_kernel>(mesh, t[0]), node<Exact_kernel>(mesh, t[1]),
                                              node<Exact_kernel>(mesh, t[2]), node<Exact_kernel>(mesh, t[3]));
      if(piece.is_degenerate())
        continue;
      m_tetrahedron_tree.insert(Numbered_piece_3<Exact_kernel, Exact_kernel::Tetrahedron_3>(piece, m_tetrahedra.size()));
      m_tetrahedra.push_back(t);
    }
    m_tetrahedron_tree.build();
  }

  void add_triangles(const Node_values_3& mesh, const std::vector<Triangle>& triangles)
  {
    for(const Triangle& t : triangles) {
      const Distance_kernel::Triangle_3 piece(node<Distance_kernel>(mesh, t[0]), node<Distance_kernel>(mesh, t[1]),
                                              node<Distance_kernel>(mesh, t[2]));
      if(!(piece.squared_area() > 0))
        continue;
      m_triangle_tree.insert(Numbered_piece_3<Distance_kernel, Distance_kernel::Triangle_3>(piece, m_triangles.size()));
      m_triangles.push_back(t);
    }
  }

  // The sides that no two tetrahedra have.
  static std::vector<Triangle> boundary_of(const std::vector<Tetrahedron>& tetrahedra)
  {
    std::map<Triangle, std::size_t> numbers;
    for(const Tetrahedron& t : tetrahedra)
      for(std::size_t i = 0; i < 4; ++i) {
        Triangle side{{t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]}};
        std::sort(side.begin(), side.end());
        ++numbers[side];
      }
    std::vector<Triangle> result;
    for(const auto& side : numbers)
      if(side.second == 1)
        result.push_back(side.first);
    return result;
  }

  // The mean of values, weighted by areas or volumes. Weights that are negative by rounding do not lead beyond the values, and the mean of
  // equal values is exactly that value: faces where nothing changes are not meshed again. Where rounding leaves no weights, it is the least
  // value.
  template <class Simplex>
  double mean(const Simplex& simplex, std::array<double, std::tuple_size<Simplex>::value> weights) const
  {
    double sum = 0, difference = 0;
    for(std::size_t i = 0; i < weights.size(); ++i) {
      weights[i] = (std::max)(weights[i], 0.);
      sum += weights[i];
      difference += weights[i] * (m_values[simplex[i]] - m_values[simplex[0]]);
    }
    if(sum > 0 && std::isfinite(sum))
      return m_values[simplex[0]] + difference / sum;
    double least = m_values[simplex[0]];
    for(const std::size_t node : simplex)
      least = (std::min)(least, m_values[node]);
    return least;
  }

  double value_in_tetrahedron(std::size_t number, const Distance_kernel::Point_3& p) const
  {
    const Tetrahedron& t = m_tetrahedra[number];
    const std::array<Distance_kernel::Point_3, 4> corners{{m_nodes[t[0]], m_nodes[t[1]], m_nodes[t[2]], m_nodes[t[3]]}};
    const double whole = volume(corners[0], corners[1], corners[2], corners[3]);
    std::array<double, 4> weights;
    for(std::size_t i = 0; i < 4; ++i) {
      auto with_p = corners; // what is opposite to the corner
      with_p[i] = p;
      weights[i] = volume(with_p[0], with_p[1], with_p[2], with_p[3]) / whole;
    }
    return mean(t, weights);
  }

  double value_on_triangle(std::size_t number, const Distance_kernel::Point_3& p) const
  {
    const Triangle& t = m_triangles[number];
    const std::array<Distance_kernel::Point_3, 3> corners{{m_nodes[t[0]], m_nodes[t[1]], m_nodes[t[2]]}};
    const auto normal = cross_product(corners[1] - corners[0], corners[2] - corners[0]);
    std::array<double, 3> weights;
    for(std::size_t i = 0; i < 3; ++i)
      weights[i] = cross_product(corners[(i + 1) % 3] - p, corners[(i + 2) % 3] - p) * normal;
    return mean(t, weights);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_SIMPLEX_LOCATION_3_H
