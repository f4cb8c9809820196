// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edges and points inside faces, which the mesh follows.
#include "Wave_model.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace psm = CGAL::Parametric_surface_mesher;
typedef CGAL::Parametric_surface_mesh_criteria Criteria;

const std::vector<Point_2> unit_square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

struct Placed_mesh
{
  CGAL::Surface_mesh<Point_3> mesh;
  CGAL::Surface_mesh<Point_3>::Property_map<CGAL::SM_Vertex_index, psm::Vertex_place> vertex_places
    = mesh.add_property_map<CGAL::SM_Vertex_index, psm::Vertex_place>("v:place").first;
  CGAL::Surface_mesh<Point_3>::Property_map<CGAL::SM_Edge_index, psm::Edge_place> edge_places
    = mesh.add_property_map<CGAL::SM_Edge_index, psm::Edge_place>("e:place").first;
  CGAL::Surface_mesh<Point_3>::Property_map<CGAL::SM_Halfedge_index, Point_2> uv
    = mesh.add_property_map<CGAL::SM_Halfedge_index, Point_2>("h:uv").first;
  CGAL::Surface_mesh<Point_3>::Property_map<CGAL::SM_Face_index, std::size_t> patches
    = mesh.add_property_map<CGAL::SM_Face_index, std::size_t>("f:patch").first;
  CGAL::Parametric_surface_mesh_report report;

  Placed_mesh(const Model& model, const Criteria& criteria)
  {
    namespace params = CGAL::parameters;
    report = CGAL::make_parametric_surface_mesh(
      model, criteria, mesh,
      params::vertex_place_map(vertex_places,
                               params::edge_place_map(edge_places, params::halfedge_uv_map(uv, params::face_patch_id_map(patches)))));
  }
};

// Each edge is covered once by edges of the mesh, which have its points as ends: in all faces, with the mesh on both sides of it.
void expect_followed(const Model& model, const Placed_mesh& placed, const std::set<std::size_t>& edges)
{
  std::map<std::size_t, double> covered;
  for(const auto e : placed.mesh.edges()) {
    const psm::Edge_place& place = placed.edge_places[e];
    if(edges.count(place.index) == 0)
      continue;
    EXPECT_FALSE(placed.mesh.is_border(e));
    covered[place.index] += std::fabs(place.parameters[1] - place.parameters[0]);
    const auto h = placed.mesh.halfedge(e);
    for(const auto& face : model.faces())
      for(const auto& loop : face.loops)
        for(const auto& use : loop)
          if(use.edge == place.index)
            for(int end : {0, 1}) {
              const auto uv = use.curve.point(place.parameters[std::size_t(end)]);
              EXPECT_LT(CGAL::squared_distance(placed.mesh.point(end == 0 ? placed.mesh.source(h) : placed.mesh.target(h)),
                                               face.surface.point(uv.x(), uv.y())), 1e-20);
            }
  }
  for(std::size_t e : edges) {
    double length = 1;
    for(const auto& face : model.faces())
      for(const auto& loop : face.loops)
        for(const auto& use : loop)
          if(use.edge == e)
            length = use.curve.end() - use.curve.begin();
    EXPECT_NEAR(covered[e], length, 1e-9) << "edge " << e;
  }
}

// Triangles of a face are positively oriented in the domain, and have its area together. The mesh is one piece.
void expect_whole(const Placed_mesh& placed, double area)
{
  EXPECT_TRUE(placed.mesh.is_valid(false));
  for(const auto v : placed.mesh.vertices())
    ASSERT_FALSE(placed.mesh.is_isolated(v)) << placed.mesh.point(v);
  double sum = 0;
  for(const auto f : placed.mesh.faces()) {
    const auto h = placed.mesh.halfedge(f);
    const Point_2 p = placed.uv[h], q = placed.uv[placed.mesh.next(h)], r = placed.uv[placed.mesh.next(placed.mesh.next(h))];
    EXPECT_EQ(CGAL::orientation(p, q, r), CGAL::LEFT_TURN);
    sum += CGAL::area(p, q, r);
  }
  EXPECT_NEAR(sum, area, 1e-9);
}

std::size_t number_at(const Placed_mesh& placed, const Point_3& p)
{
  std::size_t result = 0;
  for(const auto v : placed.mesh.vertices())
    result += placed.mesh.point(v) == p;
  return result;
}

const Criteria fine_criteria = Criteria().set_max_edge(0.08);

TEST(Inner_edges, may_dangle_touch_close_and_end_on_the_boundary)
{
  for(const Criteria& criteria : {fine_criteria, Criteria(fine_criteria).set_placement(psm::Mesh_point_placement::CIRCUMCENTER),
                                  Criteria(fine_criteria).set_closeness(1.), Criteria(fine_criteria).set_distance(1e-4),
                                  Criteria(fine_criteria).set_detail(0.02)}) {
    Wave_model wave;
    wave.add_face({{0, 0}, {0.37, 0}, {1, 0}, {1, 1}, {0, 1}});
    std::set<std::size_t> edges;
    edges.insert(wave.add_inner_segment(0, {0.37, 0}, {0.4, 0.3}));   // from the boundary
    edges.insert(wave.add_inner_segment(0, {0.4, 0.3}, {0.1, 0.35})); // goes on, and dangles
    edges.insert(wave.add_inner_segment(0, {0.4, 0.3}, {0.6, 0.25})); // a branch
    edges.insert(wave.add_inner_segment(0, {0.8, 0.1}, {0.81, 0.16})); // alone
    edges.insert(wave.add_inner_circle(0, {0.6, 0.65}, 0.2));
    edges.insert(wave.add_inner_segment(0, {0.8, 0.65}, {1, 1})); // from the circle to a corner
    wave.add_inner_point(0, {0.6, 0.65});
    wave.add_inner_point(0, {0.13, 0.77});
    const Placed_mesh placed(wave.model, criteria);
    expect_followed(wave.model, placed, edges);
    expect_whole(placed, 1);
    EXPECT_EQ(number_at(placed, wave.surface.point(0.6, 0.65)), 1u);
    EXPECT_EQ(number_at(placed, wave.surface.point(0.13, 0.77)), 1u);
    for(const auto v : placed.mesh.vertices())
      if(placed.vertex_places[v].dimension == 0) {
        EXPECT_EQ(placed.mesh.point(v), wave.model.vertices()[placed.vertex_places[v].index]);
      }
    EXPECT_GT(placed.report.smallest_angle, 20);
  }
}

TEST(Inner_edges, may_cross_in_common_vertices_and_cut_the_face)
{
  Wave_model wave;
  wave.add_face({{0, 0}, {1, 0}, {1, 0.5}, {1, 1}, {0, 1}, {0, 0.5}});
  std::set<std::size_t> edges;
  edges.insert(wave.add_inner_segment(0, {0, 0.5}, {0.5, 0.5}));
  edges.insert(wave.add_inner_segment(0, {0.5, 0.5}, {1, 0.5}));
  edges.insert(wave.add_inner_segment(0, {0.5, 0.2}, {0.5, 0.5}));
  edges.insert(wave.add_inner_segment(0, {0.5, 0.8}, {0.5, 0.5}));
  const Placed_mesh placed(wave.model, fine_criteria);
  expect_followed(wave.model, placed, edges);
  expect_whole(placed, 1);
  EXPECT_EQ(number_at(placed, wave.surface.point(0.5, 0.5)), 1u);
}

TEST(Inner_edges, run_on_in_the_next_face)
{
  Wave_model wave;
  wave.add_face({{0, 0}, {1, 0}, {1, 0.4}, {1, 1}, {0, 1}});
  wave.add_face({{1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0.4}});
  std::set<std::size_t> edges;
  edges.insert(wave.add_inner_segment(0, {0.3, 0.3}, {1, 0.4}));
  edges.insert(wave.add_inner_segment(1, {1, 0.4}, {1.6, 0.7}));
  const Placed_mesh placed(wave.model, fine_criteria);
  expect_followed(wave.model, placed, edges);
  expect_whole(placed, 2);
}

// A rib on a plate, whose lower edge lies inside that, in a shell of its own and in that of the plate, which stays in one piece.
class Inner_edges_of_shells : public testing::TestWithParam<std::size_t> {};

TEST_P(Inner_edges_of_shells, are_edges_of_other_faces)
{
  Wave_model wave;
  wave.add_face(unit_square);
  const std::size_t edge = wave.add_inner_segment(0, {0.2, 0.3}, {0.8, 0.6});
  const Surface rib = CGAL::make_parametric_function_surface([](auto t, auto z) {
    using std::sin;
    const auto u = 0.2 + 0.6 * t, v = 0.3 + 0.3 * t;
    return CGAL::parametric_surface_point(u, v, z + 0.2 * sin(3 * u) * sin(2 * v));
  });
  const std::size_t a = wave.vertex(0.2, 0.3), b = wave.vertex(0.8, 0.6), c = wave.model.add_vertex(rib.point(1, 0.4)),
                    d = wave.model.add_vertex(rib.point(0, 0.4));
  Model::Face face{rib, {{{edge, false, Curve::segment({0, 0}, {1, 0})},
                          {wave.model.add_edge(b, c), false, Curve::segment({1, 0}, {1, 0.4})},
                          {wave.model.add_edge(c, d), false, Curve::segment({1, 0.4}, {0, 0.4})},
                          {wave.model.add_edge(d, a), false, Curve::segment({0, 0.4}, {0, 0})}}}};
  face.shell = GetParam();
  wave.model.add_face(face);
  const Placed_mesh placed(wave.model, fine_criteria);
  std::map<Point_3, std::set<std::size_t>> patches_at;
  for(const auto h : placed.mesh.halfedges())
    if(!placed.mesh.is_border(h))
      patches_at[placed.mesh.point(placed.mesh.target(h))].insert(placed.patches[placed.mesh.face(h)]);
  std::array<double, 2> covered = {0, 0}; // by the plate, and the rib
  for(const auto e : placed.mesh.edges())
    if(placed.edge_places[e].index == edge) {
      covered[placed.mesh.is_border(e)] += std::fabs(placed.edge_places[e].parameters[1] - placed.edge_places[e].parameters[0]);
      EXPECT_EQ(patches_at[placed.mesh.point(placed.mesh.vertex(e, 0))].size(), 2u);
    }
  EXPECT_NEAR(covered[0], 1, 1e-9);
  EXPECT_NEAR(covered[1], 1, 1e-9);
  EXPECT_TRUE(placed.mesh.is_valid(false));
}

INSTANTIATE_TEST_SUITE_P(Shells, Inner_edges_of_shells, testing::Values(0, 1));

// Where the face is narrower than the pieces of its boundary, points of these are moved.
TEST(Inner_edges, lie_in_narrow_faces)
{
  Wave_model wave;
  wave.add_face({{0, 0}, {1, 0}, {1, 0.03}, {0.4, 0.03}, {0, 0.03}});
  const std::size_t edge = wave.add_inner_segment(0, {0.5, 0.015}, {0.7, 0.02});
  for(double u : {0.1, 0.15, 0.2, 0.25, 0.3, 0.33, 0.81, 0.88, 0.95})
    wave.add_inner_point(0, {u, 0.015});
  const Placed_mesh placed(wave.model, Criteria(fine_criteria).set_closeness(1.2).set_min_edge(0.022));
  expect_followed(wave.model, placed, {edge});
  expect_whole(placed, 0.03);
  EXPECT_EQ(number_at(placed, wave.surface.point(0.2, 0.015)), 1u);
}

TEST(Inner_edges, have_their_sizes)
{
  Wave_model wave;
  wave.add_face(unit_square);
  const std::size_t edge = wave.add_inner_segment(0, {0.2, 0.5}, {0.5, 0.6});
  wave.model.edges()[edge].max_edge = 0.01;
  wave.add_inner_point(0, {0.8, 0.3}, 0.005);
  const Placed_mesh placed(wave.model, fine_criteria);
  expect_followed(wave.model, placed, {edge});
  expect_whole(placed, 1);
  for(const auto e : placed.mesh.edges()) {
    const double length = std::sqrt(CGAL::squared_distance(placed.mesh.point(placed.mesh.vertex(e, 0)),
                                                           placed.mesh.point(placed.mesh.vertex(e, 1))));
    if(placed.edge_places[e].index == edge) {
      EXPECT_LT(length, 0.0101);
    }
    for(unsigned int end : {0, 1})
      if(placed.mesh.point(placed.mesh.vertex(e, end)) == wave.surface.point(0.8, 0.3)) {
        EXPECT_LT(length, 0.012);
      }
  }
  EXPECT_EQ(number_at(placed, wave.surface.point(0.8, 0.3)), 1u);
}

TEST(Inner_edges, form_any_network)
{
  for(unsigned int seed = 1; seed <= 60 && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Random_network network(seed);
    const Criteria criteria = seed % 3 == 0   ? fine_criteria
                              : seed % 3 == 1 ? Criteria(fine_criteria).set_closeness(1.5).set_min_edge(0.01)
                                              : Criteria(fine_criteria).set_distance(1e-3).set_detail(0.01);
    const Placed_mesh placed(network.wave.model, criteria);
    expect_followed(network.wave.model, placed, network.edges);
    expect_whole(placed, 1);
    for(const auto& point : network.wave.model.faces()[0].inner_points)
      EXPECT_EQ(number_at(placed, network.wave.model.vertices()[point.vertex]), 1u);
  }
}

// A sphere, in the coordinates of a chart: from a pole, and across its longitudes.
TEST(Inner_edges, lie_beside_poles)
{
  const Surface sphere = CGAL::make_parametric_function_surface([](auto u, auto v) {
    using std::cos;
    using std::sin;
    return CGAL::parametric_surface_point(cos(u) * cos(v), sin(u) * cos(v), sin(v));
  });
  Model model;
  const auto vertex = [&](double u, double v) { return model.add_vertex(sphere.point(u, v)); };
  const double a = CGAL_PI / 2;
  const std::size_t pole = vertex(0, a), start = vertex(0, 0), middle = vertex(1, 0.9);
  const std::size_t equator = model.add_edge(start, start), seam = model.add_edge(start, pole),
                    side = model.add_edge(pole, pole, true), other_side = model.add_edge(pole, pole, true);
  const double turn = 2 * CGAL_PI;
  model.add_face({sphere, {{{equator, false, Curve::segment({0, 0}, {turn, 0})},
                            {seam, false, Curve::segment({turn, 0}, {turn, a})},
                            {side, false, Curve::segment({turn, a}, {1, a})},
                            {other_side, false, Curve::segment({1, a}, {0, a})},
                            {seam, true, Curve::segment({0, 0}, {0, a})}}}});
  std::set<std::size_t> edges = {model.add_edge(pole, middle), model.add_edge(middle, vertex(4, 0.5))};
  model.add_inner_edge(0, *edges.begin(), Curve::segment({1, a}, {1, 0.9}));
  model.add_inner_edge(0, *edges.rbegin(), Curve::segment({1, 0.9}, {4, 0.5}));
  model.add_inner_point(0, vertex(5, 1.2), {5, 1.2});
  for(const Criteria& criteria : {fine_criteria, Criteria(fine_criteria).set_closeness(1.)}) {
    const Placed_mesh placed(model, criteria);
    EXPECT_TRUE(placed.mesh.is_valid(false));
    expect_followed(model, placed, edges);
    EXPECT_EQ(number_at(placed, sphere.point(5, 1.2)), 1u);
    EXPECT_GT(placed.report.smallest_angle, 15);
  }
}

std::string error_of(const Model& model)
{
  try {
    CGAL::Surface_mesh<Point_3> mesh;
    CGAL::make_parametric_surface_mesh(model, fine_criteria, mesh);
    return "";
  }
  catch(const CGAL::Parametric_surface_mesh_error& error) {
    return error.what();
  }
}

template <class Add>
std::string error_with(const Add& add)
{
  Wave_model wave;
  wave.add_face({{0, 0}, {1, 0}, {1, 0.5}, {1, 1}, {0, 1}, {0, 0.5}});
  add(wave);
  return error_of(wave.model);
}

TEST(Inner_edges, are_refused_where_they_are_wrong)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_with([](Wave_model&) {}), "");
  const auto expect_error = [](const std::string& error, const std::string& part) {
    EXPECT_NE(error.find(part), std::string::npos) << error;
  };
  expect_error(error_with([](Wave_model& w) { w.add_inner_segment(0, {1.2, 0.1}, {1.4, 0.2}); }), "not inside the face");
  expect_error(error_with([](Wave_model& w) { w.add_inner_segment(0, {1, 0.5}, {1.4, 0.2}); }), "not inside the face");
  expect_error(error_with([](Wave_model& w) { w.add_inner_segment(0, {0.8, 0.5}, {1.4, 0.2}); }), "crosses or touches");
  expect_error(error_with([](Wave_model& w) { w.add_inner_segment(0, {0.8, 0.5}, {1, 0.7}); }), "crosses or touches");
  expect_error(error_with([](Wave_model& w) { w.add_inner_segment(0, {1, 0.5}, {1, 0.7}); }), "crosses or touches");
  expect_error(error_with([](Wave_model& w) {
    w.add_inner_segment(0, {0.2, 0.2}, {0.8, 0.8});
    w.add_inner_segment(0, {0.2, 0.8}, {0.8, 0.2});
  }), "crosses or touches");
  expect_error(error_with([](Wave_model& w) {
    w.add_inner_segment(0, {0.2, 0.2}, {0.8, 0.8});
    w.add_inner_segment(0, {0.8, 0.8}, {0.2, 0.2});
  }), "crosses or touches");
  expect_error(error_with([](Wave_model& w) { w.add_inner_point(0, {1.2, 0.5}); }), "an inner point is not inside the face");
  expect_error(error_with([](Wave_model& w) { w.add_inner_point(0, {1, 0.7}); }), "an inner point");
  expect_error(error_with([](Wave_model& w) { w.add_inner_point(0, {1, 0.5}); }), "an inner point is not inside the face");
  expect_error(error_with([](Wave_model& w) {
    w.add_inner_segment(0, {0.25, 0.25}, {0.75, 0.75});
    w.add_inner_point(0, {0.5, 0.5});
  }), "an inner point");
  expect_error(error_with([=](Wave_model& w) { w.model.add_inner_point(0, w.vertex(0.5, 0.5), {0.5, nan}); }), "not finite");
  expect_error(error_with([](Wave_model& w) { w.model.add_inner_point(0, w.vertex(0.5, 0.5), {0.5, 0.6}); }), "away from vertex");
  expect_error(error_with([](Wave_model& w) { w.model.add_inner_point(0, 99, {0.5, 0.6}); }), "none with index 99");
  expect_error(error_with([](Wave_model& w) { w.add_inner_point(0, {0.5, 0.6}, -1); }), "wanted edge length");
  expect_error(error_with([](Wave_model& w) { w.model.add_inner_edge(0, 99, Curve::segment({0.1, 0.1}, {0.2, 0.2})); }),
               "no edge with index 99");
  expect_error(error_with([](Wave_model& w) {
    w.model.add_inner_edge(0, w.add_edge({0.1, 0.1}, {0.2, 0.2}), Curve::segment({0.1, 0.1}, {0.2, 0.3}));
  }), "away from vertex");
  Wave_model wave;
  EXPECT_THROW(wave.model.add_inner_point(0, wave.vertex(0, 0), {0, 0}), CGAL::Parametric_surface_mesh_error);
  EXPECT_THROW(wave.model.add_inner_edge(0, 0, Curve::segment({0, 0}, {1, 0})), CGAL::Parametric_surface_mesh_error);
}

} // namespace
