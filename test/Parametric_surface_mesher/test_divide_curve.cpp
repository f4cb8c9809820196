// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Parametric_function_surface_3.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Parametric_surface_mesher/divide_curve.h>

#include <gtest/gtest.h>

#include <surface_test_helpers.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

typedef CGAL::Domain_curve_2<Test_kernel> Curve;
typedef Test_kernel::Point_2 Point_2;
typedef CGAL::Parametric_surface_mesh_criteria Criteria;

namespace {

const double pi = 4 * std::atan(1.);
const CGAL::Parametric_plane_3<Test_kernel> plane;
const CGAL::Parametric_sphere_3<Test_kernel> sphere(1);

// criteria under which nothing is halved
Criteria equal_pieces(double max_edge)
{
  return Criteria().set_max_edge(max_edge).set_min_edge(max_edge).set_gamma(100);
}

template <class Surface, class... Arguments>
std::vector<double> divide(const Surface& surface, const Curve& curve, const Criteria& criteria, const Arguments&... others)
{
  return CGAL::Parametric_surface_mesher::divide_curve(CGAL::Parametric_surface_mesher::Curve_on_surface_3<Surface>(surface, curve), criteria, others...);
}

// Compares with the `ceil(length / max_edge)` equal pieces of a curve with the arc length `arc_length(t)`.
template <class Surface>
void check_equal_pieces(const Surface& surface, const Curve& curve, const std::function<double(double)>& arc_length)
{
  const double length = arc_length(curve.end());
  for(double share : {3., 1.01, 1., 0.3, 0.1, 1. / 12, 0.0173}) {
    const std::vector<double> t = divide(surface, curve, equal_pieces(share * length));
    const std::size_t n = std::size_t(std::ceil(1 / share - 1e-6));
    ASSERT_EQ(n + 1, t.size()) << "max_edge " << share << " of the length";
    EXPECT_EQ(curve.begin(), t.front());
    EXPECT_EQ(curve.end(), t.back());
    for(std::size_t i = 0; i <= n; ++i)
      EXPECT_NEAR(arc_length(t[i]), length * double(i) / double(n), 1e-8 * length) << i << " of " << n;
  }
}

// the number of pieces of a circle of radius 1 that is halved while its pieces deviate
std::size_t expected_pieces_of_circle(double max_edge, double min_edge, const std::function<double(double)>& deviation,
                                      double gamma)
{
  std::size_t n = std::size_t(std::ceil(2 * pi / max_edge - 1e-6));
  while(deviation(2 * pi / double(n)) > gamma && 2 * pi / double(n) >= 2 * min_edge)
    n *= 2;
  return n;
}

void check_halving_of_circle(const Criteria& criteria, const std::function<double(double)>& deviation)
{
  const std::size_t n
    = expected_pieces_of_circle(criteria.max_edge(), criteria.min_edge(), deviation, criteria.gamma());
  const std::vector<double> in_plane = divide(plane, Curve::circle(Point_2(3, 4), 1), criteria);
  EXPECT_EQ(n + 1, in_plane.size()) << "gamma " << criteria.gamma() << ", min_edge " << criteria.min_edge();
  for(std::size_t i = 0; i + 1 < in_plane.size(); ++i)
    EXPECT_GE(in_plane[i + 1] - in_plane[i], criteria.min_edge() * (1 - 1e-9));
  // the equator: a straight line in the domain
  EXPECT_EQ(n + 1, divide(sphere, Curve::segment(Point_2(0, 0), Point_2(2 * pi, 0)), criteria).size());
}

// the longest ratio of neighbouring pieces of a curve with `|S'| = 1`
double largest_ratio(const std::vector<double>& t)
{
  double result = 1;
  for(std::size_t i = 1; i + 1 < t.size(); ++i) {
    const double ratio = (t[i + 1] - t[i]) / (t[i] - t[i - 1]);
    result = (std::max)({result, ratio, 1 / ratio});
  }
  return result;
}

} // namespace

TEST(Divide_curve, segment_on_a_sheared_plane)
{
  const CGAL::Parametric_plane_3<Test_kernel> sheared(Point_3(1, 2, 3), Vector_3(3, 0, 0), Vector_3(1, 2, 0));
  check_equal_pieces(sheared, Curve::segment(Point_2(5, 5), Point_2(6, 7)), [](double t) { return std::sqrt(41.) * t; });
}

TEST(Divide_curve, circle_and_arcs)
{
  check_equal_pieces(plane, Curve::circle(Point_2(1, 1), 2), [](double t) { return 2 * t; });
  check_equal_pieces(plane, Curve::arc(Point_2(1, 1), 2, 3, 1), [](double t) { return 2 * (3 - t); });
}

TEST(Divide_curve, helix_on_a_cylinder)
{
  const CGAL::Parametric_cylinder_3<Test_kernel> cylinder(2);
  check_equal_pieces(cylinder, Curve::segment(Point_2(0, 0), Point_2(20, 9)),
                     [](double t) { return std::sqrt(40. * 40 + 9 * 9) * t; });
}

TEST(Divide_curve, meridian_of_a_sphere)
{
  check_equal_pieces(sphere, Curve::segment(Point_2(1, -pi / 2), Point_2(1, pi / 2)), [](double t) { return pi * t; });
}

TEST(Divide_curve, speed_that_varies_1_to_1000)
{
  const Curve curve = Curve::from_function(
    [](auto t) {
      using std::exp;
      return std::make_pair(exp(t), 0 * t);
    },
    0, std::log(1000.));
  check_equal_pieces(plane, curve, [](double t) { return std::exp(t) - 1; });
}

TEST(Divide_curve, halving_by_height_over_chord)
{
  const auto deviation = [](double angle) { return std::tan(angle / 4) / 2; };
  for(double max_edge : {2., 1., 0.7})
    for(double gamma : {0.5, 0.1, 0.05, 0.01, 0.001})
      for(double min_edge : {0.4, 0.1, 0.001})
        check_halving_of_circle(Criteria().set_max_edge(max_edge).set_min_edge(min_edge).set_gamma(gamma), deviation);
}

TEST(Divide_curve, halving_by_height_over_radius)
{
  const auto deviation = [](double angle) { return 1 - std::cos(angle / 2); };
  for(double max_edge : {2., 1., 0.7})
    for(double gamma : {0.5, 0.1, 0.05, 0.01, 0.001})
      for(double min_edge : {0.4, 0.1, 0.001})
        check_halving_of_circle(Criteria().set_max_edge(max_edge).set_min_edge(min_edge).set_gamma(gamma)
                                  .set_curve_deviation(CGAL::Parametric_surface_mesher::Curve_deviation::HEIGHT_OVER_RADIUS), deviation);
}

TEST(Divide_curve, radius_is_that_in_space)
{
  // a straight line in the domain, on the circle of latitude 60 degrees, whose radius is 1/2
  const Criteria criteria
    = Criteria().set_max_edge(pi / 6).set_min_edge(0.001).set_gamma(0.01).set_curve_deviation(
      CGAL::Parametric_surface_mesher::Curve_deviation::HEIGHT_OVER_RADIUS);
  const std::size_t n = divide(sphere, Curve::segment(Point_2(0, pi / 3), Point_2(2 * pi, pi / 3)), criteria).size() - 1;
  EXPECT_EQ(24u, n); // 6 pieces, then 1 - cos(pi / n) <= 0.01 from n = 24 on
}

TEST(Divide_curve, inflection_does_not_hide_the_deviation)
{
  const auto wave = CGAL::make_parametric_function_surface([](auto u, auto v) {
    using std::sin;
    return CGAL::parametric_surface_point(u, v, sin(u));
  });
  const Criteria criteria = Criteria().set_max_edge(100).set_min_edge(0.01).set_gamma(0.05);
  const std::vector<double> t = divide(wave, Curve::segment(Point_2(-pi, 0), Point_2(pi, 0)), criteria);
  EXPECT_GT(t.size(), 4u); // the middle of the only piece lies on its chord
}

TEST(Divide_curve, prescribed_numbers)
{
  const Curve curve = Curve::circle(Point_2(0, 0), 1);
  const auto no_size = [](double) { return 1e-3; };
  for(std::size_t n : {1, 2, 7, 400}) {
    const std::vector<double> t = divide(plane, curve, Criteria().set_max_edge(0.1).set_min_edge(0.01), no_size, 3, n);
    ASSERT_EQ(n + 1, t.size());
    for(std::size_t i = 0; i <= n; ++i)
      EXPECT_NEAR(t[i], 2 * pi * double(i) / double(n), 1e-8);
  }
}

TEST(Divide_curve, at_least_the_minimum_number)
{
  const auto no_size = [](double) { return std::numeric_limits<double>::infinity(); };
  EXPECT_EQ(4u, divide(plane, Curve::circle(Point_2(0, 0), 1), equal_pieces(100), no_size, 3).size());
}

TEST(Divide_curve, collapsed_curve_is_one_piece)
{
  const std::vector<double> t
    = divide(sphere, Curve::segment(Point_2(0, pi / 2), Point_2(2 * pi, pi / 2)), equal_pieces(0.1));
  EXPECT_EQ((std::vector<double>{0, 1}), t);
}

TEST(Divide_curve, not_finite)
{
  const auto root = CGAL::make_parametric_function_surface([](auto u, auto v) {
    using std::sqrt;
    return CGAL::parametric_surface_point(u, v, sqrt(u));
  });
  expect_refused([&] { divide(root, Curve::segment(Point_2(-1, 7), Point_2(1, 7)), equal_pieces(0.1)); }, "not finite",
                 "(u,v) = (-", ", 7)");
  const double infinity = std::numeric_limits<double>::infinity();
  expect_refused([&] { divide(plane, Curve::segment(Point_2(0, 0), Point_2(infinity, 0)), equal_pieces(0.1)); },
                 "not finite");
}

TEST(Divide_curve, too_many_pieces_are_refused)
{
  expect_refused([] {
    divide(plane, Curve::segment(Point_2(0, 0), Point_2(1, 0)), equal_pieces(1e-300));
  }, "maximum edge", "vertices");
}

TEST(Divide_curve, wanted_sizes_are_honoured)
{
  const Criteria criteria = Criteria().set_max_edge(1).set_min_edge(1e-3);
  for(double slope : {0.02, 0.2, 1.}) {
    const auto size = [slope](double s) { return 0.02 + slope * std::fabs(s - 0.6); };
    const std::vector<double> t = divide(plane, Curve::segment(Point_2(0, 0), Point_2(1, 0)), criteria, size);
    for(std::size_t i = 0; i + 1 < t.size(); ++i) {
      const double length = t[i + 1] - t[i];
      EXPECT_LE(length, 1.4 * (std::min)({size(t[i]), size((t[i] + t[i + 1]) / 2), size(t[i + 1])}) * (1 + 1e-9));
      // where sizes grow steeply, pieces may not double twice in a row
      EXPECT_GE(length, (slope < 0.1 ? 0.35 : 0.24) * (std::min)(size(t[i]), size(t[i + 1]))) << "much shorter than wanted";
    }
  }
}

TEST(Divide_curve, wanted_sizes_below_the_minimum_edge)
{
  const Criteria criteria = Criteria().set_max_edge(1).set_min_edge(0.05);
  const std::vector<double> t
    = divide(plane, Curve::segment(Point_2(0, 0), Point_2(1, 0)), criteria, [](double) { return 1e-6; });
  EXPECT_EQ(17u, t.size()); // 1/16 cannot be halved
}

TEST(Divide_curve, neighbouring_pieces_are_at_most_2_to_1)
{
  const Criteria criteria = Criteria().set_max_edge(0.1).set_min_edge(1e-5);
  for(double place : {0.01, 0.3, 0.5, 0.77}) {
    const auto jump = [place](double s) { return s < place || s > place + 0.1 ? 1. : 0.001; };
    const std::vector<double> t = divide(plane, Curve::segment(Point_2(0, 0), Point_2(1, 0)), criteria, jump);
    EXPECT_GT(t.size(), 50u);
    EXPECT_LE(largest_ratio(t), 2.02);
  }
}
