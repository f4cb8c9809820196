// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stress tests: sides of the domain that are one point in space, at all kinds of corners.
#include <CGAL/Bezier_surface_3.h>
#include <CGAL/IO/read_bezier_patches.h>

#include <gtest/gtest.h>

#include <stress_test_helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Bezier_surface_3<Test_kernel> Bezier;

Patch whole(const Bezier& bezier) { return Patch(Sample_surface(bezier), 0, 1, 0, 1); }

std::size_t number_of_triangles_at(const Meshed& m, const Point_3& pole)
{
  std::size_t result = 0;
  for(const Triangle& t : m.triangles)
    result += std::any_of(t.begin(), t.end(), [&](std::size_t v) { return distance(m.point(v), pole) < 1e-9; });
  return result;
}

// Some six triangles fill a full angle; around a pole as around any other vertex.
void expect_few_triangles_at(const Meshed& m, const Point_3& pole, double angle)
{
  const double share = angle / (2 * pi);
  EXPECT_GE(number_of_triangles_at(m, pole), 1u);
  EXPECT_LE(number_of_triangles_at(m, pole), 9 * share + 3);
}

// Area and number of triangles are those of the surface, and few triangles fail a criterion. (How a side bends within the
// surface asks for more triangles than the curvature alone.)
void expect_good(const Meshed& m, const Surface_integrals& integrals, double max_edge)
{
  expect_distinct_points(m.mesh);
  EXPECT_NEAR(1, m.area / integrals.area, 0.04);
  EXPECT_LE(m.triangles.size(), 10 * integrals.number_of_triangles(max_edge, m.report.min_edge, 0.05) + 500);
  EXPECT_LE(number_of_unmet_but_at_short_edges(m.report), m.triangles.size() / 20 + 6);
}

Meshed mesh_patch_and_check(const Patch& patch, double max_edge)
{
  SCOPED_TRACE("max_edge = " + std::to_string(max_edge));
  const Meshed m = mesh_and_check(model_of_patches({patch}), Criteria().set_max_edge(max_edge));
  expect_good(m, Surface_integrals(patch), max_edge);
  return m;
}

class Cones : public testing::TestWithParam<int>
{};

// the cone with the apex (0,0,0) and lines of length 1, open at the other end
Patch cone(int half_angle_in_degrees, double turn)
{
  const double angle = half_angle_in_degrees * pi / 180;
  return Patch(Sample_surface(CGAL::Parametric_cone_3<Test_kernel>(0, angle)), 0.3, 0.3 + turn, 0, 1);
}

// the angle of the triangles at the apex of a cone
double angle_at_apex(int half_angle_in_degrees, double turn) { return turn * std::sin(half_angle_in_degrees * pi / 180); }

class Pointed_cones : public testing::TestWithParam<int>
{};

// of the triangles whose corners are all closer to the pole than `radius`
double smallest_angle_around(const Meshed& m, const Point_3& pole, double radius)
{
  double result = 180;
  for(std::size_t i = 0; i < m.triangles.size(); ++i) {
    const Triangle& t = m.triangles[i];
    if(std::all_of(t.begin(), t.end(), [&](std::size_t v) { return distance(m.point(v), pole) < radius; }))
      result = (std::min)(result, m.min_angle(i));
  }
  return result;
}

// a part of the unit sphere
Patch part_of_sphere(double u_min, double u_max, double v_min, double v_max)
{
  return Patch(Sample_surface(CGAL::Parametric_sphere_3<Test_kernel>(1)), u_min, u_max, v_min, v_max);
}

// The net of a curved patch of degree 3 over a unit square; the control points of some sides are made one.
class Collapsible_net
{
  std::vector<Point_3> m_points;

public:
  Collapsible_net()
  {
    for(int j = 0; j < 4; ++j)
      for(int i = 0; i < 4; ++i)
        m_points.emplace_back(i / 3., j / 3. + 0.05 * i, 0.15 * (i * (3 - i) + j % 2));
  }

  // side 0: v = 0, 1: u = 1, 2: v = 1, 3: u = 0
  Collapsible_net& collapse(int side, const Point_3& p)
  {
    for(int k = 0; k < 4; ++k)
      m_points[side == 0 ? k : side == 1 ? 4 * k + 3 : side == 2 ? 12 + k : 4 * k] = p;
    return *this;
  }

  Bezier bezier() const { return Bezier(3, 3, m_points); }
};

const std::vector<Point_3> middles_of_sides
  = {Point_3(0.5, 0, 0), Point_3(1, 0.5, 0), Point_3(0.5, 1, 0.2), Point_3(0, 0.5, 0)};

class Collapsed_sides : public testing::TestWithParam<int>
{};

std::vector<Bezier> teapot()
{
  return CGAL::IO::read_bezier_patches<Test_kernel>(std::string(PARAMETRIC_SURFACE_MESHER_DATA_DIR) + "/teapot.bpt");
}

bool is_collapsed_at_bottom(const Bezier& b)
{
  return distance(b.point(0, 0), b.point(0.5, 0)) < 1e-9 && distance(b.point(0, 0), b.point(1, 0)) < 1e-9;
}

// the patches whose side v = 0 is a point
std::vector<Bezier> collapsed_patches_of_teapot()
{
  std::vector<Bezier> result;
  for(const Bezier& b : teapot())
    if(is_collapsed_at_bottom(b))
      result.push_back(b);
  return result;
}

// (v cos u, v sin u, 0)
const Sample_surface disk((sample_surfaces::Disk()));

// The disk of radius 1 as a full turn with a seam, and a hole around (u,v) = (3, distance) of the domain.
Model disk_with_hole(double distance, double radius)
{
  Model model;
  const Point_2 a(0, 0), b(2 * pi, 0), c(2 * pi, 1), d(0, 1), e(3 + radius, distance);
  const std::size_t pole = model.add_vertex(Point_3(0, 0, 0)), rim = model.add_vertex(Point_3(1, 0, 0)),
                    start = model.add_vertex(disk.point(e.x(), e.y()));
  const std::size_t bottom = model.add_edge(pole, pole, true), seam = model.add_edge(pole, rim),
                    top = model.add_edge(rim, rim), hole = model.add_edge(start, start);
  model.add_face({disk,
                  {{{bottom, false, Curve::segment(a, b)},
                    {seam, false, Curve::segment(b, c)},
                    {top, true, Curve::segment(d, c)},
                    {seam, true, Curve::segment(a, d)}},
                   {{hole, false, Curve::circle(Point_2(3, distance), radius)}}}});
  return model;
}

// Three triangles of 30 degrees have room around the apex from a half-angle of 17.4 degrees on. The triangles next to these
// are good as well.
void expect_good_apex(int half_angle_in_degrees, Criteria criteria)
{
  const Patch patch = cone(half_angle_in_degrees, 2 * pi);
  for(double max_edge = 0.04; max_edge < 0.3; max_edge *= 1.3)
    for(int share : {5, 200}) {
      SCOPED_TRACE("max_edge = " + std::to_string(max_edge) + ", min_edge = 1 / " + std::to_string(share) + " of it");
      criteria.set_max_edge(max_edge).set_min_edge(max_edge / share);
      const Meshed m = mesh_and_check(model_of_patches({patch}), criteria);
      expect_topology(m, 1, 1, 1);
      EXPECT_EQ(3u, number_of_triangles_at(m, Point_3(0, 0, 0)));
      EXPECT_GE(smallest_angle_around(m, Point_3(0, 0, 0), 5 * max_edge / share), 30 - 1e-9);
    }
}

} // namespace

TEST_P(Cones, closed_around)
{
  const Patch patch = cone(GetParam(), 2 * pi);
  for(double max_edge : {0.4, 0.1, 0.03}) {
    const Meshed m = mesh_patch_and_check(patch, max_edge);
    expect_topology(m, 1, 1, 1);
    expect_few_triangles_at(m, Point_3(0, 0, 0), angle_at_apex(GetParam(), 2 * pi));
    EXPECT_GE(m.report.smallest_angle, 20);
  }
}

TEST_P(Pointed_cones, good_around_the_apex)
{
  expect_good_apex(GetParam(), Criteria());
}

// Cuts keep clear of it.
TEST_P(Pointed_cones, good_around_the_apex_of_a_split_patch)
{
  expect_good_apex(GetParam(), Criteria().set_part_size(600));
}

INSTANTIATE_TEST_SUITE_P(Stress, Pointed_cones, testing::Values(18, 19, 20, 21, 22, 24, 25, 26),
                         [](const auto& parameter) { return "half_angle_of_" + std::to_string(parameter.param) + "_degrees"; });

// no room for 30 degrees: three triangles with the angle that there is, or what refinement makes of them
TEST(Needles, around_the_apex)
{
  for(int half_angle : {8, 12, 16})
    for(double max_edge : {0.2, 0.05}) {
      SCOPED_TRACE(half_angle);
      const Meshed m = mesh_and_check(model_of_patches({cone(half_angle, 2 * pi)}), Criteria().set_max_edge(max_edge));
      expect_topology(m, 1, 1, 1);
      EXPECT_LE(number_of_unmet_but_at_short_edges(m.report), 12u);
    }
}

// Cones ten times as high as wide, and more: no triangle is sharp but the three at the apex, whose short sides are as long as the
// minimum edge.
TEST(Needles, only_at_the_apex)
{
  for(int half_angle : {3, 4, 5}) {
    SCOPED_TRACE(half_angle);
    const double min_edge = 1e-3;
    const Meshed m = mesh_and_check(model_of_patches({cone(half_angle, 2 * pi)}), Criteria().set_max_edge(0.05).set_min_edge(min_edge).set_closeness(1.8));
    expect_topology(m, 1, 1, 1);
    EXPECT_EQ(3u, number_of_triangles_at(m, Point_3(0, 0, 0)));
    for(std::size_t i = 0; i < m.triangles.size(); ++i)
      if(m.min_angle(i) < 12) {
        const Triangle& t = m.triangles[i];
        EXPECT_EQ(1, std::count_if(t.begin(), t.end(), [&](std::size_t v) { return distance(m.point(v), Point_3(0, 0, 0)) < min_edge; }));
      }
  }
}

TEST_P(Cones, cut_open)
{
  for(double turn : {2 * pi, 4., 0.7}) {
    SCOPED_TRACE(turn);
    const Patch patch = cone(GetParam(), turn);
    const Domain domain = Domain::rectangle(patch.u_min(), patch.u_max(), 0, 1);
    for(double max_edge : {0.1, 0.03}) {
      const Meshed m = mesh_and_check(patch.surface(), domain, Criteria().set_max_edge(max_edge));
      expect_topology(m, 1, 1, 1);
      EXPECT_NEAR(1, m.area / Surface_integrals(patch).area, 0.02);
      expect_few_triangles_at(m, Point_3(0, 0, 0), angle_at_apex(GetParam(), turn));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Stress, Cones, testing::Values(18, 20, 24, 30, 40, 50, 60, 70, 80),
                         [](const auto& parameter) { return "half_angle_of_" + std::to_string(parameter.param) + "_degrees"; });

TEST(Poles_of_spheres, octants)
{
  for(int i = 0; i < 4; ++i)
    for(bool is_upper : {false, true}) {
      SCOPED_TRACE(i);
      const Patch octant = part_of_sphere(i * pi / 2, (i + 1) * pi / 2, is_upper ? 0 : -pi / 2, is_upper ? pi / 2 : 0);
      for(double max_edge : {10., 0.2, 0.05}) {
        const Meshed m = mesh_patch_and_check(octant, max_edge);
        expect_topology(m, 1, 1, 1);
        expect_few_triangles_at(m, Point_3(0, 0, is_upper ? 1 : -1), pi / 2);
      }
    }
}

TEST(Poles_of_spheres, lunes)
{
  for(double angle : {0.4, 1., 3., 6.}) {
    SCOPED_TRACE(angle);
    for(double max_edge : {0.2, 0.05}) {
      const Meshed m = mesh_patch_and_check(part_of_sphere(0, angle, -pi / 2, pi / 2), max_edge);
      expect_topology(m, 1, 1, 1);
      expect_few_triangles_at(m, Point_3(0, 0, 1), angle);
      expect_few_triangles_at(m, Point_3(0, 0, -1), angle);
    }
  }
}

// narrower than the edges are long: few triangles can be good
TEST(Poles_of_spheres, sliver)
{
  for(double angle : {0.1, 0.01, 0.001}) {
    SCOPED_TRACE(angle);
    const Patch sliver = part_of_sphere(0, angle, -pi / 2, pi / 2);
    const Meshed m = mesh_and_check(model_of_patches({sliver}), Criteria().set_max_edge(0.2));
    expect_topology(m, 1, 1, 1);
    EXPECT_TRUE(angle < 0.1 || std::fabs(m.area / Surface_integrals(sliver).area - 1) < 0.04); // thinner than edges are high
    EXPECT_LE(m.triangles.size(), 1000u);
  }
}

TEST(Poles_of_spheres, caps_of_all_heights)
{
  for(double from : {-1.5, -0.8, 0., 1., 1.5}) {
    SCOPED_TRACE(from);
    for(double max_edge : {10., 0.05}) {
      const Meshed m = mesh_patch_and_check(part_of_sphere(0, 2 * pi, from, pi / 2), max_edge);
      expect_topology(m, 1, 1, 1);
      expect_few_triangles_at(m, Point_3(0, 0, 1), 2 * pi);
    }
  }
}

TEST(Poles_of_spheres, two_caps_make_a_sphere)
{
  const std::vector<Patch> caps = {part_of_sphere(0, 2 * pi, -pi / 2, 1.2), part_of_sphere(0, 2 * pi, 1.2, pi / 2)};
  const Meshed m = mesh_and_check(model_of_patches(caps), Criteria().set_max_edge(0.1));
  expect_topology(m, 1, 0, 2);
  expect_distinct_points(m.mesh);
  EXPECT_NEAR(1, m.volume() / (4 * pi / 3), 0.01);
  EXPECT_GE(m.report.smallest_angle, 25);
}

TEST_P(Collapsed_sides, one)
{
  const int side = GetParam();
  const Bezier bezier = Collapsible_net().collapse(side, middles_of_sides[side]).bezier();
  for(double max_edge : {1., 0.1, 0.03})
    expect_topology(mesh_patch_and_check(whole(bezier), max_edge), 1, 1, 1);
}

TEST_P(Collapsed_sides, two_opposite_ones)
{
  const int side = GetParam(), other = (side + 2) % 4;
  const Bezier bezier
    = Collapsible_net().collapse(side, middles_of_sides[side]).collapse(other, middles_of_sides[other]).bezier();
  for(double max_edge : {1., 0.1, 0.03})
    expect_topology(mesh_patch_and_check(whole(bezier), max_edge), 1, 1, 1);
}

TEST_P(Collapsed_sides, two_adjacent_ones)
{
  const int side = GetParam(), next = (side + 1) % 4;
  const Point_3 corner(0.5 + 0.5 * (side == 0 || side == 1 ? 1 : -1), side < 2 ? side : 3 - side, 0.1);
  const Bezier bezier = Collapsible_net().collapse(side, corner).collapse(next, corner).bezier();
  for(double max_edge : {0.3, 0.1, 0.03}) {
    const Meshed m = mesh_and_check(model_of_patches({whole(bezier)}), Criteria().set_max_edge(max_edge));
    expect_distinct_points(m.mesh);
    expect_topology(m, 1, 1, 1);
    EXPECT_LE(m.triangles.size(), 25000u);
    EXPECT_LE(number_of_unmet_but_at_short_edges(m.report), 60u);
    EXPECT_GE(number_of_triangles_at(m, corner), 1u);
    EXPECT_LE(number_of_triangles_at(m, corner), 4u);
  }
}

INSTANTIATE_TEST_SUITE_P(Stress, Collapsed_sides, testing::Range(0, 4));

TEST(Lid_of_teapot, patches_alone)
{
  const std::vector<Bezier> patches = collapsed_patches_of_teapot();
  ASSERT_GE(patches.size(), 4u);
  for(const Bezier& bezier : patches)
    for(double max_edge : {1., 0.2, 0.05})
      expect_topology(mesh_patch_and_check(whole(bezier), max_edge), 1, 1, 1);
}

TEST(Lid_of_teapot, patches_together)
{
  std::vector<Patch> patches;
  for(const Bezier& bezier : collapsed_patches_of_teapot())
    patches.push_back(whole(bezier));
  for(double max_edge : {0.5, 0.05}) {
    const Meshed m = mesh_and_check(model_of_patches(patches), Criteria().set_max_edge(max_edge));
    EXPECT_EQ(patches.size() / 4, m.topology.components);
    EXPECT_EQ(patches.size() / 4, m.topology.border_cycles);
    EXPECT_EQ(patches.size() / 4, std::size_t(m.topology.euler_characteristic));
    EXPECT_LE(number_of_unmet_but_at_short_edges(m.report), m.triangles.size() / 50 + 4);
  }
}

TEST(Polar_disk, with_a_seam)
{
  for(double max_edge : {3., 0.3, 0.05}) {
    const Meshed m = mesh_patch_and_check(Patch(disk, 0, 2 * pi, 0, 1), max_edge);
    expect_topology(m, 1, 1, 1);
    expect_few_triangles_at(m, Point_3(0, 0, 0), 2 * pi);
    EXPECT_GE(m.report.smallest_angle, max_edge < 1 ? 30 - 1e-9 : 20);
  }
}

TEST(Polar_disk, cut_open)
{
  for(double max_edge : {0.3, 0.05}) {
    const Meshed m = mesh_and_check(disk, Domain::rectangle(0, 2 * pi, 0, 1), Criteria().set_max_edge(max_edge));
    expect_topology(m, 1, 1, 1);
    EXPECT_NEAR(pi, m.area, 0.05);
    expect_few_triangles_at(m, Point_3(0, 0, 0), 2 * pi);
  }
}

TEST(Polar_disk, with_a_hole_near_the_pole)
{
  for(double distance : {0.3, 0.1, 0.02}) {
    SCOPED_TRACE(distance);
    const Meshed m = mesh_and_check(disk_with_hole(distance, 0.9 * distance), Criteria().set_max_edge(0.1));
    expect_topology(m, 1, 2, 0);
    expect_distinct_points(m.mesh);
    EXPECT_NEAR(pi - pi * 0.81 * distance * distance * distance, m.area, 0.02);
    EXPECT_LE(m.triangles.size(), 6000u);
  }
}

TEST(Polar_disk, sectors_make_a_disk)
{
  const std::vector<Patch> sectors = {Patch(disk, 0, 1, 0, 1), Patch(disk, 1, 3, 0, 1), Patch(disk, 3, 2 * pi, 0, 1)};
  const Meshed m = mesh_and_check(model_of_patches(sectors), Criteria().set_max_edge(0.1));
  expect_topology(m, 1, 1, 1);
  expect_distinct_points(m.mesh);
  EXPECT_NEAR(pi, m.area, 0.02);
}
