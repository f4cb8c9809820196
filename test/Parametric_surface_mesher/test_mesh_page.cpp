// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The data of pages of meshes, and pictures that hide what is hidden. What a browser makes of pages is tested by check_page.py.
#ifdef MESH_PICTURES_WITH_Z_BUFFER
#include "write_png_picture.h"
#endif

#include <CGAL/Mesh_page_3.h>
#include <CGAL/Parametric_surface_mesher/internal/page/Page_writer.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace internal = CGAL::Parametric_surface_mesher::internal;

// Two triangles on two faces.
CGAL::Mesh_page_3 small_page()
{
  CGAL::Mesh_page_3 page;
  page.title = "tent";
  page.points = {{{0, 0, 0}}, {{4, 0, 0}}, {{0, 3, 0}}, {{0, 0, 2}}};
  page.triangles = {{{0, 1, 2}}, {{0, 3, 1}}};
  page.triangle_faces = {1, 0};
  page.corner_parameters = {{{{{0, 0}}, {{1, 0}}, {{0, 1}}}}, {{{{0, 0}}, {{0, 2}}, {{1, 0}}}}};
  page.metric_tensors = {{{1, 0, 1}}, {{4, 1, 2}}};
  page.faces.resize(2);
  page.faces[0].number = 7;
  page.faces[1].number = 9;
  page.lines = {{{{0, 1}}, 3}};
  page.values = {{"height", CGAL::Mesh_page_3::Dimension::LENGTH, {1, 2}},
                 {"bend", CGAL::Mesh_page_3::Dimension::RECIPROCAL_LENGTH, {0, 0.5}}};
  page.findings = {{"not met", "angle", "because of the boundary", {}, {1}, {}}, {"simplified", "closed up", "", {0}, {}, {{{1, 1, 1}}}}};
  return page;
}

nlohmann::json json_of(const CGAL::Mesh_page_3& page)
{
  std::ostringstream out;
  internal::check_page(page);
  internal::Page_writer(page, out).write();
  return nlohmann::json::parse(out.str());
}

std::string bytes_of(const std::string& base64)
{
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  unsigned int bits = 0, number = 0;
  for(const char c : base64) {
    if(c == '=')
      break;
    bits = bits << 6 | unsigned(digits.find(c));
    number += 6;
    if(number >= 8) {
      number -= 8;
      result += char(bits >> number & 255u);
    }
  }
  return result;
}

TEST(Mesh_page, has_the_mesh)
{
  const auto json = json_of(small_page());
  EXPECT_EQ(json["title"], "tent");
  EXPECT_EQ(json["low"], nlohmann::json({0, 0, 0}));
  EXPECT_EQ(json["high"], nlohmann::json({4, 3, 2}));
  // the points 0 and 1 are on both faces, and two vertices each
  EXPECT_EQ(bytes_of(json["positions"]).size(), 6u * 3 * 3);
  EXPECT_EQ(bytes_of(json["parameters"]).size(), 6u * 2 * 3);
  EXPECT_EQ(bytes_of(json["triangles"]), std::string({0, 2, 2, 2, 2, 2})); // differences of 1 are written as 2
  EXPECT_EQ(bytes_of(json["triangleFaces"]), std::string({2, 1}));
  EXPECT_EQ(json["domains"], nlohmann::json({{0, 0, 1, 2}, {0, 0, 1, 1}}));
  EXPECT_EQ(json["faces"][1]["number"], 9);
  EXPECT_EQ(json["values"][0]["dimension"], "length");
  EXPECT_EQ(json["findings"][1]["places"], nlohmann::json({{1, 1, 1}}));
  EXPECT_NEAR(json["angles"]["low"].get<double>(), std::atan(0.5) * 180 / CGAL_PI, 1e-9); // of the sides 2 and 4
}

TEST(Mesh_page, names_can_be_anything)
{
  CGAL::Mesh_page_3 page = small_page();
  page.title = "</script><b>\"\\\n\xc3\xa4 \xff\xe2\x82";
  std::ostringstream out;
  internal::Page_writer(page, out).write();
  EXPECT_EQ(out.str().find('<'), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(out.str())["title"], "</script><b>\"\\\n\xc3\xa4 ???");
}

TEST(Mesh_page, rounds_values_to_a_share_of_their_range)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const internal::Rounded_values linear({0, 10, 30, infinity}, false), logarithmic({0, 1e-6, 1, 1e6}, true);
  EXPECT_EQ(linear(0), 0u);
  EXPECT_EQ(linear(infinity), 1u);
  EXPECT_EQ(linear(10), 2u);
  EXPECT_EQ(linear(30), 65535u);
  EXPECT_NEAR(linear(20), 2 + 65533 / 2., 1);
  EXPECT_NEAR(logarithmic(1), 2 + 65533 / 2., 1);
  EXPECT_EQ(internal::Rounded_values({5, 5}, false)(5), 2u);
}

TEST(Mesh_page, writes_differences_of_any_size)
{
  internal::Page_bytes bytes;
  for(const std::size_t number : {0u, 200u, 100u, 4000000000u})
    bytes.add_difference(number);
  std::ostringstream out;
  bytes.write(out);
  const std::string text = bytes_of(out.str().substr(1));
  EXPECT_EQ(text.substr(0, 5), std::string({0, char(0x90), 3, char(0xc7), 1})); // 0, 2 * 200, 2 * 100 - 1
  EXPECT_EQ(text.size(), 10u);
}

TEST(Mesh_page, scales_what_are_lengths)
{
  CGAL::Mesh_page_3 page = small_page();
  page.scale_lengths(10);
  EXPECT_EQ(page.points[3][2], 20);
  EXPECT_EQ(page.values[0].values[1], 20);
  EXPECT_DOUBLE_EQ(page.values[1].values[1], 0.05);
  EXPECT_EQ(page.findings[1].places[0][0], 10);
}

TEST(Mesh_page, refuses_arrays_that_do_not_fit)
{
  const auto expect_refused = [](const char* sentence, auto change) {
    CGAL::Mesh_page_3 page = small_page();
    change(page);
    try {
      internal::check_page(page);
      ADD_FAILURE() << sentence;
    }
    catch(const CGAL::Parametric_surface_mesh_error& error) {
      EXPECT_NE(std::string(error.what()).find(sentence), std::string::npos) << error.what();
    }
  };
  expect_refused("there is no triangle", [](auto& page) { page.triangles.clear(); });
  expect_refused("triangle 2 has a corner that does not exist", [](auto& page) { page.triangles[1][2] = 4; });
  expect_refused("triangle 1 lies on a face that does not exist", [](auto& page) { page.triangle_faces[0] = 2; });
  expect_refused("not finite", [](auto& page) { page.points[0][1] = std::nan(""); });
  expect_refused("a parameter of a corner is not finite", [](auto& page) { page.corner_parameters[1][0][1] = std::nan(""); });
  expect_refused("'closed up' is said of a place", [](auto& page) { page.findings[1].places[0][2] = std::nan(""); });
  expect_refused("'height' has not one value", [](auto& page) { page.values[0].values.pop_back(); });
  expect_refused("'angle' is said of a triangle", [](auto& page) { page.findings[0].triangles = {2}; });
  expect_refused("belongs to a part", [](auto& page) { page.faces[0].part = 0; });
}

#ifdef MESH_PICTURES_WITH_Z_BUFFER

// Pixels of an image that are more red than blue.
std::size_t number_of_red_pixels(const mesh_picture::Image& image)
{
  std::size_t result = 0;
  for(std::size_t i = 0; i < image.bytes.size(); i += 3)
    result += image.bytes[i] > image.bytes[i + 2] + 50;
  return result;
}

// A blue triangle that rises towards the viewer, and a small red one beside its highest corner. If they were painted in the order of
// their middles, the red one would always be on top.
mesh_picture::Image image_of_two_triangles(double height_of_red)
{
  const std::vector<std::array<double, 3>> points{{{0, 0, 10}}, {{-9, -9, -50}}, {{9, -9, -50}},
                                                  {{0, -0.5, height_of_red}}, {{-0.2, -1, height_of_red}}, {{0.2, -1, height_of_red}}};
  Surface_picture_options options;
  options.azimuth = -90;
  options.elevation = 90;
  options.faces = {0, 1};
  options.face_colors = {mesh_picture::Color{50, 80, 250}, mesh_picture::Color{250, 60, 50}};
  return mesh_picture::Image_painter(points, {{{0, 1, 2}}, {{3, 4, 5}}}, options).image();
}

TEST(Mesh_picture, hides_what_is_hidden)
{
  try {
    const mesh_picture::Image hidden = image_of_two_triangles(0), seen = image_of_two_triangles(10);
    EXPECT_EQ(hidden.width, mesh_picture::width_of_image);
    EXPECT_EQ(number_of_red_pixels(hidden), 0u);
    EXPECT_GT(number_of_red_pixels(seen), 100u);
    const std::vector<char> png = mesh_picture::png_of(seen);
    EXPECT_EQ(std::string(png.data() + 1, 3), "PNG");
  }
  catch(const std::runtime_error& error) {
    GTEST_SKIP() << error.what();
  }
}

TEST(Mesh_picture, has_sharp_edges_between_faces)
{
  const std::vector<std::array<double, 3>> points{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
  const std::vector<std::array<std::size_t, 3>> triangles{{{0, 1, 2}}, {{0, 2, 3}}};
  const auto smooth = mesh_picture::corner_normals(points, triangles, {}), sharp = mesh_picture::corner_normals(points, triangles, {0, 1});
  EXPECT_EQ(sharp[0], (std::array<double, 3>{{0, 0, 1}}));
  EXPECT_EQ(sharp[3], (std::array<double, 3>{{1, 0, 0}}));
  EXPECT_EQ(smooth[0], smooth[3]);
  EXPECT_NEAR(smooth[0][0], std::sqrt(0.5), 1e-15);
}

#endif

} // namespace
