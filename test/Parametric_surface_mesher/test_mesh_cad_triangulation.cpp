// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes that are written onto shapes: Open CASCADE finds them whole, and uses them in place of its own.
#include "program_test.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

class Mesh_cad_triangulation : public Program_test
{
protected:
  Mesh_cad_triangulation() : Program_test(MESH_CAD_PROGRAM) {}

  // The shape as it comes back, with its mesh on it.
  TopoDS_Shape meshed(const TopoDS_Shape& shape, const std::string& options = "") const
  {
    BRepTools::Write(shape, file("shape.brep").c_str());
    const Result result = run("shape.brep --quiet --out meshed.brep " + options);
    EXPECT_EQ(result.status, 0) << result.err;
    TopoDS_Shape back;
    BRepTools::Read(back, file("meshed.brep").c_str(), BRep_Builder());
    return back;
  }
};

Handle(Poly_Triangulation) triangulation_of(const TopoDS_Shape& face)
{
  TopLoc_Location location;
  return BRep_Tool::Triangulation(TopoDS::Face(face), location);
}

std::vector<TopoDS_Shape> all(const TopoDS_Shape& shape, TopAbs_ShapeEnum type)
{
  TopTools_IndexedMapOfShape shapes;
  TopExp::MapShapes(shape, type, shapes);
  std::vector<TopoDS_Shape> result;
  for(int i = 1; i <= shapes.Extent(); ++i)
    result.push_back(shapes(i));
  return result;
}

// Nodes are where the surface has their parameters, and triangles face to the side of the surface.
void expect_on_surface(const TopoDS_Face& face, double tolerance)
{
  const Handle(Poly_Triangulation) mesh = triangulation_of(face);
  ASSERT_FALSE(mesh.IsNull());
  ASSERT_TRUE(mesh->HasUVNodes());
  const BRepAdaptor_Surface surface(face, false);
  const gp_Trsf place = face.Location().Transformation();
  for(int i = 1; i <= mesh->NbNodes(); ++i) {
    const gp_Pnt2d uv = mesh->UVNode(i);
    EXPECT_LT(surface.Value(uv.X(), uv.Y()).Distance(mesh->Node(i).Transformed(place)), tolerance);
  }
  for(int i = 1; i <= mesh->NbTriangles(); ++i) {
    int a = 0, b = 0, c = 0;
    mesh->Triangle(i).Get(a, b, c);
    const gp_Vec2d p(mesh->UVNode(a), mesh->UVNode(b)), q(mesh->UVNode(a), mesh->UVNode(c));
    EXPECT_GT(p ^ q, 0);
  }
}

std::vector<std::tuple<double, double, double>> points_along(const TopoDS_Edge& edge, const TopoDS_Face& face)
{
  const Handle(Poly_Triangulation) mesh = triangulation_of(face);
  const Handle(Poly_PolygonOnTriangulation) polygon = BRep_Tool::PolygonOnTriangulation(edge, mesh, face.Location());
  std::vector<std::tuple<double, double, double>> result;
  if(polygon.IsNull())
    return result;
  for(int i = 1; i <= polygon->Nodes().Length(); ++i) {
    const gp_Pnt p = mesh->Node(polygon->Nodes()(i)).Transformed(face.Location().Transformation());
    result.emplace_back(p.X(), p.Y(), p.Z());
  }
  return result;
}

// Whether one parameter has no meaning there, as the longitude at a pole.
bool is_pole(const TopoDS_Face& face, const gp_Pnt2d& uv)
{
  gp_Pnt p;
  gp_Vec du, dv;
  BRepAdaptor_Surface(face, false).D1(uv.X(), uv.Y(), p, du, dv);
  return du.Magnitude() < 1e-6;
}

// All faces have an edge's nodes at the same points, in the direction of the edge and beside its curves in their domains.
void expect_fitting_edges(const TopoDS_Shape& shape)
{
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edges;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edges);
  for(int e = 1; e <= faces_of_edges.Extent(); ++e) {
    const TopoDS_Edge edge = TopoDS::Edge(faces_of_edges.FindKey(e).Oriented(TopAbs_FORWARD));
    std::vector<std::tuple<double, double, double>> first;
    for(const TopoDS_Shape& shape_of_face : faces_of_edges(e))
      for(const TopAbs_Orientation orientation : {TopAbs_FORWARD, TopAbs_REVERSED}) {
        const TopoDS_Face face = TopoDS::Face(shape_of_face.Oriented(TopAbs_FORWARD));
        const TopoDS_Edge use = TopoDS::Edge(edge.Oriented(orientation));
        const auto points = points_along(use, face);
        ASSERT_GE(points.size(), 2u);
        if(first.empty())
          first = points;
        if(!BRep_Tool::Degenerated(edge)) {
          EXPECT_EQ(points, first);
        }
        const Handle(Poly_Triangulation) mesh = triangulation_of(face);
        const auto polygon = BRep_Tool::PolygonOnTriangulation(use, mesh, face.Location());
        double begin = 0, end = 0;
        const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(use, face, begin, end);
        for(int i = 1; i <= polygon->Nodes().Length() && !BRep_Tool::Degenerated(edge); ++i) {
          const gp_Pnt2d uv = mesh->UVNode(polygon->Nodes()(i));
          if(!is_pole(face, uv)) {
            EXPECT_LT(uv.Distance(curve->Value(polygon->Parameters()->Value(i))), 1e-6);
          }
        }
      }
  }
}

std::size_t number_of_triangles(const TopoDS_Shape& shape)
{
  std::size_t result = 0;
  for(const TopoDS_Shape& face : all(shape, TopAbs_FACE))
    result += std::size_t(triangulation_of(face)->NbTriangles());
  return result;
}

// The mesher of Open CASCADE finds nothing to do.
void expect_kept(const TopoDS_Shape& shape, double deflection)
{
  EXPECT_TRUE(BRepTools::Triangulation(shape, deflection));
  const std::size_t before = number_of_triangles(shape);
  BRepMesh_IncrementalMesh(shape, deflection);
  EXPECT_EQ(number_of_triangles(shape), before);
}

TEST_F(Mesh_cad_triangulation, fits_all_kinds_of_faces)
{
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 8, 6);
  const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5, 4, -1), gp_Dir(0, 0, 1)), 2, 8);
  BRepFilletAPI_MakeFillet rounded(box);
  for(const TopoDS_Shape& edge : all(box, TopAbs_EDGE))
    rounded.Add(1, TopoDS::Edge(edge));
  const std::vector<TopoDS_Shape> shapes{BRepAlgoAPI_Cut(box, drill).Shape(), BRepPrimAPI_MakeSphere(3).Shape(),
                                         BRepPrimAPI_MakeTorus(5, 1).Shape(), BRepPrimAPI_MakeCone(3, 0, 5).Shape(), rounded.Shape()};
  for(std::size_t i = 0; i < shapes.size(); ++i) {
    SCOPED_TRACE("shape " + std::to_string(i));
    const TopoDS_Shape shape = meshed(shapes[i], "--max-edge 1");
    for(const TopoDS_Shape& face : all(shape, TopAbs_FACE))
      expect_on_surface(TopoDS::Face(face), 1e-6);
    expect_fitting_edges(shape);
    expect_kept(shape, 0.05);
  }
}

// A part that is there twice has one triangulation, in its own place.
TEST_F(Mesh_cad_triangulation, is_in_the_place_of_the_face)
{
  const TopoDS_Shape bolt = BRepPrimAPI_MakeCylinder(1, 3);
  gp_Trsf turn, move;
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0)), 0.7);
  move.SetTranslation(gp_Vec(10, 0, 0));
  TopoDS_Compound both;
  BRep_Builder().MakeCompound(both);
  BRep_Builder().Add(both, bolt.Moved(TopLoc_Location(turn)));
  BRep_Builder().Add(both, bolt.Moved(TopLoc_Location(move)));
  const TopoDS_Shape shape = meshed(both);
  const auto faces = all(shape, TopAbs_FACE);
  ASSERT_EQ(faces.size(), 6u);
  for(const TopoDS_Shape& face : faces)
    expect_on_surface(TopoDS::Face(face), 1e-6);
  expect_fitting_edges(shape);
  EXPECT_TRUE(BRepTools::Triangulation(shape, 0.05));
}

} // namespace
