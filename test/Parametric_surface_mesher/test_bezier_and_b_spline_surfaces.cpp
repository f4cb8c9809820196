// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/B_spline_surface_3.h>
#include <CGAL/Bezier_surface_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "include/surface_test_helpers.h"

namespace {

typedef CGAL::Bezier_surface_3<> Bezier_surface_3;
typedef CGAL::B_spline_surface_3<> B_spline_surface_3;
typedef std::vector<double> Numbers;
typedef std::vector<Point_3> Points;

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

// A bumpy net without symmetries.
Points net(int size_u, int size_v)
{
  Points points;
  for(int j = 0; j < size_v; ++j)
    for(int i = 0; i < size_u; ++i)
      points.emplace_back(i + 0.1 * std::sin(3. * j), j + 0.2 * std::cos(2. * i + j), std::sin(1.7 * i * j + i));
  return points;
}

Numbers weights(int count)
{
  Numbers w;
  for(int k = 0; k < count; ++k)
    w.push_back(1 + 0.5 * std::sin(2.3 * k));
  return w;
}

// The knots of a Bezier curve over `[min, max]`.
Numbers bezier_knots(int degree, double min = 0, double max = 1)
{
  Numbers knots(degree + 1, min);
  knots.insert(knots.end(), degree + 1, max);
  return knots;
}

// One eighth of the unit sphere; the side v = 1 is collapsed to the pole.
B_spline_surface_3 sphere_octant()
{
  const double w = std::sqrt(0.5);
  const Points points = { Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0),
                          Point_3(1, 0, 1), Point_3(1, 1, 1), Point_3(0, 1, 1),
                          Point_3(0, 0, 1), Point_3(0, 0, 1), Point_3(0, 0, 1) };
  return B_spline_surface_3(2, 2, bezier_knots(2), bezier_knots(2), points,
                            { 1, w, 1, w, w * w, w, 1, w, 1 });
}

TEST(Bezier_surface, corners_are_control_points)
{
  for(int degree : { 1, 2, 3, 7, 25 }) {
    const Bezier_surface_3 s(degree, 2, net(degree + 1, 3));
    EXPECT_EQ(s.control_point(0, 0), s.point(s.u_min(), s.v_min()));
    EXPECT_EQ(s.control_point(degree, 0), s.point(s.u_max(), s.v_min()));
    EXPECT_EQ(s.control_point(0, 2), s.point(s.u_min(), s.v_max()));
    EXPECT_EQ(s.control_point(degree, 2), s.point(s.u_max(), s.v_max()));
  }
}

TEST(Bezier_surface, u_runs_fastest)
{
  const Points points = net(3, 2);
  const Bezier_surface_3 s(2, 1, points);
  EXPECT_EQ(points[1], s.control_point(1, 0));
  EXPECT_EQ(points[3], s.control_point(0, 1));
  EXPECT_EQ(3, s.number_of_control_points_u());
  EXPECT_EQ(2, s.number_of_control_points_v());
}

TEST(Bezier_surface, bilinear_patch)
{
  const Bezier_surface_3 s(1, 1, Points{ Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(1, 1, 1) });
  const auto jet = s.jet(0.25, 0.5);
  EXPECT_EQ(Point_3(0.25, 0.5, 0.125), jet.point);
  EXPECT_EQ(Vector_3(1, 0, 0.5), jet.du);
  EXPECT_EQ(Vector_3(0, 1, 0.25), jet.dv);
  EXPECT_EQ(Vector_3(0, 0, 0), jet.duu);
  EXPECT_EQ(Vector_3(0, 0, 1), jet.duv);
  EXPECT_EQ(Vector_3(0, 0, 0), jet.dvv);
}

TEST(Bezier_surface, jets)
{
  for(int degree_u : { 1, 2, 3, 6 })
    for(int degree_v : { 1, 2, 4 })
      for(double u : { 0., 0.3, 1., 1.2 })
        check_jet(Bezier_surface_3(degree_u, degree_v, net(degree_u + 1, degree_v + 1)), u, 0.6);
}

TEST(Bezier_surface, refuses_bad_input)
{
  Points points = net(4, 4);
  expect_refused([&] { Bezier_surface_3(0, 3, points); }, "Bezier surface, u", "degree from 1 to 25", "found 0");
  expect_refused([&] { Bezier_surface_3(3, 26, points); }, "Bezier surface, v", "found 26");
  expect_refused([&] { Bezier_surface_3(3, 2, points); }, "expected 4 x 3 control points", "found 16");
  points[6] = Point_3(0, nan, 0);
  expect_refused([&] { Bezier_surface_3(3, 3, points); }, "control point (2,1)", "finite", "nan");
}

TEST(B_spline_surface, is_the_bezier_surface_of_the_same_points)
{
  for(int degree : { 1, 2, 3, 5 }) {
    const Points points = net(degree + 1, 4);
    const Bezier_surface_3 bezier(degree, 3, points);
    const B_spline_surface_3 spline(degree, 3, bezier_knots(degree, 2, 4), bezier_knots(3), points);
    for(double u : { 0., 0.125, 0.7, 1. })
      for(double v : { 0., 0.4, 1. }) {
        const auto b = bezier.jet(u, v), s = spline.jet(2 + 2 * u, v);
        expect_near(b.point, s.point, 1e-14, "point");
        expect_near(b.du, 2 * s.du, 1e-13, "du");
        expect_near(b.dvv, s.dvv, 1e-12, "dvv");
        expect_near(b.duv, 2 * s.duv, 1e-12, "duv");
        expect_near(b.duu, 4 * s.duu, 1e-12, "duu");
      }
  }
}

TEST(B_spline_surface, jets_with_multiple_knots)
{
  const Numbers knots_u = { -1, -1, -1, -1, 0, 0.5, 0.5, 2, 2, 2, 2 }; // 7 functions of degree 3
  const Numbers knots_v = { 0, 0, 0, 1, 1, 3, 3, 3 };                  // 5 functions of degree 2
  for(const Numbers& w : { Numbers(), weights(35) }) {
    const B_spline_surface_3 s(3, 2, knots_u, knots_v, net(7, 5), w);
    EXPECT_EQ(!w.empty(), s.is_rational());
    EXPECT_EQ(7, s.number_of_control_points_u());
    EXPECT_EQ(5, s.number_of_control_points_v());
    for(double u : { -1.5, -1., -0.2, 0.3, 0.6, 2., 2.1 })
      for(double v : { 0., 0.4, 1.5, 3. })
        check_jet(s, u, v);
  }
}

TEST(B_spline_surface, corners_are_control_points)
{
  const Numbers knots = { 1, 1, 1, 3, 3.1, 50, 50, 50 };
  const B_spline_surface_3 s(2, 2, knots, knots, net(5, 5));
  EXPECT_EQ(1, s.u_min());
  EXPECT_EQ(50, s.v_max());
  EXPECT_EQ(s.control_point(0, 0), s.point(1, 1));
  EXPECT_EQ(s.control_point(4, 0), s.point(50, 1));
  EXPECT_EQ(s.control_point(0, 4), s.point(1, 50));
  EXPECT_EQ(s.control_point(4, 4), s.point(50, 50));
}

TEST(B_spline_surface, knot_of_full_multiplicity_interpolates_and_joins)
{
  const Numbers knots = { 0, 0, 0, 1, 1, 2, 2, 2 };
  const B_spline_surface_3 s(2, 1, knots, bezier_knots(1), net(5, 2));
  EXPECT_EQ(s.control_point(2, 0), s.point(1, 0));
  expect_near(s.point(1, 0.3), s.point(std::nextafter(1., 0.), 0.3), 1e-14, "both sides");
}

TEST(B_spline_surface, knots_need_not_be_clamped)
{
  const Numbers uniform = { 0, 1, 2, 3, 4, 5, 6, 7 }, half_clamped = { 0, 1, 1, 1, 2, 3, 4 };
  const B_spline_surface_3 s(3, 2, uniform, half_clamped, net(4, 4));
  EXPECT_EQ(3, s.u_min());
  EXPECT_EQ(4, s.u_max());
  for(double u : { 2.9, 3., 3.5, 4., 4.1 })
    for(double v : { 0.5, 1., 1.5, 2.5 })
      check_jet(s, u, v);
}

TEST(B_spline_surface, sphere_octant_is_exact)
{
  const B_spline_surface_3 s = sphere_octant();
  for(double u = 0; u <= 1; u += 0.0625)
    for(double v = 0; v <= 1; v += 0.0625) {
      EXPECT_NEAR(1, std::sqrt((s.point(u, v) - CGAL::ORIGIN).squared_length()), 1e-14);
      check_jet(s, u, v);
    }
  EXPECT_EQ(s.control_point(0, 2), s.control_point(2, 2));
  expect_near(Vector_3(0, 0, 0), s.jet(0.3, 1).du, 1e-15, "at the pole");
}

TEST(B_spline_surface, equal_weights_make_no_rational_surface)
{
  const B_spline_surface_3 s(2, 2, bezier_knots(2), bezier_knots(2), net(3, 3), Numbers(9, 0.3));
  EXPECT_FALSE(s.is_rational());
  EXPECT_EQ(1, s.weight(1, 1));
  EXPECT_EQ(Bezier_surface_3(2, 2, net(3, 3)).point(0.3, 0.4), s.point(0.3, 0.4));
  EXPECT_EQ(std::sqrt(0.5), sphere_octant().weight(1, 0));
}

TEST(B_spline_surface, a_parameter_that_is_not_a_number_gives_no_number)
{
  EXPECT_TRUE(std::isnan(sphere_octant().point(nan, 0.5).x()));
  EXPECT_TRUE(std::isnan(sphere_octant().jet(0.5, nan).du.x()));
}

void expect_knots_refused(const Numbers& knots, const char* expected, const char* found)
{
  const auto of_u = [&] { B_spline_surface_3(2, 1, knots, bezier_knots(1), net(int(knots.size()) - 3, 2)); };
  expect_refused(of_u, "B-spline surface, u", expected, found);
  const auto of_v = [&] { B_spline_surface_3(1, 2, bezier_knots(1), knots, net(2, int(knots.size()) - 3)); };
  expect_refused(of_v, "B-spline surface, v", expected, found);
}

TEST(B_spline_surface, refuses_bad_knots)
{
  expect_knots_refused({ 0, 0, 0, 1, 1 }, "at least 2 (degree + 1) knots", "number of knots 5");
  expect_knots_refused({ 0, 0, 0, 2, 1, 3, 3, 3 }, "nondecreasing", "knot 2, followed by 1");
  expect_knots_refused({ 0, 0, 0, nan, 1, 1, 1 }, "finite knots", "nan");
  expect_knots_refused({ 0, 0, 0, 1, 1, infinity }, "finite knots", "inf");
  expect_knots_refused({ 1, 1, 1, 1, 1, 1 }, "range that is not empty", "last 1");
  expect_knots_refused({ 0, 0, 0, 1, 1, 1, 2, 2, 2 }, "inner knots of multiplicity at most the degree", "knot 1");
  expect_knots_refused({ 0, 0, 0, 0, 1, 1, 1 }, "multiplicity at most degree + 1", "multiplicity 4");
}

TEST(B_spline_surface, refuses_bad_degrees_points_and_weights)
{
  const Numbers knots = bezier_knots(2);
  expect_refused([&] { B_spline_surface_3(0, 2, knots, knots, net(3, 3)); }, "surface, u", "degree", "found 0");
  expect_refused([&] { B_spline_surface_3(2, 2, knots, knots, net(3, 2)); }, "3 x 3 control points", "found 6");
  expect_refused([&] { B_spline_surface_3(2, 2, knots, knots, net(3, 3), Numbers(8, 1)); }, "weights", "found 8");
  for(double bad : { 0., -1., nan, infinity }) {
    Numbers w(9, 1);
    w[5] = bad;
    expect_refused([&] { B_spline_surface_3(2, 2, knots, knots, net(3, 3), w); }, "control point (2,1)", "positive");
  }
  Points points = net(3, 3);
  points[3] = Point_3(infinity, 0, 0);
  expect_refused([&] { B_spline_surface_3(2, 2, knots, knots, points); }, "control point (0,1)", "inf");
}

} // namespace
