// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_FACE_TRIANGULATION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_FACE_TRIANGULATION_H

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <ElSLib.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Sphere.hxx>
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

// The parameters of points of a sphere, in the way of Open CASCADE: for faces that are meshed in other parameters.
class Sphere_parameters
{
  static constexpr double pole = 1e-7; // cosine of a latitude at which the longitude has no meaning

  gp_Sphere m_sphere;
  double m_u_min = 0, m_u_max = 0;

public:
  explicit Sphere_parameters(const TopoDS_Face& face) : m_sphere(BRepAdaptor_Surface(face, false).Sphere())
  {
    double v_min = 0, v_max = 0;
    BRepTools::UVBounds(face, m_u_min, m_u_max, v_min, v_max);
  }

  // Those of the corners of a triangle. All of them are in one period, and that of the face where this is possible. A corner at a pole has
  // the longitude between those of the others.
  std::array<gp_Pnt2d, 3> operator()(const std::array<gp_Pnt, 3>& corners) const
  {
    std::array<double, 3> u, v;
    std::array<bool, 3> is_pole;
    for(std::size_t i = 0; i < 3; ++i) {
      ElSLib::Parameters(m_sphere, corners[i], u[i], v[i]);
      is_pole[i] = std::cos(v[i]) < pole;
    }
    const std::size_t first = is_pole[0] ? 1 : 0;
    for(std::size_t i = 0; i < 3; ++i)
      u[i] = nearest_turn(u[i], u[first]);
    for(std::size_t i = 0; i < 3; ++i)
      if(is_pole[i])
        u[i] = 0.5 * (u[(i + 1) % 3] + u[(i + 2) % 3]);
    const double mean = (u[0] + u[1] + u[2]) / 3, shift = nearest_turn(mean, 0.5 * (m_u_min + m_u_max)) - mean;
    return {gp_Pnt2d(u[0] + shift, v[0]), gp_Pnt2d(u[1] + shift, v[1]), gp_Pnt2d(u[2] + shift, v[2])};
  }

private:
  static double nearest_turn(double angle, double other)
  {
    const double turn = 8 * std::atan(1.);
    return angle - turn * std::round((angle - other) / turn);
  }
};

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

  // The number of a node, from 1, that is added if it is new.
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

  // Counterclockwise in the domain.
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
