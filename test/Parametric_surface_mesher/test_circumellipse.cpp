// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Circumellipse_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_point_2.h>
#include <CGAL/Parametric_surface_mesher/internal/predicates/In_ellipse_predicate.h>

#include <random_input.h>

#include <gtest/gtest.h>

#include <cmath>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_2 Point_2;
typedef CGAL::Metric_tensor_2 Tensor;
typedef CGAL::Circumellipse_2<Kernel> Ellipse;

namespace {

const double pi = std::acos(-1.);

struct Triangle
{
  Point_2 p, q, r;
};

// a triangle that is not flat, also as the metric `m` sees it: the tests are of formulas, not of conditioning
Triangle random_triangle(Random_input& random, const Tensor& m)
{
  for(;;) {
    const Triangle t = { Point_2(random.real(-1, 1), random.real(-1, 1)),
                         Point_2(random.real(-1, 1), random.real(-1, 1)),
                         Point_2(random.real(-1, 1), random.real(-1, 1)) };
    const double area = CGAL::area(t.p, t.q, t.r);
    double longest = 0;
    for(const Kernel::Vector_2& d : { t.q - t.p, t.r - t.q, t.p - t.r })
      longest = (std::max)(longest, m.squared_length(d.x(), d.y()));
    if(std::fabs(area) * std::sqrt(m.determinant()) > 0.01 * longest)
      return t;
  }
}

} // namespace

TEST(Circumellipse, circle_of_the_euclidean_metric)
{
  const Ellipse circle(Point_2(1, 0), Point_2(0, 1), Point_2(-1, 0), Tensor());
  EXPECT_NEAR(circle.center().x(), 0, 1e-15);
  EXPECT_NEAR(circle.center().y(), 0, 1e-15);
  EXPECT_NEAR(circle.d(), 1, 1e-15);
  EXPECT_NEAR(circle.a(), 1, 1e-15);
  EXPECT_NEAR(circle.b(), 1, 1e-15);
}

TEST(Circumellipse, known_ellipse_along_the_axes)
{
  // x^2/16 + y^2/4 = 1 about (3, -1)
  const Ellipse ellipse(Point_2(7, -1), Point_2(3, 1), Point_2(-1, -1), Tensor(1, 0, 4));
  EXPECT_NEAR(ellipse.center().x(), 3, 1e-14);
  EXPECT_NEAR(ellipse.center().y(), -1, 1e-14);
  EXPECT_NEAR(ellipse.a(), 4, 1e-14);
  EXPECT_NEAR(ellipse.b(), 2, 1e-14);
  EXPECT_EQ(ellipse.alpha(), 0);
  EXPECT_NEAR(ellipse.d(), 16, 1e-13);
  EXPECT_EQ(ellipse.tensor(), Tensor(1, 0, 4));
}

TEST(Circumellipse, known_rotated_ellipse)
{
  // half axes 5 and 2, the long one at 30 degrees, about (1, 2)
  const double alpha = pi / 6, a = 5, b = 2, s = std::sin(alpha), c = std::cos(alpha);
  const auto point = [&](double t) {
    return Point_2(1 + a * std::cos(t) * c - b * std::sin(t) * s, 2 + a * std::cos(t) * s + b * std::sin(t) * c);
  };
  const Ellipse ellipse(point(0.1), point(2), point(4.5), Tensor::from_ellipse(alpha, a / b));
  EXPECT_NEAR(ellipse.center().x(), 1, 1e-13);
  EXPECT_NEAR(ellipse.center().y(), 2, 1e-13);
  EXPECT_NEAR(ellipse.a(), a, 1e-13);
  EXPECT_NEAR(ellipse.b(), b, 1e-13);
  EXPECT_NEAR(ellipse.alpha(), alpha, 1e-13);
  EXPECT_NEAR(ellipse.d(), a * a, 1e-12) << "D = A^2 for an eigenvalue of 1 along the major axis, not A^2 B^2";
}

TEST(Circumellipse, passes_through_the_three_points)
{
  Random_input random(1);
  for(int i = 0; i < 10000; ++i) {
    const Tensor m = random.tensor(2);
    const Triangle t = random_triangle(random, m);
    const Ellipse ellipse(t.p, t.q, t.r, m);
    EXPECT_NEAR(ellipse.implicit_value(t.p), 0, 1e-10 * ellipse.d());
    EXPECT_NEAR(ellipse.implicit_value(t.q), 0, 1e-10 * ellipse.d());
    EXPECT_NEAR(ellipse.implicit_value(t.r), 0, 1e-10 * ellipse.d());
  }
}

TEST(Circumellipse, parametric_form_is_on_the_implicit_one)
{
  Random_input random(2);
  for(int i = 0; i < 2000; ++i) {
    const Tensor m = random.tensor(2);
    const Triangle triangle = random_triangle(random, m);
    const Ellipse ellipse(triangle.p, triangle.q, triangle.r, m);
    EXPECT_LT(ellipse.implicit_value(ellipse.center()), 0);
    for(int j = 0; j < 8; ++j) {
      const double t = random.real(-pi, pi);
      EXPECT_NEAR(ellipse.implicit_value(ellipse.point(t)), 0, 1e-10 * ellipse.d());
    }
    const Point_2 end = ellipse.point(0), side = ellipse.point(pi / 2);
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(ellipse.center(), end)), ellipse.a(), 1e-12 * ellipse.a());
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(ellipse.center(), side)), ellipse.b(), 1e-12 * ellipse.a());
    EXPECT_GE(ellipse.a(), ellipse.b() * (1 - 1e-15));
    EXPECT_NEAR(ellipse.a() / ellipse.b(), m.k(), 1e-10 * m.k());
  }
}

TEST(Circumellipse, half_axes_and_angle_come_back)
{
  Random_input random(3);
  for(int i = 0; i < 5000; ++i) {
    const double alpha = random.real(-pi / 2, pi / 2), k = random.real(1.1, 50);
    const double scale = random.real(0.01, 100);
    const Tensor m = scale * Tensor::from_ellipse(alpha, k);
    const Triangle t = random_triangle(random, m);
    const Ellipse ellipse(t.p, t.q, t.r, m);
    EXPECT_LT(std::fabs(std::remainder(ellipse.alpha() - alpha, pi)), 1e-12);
    EXPECT_NEAR(ellipse.a() / ellipse.b(), k, 1e-9 * k);
    // any scale: D = A^2 lambda_min = B^2 lambda_max
    EXPECT_NEAR(ellipse.d(), scale * ellipse.a() * ellipse.a(), 1e-9 * ellipse.d());
    EXPECT_NEAR(ellipse.d(), scale * k * k * ellipse.b() * ellipse.b(), 1e-9 * ellipse.d());
  }
}

TEST(Circumellipse, does_not_depend_on_the_scale_of_the_tensor)
{
  Random_input random(4);
  for(int i = 0; i < 1000; ++i) {
    const Tensor m = random.tensor(1);
    const Triangle t = random_triangle(random, m);
    const Ellipse ellipse(t.p, t.q, t.r, m), scaled(t.p, t.q, t.r, 1024. * m);
    EXPECT_NEAR(ellipse.center().x(), scaled.center().x(), 1e-12 * ellipse.a());
    EXPECT_NEAR(ellipse.center().y(), scaled.center().y(), 1e-12 * ellipse.a());
    EXPECT_NEAR(ellipse.a(), scaled.a(), 1e-12 * ellipse.a());
    EXPECT_NEAR(ellipse.b(), scaled.b(), 1e-12 * ellipse.a());
  }
}

TEST(Circumellipse, is_the_circle_of_the_mapped_triangle)
{
  // M = L^T L: the ellipse is what L maps to the circumcircle of the mapped points
  Random_input random(5);
  for(int i = 0; i < 5000; ++i) {
    const double a = random.real(-3, 3), b = random.real(-3, 3), c = random.real(-3, 3), d = random.real(-3, 3);
    if(std::fabs(a * d - b * c) < 0.5)
      continue;
    const Tensor m(a * a + c * c, a * b + c * d, b * b + d * d);
    const auto map = [&](const Point_2& p) { return Point_2(a * p.x() + b * p.y(), c * p.x() + d * p.y()); };
    const Triangle t = random_triangle(random, m);
    const Ellipse ellipse(t.p, t.q, t.r, m);
    const Point_2 center = CGAL::circumcenter(map(t.p), map(t.q), map(t.r));
    EXPECT_NEAR(map(ellipse.center()).x(), center.x(), 1e-9 * std::sqrt(ellipse.d()));
    EXPECT_NEAR(map(ellipse.center()).y(), center.y(), 1e-9 * std::sqrt(ellipse.d()));
    EXPECT_NEAR(ellipse.d(), CGAL::squared_distance(center, map(t.p)), 1e-9 * ellipse.d());
  }
}

TEST(Circumellipse, implicit_value_has_the_sign_of_the_predicate)
{
  typedef CGAL::Parametric_point_2<Kernel> Parametric_point_2;
  Random_input random(6);
  int inside = 0, outside = 0;
  for(int i = 0; i < 10000; ++i) {
    const Tensor m = random.tensor(2);
    const Triangle t = random_triangle(random, m);
    const Point_2 x(random.real(-1, 1), random.real(-1, 1));
    const Ellipse ellipse(t.p, t.q, t.r, m);
    const double value = ellipse.implicit_value(x);
    if(std::fabs(value) < 1e-8 * ellipse.d())
      continue;
    const auto with_tensor = [&](const Point_2& p) { return Parametric_point_2(p, Kernel::Point_3(0, 0, 0), m); };
    const CGAL::Sign sign = CGAL::Parametric_surface_mesher::internal::sign_of_in_ellipse(
      with_tensor(t.p), with_tensor(t.q), with_tensor(t.r), with_tensor(x));
    EXPECT_EQ(value < 0 ? 1 : -1, sign * CGAL::orientation(t.p, t.q, t.r));
    (value < 0 ? inside : outside) += 1;
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 1000);
}
