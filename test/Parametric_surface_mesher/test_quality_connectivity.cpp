// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

// Every expected number is worked out by hand in a comment beside it.

#include <CGAL/Triangle_mesh_quality.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <quality_test_helpers.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace {

Mesh mesh_of(const Points& points, const Triangles& triangles)
{
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}

// The strip of `2n` triangles between the rows `(i, 0)` and `(i, 1)`, closed to a ring if `is_ring`.
std::pair<Points, Triangles> strip(std::size_t n, bool is_ring)
{
  std::pair<Points, Triangles> soup;
  const std::size_t columns = is_ring ? n : n + 1;
  for(std::size_t i = 0; i < columns; ++i)
    for(int row = 0; row < 2; ++row)
      soup.first.push_back(is_ring ? Point_3(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), row)
                                   : Point_3(double(i), row, 0));
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::size_t a = 2 * i, b = 2 * ((i + 1) % columns);
    soup.second.push_back({{a, b, b + 1}});
    soup.second.push_back({{a, b + 1, a + 1}});
  }
  return soup;
}

void expect_same(const CGAL::Triangle_mesh_quality& a, const CGAL::Triangle_mesh_quality& b)
{
  EXPECT_EQ(a.number_of_vertices, b.number_of_vertices);
  EXPECT_EQ(a.number_of_edges, b.number_of_edges);
  EXPECT_EQ(a.number_of_faces, b.number_of_faces);
  EXPECT_EQ(a.number_of_border_edges, b.number_of_border_edges);
  EXPECT_EQ(a.number_of_boundary_cycles, b.number_of_boundary_cycles);
  EXPECT_EQ(a.number_of_connected_components, b.number_of_connected_components);
  EXPECT_EQ(a.number_of_isolated_vertices, b.number_of_isolated_vertices);
  EXPECT_EQ(a.number_of_non_manifold_vertices, b.number_of_non_manifold_vertices);
  EXPECT_EQ(a.euler_characteristic, b.euler_characteristic);
  EXPECT_EQ(a.is_closed, b.is_closed);
  EXPECT_EQ(a.is_manifold, b.is_manifold);
  EXPECT_NEAR(a.min_angle, b.min_angle, 1e-12);
  EXPECT_NEAR(a.mean_min_angle, b.mean_min_angle, 1e-12);
  EXPECT_NEAR(a.max_angle, b.max_angle, 1e-12);
  EXPECT_NEAR(a.mean_radius_ratio, b.mean_radius_ratio, 1e-14);
  EXPECT_NEAR(a.mean_edge_length, b.mean_edge_length, 1e-14);
  EXPECT_NEAR(a.area, b.area, 1e-13);
}

TEST(Triangle_mesh_quality, regular_tetrahedron)
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point_3(1, 1, 1), Point_3(1, -1, -1), Point_3(-1, 1, -1), Point_3(-1, -1, 1), mesh);
  const auto quality = CGAL::triangle_mesh_quality(mesh);
  EXPECT_EQ(quality.number_of_vertices, 4u);
  EXPECT_EQ(quality.number_of_edges, 6u);
  EXPECT_EQ(quality.number_of_faces, 4u);
  EXPECT_EQ(quality.euler_characteristic, 2); // a sphere
  EXPECT_EQ(quality.number_of_boundary_cycles, 0u);
  EXPECT_EQ(quality.number_of_connected_components, 1u);
  EXPECT_TRUE(quality.is_closed);
  EXPECT_TRUE(quality.is_manifold);
  EXPECT_NEAR(quality.min_angle, 60, 1e-12);
  EXPECT_NEAR(quality.min_edge_length, 2 * std::sqrt(2.), 1e-14); // between (1,1,1) and (1,-1,-1)
  EXPECT_NEAR(quality.area, 8 * std::sqrt(3.), 1e-13);            // 4 * sqrt(3)/4 * 8
}

TEST(Triangle_mesh_quality, open_strip)
{
  const auto soup = strip(3, false);
  const auto quality = CGAL::triangle_mesh_quality(mesh_of(soup.first, soup.second));
  EXPECT_EQ(quality.number_of_vertices, 8u);
  EXPECT_EQ(quality.number_of_edges, 13u); // 3 + 3 along, 4 across, 3 diagonals
  EXPECT_EQ(quality.number_of_border_edges, 8u);
  EXPECT_EQ(quality.number_of_boundary_cycles, 1u);
  EXPECT_EQ(quality.euler_characteristic, 1); // a disk
  EXPECT_FALSE(quality.is_closed);
  EXPECT_TRUE(quality.is_manifold);
  EXPECT_DOUBLE_EQ(quality.area, 3);
  expect_same(quality, CGAL::triangle_soup_quality(soup.first, soup.second));
}

TEST(Triangle_mesh_quality, ring)
{
  const auto soup = strip(8, true);
  const auto quality = CGAL::triangle_mesh_quality(mesh_of(soup.first, soup.second));
  EXPECT_EQ(quality.number_of_edges, 32u); // 8 + 8 around, 8 across, 8 diagonals
  EXPECT_EQ(quality.number_of_boundary_cycles, 2u);
  EXPECT_EQ(quality.euler_characteristic, 0);
  EXPECT_NEAR(quality.area, 16 * std::sin(pi / 8), 1e-14); // 8 rectangles of height 1
  expect_same(quality, CGAL::triangle_soup_quality(soup.first, soup.second));
}

TEST(Triangle_mesh_quality, two_components_and_an_isolated_vertex)
{
  auto soup = strip(3, false);
  for(int i = 0; i < 3; ++i)
    soup.first.push_back(Point_3(10 + (i == 1), i == 2, 0));
  soup.second.push_back({{8, 9, 10}});
  Mesh mesh = mesh_of(soup.first, soup.second);
  mesh.add_vertex(Point_3(20, 0, 0));
  soup.first.push_back(Point_3(20, 0, 0));

  const auto quality = CGAL::triangle_mesh_quality(mesh);
  EXPECT_EQ(quality.number_of_connected_components, 2u);
  EXPECT_EQ(quality.number_of_boundary_cycles, 2u);
  EXPECT_EQ(quality.number_of_isolated_vertices, 1u);
  EXPECT_EQ(quality.euler_characteristic, 3); // two disks and a point
  EXPECT_TRUE(quality.is_manifold);
  expect_same(quality, CGAL::triangle_soup_quality(soup.first, soup.second));
}

TEST(Triangle_mesh_quality, removed_elements_do_not_count)
{
  const auto soup = strip(3, false);
  Mesh mesh = mesh_of(soup.first, soup.second);
  CGAL::Euler::remove_face(halfedge(Mesh::Face_index(1), mesh), mesh); // at the end: one vertex and two edges go
  ASSERT_TRUE(mesh.has_garbage());
  const auto quality = CGAL::triangle_mesh_quality(mesh);
  EXPECT_EQ(quality.number_of_faces, 5u);
  EXPECT_EQ(quality.number_of_edges, 11u);
  EXPECT_EQ(quality.number_of_vertices, 7u);
  EXPECT_EQ(quality.number_of_connected_components, 1u);
}

TEST(Triangle_mesh_quality, pinched_vertex)
{
  // two triangles that share the vertex 0 alone
  const Points points{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(-1, 0, 0), Point_3(-1, -1, 0)};
  const Triangles triangles{{{0, 1, 2}}, {{0, 3, 4}}};
  Mesh mesh;
  for(const Point_3& p : points)
    mesh.add_vertex(p);
  for(const auto& t : triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  for(const auto& quality : {CGAL::triangle_soup_quality(points, triangles), CGAL::triangle_mesh_quality(mesh)})
  {
    EXPECT_EQ(quality.number_of_non_manifold_vertices, 1u);
    EXPECT_EQ(quality.number_of_connected_components, 2u);
    EXPECT_FALSE(quality.is_manifold);
    EXPECT_EQ(quality.euler_characteristic, 1); // 5 - 6 + 2
  }
}

TEST(Triangle_soup_quality, edge_of_three_triangles)
{
  const Points points{Point_3(0, 0, 0), Point_3(0, 0, 1), Point_3(1, 0, 0), Point_3(-1, 1, 0), Point_3(-1, -1, 0)};
  const Triangles triangles{{{0, 1, 2}}, {{0, 1, 3}}, {{0, 1, 4}}};
  const auto quality = CGAL::triangle_soup_quality(points, triangles);
  EXPECT_EQ(quality.number_of_edges, 7u);        // the common one and two for each triangle
  EXPECT_EQ(quality.number_of_border_edges, 6u);
  EXPECT_EQ(quality.number_of_non_manifold_edges, 1u);
  EXPECT_EQ(quality.number_of_non_manifold_vertices, 2u); // the ends of the edge
  EXPECT_EQ(quality.number_of_connected_components, 1u);
  EXPECT_EQ(quality.number_of_boundary_cycles, 3u); // a chain of two edges for each triangle
  EXPECT_FALSE(quality.is_manifold);
}

TEST(Triangle_soup_quality, wrong_soups_are_refused)
{
  const Points points{Point_3(0, 0, 0), Point_3(0, 0, 1), Point_3(1, 0, 0), Point_3(1, 1, 0)};
  const std::vector<std::vector<int>> quadrangle{{0, 1, 2, 3}}, out_of_range{{0, 1, 4}}, negative{{0, 1, -1}}, none{{}};
  for(const auto& faces : {quadrangle, out_of_range, negative, none})
    EXPECT_THROW(CGAL::triangle_soup_quality(points, faces), CGAL::Parametric_surface_mesh_error);
}

TEST(Triangle_mesh_quality, empty_mesh)
{
  const auto quality = CGAL::triangle_mesh_quality(Mesh());
  EXPECT_EQ(quality.number_of_faces, 0u);
  EXPECT_EQ(quality.min_angle, 0);
  EXPECT_EQ(quality.mean_radius_ratio, 0);
  EXPECT_EQ(quality.mean_edge_length, 0);
  expect_same(quality, CGAL::triangle_soup_quality(Points(), Triangles()));
}

} // namespace
