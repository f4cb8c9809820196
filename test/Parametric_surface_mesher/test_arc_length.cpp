// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Parametric_surface_mesher/internal/curves/Arc_length.h>
#include <CGAL/Parametric_surface_mesher/internal/curves/Legendre_expansion.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <random>

namespace {

using CGAL::Parametric_surface_mesher::internal::Curve_position;
using CGAL::Parametric_surface_mesher::internal::Legendre_expansion;
typedef CGAL::Parametric_surface_mesher::internal::Arc_length<std::function<double(double)>> Arc_length;

const double pi = 4 * std::atan(1.);

// of an ellipse with the half-axes `a` and 1
double speed_of_ellipse(double a, double t) { return std::hypot(a * std::sin(t), std::cos(t)); }

void check_inverse(const Arc_length& length, double tolerance)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  for(int i = 0; i < 200; ++i) {
    const double s = share(random) * length.length();
    const Curve_position position = length.position_at(s);
    EXPECT_EQ(s, position.length);
    EXPECT_NEAR(s, length.length_at(position.parameter), tolerance * length.length());
  }
}

} // namespace

TEST(Legendre_expansion, polynomials_are_exact)
{
  for(int degree = 0; degree < 15; ++degree) {
    const Legendre_expansion expansion([=](double x) { return 1 + std::pow(x, degree); });
    EXPECT_EQ(degree < 12, expansion.has_converged(1e-12)) << degree;
    for(double x : {-1., -0.7, 0., 0.3, 1.}) {
      EXPECT_NEAR(1 + std::pow(x, degree), expansion.value(x), 1e-13);
      EXPECT_NEAR(x + 1 + (std::pow(x, degree + 1) - std::pow(-1, degree + 1)) / (degree + 1), expansion.integral(x), 1e-13);
    }
  }
}

TEST(Arc_length, perimeter_of_an_ellipse)
{
  for(double a : {1., 2., 10., 100.}) {
    const Arc_length length([=](double t) { return speed_of_ellipse(a, t); }, 0, 2 * pi, 4);
    const double expected = 4 * a * boost::math::ellint_2(std::sqrt(1 - 1 / (a * a)));
    EXPECT_NEAR(1, length.length() / expected, 1e-11) << a;
    EXPECT_NEAR(0.25 * expected, length.length_at(0.5 * pi), 1e-10 * expected);
    check_inverse(length, 1e-11);
  }
}

TEST(Arc_length, descending_parameters)
{
  const auto speed = [](double t) { return std::exp(t); };
  const Arc_length up(speed, -1, 2, 3), down(speed, 2, -1, 3);
  EXPECT_NEAR(std::exp(2.) - std::exp(-1.), up.length(), 1e-10);
  EXPECT_NEAR(up.length(), down.length(), 1e-10);
  EXPECT_NEAR(up.length(), up.length_at(0.3) + down.length_at(0.3), 1e-10);
  check_inverse(up, 1e-11);
  check_inverse(down, 1e-11);
}

// as at a knot of a spline, and at a point where the curve stands still
TEST(Arc_length, kinks_and_jumps_of_the_speed)
{
  const Arc_length kink([](double t) { return std::fabs(t - 0.3); }, 0, 1, 1);
  EXPECT_NEAR(0.5 * (0.3 * 0.3 + 0.7 * 0.7), kink.length(), 1e-7);
  check_inverse(kink, 1e-7);
  const Arc_length jump([](double t) { return t < 1 / 3. ? 1. : 100.; }, 0, 1, 1);
  EXPECT_NEAR(1, jump.length() / (1 / 3. + 200 / 3.), 1e-3);
  check_inverse(jump, 1e-11);
}

TEST(Arc_length, positions_between_two_others)
{
  const Arc_length length([](double t) { return speed_of_ellipse(5, t); }, 0, 2 * pi, 4);
  const Curve_position from = length.position_at(0.21 * length.length()), to = length.position_at(0.83 * length.length());
  for(double share : {0.01, 0.5, 0.77, 0.99}) {
    const double s = from.length + share * (to.length - from.length);
    EXPECT_NEAR(length.position_at(s).parameter, length.position_between(from, to, s).parameter, 1e-10);
  }
}

TEST(Arc_length, ends_are_exact)
{
  const Arc_length length([](double t) { return 1 + t * t; }, 0.1, 0.7, 2);
  EXPECT_EQ(0.1, length.position_at(0).parameter);
  EXPECT_EQ(0.7, length.position_at(length.length()).parameter);
  EXPECT_EQ(0.7, length.position_at(2 * length.length()).parameter);
}

TEST(Arc_length, curve_of_length_zero)
{
  EXPECT_EQ(0, Arc_length([](double) { return 0.; }, 0, 1, 4).length());
}

// Lengths and positions ask the curve for nothing more, and a smooth curve is asked seldom.
TEST(Arc_length, number_of_evaluations)
{
  std::size_t number = 0;
  const Arc_length length(
    [&](double t) {
      ++number;
      return speed_of_ellipse(2, t);
    },
    0, 2 * pi, 4);
  EXPECT_LE(number, 300u);
  const std::size_t before = number;
  check_inverse(length, 1e-10);
  EXPECT_EQ(before, number);
}

// against a quadrature that shares no code
TEST(Arc_length, random_speeds)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coefficient(-1, 1);
  for(int i = 0; i < 50; ++i) {
    const double a = coefficient(random), b = coefficient(random), c = 8 * coefficient(random);
    const auto speed = [=](double t) { return std::hypot(1 + a * std::sin(c * t), b * t, std::cos(3 * t)); };
    const Arc_length length(speed, -2, 3, 2);
    const auto integral = [&](double t) {
      return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(speed, -2., t, 12, 1e-12);
    };
    for(double t : {-1.9, 0., 1.234, 3.})
      EXPECT_NEAR(integral(t), length.length_at(t), 1e-9 * length.length());
    check_inverse(length, 1e-10);
  }
}
