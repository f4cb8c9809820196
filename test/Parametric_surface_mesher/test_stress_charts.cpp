// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stress tests: the coordinates that patches with collapsed sides are meshed in.
#include <CGAL/First_fundamental_form_metric_2.h>
#include <CGAL/Parametric_function_surface_3.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Charted_surface_3.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/find_chart.h>
#include <CGAL/Parametric_surface_oracle_3.h>

#include <gtest/gtest.h>

#include <stress_test_helpers.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

namespace internal = CGAL::Parametric_surface_mesher::internal;

typedef internal::Patch_chart_2<Test_kernel> Chart;
typedef internal::Boundary_loops<Test_kernel> Loops;

// The corners of a rectangle; collapsed sides are those between corners of the same index.
Loops rectangle(double u_max, double v_max, const std::vector<std::size_t>& indices)
{
  const std::vector<Point_2> corners = {{0, 0}, {u_max, 0}, {u_max, v_max}, {0, v_max}};
  Loops loops(1);
  for(std::size_t i = 0; i < 4; ++i)
    loops[0].push_back({corners[i], Point_3(0, 0, 0), indices[i]});
  return loops;
}

// A chart and back, and its jets by differences.
template <class Surface>
void check_chart(const Surface& surface, const Chart& chart, double u_max, double v_max)
{
  const internal::Charted_surface_3<Surface> charted(surface, chart);
  for(double a : {0.02, 0.3, 0.7, 0.96})
    for(double b : {0.02, 0.3, 0.7, 0.96}) {
      SCOPED_TRACE(testing::Message() << a << ", " << b);
      const Point_2 uv(a * u_max, b * v_max), z = chart.chart_point(uv), back = chart.domain_point(z);
      EXPECT_NEAR(uv.x(), back.x(), 1e-9);
      EXPECT_NEAR(uv.y(), back.y(), 1e-9);
      const double h = 1e-5 * std::hypot(z.x(), z.y());
      const auto jet = charted.jet(z.x(), z.y()), right = charted.jet(z.x() + h, z.y()), above = charted.jet(z.x(), z.y() + h),
                 left = charted.jet(z.x() - h, z.y()), below = charted.jet(z.x(), z.y() - h);
      const auto expect_near = [](const Vector_3& expected, const Vector_3& found, double size) {
        EXPECT_LT(std::sqrt((found - expected).squared_length()), 1e-3 * size) << expected << " and " << found;
      };
      const double first = std::sqrt(jet.du.squared_length() + jet.dv.squared_length());
      expect_near((right.point - left.point) / (2 * h), jet.du, first);
      expect_near((above.point - below.point) / (2 * h), jet.dv, first);
      const double second = std::sqrt(jet.duu.squared_length() + jet.duv.squared_length() + jet.dvv.squared_length());
      expect_near((right.du - left.du) / (2 * h), jet.duu, second);
      expect_near((right.dv - left.dv) / (2 * h), jet.duv, second);
      expect_near((above.du - below.du) / (2 * h), jet.duv, second);
      expect_near((above.dv - below.dv) / (2 * h), jet.dvv, second);
    }
}

// Heights over edges between points of a chart, where domain lines count: as those of the surface in its own coordinates.
template <class Surface>
void check_heights(const Surface& surface, const Chart& chart, double u_max, double v_max)
{
  typedef internal::Charted_surface_3<Surface> Charted;
  typedef internal::Patch_point_2<Test_kernel> Patch_point;
  ASSERT_TRUE(chart.keeps_domain_lines());
  const CGAL::First_fundamental_form_metric_2<Test_kernel> metric;
  const Charted charted(surface, chart);
  const auto in_chart = CGAL::make_parametric_surface_oracle(charted, metric, {});
  const auto in_domain = CGAL::make_parametric_surface_oracle(surface, metric, {});
  const auto point = [&](const Point_2& place, const Point_2& uv) {
    const auto jet = surface.jet(uv.x(), uv.y());
    return Patch_point(place, jet.point, metric.tensor(jet));
  };
  const double gamma = 100; // no part of a height is left out
  for(double a : {0.1, 0.5, 0.8})
    for(double b : {0.1, 0.5, 0.8})
      for(double step : {-0.05, 0.02, 0.1}) {
        const Point_2 p(a * u_max, b * v_max), q((a + step) * u_max, (b + 0.5 * step) * v_max);
        Patch_point z = point(chart.chart_point(p), p), w = point(chart.chart_point(q), q);
        set_line_point(charted, z);
        set_line_point(charted, w);
        EXPECT_NEAR(p.x(), z.line_point().x(), 1e-9);
        EXPECT_NEAR(p.y(), z.line_point().y(), 1e-9);
        const double expected = in_domain.squared_height(point(p, p), point(q, q), gamma);
        EXPECT_NEAR(expected, in_chart.squared_height(z, w, gamma), 1e-9 * (1 + expected));
      }
}

// the largest ratio of the chart's lengths in two perpendicular directions
template <class Surface>
double distortion(const Surface& surface, const Chart& chart, double u_max, double v_max)
{
  const internal::Charted_surface_3<Surface> charted(surface, chart);
  double result = 1;
  for(double a : {0.05, 0.5, 0.9})
    for(double b = 0.05; b < 1; b += 0.05) {
      const Point_2 z = chart.chart_point(Point_2(a * u_max, b * v_max));
      const auto jet = charted.jet(z.x(), z.y());
      const double e = jet.du * jet.du, f = jet.du * jet.dv, g = jet.dv * jet.dv, root = std::sqrt((e - g) * (e - g) + 4 * f * f);
      result = (std::max)(result, std::sqrt((e + g + root) / (e + g - root)));
    }
  return result;
}

// a tube around the z axis with a round end of radius 0.3
auto tube(double length)
{
  return CGAL::make_parametric_function_surface<Test_kernel>([length](auto u, auto v) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const auto radius = 0.3 * v / sqrt(v * v + 0.02);
    return CGAL::parametric_surface_point(radius * cos(u), radius * sin(u), length * sqrt(v * v + 0.3));
  });
}

} // namespace

TEST(Charts, one_pole)
{
  const auto hemisphere = CGAL::make_parametric_function_surface<Test_kernel>([](auto u, auto v) {
    using std::cos;
    using std::sin;
    return CGAL::parametric_surface_point(sin(v) * cos(u), sin(v) * sin(u), -cos(v));
  });
  const Chart chart = internal::find_chart(hemisphere, rectangle(6.28, 1.57, {0, 0, 1, 2}));
  ASSERT_FALSE(chart.is_identity());
  check_chart(hemisphere, chart, 6.28, 1.57);
  check_heights(hemisphere, chart, 6.28, 1.57);
}

TEST(Charts, one_pole_of_a_long_tube)
{
  for(double length : {2., 5.}) {
    SCOPED_TRACE(length);
    const Chart chart = internal::find_chart(tube(length), rectangle(6.28, 1, {0, 0, 1, 2}));
    ASSERT_FALSE(chart.is_identity());
    check_chart(tube(length), chart, 6.28, 1);
    EXPECT_LT(distortion(tube(length), chart, 6.28, 1), 1.5);
  }
}

TEST(Charts, two_poles)
{
  const auto spindle = CGAL::make_parametric_function_surface<Test_kernel>([](auto u, auto v) {
    using std::cos;
    using std::sin;
    const auto radius = 0.3 * sin(v);
    return CGAL::parametric_surface_point(radius * cos(u), radius * sin(u), 0.1 * v - cos(v));
  });
  const Chart chart = internal::find_chart(spindle, rectangle(6.28, 3.14, {0, 0, 1, 1}));
  ASSERT_FALSE(chart.is_identity());
  check_chart(spindle, chart, 6.28, 3.14);
  check_heights(spindle, chart, 6.28, 3.14);
}

// of all four corners
TEST(Charts, corner)
{
  for(int corner = 0; corner < 4; ++corner) {
    SCOPED_TRACE(corner);
    const bool is_right = corner == 1 || corner == 2, is_top = corner >= 2;
    const auto surface = CGAL::make_parametric_function_surface<Test_kernel>([=](auto u, auto v) {
      const auto s = is_right ? 2. - u : u + 0., t = is_top ? 1. - v : v + 0.;
      return CGAL::parametric_surface_point(s * t * (1. + s), s * t * (1. + 3. * t), s * t * t);
    });
    std::vector<std::size_t> indices(4, 0);
    indices[std::size_t(corner + 2) % 4] = 1;
    const Chart chart = internal::find_chart(surface, rectangle(2, 1, indices));
    ASSERT_FALSE(chart.is_identity());
    check_chart(surface, chart, 2, 1);
    EXPECT_FALSE(chart.keeps_domain_lines());
    internal::Patch_point_2<Test_kernel> point(Point_2(0.2, 0.1));
    set_line_point(internal::Charted_surface_3(surface, chart), point);
    EXPECT_EQ(point.domain_point(), point.line_point());
    EXPECT_TRUE(chart.is_pole(chart.chart_point(Point_2(is_right ? 2 : 0, 0.3))));
    EXPECT_TRUE(chart.is_pole(chart.chart_point(Point_2(0.3, is_top ? 1 : 0))));
    const Point_2 o = chart.chart_point(Point_2(1, 0.5)), p = chart.chart_point(Point_2(1.01, 0.5)), q = chart.chart_point(Point_2(1, 0.51));
    EXPECT_EQ(CGAL::LEFT_TURN, CGAL::orientation(o, p, q));
  }
}
