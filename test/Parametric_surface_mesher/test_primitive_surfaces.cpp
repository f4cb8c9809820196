// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Parametric_primitive_surfaces_3.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "include/surface_test_helpers.h"

namespace {

typedef CGAL::Parametric_frame_3<> Frame_3;

const double pi = 4 * std::atan(1.);
const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

Frame_3 tilted_frame()
{
  return Frame_3(Point_3(1, -2, 3), Vector_3(1, 2, 2), Vector_3(1, 0, 0));
}

template <class Surface>
void check_jets(const Surface& surface)
{
  for(double u : { -1., 0., 0.7, 3. })
    for(double v : { -0.8, 0., 0.6, 1.2 })
      check_jet(surface, u, v);
}

TEST(Frame, is_orthonormal_and_right_handed)
{
  const Frame_3 f = tilted_frame();
  expect_near(Vector_3(1, 2, 2) / 3, f.z_direction(), 1e-15, "z");
  EXPECT_NEAR(0, f.x_direction() * f.z_direction(), 1e-15);
  EXPECT_GT(f.x_direction() * Vector_3(1, 0, 0), 0);
  expect_near(cross_product(f.z_direction(), f.x_direction()), f.y_direction(), 1e-15, "y");
}

TEST(Frame, may_be_left_handed)
{
  const Frame_3 f(Point_3(0, 0, 0), Vector_3(1, 0, 0), Vector_3(0, -1, 0), Vector_3(0, 0, 1));
  EXPECT_EQ(Vector_3(1, -2, 3), f.vector(1, 2, 3));
  check_jets(CGAL::Parametric_torus_3<>(2, 0.5, f));
}

TEST(Frame, refuses_vectors_that_give_no_frame)
{
  const Point_3 o(0, 0, 0);
  const Vector_3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  expect_refused([&] { Frame_3(o, x, 2 * x); }, "frame", "not parallel", "2 0 0");
  expect_refused([&] { Frame_3(o, Vector_3(0, 0, 0), x); }, "frame", "not parallel");
  expect_refused([&] { Frame_3(Point_3(0, nan, 0), z, x); }, "finite origin", "nan");
  expect_refused([&] { Frame_3(o, Vector_3(infinity, 0, 0), y); }, "frame", "inf");
  expect_refused([&] { Frame_3(o, x, y, 1.1 * z); }, "orthonormal");
  expect_refused([&] { Frame_3(o, x, Vector_3(0.1, 1, 0), z); }, "orthonormal", "0.1");
}

TEST(Primitive_surfaces, plane)
{
  const CGAL::Parametric_plane_3<> plane(Point_3(1, 2, 3), Vector_3(2, 0, 0), Vector_3(1, 1, 0));
  EXPECT_EQ(Point_3(1 + 2 * 3 + 4, 2 + 4, 3), plane.point(3, 4));
  check_jets(plane);
  EXPECT_EQ(Point_3(3, 4, 0), CGAL::Parametric_plane_3<>().point(3, 4));
  check_jets(CGAL::Parametric_plane_3<>(tilted_frame()));
}

TEST(Primitive_surfaces, cylinder)
{
  const CGAL::Parametric_cylinder_3<> cylinder(2);
  EXPECT_EQ(Point_3(2 * std::cos(0.3), 2 * std::sin(0.3), 5), cylinder.point(0.3, 5));
  EXPECT_EQ(2, cylinder.radius());
  check_jets(cylinder);
  check_jets(CGAL::Parametric_cylinder_3<>(0.5, tilted_frame()));
}

TEST(Primitive_surfaces, cone)
{
  const CGAL::Parametric_cone_3<> cone(1, pi / 6);
  expect_near(Point_3(0, 2, 2 * std::cos(pi / 6)), cone.point(pi / 2, 2), 1e-15, "point");
  expect_near(Point_3(0, 0, -2 * std::cos(pi / 6)), cone.point(1, -2), 1e-15, "apex");
  EXPECT_EQ(1, cone.radius());
  EXPECT_EQ(pi / 6, cone.semi_angle());
  check_jets(cone);
  check_jets(CGAL::Parametric_cone_3<>(0, -0.7, tilted_frame()));
}

TEST(Primitive_surfaces, sphere)
{
  const CGAL::Parametric_sphere_3<> sphere(3);
  expect_near(Point_3(3, 0, 0), sphere.point(0, 0), 0, "u axis");
  expect_near(Point_3(0, 0, 3), sphere.point(1, pi / 2), 1e-15, "pole");
  expect_near(Point_3(1.5, 1.5, std::sqrt(4.5)), sphere.point(pi / 4, pi / 4), 1e-15, "diagonal");
  check_jets(sphere);
  const CGAL::Parametric_sphere_3<> placed(0.5, tilted_frame());
  check_jets(placed);
  EXPECT_NEAR(0.25, squared_distance(placed.frame().origin(), placed.point(2, 1)), 1e-15);
}

TEST(Primitive_surfaces, torus)
{
  const CGAL::Parametric_torus_3<> torus(1, 0.3);
  expect_near(Point_3(1.3, 0, 0), torus.point(0, 0), 1e-15, "outside");
  expect_near(Point_3(0, 1, 0.3), torus.point(pi / 2, pi / 2), 1e-15, "top");
  EXPECT_EQ(1, torus.major_radius());
  EXPECT_EQ(0.3, torus.minor_radius());
  check_jets(torus);
  check_jets(CGAL::Parametric_torus_3<>(2, 0.5, tilted_frame()));
}

TEST(Primitive_surfaces, refuse_bad_measures)
{
  const Point_3 o(0, 0, 0);
  expect_refused([&] { CGAL::Parametric_plane_3<>(o, Vector_3(1, 2, 3), Vector_3(2, 4, 6)); }, "plane", "2 4 6");
  expect_refused([&] { CGAL::Parametric_plane_3<>(o, Vector_3(1, nan, 3), Vector_3(1, 0, 0)); }, "plane", "nan");
  expect_refused([&] { CGAL::Parametric_plane_3<>(Point_3(0, 0, nan), Vector_3(1, 0, 0), Vector_3(0, 1, 0)); },
                 "plane", "nan");
  expect_refused([] { CGAL::Parametric_cylinder_3<>(-1); }, "cylinder", "positive finite radius", "-1");
  expect_refused([] { CGAL::Parametric_cylinder_3<> c(nan); }, "cylinder", "nan");
  expect_refused([] { CGAL::Parametric_cone_3<>(-1, 0.5); }, "cone", "radius", "-1");
  expect_refused([] { CGAL::Parametric_cone_3<>(1, 0); }, "cone", "semi-angle", "found 0");
  expect_refused([] { CGAL::Parametric_cone_3<>(1, 1.6); }, "cone", "semi-angle", "1.6");
  expect_refused([] { CGAL::Parametric_cone_3<>(1, nan); }, "cone", "semi-angle", "nan");
  expect_refused([] { CGAL::Parametric_sphere_3<>(0); }, "sphere", "radius", "found 0");
  expect_refused([] { CGAL::Parametric_sphere_3<> s(infinity); }, "sphere", "inf");
  expect_refused([] { CGAL::Parametric_torus_3<>(0, 1); }, "torus", "major radius");
  expect_refused([] { CGAL::Parametric_torus_3<>(1, -2); }, "torus", "minor radius", "-2");
}

TEST(Primitive_surfaces, other_kernel)
{
  typedef CGAL::Simple_cartesian<double> Kernel;
  const CGAL::Parametric_sphere_3<Kernel> sphere(1);
  EXPECT_EQ(Kernel::Point_3(1, 0, 0), sphere.jet(0, 0).point);
  EXPECT_EQ(Kernel::Vector_3(0, 1, 0), CGAL::Parametric_plane_3<Kernel>().jet(0, 0).dv);
}

} // namespace
