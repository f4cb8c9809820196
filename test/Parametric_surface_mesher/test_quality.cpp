// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

// Every expected number is worked out by hand in a comment beside it.

#include <CGAL/Surface_jet_3.h>
#include <CGAL/Triangle_mesh_quality.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef std::vector<Point_3> Points;
typedef std::vector<std::array<std::size_t, 3>> Triangles;

const double pi = CGAL_PI;

CGAL::Triangle_mesh_quality quality_of_triangle(const Point_3& p, const Point_3& q, const Point_3& r)
{
  return CGAL::triangle_soup_quality(Points{p, q, r}, Triangles{{{0, 1, 2}}});
}

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

TEST(Triangle_mesh_quality, equilateral_triangle)
{
  const auto quality = quality_of_triangle(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.5, std::sqrt(3.) / 2, 0));
  EXPECT_NEAR(quality.min_angle, 60, 1e-12);
  EXPECT_NEAR(quality.mean_min_angle, 60, 1e-12);
  EXPECT_NEAR(quality.max_angle, 60, 1e-12);
  EXPECT_NEAR(quality.min_radius_ratio, 1, 1e-15); // r = 1/(2 sqrt 3), R = 1/sqrt 3
  EXPECT_NEAR(quality.area, std::sqrt(3.) / 4, 1e-15);
  EXPECT_NEAR(quality.mean_edge_length, 1, 1e-15);
  EXPECT_EQ(quality.share_below_30_degrees, 0);
  EXPECT_EQ(quality.number_of_degenerate_faces, 0u);
}

TEST(Triangle_mesh_quality, right_isosceles_triangle)
{
  const auto quality = quality_of_triangle(Point_3(5, 5, 5), Point_3(5, 6, 5), Point_3(5, 5, 6));
  EXPECT_NEAR(quality.min_angle, 45, 1e-12);
  EXPECT_NEAR(quality.max_angle, 90, 1e-12);
  // r = area/half perimeter = (1/2)/(1 + sqrt(2)/2), R = sqrt(2)/2, so 2r/R = 2(sqrt(2) - 1)
  EXPECT_NEAR(quality.mean_radius_ratio, 2 * (std::sqrt(2.) - 1), 1e-14);
  EXPECT_DOUBLE_EQ(quality.area, 0.5);
  EXPECT_DOUBLE_EQ(quality.min_edge_length, 1);
  EXPECT_DOUBLE_EQ(quality.max_edge_length, std::sqrt(2.));
  EXPECT_DOUBLE_EQ(quality.mean_edge_length, (2 + std::sqrt(2.)) / 3);
}

TEST(Triangle_mesh_quality, needle_keeps_all_digits)
{
  const Point_3 p(0, 0, 0), q(1, 0, 0), r(0.5, 1e-9, 0);
  const double angle = std::atan(2e-9) * 180 / pi; // height over half the base
  for(const auto& quality : {quality_of_triangle(p, q, r), quality_of_triangle(q, r, p), quality_of_triangle(r, p, q)})
  {
    EXPECT_NEAR(quality.min_angle / angle, 1, 1e-14);
    EXPECT_NEAR(quality.max_angle, 180 - 2 * angle, 1e-12);
    // 16 area^2/(perimeter * product of sides) = 16 * (5e-10)^2/(2 * 1/4)
    EXPECT_NEAR(quality.min_radius_ratio / 8e-18, 1, 1e-14);
    EXPECT_EQ(quality.number_of_degenerate_faces, 0u);
    EXPECT_EQ(quality.share_below_10_degrees, 1);
  }
}

TEST(Triangle_mesh_quality, needle_with_a_short_side)
{
  // the angle at p is atan(1e-12) between sides of length 1, where the arc cosine would give 0
  const auto quality = quality_of_triangle(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1e-12, 0));
  EXPECT_NEAR(quality.min_angle / (std::atan(1e-12) * 180 / pi), 1, 1e-14);
  EXPECT_NEAR(quality.max_angle, 90, 1e-10);
}

TEST(Triangle_mesh_quality, scale_does_not_matter)
{
  for(const double scale : {1e-60, 1e-30, 1e30, 1e60})
  {
    const auto quality = quality_of_triangle(Point_3(0, 0, 0), Point_3(scale, 0, 0), Point_3(0, scale, 0));
    EXPECT_NEAR(quality.mean_radius_ratio, 2 * (std::sqrt(2.) - 1), 1e-14) << scale;
    EXPECT_EQ(quality.number_of_degenerate_faces, 0u) << scale;
  }
}

TEST(Triangle_mesh_quality, shares_and_means)
{
  // isosceles triangles with legs 1 and apex angles of 5, 15, 25 and 35 degrees
  Points points{Point_3(0, 0, 0), Point_3(1, 0, 0)};
  Triangles triangles;
  for(const double degrees : {5., 15., 25., 35.})
  {
    points.push_back(Point_3(std::cos(degrees * pi / 180), std::sin(degrees * pi / 180), 0));
    triangles.push_back({{0, 1, points.size() - 1}});
  }
  const auto quality = CGAL::triangle_soup_quality(points, triangles);
  EXPECT_DOUBLE_EQ(quality.share_below_10_degrees, 0.25);
  EXPECT_DOUBLE_EQ(quality.share_below_20_degrees, 0.5);
  EXPECT_DOUBLE_EQ(quality.share_below_30_degrees, 0.75);
  EXPECT_NEAR(quality.min_angle, 5, 1e-12);
  EXPECT_NEAR(quality.mean_min_angle, 20, 1e-12); // (5 + 15 + 25 + 35)/4
  EXPECT_NEAR(quality.max_angle, 87.5, 1e-12);    // (180 - 5)/2
}

TEST(Triangle_mesh_quality, degenerate_faces)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const Points points{Point_3(0, 0, 0), Point_3(1, 1, 1), Point_3(3, 3, 3), Point_3(infinity, 0, 0), Point_3(0, 1, 0)};
  // collinear, with a repeated point, not finite, and one good triangle of area |(1,1,1) x (0,1,0)|/2 = sqrt(2)/2
  const Triangles triangles{{{0, 1, 2}}, {{0, 0, 4}}, {{0, 1, 3}}, {{0, 1, 4}}};
  const auto quality = CGAL::triangle_soup_quality(points, triangles);
  EXPECT_EQ(quality.number_of_degenerate_faces, 3u);
  EXPECT_EQ(quality.min_angle, 0);
  EXPECT_EQ(quality.max_angle, 180);
  EXPECT_EQ(quality.min_radius_ratio, 0);
  EXPECT_NEAR(quality.area, std::sqrt(2.) / 2, 1e-15);
  EXPECT_DOUBLE_EQ(quality.share_below_10_degrees, 0.75);
  EXPECT_DOUBLE_EQ(quality.min_edge_length, 1);                 // from 0 to 4
  EXPECT_DOUBLE_EQ(quality.max_edge_length, 3 * std::sqrt(3.)); // from 0 to 2
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

// The lateral surface of the unit cylinder, with the normal outwards.
struct Cylinder
{
  typedef Kernel Geom_traits;

  Point_3 point(double u, double v) const { return Point_3(std::cos(u), std::sin(u), v); }

  CGAL::Surface_jet_3<Kernel> jet(double u, double v) const
  {
    const Vector_3 zero(0, 0, 0);
    return {point(u, v), Vector_3(-std::sin(u), std::cos(u), 0), Vector_3(0, 0, 1), zero, zero, zero};
  }
};

// The unit sphere by longitude and latitude, with the normal outwards.
struct Sphere
{
  typedef Kernel Geom_traits;

  Point_3 point(double u, double v) const
  {
    return Point_3(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
  }

  CGAL::Surface_jet_3<Kernel> jet(double u, double v) const
  {
    const Vector_3 zero(0, 0, 0); // second derivatives, which nobody here asks for
    return {point(u, v), Vector_3(-std::sin(u) * std::cos(v), std::cos(u) * std::cos(v), 0),
            Vector_3(-std::cos(u) * std::sin(v), -std::sin(u) * std::sin(v), std::cos(v)), zero, zero, zero};
  }
};

// A grid of `columns` times `rows` cells, each cut from its lower left to its upper right corner.
struct Grid
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Vertex_index, Point_2> uv;

  template <class Surface>
  Grid(const Surface& surface, int columns, int rows, const Point_2& low, double du, double dv,
       bool is_reversed = false)
  {
    uv = mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv").first;
    for(int j = 0; j <= rows; ++j)
      for(int i = 0; i <= columns; ++i)
      {
        const Point_2 p(low.x() + i * du, low.y() + j * dv);
        uv[mesh.add_vertex(surface.point(p.x(), p.y()))] = p;
      }
    for(int j = 0; j < rows; ++j)
      for(int i = 0; i < columns; ++i)
      {
        const int corner = j * (columns + 1) + i, above = corner + columns + 1;
        add_face(corner, corner + 1, above + 1, is_reversed);
        add_face(corner, above + 1, above, is_reversed);
      }
  }

  void add_face(int a, int b, int c, bool is_reversed)
  {
    if(is_reversed)
      std::swap(b, c);
    mesh.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c));
  }
};

// a quarter of the cylinder: 8 columns of angle pi/16 and 2 rows of height 1/2
const double cylinder_angle = pi / 16;
const int cylinder_faces = 32;

Grid cylinder_grid(bool is_reversed = false)
{
  return Grid(Cylinder(), 8, 2, Point_2(0, 0), cylinder_angle, 0.5, is_reversed);
}

TEST(Triangle_mesh_deviation, cylinder)
{
  const Grid grid = cylinder_grid();
  const auto deviation = CGAL::triangle_mesh_deviation(grid.mesh, Cylinder(), grid.uv, 2);
  // Chord of an arc of angle d: H = 1 - cos(d/2), L = 2 sin(d/2), so H/L = tan(d/4)/2. The straight edges have
  // none, and the diagonals the same H with a larger L.
  const double ratio = std::tan(cylinder_angle / 4) / 2;
  EXPECT_NEAR(deviation.max_border_deviation_ratio, ratio, 1e-15);
  EXPECT_NEAR(deviation.max_inner_deviation_ratio, ratio, 1e-15);
  EXPECT_EQ(deviation.number_of_skipped_edges, 0u);
  // the samples in the middle of a column lie above its plane by the arc height
  EXPECT_NEAR(deviation.max_distance_to_face, 1 - std::cos(cylinder_angle / 2), 1e-15);
  EXPECT_EQ(deviation.max_distance_to_vertex, 0);
  EXPECT_EQ(deviation.number_of_inverted_faces, 0u);
  EXPECT_EQ(deviation.number_of_domain_violations, 0u);
}

TEST(Triangle_mesh_deviation, short_edges_are_skipped)
{
  const Grid grid = cylinder_grid();
  // the chords have length 2 sin(pi/32) = 0.196, everything else is at least 0.5
  const auto deviation = CGAL::triangle_mesh_deviation(grid.mesh, Cylinder(), grid.uv, 2, 0.2);
  EXPECT_EQ(deviation.number_of_skipped_edges, 24u); // 3 rows of 8
  EXPECT_NEAR(deviation.max_border_deviation_ratio, 0, 1e-15);
  // the diagonals: the line crosses the height of the arc's middle point at the middle of the chord
  const double half = cylinder_angle / 2;
  EXPECT_NEAR(deviation.max_inner_deviation_ratio,
              (1 - std::cos(half)) / std::hypot(2 * std::sin(half), 0.5), 1e-15);
}

TEST(Triangle_mesh_deviation, sampling_density)
{
  const Grid grid = cylinder_grid();
  // the corners alone lie on the faces
  EXPECT_NEAR(CGAL::triangle_mesh_deviation(grid.mesh, Cylinder(), grid.uv, 1).max_distance_to_face, 0, 1e-15);
  // every even number has the middle among its samples
  for(const unsigned int subdivisions : {4u, 8u})
    EXPECT_NEAR(CGAL::triangle_mesh_deviation(grid.mesh, Cylinder(), grid.uv, subdivisions).max_distance_to_face,
                1 - std::cos(cylinder_angle / 2), 1e-15);
}

TEST(Triangle_mesh_deviation, row_of_cells_on_the_equator_of_a_sphere)
{
  const double d = 0.3;
  const Grid grid(Sphere(), 5, 1, Point_2(1, -d / 2), d, d);
  const auto deviation = CGAL::triangle_mesh_deviation(grid.mesh, Sphere(), grid.uv);
  // Meridians are arcs of angle d of radius 1, parallels of radius cos(d/2): tan(d/4)/2 for both.
  EXPECT_NEAR(deviation.max_border_deviation_ratio, std::tan(d / 4) / 2, 1e-15);
  // A diagonal from (-d/2,-d/2) to (d/2,d/2) has the chord middle (cos^2(d/2), 0, 0) under the point (1, 0, 0),
  // H = sin^2(d/2), and L^2 = (2 cos(d/2) sin(d/2))^2 + (2 sin(d/2))^2.
  const double s = std::sin(d / 2), c = std::cos(d / 2);
  EXPECT_NEAR(deviation.max_inner_deviation_ratio, s / (2 * std::sqrt(1 + c * c)), 1e-15);
  EXPECT_GE(deviation.max_distance_to_face, s * s - 1e-15); // the diagonal's middle is a sample, above two faces
  EXPECT_EQ(deviation.number_of_inverted_faces, 0u);
  EXPECT_EQ(deviation.number_of_domain_violations, 0u);
}

TEST(Triangle_mesh_deviation, sphere_closes_up_at_a_pole)
{
  const double d = pi / 8;
  const Grid grid(Sphere(), 4, 2, Point_2(0, pi / 2 - 2 * d), d, d);
  const auto deviation = CGAL::triangle_mesh_deviation(grid.mesh, Sphere(), grid.uv, 4, 1e-10);
  EXPECT_EQ(deviation.number_of_skipped_edges, 4u); // those of the top row, all in the pole
  EXPECT_EQ(deviation.number_of_domain_violations, 0u);
  EXPECT_LT(deviation.max_distance_to_face, d * d);
}

TEST(Triangle_mesh_deviation, reversed_faces)
{
  const Grid grid = cylinder_grid(true);
  const auto deviation = CGAL::triangle_mesh_deviation(grid.mesh, Cylinder(), grid.uv);
  EXPECT_EQ(deviation.number_of_inverted_faces, std::size_t(cylinder_faces));
  EXPECT_EQ(deviation.number_of_domain_violations, std::size_t(cylinder_faces));
}

TEST(Triangle_mesh_deviation, mirrored_points)
{
  Grid grid = cylinder_grid();
  auto mirrored = grid.mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:mirrored").first;
  for(const auto v : grid.mesh.vertices())
    mirrored[v] = Point_3(grid.mesh.point(v).x(), grid.mesh.point(v).y(), -grid.mesh.point(v).z());
  const auto deviation = CGAL::triangle_mesh_deviation(grid.mesh, Cylinder(), grid.uv, 2, 0,
                                                       CGAL::parameters::vertex_point_map(mirrored));
  EXPECT_EQ(deviation.number_of_inverted_faces, std::size_t(cylinder_faces));
  EXPECT_EQ(deviation.number_of_domain_violations, 0u);
  EXPECT_DOUBLE_EQ(deviation.max_distance_to_vertex, 2); // the top row, from height 1 to -1
}

TEST(Triangle_mesh_deviation, degenerate_in_the_domain)
{
  Grid grid = cylinder_grid();
  // vertex 0 moves to the middle of the first cell's right side: one triangle collapses, the other stays as oriented
  grid.uv[Mesh::Vertex_index(0)] = Point_2(cylinder_angle, 0.25);
  const auto deviation = CGAL::triangle_mesh_deviation(grid.mesh, Cylinder(), grid.uv);
  EXPECT_EQ(deviation.number_of_domain_violations, 1u);
}

TEST(Triangle_mesh_deviation, vertex_off_the_surface)
{
  Grid grid = cylinder_grid();
  grid.mesh.point(Mesh::Vertex_index(0)) = Point_3(1.01, 0, 0); // from (1, 0, 0)
  const auto deviation = CGAL::triangle_mesh_deviation(grid.mesh, Cylinder(), grid.uv);
  EXPECT_NEAR(deviation.max_distance_to_vertex, 0.01, 1e-15);
}

TEST(Triangle_mesh_deviation, values_that_are_not_finite_are_refused)
{
  struct Pole : Cylinder
  {
    Point_3 point(double u, double v) const { return Point_3(u / v, u, v); } // not finite where v = 0
  };
  Grid grid = cylinder_grid();
  try
  {
    CGAL::triangle_mesh_deviation(grid.mesh, Pole(), grid.uv);
    FAIL() << "no exception";
  }
  catch(const CGAL::Parametric_surface_mesh_error& error)
  {
    EXPECT_STREQ(error.what(), "the surface point is not finite at (u,v) = (0, 0)");
  }
  grid.mesh.point(Mesh::Vertex_index(0)) = Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  EXPECT_THROW(CGAL::triangle_mesh_deviation(grid.mesh, Cylinder(), grid.uv), CGAL::Parametric_surface_mesh_error);
}

} // namespace
