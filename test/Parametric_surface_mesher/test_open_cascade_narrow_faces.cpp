// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces that are nowhere wider than a millionth of the diagonal: they are closed up and named, and their neighbours fit.
#include "open_cascade_test_helpers.h"

#include <CGAL/sew_open_cascade_shape.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace {

const double pi = 4 * std::atan(1.);

TopoDS_Face polygon(const std::vector<gp_Pnt>& points)
{
  BRepBuilderAPI_MakePolygon result;
  for(const gp_Pnt& p : points)
    result.Add(p);
  result.Close();
  return BRepBuilderAPI_MakeFace(result.Wire()).Face();
}

// a bar with a chamfer of `n` faces at one edge, each of them this wide in x
TopoDS_Shape bar(double width, int n = 1)
{
  std::vector<gp_Pnt> points = {{0, 0, 0}, {10, 0, 0}};
  for(int i = 0; i <= n; ++i)
    points.emplace_back(10 - i * width, 5 + 0.1 * i * width, 0);
  points.emplace_back(0, 5, 0);
  return BRepPrimAPI_MakePrism(polygon(points), gp_Vec(0, 0, 20)).Shape();
}

TopoDS_Edge line(const TopoDS_Vertex& a, const TopoDS_Vertex& b) { return BRepBuilderAPI_MakeEdge(a, b).Edge(); }

TopoDS_Vertex vertex(double x, double y) { return BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, 0)).Vertex(); }

TopoDS_Face plane_face(const std::vector<TopoDS_Edge>& edges)
{
  BRepBuilderAPI_MakeWire wire;
  for(const TopoDS_Edge& edge : edges)
    wire.Add(edge);
  return BRepBuilderAPI_MakeFace(gp_Pln(), wire.Wire()).Face();
}

TopoDS_Shell shell_of(const std::vector<TopoDS_Face>& faces)
{
  BRep_Builder builder;
  TopoDS_Shell result;
  builder.MakeShell(result);
  for(const TopoDS_Face& face : faces)
    builder.Add(result, face);
  return result;
}

// The curve between two vertices over the middle, higher by `rise`. The weights change the parameters and not the curve.
TopoDS_Edge bow(const TopoDS_Vertex& a, const TopoDS_Vertex& b, double rise, double weight = 1)
{
  const gp_Pnt p = BRep_Tool::Pnt(a), q = BRep_Tool::Pnt(b);
  TColgp_Array1OfPnt points(1, 3);
  TColStd_Array1OfReal weights(1, 3);
  points(1) = p;
  points(2) = gp_Pnt(0.5 * (p.X() + q.X()), 0.5 * (p.Y() + q.Y()) + rise, 0);
  points(3) = q;
  for(int i = 1; i <= 3; ++i)
    weights(i) = std::pow(weight, i - 1);
  return BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(points, weights), a, b).Edge();
}

void expect_sound(const TopoDS_Shape& shape, const Meshed_shape& meshed, double least_angle)
{
  EXPECT_TRUE(meshed.shape.left_out.empty());
  EXPECT_TRUE(meshed.report.left_out.empty());
  EXPECT_EQ(meshed.quality.is_closed, meshed.shape.is_shape_closed);
  EXPECT_GE(meshed.quality.min_angle, least_angle);
  EXPECT_EQ(Cad_mesh_judge(shape, meshed.judged())().text(), "ok");
}

TEST(Narrow_faces, a_strip_is_closed_up_and_named)
{
  const TopoDS_Shape shape = bar(1e-5);
  const Meshed_shape meshed(shape);
  ASSERT_EQ(meshed.shape.closed_up.size(), 1u);
  EXPECT_NEAR(meshed.shape.closed_up[0].width, 1e-5, 1e-6);
  EXPECT_EQ(meshed.shape.number_of_shape_faces, 7u);
  EXPECT_EQ(meshed.shape.shape_faces.size(), 6u);
  for(const std::size_t face : meshed.shape.shape_faces)
    EXPECT_NE(face, meshed.shape.closed_up[0].shape_face);
  expect_sound(shape, meshed, 25);
  EXPECT_NEAR(std::fabs(meshed.volume()), 1000, 1e-2);
}

TEST(Narrow_faces, the_edges_in_the_place_of_others_are_told)
{
  const auto shape = CGAL::make_model_of_open_cascade_shape(bar(1e-5));
  ASSERT_EQ(shape.model_edges.size(), shape.number_of_shape_edges);
  std::size_t merged = 0, points = 0;
  for(std::size_t e = 0; e < shape.model_edges.size(); ++e) {
    points += shape.model_edges[e].empty();
    merged += !shape.model_edges[e].empty() && shape.model_edges[e][0] != e;
  }
  EXPECT_EQ(merged, 1u);
  EXPECT_EQ(points, 2u);
}

TEST(Narrow_faces, a_wider_strip_is_meshed)
{
  const TopoDS_Shape shape = bar(1e-4);
  const Meshed_shape meshed(shape);
  EXPECT_TRUE(meshed.shape.closed_up.empty());
  EXPECT_EQ(meshed.shape.shape_faces.size(), 7u);
  expect_sound(shape, meshed, 0);
}

TEST(Narrow_faces, none_is_closed_up_on_request)
{
  const auto shape = CGAL::make_model_of_open_cascade_shape(bar(1e-5), 0);
  EXPECT_TRUE(shape.closed_up.empty());
  EXPECT_EQ(shape.model.faces().size(), 7u);
}

TEST(Narrow_faces, strips_side_by_side)
{
  const TopoDS_Shape shape = bar(7e-6, 3);
  const Meshed_shape meshed(shape);
  EXPECT_EQ(meshed.shape.closed_up.size(), 3u);
  expect_sound(shape, meshed, 25);
}

TEST(Narrow_faces, widths_do_not_add_up)
{
  const TopoDS_Shape shape = bar(1e-5, 5);
  const Meshed_shape meshed(shape);
  EXPECT_GE(meshed.shape.closed_up.size(), 2u);
  EXPECT_LE(meshed.shape.closed_up.size(), 4u);
  expect_sound(shape, meshed, 0);
}

TEST(Narrow_faces, strips_of_arcs)
{
  const TopoDS_Shape shape
    = BRepPrimAPI_MakeRevol(polygon({{5, 0, 0}, {8, 0, 0}, {8, 0, 3}, {8 - 1e-5, 0, 3 + 5e-6}, {5, 0, 3}}),
                            gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 2.).Shape();
  const Meshed_shape meshed(shape);
  EXPECT_EQ(meshed.shape.closed_up.size(), 1u);
  expect_sound(shape, meshed, 20);
}

TEST(Narrow_faces, a_ring_with_a_seam)
{
  const TopoDS_Shape shape
    = BRepPrimAPI_MakeRevol(polygon({{5, 0, 0}, {8, 0, 0}, {8, 0, 3}, {8 - 1e-5, 0, 3 + 5e-6}, {5, 0, 3}}),
                            gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))).Shape();
  const Meshed_shape meshed(shape);
  EXPECT_EQ(meshed.shape.closed_up.size(), 1u);
  expect_sound(shape, meshed, 20);
  EXPECT_NEAR(std::fabs(meshed.volume()), pi * (64 - 25) * 3, 1);
}

// Two faces with a strip between them, whose edges have the same or opposite directions, and different parameters.
void test_strip_between_bows(bool is_reversed, double weight)
{
  const double width = 5e-6;
  const TopoDS_Vertex a = vertex(0, 0), b = vertex(10, 0), c = vertex(10, 5), d = vertex(0, 5), e = vertex(10, 5 + width),
                      f = vertex(0, 5 + width), g = vertex(10, 9), h = vertex(0, 9);
  const TopoDS_Edge low = bow(d, c, 1), high = is_reversed ? bow(e, f, 1, weight) : bow(f, e, 1, weight), left = line(d, f),
                    right = line(c, e);
  const TopoDS_Shape shape
    = shell_of({plane_face({line(a, b), line(b, c), low, line(d, a)}), plane_face({low, right, high, left}),
                plane_face({high, line(e, g), line(g, h), line(h, f)})});
  const Meshed_shape meshed(shape);
  ASSERT_EQ(meshed.shape.closed_up.size(), 1u);
  EXPECT_EQ(meshed.shape.closed_up[0].shape_face, 1u);
  expect_sound(shape, meshed, 25);
  EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 1u);
  EXPECT_NEAR(meshed.quality.area, 90, 1e-3);
}

TEST(Narrow_faces, edges_with_the_same_parameters) { test_strip_between_bows(false, 1); }
TEST(Narrow_faces, edges_with_other_parameters) { test_strip_between_bows(false, 1.7); }
TEST(Narrow_faces, edges_in_opposite_directions) { test_strip_between_bows(true, 1); }
TEST(Narrow_faces, edges_in_opposite_directions_with_other_parameters) { test_strip_between_bows(true, 0.6); }

// Several faces on one side of a strip, at places between its ends; the lines between them are longer or shorter.
void test_strip_beside_several(const std::vector<double>& places, double rise, bool is_strip_last)
{
  const double width = 5e-6;
  const TopoDS_Vertex a = vertex(0, 0), b = vertex(10, 0), c = vertex(10, 5), d = vertex(0, 5);
  const TopoDS_Edge low = line(d, c);
  std::vector<TopoDS_Edge> strip = {low};
  std::vector<TopoDS_Face> faces = {plane_face({line(a, b), line(b, c), low, line(d, a)})};
  TopoDS_Vertex v = vertex(0, 5 + width), w = vertex(0, 9 + rise);
  const TopoDS_Edge begin = line(d, v);
  TopoDS_Edge wall = line(v, w);
  for(const double x : places) {
    const TopoDS_Vertex next_v = vertex(x, 5 + width), next_w = vertex(x, 9);
    const TopoDS_Edge side = line(v, next_v), next_wall = line(next_v, next_w);
    strip.push_back(side);
    faces.push_back(plane_face({side, next_wall, line(next_w, w), wall}));
    v = next_v;
    w = next_w;
    wall = next_wall;
  }
  strip.push_back(line(v, c));
  strip.push_back(begin);
  std::rotate(strip.begin(), strip.begin() + 1, strip.end());
  faces.insert(is_strip_last ? faces.end() : faces.begin(), plane_face(strip));
  const TopoDS_Shape shape = shell_of(faces);
  const Meshed_shape meshed(shape);
  ASSERT_EQ(meshed.shape.closed_up.size(), 1u);
  EXPECT_EQ(meshed.shape.closed_up[0].shape_face, is_strip_last ? faces.size() - 1 : 0u);
  expect_sound(shape, meshed, 20);
  EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 1u);
  EXPECT_EQ(meshed.quality.number_of_connected_components, 1u);
}

TEST(Narrow_faces, two_edges_on_one_side) { test_strip_beside_several({4, 10}, 0, true); }
TEST(Narrow_faces, three_edges_on_one_side) { test_strip_beside_several({3, 5, 10}, 1, false); }

TEST(Narrow_faces, a_bar_beside_others)
{
  // the strip of one bar, and the same one divided for two bars on it, side by side
  const TopoDS_Vertex a = vertex(0, 0), b = vertex(10, 0), c = vertex(10, 5), d = vertex(0, 5), e = vertex(10, 5 + 4e-6),
                      f = vertex(0, 5 + 4e-6), g = vertex(10, 5 + 8e-6), h = vertex(0, 5 + 8e-6), m = vertex(6, 5 + 8e-6),
                      n = vertex(6, 9), o = vertex(10, 9), p = vertex(0, 9);
  const TopoDS_Edge first = line(d, c), second = line(f, e), third = line(h, m), fourth = line(m, g), low_left = line(d, f),
                    low_right = line(c, e), high_left = line(f, h), high_right = line(e, g), wall = line(m, n);
  const TopoDS_Shape shape
    = shell_of({plane_face({line(a, b), line(b, c), first, line(d, a)}), plane_face({first, low_right, second, low_left}),
                plane_face({second, high_right, fourth, third, high_left}),
                plane_face({third, wall, line(n, p), line(p, h)}),
                plane_face({fourth, line(g, o), line(o, n), wall})});
  const Meshed_shape meshed(shape);
  EXPECT_EQ(meshed.shape.closed_up.size(), 2u);
  expect_sound(shape, meshed, 20);
  EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 1u);
  EXPECT_EQ(meshed.quality.number_of_connected_components, 1u);
}

// a frame between a square and one around it that is wider by `gap`, in a larger square
TopoDS_Shape framed_square(double gap)
{
  std::vector<TopoDS_Edge> inner, outer;
  for(std::vector<TopoDS_Edge>* edges : {&inner, &outer}) {
    const double r = edges == &inner ? 3 : 3 + gap;
    const TopoDS_Vertex a = vertex(-r, -r), b = vertex(r, -r), c = vertex(r, r), d = vertex(-r, r);
    *edges = {line(a, b), line(b, c), line(c, d), line(d, a)};
  }
  const auto wire = [](const std::vector<TopoDS_Edge>& edges) {
    return BRepBuilderAPI_MakeWire(edges[0], edges[1], edges[2], edges[3]).Wire();
  };
  BRepBuilderAPI_MakeFace frame(gp_Pln(), wire(outer)), around(polygon({{-6, -6, 0}, {6, -6, 0}, {6, 6, 0}, {-6, 6, 0}}));
  frame.Add(TopoDS::Wire(wire(inner).Reversed()));
  around.Add(TopoDS::Wire(wire(outer).Reversed()));
  return shell_of({around.Face(), frame.Face(), plane_face(inner)});
}

TEST(Narrow_faces, several_edges_on_both_sides)
{
  const TopoDS_Shape shape = framed_square(5e-6);
  const Meshed_shape meshed(shape);
  ASSERT_EQ(meshed.shape.closed_up.size(), 1u);
  EXPECT_EQ(meshed.shape.closed_up[0].shape_face, 1u);
  expect_sound(shape, meshed, 25);
  EXPECT_NEAR(meshed.quality.area, 144, 1e-9);
  EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 1u);
  EXPECT_EQ(meshed.quality.number_of_connected_components, 1u);
}

TEST(Narrow_faces, a_strip_that_ends_in_a_point)
{
  const TopoDS_Vertex a = vertex(0, 0), b = vertex(10, 0), c = vertex(10, 5), d = vertex(0, 5), e = vertex(10, 5 + 1e-5),
                      g = vertex(10, 9), h = vertex(0, 9);
  const TopoDS_Edge low = line(d, c), high = line(d, e);
  const TopoDS_Shape shape
    = shell_of({plane_face({line(a, b), line(b, c), low, line(d, a)}), plane_face({low, line(c, e), high}),
                plane_face({high, line(e, g), line(g, h), line(h, d)})});
  const Meshed_shape meshed(shape);
  EXPECT_EQ(meshed.shape.closed_up.size(), 1u);
  expect_sound(shape, meshed, 25);
  EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 1u);
}

TEST(Narrow_faces, what_is_wider_between_its_ends_is_meshed)
{
  const TopoDS_Vertex a = vertex(0, 0), b = vertex(10, 0), c = vertex(10, 5), d = vertex(0, 5), g = vertex(10, 9),
                      h = vertex(0, 9);
  const TopoDS_Edge low = line(d, c), high = bow(d, c, 0.01);
  const TopoDS_Shape shape = shell_of({plane_face({line(a, b), line(b, c), low, line(d, a)}), plane_face({low, high}),
                                       plane_face({high, line(c, g), line(g, h), line(h, d)})});
  const Meshed_shape meshed(shape);
  EXPECT_TRUE(meshed.shape.closed_up.empty());
  EXPECT_EQ(meshed.shape.model.faces().size(), 3u);
}

TEST(Narrow_faces, a_strip_at_a_border)
{
  const TopoDS_Vertex a = vertex(0, 0), b = vertex(10, 0), c = vertex(10, 5), d = vertex(0, 5), e = vertex(10, 5 + 1e-5),
                      f = vertex(0, 5 + 1e-5);
  const TopoDS_Edge low = line(d, c);
  const TopoDS_Shape shape
    = shell_of({plane_face({line(a, b), line(b, c), low, line(d, a)}),
                plane_face({low, line(c, e), line(e, f), line(f, d)})});
  const Meshed_shape meshed(shape);
  EXPECT_EQ(meshed.shape.closed_up.size(), 1u);
  expect_sound(shape, meshed, 25);
  EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 1u);
}

TEST(Narrow_faces, what_its_neighbour_surrounds_is_meshed)
{
  const TopoDS_Vertex a = vertex(2, 5), b = vertex(8, 5), c = vertex(8, 5 + 1e-5), d = vertex(2, 5 + 1e-5);
  const std::vector<TopoDS_Edge> edges = {line(a, b), line(b, c), line(c, d), line(d, a)};
  BRepBuilderAPI_MakeWire hole;
  for(const TopoDS_Edge& edge : edges)
    hole.Add(edge);
  BRepBuilderAPI_MakeFace around(polygon({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}));
  around.Add(TopoDS::Wire(hole.Wire().Reversed()));
  const TopoDS_Shape shape = shell_of({around.Face(), plane_face(edges)});
  const Meshed_shape meshed(shape);
  EXPECT_TRUE(meshed.shape.closed_up.empty());
  expect_sound(shape, meshed, 0);
  EXPECT_NEAR(meshed.quality.area, 100, 1e-6);
}

TEST(Narrow_faces, a_needle_does_not_vanish)
{
  const TopoDS_Shape shape = BRepPrimAPI_MakeBox(100, 4e-5, 4e-5).Shape();
  const Meshed_shape meshed(shape);
  EXPECT_TRUE(meshed.shape.closed_up.empty());
  expect_sound(shape, meshed, 0);
}

TEST(Narrow_faces, a_needle_does_not_matter_for_others)
{
  const TopoDS_Shape needle = BRepPrimAPI_MakeBox(gp_Pnt(0, -5, 0), 10, 1e-6, 1e-6).Shape();
  const TopoDS_Shape shape = compound_of({needle, bar(1e-5)});
  const Meshed_shape meshed(shape);
  EXPECT_EQ(meshed.shape.closed_up.size(), 1u);
  expect_sound(shape, meshed, 0);
}

TopoDS_Shape sewn(const Handle(Geom_Surface)& surface, const std::vector<std::array<double, 4>>& ranges)
{
  std::vector<TopoDS_Face> faces;
  for(const auto& r : ranges)
    faces.push_back(BRepBuilderAPI_MakeFace(surface, r[0], r[1], r[2], r[3], 1e-9).Face());
  return CGAL::sew_open_cascade_shape(shell_of(faces), 1e-7).shape;
}

TEST(Narrow_faces, a_lune_that_closes_a_sphere)
{
  const double end = 2 * pi - 2e-6;
  const TopoDS_Shape shape
    = sewn(new Geom_SphericalSurface(gp_Ax3(), 10), {{0, end, -pi / 2, pi / 2}, {end, 2 * pi, -pi / 2, pi / 2}});
  const Meshed_shape meshed(shape);
  EXPECT_EQ(meshed.shape.closed_up.size(), 1u);
  expect_sound(shape, meshed, 20);
}

TEST(Narrow_faces, a_strip_that_closes_a_cylinder)
{
  const double end = 2 * pi - 2e-6;
  const TopoDS_Shape shape = sewn(new Geom_CylindricalSurface(gp_Ax3(), 10), {{0, end, 0, 10}, {end, 2 * pi, 0, 10}});
  const Meshed_shape meshed(shape);
  EXPECT_EQ(meshed.shape.closed_up.size(), 1u);
  expect_sound(shape, meshed, 25);
  EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 2u);
}

TEST(Narrow_faces, a_ring_that_closes_a_torus)
{
  const double end = 2 * pi - 4e-6;
  const TopoDS_Shape shape
    = sewn(new Geom_ToroidalSurface(gp_Ax3(), 10, 3), {{0, 2 * pi, 0, end}, {0, 2 * pi, end, 2 * pi}});
  const Meshed_shape meshed(shape);
  EXPECT_EQ(meshed.shape.closed_up.size(), 1u);
  expect_sound(shape, meshed, 25);
}

TEST(Short_edges, become_vertices)
{
  const TopoDS_Vertex a = vertex(0, 0), b = vertex(10, 0), c = vertex(10, 5), d = vertex(0, 5), e = vertex(4, 5),
                      f = vertex(4 + 3e-6, 5), g = vertex(10, 9), h = vertex(0, 9);
  const TopoDS_Edge first = line(d, e), small = line(e, f), last = line(f, c);
  const TopoDS_Shape shape = shell_of({plane_face({line(a, b), line(b, c), last, small, first, line(d, a)}),
                                       plane_face({first, small, last, line(c, g), line(g, h), line(h, d)})});
  const Meshed_shape meshed(shape);
  EXPECT_TRUE(meshed.shape.closed_up.empty());
  const auto& edges = meshed.shape.model_edges;
  EXPECT_EQ(std::count_if(edges.begin(), edges.end(), [](const auto& of_model) { return of_model.empty(); }), 1);
  expect_sound(shape, meshed, 25);
  EXPECT_NEAR(meshed.quality.area, 90, 1e-9);
  EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 1u);
}

TEST(Short_edges, that_close_a_circle)
{
  const double begin = 1e-6;
  const gp_Circ circle(gp_Ax2(gp_Pnt(5, 5, 0), gp_Dir(0, 0, 1)), 2);
  const TopoDS_Edge arc = BRepBuilderAPI_MakeEdge(circle, begin, 2 * pi).Edge();
  const TopoDS_Edge small = line(TopExp::LastVertex(arc), TopExp::FirstVertex(arc));
  BRepBuilderAPI_MakeFace around(polygon({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}));
  around.Add(TopoDS::Wire(BRepBuilderAPI_MakeWire(arc, small).Wire().Reversed()));
  const Meshed_shape meshed(around.Face());
  const auto& edges = meshed.shape.model_edges;
  EXPECT_EQ(std::count_if(edges.begin(), edges.end(), [](const auto& of_model) { return of_model.empty(); }), 1);
  expect_sound(around.Face(), meshed, 25);
  EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 2u);
}

TEST(Short_edges, of_small_holes_stay)
{
  const TopoDS_Face hole = polygon({{1, 1, 0}, {1 + 5e-6, 1, 0}, {1, 1 + 5e-6, 0}});
  BRepBuilderAPI_MakeFace around(polygon({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}));
  around.Add(TopoDS::Wire(TopoDS_Iterator(hole).Value().Reversed()));
  const Meshed_shape meshed(around.Face());
  for(const auto& edges : meshed.shape.model_edges)
    EXPECT_EQ(edges.size(), 1u);
  expect_sound(around.Face(), meshed, 0);
  EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 2u);
}

TEST(Narrow_faces, the_judge_accepts_nothing_else_without_triangles)
{
  const TopoDS_Shape narrow = bar(1e-5), wide = bar(1e-4);
  const Meshed_shape meshed(narrow);
  Judged_mesh unnamed = meshed.judged(), misnamed = meshed.judged();
  unnamed.closed_up_faces.clear();
  misnamed.closed_up_faces.push_back(1);
  EXPECT_EQ(Cad_mesh_judge(narrow, unnamed)().text(), "uncov1");
  EXPECT_EQ(Cad_mesh_judge(narrow, misnamed)().text(), "uncov1");
  EXPECT_NE(Cad_mesh_judge(wide, meshed.judged())().text(), "ok");
}

} // namespace
