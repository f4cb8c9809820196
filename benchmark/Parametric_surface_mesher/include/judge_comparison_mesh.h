// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a mesh of a comparison is like, by measures that know nothing of the mesher.
#ifndef JUDGE_COMPARISON_MESH_H
#define JUDGE_COMPARISON_MESH_H

#include "Aabb_tree_types.h"
#include "Comparison_shape.h"
#include "Sample_mesher.h"

#include <CGAL/Triangle_mesh_quality.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// (It goes through a pipe: plain data.)
struct Comparison_verdict
{
  double faces, min_angle, mean_min_angle, mean_radius_ratio;
  double share_below_30_degrees; // of the triangles, by their smallest angles
  double distance;               // the largest one, from the mesh to the surface and back
  double share_of_rims;          // that edges of the mesh follow
  std::array<double, 60> smallest_angles; // numbers of triangles, by degrees
};

namespace comparison {

typedef cgal_meshers::Point_3 Point_3;
typedef Sample_kernel::Vector_3 Vector_3;
typedef Sample_kernel::Triangle_3 Triangle_3;

inline std::vector<Triangle_3> triangles_of(const Sample_mesh& mesh)
{
  std::vector<Triangle_3> triangles;
  triangles.reserve(mesh.number_of_faces());
  for(const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    triangles.emplace_back(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))));
  }
  return triangles;
}

inline double smallest_angle(const Triangle_3& t)
{
  double smallest = 60;
  for(int i = 0; i < 3; ++i)
    smallest = (std::min)(smallest, CGAL::approximate_angle(t[i + 1], t[i], t[i + 2]));
  return smallest;
}

// from points all over a triangle to the surface, the largest distance
inline double distance_from_triangle(const Triangle_3& t, const cgal_meshers::Distance& distance)
{
  const int parts = 4; // of each side
  double largest = 0;
  for(int i = 0; i <= parts; ++i)
    for(int j = 0; i + j <= parts; ++j) {
      const Vector_3 to_second = t[1] - t[0], to_third = t[2] - t[0];
      largest = (std::max)(largest, std::abs(distance(t[0] + (1. * i / parts) * to_second + (1. * j / parts) * to_third)));
    }
  return largest;
}

// from points of the surface to the triangles, the largest distance
inline double distance_to_triangles(const std::vector<Point_3>& points, const std::vector<Triangle_3>& triangles)
{
  typedef Aabb_triangle_primitive<Sample_kernel, std::vector<Triangle_3>::const_iterator> Primitive;
  Aabb_tree<Sample_kernel, Primitive> tree(triangles.begin(), triangles.end());
  double largest = 0;
  for(const Point_3& p : points)
    largest = (std::max)(largest, tree.squared_distance(p));
  return std::sqrt(largest);
}

inline bool is_on_rim(const Point_3& p, double height, double tolerance)
{
  return std::hypot(std::hypot(p.x(), p.y()) - 1, p.z() - height) < tolerance;
}

inline bool is_on_a_rim(const Point_3& p, const Comparison_shape& shape, double tolerance)
{
  return std::any_of(shape.rims.begin(), shape.rims.end(), [&](double height) { return is_on_rim(p, height, tolerance); });
}

// Points of the surface: vertices of a fine mesh, all of those on rims and at most some 40000 others.
inline std::vector<Point_3> points_of_surface(const Sample_mesh& fine, const Comparison_shape& shape)
{
  const std::size_t step = fine.number_of_vertices() / 40000 + 1;
  std::vector<Point_3> points;
  for(const auto v : fine.vertices())
    if(static_cast<std::size_t>(v) % step == 0 || is_on_a_rim(fine.point(v), shape, 1e-9))
      points.push_back(fine.point(v));
  return points;
}

// the angle between the normals of the triangles beside an edge, in degrees
inline double bend_at(const Sample_mesh& mesh, Sample_mesh::Halfedge_index h)
{
  const auto point = [&](Sample_mesh::Halfedge_index g) { return mesh.point(mesh.target(g)); };
  const auto opposite = mesh.opposite(h);
  return 180 - std::abs(CGAL::approximate_dihedral_angle(point(opposite), point(h), point(mesh.next(h)), point(mesh.next(opposite))));
}

// The parts of a circle, by angles.
class Covered_circle
{
  std::vector<char> m_is_covered = std::vector<char>(3600, false);

public:
  void cover(const Point_3& p, const Point_3& q)
  {
    const double size = static_cast<double>(m_is_covered.size()), turn = 2 * sample_surfaces::pi;
    double first = std::atan2(p.y(), p.x()), length = std::atan2(q.y(), q.x()) - first;
    length -= turn * std::round(length / turn);
    if(length < 0)
      first += length, length = -length;
    const auto begin = static_cast<std::ptrdiff_t>(std::round(first / turn * size));
    const auto end = static_cast<std::ptrdiff_t>(std::round((first + length) / turn * size));
    for(std::ptrdiff_t i = begin; i < end; ++i)
      m_is_covered[(i + m_is_covered.size()) % m_is_covered.size()] = true;
  }

  double share() const
  {
    return static_cast<double>(std::count(m_is_covered.begin(), m_is_covered.end(), true)) / static_cast<double>(m_is_covered.size());
  }
};

// The share of the rims that sharp edges of the mesh follow: both ends are on the rim.
inline double share_of_rims(const Sample_mesh& mesh, const Comparison_shape& shape)
{
  const double sharp = 30, tolerance = 2e-4;
  double sum = 0;
  for(const double height : shape.rims) {
    Covered_circle circle;
    for(const auto e : mesh.edges()) {
      const Point_3 p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
      if(is_on_rim(p, height, tolerance) && is_on_rim(q, height, tolerance) && !mesh.is_border(e)
         && bend_at(mesh, mesh.halfedge(e)) > sharp)
        circle.cover(p, q);
    }
    sum += circle.share();
  }
  return shape.rims.empty() ? 0 : sum / static_cast<double>(shape.rims.size());
}

} // namespace comparison

// `points` are on the surface.
inline Comparison_verdict judge_comparison_mesh(const Sample_mesh& mesh, const Comparison_shape& shape,
                                                const std::vector<comparison::Point_3>& points)
{
  const CGAL::Triangle_mesh_quality quality = CGAL::triangle_mesh_quality(mesh);
  Comparison_verdict verdict{};
  verdict.faces = static_cast<double>(quality.number_of_faces);
  verdict.min_angle = quality.min_angle;
  verdict.mean_min_angle = quality.mean_min_angle;
  verdict.mean_radius_ratio = quality.mean_radius_ratio;
  const std::vector<comparison::Triangle_3> triangles = comparison::triangles_of(mesh);
  for(const comparison::Triangle_3& t : triangles) {
    const double angle = comparison::smallest_angle(t);
    verdict.share_below_30_degrees += (angle < 30) / verdict.faces;
    ++verdict.smallest_angles[(std::min)(static_cast<std::size_t>(angle), verdict.smallest_angles.size() - 1)];
    verdict.distance = (std::max)(verdict.distance, comparison::distance_from_triangle(t, shape.distance));
  }
  verdict.distance = (std::max)(verdict.distance, comparison::distance_to_triangles(points, triangles));
  verdict.share_of_rims = comparison::share_of_rims(mesh, shape);
  return verdict;
}

#endif // JUDGE_COMPARISON_MESH_H
