// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shapes with faults: what can be meshed is meshed, the rest is named.
#include "open_cascade_test_helpers.h"

#include <CGAL/repair_open_cascade_shape.h>
#include <CGAL/sew_open_cascade_shape.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFill.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace {

TopoDS_Wire polygon(const std::vector<gp_Pnt>& points)
{
  BRepBuilderAPI_MakePolygon result;
  for(const gp_Pnt& p : points)
    result.Add(p);
  result.Close();
  return result.Wire();
}

// a face with the given boundary, whatever that is
TopoDS_Face face_of(const TopoDS_Wire& wire, const Handle(Geom_Surface)& surface)
{
  BRep_Builder builder;
  TopoDS_Face result;
  builder.MakeFace(result, surface, 1e-7);
  builder.Add(result, wire);
  return result;
}

// a quarter of a cylinder of radius 1 with its boundary, and a square
TopoDS_Face cylinder_face()
{
  return BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(), 1), 0.3, 1.9, 0., 2., 1e-7).Face();
}

void remove_domain_curves(const TopoDS_Face& face)
{
  BRep_Builder builder;
  for(TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
    builder.UpdateEdge(TopoDS::Edge(edge.Current()), Handle(Geom2d_Curve)(), face, 1e-7);
}

TEST(Dirty_shapes, missing_curves_in_the_domain_are_rebuilt)
{
  const TopoDS_Face face = cylinder_face();
  remove_domain_curves(face);
  const Meshed_shape meshed(face);
  EXPECT_EQ(meshed.shape.number_of_rebuilt_curves, 4u);
  EXPECT_TRUE(meshed.shape.left_out.empty());
  EXPECT_NEAR(meshed.quality.area, 3.2, 0.01);
  EXPECT_EQ(Cad_mesh_judge(cylinder_face(), meshed.judged())().text(), "ok");
}

// A loop may run against its curves, in each of the eight ways that three edges can be directed.
TEST(Dirty_shapes, triangles_with_edges_in_mixed_directions)
{
  const std::vector<gp_Pnt> corners{gp_Pnt(0, 0, 0), gp_Pnt(2, 0, 0), gp_Pnt(0, 1, 0)};
  for(unsigned int directions = 0; directions < 8; ++directions) {
    BRepBuilderAPI_MakeWire wire;
    for(unsigned int i = 0; i < 3; ++i) {
      const gp_Pnt &p = corners[i], &q = corners[(i + 1) % 3];
      wire.Add((directions >> i & 1) == 0 ? BRepBuilderAPI_MakeEdge(p, q).Edge() : BRepBuilderAPI_MakeEdge(q, p).Edge());
    }
    const Meshed_shape meshed(face_of(wire.Wire(), new Geom_Plane(gp_Pln())));
    EXPECT_TRUE(meshed.shape.left_out.empty()) << directions;
    EXPECT_NEAR(meshed.quality.area, 1, 1e-9) << directions;
    EXPECT_GT(meshed.quality.min_angle, 26) << directions; // the smallest corner has 26.6 degrees
  }
}

TEST(Dirty_shapes, faces_without_a_surface_are_left_out)
{
  TopoDS_Face face;
  BRep_Builder().MakeFace(face);
  BRep_Builder().Add(face, BRepBuilderAPI_MakePolygon(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0), gp_Pnt(0, 1, 0), true).Wire());
  const Meshed_shape meshed(compound_of({face, cylinder_face()}));
  ASSERT_EQ(meshed.shape.left_out.size(), 1u);
  EXPECT_NE(meshed.shape.left_out[0].reason.find("no surface"), std::string::npos) << meshed.shape.left_out[0].reason;
  EXPECT_NEAR(meshed.quality.area, 3.2, 0.01);
}

// A tolerance that allows for a wrong curve does not make it right.
TEST(Dirty_shapes, curves_in_the_domain_within_wide_tolerances_are_rebuilt)
{
  const TopoDS_Face face = cylinder_face();
  const TopoDS_Edge edge = TopoDS::Edge(TopExp_Explorer(face, TopAbs_EDGE).Current());
  const double off = 0.02;
  double first, last;
  const Handle(Geom2d_Curve) curve
    = Handle(Geom2d_Curve)::DownCast(BRep_Tool::CurveOnSurface(edge, face, first, last)->Translated(gp_Vec2d(0, off)));
  BRep_Builder().UpdateEdge(edge, curve, face, off);
  const Meshed_shape meshed(face);
  EXPECT_EQ(meshed.shape.number_of_rebuilt_curves, 1u);
  EXPECT_LT(meshed.shape.largest_gap, 1e-6);
}

TEST(Dirty_shapes, curves_in_the_domain_that_are_far_off_are_rebuilt)
{
  const TopoDS_Face face = cylinder_face();
  const TopoDS_Edge edge = TopoDS::Edge(TopExp_Explorer(face, TopAbs_EDGE).Current());
  double first, last;
  const Handle(Geom2d_Curve) curve
    = Handle(Geom2d_Curve)::DownCast(BRep_Tool::CurveOnSurface(edge, face, first, last)->Translated(gp_Vec2d(0.1, 0.05)));
  BRep_Builder().UpdateEdge(edge, curve, face, 1e-7);
  const Meshed_shape meshed(face);
  EXPECT_EQ(meshed.shape.number_of_rebuilt_curves, 1u);
  EXPECT_LT(meshed.shape.largest_gap, 1e-5);
  EXPECT_NEAR(meshed.quality.area, 3.2, 0.01);
}

TEST(Dirty_shapes, gaps_above_the_tolerance_are_reported)
{
  const TopoDS_Face face = cylinder_face();
  const TopoDS_Edge edge = TopoDS::Edge(TopExp_Explorer(face, TopAbs_EDGE).Current());
  double first, last;
  const Handle(Geom2d_Curve) curve
    = Handle(Geom2d_Curve)::DownCast(BRep_Tool::CurveOnSurface(edge, face, first, last)->Translated(gp_Vec2d(1e-4, 1e-4)));
  BRep_Builder().UpdateEdge(edge, curve, face, 1e-7);
  const Meshed_shape meshed(face);
  EXPECT_NEAR(meshed.shape.largest_gap, std::sqrt(2.) * 1e-4, 1e-6);
  ASSERT_FALSE(meshed.shape.gaps.empty());
  EXPECT_EQ(meshed.shape.gaps.front().shape_face, 0u);
  EXPECT_NEAR(meshed.shape.gaps.front().tolerance, 1e-7, 1e-9);
}

TEST(Dirty_shapes, an_open_loop_does_not_matter_for_other_faces)
{
  BRepBuilderAPI_MakeWire open;
  open.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 5), gp_Pnt(1, 0, 5)).Edge());
  open.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(1, 0, 5), gp_Pnt(1, 1, 5)).Edge());
  const Handle(Geom_Surface) plane = new Geom_Plane(gp_Pln(gp_Pnt(0, 0, 5), gp_Dir(0, 0, 1)));
  const TopoDS_Shape good = BRepPrimAPI_MakeBox(2, 2, 2).Shape();
  const Meshed_shape meshed(compound_of({face_of(open.Wire(), plane), good}));
  ASSERT_EQ(meshed.shape.left_out.size(), 1u);
  EXPECT_NE(meshed.shape.left_out[0].reason.find("open"), std::string::npos) << meshed.shape.left_out[0].reason;
  EXPECT_TRUE(meshed.quality.is_closed);
  EXPECT_NEAR(meshed.volume(), 8, 1e-9);
}

TEST(Dirty_shapes, a_face_without_boundary_is_left_out)
{
  BRep_Builder builder;
  TopoDS_Face empty;
  builder.MakeFace(empty, new Geom_Plane(gp_Pln()), 1e-7);
  const Meshed_shape meshed(compound_of({BRepPrimAPI_MakeBox(2, 2, 2).Shape(), empty}));
  ASSERT_EQ(meshed.shape.left_out.size(), 1u);
  EXPECT_EQ(meshed.shape.left_out[0].shape_face, 6u);
  EXPECT_TRUE(meshed.quality.is_closed);
}

TEST(Dirty_shapes, a_boundary_that_crosses_itself_is_left_out)
{
  const Handle(Geom_Surface) plane = new Geom_Plane(gp_Pln());
  const TopoDS_Face bow_tie = face_of(polygon({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}), plane);
  const Meshed_shape meshed(compound_of({BRepPrimAPI_MakeBox(gp_Pnt(3, 0, 0), 2, 2, 2).Shape(), bow_tie}));
  EXPECT_TRUE(meshed.shape.left_out.empty());
  ASSERT_EQ(meshed.report.left_out.size(), 1u);
  EXPECT_EQ(meshed.shape.shape_faces[meshed.report.left_out[0].face], 6u);
  EXPECT_NE(meshed.report.left_out[0].reason.find("crosses"), std::string::npos) << meshed.report.left_out[0].reason;
  EXPECT_TRUE(meshed.quality.is_closed);
  EXPECT_NEAR(meshed.volume(), 8, 1e-9);
}

TEST(Dirty_shapes, without_the_parameter_a_bad_face_is_an_error_that_names_it)
{
  const TopoDS_Face bow_tie = face_of(polygon({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}), new Geom_Plane(gp_Pln()));
  const auto shape
    = CGAL::make_model_of_open_cascade_shape(compound_of({BRepPrimAPI_MakeBox(gp_Pnt(3, 0, 0), 2, 2, 2).Shape(), bow_tie}));
  Mesh mesh;
  try {
    CGAL::make_parametric_surface_mesh(shape.model, cad_criteria(shape.diagonal), mesh);
    FAIL() << "no exception";
  }
  catch(const CGAL::Parametric_surface_mesh_error& error) {
    ASSERT_TRUE(error.face());
    EXPECT_EQ(*error.face(), 6u);
    EXPECT_EQ(mesh.number_of_faces(), 0u);
  }
}

TEST(Dirty_shapes, no_face_that_can_be_meshed_is_an_error)
{
  const TopoDS_Face bow_tie = face_of(polygon({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}), new Geom_Plane(gp_Pln()));
  EXPECT_THROW(Meshed_shape{bow_tie}, CGAL::Parametric_surface_mesh_error);
}

TEST(Dirty_shapes, tiny_edges_stay_watertight)
{
  // a prism whose polygon has an edge of 1e-5
  const TopoDS_Wire wire = polygon({{0, 0, 0}, {1, 0, 0}, {1, 0.5, 0}, {1 - 1e-5, 0.50001, 0}, {0, 1, 0}});
  const Meshed_shape meshed(BRepBuilderAPI_MakeFace(wire).Shape());
  EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 1u);
  EXPECT_NEAR(meshed.quality.area, 0.75, 1e-4);
}

TEST(Dirty_shapes, a_slit_is_no_boundary)
{
  // a square with a line into its inside, there and back
  const gp_Pnt a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0), m(0.5, 0.5, 0);
  const TopoDS_Vertex va = BRepBuilderAPI_MakeVertex(a), vb = BRepBuilderAPI_MakeVertex(b), vc = BRepBuilderAPI_MakeVertex(c),
                      vd = BRepBuilderAPI_MakeVertex(d), vm = BRepBuilderAPI_MakeVertex(m);
  const TopoDS_Edge slit = BRepBuilderAPI_MakeEdge(va, vm).Edge();
  BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  builder.Add(wire, slit);
  builder.Add(wire, slit.Reversed());
  builder.Add(wire, BRepBuilderAPI_MakeEdge(va, vb).Edge());
  builder.Add(wire, BRepBuilderAPI_MakeEdge(vb, vc).Edge());
  builder.Add(wire, BRepBuilderAPI_MakeEdge(vc, vd).Edge());
  builder.Add(wire, BRepBuilderAPI_MakeEdge(vd, va).Edge());
  const Meshed_shape meshed(face_of(wire, new Geom_Plane(gp_Pln())));
  EXPECT_TRUE(meshed.shape.left_out.empty());
  EXPECT_NEAR(meshed.quality.area, 1, 1e-10);
  EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 1u);
}

TEST(Dirty_shapes, faces_that_do_not_agree_about_the_outside_are_turned)
{
  const TopoDS_Shape solid = BRepPrimAPI_MakeBox(2, 2, 2).Shape();
  BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  bool is_first = true;
  for(TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next(), is_first = false)
    builder.Add(shell, is_first ? face.Current().Reversed() : face.Current());
  const Meshed_shape meshed(shell);
  EXPECT_GE(meshed.shape.number_of_reversed_faces, 1u);
  EXPECT_TRUE(meshed.quality.is_closed);
  EXPECT_NEAR(meshed.volume(), 8, 1e-9);
}

TEST(Dirty_shapes, cavities_stay_when_others_are_turned)
{
  const TopoDS_Shape hollow = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(4, 0, 0), 3, 3, 3).Shape(),
                                              BRepPrimAPI_MakeBox(gp_Pnt(5, 1, 1), 1, 1, 1).Shape()).Shape();
  BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for(TopExp_Explorer face(BRepPrimAPI_MakeBox(2, 2, 2).Shape(), TopAbs_FACE); face.More(); face.Next())
    builder.Add(shell, TopExp_Explorer(shell, TopAbs_FACE).More() ? face.Current() : face.Current().Reversed());
  const Meshed_shape meshed(compound_of({hollow, shell}));
  EXPECT_GE(meshed.shape.number_of_reversed_faces, 1u);
  EXPECT_TRUE(meshed.quality.is_closed);
  EXPECT_NEAR(meshed.volume(), 8 + 27 - 1, 1e-9);
}

// Faces along a ring that is turned over once; the last one ends where the first one begins, the other way round.
TEST(Dirty_shapes, a_shell_that_cannot_be_oriented_is_meshed)
{
  const int n = 5;
  std::vector<TopoDS_Vertex> sides[2];
  for(int side = 0; side < 2; ++side)
    for(int i = 0; i < n; ++i) {
      const double angle = 2 * CGAL_PI * i / n, turn = angle / 2, s = side == 0 ? 1 : -1;
      const double r = 10 + 2 * s * std::cos(turn);
      sides[side].push_back(BRepBuilderAPI_MakeVertex(gp_Pnt(r * std::cos(angle), r * std::sin(angle), 2 * s * std::sin(turn))));
    }
  std::vector<TopoDS_Edge> rungs;
  for(int i = 0; i < n; ++i)
    rungs.push_back(BRepBuilderAPI_MakeEdge(sides[0][i], sides[1][i]));
  rungs.push_back(TopoDS::Edge(rungs.front().Reversed()));
  BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for(int i = 0; i < n; ++i)
    builder.Add(shell, BRepFill::Face(rungs[i], rungs[i + 1]));
  const Meshed_shape meshed(shell);
  EXPECT_TRUE(meshed.shape.left_out.empty());
  EXPECT_TRUE(meshed.report.left_out.empty());
  EXPECT_EQ(meshed.shape.turned_edges.size(), 1u);
  EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 1u);
  EXPECT_EQ(meshed.quality.number_of_connected_components, 1u);
}

TEST(Dirty_shapes, faces_that_a_solid_has_too_are_meshed_once)
{
  std::vector<TopoDS_Shape> shapes{BRepPrimAPI_MakeBox(2, 2, 2).Shape()};
  for(TopExp_Explorer face(shapes.front(), TopAbs_FACE); face.More(); face.Next())
    shapes.push_back(face.Current());
  const Meshed_shape meshed(compound_of(shapes));
  EXPECT_TRUE(meshed.report.left_out.empty());
  EXPECT_EQ(meshed.shape.repeated_faces.size(), 6u);
  EXPECT_EQ(meshed.shape.model.faces().size(), 6u);
  EXPECT_TRUE(meshed.shape.is_shape_closed);
  EXPECT_TRUE(meshed.quality.is_closed);
  EXPECT_NEAR(meshed.volume(), 8, 1e-9);
}

TEST(Dirty_shapes, repair_changes_a_copy)
{
  const TopoDS_Face face = cylinder_face();
  remove_domain_curves(face);
  const TopoDS_Shape repaired = CGAL::repair_open_cascade_shape(face);
  EXPECT_EQ(CGAL::make_model_of_open_cascade_shape(repaired).number_of_rebuilt_curves, 0u);
  EXPECT_EQ(CGAL::make_model_of_open_cascade_shape(face).number_of_rebuilt_curves, 4u);
}

TEST(Dirty_shapes, an_empty_shape_is_refused)
{
  EXPECT_THROW(CGAL::make_model_of_open_cascade_shape(TopoDS_Shape()), CGAL::Parametric_surface_mesh_error);
  EXPECT_THROW(CGAL::make_model_of_open_cascade_shape(compound_of({})), CGAL::Parametric_surface_mesh_error);
}

TEST(Dirty_shapes, loose_faces_are_sewn)
{
  std::vector<TopoDS_Shape> faces;
  for(TopExp_Explorer face(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), TopAbs_FACE); face.More(); face.Next())
    faces.push_back(BRepBuilderAPI_Copy(face.Current()).Shape());
  const TopoDS_Shape loose = compound_of(faces);
  EXPECT_FALSE(Meshed_shape(loose).quality.is_closed);
  const CGAL::Sewn_open_cascade_shape sewn = CGAL::sew_open_cascade_shape(loose, 1e-5);
  EXPECT_EQ(sewn.number_of_sewn_edges, 12u);
  EXPECT_EQ(sewn.number_of_free_edges, 0u);
  EXPECT_EQ(sewn.number_of_lost_faces, 0u);
  const Meshed_shape meshed(sewn.shape);
  EXPECT_TRUE(meshed.quality.is_closed);
  EXPECT_NEAR(std::abs(meshed.volume()), 6, 1e-9);
  EXPECT_THROW(CGAL::sew_open_cascade_shape(loose, 0), CGAL::Parametric_surface_mesh_error);
}

// Two boxes that touch, and the open faces of a third one.
TEST(Dirty_shapes, solids_stay_solids_when_faces_are_sewn)
{
  std::vector<TopoDS_Shape> shapes{BRepPrimAPI_MakeBox(1, 1, 1).Shape(), BRepPrimAPI_MakeBox(gp_Pnt(1, 0, 0), 1, 1, 1).Shape()};
  for(TopExp_Explorer face(BRepPrimAPI_MakeBox(gp_Pnt(5, 0, 0), 1, 2, 3).Shape(), TopAbs_FACE); face.More(); face.Next())
    shapes.push_back(BRepBuilderAPI_Copy(face.Current()).Shape());
  const CGAL::Sewn_open_cascade_shape sewn = CGAL::sew_open_cascade_shape(compound_of(shapes), 1e-5);
  EXPECT_EQ(sewn.number_of_sewn_edges, 12u);
  EXPECT_EQ(sewn.number_of_lost_faces, 0u);
  std::size_t number_of_solids = 0;
  for(TopExp_Explorer solid(sewn.shape, TopAbs_SOLID); solid.More(); solid.Next())
    ++number_of_solids;
  EXPECT_EQ(number_of_solids, 2u);
  EXPECT_TRUE(Meshed_shape(sewn.shape).quality.is_closed);
}

TEST(Dirty_shapes, edges_inside_faces_are_named_and_followed)
{
  TopoDS_Face face = face_of(polygon({gp_Pnt(0, 0, 0), gp_Pnt(4, 0, 0), gp_Pnt(4, 4, 0), gp_Pnt(0, 4, 0)}), new Geom_Plane(gp_Pln()));
  const TopoDS_Shape scratch = BRepBuilderAPI_MakeEdge(gp_Pnt(1, 1, 0), gp_Pnt(3, 2, 0)).Edge();
  TopoDS_Wire wire;
  BRep_Builder builder;
  builder.MakeWire(wire);
  builder.Add(wire, scratch.Oriented(TopAbs_INTERNAL));
  builder.Add(face, wire);
  const Meshed_shape meshed(face);
  EXPECT_TRUE(meshed.shape.left_out.empty());
  ASSERT_EQ(meshed.shape.inner_edges.size(), 1u);
  EXPECT_EQ(meshed.shape.inner_edges[0].shape_face, 0u);
  EXPECT_EQ(meshed.shape.inner_edges[0].reason, "");
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(face, TopAbs_EDGE, edges);
  EXPECT_TRUE(edges(int(meshed.shape.inner_edges[0].shape_edge) + 1).IsSame(scratch));
  EXPECT_NEAR(meshed.quality.area, 16, 1e-9);
}

} // namespace
