// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_TEST_SURFACE_TEST_HELPERS_H
#define CGAL_TEST_SURFACE_TEST_HELPERS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Surface_jet_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Test_kernel;
typedef Test_kernel::Point_3 Point_3;
typedef Test_kernel::Vector_3 Vector_3;

inline void expect_near(const Vector_3& expected, const Vector_3& found, double tolerance, const std::string& what)
{
  EXPECT_LE(std::sqrt((expected - found).squared_length()), tolerance)
    << what << ": expected " << expected << ", found " << found;
}

inline void expect_near(const Point_3& expected, const Point_3& found, double tolerance, const std::string& what)
{
  expect_near(expected - CGAL::ORIGIN, found - CGAL::ORIGIN, tolerance, what);
}

// Compares the derivatives of `surface` at `(u,v)` with central differences of point() (first order) and of the
// first derivatives (second order). The surface must be smooth in a neighbourhood of `scale / 1e5`.
template <class Surface>
void check_jet(const Surface& surface, double u, double v, double scale = 1)
{
  const std::string at = " at " + std::to_string(u) + ", " + std::to_string(v);
  const double h = 1e-5 * scale;
  const auto jet = surface.jet(u, v);
  EXPECT_EQ(surface.point(u, v), jet.point) << at;

  const auto east = surface.jet(u + h, v), west = surface.jet(u - h, v);
  const auto north = surface.jet(u, v + h), south = surface.jet(u, v - h);
  const double tolerance = 1e-7 * (1 + std::sqrt(jet.du.squared_length() + jet.dv.squared_length()
                                                 + jet.duu.squared_length() + jet.duv.squared_length()
                                                 + jet.dvv.squared_length()));
  expect_near((east.point - west.point) / (2 * h), jet.du, tolerance, "du" + at);
  expect_near((north.point - south.point) / (2 * h), jet.dv, tolerance, "dv" + at);
  expect_near((east.du - west.du) / (2 * h), jet.duu, tolerance, "duu" + at);
  expect_near((north.du - south.du) / (2 * h), jet.duv, tolerance, "duv" + at);
  expect_near((east.dv - west.dv) / (2 * h), jet.duv, tolerance, "dvu" + at);
  expect_near((north.dv - south.dv) / (2 * h), jet.dvv, tolerance, "dvv" + at);
}

// Expects a Parametric_surface_mesh_error from `call` whose message contains all `words`.
template <class Call, class... Words>
void expect_refused(const Call& call, const Words&... words)
{
  try {
    call();
    ADD_FAILURE() << "nothing was thrown";
  } catch(const CGAL::Parametric_surface_mesh_error& error) {
    const std::string message = error.what();
    for(const std::string& word : { std::string(words)... })
      EXPECT_NE(std::string::npos, message.find(word)) << "no \"" << word << "\" in: " << message;
  }
}

#endif // CGAL_TEST_SURFACE_TEST_HELPERS_H
