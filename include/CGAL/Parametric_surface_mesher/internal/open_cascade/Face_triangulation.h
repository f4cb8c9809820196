// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_FACE_TRIANGULATION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_FACE_TRIANGULATION_H

#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The nodes and triangles of one face, as they are collected. A vertex of a mesh is several nodes where the face has it with several
// parameters: at a seam and at a pole.
template <class Vertex>
class Face_triangulation
{
  static constexpr double same_parameter = 1e-9; // relative

  struct Node
  {
    gp_Pnt point; // in the place of the face
    gp_Pnt2d uv;
  };

  std::vector<Node> m_nodes;
  std::vector<std::array<int, 3>> m_triangles;
  std::multimap<Vertex, int> m_nodes_of_vertices;

public:
  bool is_empty() const { return m_triangles.empty(); }
  const gp_Pnt2d& uv(int node) const { return m_nodes[std::size_t(node) - 1].uv; }

  // Returns the number of a node, from 1. The node is added if it is new.
  int node(Vertex vertex, const gp_Pnt& point, const gp_Pnt2d& uv)
  {
    const auto known = m_nodes_of_vertices.equal_range(vertex);
    for(auto i = known.first; i != known.second; ++i)
      if(are_equal(this->uv(i->second), uv))
        return i->second;
    m_nodes.push_back({point, uv});
    m_nodes_of_vertices.emplace(vertex, int(m_nodes.size()));
    return int(m_nodes.size());
  }

  // The nodes are counterclockwise in the domain.
  void add_triangle(const std::array<int, 3>& nodes) { m_triangles.push_back(nodes); }

  std::vector<int> nodes_of(Vertex vertex) const
  {
    std::vector<int> result;
    const auto known = m_nodes_of_vertices.equal_range(vertex);
    for(auto i = known.first; i != known.second; ++i)
      result.push_back(i->second);
    return result;
  }

  // `place`: that of the face. `distance`: from the surface
  Handle(Poly_Triangulation) finished(const gp_Trsf& place, double distance) const
  {
    const gp_Trsf from_place = place.Inverted();
    Handle(Poly_Triangulation) result = new Poly_Triangulation(int(m_nodes.size()), int(m_triangles.size()), true);
    for(std::size_t i = 0; i < m_nodes.size(); ++i) {
      result->SetNode(int(i) + 1, m_nodes[i].point.Transformed(from_place));
      result->SetUVNode(int(i) + 1, m_nodes[i].uv);
    }
    for(std::size_t i = 0; i < m_triangles.size(); ++i)
      result->SetTriangle(int(i) + 1, Poly_Triangle(m_triangles[i][0], m_triangles[i][1], m_triangles[i][2]));
    result->Deflection(distance);
    return result;
  }

private:
  static bool are_equal(double a, double b) { return std::fabs(a - b) <= same_parameter * (1 + std::fabs(a)); }
  static bool are_equal(const gp_Pnt2d& a, const gp_Pnt2d& b) { return are_equal(a.X(), b.X()) && are_equal(a.Y(), b.Y()); }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_FACE_TRIANGULATION_H
