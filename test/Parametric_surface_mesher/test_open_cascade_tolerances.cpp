// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shapes whose curves meet only up to the tolerances of their vertices, or up to whole periods.
#include "open_cascade_test_helpers.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Dir2d.hxx>
#include <gp_Lin.hxx>
#include <gp_Pln.hxx>
#include <gp_Pnt2d.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

TopoDS_Vertex vertex_at(const gp_Pnt& p, double tolerance)
{
  TopoDS_Vertex result;
  BRep_Builder().MakeVertex(result, p, tolerance);
  return result;
}

// A segment from `p` to `q`, which are the places of its vertices up to their tolerances.
TopoDS_Edge segment(const TopoDS_Vertex& source, const TopoDS_Vertex& target, const gp_Pnt& p, const gp_Pnt& q)
{
  BRep_Builder builder;
  TopoDS_Edge result;
  builder.MakeEdge(result, new Geom_Line(p, gp_Dir(gp_Vec(p, q))), 1e-7);
  builder.Add(result, source.Oriented(TopAbs_FORWARD));
  builder.Add(result, target.Oriented(TopAbs_REVERSED));
  builder.Range(result, 0, p.Distance(q));
  return result;
}

TopoDS_Face planar_face(const std::vector<TopoDS_Edge>& edges)
{
  BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for(const TopoDS_Edge& edge : edges)
    builder.Add(wire, edge);
  TopoDS_Face result;
  builder.MakeFace(result, new Geom_Plane(gp_Pln()), 1e-7);
  builder.Add(result, wire);
  return result;
}

// A rectangle whose upright sides end this far from the corners, or have moved up as far and the other ones to the left.
TopoDS_Face rectangle_with_gaps(double height, double gap, bool have_moved)
{
  const std::vector<gp_Pnt> corners{gp_Pnt(0, 0, 0), gp_Pnt(10, 0, 0), gp_Pnt(10, height, 0), gp_Pnt(0, height, 0)};
  std::vector<TopoDS_Vertex> vertices;
  for(const gp_Pnt& p : corners)
    vertices.push_back(vertex_at(p, 1.2 * gap));
  std::vector<TopoDS_Edge> edges;
  for(std::size_t i = 0; i < 4; ++i) {
    const gp_Pnt &p = corners[i], &q = corners[(i + 1) % 4];
    const gp_Vec forward = (i % 2 == 1 ? gap : have_moved ? -gap : 0) * gp_Vec(p, q).Normalized();
    edges.push_back(segment(vertices[i], vertices[(i + 1) % 4], p.Translated(forward), q.Translated(have_moved ? forward : -forward)));
  }
  return planar_face(edges);
}

// A gap is no pole, whatever share of the domain it is.
TEST(Tolerances, gaps_between_curves_are_closed)
{
  for(double height : {0.2, 1., 5.})
    for(double gap : {0.001, 0.01, 0.03})
      for(bool have_moved : {false, true}) {
        const Meshed_shape meshed(rectangle_with_gaps(height, gap, have_moved));
        EXPECT_TRUE(meshed.shape.left_out.empty()) << gap;
        EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 1u) << gap;
        EXPECT_NEAR(meshed.quality.area, 10 * height, 10 * gap) << gap;
        EXPECT_GT(meshed.quality.min_angle, 29) << height << " " << gap << " " << have_moved;
        for(const auto& edge : meshed.shape.model.edges())
          EXPECT_FALSE(edge.is_collapsed) << gap;
      }
}

// A patch whose side v = 0 is a point.
Handle(Geom_BezierSurface) pointed_surface()
{
  TColgp_Array2OfPnt poles(1, 2, 1, 2);
  poles(1, 1) = poles(2, 1) = gp_Pnt(0, 0, 0);
  poles(1, 2) = gp_Pnt(10, 0, 0);
  poles(2, 2) = gp_Pnt(5, 10, 0);
  return new Geom_BezierSurface(poles);
}

// The collapsed side of a file is not exactly parallel to an axis of the domain.
TEST(Tolerances, slanted_poles_are_straightened)
{
  BRep_Builder builder;
  for(double slant : {2e-7, 2e-6, 1e-4}) {
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(pointed_surface(), 1e-6).Face();
    for(TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(e.Current());
      if(BRep_Tool::Degenerated(edge)) {
        builder.UpdateEdge(edge, new Geom2d_Line(gp_Pnt2d(0, 0), gp_Dir2d(1, slant)), face, 1e-7);
        builder.UpdateVertex(TopExp::FirstVertex(edge), 20 * slant);
      }
    }
    const Meshed_shape meshed(face);
    EXPECT_TRUE(meshed.shape.left_out.empty()) << slant;
    EXPECT_NEAR(meshed.quality.area, 50, 1e-2) << slant;
    EXPECT_GT(meshed.quality.min_angle, 20) << slant;
  }
}

// An arc on the cylinder of radius 1 whose curve in the domain is some periods away.
TopoDS_Edge arc(const TopoDS_Vertex& source, const TopoDS_Vertex& target, double begin, double end, double height,
                const Handle(Geom_Surface)& cylinder, int periods)
{
  BRep_Builder builder;
  TopoDS_Edge result;
  builder.MakeEdge(result, new Geom_Circle(gp_Ax2(gp_Pnt(0, 0, height), gp::DZ(), gp::DX()), 1), 1e-7);
  builder.UpdateEdge(result, new Geom2d_Line(gp_Pnt2d(2 * CGAL_PI * periods, height), gp::DX2d()), cylinder, TopLoc_Location(), 1e-7);
  builder.Add(result, source.Oriented(TopAbs_FORWARD));
  builder.Add(result, target.Oriented(TopAbs_REVERSED));
  builder.Range(result, begin, end);
  return result;
}

// The wall of a cylinder. The upper circle has two arcs, so that the loop comes to the upper end of the seam twice.
TEST(Tolerances, uses_are_ordered_whatever_their_order_and_periods)
{
  const double u = 0.5, pi = CGAL_PI;
  const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), 1);
  const auto point = [](double angle, double height) { return gp_Pnt(std::cos(angle), std::sin(angle), height); };
  const TopoDS_Vertex lower = vertex_at(point(u, 0), 1e-7), upper = vertex_at(point(u, 1), 1e-7),
                      opposite = vertex_at(point(u + pi, 1), 1e-7);
  BRep_Builder builder;
  const TopoDS_Edge seam = segment(lower, upper, point(u, 0), point(u, 1));
  builder.UpdateEdge(seam, new Geom2d_Line(gp_Pnt2d(u + 2 * pi, 0), gp::DY2d()), new Geom2d_Line(gp_Pnt2d(u, 0), gp::DY2d()),
                     cylinder, TopLoc_Location(), 1e-7);
  for(int periods : {-1, 0, 1})
    for(int other : {-1, 0, 1}) {
      std::vector<TopoDS_Shape> edges{arc(lower, lower, u, u + 2 * pi, 0, cylinder, other), seam,
                                      arc(opposite, upper, u + pi, u + 2 * pi, 1, cylinder, periods).Reversed(),
                                      arc(upper, opposite, u, u + pi, 1, cylinder, other).Reversed(), seam.Reversed()};
      std::vector<std::size_t> order{0, 1, 2, 3, 4};
      do {
        TopoDS_Wire wire;
        builder.MakeWire(wire);
        for(std::size_t i : order)
          builder.Add(wire, edges[i]);
        TopoDS_Face face;
        builder.MakeFace(face, cylinder, 1e-7);
        builder.Add(face, wire);
        const auto shape = CGAL::make_model_of_open_cascade_shape(face);
        ASSERT_TRUE(shape.left_out.empty()) << periods << other << order[0] << order[1] << order[2] << order[3] << order[4]
                                            << shape.left_out.front().reason;
        ASSERT_EQ(shape.model.faces().front().loops.size(), 1u);
        ASSERT_EQ(shape.model.faces().front().loops.front().size(), 5u);
      } while(std::next_permutation(order.begin(), order.end()));
    }
}

// A triangle whose sides run past two of its corners, by far more than they are divided.
TEST(Tolerances, curves_that_cross_before_their_vertex_end_there)
{
  const double beyond = 0.006;
  const gp_Pnt a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  const TopoDS_Vertex va = vertex_at(a, 1e-7), vb = vertex_at(b, 1.1 * beyond), vc = vertex_at(c, 1.1 * beyond);
  BRep_Builder builder;
  TopoDS_Edge round; // a quarter of a circle, a little longer at both ends
  builder.MakeEdge(round, new Geom_Circle(gp_Ax2(gp::Origin(), gp::DZ(), gp::DX()), 1), 1e-7);
  builder.Add(round, vb.Oriented(TopAbs_FORWARD));
  builder.Add(round, vc.Oriented(TopAbs_REVERSED));
  builder.Range(round, -beyond, 0.5 * CGAL_PI + beyond);
  const TopoDS_Face face = planar_face({segment(va, vb, a, gp_Pnt(1 + beyond, 0, 0)), round, segment(vc, va, gp_Pnt(0, 1 + beyond, 0), a)});
  const auto shape = CGAL::make_model_of_open_cascade_shape(face);
  Mesh mesh;
  const auto report = CGAL::make_parametric_surface_mesh(shape.model, cad_criteria(shape.diagonal).set_max_edge(0.004), mesh,
                                                         CGAL::parameters::leaves_out_bad_faces(true));
  EXPECT_TRUE(report.left_out.empty());
  EXPECT_NEAR(CGAL::triangle_mesh_quality(mesh).area, 0.25 * CGAL_PI, 0.01);
  EXPECT_GT(report.smallest_angle, 20);
}

// Two rectangles, and between them a face with a straight side and one through three points in the middle.
TopoDS_Shape shell_with_lens(double tolerance, const std::vector<double>& heights)
{
  const auto vertex = [](double x, double y) { return vertex_at(gp_Pnt(x, y, 0), 1e-7); };
  const auto line = [](const TopoDS_Vertex& v, const TopoDS_Vertex& w) { return segment(v, w, BRep_Tool::Pnt(v), BRep_Tool::Pnt(w)); };
  const TopoDS_Vertex left = vertex(-5, 0), l = vertex(-0.15, 0), r = vertex(0.15, 0), right = vertex(5, 0),
                      below[] = {vertex(-5, -5), vertex(5, -5)}, above[] = {vertex(-5, 5), vertex(5, 5)};
  const TopoDS_Edge to_left = line(left, l), to_right = line(r, right), straight = line(l, r);
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 5);
  for(int i = 0; i < 5; ++i)
    points->SetValue(i + 1, gp_Pnt(-0.15 + 0.075 * i, i == 0 || i == 4 ? 0 : heights[i - 1], 0));
  GeomAPI_Interpolate interpolate(points, false, 1e-9);
  interpolate.Perform();
  TopoDS_Edge bent;
  BRep_Builder builder;
  builder.MakeEdge(bent, interpolate.Curve(), tolerance);
  builder.Add(bent, l.Oriented(TopAbs_FORWARD));
  builder.Add(bent, r.Oriented(TopAbs_REVERSED));
  builder.Range(bent, interpolate.Curve()->FirstParameter(), interpolate.Curve()->LastParameter());
  builder.UpdateEdge(straight, tolerance);
  const auto back = [](const TopoDS_Edge& edge) { return TopoDS::Edge(edge.Reversed()); };
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  builder.Add(shell, planar_face({line(below[0], below[1]), line(below[1], right), back(to_right), back(straight), back(to_left),
                                  line(left, below[0])}));
  builder.Add(shell, planar_face({to_left, bent, to_right, line(right, above[1]), line(above[1], above[0]), line(above[0], left)}));
  builder.Add(shell, planar_face({straight, back(bent)}));
  return shell;
}

TEST(Tolerances, faces_narrower_than_the_tolerances_of_their_edges_are_closed_up)
{
  const Meshed_shape meshed(shell_with_lens(0.002, {-0.0005, -0.001, -0.0005}));
  ASSERT_EQ(meshed.shape.closed_up.size(), 1u);
  EXPECT_EQ(meshed.shape.closed_up[0].shape_face, 2u);
  EXPECT_NEAR(meshed.shape.closed_up[0].width, 0.001, 1e-4);
  EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 1u);
  EXPECT_GT(meshed.quality.min_angle, 29);
}

// The curves enclose more to the left than to the right, but the point in the middle says otherwise.
TEST(Tolerances, faces_fit_whose_curves_cross)
{
  const Meshed_shape meshed(shell_with_lens(1e-7, {0.003, -0.001, 0.003}));
  EXPECT_TRUE(meshed.shape.closed_up.empty());
  EXPECT_TRUE(meshed.report.left_out.empty());
  EXPECT_EQ(meshed.shape.number_of_reversed_faces, 0u);
  EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 1u);
  EXPECT_EQ(meshed.quality.number_of_connected_components, 1u);
}

// Halving the pieces of curves that cross does not help, and is taken back for the neighbours.
TEST(Tolerances, a_face_whose_curves_cross_does_not_harm_its_neighbors)
{
  const Meshed_shape meshed(shell_with_lens(1e-7, {0.03, -0.03, 0.03}));
  ASSERT_EQ(meshed.report.left_out.size(), 1u);
  EXPECT_EQ(meshed.shape.shape_faces[meshed.report.left_out[0].face], 2u);
  EXPECT_GT(meshed.quality.min_angle, 20);
}

TEST(Tolerances, vertices_within_their_tolerances_are_joined)
{
  const gp_Pnt a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(1e-5, 1, 0);
  const TopoDS_Vertex va = vertex_at(a, 1e-7), vb = vertex_at(b, 1e-7);
  for(double tolerance : {8e-6, 4e-6}) {
    const TopoDS_Vertex vc = vertex_at(c, tolerance), vd = vertex_at(d, tolerance);
    const auto shape = CGAL::make_model_of_open_cascade_shape(planar_face({segment(va, vb, a, b), segment(vb, vd, b, d), segment(vc, va, c, a)}));
    EXPECT_EQ(shape.number_of_joined_vertices, tolerance > 5e-6 ? 1u : 0u);
    EXPECT_EQ(shape.left_out.size(), tolerance > 5e-6 ? 0u : 1u);
  }
}

} // namespace
