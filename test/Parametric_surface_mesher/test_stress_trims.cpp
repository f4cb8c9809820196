// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stress tests: trims that are thin, that nearly touch or do touch, and that cross.
#include <gtest/gtest.h>

#include <stress_test_helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef Domain::Loop Loop;

const Point_2 origin(0, 0);

Sample_surface paraboloid() { return Sample_surface(sample_surfaces::Paraboloid()); }

Loop circle(const Point_2& center, double radius) { return {Curve::circle(center, radius)}; }

Domain with_holes(Domain domain, const std::vector<Loop>& holes)
{
  for(const Loop& hole : holes)
    domain.add_hole(hole);
  return domain;
}

Domain square() { return Domain::rectangle(0, 1, 0, 1); }

// the arc from `p` to `q` with its middle at `height` to the left of the chord
Curve arc_over(const Point_2& p, const Point_2& q, double height)
{
  const Vector_2 chord = q - p, left(-chord.y(), chord.x());
  const double half = 0.5 * std::sqrt(chord.squared_length()), h = std::fabs(height),
               radius = (half * half + h * h) / (2 * h), sign = height > 0 ? 1 : -1;
  const Point_2 center = CGAL::midpoint(p, q) + (sign * (h - radius) / (2 * half)) * left;
  const double half_angle = 2 * std::atan2(h, half), middle = std::atan2(sign * left.y(), sign * left.x());
  Curve curve = Curve::arc(center, radius, middle + sign * half_angle, middle - sign * half_angle);
  curve.set_end_points(p, q);
  return curve;
}

// the part of a curve from its parameter `begin` to `end`
Curve part(const Curve& curve, double begin, double end)
{
  Curve result([curve](double t) { return curve.jet(t); }, begin, end);
  result.set_end_points(curve.point(begin), curve.point(end));
  return result;
}

// the curve in two, so that its points are not those beside another curve
std::pair<Curve, Curve> parts(const Curve& curve)
{
  const double middle = 0.62 * curve.begin() + 0.38 * curve.end();
  return {part(curve, curve.begin(), middle), part(curve, middle, curve.end())};
}

// the same circle, but begun elsewhere
Loop turned_circle(const Point_2& center, double radius)
{
  Curve curve = Curve::arc(center, radius, 0.05, 0.05 + 2 * pi);
  curve.set_end_points(curve.source(), curve.source());
  return {curve};
}

// the area between an arc and its chord
double area_of_segment(double chord, double height)
{
  const double half = chord / 2, radius = (half * half + height * height) / (2 * height),
               angle = 4 * std::atan2(height, half);
  return radius * radius / 2 * (angle - std::sin(angle));
}

// Meshes a trimmed plane; with its exact area as far as the division can tell.
Meshed mesh_flat(const Domain& domain, double max_edge, double area, double tolerance)
{
  const Meshed m = mesh_and_check(flat(), domain, Criteria().set_max_edge(max_edge));
  EXPECT_NEAR(1, m.area / area, tolerance);
  for(std::size_t t = 0; t < m.triangles.size(); ++t)
    EXPECT_GT(m.area_vector(t).z(), 0) << t;
  return m;
}

// The strip beside a spiral, closed by short segments.
Domain spiral_strip(double width, double turns)
{
  const auto spiral = [](double offset) {
    return [offset](auto t) {
      using std::cos;
      using std::sin;
      const auto radius = 0.3 + offset + 0.1 * t;
      return std::make_pair(radius * cos(t), radius * sin(t));
    };
  };
  const Curve inner = Curve::from_function(spiral(0), 0, 2 * pi * turns),
              outer = Curve::from_function(spiral(width), 2 * pi * turns, 0);
  const auto outer_parts = parts(outer);
  return Domain(Loop{inner, Curve::segment(inner.target(), outer.source()), outer_parts.first, outer_parts.second,
                     Curve::segment(outer.target(), inner.source())});
}

double area_of_spiral_strip(double width, double turns)
{
  const double t = 2 * pi * turns;
  const auto area = [t](double radius) { return (std::pow(radius + 0.1 * t, 3) - std::pow(radius, 3)) / 0.6; };
  return area(0.3 + width) - area(0.3);
}

// The plane, or a surface above it, in two faces: the ring between two circles and the disk inside the smaller one.
Model ring_and_disk(const Sample_surface& surface, double inner_radius)
{
  Model model;
  const Curve outer_circle = Curve::circle(origin, 1), inner_circle = turned_circle(origin, inner_radius).front();
  const std::size_t v = model.add_vertex(surface.point(1, 0)),
                    w = model.add_vertex(surface.point(inner_circle.source().x(), inner_circle.source().y()));
  const std::size_t outer = model.add_edge(v, v), inner = model.add_edge(w, w);
  model.add_face({surface, {{{outer, false, outer_circle}}, {{inner, false, inner_circle}}}});
  model.add_face({surface, {{{inner, false, inner_circle}}}});
  return model;
}

// Two faces between arcs from p to q: a crescent and what is beside it. The arc between them is two edges.
Model crescent_and_neighbour(const Sample_surface& surface, double low, double middle, double high)
{
  Model model;
  const Point_2 p(0, 0), q(1, 0);
  const auto between = parts(arc_over(p, q, middle));
  const Point_2& m = between.first.target();
  const std::size_t v = model.add_vertex(surface.point(0, 0)), w = model.add_vertex(surface.point(1, 0)),
                    x = model.add_vertex(surface.point(m.x(), m.y()));
  const std::size_t a = model.add_edge(v, w), b = model.add_edge(v, x), c = model.add_edge(x, w), d = model.add_edge(v, w);
  model.add_face({surface, {{{a, false, arc_over(p, q, low)}, {c, true, between.second}, {b, true, between.first}}}});
  model.add_face({surface, {{{b, false, between.first}, {c, false, between.second}, {d, true, arc_over(p, q, high)}}}});
  return model;
}

// Two faces that share an edge fit: no border along it, and no vertex twice.
void check_fit(const Model& model, double max_edge, double area, double tolerance)
{
  const Meshed m = mesh_and_check(model, Criteria().set_max_edge(max_edge));
  EXPECT_GT(m.report.number_of_split_boundary_edges, 0u);
  expect_topology(m, 1, 1, 1);
  expect_distinct_points(m.mesh);
  EXPECT_NEAR(1, m.area / area, tolerance);
}

void expect_patch_refused(const Domain& domain, double max_edge, const std::string& first, const std::string& second)
{
  Mesh mesh;
  const Criteria criteria = Criteria().set_max_edge(max_edge);
  expect_refused([&] { CGAL::make_parametric_surface_mesh(flat(), domain, criteria, mesh); }, "cross", first, second);
  EXPECT_EQ(0u, mesh.number_of_vertices());
}

} // namespace

TEST(Thin_trims, slivers)
{
  for(double width : {0.1, 0.01, 0.001, 1e-6}) {
    SCOPED_TRACE(width);
    const Meshed m = mesh_flat(Domain::rectangle(0, 1, 0, width), 0.1, width, 1e-9);
    expect_topology(m, 1, 1, 1);
    EXPECT_LE(m.triangles.size(), 5000u);
  }
}

TEST(Thin_trims, slanted_sliver)
{
  const Domain sliver({Point_2(0, 0), Point_2(0.6, 0.8), Point_2(0.5992, 0.8006), Point_2(-0.0008, 0.0006)});
  const Meshed m = mesh_flat(sliver, 0.1, 0.001, 1e-6);
  expect_topology(m, 1, 1, 1);
}

TEST(Thin_trims, needle_triangle)
{
  for(double height : {0.1, 0.001, 1e-5}) {
    SCOPED_TRACE(height);
    const Meshed m = mesh_flat(Domain({Point_2(0, 0), Point_2(1, 0), Point_2(0.9, height)}), 0.1, height / 2, 1e-6);
    expect_topology(m, 1, 1, 1);
    EXPECT_LE(m.triangles.size(), 5000u);
  }
}

// The polygons of two nearly equal circles that begin at the same angle do not cross, others do.
TEST(Thin_trims, rings)
{
  for(bool is_turned : {false, true})
    for(double gap : {0.1, 0.01, 0.001, 1e-4, 1e-6}) {
      SCOPED_TRACE(gap);
      const Loop inner = is_turned ? turned_circle(origin, 1 - gap) : circle(origin, 1 - gap);
      const Meshed m = mesh_and_check(flat(), with_holes(Domain(circle(origin, 1)), {inner}), Criteria().set_max_edge(0.3));
      expect_topology(m, 1, 2, 0);
      EXPECT_NEAR(1, m.area / (pi * gap * (2 - gap)), gap > 0.05 ? 0.1 : 1);
      EXPECT_EQ(is_turned && gap < 0.005, m.report.number_of_split_boundary_edges > 0);
      EXPECT_LE(m.triangles.size(), 40000u);
    }
}

TEST(Thin_trims, lens_between_two_arcs)
{
  for(double height : {0.1, 0.01, 0.001}) {
    SCOPED_TRACE(height);
    const Point_2 p(0, 0), q(1, 0);
    const Domain lens(Loop{arc_over(q, p, height), arc_over(p, q, height)});
    const Meshed m = mesh_flat(lens, 0.2, 2 * area_of_segment(1, height), 0.05);
    expect_topology(m, 1, 1, 1);
  }
}

TEST(Thin_trims, crescents)
{
  for(double difference : {0.05, 0.005, 0.0005}) {
    SCOPED_TRACE(difference);
    const Point_2 p(0, 0), q(1, 0);
    const auto below = parts(arc_over(p, q, 0.25));
    const Domain crescent(Loop{below.first, below.second, arc_over(q, p, -0.25 - difference)});
    const double area = area_of_segment(1, 0.25 + difference) - area_of_segment(1, 0.25);
    const Meshed m = mesh_and_check(flat(), crescent, Criteria().set_max_edge(0.3));
    expect_topology(m, 1, 1, 1);
    EXPECT_NEAR(1, m.area / area, 0.4);
    EXPECT_TRUE(difference > 0.01 || m.report.number_of_split_boundary_edges > 0);
  }
}

TEST(Thin_trims, spiral_strip)
{
  for(double width : {0.2, 0.02, 0.002}) {
    SCOPED_TRACE(width);
    const Meshed m = mesh_and_check(flat(), spiral_strip(width, 2), Criteria().set_max_edge(0.4));
    expect_topology(m, 1, 1, 1);
    EXPECT_NEAR(1, m.area / area_of_spiral_strip(width, 2), 0.2);
    EXPECT_TRUE(width > 0.01 || m.report.number_of_split_boundary_edges > 0);
  }
}

TEST(Thin_trims, strip_around_a_cylinder)
{
  const Sample_surface cylinder(CGAL::Parametric_cylinder_3<Test_kernel>(1));
  const Domain strip({Point_2(0, 0), Point_2(12, 4), Point_2(12, 4.01), Point_2(0, 0.01)});
  const Meshed m = mesh_and_check(cylinder, strip, Criteria().set_max_edge(0.2));
  expect_topology(m, 1, 1, 1);
  EXPECT_NEAR(1, m.area / 0.12, 0.02);
}

TEST(Thin_trims, comb)
{
  std::vector<Point_2> points = {Point_2(0, 0)};
  for(int i = 0; i < 20; ++i) {
    points.emplace_back(i, i == 0 ? 1 : 0.1);
    points.emplace_back(i + 0.02, 1);
    points.emplace_back(i + 0.98, 1);
    points.emplace_back(i + 0.99, 0.1);
  }
  points[1] = Point_2(0, 0.1);
  points.emplace_back(20, 0);
  std::reverse(points.begin(), points.end());
  const Meshed m = mesh_and_check(flat(), Domain(points), Criteria().set_max_edge(0.5));
  expect_topology(m, 1, 1, 1);
}

TEST(Close_trims, hole_near_the_outer_loop)
{
  for(double gap : {0.005, 1e-4, 1e-6}) {
    SCOPED_TRACE(gap);
    const Meshed m = mesh_flat(with_holes(square(), {circle(Point_2(0.2 + gap, 0.5), 0.2)}), 0.1, 1 - pi * 0.04, 0.01);
    expect_topology(m, 1, 2, 0);
    EXPECT_LE(m.triangles.size(), 4000u);
  }
}

TEST(Close_trims, hole_in_a_corner)
{
  const Meshed m = mesh_flat(with_holes(square(), {circle(Point_2(0.2005, 0.2005), 0.2)}), 0.1, 1 - pi * 0.04, 0.01);
  expect_topology(m, 1, 2, 0);
}

TEST(Close_trims, two_holes_that_nearly_touch)
{
  for(double gap : {1e-2, 1e-4, 1e-7}) {
    SCOPED_TRACE(gap);
    const Meshed m = mesh_flat(
      with_holes(square(), {circle(Point_2(0.3 - gap / 2, 0.5), 0.2), circle(Point_2(0.7 + gap / 2, 0.51), 0.2)}), 0.1,
      1 - 2 * pi * 0.04, 0.02);
    expect_topology(m, 1, 3, -1);
  }
}

TEST(Close_trims, many_holes)
{
  std::vector<Loop> holes;
  for(int i = 0; i < 8; ++i)
    for(int j = 0; j < 8; ++j)
      holes.push_back(circle(Point_2((i + 0.5) / 8, (j + 0.5) / 8), 0.0615));
  const Meshed m = mesh_flat(with_holes(square(), holes), 0.1, 1 - 64 * pi * 0.0615 * 0.0615, 0.12);
  expect_topology(m, 1, 65, -63);
}

TEST(Close_trims, hole_on_a_curved_surface)
{
  const Domain domain = with_holes(Domain::rectangle(-1, 1, -1, 1), {circle(Point_2(-0.497, 0), 0.5)});
  const Meshed m = mesh_and_check(paraboloid(), domain, Criteria().set_max_edge(0.2));
  expect_topology(m, 1, 2, 0);
}

// The hole opens to the corner: what is left is a disk, bent around it.
TEST(Touching_loops, hole_at_a_corner_of_the_outer_loop)
{
  const Loop hole = Domain::polygon({Point_2(0, 0), Point_2(0.5, 0.1), Point_2(0.5, 0.5), Point_2(0.1, 0.5)});
  const Meshed m = mesh_flat(with_holes(square(), {hole}), 0.1, 1 - 0.2, 1e-9);
  expect_topology(m, 1, 1, 1);
}

TEST(Touching_loops, two_holes_with_a_common_corner)
{
  const Loop a = Domain::polygon({Point_2(0.5, 0.5), Point_2(0.8, 0.5), Point_2(0.8, 0.8)}),
             b = Domain::polygon({Point_2(0.5, 0.5), Point_2(0.2, 0.5), Point_2(0.2, 0.2)});
  const Meshed m = mesh_flat(with_holes(square(), {a, b}), 0.1, 1 - 0.09, 1e-9);
  expect_topology(m, 1, 2, 0);
}

TEST(Touching_loops, circles_that_touch_where_they_begin)
{
  const Domain domain = with_holes(Domain(circle(origin, 1)), {circle(Point_2(0.5, 0), 0.5)}); // in (1,0)
  const Meshed m = mesh_flat(domain, 0.1, 0.75 * pi, 0.02);
  expect_topology(m, 1, 1, 1);
}

TEST(Touching_loops, chain_of_four_holes)
{
  std::vector<Loop> holes;
  for(int i = 0; i < 4; ++i) {
    const double x = 0.1 + 0.2 * i;
    const Point_2 next(0.1 + 0.2 * (i + 1), 0.5); // to the last bit
    holes.push_back(Domain::polygon({Point_2(x, 0.5), Point_2(x + 0.1, 0.4), next, Point_2(x + 0.1, 0.6)}));
  }
  const Meshed m = mesh_flat(with_holes(square(), holes), 0.05, 1 - 4 * 0.02, 1e-9);
  expect_topology(m, 1, 2, 0);
}

TEST(Touching_loops, outer_loop_that_pinches_the_domain)
{
  const Domain domain({Point_2(0, 0), Point_2(1, 0), Point_2(1, 1), Point_2(2, 1), Point_2(2, 2), Point_2(1, 2),
                       Point_2(1, 1), Point_2(0, 1)});
  const Meshed m = mesh_flat(domain, 0.1, 2, 1e-9);
  expect_topology(m, 2, 2, 2);
}

TEST(Touching_loops, outer_loop_that_closes_around_a_hole)
{
  const Domain domain({Point_2(0, 0), Point_2(3, 0), Point_2(3, 3), Point_2(1.5, 3), Point_2(2, 2), Point_2(2, 1),
                       Point_2(1, 1), Point_2(1, 2), Point_2(1.5, 3), Point_2(0, 3)});
  const Meshed m = mesh_flat(domain, 0.2, 9 - 1.5, 1e-9);
  expect_topology(m, 1, 1, 1);
}

TEST(Shared_thin_curves, ring_and_disk)
{
  for(double gap : {0.005, 0.0005}) {
    SCOPED_TRACE(gap);
    check_fit(ring_and_disk(flat(), 1 - gap), 0.3, pi, 0.02);
  }
}

TEST(Shared_thin_curves, ring_and_disk_on_a_paraboloid)
{
  check_fit(ring_and_disk(paraboloid(), 0.999), 0.3, 2 * pi / 3 * (std::pow(2., 1.5) - 1), 0.02);
}

TEST(Shared_thin_curves, crescent_and_neighbour)
{
  for(double gap : {0.01, 0.001}) {
    SCOPED_TRACE(gap);
    const double area = area_of_segment(1, 0.3) + area_of_segment(1, 0.1); // the lower arc bulges to the other side
    check_fit(crescent_and_neighbour(flat(), -0.1, 0.3 - gap, 0.3), 0.4, area, 0.05);
  }
}

TEST(Shared_thin_curves, two_crescents)
{
  const double area = area_of_segment(1, 0.302) - area_of_segment(1, 0.3);
  check_fit(crescent_and_neighbour(flat(), 0.3, 0.301, 0.302), 0.4, area, 0.3);
}

TEST(Crossing_trims, circles)
{
  for(const Loop& hole : {circle(Point_2(0.5, 0), 0.6), circle(Point_2(0.4, 0), 0.6001)})
    expect_patch_refused(with_holes(Domain(circle(origin, 1)), {hole}), 0.2, "of loop 1", "of loop 2");
}

TEST(Crossing_trims, holes)
{
  const std::vector<Loop> holes = {circle(Point_2(0.3, 0.5), 0.2), circle(Point_2(0.69, 0.5), 0.2)};
  expect_patch_refused(with_holes(square(), holes), 0.1, "of loop 2", "of loop 3");
}

TEST(Crossing_trims, loop_with_itself)
{
  const Domain eight(Loop{Curve::from_function(
    [](auto t) {
      using std::sin;
      return std::make_pair(sin(t), sin(2 * t));
    },
    0.5, 0.5 + 2 * pi)});
  expect_patch_refused(eight, 0.1, "of loop 1", "of loop 1");
}

TEST(Crossing_trims, arcs_that_cross_beside_their_common_end)
{
  const Point_2 p(0, 0), q(1, 0);
  const Curve wave = Curve::from_function(
    [](auto t) {
      using std::sin;
      return std::make_pair(t, 0.1 * sin(2 * pi * t));
    },
    0, 1);
  expect_patch_refused(Domain(Loop{wave, Curve::segment(wave.target(), wave.source())}), 0.1, "segment", "of loop 1");
}

TEST(Crossing_trims, prescribed_divisions)
{
  Domain ring = with_holes(Domain(circle(origin, 1)), {{Curve::arc(origin, 0.98, 0.2, 0.2 + 2 * pi)}});
  ring.loops()[0][0].set_number_of_edges(6);
  ring.loops()[1][0].set_number_of_edges(7);
  expect_patch_refused(ring, 0.5, "of loop 1", "of loop 2");
}

TEST(Crossing_trims, one_prescribed_division)
{
  // the outer polygon stays, and lies inside the inner circle
  Domain ring = with_holes(Domain(circle(origin, 1)), {circle(origin, 0.98)});
  ring.loops()[0][0].set_number_of_edges(6);
  expect_patch_refused(ring, 0.5, "of loop 1", "of loop 2");
  // the inner polygon is inside, however coarse it is, and the outer one can be refined
  ring.loops()[0][0].set_number_of_edges(0);
  ring.loops()[1][0].set_number_of_edges(6);
  const Meshed m = mesh_and_check(flat(), ring, Criteria().set_max_edge(0.5));
  expect_topology(m, 1, 2, 0);
}
