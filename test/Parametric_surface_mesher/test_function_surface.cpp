// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Parametric_function_surface_3.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <type_traits>

#include "include/surface_test_helpers.h"

namespace {

const auto peak_function = [](auto u, auto v)
{
  using std::exp;
  return CGAL::parametric_surface_point(u, v, 0.8 * exp(-(u * u + v * v) / (2 * 0.12 * 0.12)));
};

// A functor with one type for all coordinates.
struct Wave
{
  template <class U, class V>
  auto operator()(const U& u, const V& v) const
  {
    using std::sin;
    typedef decltype(u * v) T;
    return std::array<T, 3>{ T(u), T(v), T(sin(u * v) + u * u * v) };
  }
};

TEST(Function_surface, point_is_the_value_of_the_function)
{
  const auto peak = CGAL::make_parametric_function_surface(peak_function);
  EXPECT_EQ(Point_3(0, 0, 0.8), peak.point(0, 0));
  expect_near(Point_3(0.1, -0.2, 0.8 * std::exp(-0.05 / 0.0288)), peak.point(0.1, -0.2), 1e-15, "point");
}

TEST(Function_surface, derivatives_of_peak)
{
  const auto peak = CGAL::make_parametric_function_surface(peak_function);
  const double k = 1 / (0.12 * 0.12), u = 0.07, v = -0.11;
  const auto jet = peak.jet(u, v);
  const double z = jet.point.z();
  expect_near(Vector_3(1, 0, -k * u * z), jet.du, 1e-13, "du");
  expect_near(Vector_3(0, 1, -k * v * z), jet.dv, 1e-13, "dv");
  expect_near(Vector_3(0, 0, (k * k * u * u - k) * z), jet.duu, 1e-12, "duu");
  expect_near(Vector_3(0, 0, k * k * u * v * z), jet.duv, 1e-12, "duv");
  expect_near(Vector_3(0, 0, (k * k * v * v - k) * z), jet.dvv, 1e-12, "dvv");
}

TEST(Function_surface, finite_differences)
{
  const auto peak = CGAL::make_parametric_function_surface(peak_function);
  const auto wave = CGAL::make_parametric_function_surface(Wave());
  for(double u : { -0.3, 0., 0.1, 0.45 })
    for(double v : { -0.2, 0., 0.35 }) {
      check_jet(peak, u, v, 0.1);
      check_jet(wave, u, v);
    }
}

TEST(Function_surface, coordinates_of_one_variable_and_constants)
{
  const auto surface = CGAL::make_parametric_function_surface([](auto u, auto v)
  {
    using std::cos;
    return CGAL::parametric_surface_point(cos(v), u * u, 3);
  });
  const auto jet = surface.jet(2, 1);
  EXPECT_EQ(Point_3(std::cos(1.), 4, 3), jet.point);
  EXPECT_EQ(Vector_3(0, 4, 0), jet.du);
  expect_near(Vector_3(-std::sin(1.), 0, 0), jet.dv, 1e-15, "dv");
  EXPECT_EQ(Vector_3(0, 2, 0), jet.duu);
  EXPECT_EQ(Vector_3(0, 0, 0), jet.duv);
  expect_near(Vector_3(-std::cos(1.), 0, 0), jet.dvv, 1e-15, "dvv");
}

TEST(Function_surface, branches_and_math_functions)
{
  const auto surface = CGAL::make_parametric_function_surface([](auto u, auto v)
  {
    using std::sqrt; using std::pow; using std::log; using std::atan2; using std::tanh;
    auto height = sqrt(1 + u * u) * pow(v, 3);
    if(u < v)
      height = height + 1;
    return CGAL::parametric_surface_point(log(2 + u), atan2(v, 1 + u * u), height + tanh(u - v));
  });
  check_jet(surface, 0.3, 0.7);
  check_jet(surface, 1.3, 0.7);
  EXPECT_NEAR(1, surface.point(0, 1e-9).z() - surface.point(0, -1e-9).z(), 1e-6);
}

TEST(Function_surface, values_that_are_not_finite_pass_through)
{
  const auto surface = CGAL::make_parametric_function_surface([](auto u, auto v)
  {
    using std::sqrt;
    return CGAL::parametric_surface_point(u, v, sqrt(u));
  });
  EXPECT_TRUE(std::isnan(surface.point(-1, 0).z()));
  EXPECT_TRUE(std::isnan(surface.jet(-1, 0).du.z()));
}

// a sum that begins with the type of `u`
TEST(Function_surface, sum_in_a_loop)
{
  const auto surface = CGAL::make_parametric_function_surface([](auto u, auto v)
  {
    using std::exp;
    auto z = 0. * u;
    for(double c : { -0.5, 0., 0.5 })
      z = z + exp(-(u - c) * (u - c) - (v + c) * (v + c));
    return CGAL::parametric_surface_point(u, v, z);
  });
  const double u = 0.3, v = 0.7;
  double expected = 0;
  for(double c : { -0.5, 0., 0.5 })
    expected += -2 * (v + c) * std::exp(-(u - c) * (u - c) - (v + c) * (v + c));
  EXPECT_NEAR(expected, surface.jet(u, v).dv.z(), 1e-14);
  check_jet(surface, u, v);
}

TEST(Function_surface, coordinates_of_one_type)
{
  const auto surface = CGAL::make_parametric_function_surface([](auto u, auto v) { return std::array{ u, v, u * v }; });
  EXPECT_EQ(Point_3(2, 3, 6), surface.point(2, 3));
  EXPECT_EQ(Vector_3(1, 0, 3), surface.jet(2, 3).du);
  EXPECT_EQ(Vector_3(0, 1, 2), surface.jet(2, 3).dv);
}

// each function in a coordinate of its own, at a place where all of them are smooth
TEST(Function_surface, all_functions)
{
  const auto check = [](auto function) {
    const auto surface = CGAL::make_parametric_function_surface([function](auto u, auto v) {
      return CGAL::parametric_surface_point(u, v, function(0.5 + 0.2 * u - 0.1 * v, 0.7 * u + 0.2 * u * v));
    });
    check_jet(surface, 0.4, 0.3);
    EXPECT_EQ(surface.point(0.4, 0.3), surface.jet(0.4, 0.3).point);
  };
  using std::sqrt; using std::cbrt; using std::exp; using std::exp2; using std::expm1; using std::log; using std::log1p;
  using std::log2; using std::log10; using std::sin; using std::cos; using std::tan; using std::asin; using std::acos;
  using std::atan; using std::sinh; using std::cosh; using std::tanh; using std::asinh; using std::acosh; using std::atanh;
  using std::erf; using std::erfc; using std::abs; using std::fabs; using std::pow; using std::hypot; using std::atan2;
  using std::fmod; using std::fmin; using std::fmax; using std::floor; using std::ceil; using std::round; using std::trunc;
  check([](auto x, auto y) { return sqrt(x) + cbrt(y) + exp(x * y) + exp2(y) - expm1(x); });
  check([](auto x, auto y) { return log(x) + log1p(y) - log2(x) * log10(y); });
  check([](auto x, auto y) { return sin(x) + cos(y) * tan(x) + asin(x) - acos(y) / atan(x); });
  check([](auto x, auto y) { return sinh(x) + cosh(y) * tanh(x) + asinh(x) - acosh(1.5 + y) / atanh(x); });
  check([](auto x, auto y) { return erf(x) * erfc(y) + abs(-x) + fabs(y - 3) + pow(x, 3) + pow(y, 2.5f) + pow(x, y) + pow(2, y); });
  check([](auto x, auto y) { return hypot(x, y) + hypot(x, 2) + hypot(1., x, y) + atan2(x, y) + atan2(y, -x) + atan2(-1, x); });
  check([](auto x, auto y) { return fmod(7 * x, y) + fmin(x, y) * fmax(y, 0.1) + floor(x) * ceil(y) + round(3 * y) + trunc(9 * x); });
  check([](auto x, auto y) { x += y; x *= 2. * y; x -= 1 / y; x /= 3 - y; return x <= y || x != 1 ? -x + 2 * +y : y; });
}

TEST(Function_surface, powers_at_zero)
{
  const auto surface = CGAL::make_parametric_function_surface([](auto u, auto v)
  {
    using std::pow;
    return CGAL::parametric_surface_point(pow(u, 1), pow(u, 2) + pow(v, 0), pow(v, 3));
  });
  const auto jet = surface.jet(0, 0);
  EXPECT_EQ(Vector_3(1, 0, 0), jet.du);
  EXPECT_EQ(Vector_3(0, 0, 0), jet.dv);
  EXPECT_EQ(Vector_3(0, 2, 0), jet.duu);
  EXPECT_EQ(Vector_3(0, 0, 0), jet.dvv);
}

CGAL::Surface_jet_3<Test_kernel> saddle_jet(double u, double v)
{
  return { Point_3(u, v, u * v), Vector_3(1, 0, v), Vector_3(0, 1, u),
           Vector_3(0, 0, 0), Vector_3(0, 0, 1), Vector_3(0, 0, 0) };
}

TEST(Jet_surface, point_from_jet)
{
  const auto saddle = CGAL::make_parametric_jet_surface(saddle_jet);
  static_assert(std::is_same<decltype(saddle)::Geom_traits, Test_kernel>::value, "the kernel of the jet");
  check_jet(saddle, 0.3, 0.4);
}

TEST(Jet_surface, point_function_spares_the_jet)
{
  int jets = 0;
  const auto saddle = CGAL::make_parametric_jet_surface(
    [&jets](double u, double v) { ++jets; return saddle_jet(u, v); },
    [](double u, double v) { return Point_3(u, v, u * v); });
  EXPECT_EQ(Point_3(2, 3, 6), saddle.point(2, 3));
  EXPECT_EQ(0, jets);
  EXPECT_EQ(Vector_3(1, 0, 3), saddle.jet(2, 3).du);
  EXPECT_EQ(1, jets);
}

TEST(Jet_surface, other_kernel)
{
  typedef CGAL::Simple_cartesian<double> Kernel;
  const auto peak = CGAL::make_parametric_function_surface<Kernel>(peak_function);
  const auto same = CGAL::make_parametric_jet_surface([&peak](double u, double v) { return peak.jet(u, v); });
  static_assert(std::is_same<decltype(same)::Geom_traits, Kernel>::value, "the kernel of the jet");
  EXPECT_EQ(peak.point(0.1, 0.2), same.point(0.1, 0.2));
}

} // namespace
