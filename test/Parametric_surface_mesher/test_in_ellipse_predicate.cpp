// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Anisotropic_Delaunay_triangulation_traits_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

#include <random_input.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Anisotropic_Delaunay_triangulation_traits_2<Kernel> Traits;
typedef Traits::Point_2 Point_2;
typedef CGAL::Metric_tensor_2 Tensor;
typedef CGAL::Exact_rational Rational;
typedef std::array<Point_2, 4> Quadruple;

namespace {

Point_2 make_point(double x, double y, const Tensor& m)
{
  return Point_2(Kernel::Point_2(x, y), Kernel::Point_3(x, y, 0), m);
}

int predicate(const Quadruple& q)
{
  return Traits().side_of_oriented_circle_2_object()(q[0], q[1], q[2], q[3]);
}

// The definition, in rational numbers: the determinant of the rows (x, y, x^T M x, 1), not translated, for the
// tensor M that is the common one of the four points.
int rational_sign(const Quadruple& q)
{
  const Tensor m = CGAL::Parametric_surface_mesher::internal::common_tensor(q[0].tensor(), q[1].tensor(),
                                                                           q[2].tensor(), q[3].tensor());
  const Rational e(m.e()), f(m.f()), g(m.g());
  std::array<Rational, 4> x, y, z;
  for(int i = 0; i < 4; ++i) {
    x[i] = Rational(q[i].x());
    y[i] = Rational(q[i].y());
    z[i] = e * x[i] * x[i] + 2 * f * x[i] * y[i] + g * y[i] * y[i];
  }
  const auto minor = [&](int i, int j, int k) -> Rational {
    return x[i] * (y[j] * z[k] - y[k] * z[j]) - y[i] * (x[j] * z[k] - x[k] * z[j])
           + z[i] * (x[j] * y[k] - x[k] * y[j]);
  };
  // expanded along the column of ones
  const Rational det = minor(0, 1, 2) - minor(0, 1, 3) + minor(0, 2, 3) - minor(1, 2, 3);
  return CGAL::sign(det);
}

// The predicate on all 24 orders: the same, up to the sign of the permutation. Returns it for the order given.
int predicate_in_all_orders(const Quadruple& q)
{
  const int sign = predicate(q);
  std::array<int, 4> order = {0, 1, 2, 3};
  do {
    int parity = 1;
    for(int i = 0; i < 4; ++i)
      for(int j = i + 1; j < 4; ++j)
        if(order[i] > order[j])
          parity = -parity;
    EXPECT_EQ(predicate({q[order[0]], q[order[1]], q[order[2]], q[order[3]]}), parity * sign)
      << "order " << order[0] << order[1] << order[2] << order[3];
  } while(std::next_permutation(order.begin(), order.end()));
  return sign;
}

void expect_exact(const Quadruple& q)
{
  EXPECT_EQ(predicate_in_all_orders(q), rational_sign(q));
}

double next(double x, int steps)
{
  for(; steps > 0; --steps)
    x = std::nextafter(x, std::numeric_limits<double>::infinity());
  for(; steps < 0; ++steps)
    x = std::nextafter(x, -std::numeric_limits<double>::infinity());
  return x;
}

// Four points of one ellipse, exactly, with four different tensors whose sum has it as circle. All numbers are
// integers of few bits times powers of two, so no operation on them rounds.
//   L = (a b; 0 d) with powers of two a and d maps an ellipse of M = L^T L to a circle and back without
// rounding; the circle has integer points because its radius is a product of primes of the form 4n+1.
class Cocircular_points
{
  std::vector<std::pair<int, int>> m_circle;

public:
  Cocircular_points()
  {
    const int radius = 5 * 13 * 17;
    for(int x = -radius; x <= radius; ++x)
      for(int y = -radius; y <= radius; ++y)
        if(x * x + y * y == radius * radius)
          m_circle.emplace_back(x, y);
  }

  std::size_t size_of_circle() const { return m_circle.size(); }

  Quadruple operator()(Random_input& random, int exponent = 0, int tensor_exponent = 0) const
  {
    const int log_a = random.integer(-4, 4), log_d = random.integer(-4, 4);
    const double a = std::ldexp(1., log_a), d = std::ldexp(1., log_d), b = random.integer(-20, 20) / 4.;
    const Tensor m(a * a, a * b, b * b + d * d);
    const double center_x = random.integer(-1000, 1000), center_y = random.integer(-1000, 1000);

    // weights m/2 + n, m/2 - n, 3m/2 + n', 3m/2 - n' that sum up to 4 m
    const double n = random.integer(0, 1) == 0 ? 0 : 1. / 8, n1 = random.integer(-1, 1) / 4.;
    const Tensor shear(m.e(), 0, -m.g()), other(-m.e(), 0, m.g() / 2);
    const Tensor half = 0.5 * m, more = 1.5 * m;
    // a shear of at most an eighth of the diagonal may still break definiteness of a flat m; then do without
    std::array<Tensor, 4> tensors = {half + n * shear, half + (-n) * shear, more + n1 * other, more + (-n1) * other};
    for(const Tensor& t : tensors)
      if(!t.is_positive_definite()) {
        tensors = {half, half, more, more};
        break;
      }
    std::swap(tensors[0], tensors[random.integer(0, 3)]);

    Quadruple result;
    std::vector<std::size_t> chosen;
    for(int i = 0; i < 4; ++i) {
      std::size_t c;
      do
        c = static_cast<std::size_t>(random.integer(m_circle.size()));
      while(std::find(chosen.begin(), chosen.end(), c) != chosen.end());
      chosen.push_back(c);
      const double v = m_circle[c].second / d, u = (m_circle[c].first - b * v) / a;
      result[i] = make_point(std::ldexp(u + center_x, exponent), std::ldexp(v + center_y, exponent),
                             std::ldexp(1., tensor_exponent) * tensors[i]);
    }
    return result;
  }
};

// four points close to one ellipse of their common tensor
Quadruple nearly_cocircular(Random_input& random, double decades, double spread_of_tensors)
{
  const double pi = std::acos(-1.);
  const Tensor m = random.tensor(decades);
  std::array<Tensor, 4> tensors;
  for(Tensor& t : tensors)
    t = m + random.real(0, spread_of_tensors) * random.tensor(decades);
  const Tensor sum = CGAL::Parametric_surface_mesher::internal::common_tensor(tensors[0], tensors[1], tensors[2],
                                                                             tensors[3]);
  const double alpha = sum.alpha(), k = sum.k(), c = std::cos(alpha), s = std::sin(alpha);
  const double center_x = random.real(-1, 1), center_y = random.real(-1, 1);
  Quadruple q;
  for(int i = 0; i < 4; ++i) {
    const double t = random.real(-pi, pi), major = std::cos(t), minor = std::sin(t) / k;
    q[i] = make_point(center_x + major * c - minor * s, center_y + major * s + minor * c, tensors[i]);
  }
  return q;
}

Quadruple random_points(Random_input& random, double decades)
{
  Quadruple q;
  for(Point_2& p : q)
    p = make_point(random.real(-1, 1), random.real(-1, 1), random.tensor(decades));
  return q;
}

Quadruple scaled(const Quadruple& q, double scale, double tensor_scale)
{
  Quadruple result;
  for(int i = 0; i < 4; ++i)
    result[i] = make_point(scale * q[i].x(), scale * q[i].y(), tensor_scale * q[i].tensor());
  return result;
}

} // namespace

TEST(In_ellipse_predicate, known_signs)
{
  const Tensor m(1, 0, 4);
  const Point_2 p = make_point(2, 0, m), q = make_point(0, 1, m), r = make_point(-2, 0, m);
  EXPECT_EQ(predicate({p, q, r, make_point(0, 0, m)}), CGAL::ON_POSITIVE_SIDE);
  EXPECT_EQ(predicate({p, q, r, make_point(0, -1, m)}), CGAL::ON_ORIENTED_BOUNDARY);
  EXPECT_EQ(predicate({p, q, r, make_point(0, -1.001, m)}), CGAL::ON_NEGATIVE_SIDE);
  EXPECT_EQ(predicate({r, q, p, make_point(0, 0, m)}), CGAL::ON_NEGATIVE_SIDE);
  // inside the circle through p, q, r, outside the ellipse
  EXPECT_EQ(predicate({p, q, r, make_point(0, -1.5, m)}), CGAL::ON_NEGATIVE_SIDE);
  // inside the ellipse under the identity of the second point set
  EXPECT_EQ(predicate({Point_2(2, 0), Point_2(0, 1), Point_2(-2, 0), Point_2(0, -1.5)}), CGAL::ON_POSITIVE_SIDE);
}

TEST(In_ellipse_predicate, is_that_of_cgal_for_the_euclidean_metric)
{
  Random_input random(1);
  for(int i = 0; i < 20000; ++i) {
    Quadruple q;
    for(Point_2& p : q)
      // few bits, so that many are cocircular or collinear
      p = Point_2(random.integer(-4, 4), random.integer(-4, 4));
    EXPECT_EQ(predicate(q), Kernel().side_of_oriented_circle_2_object()(q[0], q[1], q[2], q[3]));
  }
}

TEST(In_ellipse_predicate, common_tensor_does_not_depend_on_the_order)
{
  using CGAL::Parametric_surface_mesher::internal::common_tensor;
  Random_input random(2);
  for(int i = 0; i < 5000; ++i) {
    std::array<Tensor, 4> t;
    for(Tensor& m : t)
      m = std::pow(10., random.real(-3, 3)) * random.tensor(6);
    const Tensor sum = common_tensor(t[0], t[1], t[2], t[3]);
    const double largest = sum.e() + sum.g();
    EXPECT_NEAR(sum.e(), t[0].e() + t[1].e() + t[2].e() + t[3].e(), 1e-15 * largest);
    EXPECT_NEAR(sum.f(), t[0].f() + t[1].f() + t[2].f() + t[3].f(), 1e-15 * largest);
    EXPECT_NEAR(sum.g(), t[0].g() + t[1].g() + t[2].g() + t[3].g(), 1e-15 * largest);
    std::array<int, 4> o = {0, 1, 2, 3};
    do
      EXPECT_EQ(common_tensor(t[o[0]], t[o[1]], t[o[2]], t[o[3]]), sum);
    while(std::next_permutation(o.begin(), o.end()));
  }
}

TEST(In_ellipse_predicate, cocircular_points_are_on_the_boundary)
{
  const Cocircular_points cocircular;
  ASSERT_EQ(cocircular.size_of_circle(), 108u);
  Random_input random(3);
  for(int i = 0; i < 10000; ++i) {
    const Quadruple q = cocircular(random);
    ASSERT_EQ(rational_sign(q), 0) << "the construction is not exact";
    EXPECT_EQ(predicate_in_all_orders(q), CGAL::ON_ORIENTED_BOUNDARY);
  }
}

// with sides along the axes, to which the mixed coefficient alone gives a sign; and such rectangles without area
TEST(In_ellipse_predicate, corners_of_rectangles)
{
  Random_input random(31);
  std::array<int, 3> numbers = {0, 0, 0}; // of signs
  for(int i = 0; i < 5000; ++i) {
    const double x0 = random.real(-5, 5), y0 = random.real(-5, 5), x1 = i % 50 == 0 ? x0 : random.real(-5, 5),
                 y1 = i % 50 == 1 ? y0 : random.real(-5, 5);
    const double f = random.integer(-1, 1) * std::pow(10., -random.integer(1, 40));
    std::array<Tensor, 4> m;
    for(Tensor& tensor : m)
      tensor = Tensor(random.real(1, 5), f, random.real(1, 5));
    const Quadruple q = {make_point(x0, y0, m[0]), make_point(x1, y0, m[1]), make_point(x1, y1, m[2]), make_point(x0, y1, m[3])};
    expect_exact(q);
    ++numbers[std::size_t(rational_sign(q) + 1)];
  }
  for(int number : numbers)
    EXPECT_GT(number, 1000);
}

TEST(In_ellipse_predicate, cocircular_points_at_extreme_scales)
{
  const Cocircular_points cocircular;
  Random_input random(4);
  for(int i = 0; i < 5000; ++i) {
    const Quadruple q = cocircular(random, random.integer(-490, 490), random.integer(-490, 490));
    ASSERT_EQ(rational_sign(q), 0) << "the construction is not exact";
    EXPECT_EQ(predicate_in_all_orders(q), CGAL::ON_ORIENTED_BOUNDARY);
  }
}

TEST(In_ellipse_predicate, cocircular_points_moved_by_an_ulp)
{
  const Cocircular_points cocircular;
  Random_input random(5);
  int not_zero = 0;
  for(int i = 0; i < 10000; ++i) {
    Quadruple q = cocircular(random);
    Point_2& p = q[random.integer(0, 3)];
    const int steps = random.integer(0, 1) == 0 ? 1 : -1;
    p = random.integer(0, 1) == 0 ? make_point(next(p.x(), steps), p.y(), p.tensor())
                                  : make_point(p.x(), next(p.y(), steps), p.tensor());
    expect_exact(q);
    not_zero += predicate(q) != 0;
  }
  EXPECT_GT(not_zero, 9000);
}

TEST(In_ellipse_predicate, cocircular_points_with_a_tensor_moved_by_an_ulp)
{
  const Cocircular_points cocircular;
  Random_input random(6);
  for(int i = 0; i < 10000; ++i) {
    Quadruple q = cocircular(random);
    for(Point_2& p : q) {
      const Tensor m = p.tensor();
      const Tensor moved(next(m.e(), random.integer(-1, 1)), next(m.f(), random.integer(-1, 1)),
                         next(m.g(), random.integer(-1, 1)));
      p = make_point(p.x(), p.y(), moved.is_positive_definite() ? moved : m);
    }
    expect_exact(q);
  }
}

TEST(In_ellipse_predicate, random_points)
{
  Random_input random(7);
  int inside = 0;
  for(int i = 0; i < 10000; ++i) {
    const Quadruple q = random_points(random, 2);
    expect_exact(q);
    inside += predicate(q) == CGAL::ON_POSITIVE_SIDE;
  }
  EXPECT_GT(inside, 1000);
}

TEST(In_ellipse_predicate, nearly_cocircular_points)
{
  Random_input random(8);
  for(int i = 0; i < 5000; ++i) {
    expect_exact(nearly_cocircular(random, 1, 0));
    expect_exact(nearly_cocircular(random, 1, 0.5));
  }
}

TEST(In_ellipse_predicate, very_anisotropic_tensors)
{
  Random_input random(9);
  for(int i = 0; i < 5000; ++i) {
    expect_exact(random_points(random, 6));
    expect_exact(nearly_cocircular(random, 6, 0.1));
  }
}

TEST(In_ellipse_predicate, extreme_scales)
{
  Random_input random(10);
  for(int i = 0; i < 10000; ++i) {
    const double scale = std::pow(10., random.real(-150, 150)), tensor_scale = std::pow(10., random.real(-145, 145));
    expect_exact(scaled(random_points(random, 2), scale, tensor_scale));
    expect_exact(scaled(nearly_cocircular(random, 2, 0.1), scale, tensor_scale));
  }
}

// The coordinates differ by up to 300 orders of magnitude and the tensors make good for it, so that products of
// coordinates underflow, or lifted coordinates overflow, while the determinant is of a harmless size.
TEST(In_ellipse_predicate, underflow_and_overflow_inside_the_determinant)
{
  Random_input random(11);
  for(int i = 0; i < 20000; ++i) {
    const double scale_x = std::pow(10., random.real(-160, 160)), scale_y = std::pow(10., random.real(-308, 160));
    const double scale_e = std::pow(10., random.real(-150, 150)), scale_g = std::pow(10., random.real(-150, 150));
    Quadruple q = i % 2 == 0 ? random_points(random, 1) : nearly_cocircular(random, 1, 0.1);
    for(Point_2& p : q) {
      const Tensor& m = p.tensor();
      p = make_point(scale_x * p.x(), scale_y * p.y(),
                     Tensor(scale_e * m.e(), std::sqrt(scale_e * scale_g) * m.f(), scale_g * m.g()));
      ASSERT_TRUE(p.tensor().is_positive_definite());
    }
    expect_exact(q);
  }
}

// Products of two coordinates are denormal, and round to few bits, while a huge tensor lifts the determinant
// well into the normal range: a filter that looks only at the size of the determinant trusts it.
TEST(In_ellipse_predicate, denormal_products_of_coordinates)
{
  Random_input random(15);
  const double tiny = std::numeric_limits<double>::denorm_min();
  for(int i = 0; i < 5000; ++i) {
    Quadruple q;
    for(Point_2& p : q)
      p = make_point(random.real(-1, 1), random.integer(-50, 50) * tiny, Tensor(random.real(1, 2) * 1e78, 0, 1));
    expect_exact(q);
  }
}

TEST(In_ellipse_predicate, points_far_from_the_origin)
{
  Random_input random(12);
  for(int i = 0; i < 5000; ++i) {
    Quadruple q = nearly_cocircular(random, 1, 0.1);
    const double far_x = random.real(-1e8, 1e8), far_y = random.real(-1e8, 1e8);
    for(Point_2& p : q)
      p = make_point(p.x() + far_x, p.y() + far_y, p.tensor());
    expect_exact(q);
  }
}

TEST(In_ellipse_predicate, degenerate_arguments)
{
  Random_input random(13);
  for(int i = 0; i < 2000; ++i) {
    // two points the same: on the boundary, whatever the tensors
    Quadruple q = random_points(random, 2);
    const int from = random.integer(0, 3), to = (from + random.integer(1, 3)) % 4;
    q[to] = make_point(q[from].x(), q[from].y(), q[to].tensor());
    EXPECT_EQ(predicate_in_all_orders(q), CGAL::ON_ORIENTED_BOUNDARY);

    // three or four points on a line
    Quadruple line = random_points(random, 2);
    const double dx = random.dyadic(10), dy = random.dyadic(10);
    const int n = random.integer(3, 4);
    for(int j = 0; j < n; ++j) {
      const int t = random.integer(-100, 100);
      line[j] = make_point(t * dx, t * dy, line[j].tensor());
    }
    expect_exact(line);
  }
}

// For any positive definite tensor, a point inside the ellipse of the triangle across an edge makes a strictly
// convex quadrilateral with it: the flip that follows is valid.
TEST(In_ellipse_predicate, inside_implies_a_strictly_convex_quadrilateral)
{
  Random_input random(14);
  int flips = 0;
  for(int i = 0; i < 50000; ++i) {
    const Quadruple q = i % 2 == 0 ? random_points(random, 4) : nearly_cocircular(random, 4, 0.5);
    // triangle (0, 1, 2) and the point 3 across the edge (1, 2)
    if(CGAL::orientation(q[0], q[1], q[2]) != CGAL::LEFT_TURN || CGAL::orientation(q[1], q[2], q[3]) != CGAL::RIGHT_TURN)
      continue;
    if(predicate(q) == CGAL::ON_POSITIVE_SIDE) {
      ++flips;
      EXPECT_EQ(CGAL::orientation(q[0], q[1], q[3]), CGAL::LEFT_TURN);
      EXPECT_EQ(CGAL::orientation(q[0], q[3], q[2]), CGAL::LEFT_TURN);
    }
  }
  EXPECT_GT(flips, 1000);
}
