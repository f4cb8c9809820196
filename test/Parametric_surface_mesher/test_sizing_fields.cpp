// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sizing fields in space.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Graded_sizing_field_3.h>
#include <CGAL/Interpolated_sizing_field_3.h>
#include <CGAL/Least_sizing_field_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Segment_3 Segment_3;
typedef Kernel::Triangle_3 Triangle_3;
typedef CGAL::Graded_sizing_field_3<Kernel> Graded;
typedef CGAL::Interpolated_sizing_field_3<Kernel> Interpolated;
typedef CGAL::Parametric_surface_mesh_error Error;

const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

class Random_points
{
  std::mt19937 m_generator{7};
  std::uniform_real_distribution<double> m_coordinate{-2, 2};

public:
  Point_3 operator()()
  {
    const double x = m_coordinate(m_generator), y = m_coordinate(m_generator), z = m_coordinate(m_generator);
    return Point_3(x, y, z);
  }
};

TEST(Sizing_fields, grow_outside_of_a_box)
{
  const auto field = Graded::in_box(Kernel::Iso_cuboid_3(0, 0, 0, 1, 2, 3), 0.1, 0.5);
  EXPECT_DOUBLE_EQ(field(Point_3(0.5, 1, 2.9)), 0.1);
  EXPECT_DOUBLE_EQ(field(Point_3(2, 1, 1)), 0.6);
  EXPECT_DOUBLE_EQ(field(Point_3(4, 6, 1)), 0.1 + 0.5 * 5);
  EXPECT_DOUBLE_EQ(field.length(), 0.1);
}

TEST(Sizing_fields, grow_outside_of_a_ball)
{
  const auto field = Graded::in_ball(Point_3(1, 0, 0), 2, 0.1);
  EXPECT_DOUBLE_EQ(field(Point_3(1, 1, 1)), 0.1);
  EXPECT_DOUBLE_EQ(field(Point_3(1, 3, 4)), 0.1 + 0.2 * 3);
}

TEST(Sizing_fields, grow_outside_of_a_cylinder_with_flat_ends)
{
  const auto field = Graded::in_cylinder(Segment_3(Point_3(0, 0, 0), Point_3(0, 0, 2)), 1, 0.1, 1);
  EXPECT_DOUBLE_EQ(field(Point_3(0.7, 0.7, 1.9)), 0.1);
  EXPECT_DOUBLE_EQ(field(Point_3(3, 0, 1)), 2.1);
  EXPECT_DOUBLE_EQ(field(Point_3(0.5, 0, 3)), 1.1);
  EXPECT_DOUBLE_EQ(field(Point_3(0, -4, -4)), 5.1);
}

TEST(Sizing_fields, grow_with_the_distance_from_points_segments_and_triangles)
{
  Random_points random;
  std::vector<Point_3> points;
  std::vector<Segment_3> segments;
  std::vector<Triangle_3> triangles;
  for(int i = 0; i < 50; ++i) {
    points.push_back(random());
    segments.push_back(Segment_3(random(), random()));
    triangles.push_back(Triangle_3(random(), random(), random()));
  }
  const auto expect_distances = [&](const auto& pieces) {
    const auto field = Graded::near(pieces, 0.1, 0.5), far_reaching = Graded::near(pieces, 0.1, 0.5, 0.25);
    for(int i = 0; i < 200; ++i) {
      const Point_3 p = random();
      double distance = infinity;
      for(const auto& piece : pieces)
        distance = (std::min)(distance, std::sqrt(squared_distance(p, piece)));
      EXPECT_NEAR(field(p), 0.1 + 0.5 * distance, 1e-9);
      EXPECT_NEAR(far_reaching(p), 0.1 + 0.5 * (std::max)(0., distance - 0.25), 1e-9);
    }
  };
  expect_distances(points);
  expect_distances(segments);
  expect_distances(triangles);
  const auto single = Graded::near(std::array<Point_3, 1>{{Point_3(0, 0, 0)}}, 0.1);
  EXPECT_DOUBLE_EQ(single(Point_3(0, 3, 4)), 1.1);
}

TEST(Sizing_fields, are_combined_by_the_least_length)
{
  CGAL::Least_sizing_field_3<Point_3> field;
  EXPECT_TRUE(field.is_empty());
  EXPECT_EQ(field(Point_3(0, 0, 0)), infinity);
  field.add(Graded::in_ball(Point_3(0, 0, 0), 1, 0.1)).add(Graded::in_ball(Point_3(10, 0, 0), 1, 0.2)).add([](const Point_3&) { return 0.5; });
  EXPECT_FALSE(field.is_empty());
  EXPECT_DOUBLE_EQ(field(Point_3(0, 0, 0)), 0.1);
  EXPECT_DOUBLE_EQ(field(Point_3(9.5, 0, 0)), 0.2);
  EXPECT_DOUBLE_EQ(field(Point_3(5, 0, 0)), 0.5);
}

TEST(Sizing_fields, refuse_what_is_no_length_or_place)
{
  const Kernel::Iso_cuboid_3 box(0, 0, 0, 1, 1, 1);
  for(const double length : {0., -1., infinity, nan})
    EXPECT_THROW(Graded::in_box(box, length), Error) << length;
  for(const double growth : {-0.1, infinity, nan})
    EXPECT_THROW(Graded::in_box(box, 1, growth), Error) << growth;
  EXPECT_THROW(Graded::in_ball(Point_3(0, 0, 0), -1, 1), Error);
  EXPECT_THROW(Graded::in_cylinder(Segment_3(Point_3(1, 0, 0), Point_3(1, 0, 0)), 1, 1), Error);
  EXPECT_THROW(Graded::near(std::vector<Point_3>(), 1), Error);
  EXPECT_THROW(Graded::near(std::vector<Segment_3>{Segment_3(Point_3(1, 0, 0), Point_3(1, 0, 0))}, 1), Error);
}

// A linear function of the place.
double linear(const std::array<double, 3>& p) { return 5 + p[0] - 0.5 * p[1] + 0.25 * p[2]; }

// The cubes of a grid in the unit cube, each divided into six tetrahedra along its diagonal.
CGAL::Node_values_3 grid_of_tetrahedra(std::size_t n)
{
  CGAL::Node_values_3 mesh;
  for(std::size_t i = 0; i <= n; ++i)
    for(std::size_t j = 0; j <= n; ++j)
      for(std::size_t k = 0; k <= n; ++k)
        mesh.nodes.push_back({{double(i) / double(n), double(j) / double(n), double(k) / double(n)}});
  for(const auto& p : mesh.nodes)
    mesh.values.push_back(linear(p));
  const std::size_t steps[3] = {(n + 1) * (n + 1), n + 1, 1};
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j)
      for(std::size_t k = 0; k < n; ++k) {
        std::array<std::size_t, 3> order{{0, 1, 2}};
        do {
          std::array<std::size_t, 4> t{{i * steps[0] + j * steps[1] + k}};
          for(std::size_t step = 0; step < 3; ++step)
            t[step + 1] = t[step] + steps[order[step]];
          mesh.tetrahedra.push_back(t);
        } while(std::next_permutation(order.begin(), order.end()));
      }
  return mesh;
}

TEST(Sizing_fields, are_linear_in_tetrahedra_and_those_of_the_closest_point_outside)
{
  const Interpolated field(grid_of_tetrahedra(4));
  EXPECT_DOUBLE_EQ(field.length(), 4.5);
  Random_points random;
  for(int i = 0; i < 500; ++i) {
    const Point_3 p = random();
    const auto inside = [](double x) { return (std::min)((std::max)(x, 0.), 1.); };
    EXPECT_NEAR(field(p), linear({{inside(p.x()), inside(p.y()), inside(p.z())}}), 1e-9);
  }
  for(double x : {0., 0.25, 0.3, 1.}) // on common sides, edges and corners
    EXPECT_NEAR(field(Point_3(x, x, 0.5)), linear({{x, x, 0.5}}), 1e-12);
}

TEST(Sizing_fields, are_linear_on_triangles)
{
  CGAL::Node_values_3 mesh;
  mesh.nodes = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{1, 1, 0}}, {{0.5, 0, 0}}};
  mesh.triangles = {{{0, 1, 2}}, {{1, 3, 2}}, {{0, 4, 1}}}; // the last one has no area
  for(const auto& p : mesh.nodes)
    mesh.values.push_back(linear(p));
  const Interpolated field(mesh);
  EXPECT_NEAR(field(Point_3(0.3, 0.2, 0)), linear({{0.3, 0.2, 0}}), 1e-12);
  EXPECT_NEAR(field(Point_3(0.8, 0.9, 7)), linear({{0.8, 0.9, 0}}), 1e-12);
  EXPECT_NEAR(field(Point_3(3, 5, 7)), linear({{1, 1, 0}}), 1e-12);
}

TEST(Sizing_fields, refuse_meshes_without_lengths)
{
  CGAL::Node_values_3 mesh;
  EXPECT_THROW(Interpolated{mesh}, Error);
  mesh.nodes = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}};
  mesh.triangles = {{{0, 1, 2}}};
  EXPECT_THROW(Interpolated{mesh}, Error);
  mesh.values = {1, 2, 3};
  EXPECT_NO_THROW(Interpolated{mesh});
  for(const double length : {0., -1., infinity, nan}) {
    mesh.values[1] = length;
    EXPECT_THROW(Interpolated{mesh}, Error) << length;
  }
  mesh.values[1] = 1;
  mesh.triangles[0][2] = 3;
  EXPECT_THROW(Interpolated{mesh}, Error);
  mesh.triangles[0][2] = 1;
  EXPECT_THROW(Interpolated{mesh}, Error); // no area
}

} // namespace
