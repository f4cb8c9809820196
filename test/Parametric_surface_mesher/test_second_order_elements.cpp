// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Jacobian of curved triangles: what is proved of it, and what becomes of triangles that are folded.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Curved_elements.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Quadratic_triangle_3.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Scaled_jacobian.h>

#include <gtest/gtest.h>

#include <random_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

using namespace CGAL::Parametric_surface_mesher::internal;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef Quadratic_triangle_3<Kernel> Triangle;
typedef Curved_elements<Kernel> Elements;

const double infinity = std::numeric_limits<double>::infinity();

Triangle triangle_with_straight_sides(const Point_3& p, const Point_3& q, const Point_3& r)
{
  return Triangle({p, q, r, straight_middle(p, q), straight_middle(q, r), straight_middle(r, p)});
}

// Its normal at barycentric coordinates, by the derivatives of the shape functions.
Vector_3 normal_at(const Triangle& triangle, double l0, double l1, double l2)
{
  const auto& p = triangle.nodes();
  const std::array<double, 6> by_l1 = {1 - 4 * l0, 4 * l1 - 1, 0, 4 * (l0 - l1), 4 * l2, -4 * l2},
                              by_l2 = {1 - 4 * l0, 0, 4 * l2 - 1, -4 * l1, 4 * l1, 4 * (l0 - l2)};
  Vector_3 du(0, 0, 0), dv(0, 0, 0);
  for(std::size_t i = 0; i < 6; ++i) {
    du = du + by_l1[i] * (p[i] - CGAL::ORIGIN);
    dv = dv + by_l2[i] * (p[i] - CGAL::ORIGIN);
  }
  return cross_product(du, dv);
}

// The smallest of many samples of what `scaled_jacobian()` bounds.
double sampled_jacobian(const Triangle& triangle, int n)
{
  const Vector_3 mean = triangle.normal().mean();
  double result = infinity;
  for(int i = 0; i <= n; ++i)
    for(int k = 0; i + k <= n; ++k)
      result = (std::min)(result, normal_at(triangle, double(i) / n, double(k) / n, double(n - i - k) / n) * mean
                                    / mean.squared_length());
  return result;
}

// Corners at random, and nodes that are off the middles of the sides by up to `bend`.
Triangle random_triangle(Random_input& random, double bend)
{
  const auto vector = [&] {
    const double x = random.real(-1, 1), y = random.real(-1, 1), z = random.real(-1, 1);
    return Vector_3(x, y, z);
  };
  const Point_3 p = CGAL::ORIGIN + vector(), q = CGAL::ORIGIN + vector(), r = CGAL::ORIGIN + vector();
  auto nodes = triangle_with_straight_sides(p, q, r).nodes();
  for(std::size_t i = 3; i < 6; ++i)
    nodes[i] = nodes[i] + bend * vector();
  return Triangle(nodes);
}

} // namespace

TEST(Quadratic_triangle, goes_through_its_nodes)
{
  Random_input random(1);
  const Triangle t = random_triangle(random, 0.5);
  const std::array<std::array<double, 3>, 6> places
    = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}}};
  for(std::size_t i = 0; i < 6; ++i)
    EXPECT_LT(squared_distance(t.point(places[i][0], places[i][1], places[i][2]), t.nodes()[i]), 1e-28);
}

TEST(Quadratic_triangle, has_the_normal_of_its_derivatives)
{
  Random_input random(2);
  for(int i = 0; i < 20; ++i) {
    const Triangle t = random_triangle(random, 0.5);
    const auto c = t.normal().coefficients;
    const double l0 = 0.2, l1 = 0.3, l2 = 0.5;
    const Vector_3 normal = l0 * l0 * c[0] + l1 * l1 * c[1] + l2 * l2 * c[2]
                            + 2 * (l0 * l1 * c[3] + l1 * l2 * c[4] + l2 * l0 * c[5]);
    EXPECT_LT((normal - normal_at(t, l0, l1, l2)).squared_length(), 1e-26);
  }
}

TEST(Scaled_jacobian, of_a_straight_triangle_is_1)
{
  const Triangle t = triangle_with_straight_sides({1, 2, 3}, {2, 2, 5}, {1, 7, 3});
  EXPECT_NEAR(scaled_jacobian(t, t.straight_normal()), 1, 1e-12);
}

TEST(Scaled_jacobian, without_area_or_on_the_wrong_side_is_refused)
{
  const Triangle flat = triangle_with_straight_sides({0, 0, 0}, {1, 0, 0}, {3, 0, 0});
  EXPECT_EQ(scaled_jacobian(flat, {0, 0, 1}), -infinity);
  const Triangle t = triangle_with_straight_sides({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(scaled_jacobian(t, {0, 0, -1}), -infinity);
}

TEST(Scaled_jacobian, of_a_folded_triangle_is_negative)
{
  // the side between the first two corners bulges over the third one
  const Triangle t({Point_3(0, 0, 0), {1, 0, 0}, {0.5, 0.2, 0}, {0.5, 0.4, 0}, {0.75, 0.1, 0}, {0.25, 0.1, 0}});
  EXPECT_LT(scaled_jacobian(t, {0, 0, -1}), 0);
  EXPECT_LT(scaled_jacobian(t, {0, 0, 1}), 0);
  // a node beyond the quarter of its side turns the end of the side back
  const Triangle quarter({Point_3(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0.2, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, 0}});
  EXPECT_LT(scaled_jacobian(quarter, {0, 0, 1}), 0);
  const Triangle third({Point_3(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0.33, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, 0}});
  EXPECT_GT(scaled_jacobian(third, {0, 0, 1}), 0);
}

// What is proved is never more than what is sampled, and not much less.
TEST(Scaled_jacobian, is_below_all_samples_and_close_to_them)
{
  Random_input random(20131);
  std::size_t number_of_good_ones = 0;
  for(int i = 0; i < 3000; ++i) {
    const Triangle t = random_triangle(random, 0.1 + 0.1 * (i % 5));
    const double proved = scaled_jacobian(t, t.normal().mean()), sampled = sampled_jacobian(t, 30);
    number_of_good_ones += proved > 0;
    ASSERT_LE(proved, sampled) << "case " << i;
    if(sampled > -1) {
      ASSERT_GT(proved, sampled - 0.03) << "case " << i;
    }
  }
  EXPECT_GT(number_of_good_ones, 500u);
}

// Far from the origin and nearly without area, the bound still is one: it counts rounding.
TEST(Scaled_jacobian, of_slivers_far_away_is_below_all_samples)
{
  Random_input random(20132);
  for(int i = 0; i < 1000; ++i) {
    auto nodes = random_triangle(random, 0.1).nodes();
    for(Point_3& p : nodes)
      p = Point_3(1e3 + p.x(), p.y() * std::pow(10., -(i % 8)), p.z() * std::pow(10., -(i % 8)));
    const Triangle t(nodes);
    ASSERT_LE(scaled_jacobian(t, t.normal().mean()), sampled_jacobian(t, 10) + 1e-6) << "case " << i;
  }
}

// Two triangles at a side that bulges beyond the opposite corner of one of them.
TEST(Curved_elements, are_curved_less_where_they_are_folded)
{
  const Point_3 a(0, 0, 0), b(1, 0, 0), above(0.5, 0.2, 0), below(0.5, -1, 0);
  const auto side = [](const Point_3& p, const Point_3& q) { return Elements::Side{straight_middle(p, q), straight_middle(p, q)}; };
  std::vector<Elements::Side> sides = {side(a, b), side(b, above), side(above, a), side(a, below), side(below, b)};
  sides[0].curved = Point_3(0.5, 0.4, 0);
  sides[3].curved = sides[3].curved + Vector_3(-0.05, 0.02, 0);
  const Vector_3 up(0, 0, 1);
  Elements elements(sides, {{{a, b, above}, {0, 1, 2}, up}, {{a, below, b}, {3, 4, 0}, up}}, 0.1);
  EXPECT_LT(elements.jacobians()[0], 0);
  elements.curve_less();
  EXPECT_GE(elements.jacobians()[0], 0.1);
  EXPECT_GE(elements.jacobians()[1], 0.1);
  EXPECT_LT(elements.sides()[0].node().y(), 0.2);
  EXPECT_GE(elements.sides()[0].node().y(), 0);
  EXPECT_EQ(elements.sides()[3].node(), sides[3].curved); // this one was not to blame
}

TEST(Curved_elements, without_area_stay_as_they_are)
{
  const Point_3 a(0, 0, 0), b(1, 0, 0), c(2, 0, 0);
  const std::vector<Elements::Side> sides = {{straight_middle(a, b), Point_3(0.5, 0.1, 0)},
                                             {straight_middle(b, c), straight_middle(b, c)},
                                             {straight_middle(c, a), straight_middle(c, a)}};
  Elements elements(sides, {{{a, b, c}, {0, 1, 2}, Vector_3(0, 0, 1)}}, 0.1);
  elements.curve_less();
  EXPECT_LT(elements.jacobians()[0], 0.1);
  EXPECT_EQ(elements.sides()[0].node(), sides[0].curved);
}

// Fans of triangles around a vertex with sides bent at random: in the end none fails, whatever their neighbours needed.
TEST(Curved_elements, never_fail_in_the_end_if_straight_ones_do_not)
{
  Random_input random(20133);
  std::size_t number_of_failures = 0;
  for(int run = 0; run < 100; ++run) {
    const std::size_t n = 6;
    std::vector<Point_3> rim;
    for(std::size_t i = 0; i < n; ++i)
      rim.emplace_back(std::cos(CGAL_PI / 3 * double(i)), std::sin(CGAL_PI / 3 * double(i)), 0);
    const auto side = [&](const Point_3& p, const Point_3& q) {
      const Point_3 middle = straight_middle(p, q);
      const double x = random.real(-0.5, 0.5), y = random.real(-0.5, 0.5), z = random.real(-0.5, 0.5);
      return Elements::Side{middle, middle + Vector_3(x, y, z)};
    };
    std::vector<Elements::Side> sides;
    std::vector<Elements::Element> fan;
    for(std::size_t i = 0; i < n; ++i)
      sides.push_back(side(Point_3(0, 0, 0), rim[i]));
    for(std::size_t i = 0; i < n; ++i) {
      sides.push_back(side(rim[i], rim[(i + 1) % n]));
      fan.push_back({{Point_3(0, 0, 0), rim[i], rim[(i + 1) % n]}, {i, n + i, (i + 1) % n}, Vector_3(0, 0, 1)});
    }
    Elements elements(sides, fan, 0.1);
    for(const double jacobian : elements.jacobians())
      number_of_failures += !(jacobian >= 0.1);
    elements.curve_less();
    for(std::size_t e = 0; e < n; ++e) {
      ASSERT_GE(elements.jacobians()[e], 0.1);
      const auto& s = fan[e].sides;
      const auto& p = fan[e].corners;
      const Triangle t({p[0], p[1], p[2], elements.sides()[s[0]].node(), elements.sides()[s[1]].node(), elements.sides()[s[2]].node()});
      ASSERT_GE(sampled_jacobian(t, 20), 0.1);
    }
  }
  EXPECT_GT(number_of_failures, 100u);
}
