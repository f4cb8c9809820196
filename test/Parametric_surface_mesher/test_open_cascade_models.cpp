// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shapes that Open CASCADE builds, meshed with the defaults of mesh_cad and judged by Open CASCADE.
#include "open_cascade_test_helpers.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BOPAlgo_Builder.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace {

const double pi = 4 * std::atan(1.);

// Meshes a solid: all faces, closed, well shaped, facing outward, with its volume.
void expect_good_solid(const TopoDS_Shape& shape, double smallest_angle = 20)
{
  const Meshed_shape meshed(shape);
  EXPECT_TRUE(meshed.shape.left_out.empty());
  EXPECT_TRUE(meshed.report.left_out.empty());
  EXPECT_TRUE(meshed.shape.is_shape_closed);
  EXPECT_TRUE(meshed.quality.is_closed);
  EXPECT_GE(meshed.quality.min_angle, smallest_angle);
  const Cad_mesh_verdict verdict = Cad_mesh_judge(shape, meshed.judged())();
  EXPECT_EQ(verdict.text(), "ok");
  EXPECT_LE(verdict.deviation, 1e-3);
  EXPECT_NEAR(meshed.volume(), volume_of(shape), 0.01 * volume_of(shape));
}

TopoDS_Shape box() { return BRepPrimAPI_MakeBox(10, 20, 30).Shape(); }

TopoDS_Shape drilled_box()
{
  const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5, 10, -1), gp_Dir(0, 0, 1)), 3, 40).Shape();
  return BRepAlgoAPI_Cut(box(), drill).Shape();
}

TEST(Open_cascade_models, box_is_meshed_exactly)
{
  const Meshed_shape meshed(box());
  EXPECT_EQ(meshed.shape.model.faces().size(), 6u);
  EXPECT_EQ(meshed.shape.model.edges().size(), 12u);
  EXPECT_EQ(meshed.shape.model.vertices().size(), 8u);
  EXPECT_NEAR(meshed.volume(), 6000, 1e-8);
  EXPECT_GE(meshed.quality.min_angle, 29.9);
  expect_good_solid(box());
}

TEST(Open_cascade_models, primitives)
{
  expect_good_solid(BRepPrimAPI_MakeCylinder(5, 20).Shape());
  expect_good_solid(BRepPrimAPI_MakeCone(5, 2, 10).Shape());
  expect_good_solid(BRepPrimAPI_MakeCone(5, 0, 10).Shape());
  expect_good_solid(BRepPrimAPI_MakeSphere(7).Shape());
  expect_good_solid(BRepPrimAPI_MakeTorus(10, 3).Shape());
}

TEST(Open_cascade_models, parts_of_primitives)
{
  expect_good_solid(BRepPrimAPI_MakeSphere(7, -0.5, 1, 4).Shape());
  expect_good_solid(BRepPrimAPI_MakeCylinder(5, 20, 2).Shape());
  expect_good_solid(BRepPrimAPI_MakeTorus(10, 3, 1.5).Shape());
}

TEST(Open_cascade_models, booleans)
{
  expect_good_solid(drilled_box());
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(10, 20, 30), 6).Shape();
  expect_good_solid(BRepAlgoAPI_Fuse(box(), ball).Shape(), 15);
  expect_good_solid(BRepAlgoAPI_Cut(box(), ball).Shape(), 15);
}

TEST(Open_cascade_models, fillets)
{
  const TopoDS_Shape sharp = box();
  BRepFilletAPI_MakeFillet fillet(sharp);
  for(TopExp_Explorer edge(sharp, TopAbs_EDGE); edge.More(); edge.Next())
    fillet.Add(2, TopoDS::Edge(edge.Current()));
  expect_good_solid(fillet.Shape());
}

TEST(Open_cascade_models, shells_have_an_inside)
{
  const TopoDS_Shape solid = box();
  TopTools_ListOfShape open;
  open.Append(TopExp_Explorer(solid, TopAbs_FACE).Current());
  BRepOffsetAPI_MakeThickSolid hollow;
  hollow.MakeThickSolidByJoin(solid, open, -1, 1e-3);
  expect_good_solid(hollow.Shape());
}

TEST(Open_cascade_models, lofts)
{
  BRepOffsetAPI_ThruSections loft(true, false);
  for(const double z : {0., 10., 15.}) {
    const gp_Circ circle(gp_Ax2(gp_Pnt(0.2 * z, 0, z), gp_Dir(0, 0, 1)), 5 - 0.2 * z);
    loft.AddWire(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge()).Wire());
  }
  expect_good_solid(loft.Shape());
}

TEST(Open_cascade_models, nurbs_of_primitives)
{
  expect_good_solid(BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(10, 3).Shape()).Shape());
  expect_good_solid(BRepBuilderAPI_NurbsConvert(drilled_box()).Shape());
}

TEST(Open_cascade_models, surfaces_that_the_kernel_evaluates)
{
  const Handle(Geom_TrimmedCurve) arc = GC_MakeArcOfCircle(gp_Pnt(5, 0, 0), gp_Pnt(8, 0, 3), gp_Pnt(6, 0, 7)).Value();
  const TopoDS_Edge profile = BRepBuilderAPI_MakeEdge(arc).Edge();
  const TopoDS_Shape vase = BRepPrimAPI_MakeRevol(profile, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 1.5 * pi).Shape();
  const Meshed_shape meshed(vase);
  EXPECT_FALSE(meshed.quality.is_closed);
  EXPECT_GE(meshed.quality.min_angle, 25);
  EXPECT_EQ(Cad_mesh_judge(vase, meshed.judged())().text(), "ok");
}

TEST(Open_cascade_models, offset_surface)
{
  const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(gp_Ax3(), 5);
  const Handle(Geom_Surface) offset = new Geom_OffsetSurface(sphere, 1.5);
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(offset, 0.5, 2., -0.7, 0.8, 1e-6).Shape();
  const Meshed_shape meshed(face);
  EXPECT_GE(meshed.quality.min_angle, 25);
  for(const auto v : meshed.mesh.vertices())
    EXPECT_NEAR(std::sqrt((meshed.mesh.point(v) - CGAL::ORIGIN).squared_length()), 6.5, 1e-9);
}

TEST(Open_cascade_models, locations_of_assemblies)
{
  const TopoDS_Shape part = drilled_box();
  BRep_Builder builder;
  TopoDS_Compound assembly;
  builder.MakeCompound(assembly);
  for(int i = 0; i < 3; ++i) {
    gp_Trsf move, turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 1, 0)), 0.4 * i);
    move.SetTranslation(gp_Vec(40 * i, 0, 0));
    builder.Add(assembly, part.Moved(TopLoc_Location(move * turn)));
  }
  expect_good_solid(assembly);
  EXPECT_EQ(Meshed_shape(assembly).quality.number_of_connected_components, 3u);
}

TEST(Open_cascade_models, reversed_solid_faces_inward)
{
  const Meshed_shape meshed(BRepPrimAPI_MakeSphere(7).Shape().Reversed());
  EXPECT_TRUE(meshed.quality.is_closed);
  EXPECT_LT(meshed.volume(), 0);
}

TEST(Open_cascade_models, a_face_between_two_solids_is_in_both_shells)
{
  BOPAlgo_Builder fuse;
  fuse.AddArgument(BRepPrimAPI_MakeBox(10, 10, 10).Shape());
  fuse.AddArgument(BRepPrimAPI_MakeBox(gp_Pnt(10, 2, 2), 10, 5, 5).Shape());
  fuse.Perform();
  const Meshed_shape meshed(fuse.Shape());
  EXPECT_EQ(meshed.shape.shape_faces.size(), meshed.shape.number_of_shape_faces + 1);
  EXPECT_TRUE(meshed.shape.is_shape_closed);
  EXPECT_TRUE(meshed.quality.is_closed);
  EXPECT_EQ(meshed.quality.number_of_connected_components, 2u);
  EXPECT_NEAR(meshed.volume(), 1250, 1e-8);
}

TEST(Open_cascade_models, free_faces_and_edges)
{
  const Meshed_shape meshed(compound_of({BRepBuilderAPI_MakeFace(gp_Pln(), 0., 3., 0., 2.).Shape(),
                                         BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 5), gp_Pnt(1, 0, 5)).Shape()}));
  EXPECT_FALSE(meshed.shape.is_shape_closed);
  EXPECT_EQ(meshed.quality.number_of_boundary_cycles, 1u);
  EXPECT_NEAR(meshed.quality.area, 6, 1e-10);
}

TEST(Open_cascade_models, shape_is_not_changed_and_mesh_is_the_same_again)
{
  const TopoDS_Shape shape = drilled_box();
  const Judged_mesh first = Meshed_shape(shape).judged(), second = Meshed_shape(shape).judged();
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.triangles, second.triangles);
  EXPECT_EQ(first.face_ids, second.face_ids);
}

TEST(Open_cascade_models, sizes_of_single_faces_and_edges)
{
  CGAL::Open_cascade_model_3 shape = CGAL::make_model_of_open_cascade_shape(box());
  shape.model.faces()[0].max_edge = 0.3;
  Mesh mesh;
  const auto patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;
  CGAL::make_parametric_surface_mesh(shape.model, cad_criteria(shape.diagonal), mesh, CGAL::parameters::face_patch_id_map(patch));
  double longest = 0;
  for(const auto f : mesh.faces())
    if(patch[f] == 0)
      for(const auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
        longest = (std::max)(longest, CGAL::to_double(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)))));
  EXPECT_LE(std::sqrt(longest), 0.6);
  EXPECT_GE(CGAL::triangle_mesh_quality(mesh).min_angle, 20);

  shape.model.faces()[0].max_edge = 0;
  shape.model.set_sizing_field([](const Kernel::Point_3& p) { return p.z() > 20 ? 0.5 : 2.; });
  Mesh graded;
  CGAL::make_parametric_surface_mesh(shape.model, cad_criteria(shape.diagonal), graded);
  std::size_t above = 0, below = 0;
  for(const auto v : graded.vertices())
    ++(graded.point(v).z() > 20 ? above : below);
  EXPECT_GT(above, 2 * below);
}

} // namespace
