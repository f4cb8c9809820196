// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Input that cannot be meshed: an exception that names the place, and an output mesh that is as it was.
// This file is compiled with NDEBUG too.
#include <CGAL/Parametric_function_surface_3.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Principal_curvature_metric_2.h>
#include <CGAL/Space_curve_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/Parametric_surface_mesher/orient_faces.h>
#include <gtest/gtest.h>

#include <Sample_surfaces.h>
#include <mesher_test_helpers.h>

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

const double infinity = std::numeric_limits<double>::infinity(), not_a_number = std::numeric_limits<double>::quiet_NaN();

// the plane, with the point and the first derivative of a place replaced
struct Spoiled_plane
{
  std::function<bool(double, double)> is_spoiled;
  double z, derivative;

  Point_3 point(double u, double v) const { return Point_3(u, v, is_spoiled(u, v) ? z : 0); }

  CGAL::Surface_jet_3<Test_kernel> jet(double u, double v) const
  {
    const Vector_3 zero(0, 0, 0);
    return {point(u, v), Vector_3(1, 0, is_spoiled(u, v) ? derivative : 0), Vector_3(0, 1, 0), zero, zero, zero};
  }
};

// `(x(u,v), y(u,v), 0)` for linear x and y
struct Linear_surface
{
  double xu, xv, yu, yv;

  Point_3 point(double u, double v) const { return Point_3(xu * u + xv * v, yu * u + yv * v, 0); }

  CGAL::Surface_jet_3<Test_kernel> jet(double u, double v) const
  {
    const Vector_3 zero(0, 0, 0);
    return {point(u, v), Vector_3(xu, yu, 0), Vector_3(xv, yv, 0), zero, zero, zero};
  }
};

// a surface over the unit square with four peaks, and a change of its jet
struct Peaks
{
  std::function<void(CGAL::Surface_jet_3<Test_kernel>&)> change;

  CGAL::Surface_jet_3<Test_kernel> jet(double u, double v) const
  {
    const auto peaks = CGAL::make_parametric_function_surface([](auto x, auto y) {
      using std::exp;
      auto z = 0. * x;
      for(double a : {0.3, 0.7})
        for(double b : {0.3, 0.7})
          z = z + 0.2 * exp(-20 * ((x - a) * (x - a) + (y - b) * (y - b)));
      return CGAL::parametric_surface_point(x, y, z);
    });
    CGAL::Surface_jet_3<Test_kernel> result = peaks.jet(u, v);
    if(change)
      change(result);
    return result;
  }

  Point_3 point(double u, double v) const { return Peaks{nullptr}.jet(u, v).point; }
};

const Sample_surface flat((sample_surfaces::Flat()));

Criteria small_edges() { return Criteria().set_max_edge(0.1).set_min_edge(0.001); }

Domain square() { return Domain::rectangle(0, 1, 0, 1); }

Domain square_with_holes(const std::vector<Domain::Loop>& holes)
{
  Domain domain = square();
  for(const Domain::Loop& hole : holes)
    domain.add_hole(hole);
  return domain;
}

Domain::Loop small_square(double u, double v, double size)
{
  return Domain::polygon({Point_2(u, v), Point_2(u + size, v), Point_2(u + size, v + size), Point_2(u, v + size)});
}

// Expects that a patch is refused with all `words` in the message, and that a mesh that holds a triangle is left alone.
template <class... Words>
void check_refused(const Sample_surface& surface, const Domain& domain, const Criteria& criteria, const Words&... words)
{
  Mesh mesh;
  const Uv_map uv = uv_map(mesh);
  const Point_3 p(1, 2, 3);
  CGAL::make_triangle(p, Point_3(4, 5, 6), Point_3(7, 8, 10), mesh);
  expect_refused([&] { add_patch(surface, domain, criteria, mesh); }, words...);
  EXPECT_EQ(3u, mesh.number_of_vertices());
  EXPECT_EQ(3u, mesh.number_of_edges());
  EXPECT_EQ(1u, mesh.number_of_faces());
  EXPECT_EQ(p, mesh.point(*mesh.vertices_begin()));
  EXPECT_EQ(Point_2(0, 0), uv[*mesh.vertices_begin()]);
}

template <class... Words>
void check_refused(const Domain& domain, const Words&... words)
{
  check_refused(flat, domain, small_edges(), words...);
}

Sample_surface spoiled(const std::function<bool(double, double)>& is_spoiled, double z, double derivative)
{
  return Sample_surface(Spoiled_plane{is_spoiled, z, derivative});
}

bool is_on_the_right(double u, double) { return u > 0.95; }

bool is_inside(double u, double v) { return std::hypot(u - 0.5, v - 0.5) < 0.3; }

std::string word(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

// Expects that a setter refuses each of some values, tells the value and the range, and sets nothing.
template <class Set>
void check_option(Set set, const std::string& name, const std::string& range, const std::vector<double>& values)
{
  for(double value : values) {
    Criteria criteria = small_edges();
    expect_refused([&] { (criteria.*set)(value); },
                   "the " + name + " must be " + range + ", and is " + word(value));
    EXPECT_EQ(small_edges().angle(), criteria.angle());
    EXPECT_EQ(small_edges().gamma(), criteria.gamma());
    EXPECT_EQ(small_edges().max_edge(), criteria.max_edge());
    EXPECT_FALSE(criteria.distance());
  }
}

typedef CGAL::Parametric_plane_3<Test_kernel> Plane;
typedef CGAL::Parametric_surface_model_3<Plane> Plane_model;

// two triangles on the unit square, with an edge in common
Plane_model two_triangles()
{
  Plane_model model;
  const std::vector<Point_2> corners = {Point_2(0, 0), Point_2(1, 0), Point_2(1, 1), Point_2(0, 1)};
  for(const Point_2& p : corners)
    model.add_vertex(Point_3(p.x(), p.y(), 0));
  std::vector<Plane_model::Edge_use> uses;
  for(const auto& [from, to] : std::vector<std::pair<int, int>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}})
    uses.push_back({model.add_edge(from, to), false, Curve::segment(corners[from], corners[to])});
  Plane_model::Edge_use back = uses[4];
  back.is_reversed = true;
  model.add_face({Plane(), {{uses[0], uses[1], back}}});
  model.add_face({Plane(), {{uses[2], uses[3], uses[4]}}});
  return model;
}

// Expects that a model is refused by `validate()` and by the mesher once `spoil` has changed it.
template <class Spoil, class... Words>
void check_model_refused(Spoil spoil, const Words&... words)
{
  Plane_model model = two_triangles();
  spoil(model);
  expect_refused([&] { CGAL::Parametric_surface_mesher::validate(model); }, words...);
  Mesh mesh;
  expect_refused([&] { CGAL::make_parametric_surface_mesh(model, small_edges(), mesh); }, words...);
  EXPECT_EQ(0u, mesh.number_of_vertices());
}

} // namespace

TEST(Bad_input, a_good_patch_is_added_to_the_mesh)
{
  Mesh mesh;
  CGAL::make_triangle(Point_3(1, 2, 3), Point_3(4, 5, 6), Point_3(7, 8, 10), mesh);
  EXPECT_GT(add_patch(flat, square(), small_edges(), mesh).number_of_faces, 100u);
}

TEST(Bad_input, values_on_the_boundary)
{
  for(double value : {not_a_number, infinity, -infinity})
    check_refused(spoiled(is_on_the_right, value, 0), square(), small_edges(), "not finite", "(u,v) = (");
}

TEST(Bad_input, values_inside)
{
  for(double value : {not_a_number, infinity, -infinity})
    check_refused(spoiled(is_inside, value, 0), square(), small_edges(), "not finite", "(u,v) = (0.");
}

TEST(Bad_input, values_inside_that_only_the_criteria_ask_for)
{
  // so small a spot that no vertex need lie in it
  const auto spot = [](double u, double v) { return std::hypot(u - 0.5, v - 0.5) < 1e-9; };
  const Domain triangle({Point_2(0, 0), Point_2(1, 0), Point_2(1, 1), Point_2(0, 1)});
  const Criteria coarse = Criteria().set_max_edge(2).set_min_edge(0.001);
  check_refused(spoiled(spot, not_a_number, 0), triangle, coarse, "not finite", "(u,v) = (0.5, 0.5)");
}

TEST(Bad_input, derivatives)
{
  for(double value : {not_a_number, infinity}) {
    check_refused(spoiled(is_on_the_right, 0, value), square(), small_edges(), "not finite", "(u,v) = (");
    check_refused(spoiled(is_inside, 0, value), square(), small_edges(), "not finite", "(u,v) = (0.");
  }
}

TEST(Bad_input, domain_that_is_not_finite)
{
  for(double value : {not_a_number, infinity})
    check_refused(Domain({Point_2(0, 0), Point_2(value, 0), Point_2(1, 1)}), "loop 1");
}

TEST(Bad_input, open_loop)
{
  check_refused(Domain(Domain::Loop{Curve::segment(Point_2(0, 0), Point_2(1, 0)),
                                    Curve::segment(Point_2(1, 0), Point_2(0.75, 1)),
                                    Curve::segment(Point_2(0.5, 1), Point_2(0, 0))}),
                "loop 1", "open", "curve 2", "(0.75, 1)", "(0.5, 1)");
  check_refused(square_with_holes({small_square(0.1, 0.1, 0.2), {Curve::arc(Point_2(0.7, 0.7), 0.1, 0, 3)}}), "loop 3", "open",
                "curve 1");
}

TEST(Bad_input, empty_loop)
{
  check_refused(Domain(Domain::Loop()), "loop 1", "no curve");
  check_refused(square_with_holes({{}}), "loop 2", "no curve");
}

TEST(Bad_input, loops_of_two_points)
{
  Domain::Loop loop = Domain::polygon({Point_2(0, 0), Point_2(1, 0)});
  check_refused(Domain(loop), "loop 1");
  for(Curve& curve : loop)
    curve.set_number_of_edges(1);
  check_refused(Domain(loop), "loop 1", "2 edges", "3");
}

TEST(Bad_input, curve_of_length_zero)
{
  check_refused(Domain({Point_2(0, 0), Point_2(1, 0), Point_2(1, 0), Point_2(1, 1)}), "loop 1", "length zero", "(1, 0)");
}

TEST(Bad_input, crossing_segments_are_both_named)
{
  Domain::Loop bow_tie = Domain::polygon({Point_2(0, 0), Point_2(1, 1), Point_2(1, 0), Point_2(0, 1)});
  for(Curve& curve : bow_tie)
    curve.set_number_of_edges(1);
  check_refused(Domain(bow_tie), "crosses", "segment 1 of loop 1", "(0, 0) to (1, 1)", "segment 3 of loop 1", "(1, 0) to (0, 1)");
}

TEST(Bad_input, crossing_loops)
{
  check_refused(square_with_holes({small_square(0.8, 0.4, 0.4)}), "crosses", "of loop 1", "of loop 2");
  check_refused(square_with_holes({small_square(0.2, 0.2, 0.3), small_square(0.4, 0.4, 0.3)}), "crosses", "of loop 2",
                "of loop 3");
}

TEST(Bad_input, loops_that_touch)
{
  // along a side, in a point where only one of them has a corner, and a loop with itself
  check_refused(square_with_holes({small_square(0.2, 0.2, 0.2), small_square(0.4, 0.3, 0.2)}), "touches", "of loop 2",
                "of loop 3", "(0.4", "0.4");
  check_refused(square_with_holes({small_square(0, 0.2, 0.2)}), "touches", "of loop 1", "of loop 2");
  check_refused(Domain({Point_2(0, 0), Point_2(1, 0), Point_2(1, 1), Point_2(0.5, 0), Point_2(0, 1)}), "touches",
                "of loop 1, ", "(0.5, 0)");
}

TEST(Bad_input, side_that_folds_back)
{
  check_refused(Domain({Point_2(0, 0), Point_2(2, 0), Point_2(1, 0), Point_2(1, 1)}), "touches", "of loop 1");
}

TEST(Bad_input, wrong_nesting)
{
  check_refused(square_with_holes({small_square(2, 2, 0.5)}), "loop 2", "outside", "(2, 2)");
  check_refused(square_with_holes({small_square(0.2, 0.2, 0.6), small_square(0.4, 0.4, 0.2)}), "loop 3",
                "inside another hole", "(0.4");
  check_refused(square_with_holes({small_square(-1, -1, 3)}), "loop 1", "outer", "inside");
}

TEST(Bad_input, domain_of_area_zero)
{
  check_refused(Domain({Point_2(0, 0), Point_2(1, 1), Point_2(3, 3)}), "loop 1");
  check_refused(Domain({Point_2(1, 1), Point_2(1, 1), Point_2(1, 1)}), "loop 1");
}

TEST(Bad_input, degenerate_surface)
{
  check_refused(Sample_surface(Linear_surface{1, 2, 2, 4}), square(), small_edges(), "degenerate", "(u,v) = ("); // a line
  check_refused(Sample_surface(Linear_surface{1, 0, 0, 0}), square(), small_edges(), "degenerate");
  check_refused(Sample_surface(Linear_surface{0, 0, 0, 0}), square(), small_edges(), "degenerate"); // a point
  check_refused(Sample_surface(Linear_surface{0, 0, 0, 0}), square(), Criteria(), "degenerate");
}

TEST(Bad_input, sizes_that_contradict_each_other)
{
  check_refused(flat, square(), Criteria().set_max_edge(0.25).set_min_edge(0.5), "minimum edge", "0.5", "maximum edge",
                "0.25");
}

TEST(Bad_input, sizes_that_need_too_many_vertices)
{
  Criteria few = Criteria().set_max_edge(1e-6).set_min_edge(1e-7).set_max_number_of_vertices(1000);
  check_refused(flat, square(), few, "maximum edge", "vertices");
  check_refused(flat, square(), Criteria().set_max_edge(1e-300).set_min_edge(1e-300), "maximum edge", "vertices");
}

TEST(Bad_input, minimum_edge_that_needs_too_many_vertices)
{
  // the boundary would be halved down to the wanted size
  const Criteria criteria = Criteria().set_max_edge(0.1).set_min_edge(1e-6).set_max_number_of_vertices(1000);
  check_refused(flat, square(), Criteria(criteria).set_sizing_field([](double, double) { return 1e-4; }), "vertices");
  const Sample_surface cylinder((CGAL::Parametric_cylinder_3<Test_kernel>(1)));
  check_refused(cylinder, square(), Criteria(criteria).set_gamma(1e-5), "vertices");
}

TEST(Bad_input, sizing_field)
{
  for(double value : {0., -1., not_a_number}) {
    const auto on_the_right = [value](double u, double v) { return is_on_the_right(u, v) ? value : 0.1; };
    check_refused(flat, square(), small_edges().set_sizing_field(on_the_right), "sizing field", "not positive", "(u,v) = (");
    const auto inside = [value](double u, double v) { return is_inside(u, v) ? value : 0.1; };
    check_refused(flat, square(), small_edges().set_sizing_field(inside), "sizing field", "not positive", "(u,v) = (0.");
  }
}

TEST(Bad_input, options_out_of_range)
{
  const std::string finite = "positive and finite", angle = "at least 0 and below 60 degrees";
  check_option(&Criteria::set_max_edge, "maximum edge length", finite, {-1, 0, infinity, not_a_number});
  check_option(&Criteria::set_min_edge, "minimum edge length", finite, {-1, 0, infinity, not_a_number});
  check_option(&Criteria::set_gamma, "deviation ratio gamma", "positive", {-1, 0, not_a_number});
  check_option(&Criteria::set_angle, "smallest angle", angle, {-1, 60, 80, 100, infinity, not_a_number});
  check_option(&Criteria::set_size_factor, "size factor", finite, {-1, 0, infinity, not_a_number});
  check_option(&Criteria::set_growth, "growth", "at least 0 and finite", {-1, infinity, not_a_number});
  check_option(&Criteria::set_distance, "distance", "positive", {-1, 0, not_a_number});
  check_option(&Criteria::set_closeness, "closeness", "positive", {-1, 0, not_a_number});
  check_option(&Criteria::set_improvement_angle, "improvement angle", angle, {-1, 60, not_a_number});
  check_option(&Criteria::set_improvement_time, "improvement time", "at least 0", {-1, not_a_number});
}

TEST(Bad_input, sizes_that_are_not_set)
{
  EXPECT_FALSE(Criteria().sizing().max_edge);
  EXPECT_EQ(0.5, Criteria().set_min_edge(0.5).sizing().min_edge);
  expect_refused([] { Criteria().max_edge(); }, "maximum edge length", "not been set");
  const CGAL::Space_curve_3<Test_kernel> segment = CGAL::Space_curve_3<Test_kernel>::segment(Point_3(0, 0, 0), Point_3(1, 0, 0));
  expect_refused([&] { CGAL::Parametric_surface_mesher::divide_curve(segment, Criteria()); }, "edge length has not been set");
  EXPECT_EQ(11u, CGAL::Parametric_surface_mesher::divide_curve(segment, small_edges()).size());
}

TEST(Bad_input, curves)
{
  const auto jet = [](double t) { return Curve::Jet{Point_2(t, t), Vector_2(1, 1), Vector_2(0, 0)}; };
  const auto jet_in_space = [](double t) {
    return CGAL::Space_curve_3<Test_kernel>::Jet{Point_3(t, t, t), Vector_3(1, 1, 1), Vector_3(0, 0, 0)};
  };
  for(double end : {1., infinity, not_a_number}) {
    expect_refused([&] { Curve(jet, 1, end); }, "parameters of a curve", "and are 1 and " + word(end));
    expect_refused([&] { CGAL::Space_curve_3<Test_kernel>(jet_in_space, 1, end); }, "parameters of a curve", word(end));
  }
  for(double radius : {0., -1., infinity, not_a_number})
    expect_refused([&] { Curve::circle(Point_2(0, 0), radius); }, "radius of an arc", "positive and finite", word(radius));
  Domain domain = square();
  Domain::Loop loop = domain.loops()[0];
  loop[1].set_number_of_edges(4000000000u);
  check_refused(Domain(loop), "4000000000 pieces", "allowed number of vertices");
}

TEST(Bad_input, metric_parameters)
{
  for(double ratio : {0.5, not_a_number, infinity})
    expect_refused([&] { CGAL::Principal_curvature_metric_2<Test_kernel> metric(ratio); }, "at least 1", word(ratio));
  for(double ratio : {0., -1., not_a_number})
    expect_refused([&] { CGAL::Metric_tensor_2::from_ellipse(0.1, ratio); }, "half axes", "positive", word(ratio));
}

TEST(Bad_input, numbers_in_a_model)
{
  Mesh mesh;
  EXPECT_GT(CGAL::make_parametric_surface_mesh(two_triangles(), small_edges(), mesh).number_of_faces, 100u);
  check_model_refused([](Plane_model& model) { model.edges()[1].target = 4; }, "edge 2", "no vertex with index 4", "only 4 vertices");
  check_model_refused([](Plane_model& model) { model.edges()[1].source = std::size_t(-1); }, "edge 2", "no vertex");
  check_model_refused([](Plane_model& model) { model.edges()[2].is_collapsed = true; }, "edge 3 is collapsed", "vertex 3", "vertex 4");
  const auto use_edge_5 = [](Plane_model& model) { model.faces()[1].loops[0][2].edge = 5; };
  check_model_refused(use_edge_5, "face 2", "loop 1", "no edge with index 5", "only 5 edges");
  Plane_model model = two_triangles();
  use_edge_5(model);
  expect_refused([&] { CGAL::Parametric_surface_mesher::orient_faces(model); }, "no edge with index 5");
  expect_refused([&] { model.add_edge(0, 4); }, "no vertex with index 4");
  expect_refused([&] { model.add_edge(0, 1, true); }, "collapsed");
}

TEST(Bad_input, loops_of_a_model)
{
  check_model_refused([](Plane_model& model) { model.faces().clear(); }, "no faces");
  check_model_refused([](Plane_model& model) { model.faces()[1].loops.clear(); }, "face 2 has no loop");
  check_model_refused([](Plane_model& model) { model.faces()[1].loops.emplace_back(); }, "face 2", "loop 2", "no edge");
  check_model_refused([](Plane_model& model) { model.faces()[0].loops[0][2].is_reversed = false; }, "face 1", "loop 1", "open");
  check_model_refused([](Plane_model& model) { model.faces()[0].is_reversed = true; }, "faces 1 and 2", "orient_faces");
  for(double value : {not_a_number, infinity})
    check_model_refused([&](Plane_model& model) {
      auto& curve = model.faces()[1].loops[0][0].curve;
      curve.set_end_points(Point_2(value, 1), curve.target());
    }, "face 2", "edge 3", "(" + word(value) + ", 1)", "not finite");
}

TEST(Bad_input, lengths_in_a_model)
{
  for(double value : {-1., infinity, not_a_number}) {
    const std::string range = "at least 0 and finite, and is " + word(value);
    check_model_refused([&](Plane_model& model) { model.faces()[1].max_edge = value; }, "edge length of face 2", range);
    check_model_refused([&](Plane_model& model) { model.edges()[3].max_edge = value; }, "edge 4", range);
    check_model_refused([&](Plane_model& model) { model.edges()[3].tolerance = value; }, "tolerance of edge 4", range);
    expect_refused([&] { two_triangles().set_tolerance(value); }, "tolerance of the model", range);
  }
  Plane_model model = two_triangles();
  model.add_vertex(Point_3(0, not_a_number, 0));
  expect_refused([&] { CGAL::Parametric_surface_mesher::validate(model); }, "vertex 5", "nan", "not finite");
}

TEST(Bad_input, derivatives_that_contradict_the_points)
{
  typedef CGAL::Surface_jet_3<Test_kernel> Jet;
  const auto without_z = [](Vector_3& d) { d = Vector_3(d.x(), d.y(), 0); };
  const auto refused = [](const std::function<void(Jet&)>& change, const std::string& word) {
    check_refused(Sample_surface(Peaks{change}), square(), small_edges(), "contradict", "(u,v) = (0.", word, "jet()");
  };
  check_refused(Sample_surface(Peaks{[](Jet& jet) { jet.point = jet.point + Vector_3(0, 0, 0.1); }}), square(), small_edges(),
                "contradicts itself", "point() gives (0.", "jet() (0.");
  refused([&](Jet& jet) { without_z(jet.du); }, "/du");
  refused([&](Jet& jet) { without_z(jet.dv); without_z(jet.duv); without_z(jet.dvv); }, "d/dv");
  refused([](Jet& jet) { jet.dv = 1.02 * jet.dv; }, "d/dv is (0, 1.02, ");
  refused([](Jet& jet) { std::swap(jet.du, jet.dv); }, "/du");
  refused([](Jet& jet) { jet.duu = -jet.duu; }, "d^2/du^2");
  refused([](Jet& jet) { jet.duv = 2 * jet.duv; }, "d^2/(du dv)");
  refused([](Jet& jet) { jet.dvv = Vector_3(0, 0, 0); }, "d^2/dv^2");
  Mesh mesh;
  EXPECT_GT(add_patch(Sample_surface(Peaks{nullptr}), square(), small_edges(), mesh).number_of_faces, 100u);
}

// Creases through the centre of the domain, points that are rounded to `float`, large offsets, and derivatives that are there
// but on one side.
TEST(Bad_input, rough_surfaces_are_none)
{
  const auto accepted = [](const auto& surface, double max_edge) {
    Mesh mesh;
    EXPECT_GT(add_patch(surface, square(), Criteria().set_max_edge(max_edge).set_gamma(1), mesh).number_of_faces, 3u);
  };
  for(double edge : {0.1, 0.5, 1.}) {
    accepted(CGAL::make_parametric_function_surface([](auto u, auto v) {
      using std::fabs;
      return CGAL::parametric_surface_point(u, v, fabs(u - 0.5) + fabs(v - 0.5));
    }), edge);
    accepted(CGAL::make_parametric_function_surface([](auto u, auto v) {
      using std::hypot;
      return CGAL::parametric_surface_point(1e-7 * u, 1e-7 * v, 1e-7 * hypot(u - 0.5, v - 0.5));
    }), 1e-7 * edge);
    accepted(CGAL::make_parametric_function_surface([](auto u, auto v) {
      return CGAL::parametric_surface_point(1e6 + u, v - 1e6, 0.1 * u * v);
    }), edge);
    const auto smooth = CGAL::make_parametric_function_surface([](auto u, auto v) {
      using std::sin;
      return CGAL::parametric_surface_point(u, v, 0.2 * sin(3 * u) * v);
    });
    accepted(CGAL::make_parametric_jet_surface([&](double u, double v) {
      auto jet = smooth.jet(u, v);
      jet.point = Point_3(float(jet.point.x()), float(jet.point.y()), float(jet.point.z()));
      return jet;
    }), edge);
  }
}
