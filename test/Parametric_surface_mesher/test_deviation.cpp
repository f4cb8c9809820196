// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

// Every expected number is worked out by hand in a comment beside it.

#include <CGAL/Surface_jet_3.h>
#include <CGAL/Triangle_mesh_deviation.h>

#include <gtest/gtest.h>

#include <quality_test_helpers.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace {

// The lateral surface of the unit cylinder, with the normal outwards.
struct Cylinder
{
  typedef Test_kernel Geom_traits;

  Point_3 point(double u, double v) const { return Point_3(std::cos(u), std::sin(u), v); }

  CGAL::Surface_jet_3<Test_kernel> jet(double u, double v) const
  {
    const Vector_3 zero(0, 0, 0);
    return {point(u, v), Vector_3(-std::sin(u), std::cos(u), 0), Vector_3(0, 0, 1), zero, zero, zero};
  }
};

// The unit sphere by longitude and latitude, with the normal outwards.
struct Sphere
{
  typedef Test_kernel Geom_traits;

  Point_3 point(double u, double v) const
  {
    return Point_3(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
  }

  CGAL::Surface_jet_3<Test_kernel> jet(double u, double v) const
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
  EXPECT_NEAR(deviation.max_inner_normal_deviation_ratio, ratio, 1e-15);
  EXPECT_EQ(deviation.number_of_skipped_edges, 0u);
  // the samples in the middle of a column lie above its plane by the arc height
  EXPECT_NEAR(deviation.max_distance_to_face, 1 - std::cos(cylinder_angle / 2), 1e-15);
  EXPECT_EQ(deviation.max_distance_to_vertex, 0);
  EXPECT_EQ(deviation.number_of_inverted_faces, 0u);
  EXPECT_EQ(deviation.number_of_domain_violations, 0u);
}

// the plane in polar coordinates
struct Polar_plane
{
  typedef Cylinder::Geom_traits Geom_traits;
  typedef Geom_traits::Point_3 Point_3;
  typedef Geom_traits::Vector_3 Vector_3;

  Point_3 point(double u, double v) const { return Point_3(v * std::cos(u), v * std::sin(u), 0); }

  CGAL::Surface_jet_3<Geom_traits> jet(double u, double v) const
  {
    const double c = std::cos(u), s = std::sin(u);
    return {point(u, v), Vector_3(-v * s, v * c, 0), Vector_3(c, s, 0), Vector_3(-v * c, -v * s, 0),
            Vector_3(-s, c, 0), Vector_3(0, 0, 0)};
  }
};

TEST(Triangle_mesh_deviation, lines_that_bend_within_the_surface)
{
  const Grid grid(Polar_plane(), 2, 2, Point_2(0, 1), cylinder_angle, 1);
  const auto deviation = CGAL::triangle_mesh_deviation(grid.mesh, Polar_plane(), grid.uv, 2);
  // the inner edges along u are chords of circles, as on the cylinder, but all of it lies in the plane
  EXPECT_GE(deviation.max_inner_deviation_ratio, std::tan(cylinder_angle / 4) / 2 - 1e-15);
  EXPECT_NEAR(deviation.max_inner_normal_deviation_ratio, 0, 1e-15);
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
