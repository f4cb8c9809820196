// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <CGAL/First_fundamental_form_metric_2.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Spacing_limit.h>
#include <CGAL/Parametric_surface_oracle_3.h>

#include <mesher_test_helpers.h>
#include <random_input.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace {

typedef CGAL::Surface_jet_3<Test_kernel> Jet;
typedef Test_kernel::Vector_3 Vector_3;

// the same jet everywhere
struct Jet_surface
{
  typedef Test_kernel Geom_traits;

  Jet constant_jet;

  Point_3 point(double, double) const { return constant_jet.point; }
  Jet jet(double, double) const { return constant_jet; }
};

typedef CGAL::First_fundamental_form_metric_2<Test_kernel> Metric;
typedef CGAL::Parametric_surface_oracle_3<Jet_surface, Metric> Oracle;

Vector_3 random_vector(Random_input& random, double size)
{
  return Vector_3(random.real(-size, size), random.real(-size, size), random.real(-size, size));
}

// of lengths and directions that vary by orders of magnitude
Jet random_jet(Random_input& random)
{
  const auto size = [&] { return std::pow(10., random.real(-1.5, 1.5)); };
  const double u = size(), v = size(), bend = size();
  return {Point_3(0, 0, 0),
          random_vector(random, u),
          random_vector(random, v),
          random_vector(random, bend * u * u),
          random_vector(random, bend * u * v),
          random_vector(random, bend * v * v)};
}

double limit(const Jet& jet, Criteria criteria)
{
  criteria.set_min_edge(1e-9); // it has to be set, and does not matter here
  const Jet_surface surface{jet};
  const Metric metric;
  const Oracle oracle(surface, metric);
  const CGAL::Parametric_surface_mesher::internal::Spacing_limit<Oracle> limit(oracle, criteria, CGAL::Bbox_2());
  return limit.by_curvature(Point_2(0, 0), jet);
}

} // namespace

// Whether curvatures are computed, or a bound tells that they do not matter: a maximum edge only cuts off what is above it.
TEST(Spacing_limit, is_that_of_the_curvature_up_to_the_maximum_edge)
{
  Random_input random(11);
  std::size_t number_of_limited = 0;
  const std::size_t n = 20000;
  for(std::size_t i = 0; i < n; ++i) {
    const Jet jet = random_jet(random);
    Criteria criteria;
    criteria.set_gamma(0.1).set_max_edge(1e30);
    if(i % 2 == 1)
      criteria.set_distance(0.01);
    const double by_curvature = limit(jet, criteria), max_edge = std::pow(10., random.real(-3, 1));
    EXPECT_DOUBLE_EQ((std::min)(by_curvature, max_edge), limit(jet, criteria.set_max_edge(max_edge)));
    number_of_limited += by_curvature < max_edge;
  }
  EXPECT_GT(number_of_limited, n / 5);
  EXPECT_LT(number_of_limited, 4 * n / 5);
}

TEST(Spacing_limit, flat)
{
  const Vector_3 zero(0, 0, 0);
  for(const Jet& jet : {Jet{Point_3(0, 0, 0), Vector_3(1, 0, 0), Vector_3(0.3, 2, 0), zero, zero, zero},
                        Jet{Point_3(0, 0, 0), zero, zero, zero, zero, zero}})
    EXPECT_EQ(3, limit(jet, Criteria().set_max_edge(3)));
}

// Curvature does not depend on the unit of the parameters, whatever underflows on the way.
TEST(Spacing_limit, in_any_unit_of_the_domain)
{
  for(double unit : {1e-45, 1e-20, 1., 1e20, 1e45}) {
    const Vector_3 bend(0, 0, unit * unit);
    const Jet jet{Point_3(0, 0, 0), Vector_3(unit, 0, 0), Vector_3(0, unit, 0), bend, Vector_3(0, 0, 0), bend};
    EXPECT_NEAR(0.7, limit(jet, Criteria().set_gamma(0.1).set_max_edge(10)), 1e-12) << unit;
  }
}
