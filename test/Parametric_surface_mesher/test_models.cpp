// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models of several patches: what is joined, what is refused, and that the meshes have no crack.
#include <CGAL/B_spline_surface_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/IO/read_bezier_patches.h>
#include <CGAL/Parametric_function_surface_3.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Rectangular_patch_3.h>
#include <CGAL/Triangle_mesh_quality.h>
#include <CGAL/make_model_of_rectangular_patches.h>
#include <CGAL/make_parametric_surface_triangle_soup.h>

#include <gtest/gtest.h>

#include <mesher_test_helpers.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

typedef CGAL::Bezier_surface_3<Test_kernel> Bezier;
typedef CGAL::Parametric_surface_model_3<Bezier> Model;

namespace {

// the bilinear patch with the corners S(0,0), S(1,0), S(1,1), S(0,1)
Bezier patch(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
{
  return Bezier(1, 1, std::vector<Point_3>{a, b, d, c});
}

// the same patch seen in one of the 8 ways to lay it over the unit square: from 4 on it faces to the other side
Bezier patch_turned(std::array<Point_3, 4> corners, int way)
{
  if(way >= 4)
    std::swap(corners[1], corners[3]);
  return patch(corners[way % 4], corners[(way + 1) % 4], corners[(way + 2) % 4], corners[(way + 3) % 4]);
}

struct Meshed_model
{
  Mesh mesh;
  Report report;
  CGAL::Triangle_mesh_quality quality;
};

template <class AnyModel>
Meshed_model mesh_model(const AnyModel& model, double max_edge)
{
  Meshed_model result;
  const Criteria criteria = Criteria().set_max_edge(max_edge);
  result.report = CGAL::make_parametric_surface_mesh(model, criteria, result.mesh);
  EXPECT_TRUE(result.mesh.is_valid());
  result.quality = CGAL::triangle_mesh_quality(result.mesh);
  EXPECT_EQ(result.report.number_of_faces, result.mesh.number_of_faces());
  EXPECT_EQ(result.report.number_of_vertices, result.mesh.number_of_vertices());
  EXPECT_TRUE(result.quality.is_manifold);
  EXPECT_EQ(0u, result.quality.number_of_degenerate_faces);
  EXPECT_EQ(0u, result.quality.number_of_isolated_vertices);
  return result;
}

Meshed_model mesh_patches(const std::vector<Bezier>& patches, double max_edge)
{
  return mesh_model(CGAL::make_model_of_rectangular_patches(patches), max_edge);
}

void expect_topology(const Meshed_model& m, std::size_t components, std::size_t cycles, std::ptrdiff_t euler)
{
  EXPECT_EQ(components, m.quality.number_of_connected_components);
  EXPECT_EQ(cycles, m.quality.number_of_boundary_cycles);
  EXPECT_EQ(euler, m.quality.euler_characteristic);
}

std::vector<Bezier> teapot()
{
  return CGAL::IO::read_bezier_patches<Test_kernel>(std::string(PARAMETRIC_SURFACE_MESHER_DATA_DIR) + "/teapot.bpt");
}

// the corners of the sides of the unit cube, counterclockwise from outside
std::vector<std::array<Point_3, 4>> sides_of_cube()
{
  const Point_3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), xy(1, 1, 0), xz(1, 0, 1), yz(0, 1, 1), xyz(1, 1, 1);
  return {{o, y, xy, x}, {z, xz, xyz, yz}, {o, x, xz, z}, {y, yz, xyz, xy}, {o, z, yz, y}, {x, xy, xyz, xz}};
}

double signed_volume(const Mesh& mesh)
{
  return CGAL::to_double(CGAL::Polygon_mesh_processing::volume(mesh));
}

// a strip of `n` patches around the z axis that turns over `half_turns` times
std::vector<Bezier> twisted_strip(int n, int half_turns)
{
  const double pi = 4 * std::atan(1.);
  const auto point = [&](int i, double side) {
    const double angle = 2 * pi * (i % n) / n, twist = pi * half_turns * i / n; // the place repeats, the twist goes on
    const double r = 3 + side * std::cos(twist);
    return Point_3(r * std::cos(angle), r * std::sin(angle), side * std::sin(twist));
  };
  std::vector<Bezier> result;
  for(int i = 0; i < n; ++i)
    result.push_back(patch(point(i, -1), point(i + 1, -1), point(i + 1, 1), point(i, 1)));
  return result;
}

} // namespace

TEST(Models, teapot)
{
  const std::vector<Bezier> patches = teapot();
  ASSERT_EQ(28u, patches.size());
  for(double max_edge : {0.5, 0.1}) {
    const Meshed_model m = mesh_patches(patches, max_edge);
    expect_topology(m, 4, 7, 1); // lid, and body, handle and spout with two openings each
    EXPECT_GT(m.quality.min_angle, 5);
    EXPECT_LE(number_of_unmet_but_at_short_edges(m.report), m.mesh.number_of_faces() / 200);
    EXPECT_LE(m.report.count(CGAL::Parametric_surface_mesher::Unmet_cause::NO_BETTER_POINT), m.mesh.number_of_faces() / 2000);
  }
}

TEST(Models, teapot_is_the_same_again)
{
  const Meshed_model a = mesh_patches(teapot(), 0.2), b = mesh_patches(teapot(), 0.2);
  ASSERT_EQ(a.mesh.number_of_vertices(), b.mesh.number_of_vertices());
  ASSERT_EQ(a.mesh.number_of_faces(), b.mesh.number_of_faces());
  for(const auto v : a.mesh.vertices())
    EXPECT_EQ(a.mesh.point(v), b.mesh.point(v));
  for(const auto f : a.mesh.faces())
    EXPECT_EQ(corners(a.mesh, f), corners(b.mesh, f));
}

// Two half cylinders, so coarse that both would join the same boundary vertices across.
TEST(Models, edges_across_narrow_patches_are_not_repeated)
{
  const Point_3 a(-1, 0, 0), b(1, 0, 0), c(1, 0, 9), d(-1, 0, 9);
  const Bezier front(2, 1, std::vector<Point_3>{a, Point_3(0, -1, 0), b, d, Point_3(0, -1, 9), c});
  const Bezier back(2, 1, std::vector<Point_3>{a, Point_3(0, 1, 0), b, d, Point_3(0, 1, 9), c});
  Mesh mesh;
  const Criteria coarse = Criteria().set_max_edge(20).set_min_edge(5).set_gamma(10);
  CGAL::make_parametric_surface_mesh(
    CGAL::make_model_of_rectangular_patches(std::vector<Bezier>{front, back}), coarse, mesh);
  const auto quality = CGAL::triangle_mesh_quality(mesh);
  EXPECT_TRUE(mesh.is_valid());
  EXPECT_TRUE(quality.is_manifold);
}

TEST(Models, closed_sphere_of_one_face)
{
  const double pi = 4 * std::atan(1.);
  typedef CGAL::Parametric_sphere_3<Test_kernel> Sphere;
  typedef CGAL::Parametric_surface_model_3<Sphere> Sphere_model;
  Sphere_model model;
  const Sphere sphere(1);
  const std::size_t south = model.add_vertex(sphere.point(0, -pi / 2)), north = model.add_vertex(sphere.point(0, pi / 2));
  const std::size_t bottom = model.add_edge(south, south, true), seam = model.add_edge(south, north),
                    top = model.add_edge(north, north, true);
  const Point_2 a(0, -pi / 2), b(2 * pi, -pi / 2), c(2 * pi, pi / 2), d(0, pi / 2);
  model.add_face({sphere,
                  {{{bottom, false, Curve::segment(a, b)},
                    {seam, false, Curve::segment(b, c)},
                    {top, true, Curve::segment(d, c)},
                    {seam, true, Curve::segment(a, d)}}}});
  const Meshed_model m = mesh_model(model, 0.1);
  expect_topology(m, 1, 0, 2);
  EXPECT_TRUE(m.report.unmet.empty());
  EXPECT_GE(m.quality.min_angle, 30);
  EXPECT_NEAR(CGAL::Polygon_mesh_processing::volume(m.mesh), 4 * pi / 3, 0.02);
}

TEST(Models, patch_ids_and_domain_points)
{
  const std::vector<Bezier> patches = teapot();
  Mesh mesh;
  const auto ids = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch", 99).first;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  CGAL::make_parametric_surface_mesh(CGAL::make_model_of_rectangular_patches(patches), Criteria().set_max_edge(0.2), mesh,
                                     CGAL::parameters::face_patch_id_map(ids, CGAL::parameters::halfedge_uv_map(uv)));
  std::set<std::size_t> found;
  for(const auto f : mesh.faces()) {
    ASSERT_LT(ids[f], patches.size());
    found.insert(ids[f]);
    for(const auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
      EXPECT_LT(distance(patches[ids[f]].point(uv[h].x(), uv[h].y()), mesh.point(mesh.target(h))), 1e-9);
  }
  EXPECT_EQ(patches.size(), found.size());
}

TEST(Models, two_patches_in_all_directions)
{
  const Bezier first = patch(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0));
  const std::array<Point_3, 4> second = {Point_3(1, 0, 0), Point_3(2, 0, 0), Point_3(2, 1, 0), Point_3(1, 1, 0)};
  for(int way = 0; way < 8; ++way) {
    SCOPED_TRACE(way);
    const Model model = CGAL::make_model_of_rectangular_patches(std::vector<Bezier>{first, patch_turned(second, way)});
    EXPECT_EQ(6u, model.vertices().size());
    EXPECT_EQ(7u, model.edges().size());
    EXPECT_FALSE(model.faces()[0].is_reversed);
    EXPECT_EQ(way >= 4, model.faces()[1].is_reversed);
    const Meshed_model m = mesh_model(model, 0.13);
    expect_topology(m, 1, 1, 1);
    EXPECT_NEAR(2, m.quality.area, 1e-12);
    EXPECT_EQ(0u, m.report.unmet.size());
    for(const auto f : m.mesh.faces()) { // all face upward
      const auto v = corners(m.mesh, f);
      EXPECT_GT(cross_product(m.mesh.point(v[1]) - m.mesh.point(v[0]), m.mesh.point(v[2]) - m.mesh.point(v[0])).z(), 0);
    }
  }
}

TEST(Models, patches_that_touch_in_a_corner_stay_apart)
{
  const Bezier first = patch(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0)),
               second = patch(Point_3(1, 1, 0), Point_3(2, 1, 0), Point_3(2, 2, 0), Point_3(1, 2, 0));
  expect_topology(mesh_patches({first, second}, 0.2), 2, 2, 2);
}

TEST(Models, collapsed_side)
{
  // each of the four sides in turn; in two directions
  const Point_3 a(0, 0, 0), b(1, 0, 0), c(0.4, 1, 0.2);
  for(int way = 0; way < 8; ++way) {
    SCOPED_TRACE(way);
    const Meshed_model m = mesh_patches({patch_turned({a, b, c, c}, way)}, 0.1);
    expect_topology(m, 1, 1, 1);
    EXPECT_GT(m.quality.number_of_faces, 50u);
    EXPECT_GT(m.quality.min_angle, 10);
  }
}

TEST(Models, pyramid_of_collapsed_patches)
{
  const std::array<Point_3, 4> base = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0)};
  const Point_3 apex(0.5, 0.5, 1);
  std::vector<Bezier> patches;
  for(int i = 0; i < 4; ++i)
    patches.push_back(patch_turned({base[i], base[(i + 1) % 4], apex, apex}, 2 * i + i / 2));
  expect_topology(mesh_patches(patches, 0.1), 1, 1, 1);
}

TEST(Models, closed_box)
{
  const auto sides = sides_of_cube();
  for(int start = 0; start < 8; ++start) {
    SCOPED_TRACE(start);
    std::vector<Bezier> patches;
    for(std::size_t i = 0; i < sides.size(); ++i)
      patches.push_back(patch_turned(sides[i], (start + 3 * int(i)) % 8));
    const Meshed_model m = mesh_patches(patches, 0.2);
    expect_topology(m, 1, 0, 2);
    EXPECT_TRUE(m.quality.is_closed);
    EXPECT_EQ(0u, m.report.unmet.size());
    EXPECT_NEAR(1, signed_volume(m.mesh), 1e-12); // whatever the direction of the first patch
  }
}

// The same arc with two parametrisations, by weights; the second surface goes on outward.
TEST(Models, patches_that_run_through_their_common_curve_at_different_speeds)
{
  typedef CGAL::B_spline_surface_3<Test_kernel> Spline;
  const double w = std::sqrt(0.5);
  const std::vector<double> quadratic = {0, 0, 0, 1, 1, 1}, linear = {0, 0, 1, 1};
  const Point_3 a(1, 0, 0), b(1, 1, 0), c(0, 1, 0);
  const Vector_3 up(0, 0, 1);
  const Spline wall(2, 1, quadratic, linear, std::vector<Point_3>{a, b, c, a + up, b + up, c + up}, {1, w, 1, 1, w, 1});
  const Spline floor(2, 1, quadratic, linear,
                     std::vector<Point_3>{a, b, c, Point_3(2, 0, 0), Point_3(2, 2, 0), Point_3(0, 2, 0)},
                     {1, 2 * w, 4, 1, 2 * w, 4});
  ASSERT_GT(distance(wall.point(0.5, 0), floor.point(0.5, 0)), 0.1);
  for(const auto& patches : {std::vector<Spline>{wall, floor}, std::vector<Spline>{floor, wall}}) {
    const auto model = CGAL::make_model_of_rectangular_patches(patches);
    EXPECT_EQ(7u, model.edges().size());
    const Meshed_model m = mesh_model(model, 0.1);
    expect_topology(m, 1, 1, 1);
    EXPECT_EQ(0u, m.report.unmet.size());
    EXPECT_NEAR(2 * std::atan(1.) * (1 + 1.5), m.quality.area, 0.005);
  }
}

TEST(Models, strips)
{
  for(int n : {3, 4, 7}) {
    expect_topology(mesh_patches(twisted_strip(n, 0), 0.5), 1, 2, 0);
    expect_refused([&] { CGAL::make_model_of_rectangular_patches(twisted_strip(n, 1)); }, "not orientable", "faces ");
  }
  expect_topology(mesh_patches(twisted_strip(6, 2), 0.5), 1, 2, 0);
}

// Where three patches meet the mesh is cut: three pieces. The triangle soup is not.
TEST(Models, three_patches_on_one_edge)
{
  const Point_3 a(0, 0, 0), b(0, 0, 1);
  std::vector<Bezier> patches;
  for(const Vector_3& d : {Vector_3(1, 0, 0), Vector_3(-1, 1, 0), Vector_3(-1, -1, 0)})
    patches.push_back(patch(a, a + d, b + d, b));
  const Model model = CGAL::make_model_of_rectangular_patches(patches);
  const Meshed_model m = mesh_model(model, 0.2);
  expect_topology(m, 3, 3, 3);

  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> patch_ids;
  CGAL::make_parametric_surface_triangle_soup(model, Criteria().set_max_edge(0.2), points, triangles, patch_ids);
  ASSERT_EQ(m.mesh.number_of_faces(), triangles.size());
  ASSERT_EQ(triangles.size(), patch_ids.size());
  std::map<std::pair<std::size_t, std::size_t>, int> uses;
  for(const auto& t : triangles)
    for(int k = 0; k < 3; ++k)
      ++uses[std::minmax(t[k], t[(k + 1) % 3])];
  const auto is_on_axis = [&](std::size_t v) { return points[v].x() == 0 && points[v].y() == 0; };
  std::size_t on_axis = 0;
  for(const auto& use : uses)
    if(is_on_axis(use.first.first) && is_on_axis(use.first.second)) {
      EXPECT_EQ(3, use.second);
      ++on_axis;
    }
  EXPECT_EQ(5u, on_axis);
  EXPECT_EQ(m.mesh.number_of_vertices(), points.size() + 2 * (on_axis + 1));
}

TEST(Models, cylinder_with_a_seam)
{
  typedef CGAL::Parametric_cylinder_3<Test_kernel> Cylinder;
  CGAL::Parametric_surface_model_3<Cylinder> model;
  const double turn = 8 * std::atan(1.);
  const Cylinder cylinder(1);
  const std::size_t below = model.add_vertex(cylinder.point(0, 0)), above = model.add_vertex(cylinder.point(0, 2));
  const std::size_t bottom = model.add_edge(below, below), top = model.add_edge(above, above),
                    seam = model.add_edge(below, above);
  const Point_2 a(0, 0), b(turn, 0), c(turn, 2), d(0, 2);
  model.add_face({cylinder,
                  {{{bottom, false, Curve::segment(a, b)},
                    {seam, false, Curve::segment(b, c)},
                    {top, true, Curve::segment(d, c)},
                    {seam, true, Curve::segment(a, d)}}}});
  const Meshed_model m = mesh_model(model, 0.2);
  expect_topology(m, 1, 2, 0);
  EXPECT_NEAR(2 * turn, m.quality.area, 0.05);
}

TEST(Models, patches_that_are_not_finite_and_negative_tolerances_are_refused)
{
  const auto pole = CGAL::make_parametric_function_surface([](auto u, auto v) {
    using std::log;
    return CGAL::parametric_surface_point(u, v, log(u * u + v * v));
  });
  typedef CGAL::Rectangular_patch_3<std::decay_t<decltype(pole)>> Patch;
  const auto make = [&](double v_min, double tolerance) {
    return [=] { CGAL::make_model_of_rectangular_patches(std::vector<Patch>{Patch(pole, 1, 2, 1, 2), Patch(pole, -1, 1, v_min, 1)}, tolerance); };
  };
  expect_refused(make(-1, 0), "patch 2: the surface is not finite at (u,v) = (0, 0)");
  expect_refused(make(0.5, -1), "the tolerance of patches must be at least 0, and is -1");
  EXPECT_NO_THROW(make(0.5, 0)());
}

TEST(Models, errors_name_the_face_and_leave_the_mesh)
{
  Model model = CGAL::make_model_of_rectangular_patches(teapot());
  std::swap(model.faces()[5].loops[0][0].curve, model.faces()[5].loops[0][2].curve);
  Mesh mesh;
  CGAL::make_triangle(Point_3(1, 2, 3), Point_3(4, 5, 6), Point_3(7, 8, 10), mesh);
  expect_refused([&] { CGAL::make_parametric_surface_mesh(model, Criteria().set_max_edge(0.5), mesh); }, "face 6");
  EXPECT_EQ(3u, mesh.number_of_vertices());
  EXPECT_EQ(1u, mesh.number_of_faces());
}
