// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polishing: the qualities that it counts, the way up their slope, and that no more triangles fail a criterion after it.
#include <CGAL/Mesh_2/Face_badness.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Patch_polishing.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Vertex_star.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Triangle_quality.h>

#include <mesher_test_helpers.h>
#include <plane_patch.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>

namespace {

namespace internal = CGAL::Parametric_surface_mesher::internal;
using CGAL::Parametric_surface_mesher::Criterion_set;
using CGAL::Parametric_surface_mesher::Mesh_criterion;

typedef Plane_triangulation::Face_handle Face_handle;
typedef Plane_triangulation::Vertex_handle Vertex_handle;
typedef Plane_kernel::Point_2 Plane_point;
typedef internal::Vertex_star<Plane_triangulation, Plane_oracle::Metric_field> Star;
typedef internal::Mean_ratio_and_angle Quality;

const double pi = 4 * std::atan(1.);

// A wheel of triangles around one inner vertex.
struct Wheel
{
  Plane_triangulation triangulation;
  Vertex_handle center;

  explicit Wheel(const Plane_point& p, int number_of_spokes = 6)
  {
    for(int i = 0; i < number_of_spokes; ++i) {
      const double angle = 2 * pi * i / number_of_spokes;
      triangulation.insert(at(Plane_point(std::cos(angle), std::sin(angle))))->set_on_boundary(true);
    }
    center = triangulation.insert(at(p));
    std::size_t index = 0;
    for(Vertex_handle vertex : triangulation.finite_vertex_handles()) {
      vertex->set_index(index++);
      vertex->set_spacing(1);
    }
    for(Face_handle face : triangulation.finite_face_handles()) {
      face->set_in_domain(true);
      face->set_verdict({{}, internal::Scope::WHOLE});
    }
  }

  double distance() const { return std::hypot(center->point().x(), center->point().y()); }
};

// what fails is for the test to say
struct Own_judge
{
  std::function<bool(Face_handle)> fails = [](Face_handle) { return false; };

  Criterion_set first_failed(Face_handle face) const
  {
    return fails(face) ? Criterion_set(Mesh_criterion::ANGLE) : Criterion_set();
  }

  bool is_inverted(Face_handle) const { return false; }
};

// returns the number of moves
std::size_t polish(Wheel& wheel, const Own_judge& judge, int number_of_sweeps)
{
  const Plane_evaluator evaluate{};
  internal::Patch_polishing<Plane_evaluator, Own_judge> sweep(wheel.triangulation, evaluate, judge, Criteria().set_min_edge(1e-6));
  std::size_t result = 0;
  for(int i = 0; i < number_of_sweeps; ++i)
    result += sweep([] { return true; });
  return result;
}

double mean_quality(const Wheel& wheel, const Plane_point& p)
{
  Star star(wheel.triangulation, Plane_oracle::Metric_field());
  star.collect(wheel.center);
  return star.shape(at(p), Quality()).quality.mean;
}

} // namespace

TEST(Triangle_quality, of_known_triangles)
{
  EXPECT_DOUBLE_EQ(1, internal::Squared_mean_ratio()({4, 4, 4}));
  EXPECT_DOUBLE_EQ(1, Quality()({4, 4, 4}));
  EXPECT_EQ(0, Quality()({1, 1, 4})); // on a line
  // half a square: (3 / 4, and sin^2 45 = 1/2 over 3/4) by weights of 1 and 1/2
  EXPECT_DOUBLE_EQ((3. / 4 + 0.5 * 2 / 3) / 1.5, Quality()({1, 1, 2}));
}

TEST(Triangle_quality, derivatives)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  int number_compared = 0;
  for(int n = 0; n < 200; ++n) {
    const double ax = coordinate(random), ay = coordinate(random), bx = coordinate(random), by = coordinate(random);
    const std::array<double, 3> lengths{(ax - bx) * (ax - bx) + (ay - by) * (ay - by), ax * ax + ay * ay, bx * bx + by * by};
    const double step = 1e-6 * lengths[1];
    const auto shortest = [](const std::array<double, 3>& l) { return std::min_element(l.begin(), l.end()) - l.begin(); };
    const std::array<double, 2> derivatives = Quality().derivatives(lengths);
    for(int i : {1, 2}) {
      std::array<double, 3> more = lengths, less = lengths;
      more[i] += step;
      less[i] -= step;
      if(shortest(more) != shortest(less) || internal::squared_area_16(less) < 1e-2 || internal::squared_area_16(more) < 1e-2)
        continue; // a kink, or nearly a line
      const double expected = (Quality()(more) - Quality()(less)) / (2 * step);
      EXPECT_NEAR(expected, derivatives[i - 1], 1e-4 * (1 + std::abs(expected)));
      ++number_compared;
    }
  }
  EXPECT_GT(number_compared, 300);
}

TEST(Vertex_star, no_direction_is_steeper)
{
  std::mt19937 random(6);
  std::uniform_real_distribution<double> coordinate(-0.3, 0.3);
  for(int n = 0; n < 20; ++n) {
    const Plane_point p(coordinate(random), coordinate(random));
    const Wheel wheel(p, 5 + n % 3);
    Star star(wheel.triangulation, Plane_oracle::Metric_field());
    star.collect(wheel.center);
    const double before = star.quality(Quality()).mean, step = 1e-6;
    const auto direction = star.direction_of_ascent(Quality());
    EXPECT_NEAR(1, direction.squared_length(), 1e-12);
    const double gain = mean_quality(wheel, p + step * direction) - before;
    EXPECT_GT(gain, 0);
    for(int k = 0; k < 36; ++k) {
      const Plane_kernel::Vector_2 other(std::cos(k * pi / 18), std::sin(k * pi / 18));
      EXPECT_LE(mean_quality(wheel, p + step * other) - before, gain + 1e-3 * step);
    }
  }
}

TEST(Patch_polishing, climbs_to_the_middle)
{
  Wheel wheel(Plane_point(0.12, 0.1));
  const double before = mean_quality(wheel, wheel.center->point());
  EXPECT_GT(polish(wheel, Own_judge(), 20), 3u);
  EXPECT_GT(mean_quality(wheel, wheel.center->point()), before);
  EXPECT_LT(wheel.distance(), 0.06); // as good as perfect
}

TEST(Patch_polishing, leaves_what_is_perfect)
{
  Wheel wheel(Plane_point(0.001, 0));
  EXPECT_EQ(0u, polish(wheel, Own_judge(), 3));
  EXPECT_EQ(at(Plane_point(0.001, 0)), wheel.center->point());
}

TEST(Patch_polishing, leaves_what_is_kept)
{
  Wheel wheel(Plane_point(0.12, 0.1));
  wheel.center->set_kept(true);
  EXPECT_EQ(0u, polish(wheel, Own_judge(), 3));
}

// All that is left of x = 0.1 fails.
TEST(Patch_polishing, makes_no_triangle_fail)
{
  Wheel wheel(Plane_point(0.12, 0.1));
  const Own_judge judge{[&](Face_handle) { return wheel.center->point().x() < 0.1; }};
  EXPECT_GT(polish(wheel, judge, 20), 0u);
  EXPECT_GE(wheel.center->point().x(), 0.1);
  for(Face_handle face : wheel.triangulation.finite_face_handles())
    EXPECT_FALSE(face->verdict().fails());
}

// What fails anyway may be made better.
TEST(Patch_polishing, moves_what_fails)
{
  Wheel wheel(Plane_point(0.12, 0.1));
  for(Face_handle face : wheel.triangulation.finite_face_handles())
    face->set_verdict({Mesh_criterion::ANGLE, internal::Scope::WHOLE});
  EXPECT_GT(polish(wheel, Own_judge{[](Face_handle) { return true; }}, 20), 3u);
  EXPECT_LT(wheel.distance(), 0.06);
  for(Face_handle face : wheel.triangulation.finite_face_handles())
    EXPECT_TRUE(face->verdict().fails());
}
