// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random patches and models of all kinds, some of them absurd, are meshed or refused, and an audit that shares no code with
// the mesher finds nothing. The program fuzz_patches goes on where this test ends. Then inputs that fuzzing has found.
#include <gtest/gtest.h>

#include <CGAL/make_model_of_rectangular_patches.h>

#include <check_fuzz_case.h>
#include <make_fuzz_case.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace {

void expect_nothing_found(const Fuzz_case& fuzz_case)
{
  Fuzz_check check(fuzz_case);
  for(const std::string& text : check().texts())
    ADD_FAILURE() << fuzz_case.description << "\n" << text;
}

const std::uint64_t first_seed = 1, patches_in_a_test = 50;

// the closed curve around `(x,y)`
Fuzz_domain::Loop circle(double x, double y, double radius)
{
  return {Fuzz_domain::Curve::circle(Fuzz_kernel::Point_2(x, y), radius)};
}

Fuzz_case plane_patch(const Fuzz_domain& domain)
{
  Fuzz_case result;
  result.surface = Fuzz_surface(CGAL::Parametric_plane_3<Fuzz_kernel>(), -1, 1, -1, 1);
  result.domain = domain;
  return result;
}

} // namespace

class Fuzz_patches : public testing::TestWithParam<std::uint64_t>
{};

TEST_P(Fuzz_patches, break_no_invariant)
{
  for(std::uint64_t seed = GetParam(); seed < GetParam() + patches_in_a_test; ++seed) {
    SCOPED_TRACE("fuzz_patches --only " + std::to_string(seed));
    expect_nothing_found(make_fuzz_case(seed));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Fuzz_patches,
                         testing::Range(first_seed, first_seed + 6 * patches_in_a_test, patches_in_a_test));

// The pieces of the outer loop leave the hole outside, though none crosses it.
TEST(Found_by_fuzzing, hole_between_a_curve_and_its_pieces)
{
  Fuzz_domain domain(circle(0, 0, 1));
  domain.add_hole(circle(0.97 * std::cos(0.63), 0.97 * std::sin(0.63), 0.01));
  Fuzz_case coarse = plane_patch(domain);
  coarse.criteria.set_max_edge(1.4).set_min_edge(0.001).set_gamma(0.5).set_angle(0);
  expect_nothing_found(coarse);
}

// The same inside out: the pieces of one hole have another one inside.
TEST(Found_by_fuzzing, hole_beside_a_curve_that_bends_inwards)
{
  typedef Fuzz_kernel::Point_2 Point_2;
  Fuzz_domain domain(Fuzz_domain::polygon({Point_2(-2, -2), Point_2(2, -2), Point_2(2, 2), Point_2(-2, 2)}));
  Fuzz_domain::Loop moon = {Fuzz_domain::Curve::arc(Point_2(0, 0), 1, 0, CGAL_PI)};
  moon.push_back(Fuzz_domain::Curve::arc(Point_2(0, 0), 1, CGAL_PI, 0));
  moon.back() = Fuzz_domain::Curve(
    [](double t) {
      return Fuzz_domain::Curve::Jet{Point_2(-std::cos(t), 0.8 * std::sin(t)), Fuzz_kernel::Vector_2(std::sin(t), 0.8 * std::cos(t)),
                                     Fuzz_kernel::Vector_2(std::cos(t), -0.8 * std::sin(t))};
    },
    0, CGAL_PI);
  domain.add_hole(moon);
  domain.add_hole(circle(0.1, 0.75, 0.01));
  Fuzz_case coarse = plane_patch(domain);
  coarse.criteria.set_max_edge(3).set_min_edge(0.001).set_gamma(0.9).set_angle(0);
  expect_nothing_found(coarse);
}

// What the width of a ring asks for may make its pieces cross, before they are triangulated again.
TEST(Found_by_fuzzing, narrow_ring_divided_by_closeness)
{
  for(const double width : {0.001, 0.002, 0.005})
    for(const double closeness : {0.5, 0.75, 1.8}) {
      Fuzz_domain domain(circle(0, 0, 1));
      domain.add_hole(circle(0, 0, 1 - width));
      Fuzz_case ring = plane_patch(domain);
      ring.criteria.set_max_edge(3.5).set_min_edge(0.014).set_closeness(closeness).set_max_number_of_vertices(8000);
      ring.expectation = Fuzz_expectation::ANY;
      expect_nothing_found(ring);
    }
}

// Points on a seam are one in space: triangles between them are flat, and moves computed from these are not finite.
TEST(Found_by_fuzzing, torus_with_hardly_a_point_inside)
{
  for(const double radius : {0.1, 0.3, 0.5, 0.8})
    for(std::size_t number_inside : {1, 2, 5}) {
      Fuzz_case torus;
      torus.model = CGAL::make_model_of_rectangular_patches(std::vector<Fuzz_surface>{
        Fuzz_surface(CGAL::Parametric_torus_3<Fuzz_kernel>(1, radius), 0, 2 * CGAL_PI, 0, 2 * CGAL_PI)});
      torus.is_model_closed = true;
      torus.criteria.set_max_edge(3.7).set_min_edge(0.04).set_max_number_of_sweeps(1).set_improvement_angle(0);
      Fuzz_mesh whole;
      ASSERT_TRUE(mesh_fuzz_case(torus, torus.criteria, false, whole).is_mesh());
      torus.criteria.set_max_number_of_vertices(whole.report.number_of_boundary_edges + number_inside);
      expect_nothing_found(torus);
    }
}

// A torus in parts, with hardly a point inside: a chord of one part joins the same vertices as a side that two other parts share.
TEST(Found_by_fuzzing, chord_beside_a_side_of_other_parts) { expect_nothing_found(make_fuzz_case(411639)); }

// The same, where the chord is a side that two strips, or a strip and a part, have in common.
TEST(Found_by_fuzzing, chord_between_strips)
{
  for(const std::uint64_t seed : {1041085, 1050526})
    expect_nothing_found(make_fuzz_case(seed));
}

// Hills between the places that every triangle has, where the minimum edge leaves no room for a vertex.
TEST(Found_by_fuzzing, missed_hills_are_reported)
{
  for(const std::uint64_t seed : {1055572, 1056241, 1096149})
    expect_nothing_found(make_fuzz_case(seed));
}

// A hole that is the outline, meshed since the minimum edge is longer than both: triangles without area have no angle that will do.
TEST(Found_by_fuzzing, triangles_without_area) { expect_nothing_found(make_fuzz_case(1094523)); }

// The same with parts of other sizes.
TEST(Found_by_fuzzing, torus_in_parts_with_hardly_a_point_inside)
{
  for(const double radius : {0.1, 0.3})
    for(const std::size_t part_size : {7, 19}) {
      Fuzz_case torus;
      torus.model = CGAL::make_model_of_rectangular_patches(std::vector<Fuzz_surface>{
        Fuzz_surface(CGAL::Parametric_torus_3<Fuzz_kernel>(1, radius), 0, 2 * CGAL_PI, 0, 2 * CGAL_PI)});
      torus.is_model_closed = true;
      torus.criteria.set_max_edge(0.5 * radius).set_part_size(part_size);
      Fuzz_mesh whole;
      ASSERT_TRUE(mesh_fuzz_case(torus, torus.criteria, false, whole).is_mesh());
      torus.criteria.set_max_number_of_vertices(whole.report.number_of_boundary_edges + 1);
      expect_nothing_found(torus);
    }
}
