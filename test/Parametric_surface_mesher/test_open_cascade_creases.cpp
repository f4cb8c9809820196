// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Creases inside of faces become edges of the mesh; faces and edges keep their numbers.
#include "open_cascade_test_helpers.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace {

// A roof of degree 2 in both directions: two slopes that meet in the line x = 1, z = 1. The knot there has this multiplicity.
TopoDS_Face roof(int multiplicity)
{
  const std::array<std::array<double, 2>, 5> profile = {{{0, 0}, {0.5, 0.5}, {1, 1}, {1.5, 0.5}, {2, 0}}}; // x and z
  const int n = multiplicity == 2 ? 5 : 4;
  TColgp_Array2OfPnt points(1, n, 1, 3);
  for(int i = 1; i <= n; ++i)
    for(int j = 1; j <= 3; ++j) {
      const auto& p = profile[std::size_t(n == 5 || i < 3 ? i - 1 : i)];
      points(i, j) = gp_Pnt(p[0], j - 1., p[1]);
    }
  TColStd_Array1OfReal u_knots(1, 3), v_knots(1, 2);
  TColStd_Array1OfInteger u_multiplicities(1, 3), v_multiplicities(1, 2);
  for(int i = 1; i <= 3; ++i) {
    u_knots(i) = i - 1;
    u_multiplicities(i) = i == 2 ? multiplicity : 3;
  }
  for(int i = 1; i <= 2; ++i) {
    v_knots(i) = i - 1;
    v_multiplicities(i) = 3;
  }
  const Handle(Geom_BSplineSurface) surface
    = new Geom_BSplineSurface(points, u_knots, v_knots, u_multiplicities, v_multiplicities, 2, 2);
  return BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
}

// a bar whose side is one face, extruded from a curve with three kinks and closed by a straight line
TopoDS_Shape bar_with_kinks()
{
  TColgp_Array1OfPnt points(1, 5);
  points(1) = gp_Pnt(0, 0, 0);
  points(2) = gp_Pnt(3, 0, 0);
  points(3) = gp_Pnt(4, 2, 0);
  points(4) = gp_Pnt(2, 3, 0);
  points(5) = gp_Pnt(0, 2, 0);
  TColStd_Array1OfReal knots(1, 5);
  TColStd_Array1OfInteger multiplicities(1, 5);
  for(int i = 1; i <= 5; ++i) {
    knots(i) = i;
    multiplicities(i) = i == 1 || i == 5 ? 2 : 1;
  }
  const Handle(Geom_BSplineCurve) curve = new Geom_BSplineCurve(points, knots, multiplicities, 1);
  BRepBuilderAPI_MakeWire outline(BRepBuilderAPI_MakeEdge(curve).Edge());
  outline.Add(BRepBuilderAPI_MakeEdge(points(5), points(1)).Edge());
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 5)).Shape();
}

// whether a triangle has corners on either side of the plane x = 1
bool is_crossed_by_crease(const Mesh& mesh, Mesh::Face_index f)
{
  bool has_left = false, has_right = false;
  for(const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
    has_left = has_left || mesh.point(v).x() < 1 - 1e-9;
    has_right = has_right || mesh.point(v).x() > 1 + 1e-9;
  }
  return has_left && has_right;
}

} // namespace

TEST(Creases, become_edges_of_the_mesh)
{
  const TopoDS_Face face = roof(2);
  const Meshed_shape meshed(face);
  EXPECT_EQ("ok", Cad_mesh_judge(face, meshed.judged())().text());
  EXPECT_GT(meshed.quality.min_angle, 30);
  for(const auto f : meshed.mesh.faces())
    EXPECT_FALSE(is_crossed_by_crease(meshed.mesh, f));
  EXPECT_EQ(1u, meshed.quality.number_of_connected_components);
  EXPECT_EQ(1u, meshed.quality.number_of_boundary_cycles);
  EXPECT_EQ(1u, meshed.shape.number_of_shape_faces);
  EXPECT_EQ((std::vector<std::size_t>{0, 0}), meshed.shape.shape_faces);
  EXPECT_EQ(4u, meshed.shape.number_of_shape_edges);
  std::size_t number_of_parts = 0;
  for(const auto& edges : meshed.shape.model_edges)
    number_of_parts += edges.size();
  EXPECT_EQ(6u, number_of_parts); // the two edges across the crease have two each
}

TEST(Creases, smooth_knots_are_none)
{
  EXPECT_EQ(1u, CGAL::make_model_of_open_cascade_shape(roof(1)).model.faces().size());
  for(const TopoDS_Shape& shape : {BRepPrimAPI_MakeCylinder(1, 2).Shape(), BRepPrimAPI_MakeTorus(3, 1).Shape()}) {
    const auto model = CGAL::make_model_of_open_cascade_shape(BRepBuilderAPI_NurbsConvert(shape).Shape());
    EXPECT_EQ(model.number_of_shape_faces, model.model.faces().size());
  }
}

TEST(Creases, of_an_extruded_curve)
{
  const TopoDS_Shape shape = bar_with_kinks();
  const Meshed_shape meshed(shape);
  EXPECT_EQ("ok", Cad_mesh_judge(shape, meshed.judged())().text());
  EXPECT_TRUE(meshed.quality.is_closed);
  EXPECT_GT(meshed.quality.min_angle, 25);
  EXPECT_EQ(4u, meshed.shape.number_of_shape_faces);
  EXPECT_EQ(7u, meshed.shape.model.faces().size());
  EXPECT_NEAR(45, meshed.volume(), 1e-9); // Open CASCADE integrates over the kinks, and finds 46
}
