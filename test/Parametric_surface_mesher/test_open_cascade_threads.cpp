// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces that Open CASCADE evaluates, meshed by several threads: always the mesh that one thread gives.
#include <gtest/gtest.h>

#include <check_invariants.h>

#include "open_cascade_test_helpers.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax1.hxx>

#include <tbb/global_control.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

// of many spans, in the plane y = 0
Handle(Geom_BSplineCurve) wavy_curve()
{
  TColgp_Array1OfPnt points(1, 25);
  for(int i = 1; i <= 25; ++i)
    points(i) = gp_Pnt(3 + 0.3 * std::sin(0.9 * i), 0, 0.25 * i);
  return GeomAPI_PointsToBSpline(points).Curve();
}

Handle(Geom_BSplineSurface) wavy_surface()
{
  TColgp_Array2OfPnt points(1, 15, 1, 15);
  for(int i = 1; i <= 15; ++i)
    for(int j = 1; j <= 15; ++j)
      points(i, j) = gp_Pnt(0.4 * i, 0.4 * j, 0.3 * std::sin(0.8 * i) * std::cos(0.7 * j));
  return GeomAPI_PointsToBSplineSurface(points, 3, 3, GeomAbs_C2, 0.01).Surface();
}

// two faces on one surface, with a gap between them, and their images by a location
TopoDS_Shape four_faces(const Handle(Geom_Surface) & surface, double u_min, double u_max, double v_min, double v_max)
{
  BRep_Builder builder;
  TopoDS_Compound result;
  builder.MakeCompound(result);
  gp_Trsf shift;
  shift.SetTranslation(gp_Vec(0, 0, 20));
  const double u1 = u_min + 0.45 * (u_max - u_min), u2 = u_min + 0.55 * (u_max - u_min);
  for(const auto& u : {std::make_pair(u_min, u1), std::make_pair(u2, u_max)}) {
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, u.first, u.second, v_min, v_max, 1e-7);
    builder.Add(result, face);
    builder.Add(result, face.Moved(TopLoc_Location(shift)));
  }
  return result;
}

void check_ten_runs(const Handle(Geom_Surface) & surface, double u_min, double u_max, double v_min, double v_max)
{
  const auto shape = CGAL::make_model_of_open_cascade_shape(four_faces(surface, u_min, u_max, v_min, v_max));
  ASSERT_EQ(4u, shape.model.faces().size());
  for(const auto& face : shape.model.faces())
    ASSERT_TRUE(face.surface.is_evaluated_by_open_cascade());
  const auto criteria = CGAL::Parametric_surface_mesh_criteria().set_max_edge(shape.diagonal / 60).set_gamma(0.3).set_part_size(100);
  Mesh sequential;
  CGAL::make_parametric_surface_mesh(shape.model, criteria, sequential);
  ASSERT_GT(sequential.number_of_faces(), 8 * 100u);
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 4);
  for(int run = 0; run < 10; ++run) {
    SCOPED_TRACE(run);
    Mesh parallel;
    CGAL::make_parametric_surface_mesh<CGAL::Parallel_tag>(shape.model, criteria, parallel);
    ASSERT_EQ(sequential.number_of_vertices(), parallel.number_of_vertices());
    ASSERT_EQ(sequential.number_of_faces(), parallel.number_of_faces());
    check_identical_connectivity(sequential, parallel);
    for(const auto v : sequential.vertices())
      ASSERT_EQ(sequential.point(v), parallel.point(v));
  }
}

} // namespace

TEST(Threads_and_open_cascade, offset_faces)
{
  const Handle(Geom_Surface) offset = new Geom_OffsetSurface(wavy_surface(), 0.1);
  double u_min, u_max, v_min, v_max;
  offset->Bounds(u_min, u_max, v_min, v_max);
  check_ten_runs(offset, u_min, u_max, v_min, v_max);
}

TEST(Threads_and_open_cascade, faces_of_revolution)
{
  const auto curve = wavy_curve();
  check_ten_runs(new Geom_SurfaceOfRevolution(curve, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))), 0, 3, curve->FirstParameter(),
                 curve->LastParameter());
}

TEST(Threads_and_open_cascade, extruded_faces)
{
  const auto curve = wavy_curve();
  check_ten_runs(new Geom_SurfaceOfLinearExtrusion(curve, gp_Dir(0, 1, 0)), curve->FirstParameter(), curve->LastParameter(), 0, 4);
}

// What a surface remembers of its evaluation stays with one copy.
TEST(Threads_and_open_cascade, copies_have_surfaces_of_their_own)
{
  const auto shape = CGAL::make_model_of_open_cascade_shape(four_faces(new Geom_OffsetSurface(wavy_surface(), 0.1), 0, 1, 0, 1));
  const CGAL::Open_cascade_surface_3& surface = shape.model.faces().front().surface;
  const CGAL::Open_cascade_surface_3 copy = surface;
  for(const double u : {0.1, 0.13, 0.3, 0.35, 0.9}) {
    EXPECT_EQ(surface.point(u, 0.2), copy.point(u, 0.2));
    EXPECT_EQ(surface.jet(u, 0.2).duv, copy.jet(u, 0.2).duv);
  }
}
