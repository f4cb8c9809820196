// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_OPPOSITE_TRIANGLES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_OPPOSITE_TRIANGLES_H

#include <CGAL/Node_values_3.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Distances_3.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Piece_tree_3.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// How far the triangles of a mesh are from what is opposite to them, on either side.
class Opposite_triangles
{
  typedef Distance_kernel::Point_3 Point_3;
  typedef Distance_kernel::Vector_3 Vector_3;
  typedef Distance_kernel::Ray_3 Ray_3;
  typedef Distance_kernel::Triangle_3 Triangle_3;
  typedef Piece_tree_3<Distance_kernel, Triangle_3> Tree;

  // The places of a triangle that rays begin at, as weights of its corners.
  static constexpr double places[4][3] = {{1. / 3, 1. / 3, 1. / 3}, {0.8, 0.1, 0.1}, {0.1, 0.8, 0.1}, {0.1, 0.1, 0.8}};
  static constexpr double least_cosine = 0.5; // of the angle between the normals of triangles that are opposite to each other
  // Triangles closer to each other than this share of the longest side touch, as faces of two parts do, and have no room between them.
  static constexpr double share_of_touch = 1e-6;

  const Node_values_3& m_mesh;
  std::vector<Triangle_3> m_triangles;
  std::vector<Vector_3> m_normals; // of length 1, or 0
  Tree m_tree;
  std::vector<double> m_room;

public:
  explicit Opposite_triangles(const Node_values_3& mesh) : m_mesh(mesh)
  {
    for(const auto& triangle : mesh.triangles) {
      const Point_3 p = node(triangle[0]), q = node(triangle[1]), r = node(triangle[2]);
      const Vector_3 normal = cross_product(q - p, r - p);
      const double length = std::sqrt(normal * normal);
      m_triangles.emplace_back(p, q, r);
      m_normals.push_back(length > 0 ? normal / length : normal);
    }
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
      if(m_normals[t] != NULL_VECTOR)
        m_tree.insert(Tree::Primitive(m_triangles[t], t));
    m_tree.build();
  }

  Opposite_triangles(const Opposite_triangles&) = delete;
  Opposite_triangles& operator=(const Opposite_triangles&) = delete;

  // For each triangle the smallest distance, along a normal, of a triangle that is opposite to it; infinity if there is none.
  std::vector<double> room()
  {
    m_room.assign(m_triangles.size(), std::numeric_limits<double>::infinity());
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
      if(m_normals[t] != NULL_VECTOR)
        for(const auto& place : places)
          for(const double side : {1., -1.})
            look(t, place, side * m_normals[t]);
    return m_room;
  }

private:
  Point_3 node(std::size_t i) const { return {m_mesh.nodes[i][0], m_mesh.nodes[i][1], m_mesh.nodes[i][2]}; }

  // What is seen from a triangle has no more room itself.
  void look(std::size_t t, const double (&place)[3], const Vector_3& direction)
  {
    const Triangle_3& triangle = m_triangles[t];
    const Vector_3 from_first = place[1] * (triangle[1] - triangle[0]) + place[2] * (triangle[2] - triangle[0]);
    const Point_3 source = triangle[0] + from_first;
    const double touch = share_of_touch * longest_side(triangle);
    std::vector<std::size_t> touching(1, t);
    for(;;) {
      const auto hit = m_tree.first_intersected_primitive(Ray_3(source, direction), [&](std::size_t other) {
        return std::find(touching.begin(), touching.end(), other) != touching.end();
      });
      if(!hit)
        return;
      const double cosine = m_normals[*hit] * direction,
                   distance = cosine != 0 ? (m_triangles[*hit][0] - source) * m_normals[*hit] / cosine : 0;
      if(distance > touch) {
        if(std::fabs(cosine) >= least_cosine && !have_common_corner(t, *hit)) {
          m_room[t] = (std::min)(m_room[t], distance);
          m_room[*hit] = (std::min)(m_room[*hit], distance);
        }
        return;
      }
      touching.push_back(*hit);
    }
  }

  static double longest_side(const Triangle_3& t)
  {
    return std::sqrt((std::max)({squared_distance(t[0], t[1]), squared_distance(t[1], t[2]), squared_distance(t[2], t[0])}));
  }

  bool have_common_corner(std::size_t a, std::size_t b) const
  {
    const auto &s = m_mesh.triangles[a], &t = m_mesh.triangles[b];
    return std::any_of(s.begin(), s.end(), [&](std::size_t node) { return std::find(t.begin(), t.end(), node) != t.end(); });
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_OPPOSITE_TRIANGLES_H
