// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

// Every expected number is worked out by hand in a comment beside it.

#include <CGAL/Triangle_mesh_quality.h>

#include <gtest/gtest.h>

#include <quality_test_helpers.h>

#include <cmath>
#include <limits>

namespace {

CGAL::Triangle_mesh_quality quality_of_triangle(const Point_3& p, const Point_3& q, const Point_3& r)
{
  return CGAL::triangle_soup_quality(Points{p, q, r}, Triangles{{{0, 1, 2}}});
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

} // namespace
