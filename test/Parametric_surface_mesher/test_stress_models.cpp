// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stress tests: models of several faces and shells, edges with curves of their own, and models that do not fit together.
#include <CGAL/Bezier_surface_3.h>
#include <CGAL/make_parametric_surface_triangle_soup.h>
#include <CGAL/Parametric_surface_mesher/orient_faces.h>

#include <gtest/gtest.h>

#include <stress_test_helpers.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef std::array<Point_3, 4> Quad; // counterclockwise as seen from where it faces to
typedef CGAL::Space_curve_3<Test_kernel> Space_curve;

Sample_surface bilinear(const Quad& q)
{
  return Sample_surface(CGAL::Bezier_surface_3<Test_kernel>(1, 1, std::vector<Point_3>{q[0], q[1], q[3], q[2]}));
}

const std::array<Point_2, 4> unit_square = {Point_2(0, 0), Point_2(1, 0), Point_2(1, 1), Point_2(0, 1)};

// Builds a model of bilinear faces: equal corners are one vertex, equal sides one edge.
class Quad_model
{
  Model m_model;
  std::map<Point_3, std::size_t> m_vertices;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> m_edges;

public:
  const Model& model() const { return m_model; }

  Quad_model& add(const Quad& quad, std::size_t shell = 0)
  {
    Model::Loop loop;
    for(int i = 0; i < 4; ++i) {
      const std::size_t source = vertex(quad[i]), target = vertex(quad[(i + 1) % 4]);
      const std::size_t e = edge(source, target);
      const bool is_reversed = m_model.edges()[e].source != source;
      const Point_2 &p = unit_square[i], &q = unit_square[(i + 1) % 4];
      loop.push_back({e, is_reversed, is_reversed ? Curve::segment(q, p) : Curve::segment(p, q)});
    }
    m_model.add_face({bilinear(quad), {loop}, false, shell});
    return *this;
  }

private:
  std::size_t vertex(const Point_3& p)
  {
    const auto found = m_vertices.find(p);
    return found != m_vertices.end() ? found->second : m_vertices[p] = m_model.add_vertex(p);
  }

  std::size_t edge(std::size_t source, std::size_t target)
  {
    const std::pair<std::size_t, std::size_t> ends = std::minmax(source, target);
    const auto found = m_edges.find(ends);
    return found != m_edges.end() ? found->second : m_edges[ends] = m_model.add_edge(source, target, source == target);
  }
};

// the sides of the unit cube at `(x, y, z)`, facing outward
std::vector<Quad> sides_of_cube(double x, double y, double z)
{
  const auto p = [=](int a, int b, int c) { return Point_3(x + a, y + b, z + c); };
  return {{p(0, 0, 0), p(0, 1, 0), p(1, 1, 0), p(1, 0, 0)}, {p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1)},
          {p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1)}, {p(0, 1, 0), p(0, 1, 1), p(1, 1, 1), p(1, 1, 0)},
          {p(0, 0, 0), p(0, 0, 1), p(0, 1, 1), p(0, 1, 0)}, {p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), p(1, 0, 1)}};
}

Quad_model& add_cube(Quad_model& quads, double x, double y, double z, std::size_t shell)
{
  for(const Quad& quad : sides_of_cube(x, y, z))
    quads.add(quad, shell);
  return quads;
}

// two unit cubes, the second one at `(x, y, z)`, each a shell of its own
Model two_cubes(double x, double y, double z)
{
  Quad_model quads;
  return add_cube(add_cube(quads, 0, 0, 0, 0), x, y, z, 1).model();
}

const Criteria fifth = Criteria().set_max_edge(0.2);

// Two closed cubes, whatever they have in common.
void check_two_cubes(const Model& model)
{
  const Meshed m = mesh_and_check(model, fifth);
  expect_topology(m, 2, 0, 4);
  EXPECT_EQ(0u, m.topology.border_edges);
  EXPECT_NEAR(2, m.volume(), 1e-9);
  EXPECT_NEAR(12, m.area, 1e-9);
}

struct Soup
{
  std::vector<Point_3> points;
  std::vector<Triangle> triangles;
  std::vector<std::size_t> patch_ids;
  Report report;

  explicit Soup(const Model& model, bool are_points_distinct = true)
  {
    report = CGAL::make_parametric_surface_triangle_soup(model, fifth, points, triangles, patch_ids);
    EXPECT_EQ(triangles.size(), patch_ids.size());
    if(are_points_distinct) {
      EXPECT_EQ(points.size(), std::set<Point_3>(points.begin(), points.end()).size());
    }
    EXPECT_EQ(points.size(), report.number_of_vertices);
    EXPECT_EQ(triangles.size(), report.number_of_faces);
  }

  // by the number of their triangles
  std::map<std::size_t, std::size_t> number_of_edges(const std::function<bool(const Point_3&)>& is_wanted) const
  {
    std::map<std::size_t, std::size_t> result;
    for(const auto& edge : sides_of_edges(triangles))
      if(is_wanted(points[edge.first.first]) && is_wanted(points[edge.first.second]))
        ++result[edge.second.size()];
    return result;
  }
};

// half planes of size 1 along the z axis, at these angles; they face counterclockwise
Model book(const std::vector<double>& angles)
{
  Quad_model quads;
  for(double angle : angles) {
    const Point_3 a(std::cos(angle), std::sin(angle), 0), b(a.x(), a.y(), 1);
    quads.add({Point_3(0, 0, 0), a, b, Point_3(0, 0, 1)});
  }
  return quads.model();
}

bool is_on_axis(const Point_3& p) { return p.x() == 0 && p.y() == 0; }

// Two unit squares side by side with the edge x = 1, number 1, between them. The first one's side is `gap` lower.
Model two_squares(double gap, bool has_curve = false, double tolerance_of_edge = 0)
{
  Model model;
  const Point_3 a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0), e(2, 0, 0), f(2, 1, 0);
  const std::vector<Point_3> vertices = {a, b, c, d, e, f};
  for(const Point_3& p : vertices)
    model.add_vertex(p);
  Model::Edge middle;
  middle.source = 1;
  middle.target = 2;
  middle.tolerance = tolerance_of_edge;
  if(has_curve)
    middle.curve = std::make_shared<Space_curve>(Space_curve::segment(b, c));
  model.add_edge(0, 1);
  model.add_edge(middle);
  for(const auto& ends : std::vector<std::pair<int, int>>{{2, 3}, {3, 0}, {1, 4}, {4, 5}, {5, 2}})
    model.add_edge(ends.first, ends.second);
  const auto& s = unit_square;
  const auto sagging = function_surface(
    [gap](auto u, auto v) { return CGAL::parametric_surface_point(u, v, -4 * gap * u * v * (1 - v)); });
  model.add_face({sagging,
                  {{{0, false, Curve::segment(s[0], s[1])},
                    {1, false, Curve::segment(s[1], s[2])},
                    {2, false, Curve::segment(s[2], s[3])},
                    {3, false, Curve::segment(s[3], s[0])}}}});
  model.add_face({bilinear({b, e, f, c}),
                  {{{4, false, Curve::segment(s[0], s[1])},
                    {5, false, Curve::segment(s[1], s[2])},
                    {6, false, Curve::segment(s[2], s[3])},
                    {1, true, Curve::segment(s[0], s[3])}}}});
  return model;
}

void check_two_squares(const Model& model)
{
  const Meshed m = mesh_and_check(model, fifth);
  expect_topology(m, 1, 1, 1);
  expect_distinct_points(m.mesh);
  EXPECT_NEAR(2, m.area, 1e-3);
  for(const auto v : m.mesh.vertices())
    EXPECT_TRUE(m.mesh.point(v).x() != 1 || m.mesh.point(v).z() == 0) << "a point of the edge is not on its curve";
}

// Expects that meshing is refused, and leaves the mesh alone.
template <class... Words>
void expect_model_refused(const Model& model, const Words&... words)
{
  Mesh mesh;
  expect_refused([&] { CGAL::make_parametric_surface_mesh(model, fifth, mesh); }, words...);
  EXPECT_EQ(0u, mesh.number_of_vertices());
  std::vector<Point_3> points(1);
  std::vector<Triangle> triangles;
  std::vector<std::size_t> patch_ids;
  expect_refused([&] { CGAL::make_parametric_surface_triangle_soup(model, fifth, points, triangles, patch_ids); }, words...);
  EXPECT_EQ(1u, points.size());
}

Model::Loop& first_loop(Model& model, std::size_t face) { return model.faces()[face].loops.front(); }

// the ring of `n` squares around the z axis that turns over `half_turns` times
Model twisted_ring(int n, int half_turns)
{
  const auto point = [&](int i, double side) {
    const double angle = 2 * pi * (i % n) / n, twist = pi * (half_turns * i % (2 * n)) / n;
    const double r = 3 + side * std::cos(twist);
    return Point_3(r * std::cos(angle), r * std::sin(angle), side * std::sin(twist));
  };
  Quad_model quads;
  for(int i = 0; i < n; ++i) {
    const double side = i + 1 == n && half_turns % 2 != 0 ? -1 : 1; // the last one meets the first one turned over
    quads.add({point(i, -1), point((i + 1) % n, -side), point((i + 1) % n, side), point(i, 1)});
  }
  return quads.model();
}

// One face that is a strip around the z axis and turns over `half_turns` times: it meets itself.
Model strip_of_one_face(int half_turns)
{
  const Sample_surface strip = function_surface([half_turns](auto u, auto v) {
    using std::cos;
    using std::sin;
    const auto twist = 0.5 * half_turns * u;
    const auto r = 3 + v * cos(twist);
    return CGAL::parametric_surface_point(r * cos(u), r * sin(u), v * sin(twist));
  });
  Model model;
  const bool is_odd = half_turns % 2 != 0;
  const Point_2 a(0, -1), b(2 * pi, -1), c(2 * pi, 1), d(0, 1);
  const std::size_t v = model.add_vertex(strip.point(0, -1)), w = model.add_vertex(strip.point(0, 1));
  const std::size_t bottom = model.add_edge(v, is_odd ? w : v), seam = model.add_edge(v, w),
                    top = model.add_edge(w, is_odd ? v : w);
  model.add_face({strip,
                  {{{bottom, false, Curve::segment(a, b)},
                    {seam, is_odd, is_odd ? Curve::segment(c, b) : Curve::segment(b, c)},
                    {top, true, Curve::segment(d, c)},
                    {seam, true, Curve::segment(a, d)}}}});
  return model;
}

// four triangles, each a patch with a collapsed side
std::vector<Patch> tetrahedron()
{
  const std::array<Point_3, 4> p = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1)};
  const std::array<std::array<int, 3>, 4> faces = {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  std::vector<Patch> result;
  for(const auto& f : faces)
    result.emplace_back(bilinear({p[f[0]], p[f[1]], p[f[2]], p[f[2]]}), 0, 1, 0, 1);
  return result;
}

} // namespace

TEST(Shells, cubes_that_share_a_face) { check_two_cubes(two_cubes(1, 0, 0)); }

TEST(Shells, cubes_that_share_an_edge) { check_two_cubes(two_cubes(1, 1, 0)); }

TEST(Shells, cubes_that_share_a_vertex) { check_two_cubes(two_cubes(1, 1, 1)); }

TEST(Shells, cubes_apart) { check_two_cubes(two_cubes(5, 0, 0)); }

// Each a shell: what all of them have in common is one point.
TEST(Shells, block_of_eight_cubes)
{
  Quad_model quads;
  for(int i = 0; i < 8; ++i)
    add_cube(quads, i & 1, i >> 1 & 1, i >> 2, i);
  const Meshed m = mesh_and_check(quads.model(), fifth);
  expect_topology(m, 8, 0, 16);
  EXPECT_NEAR(8, m.volume(), 1e-9);
  std::size_t copies = 0;
  for(const auto v : m.mesh.vertices())
    copies += m.mesh.point(v) == Point_3(1, 1, 1);
  EXPECT_EQ(8u, copies);
}

// Without shells of their own the cubes are cut open where four faces meet.
TEST(Shells, cubes_of_one_shell_that_share_an_edge)
{
  Quad_model quads;
  const Model model = add_cube(add_cube(quads, 0, 0, 0, 0), 1, 1, 0, 0).model();
  const Meshed m = mesh_and_check(model, fifth);
  EXPECT_EQ(2u, m.topology.components);
  EXPECT_EQ(4 * 5u, m.topology.border_edges);
}

TEST(Shells, soup_of_cubes_that_share_a_face)
{
  const Soup soup(two_cubes(1, 0, 0), false); // the common face is there twice
  for(const Vector_3& side : {Vector_3(0, 0, 0), Vector_3(0, 0, 1), Vector_3(0, 1, 0), Vector_3(0, 1, 1)}) {
    const bool is_along_y = side.y() == side.z();
    const auto is_on_side
      = [&](const Point_3& p) { return p.x() == 1 && (is_along_y ? p.z() == side.z() : p.y() == side.y()); };
    EXPECT_EQ((std::map<std::size_t, std::size_t>{{4, 5}}), soup.number_of_edges(is_on_side));
  }
  const auto all = soup.number_of_edges([](const Point_3&) { return true; });
  EXPECT_EQ(0u, all.count(1) + all.count(3)) << "there is a border";
}

TEST(Joints, three_faces)
{
  const Model model = book({0, 2, 4});
  const Meshed m = mesh_and_check(model, fifth);
  expect_topology(m, 3, 3, 3);
  const Soup soup(model);
  EXPECT_EQ((std::map<std::size_t, std::size_t>{{3, 5}}), soup.number_of_edges(is_on_axis));
  const auto all = soup.number_of_edges([](const Point_3&) { return true; });
  EXPECT_EQ(3u, all.size());
  EXPECT_EQ(3 * 15u, all.at(1));
  EXPECT_EQ(m.triangles.size(), soup.triangles.size());
}

TEST(Joints, t_joint_within_a_plane)
{
  const double quarter = pi / 2;
  const Model model = book({0, quarter, 2 * quarter});
  expect_topology(mesh_and_check(model, fifth), 3, 3, 3);
  EXPECT_EQ((std::map<std::size_t, std::size_t>{{3, 5}}), Soup(model).number_of_edges([](const Point_3& p) {
    return std::fabs(p.x()) < 1e-12 && p.y() == 0;
  }));
}

TEST(Joints, seven_faces)
{
  const Model model = book({0, 1, 2, 3, 4, 5, 6});
  expect_topology(mesh_and_check(model, fifth), 7, 7, 7);
  EXPECT_EQ((std::map<std::size_t, std::size_t>{{7, 5}}), Soup(model).number_of_edges(is_on_axis));
}

TEST(Joints, three_faces_of_three_shells)
{
  Quad_model quads;
  const Point_3 o(0, 0, 0), z(0, 0, 1);
  quads.add({o, Point_3(1, 0, 0), Point_3(1, 0, 1), z}, 0).add({o, Point_3(0, 1, 0), Point_3(0, 1, 1), z}, 1);
  quads.add({o, Point_3(-1, 0, 0), Point_3(-1, 0, 1), z}, 2);
  expect_topology(mesh_and_check(quads.model(), fifth), 3, 3, 3);
  EXPECT_EQ((std::map<std::size_t, std::size_t>{{3, 5}}), Soup(quads.model()).number_of_edges(is_on_axis));
}

TEST(Edges_with_curves, exact) { check_two_squares(two_squares(0, true)); }

TEST(Edges_with_curves, within_the_default_tolerance) { check_two_squares(two_squares(1e-7, true)); }

TEST(Edges_with_curves, beyond_the_default_tolerance)
{
  expect_model_refused(two_squares(1e-4, true), "face 1", "edge 2", "away from the curve of the edge", "tolerance");
}

TEST(Edges_with_curves, within_a_tolerance_of_the_model)
{
  Model model = two_squares(1e-4, true);
  model.set_tolerance(2e-4);
  check_two_squares(model);
  model.set_tolerance(5e-5);
  expect_model_refused(model, "face 1", "edge 2", "5e-05");
}

TEST(Edges_with_curves, within_a_tolerance_of_the_edge)
{
  const Model model = two_squares(1e-4, true, 2e-4);
  EXPECT_NO_THROW(CGAL::Parametric_surface_mesher::validate(model));
  Mesh mesh;
  CGAL::make_parametric_surface_mesh(model, fifth, mesh);
  for(const auto v : mesh.vertices())
    EXPECT_TRUE(mesh.point(v).x() != 1 || mesh.point(v).z() == 0);
}

TEST(Edges_with_curves, uses_without_a_curve)
{
  expect_model_refused(two_squares(1e-4), "face 2", "edge 2", "away from", "face 1");
}

// A tolerance chosen by the message must do.
TEST(Edges_with_curves, largest_distance_is_named)
{
  const double gap = 1. / 8192;
  expect_model_refused(two_squares(gap, true), "face 1", "edge 2", "0.00012207");
  expect_model_refused(two_squares(gap), "face 2", "edge 2", "0.00012207");
}

TEST(Validation, open_by_vertex)
{
  Model model = two_squares(0);
  first_loop(model, 0)[1].edge = 5;
  expect_model_refused(model, "face 1", "loop 1", "open", "vertex");
}

TEST(Validation, open_in_the_domain)
{
  Model model = two_squares(0);
  first_loop(model, 0)[1].curve = Curve::segment(Point_2(1, 0.125), Point_2(1, 1));
  expect_model_refused(model, "face 1", "loop 1", "open in the domain", "(1, 0.125)");
}

TEST(Validation, wrong_number_of_an_edge)
{
  Model model = two_squares(0);
  first_loop(model, 1)[2].edge = 77;
  expect_model_refused(model, "face 2", "loop 1", "no edge with index 77");
}

TEST(Validation, different_ranges_of_parameters)
{
  Model model = two_squares(0);
  first_loop(model, 1)[3].curve
    = Curve([](double t) { return Curve::Jet{Point_2(0, t / 2), Vector_2(0, 0.5), Vector_2(0, 0)}; }, 0, 2);
  expect_model_refused(model, "face 2", "edge 2", "0 to 2", "0 to 1");
}

TEST(Validation, different_speeds_of_parameters)
{
  Model model = two_squares(0);
  first_loop(model, 1)[3].curve
    = Curve([](double t) { return Curve::Jet{Point_2(0, t * t), Vector_2(0, 2 * t), Vector_2(0, 2)}; }, 0, 1);
  expect_model_refused(model, "face 2", "edge 2", "away from", "face 1");
}

TEST(Validation, vertex_that_is_elsewhere)
{
  Model model;
  model.add_vertex(Point_3(0, 0, 0.01));
  model.add_edge(0, 0);
  model.add_face({flat(), {{{0, false, Curve::circle(Point_2(0, 1), 1)}}}});
  expect_model_refused(model, "face 1", "edge 1", "vertex 1");
}

TEST(Validation, collapsed_edge_that_is_none)
{
  Model model;
  model.add_vertex(Point_3(1, 0, 0));
  model.add_edge(0, 0, true);
  model.add_face({flat(), {{{0, false, Curve::circle(Point_2(0, 0), 1)}}}});
  expect_model_refused(model, "face 1", "edge 1", "vertex 1", "2");
}

TEST(Validation, faces_that_face_to_different_sides)
{
  Model model = two_squares(0);
  model.faces()[1].is_reversed = true;
  expect_model_refused(model, "faces 1 and 2", "edge 2");
  CGAL::Parametric_surface_mesher::orient_faces(model);
  EXPECT_FALSE(model.faces()[1].is_reversed);
  check_two_squares(model);
}

TEST(Validation, missing_loops_and_edges)
{
  Model without_loop = two_squares(0), without_edge = two_squares(0);
  without_loop.faces()[1].loops.clear();
  expect_model_refused(without_loop, "face 2", "no loop");
  without_edge.faces()[1].loops.emplace_back();
  expect_model_refused(without_edge, "face 2", "loop 2", "no edge");
}

TEST(Validation, empty_model) { expect_model_refused(Model(), ""); }

TEST(Validation, nan_in_a_surface)
{
  Model model = two_squares(0);
  model.faces()[1].surface
    = function_surface([](auto u, auto v) { return CGAL::parametric_surface_point(1 + u, v, 0 * u / (v - v)); });
  expect_model_refused(model, "face 2");
}

TEST(Validation, crossing_loops_name_the_face)
{
  Model model = two_squares(0);
  const std::size_t v = 1, w = 2; // an edge of the second face that leaves it
  model.faces()[1].loops[0][3].curve = Curve::segment(Point_2(0, 0), Point_2(0, 1));
  const std::size_t e = model.add_edge(v, w), f = model.add_edge(v, w);
  const auto bow = [](double size) {
    return Curve(
      [size](double t) {
        return Curve::Jet{Point_2(size * std::sin(2 * pi * t), t), Vector_2(2 * pi * size * std::cos(2 * pi * t), 1),
                          Vector_2(-4 * pi * pi * size * std::sin(2 * pi * t), 0)};
      },
      0, 1);
  };
  model.faces()[1].loops = {{{e, false, bow(0.1)}, {f, true, bow(-0.1)}}};
  expect_model_refused(model, "face 2", "cross", "loop 1");
}

TEST(Orientation, cubes_of_all_directions)
{
  for(int pattern = 0; pattern < 64; pattern += 5) {
    SCOPED_TRACE(pattern);
    Quad_model quads;
    int i = 0;
    for(const Quad& q : sides_of_cube(3, 4, 5))
      quads.add(pattern >> i++ & 1 ? Quad{q[3], q[2], q[1], q[0]} : q);
    Model model = quads.model();
    EXPECT_EQ(pattern == 0, [&] {
      try {
        CGAL::Parametric_surface_mesher::validate(model);
        return true;
      } catch(const CGAL::Parametric_surface_mesh_error&) {
        return false;
      }
    }());
    CGAL::Parametric_surface_mesher::orient_faces(model);
    const Meshed m = mesh_and_check(model, fifth);
    expect_topology(m, 1, 0, 2);
    EXPECT_NEAR(1, m.volume(), 1e-9);
  }
}

TEST(Orientation, two_cubes_inside_out)
{
  Quad_model quads;
  for(double x : {0., 7.})
    for(const Quad& q : sides_of_cube(x, 0, 0))
      quads.add({q[3], q[2], q[1], q[0]});
  Model model = quads.model();
  CGAL::Parametric_surface_mesher::orient_faces(model);
  const Meshed m = mesh_and_check(model, fifth);
  expect_topology(m, 2, 0, 4);
  EXPECT_NEAR(2, m.volume(), 1e-9);
}

TEST(Orientation, rings_that_turn_over)
{
  Model annulus = twisted_ring(6, 0), twice = twisted_ring(8, 2);
  for(Model* model : {&annulus, &twice}) {
    CGAL::Parametric_surface_mesher::orient_faces(*model);
    const Meshed m = mesh_and_check(*model, Criteria().set_max_edge(0.4));
    expect_topology(m, 1, 2, 0);
  }
  Model moebius = twisted_ring(7, 1);
  expect_refused([&] { CGAL::Parametric_surface_mesher::orient_faces(moebius); }, "not orientable", "edge");
  expect_model_refused(moebius, "face to different sides");
}

TEST(Orientation, face_that_meets_itself)
{
  expect_topology(mesh_and_check(strip_of_one_face(0), Criteria().set_max_edge(0.4)), 1, 2, 0);
  expect_topology(mesh_and_check(strip_of_one_face(2), Criteria().set_max_edge(0.4)), 1, 2, 0);
}

TEST(Orientation, moebius_strip_of_one_face)
{
  Model model = strip_of_one_face(1);
  expect_model_refused(model, "faces 1 and 1", "edge 2");
  expect_refused([&] { CGAL::Parametric_surface_mesher::orient_faces(model); }, "not orientable", "edge 2");
}

TEST(Solids, box_from_the_samples)
{
  const Meshed m = mesh_and_check(make_sample_model("box").model, fifth);
  expect_topology(m, 1, 0, 2);
  expect_distinct_points(m.mesh);
  EXPECT_NEAR(1.125, m.volume(), 1e-9);
  EXPECT_EQ(0u, m.report.unmet.size());
}

TEST(Solids, coarsest_box)
{
  Quad_model quads;
  const Meshed m = mesh_and_check(add_cube(quads, 0, 0, 0, 0).model(), Criteria().set_max_edge(10));
  expect_topology(m, 1, 0, 2);
  EXPECT_NEAR(1, m.volume(), 1e-9);
  EXPECT_EQ(12u, m.triangles.size());
}

TEST(Solids, tetrahedron_of_collapsed_patches)
{
  for(double max_edge : {2., 0.3, 0.05}) {
    SCOPED_TRACE(max_edge);
    const Meshed m = mesh_and_check(model_of_patches(tetrahedron()), Criteria().set_max_edge(max_edge));
    expect_topology(m, 1, 0, 2);
    expect_distinct_points(m.mesh);
    EXPECT_NEAR(1. / 6, m.volume(), 1e-9);
    EXPECT_LE(m.report.unmet.size(), m.triangles.size() / 20 + 12);
  }
}

TEST(Solids, vertex_limit_for_the_whole_model)
{
  Quad_model quads;
  const Model model = add_cube(quads, 0, 0, 0, 0).model();
  for(std::size_t limit : {300u, 1000u, 2000u}) {
    SCOPED_TRACE(limit);
    Mesh mesh;
    const Report report
      = CGAL::make_parametric_surface_mesh(model, Criteria().set_max_edge(0.03).set_max_number_of_vertices(limit), mesh);
    EXPECT_TRUE(mesh.is_valid());
    EXPECT_TRUE(CGAL::is_closed(mesh));
    EXPECT_LE(mesh.number_of_vertices(), (std::max)(limit, report.number_of_boundary_edges));
    EXPECT_GT(report.count(CGAL::Parametric_surface_mesher::Unmet_cause::VERTEX_LIMIT), 0u);
  }
}

TEST(Solids, the_same_again)
{
  const Meshed a = mesh_and_check(two_cubes(1, 1, 0), fifth), b = mesh_and_check(two_cubes(1, 1, 0), fifth);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.patch_ids, b.patch_ids);
  for(const auto v : a.mesh.vertices())
    EXPECT_EQ(a.mesh.point(v), b.mesh.point(v));
}
