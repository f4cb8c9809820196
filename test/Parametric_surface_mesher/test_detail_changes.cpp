// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Changes around a triangle keep the topology of each shell, and move no point farther than the width.
#include <CGAL/Parametric_surface_mesher/internal/curing/Corner_angles.h>
#include <CGAL/Parametric_surface_mesher/internal/curing/Detail_changes.h>
#include <CGAL/Parametric_surface_mesher/internal/curing/Detail_curing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace internal = CGAL::Parametric_surface_mesher::internal;

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Space_kernel;
typedef internal::Triangle_complex<Space_kernel> Complex;
typedef internal::Detail_changes<Space_kernel> Changes;
typedef Space_kernel::Point_3 Point_3;

const double width = 0.1;

// a complex of triangles of one patch in shell 0; all vertices are inside of it
Complex make_complex(const std::vector<Point_3>& points, const std::vector<std::array<std::size_t, 3>>& triangles)
{
  Complex result;
  for(const Point_3& p : points)
    result.add_vertex({p, 2, 0, false});
  for(const auto& t : triangles) {
    Complex::Triangle triangle{t, {}, 0, {0, Complex::none}, 0};
    for(std::size_t i = 0; i < 3; ++i)
      triangle.uv[i] = {points[t[i]].x(), points[t[i]].y()};
    result.add_triangle(triangle);
  }
  return result;
}

std::size_t number_of_triangles(const Complex& complex)
{
  return std::size_t(std::count_if(complex.triangles().begin(), complex.triangles().end(),
                                   [](const Complex::Triangle& t) { return !t.is_removed; }));
}

// vertices - edges + triangles, of what is there
std::ptrdiff_t euler_characteristic(const Complex& complex)
{
  std::set<std::size_t> vertices;
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for(const Complex::Triangle& t : complex.triangles())
    for(std::size_t i = 0; i < 3 && !t.is_removed; ++i) {
      vertices.insert(t.vertices[i]);
      edges.insert(std::minmax(t.vertices[i], t.vertices[(i + 1) % 3]));
    }
  return std::ptrdiff_t(vertices.size()) - std::ptrdiff_t(edges.size()) + std::ptrdiff_t(number_of_triangles(complex));
}

std::vector<Changes::Change> all_changes(const Complex& complex, std::size_t triangle)
{
  const Changes changes(complex, width);
  std::vector<Changes::Change> result = changes.around(triangle);
  for(const auto& slide : changes.slides_around(triangle))
    result.push_back(slide);
  return result;
}

// the plane z = 0
struct Plane
{
  struct Jet
  {
    Space_kernel::Vector_3 du, dv;
  };

  Point_3 point(double u, double v) const { return {u, v, 0}; }
  Jet jet(double, double) const { return {{1, 0, 0}, {0, 1, 0}}; }
};

// A flat triangle at a vertex of the model, number 0, which is all that is left of patch 1; patch 0 is around it.
Complex make_remnant()
{
  Complex result = make_complex({{0, 0, 0}, {0.5, 0.02, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {-1, 0, 0}, {2, 0, 0}},
                                {{0, 3, 5}, {0, 1, 3}, {1, 2, 3}, {2, 6, 3}, {0, 5, 4}, {0, 4, 2}, {2, 4, 6}, {0, 2, 1}});
  Complex with_dimensions;
  for(std::size_t v = 0; v < result.vertices().size(); ++v) {
    auto vertex = result.vertex(v);
    vertex.dimension = v == 0 ? 0 : v < 3 ? 1 : 2;
    vertex.triangles.clear();
    with_dimensions.add_vertex(vertex);
  }
  for(std::size_t t = 0; t < result.triangles().size(); ++t) {
    Complex::Triangle triangle = result.triangle(t);
    triangle.patch = t + 1 == result.triangles().size() ? 1 : 0;
    with_dimensions.add_triangle(triangle);
  }
  return with_dimensions;
}

// two triangles over a short edge, the second apex at this distance from the edge
Complex make_kite(double short_edge, double height = 1)
{
  return make_complex({{0, 0, 0}, {short_edge, 0, 0}, {0, 1, 0}, {0.3 * short_edge, -height, 0}}, {{0, 1, 2}, {1, 0, 3}});
}

} // namespace

// The edge between two vertices of the border is inside: joining them would leave triangles that meet in a point.
TEST(Detail_changes, do_not_pinch_the_border)
{
  const Complex complex = make_kite(0.01);
  for(const auto& change : all_changes(complex, 0))
    EXPECT_FALSE(change.removed.size() > change.added.size() && change.displacements.size() == 1) << change.survivor;
}

// A tetrahedron is the smallest closed surface; it does not vanish, however small it is.
TEST(Detail_changes, keep_a_closed_surface)
{
  const Complex complex = make_complex({{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 0.01}},
                                       {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  EXPECT_TRUE(all_changes(complex, 0).empty());
}

// A thin tube: its corners are not joined around it, though they are close; along it they may be.
TEST(Detail_changes, keep_a_handle)
{
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  const std::size_t n = 3, m = 5; // corners of the section, and sections of a tube from 0 to 4
  for(std::size_t j = 0; j < m; ++j)
    for(const Point_3& p : {Point_3(0, 0, 0), Point_3(0.01, 0, 0), Point_3(0, 0.01, 0)})
      points.emplace_back(p.x(), p.y(), double(j));
  for(std::size_t j = 0; j + 1 < m; ++j)
    for(std::size_t i = 0; i < n; ++i) {
      const std::size_t a = n * j + i, b = n * j + (i + 1) % n;
      triangles.push_back({a, b, b + n});
      triangles.push_back({a, b + n, a + n});
    }
  Complex complex = make_complex(points, triangles);
  ASSERT_EQ(0, euler_characteristic(complex));
  for(std::size_t t = 0; t < triangles.size(); ++t)
    for(const auto& change : all_changes(complex, t)) {
      const auto back = complex.apply(change);
      EXPECT_EQ(0, euler_characteristic(complex)) << "triangle " << t;
      complex.take_back(back);
    }
}

TEST(Detail_changes, move_no_farther_than_the_width)
{
  const auto has_collapse = [](double length) {
    // a fan around two close vertices inside of a hexagon
    const Complex complex
      = make_complex({{0, 0, 0}, {length, 0, 0}, {2, 0, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0}, {-1, -2, 0}, {1, -2, 0}},
                     {{1, 2, 3}, {0, 1, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 7}, {0, 7, 1}, {1, 7, 2}});
    const auto changes = Changes(complex, width).around(1);
    return std::any_of(changes.begin(), changes.end(), [](const auto& c) { return c.removed.size() == c.added.size() + 2; });
  };
  EXPECT_TRUE(has_collapse(0.5 * width));
  // a vertex inside of a face may be slid away in its plane, at any distance
  const Complex complex = make_complex({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0.01, 0.01, 2 * width}},
                                       {{5, 1, 2}, {5, 2, 3}, {5, 3, 4}, {5, 4, 1}});
  EXPECT_TRUE(Changes(complex, width).slides_around(0).empty());
  EXPECT_FALSE(Changes(complex, 3 * width).slides_around(0).empty());
  EXPECT_FALSE(has_collapse(1.1 * width));
}

// Three vertices are close to each other, in the middle of others. Triangle 0 has two of them, and the third one is across the side
// between them.
TEST(Detail_changes, join_vertices_beside_short_sides)
{
  const Complex complex
    = make_complex({{0, 0, 0}, {0.01, 0, 0}, {0.005, 0.01, 0}, {0.005, -1, 0}, {2, 1, 0}, {-2, 1, 0}},
                   {{1, 0, 3}, {0, 1, 2}, {1, 3, 4}, {1, 4, 2}, {2, 4, 5}, {0, 2, 5}, {0, 5, 3}});
  std::set<std::size_t> survivors;
  for(const auto& change : Changes(complex, width).around(0))
    if(change.removed == complex.vertex(2).triangles)
      survivors.insert(change.survivor);
  EXPECT_EQ((std::set<std::size_t>{0, 1}), survivors);
}

// What is applied and taken back leaves no trace.
TEST(Detail_changes, are_taken_back)
{
  Complex complex = make_complex({{0, 0, 0}, {1, 0, 0}, {0.5, 0.01, 0}, {0.5, -1, 0}, {0.5, 1, 0}},
                                 {{0, 1, 2}, {1, 0, 3}, {0, 2, 4}, {2, 1, 4}});
  const auto changes = Changes(complex, width).around(0);
  ASSERT_FALSE(changes.empty());
  for(const auto& change : changes) {
    complex.take_back(complex.apply(change));
    EXPECT_EQ(4u, number_of_triangles(complex));
    EXPECT_EQ(4u, complex.triangles().size());
    for(const auto& vertex : complex.vertices())
      EXPECT_EQ(0, vertex.displacement.length());
  }
  const auto insertion = std::find_if(changes.begin(), changes.end(), [](const auto& c) { return c.survivor == 2; });
  ASSERT_NE(changes.end(), insertion);
  complex.apply(*insertion); // vertex 2 is put into the long edge: the flat triangle vanishes, that across the edge is split
  EXPECT_EQ(4u, number_of_triangles(complex));
  EXPECT_TRUE(complex.triangles_at(0, 1).empty());
}

// An edge with three triangles of one shell is joined only along itself.
TEST(Detail_changes, keep_edges_that_are_not_manifold)
{
  const Complex complex = make_complex({{0, 0, 0}, {0.01, 0, 0}, {0.005, 1, 0}, {0.005, -1, 0}, {0.005, 0, 1}, {0, 0.5, -1}},
                                       {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {2, 0, 5}});
  for(const auto& change : all_changes(complex, 3))
    EXPECT_TRUE(change.removed.size() <= change.added.size() || change.survivor != 1) << change.survivor;
}

// A small angle at a vertex of the model is excused by a corner of the shape that is as sharp, not by what curing has left of a patch.
TEST(Detail_curing, removes_remnants_at_vertices_of_the_model)
{
  const std::vector<Plane> surfaces(2);
  const std::vector<bool> are_reversed(2, false);
  const auto number_left = [&](Complex complex, const internal::Corner_angles<Space_kernel>& corners) {
    internal::Detail_curing<Space_kernel, Plane> curing(complex, surfaces, are_reversed, corners, width, width);
    curing([] { return true; });
    return std::count_if(complex.triangles().begin(), complex.triangles().end(),
                         [](const Complex::Triangle& t) { return !t.is_removed && t.patch == 1; });
  };
  const Complex complex = make_remnant();
  internal::Corner_angles<Space_kernel> corners;
  EXPECT_EQ(0, number_left(complex, corners));
  corners.add(complex);
  EXPECT_EQ(1, number_left(complex, corners));
}

TEST(Corner_angles, are_those_between_borders)
{
  internal::Corner_angles<Space_kernel> corners;
  corners.add(make_remnant());
  const double of_remnant = std::atan(0.04);
  EXPECT_TRUE(corners.has_corner_as_small({0, 0, 0}, 1, of_remnant));
  EXPECT_FALSE(corners.has_corner_as_small({0, 0, 0}, 1, 0.8 * of_remnant));
  EXPECT_FALSE(corners.has_corner_as_small({0, 0, 0}, 0, 5)); // the rest of a full turn
  EXPECT_TRUE(corners.has_corner_as_small({0, 0, 0}, 0, 6.2));
  EXPECT_FALSE(corners.has_corner_as_small({1, 0, 0}, 1, of_remnant)); // no vertex of the model
}
