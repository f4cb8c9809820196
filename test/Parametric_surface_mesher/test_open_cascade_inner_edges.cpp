// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edges and vertices inside faces of shapes, and points and curves that are put on them: the mesh follows them.
#include "open_cascade_test_helpers.h"

#include <CGAL/imprint_on_open_cascade_shape.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

namespace psm = CGAL::Parametric_surface_mesher;

TopoDS_Shape segment(const gp_Pnt& p, const gp_Pnt& q) { return BRepBuilderAPI_MakeEdge(p, q).Edge(); }

TopoDS_Shape circle(const gp_Pnt& center, const gp_Dir& axis, double radius)
{
  return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(center, axis), radius)).Edge();
}

// a square of side 4 with edges and vertices inside, whatever these are
TopoDS_Face square_with(const std::vector<TopoDS_Shape>& edges, const std::vector<TopoDS_Shape>& vertices = {})
{
  TopoDS_Face result = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4).Face();
  BRep_Builder builder;
  for(const TopoDS_Shape& edge : edges) {
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    builder.Add(wire, edge.Oriented(TopAbs_INTERNAL));
    builder.Add(result, wire);
  }
  for(const TopoDS_Shape& vertex : vertices)
    builder.Add(result, vertex.Oriented(TopAbs_INTERNAL));
  return result;
}

struct Placed_shape
{
  CGAL::Open_cascade_model_3 shape;
  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, psm::Edge_place> places = mesh.add_property_map<Mesh::Edge_index, psm::Edge_place>("e:place").first;
  CGAL::Parametric_surface_mesh_report report;

  explicit Placed_shape(const TopoDS_Shape& s) : shape(CGAL::make_model_of_open_cascade_shape(s))
  {
    namespace params = CGAL::parameters;
    report = CGAL::make_parametric_surface_mesh(shape.model, cad_criteria(shape.diagonal), mesh,
                                                params::edge_place_map(places, params::leaves_out_bad_faces(true)));
    EXPECT_TRUE(shape.left_out.empty());
    EXPECT_TRUE(report.left_out.empty());
    EXPECT_TRUE(mesh.is_valid(false));
  }

  // The length of the edges of the mesh inside it that lie on a curve: they are edges of the model, with both ends on the curve.
  double length_on(const TopoDS_Shape& curve) const
  {
    double result = 0;
    for(const auto e : mesh.edges()) {
      if(mesh.is_border(e) || places[e].index == psm::Edge_place::none)
        continue;
      const Kernel::Point_3 p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
      if(is_on(p, curve) && is_on(q, curve))
        result += std::sqrt(CGAL::squared_distance(p, q));
    }
    return result;
  }

  static bool is_on(const Kernel::Point_3& p, const TopoDS_Shape& curve)
  {
    return BRepExtrema_DistShapeShape(BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), p.z())).Vertex(), curve).Value() < 1e-5;
  }

  bool has_vertex_at(double x, double y, double z) const
  {
    for(const auto v : mesh.vertices())
      if(CGAL::squared_distance(mesh.point(v), Kernel::Point_3(x, y, z)) < 1e-12)
        return true;
    return false;
  }
};

TEST(Inner_edges_of_shape, are_followed)
{
  const TopoDS_Shape line = segment(gp_Pnt(1, 1, 0), gp_Pnt(3, 2, 0)), ring = circle(gp_Pnt(1, 3, 0), gp_Dir(0, 0, 1), 0.5);
  const Placed_shape placed(square_with({line, ring}, {BRepBuilderAPI_MakeVertex(gp_Pnt(3, 3, 0)).Vertex()}));
  ASSERT_EQ(placed.shape.inner_edges.size(), 2u);
  ASSERT_EQ(placed.shape.inner_vertices.size(), 1u);
  for(const auto& edge : placed.shape.inner_edges)
    EXPECT_EQ(edge.reason, "");
  EXPECT_EQ(placed.shape.inner_vertices[0].reason, "");
  EXPECT_NEAR(placed.length_on(line), std::sqrt(5), 1e-9);
  EXPECT_NEAR(placed.length_on(ring), std::acos(-1.), 0.1);
  EXPECT_TRUE(placed.has_vertex_at(3, 3, 0));
  EXPECT_NEAR(CGAL::triangle_mesh_quality(placed.mesh).area, 16, 1e-9);
  EXPECT_GT(placed.report.smallest_angle, 25);
}

// A short edge inside a circle, as close to it as the 32nd part of the circle is to its chord.
TEST(Inner_edges_of_shape, beside_a_curve)
{
  const double angle = std::acos(-1.) / 32, c = std::cos(angle), s = std::sin(angle);
  const TopoDS_Shape ring = circle(gp_Pnt(2, 2, 0), gp_Dir(0, 0, 1), 1),
                     line = segment(gp_Pnt(2 + 0.998 * c + 0.01 * s, 2 + 0.998 * s - 0.01 * c, 0), gp_Pnt(2 + 0.998 * c - 0.01 * s, 2 + 0.998 * s + 0.01 * c, 0));
  const Placed_shape placed(square_with({ring, line}));
  for(const auto& edge : placed.shape.inner_edges)
    EXPECT_EQ(edge.reason, "");
  EXPECT_NEAR(placed.length_on(line), 0.02, 1e-6);
}

// The face is meshed as if they were not there, and they are named.
TEST(Inner_edges_of_shape, that_do_not_fit_are_named)
{
  const TopoDS_Shape good = segment(gp_Pnt(1, 1, 0), gp_Pnt(3, 2, 0));
  const Placed_shape placed(square_with({segment(gp_Pnt(3, 3, 0), gp_Pnt(5, 3, 0)), segment(gp_Pnt(5, 1, 0), gp_Pnt(6, 2, 0)), good,
                                         segment(gp_Pnt(1, 2, 0), gp_Pnt(3, 1, 0)), segment(gp_Pnt(1, 3, 1), gp_Pnt(2, 3, 1)),
                                         segment(gp_Pnt(1, 3.5, 0), gp_Pnt(2, 4, 0))},
                                        {BRepBuilderAPI_MakeVertex(gp_Pnt(2, 1.5, 0)).Vertex(), BRepBuilderAPI_MakeVertex(gp_Pnt(9, 1, 0)).Vertex()}));
  ASSERT_EQ(placed.shape.inner_edges.size(), 6u);
  for(std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(placed.shape.inner_edges[i].reason.empty(), i == 2) << i << placed.shape.inner_edges[i].reason;
  ASSERT_EQ(placed.shape.inner_vertices.size(), 2u);
  for(const auto& vertex : placed.shape.inner_vertices)
    EXPECT_NE(vertex.reason, "");
  EXPECT_NEAR(placed.length_on(good), std::sqrt(5), 1e-9);
  EXPECT_NEAR(CGAL::triangle_mesh_quality(placed.mesh).area, 16, 1e-9);
}

// The parameters that a projection finds are a period away from those of the face.
TEST(Inner_edges_of_shape, a_vertex_on_a_cylinder)
{
  for(double u : {-7., -1., 0., 6., 12.}) {
    TopoDS_Face face = BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(), 2), u, u + 2, 0, 3, 1e-7).Face();
    BRep_Builder().Add(face, BRepBuilderAPI_MakeVertex(gp_Pnt(2 * std::cos(u + 0.7), 2 * std::sin(u + 0.7), 1)).Vertex().Oriented(TopAbs_INTERNAL));
    const Placed_shape placed(face);
    ASSERT_EQ(placed.shape.inner_vertices.size(), 1u);
    EXPECT_EQ(placed.shape.inner_vertices[0].reason, "") << u;
    EXPECT_TRUE(placed.has_vertex_at(2 * std::cos(u + 0.7), 2 * std::sin(u + 0.7), 1)) << u;
  }
}

// A point above a face, one beside an edge; a line on a face, one across an edge into the next face; and a circle.
TEST(Imprint, of_points_and_curves_is_followed)
{
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 4, 4).Shape();
  const TopoDS_Shape curves = compound_of({segment(gp_Pnt(1, 1, 4), gp_Pnt(3, 2, 4)), segment(gp_Pnt(2, 3, 4.05), gp_Pnt(3.5, 3, 4.1)),
                                           circle(gp_Pnt(2, 2, 0), gp_Dir(0, 0, 1), 1)});
  const auto imprinted = CGAL::imprint_on_open_cascade_shape(box, {gp_Pnt(1, 3, 4.125), gp_Pnt(4, 0, 1), gp_Pnt(0, 2, 2)}, curves, 0.2);
  EXPECT_NEAR(imprinted.points[0].distance, 0.125, 1e-9);
  EXPECT_EQ(imprinted.points[0].shapes.size(), 1u);
  EXPECT_EQ(imprinted.points[1].shapes.size(), 1u);
  EXPECT_EQ(imprinted.curves[0].shapes.size(), 1u);
  EXPECT_NEAR(imprinted.points[1].distance, 0, 1e-9);
  EXPECT_NEAR(imprinted.curves[0].distance, 0, 1e-6);
  EXPECT_NEAR(imprinted.curves[1].distance, 0.1, 0.01);
  EXPECT_NEAR(imprinted.curves[1].projected_length, 1.5, 1e-6);
  const Placed_shape placed(imprinted.shape);
  EXPECT_TRUE(CGAL::is_closed(placed.mesh));
  EXPECT_NEAR(CGAL::Polygon_mesh_processing::volume(placed.mesh), 64, 1e-9);
  EXPECT_NEAR(placed.length_on(segment(gp_Pnt(1, 1, 4), gp_Pnt(3, 2, 4))), std::sqrt(5), 1e-9);
  EXPECT_NEAR(placed.length_on(segment(gp_Pnt(2, 3, 4), gp_Pnt(3.5, 3, 4))), 1.5, 1e-6);
  EXPECT_NEAR(placed.length_on(circle(gp_Pnt(2, 2, 0), gp_Dir(0, 0, 1), 1)), 2 * std::acos(-1.), 0.05);
  EXPECT_TRUE(placed.has_vertex_at(1, 3, 4));
  EXPECT_TRUE(placed.has_vertex_at(4, 0, 1));
  EXPECT_TRUE(placed.has_vertex_at(0, 2, 2));
}

// On a cylinder across the seam and onto the lid, and around a sphere.
TEST(Imprint, runs_across_edges_and_seams)
{
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1, 3).Shape();
  const auto on_cylinder = CGAL::imprint_on_open_cascade_shape(
    cylinder, {}, compound_of({segment(gp_Pnt(1, -0.5, 1), gp_Pnt(1, 0.5, 2)), segment(gp_Pnt(0, 0.2, 3), gp_Pnt(0, 1.0, 3))}), 0.3);
  const Placed_shape placed(on_cylinder.shape);
  EXPECT_TRUE(CGAL::is_closed(placed.mesh));
  double length = 0;
  for(const auto e : placed.mesh.edges())
    if(placed.places[e].index != psm::Edge_place::none) {
      const auto middle = CGAL::midpoint(placed.mesh.point(placed.mesh.vertex(e, 0)), placed.mesh.point(placed.mesh.vertex(e, 1)));
      if(middle.x() > 0.8 && std::fabs(middle.y() - (middle.z() - 1.5)) < 0.12 && std::fabs(middle.y()) > 1e-3 && middle.z() < 2.1)
        length += std::sqrt(CGAL::squared_distance(placed.mesh.point(placed.mesh.vertex(e, 0)), placed.mesh.point(placed.mesh.vertex(e, 1))));
    }
  EXPECT_NEAR(length, on_cylinder.curves[0].projected_length, 0.05);
  EXPECT_NEAR(placed.length_on(segment(gp_Pnt(0, 0.2, 3), gp_Pnt(0, 1, 3))), 0.8, 1e-6);

  const TopoDS_Shape equator = circle(gp_Pnt(0, 0, 0), gp_Dir(0.3, 0.2, 1), 1.05);
  const auto on_sphere = CGAL::imprint_on_open_cascade_shape(BRepPrimAPI_MakeSphere(1).Shape(), {gp_Pnt(0, 0, 1.1), gp_Pnt(0, -1.1, 0)}, equator, 0.2);
  const Placed_shape sphere(on_sphere.shape);
  EXPECT_TRUE(CGAL::is_closed(sphere.mesh));
  EXPECT_NEAR(on_sphere.curves[0].distance, 0.05, 1e-3);
  EXPECT_TRUE(sphere.has_vertex_at(0, -1, 0));
}

// The back of a thin plate is close to the line, too.
TEST(Imprint, is_in_front_of_a_plate)
{
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(4, 4, 0.1).Shape();
  for(double z : {0.1, 0.15, 0.3}) {
    const auto imprinted = CGAL::imprint_on_open_cascade_shape(plate, {gp_Pnt(3, 3, z)}, segment(gp_Pnt(1, 1, z), gp_Pnt(2, 3, z)), 0.5);
    EXPECT_NEAR(imprinted.curves[0].distance, z - 0.1, 1e-6);
    EXPECT_NEAR(imprinted.curves[0].projected_length, std::sqrt(5), 1e-6);
    const Placed_shape placed(imprinted.shape);
    EXPECT_EQ(placed.shape.inner_edges.size(), 1u);
    EXPECT_NEAR(placed.length_on(segment(gp_Pnt(1, 1, 0.1), gp_Pnt(2, 3, 0.1))), std::sqrt(5), 1e-6);
    EXPECT_TRUE(placed.has_vertex_at(3, 3, 0.1));
  }
}

// A line through a block is projected onto the side that is closer to it.
TEST(Imprint, is_on_the_closest_face)
{
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(4, 4, 1).Shape();
  const auto imprinted = CGAL::imprint_on_open_cascade_shape(plate, {}, segment(gp_Pnt(1, 1, 0.8), gp_Pnt(3, 2, 0.9)), 2);
  EXPECT_NEAR(imprinted.curves[0].distance, 0.2, 0.02);
  EXPECT_NEAR(imprinted.curves[0].projected_length, std::sqrt(5), 1e-6);
}

TEST(Imprint, is_refused_far_from_the_faces)
{
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 4, 4).Shape();
  EXPECT_THROW(CGAL::imprint_on_open_cascade_shape(box, {gp_Pnt(1, 3, 5)}, TopoDS_Shape(), 0.5), CGAL::Parametric_surface_mesh_error);
  EXPECT_THROW(CGAL::imprint_on_open_cascade_shape(box, {}, segment(gp_Pnt(1, 1, 5), gp_Pnt(3, 1, 5)), 0.5), CGAL::Parametric_surface_mesh_error);
  EXPECT_THROW(CGAL::imprint_on_open_cascade_shape(box, {}, TopoDS_Shape(), 0), CGAL::Parametric_surface_mesh_error);
  EXPECT_TRUE(CGAL::imprint_on_open_cascade_shape(box, {}, TopoDS_Shape(), 1).shape.IsSame(box));
}

} // namespace
