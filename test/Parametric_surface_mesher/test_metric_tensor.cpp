// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Metric_tensor_2.h>

#include <random_input.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

typedef CGAL::Metric_tensor_2 Tensor;

namespace {

const double pi = std::acos(-1.);

// the difference of two angles of axes, which are the same half a turn further
double axis_difference(double a, double b)
{
  return std::fabs(std::remainder(a - b, pi));
}

} // namespace

TEST(Metric_tensor, default_is_euclidean)
{
  const Tensor m;
  EXPECT_EQ(m, Tensor(1, 0, 1));
  EXPECT_TRUE(m.is_positive_definite());
  EXPECT_EQ(m.alpha(), 0);
  EXPECT_DOUBLE_EQ(m.k(), 1);
  EXPECT_DOUBLE_EQ(m.squared_length(3, 4), 25);
}

TEST(Metric_tensor, components)
{
  const Tensor m(5, -2, 3);
  EXPECT_EQ(m.e(), 5);
  EXPECT_EQ(m.f(), -2);
  EXPECT_EQ(m.g(), 3);
  EXPECT_EQ(m.determinant(), 11);
  EXPECT_EQ(m.trace(), 8);
  EXPECT_EQ(m.squared_length(1, 0), 5);
  EXPECT_EQ(m.squared_length(0, 1), 3);
  EXPECT_EQ(m.squared_length(1, 1), 4);
  EXPECT_EQ(m.squared_length(-2, 3), 5 * 4 + 2 * 2 * 6 + 3 * 9);
}

TEST(Metric_tensor, sum_and_multiple)
{
  EXPECT_EQ(Tensor(1, 2, 8) + Tensor(4, -1, 16), Tensor(5, 1, 24));
  EXPECT_EQ(0.5 * Tensor(4, -2, 8), Tensor(2, -1, 4));
  EXPECT_NE(Tensor(1, 0, 1), Tensor(1, 0, 2));
}

TEST(Metric_tensor, axes_along_the_coordinates)
{
  // circles of a metric in which u is short are long in u
  const Tensor along_u(1, 0, 16);
  EXPECT_EQ(along_u.alpha(), 0);
  EXPECT_DOUBLE_EQ(along_u.k(), 4);
  const Tensor along_v(16, 0, 1);
  EXPECT_DOUBLE_EQ(along_v.alpha(), pi / 2);
  EXPECT_DOUBLE_EQ(along_v.k(), 4);
}

TEST(Metric_tensor, alpha_is_the_direction_of_the_smaller_eigenvalue)
{
  Random_input random(1);
  for(int i = 0; i < 10000; ++i) {
    const Tensor m = random.tensor(3);
    const double c = std::cos(m.alpha()), s = std::sin(m.alpha());
    EXPECT_GT(m.alpha(), -pi / 2 - 1e-15);
    EXPECT_LE(m.alpha(), pi / 2);
    // M d = lambda d
    EXPECT_NEAR(m.e() * c + m.f() * s, m.lambda_min() * c, 1e-14 * m.lambda_max());
    EXPECT_NEAR(m.f() * c + m.g() * s, m.lambda_min() * s, 1e-14 * m.lambda_max());
    EXPECT_NEAR(-m.e() * s + m.f() * c, -m.lambda_max() * s, 1e-14 * m.lambda_max());
    EXPECT_NEAR(m.lambda_min() + m.lambda_max(), m.trace(), 1e-14 * m.lambda_max());
    EXPECT_NEAR(m.k() * m.k(), m.lambda_max() / m.lambda_min(), 1e-12 * m.k() * m.k());
  }
}

TEST(Metric_tensor, from_ellipse_and_back)
{
  Random_input random(2);
  for(int i = 0; i < 10000; ++i) {
    const double alpha = random.real(-pi / 2, pi / 2);
    const double k = std::pow(10., random.real(0.01, 3));
    const Tensor m = Tensor::from_ellipse(alpha, k);
    ASSERT_TRUE(m.is_positive_definite());
    // the condition of the smaller eigenvalue is k^2, that of the angle 1 / (k^2 - 1)
    EXPECT_NEAR(m.k(), k, 1e-14 * k * k * k);
    EXPECT_LT(axis_difference(m.alpha(), alpha), 1e-12);
    EXPECT_NEAR(m.lambda_min(), 1, 1e-14 * k * k);
    EXPECT_NEAR(m.lambda_max(), k * k, 1e-13 * k * k);
    const Tensor back = m.lambda_min() * Tensor::from_ellipse(m.alpha(), m.k());
    EXPECT_NEAR(back.e(), m.e(), 1e-13 * k * k);
    EXPECT_NEAR(back.f(), m.f(), 1e-13 * k * k);
    EXPECT_NEAR(back.g(), m.g(), 1e-13 * k * k);
  }
}

TEST(Metric_tensor, from_ellipse_is_the_bracket_of_equation_5)
{
  Random_input random(3);
  for(int i = 0; i < 1000; ++i) {
    const double alpha = random.real(-pi / 2, pi / 2), k = random.real(1, 20);
    const double u = random.real(-1, 1), v = random.real(-1, 1);
    const double s = std::sin(alpha), c = std::cos(alpha), s2 = std::sin(2 * alpha);
    const double bracket = k * k * (u * u * s * s - u * v * s2 + v * v * c * c)
                           + u * u * c * c + v * v * s * s + u * v * s2;
    EXPECT_NEAR(Tensor::from_ellipse(alpha, k).squared_length(u, v), bracket, 1e-12 * k * k);
  }
}

TEST(Metric_tensor, positive_definite)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(Tensor(2, 1, 1).is_positive_definite());
  EXPECT_TRUE(Tensor(1e-150, 0, 1e-150).is_positive_definite());
  EXPECT_TRUE(Tensor(1e150, 0, 1e150).is_positive_definite());
  EXPECT_TRUE(Tensor(1e150, 0, 1e-150).is_positive_definite());
  EXPECT_FALSE(Tensor(0, 0, 0).is_positive_definite());
  EXPECT_FALSE(Tensor(1, 1, 1).is_positive_definite());
  EXPECT_FALSE(Tensor(1, 2, 1).is_positive_definite());
  EXPECT_FALSE(Tensor(1, 0, 0).is_positive_definite());
  EXPECT_FALSE(Tensor(0, 0, 1).is_positive_definite());
  EXPECT_FALSE(Tensor(-1, 0, -1).is_positive_definite());
  EXPECT_FALSE(Tensor(-2, 1, -1).is_positive_definite());
  for(double bad : {nan, infinity, -infinity}) {
    EXPECT_FALSE(Tensor(bad, 0, 1).is_positive_definite());
    EXPECT_FALSE(Tensor(1, bad, 1).is_positive_definite());
    EXPECT_FALSE(Tensor(1, 0, bad).is_positive_definite());
  }
}
