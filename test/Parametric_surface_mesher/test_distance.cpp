// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

// The distance that is asked for is kept everywhere, and no feature of a surface or of its boundary is missed.

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/B_spline_surface_3.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Parametric_surface_mesher/divide_curve.h>

#include <gtest/gtest.h>

#include <mesher_test_helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

using CGAL::Parametric_surface_mesher::Mesh_criterion;
using CGAL::Parametric_surface_mesher::Unmet_cause;

namespace {

typedef CGAL::Surface_jet_3<Test_kernel> Jet;

// Surfaces of one type, so that the mesher is compiled once.
struct Any_surface
{
  typedef Test_kernel Geom_traits;

  std::function<Jet(double, double)> function;

  Point_3 point(double u, double v) const { return function(u, v).point; }
  Jet jet(double u, double v) const { return function(u, v); }
};

template <class Surface>
Any_surface any_surface(const Surface& surface)
{
  return {[=](double u, double v) { return surface.jet(u, v); }};
}

// Gaussian peaks over a plane.
struct Peaks
{
  std::vector<Point_2> tops;
  double width, height;

  Jet jet(double u, double v) const
  {
    Jet result = {Point_3(u, v, 0), Vector_3(1, 0, 0), Vector_3(0, 1, 0), Vector_3(0, 0, 0), Vector_3(0, 0, 0), Vector_3(0, 0, 0)};
    for(const Point_2& top : tops) {
      const double x = (u - top.x()) / width, y = (v - top.y()) / width, z = height * std::exp(-x * x - y * y);
      result.point = result.point + Vector_3(0, 0, z);
      result.du = result.du + Vector_3(0, 0, -2 * x * z / width);
      result.dv = result.dv + Vector_3(0, 0, -2 * y * z / width);
      result.duu = result.duu + Vector_3(0, 0, (4 * x * x - 2) * z / (width * width));
      result.duv = result.duv + Vector_3(0, 0, 4 * x * y * z / (width * width));
      result.dvv = result.dvv + Vector_3(0, 0, (4 * y * y - 2) * z / (width * width));
    }
    return result;
  }
};

const Domain unit_square = Domain::rectangle(0, 1, 0, 1);

// The largest distance from the mesh of samples of the surface: of all triangles that the report does not list, on as many lines
// as a side has parts.
double largest_distance(const Mesh& mesh, const Any_surface& surface, const Report& report, int parts)
{
  typedef CGAL::AABB_tree<CGAL::AABB_traits<Test_kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>> Tree;
  const Tree tree(mesh.faces().begin(), mesh.faces().end(), mesh);
  const auto unmet = unmet_by_face(report);
  const Uv_map uv = uv_map(mesh);
  double result = 0;
  for(const Mesh::Face_index f : mesh.faces()) {
    if(unmet.count(std::size_t(f)) > 0)
      continue;
    const auto v = corners(mesh, f);
    const Test_kernel::Triangle_3 triangle(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
    for(int i = 0; i <= parts; ++i)
      for(int k = 0; i + k <= parts; ++k) {
        const Point_2 p = CGAL::barycenter(uv[v[0]], double(i), uv[v[1]], double(k), uv[v[2]], double(parts - i - k));
        const Point_3 s = surface.point(p.x(), p.y());
        if(CGAL::squared_distance(s, triangle) > result * result)
          result = (std::max)(result, std::sqrt(tree.squared_distance(s)));
      }
  }
  return result;
}

Criteria coarse_criteria(double distance)
{
  Criteria criteria;
  return criteria.set_max_edge(10).set_min_edge(1e-3).set_angle(0).set_gamma(10).set_distance(distance);
}

TEST(Distance, peak_with_a_large_maximum_edge)
{
  const Any_surface peak = any_surface(Peaks{{Point_2(0.5, 0.5)}, 0.12, 0.8});
  Mesh mesh;
  const Report report = add_patch(peak, unit_square, coarse_criteria(0.01), mesh);
  EXPECT_LE(report.unmet.size(), mesh.number_of_faces() / 20);
  EXPECT_LE(largest_distance(mesh, peak, report, 30), 0.01);
}

TEST(Distance, narrow_peaks_at_random_places)
{
  std::mt19937 random(22);
  std::uniform_real_distribution<double> place(0.1, 0.9);
  for(int i = 0; i < 12; ++i) {
    Peaks peaks{{}, 1. / 60, 0.1}; // half as high over 1/36, a hundredth as high over 1/14
    for(int k = 0; k <= i % 3; ++k) {
      const double u = place(random), v = place(random);
      peaks.tops.emplace_back(u, v);
    }
    const Any_surface surface = any_surface(peaks);
    Mesh mesh;
    const Report report = add_patch(surface, unit_square, i % 2 == 0 ? coarse_criteria(0.005) : Criteria().set_max_edge(0.5), mesh);
    EXPECT_LE(report.unmet.size(), mesh.number_of_faces() / 20) << i;
    double highest = 0;
    for(const Mesh::Vertex_index v : mesh.vertices())
      highest = (std::max)(highest, mesh.point(v).z());
    EXPECT_GE(highest, 0.09) << i;
    if(i % 2 == 0) {
      EXPECT_LE(largest_distance(mesh, surface, report, 30), 0.005) << i;
    }
  }
}

// What is found and cannot be followed is told, with the cause.
void expect_one_unmet(const Criteria& criteria, Mesh_criterion criterion, Unmet_cause cause)
{
  const Any_surface peak = any_surface(Peaks{{Point_2(0.41, 0.62)}, 1. / 60, 0.1});
  Mesh mesh;
  const Report report = add_patch(peak, unit_square, criteria, mesh);
  EXPECT_EQ(mesh.number_of_faces(), 2u);
  ASSERT_EQ(report.unmet.size(), 1u);
  EXPECT_TRUE(report.unmet[0].criteria.contains(criterion));
  EXPECT_EQ(report.unmet[0].cause, cause);
}

TEST(Distance, peak_that_cannot_be_followed)
{
  const Criteria flat = coarse_criteria(0.005);
  expect_one_unmet(Criteria(flat).set_min_edge(2), Mesh_criterion::DISTANCE, Unmet_cause::MINIMUM_EDGE);
  expect_one_unmet(Criteria(flat).set_max_number_of_vertices(4), Mesh_criterion::DISTANCE, Unmet_cause::VERTEX_LIMIT);
  expect_one_unmet(Criteria().set_max_edge(10).set_min_edge(2).set_angle(0).set_gamma(0.05), Mesh_criterion::DEVIATION,
                   Unmet_cause::MINIMUM_EDGE);
}

TEST(Distance, no_look_is_no_promise)
{
  const Any_surface surface = any_surface(Peaks{{Point_2(0.41, 0.62)}, 1. / 60, 0.1});
  Mesh mesh;
  add_patch(surface, unit_square, coarse_criteria(0.005).set_feature_resolution(0), mesh);
  EXPECT_LE(mesh.number_of_faces(), 4u);
}

// Bumps with feet where the curve is halved.
struct Bumpy_curve
{
  typedef Test_kernel Geom_traits;

  double number_of_bumps, height;

  double begin() const { return 0; }
  double end() const { return 1; }
  double rise(double t) const { return std::sin(number_of_bumps * CGAL_PI * t); }
  double slope(double t) const
  {
    return 2 * number_of_bumps * CGAL_PI * height * rise(t) * std::cos(number_of_bumps * CGAL_PI * t);
  }
  Point_3 point(double t) const { return Point_3(t, height * rise(t) * rise(t), 0); }
  double speed(double t) const { return std::sqrt(1 + slope(t) * slope(t)); }
  double curvature_radius(double) const { return 1; }
};

TEST(Distance, curve_with_symmetric_bumps)
{
  for(double n : {4., 8., 16., 24.}) {
    const Bumpy_curve curve{n, 0.05};
    const std::vector<double> division
      = CGAL::Parametric_surface_mesher::divide_curve(curve, coarse_criteria(0.01));
    double farthest = 0;
    for(std::size_t i = 0; i + 1 < division.size(); ++i) {
      const Test_kernel::Segment_3 chord(curve.point(division[i]), curve.point(division[i + 1]));
      for(int k = 1; k < 400; ++k)
        farthest = (std::max)(farthest, CGAL::squared_distance(
                                          curve.point(division[i] + (division[i + 1] - division[i]) * k / 400), chord));
    }
    EXPECT_LE(std::sqrt(farthest), 0.01) << n;
  }
}

// Of degree 3 in u, with a row of control points drawn out between narrow knots.
Any_surface b_spline_with_sharp_knots()
{
  std::vector<Point_3> points;
  for(int k = 0; k < 2; ++k)
    for(int i = 0; i < 8; ++i)
      points.emplace_back(i / 7., k, i == 4 ? 0.2 : 0.);
  return any_surface(CGAL::B_spline_surface_3<Test_kernel>(3, 1, {0, 0, 0, 0, 0.5, 0.55, 0.55, 0.6, 1, 1, 1, 1}, {0, 0, 1, 1}, points));
}

TEST(Distance, dense_samples)
{
  struct Patch
  {
    std::string name;
    Any_surface surface;
    Domain domain;
  };
  const std::vector<Patch> patches
    = {{"sphere", any_surface(CGAL::Parametric_sphere_3<Test_kernel>(1)), Domain::rectangle(0, 2, -1, 1)},
       {"torus", any_surface(CGAL::Parametric_torus_3<Test_kernel>(1, 0.3)), Domain::rectangle(0, 2, 0, 4)},
       {"cylinder", any_surface(CGAL::Parametric_cylinder_3<Test_kernel>(1)), Domain::rectangle(0, 4, 0, 2)},
       {"B-spline", b_spline_with_sharp_knots(), unit_square}};
  for(const Patch& patch : patches)
    for(double distance : {1e-2, 1e-3}) {
      Mesh mesh;
      Criteria criteria;
      criteria.set_max_edge(1).set_min_edge(1e-3).set_gamma(10).set_distance(distance);
      const Report report = add_patch(patch.surface, patch.domain, criteria, mesh);
      EXPECT_LE(report.unmet.size(), mesh.number_of_faces() / 50) << patch.name << " " << distance;
      EXPECT_LE(largest_distance(mesh, patch.surface, report, 12), distance) << patch.name;
    }
}

} // namespace
