// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/IO/read_bezier_patches.h>

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "include/surface_test_helpers.h"

#ifndef PARAMETRIC_SURFACE_MESHER_DATA_DIR
#define PARAMETRIC_SURFACE_MESHER_DATA_DIR "../../examples/Parametric_surface_mesher/data"
#endif

namespace {

typedef std::vector<CGAL::Bezier_surface_3<> > Patches;

// degree 1 in u, 2 in v
const std::string small_patch =
  "1 2\n"
  "0 0 0\n1 0 0\n"
  "0 1 5\n1 1 5\n"
  "0 2 0\n1 2 0\n";

Patches read(const std::string& text)
{
  std::istringstream input(text);
  return CGAL::IO::read_bezier_patches(input, "input.bpt");
}

template <class... Words>
void expect_text_refused(const std::string& text, const Words&... words)
{
  expect_refused([&] { read(text); }, "input.bpt", words...);
}

TEST(Read_bezier_patches, u_runs_fastest)
{
  const Patches patches = read("1\n" + small_patch);
  ASSERT_EQ(1u, patches.size());
  EXPECT_EQ(1, patches[0].degree_u());
  EXPECT_EQ(2, patches[0].degree_v());
  EXPECT_EQ(Point_3(1, 0, 0), patches[0].point(1, 0));
  EXPECT_EQ(Point_3(0, 2, 0), patches[0].point(0, 1));
  EXPECT_EQ(Point_3(0.5, 1, 2.5), patches[0].point(0.5, 0.5));
}

TEST(Read_bezier_patches, blank_lines_and_other_line_ends)
{
  EXPECT_EQ(2u, read("\n 2 \r\n\n" + small_patch + "\n\t\n" + small_patch + "\n\n").size());
  const std::string without_last_line_end = small_patch.substr(0, small_patch.size() - 1);
  EXPECT_EQ(1u, read("1\n" + without_last_line_end).size());
}

TEST(Read_bezier_patches, teapot)
{
  const Patches teapot = CGAL::IO::read_bezier_patches(PARAMETRIC_SURFACE_MESHER_DATA_DIR "/teapot.bpt");
  ASSERT_EQ(28u, teapot.size());
  EXPECT_EQ(Point_3(1.4, 0, 2.4), teapot[0].point(0, 0));
  EXPECT_EQ(Point_3(0, -1.5, 2.4), teapot[0].point(1, 1));
  for(const auto& patch : teapot) {
    EXPECT_EQ(3, patch.degree_u());
    EXPECT_EQ(3, patch.degree_v());
    check_jet(patch, 0.4, 0.7);
  }
}

TEST(Read_bezier_patches, neighbours_in_the_teapot_share_their_side)
{
  const Patches teapot = CGAL::IO::read_bezier_patches(PARAMETRIC_SURFACE_MESHER_DATA_DIR "/teapot.bpt");
  for(double v : { 0., 0.3, 0.5, 0.9, 1. })
    EXPECT_EQ(teapot[0].point(1, v), teapot[1].point(0, v));
}

TEST(Read_bezier_patches, refuses_a_bad_count)
{
  expect_text_refused("", "line 1", "positive number of patches", "end of the file");
  expect_text_refused("teapot\n", "line 1", "positive number of patches", "\"teapot\"");
  expect_text_refused("0\n", "line 1", "positive number of patches", "\"0\"");
  expect_text_refused("-3\n", "line 1", "positive number of patches", "\"-3\"");
  expect_text_refused("1.5\n", "line 1", "positive number of patches", "\"1.5\"");
  expect_text_refused("99999999999999999999\n", "line 1", "positive number of patches");
  expect_text_refused("2000000000\n" + small_patch, "line 9", "two degrees", "patch 2 of 2000000000", "end of the file");
}

TEST(Read_bezier_patches, refuses_bad_degrees)
{
  expect_text_refused("1\n3\n", "line 2", "two degrees", "patch 1 of 1", "\"3\"");
  expect_text_refused("1\n0 3\n", "line 2", "two degrees from 1 to 25", "\"0 3\"");
  expect_text_refused("1\n3 26\n", "line 2", "two degrees from 1 to 25", "\"3 26\"");
  expect_text_refused("1\n3 x\n", "line 2", "two degrees");
}

TEST(Read_bezier_patches, refuses_bad_points)
{
  expect_text_refused("1\n1 1\n0 0 0\n1 0\n0 1 0\n1 1 0\n", "line 4", "control point 2 of 4 of patch 1 of 1", "\"1 0\"");
  expect_text_refused("1\n1 1\n0 0 0\n1 0 nan\n", "line 4", "finite coordinates", "\"1 0 nan\"");
  expect_text_refused("1\n1 1\n0 0 0\n1 0 1e999\n", "line 4", "finite coordinates");
  expect_text_refused("1\n1 1\n0 0 0\n1 0 0 7\n", "line 4", "three finite coordinates");
  expect_text_refused("1\n1 1\n0 0 0\n", "line 4", "control point 2 of 4", "end of the file");
}

TEST(Read_bezier_patches, refuses_what_follows_the_last_patch)
{
  expect_text_refused("1\n" + small_patch + "\nmore\n", "line 10", "expected the end of the file", "\"more\"");
}

TEST(Read_bezier_patches, refuses_a_file_that_cannot_be_read)
{
  expect_refused([] { CGAL::IO::read_bezier_patches("no_such_file.bpt"); }, "no_such_file.bpt", "cannot open");
  expect_refused([] { CGAL::IO::read_bezier_patches("."); }, ".", "read error");
}

} // namespace
