// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Detail that is much smaller than the tolerance vanishes from the mesh, and is reported.
#include "open_cascade_test_helpers.h"

#include <CGAL/make_parametric_surface_triangle_soup.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BOPAlgo_Builder.hxx>
#include <gp_Ax2.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace {

// a bar with a step of this height across its top
TopoDS_Shape stepped_bar(double step, double depth = 20)
{
  BRepBuilderAPI_MakePolygon outline;
  for(const gp_Pnt& p : {gp_Pnt(0, 0, 0), gp_Pnt(60, 0, 0), gp_Pnt(60, 0, 10), gp_Pnt(25, 0, 10), gp_Pnt(25, 0, 10 + step),
                         gp_Pnt(0, 0, 10 + step)})
    outline.Add(p);
  outline.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, depth, 0)).Shape();
}

CGAL::Parametric_surface_mesh_criteria criteria_with_detail(double diagonal)
{
  auto criteria = cad_criteria(diagonal);
  return criteria.set_detail(0.5 * *criteria.distance());
}

Meshed_shape mesh_without_detail(const TopoDS_Shape& shape) { return Meshed_shape(shape, criteria_with_detail); }

Judged_mesh judged(const Meshed_shape& meshed)
{
  Judged_mesh result = meshed.judged();
  for(const auto& detail : meshed.report.removed_details)
    (detail.is_closed_up ? result.closed_up_faces : result.thinned_faces).push_back(meshed.shape.shape_faces[detail.face] + 1);
  result.closed_up_width = *criteria_with_detail(1).detail();
  return result;
}

// of triangles with an angle below 10 degrees
std::size_t number_of_small_angles(const Meshed_shape& meshed)
{
  std::size_t result = 0;
  for(const auto f : meshed.mesh.faces()) {
    double smallest = 180;
    for(const auto h : meshed.mesh.halfedges_around_face(meshed.mesh.halfedge(f)))
      smallest = (std::min)(smallest, CGAL::approximate_angle(meshed.mesh.point(meshed.mesh.source(h)), meshed.mesh.point(meshed.mesh.target(h)),
                                                              meshed.mesh.point(meshed.mesh.target(meshed.mesh.next(h)))));
    result += smallest < 10;
  }
  return result;
}

// vertices - edges + faces
std::ptrdiff_t euler_characteristic(const Mesh& mesh)
{
  return std::ptrdiff_t(mesh.number_of_vertices()) - std::ptrdiff_t(mesh.number_of_edges()) + std::ptrdiff_t(mesh.number_of_faces());
}

void expect_sound(const TopoDS_Shape& shape, const Meshed_shape& meshed)
{
  EXPECT_TRUE(meshed.mesh.is_valid(false));
  EXPECT_TRUE(CGAL::is_triangle_mesh(meshed.mesh));
  for(const auto v : meshed.mesh.vertices())
    EXPECT_FALSE(meshed.mesh.is_isolated(v));
  EXPECT_EQ(meshed.shape.is_shape_closed, meshed.quality.is_closed);
  EXPECT_EQ("ok", Cad_mesh_judge(shape, judged(meshed))().text());
  EXPECT_NEAR(meshed.quality.min_angle, meshed.report.smallest_angle, 1e-6);
  EXPECT_EQ(meshed.mesh.number_of_vertices(), meshed.report.number_of_vertices);
  EXPECT_EQ(meshed.mesh.number_of_faces(), meshed.report.number_of_faces);
}

} // namespace

TEST(Details, a_low_step_vanishes)
{
  const double step = 0.0008; // so low that edges beside it do not become shorter than the minimum edge, either
  const TopoDS_Shape shape = stepped_bar(step);
  EXPECT_GT(number_of_small_angles(Meshed_shape(shape)), 4u);
  const Meshed_shape meshed = mesh_without_detail(shape);
  expect_sound(shape, meshed);
  EXPECT_LE(number_of_small_angles(meshed), 2u); // at the ends of the step there may be one each
  EXPECT_EQ(2, euler_characteristic(meshed.mesh));
  ASSERT_FALSE(meshed.report.removed_details.empty());
  for(const auto& detail : meshed.report.removed_details) {
    EXPECT_GE(detail.moved, step * (1 - 1e-9));
    EXPECT_LE(detail.moved, *criteria_with_detail(meshed.shape.diagonal).detail());
    EXPECT_NEAR(25, detail.place[0], 1e-9);
    EXPECT_GT(detail.number_of_triangles, 0u);
  }
}

// Higher than the width, it is kept, with whatever angles.
TEST(Details, a_step_above_the_width_stays)
{
  const double step = 0.03; // the diagonal is 64, so that the width is 0.016
  const TopoDS_Shape shape = stepped_bar(step);
  const Meshed_shape meshed = mesh_without_detail(shape);
  expect_sound(shape, meshed);
  EXPECT_TRUE(meshed.report.removed_details.empty());
}

TEST(Details, nothing_vanishes_that_makes_no_needles)
{
  const TopoDS_Shape shape = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  const Meshed_shape with = Meshed_shape(shape), without = mesh_without_detail(shape);
  EXPECT_TRUE(without.report.removed_details.empty());
  EXPECT_EQ(with.mesh.number_of_faces(), without.mesh.number_of_faces());
  EXPECT_EQ(with.mesh.number_of_vertices(), without.mesh.number_of_vertices());
}

// The rims of a thin pipe are narrow, but to close them would put its two walls on each other.
TEST(Details, a_thin_wall_stays)
{
  const TopoDS_Shape shape
    = BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(5.01, 100).Shape(), BRepPrimAPI_MakeCylinder(5, 100).Shape()).Shape();
  const Meshed_shape meshed = mesh_without_detail(shape);
  expect_sound(shape, meshed);
  EXPECT_TRUE(meshed.report.removed_details.empty());
  EXPECT_EQ(0, euler_characteristic(meshed.mesh)); // a torus
}

// A plate with a hole that is smaller than the width
TEST(Details, a_through_hole_stays)
{
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(60, 60, 5).Shape(),
                                             BRepPrimAPI_MakeCylinder(gp_Ax2({30, 30, -1}, {0, 0, 1}), 0.008, 7).Shape()).Shape();
  const Meshed_shape meshed = mesh_without_detail(shape);
  EXPECT_TRUE(meshed.quality.is_closed);
  EXPECT_EQ(0, euler_characteristic(meshed.mesh));
}

// Two solids that share a face with a step in its outline: each of them is closed, and they share the points there.
TEST(Details, vanish_from_two_solids_alike)
{
  BOPAlgo_Builder builder;
  gp_Trsf beside;
  beside.SetTranslation(gp_Vec(0, 20, 0));
  const TopoDS_Shape bar = stepped_bar(0.01);
  builder.AddArgument(bar);
  builder.AddArgument(stepped_bar(0.01).Moved(beside));
  builder.Perform();
  const Meshed_shape meshed = mesh_without_detail(builder.Shape());
  EXPECT_EQ(4, euler_characteristic(meshed.mesh)); // of two spheres
  EXPECT_LT(Meshed_shape(builder.Shape()).quality.min_angle, 0.1);
  EXPECT_GT(meshed.quality.min_angle, 3);
  EXPECT_TRUE(meshed.quality.is_closed);

  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> patches;
  const auto report = CGAL::make_parametric_surface_triangle_soup(meshed.shape.model, criteria_with_detail(meshed.shape.diagonal),
                                                                  points, triangles, patches);
  EXPECT_EQ(meshed.report.removed_details.size(), report.removed_details.size());
  EXPECT_EQ(points.size(), report.number_of_vertices);
  std::map<std::pair<std::size_t, std::size_t>, int> sides; // by shell they are even, and so is the sum
  std::vector<bool> is_used(points.size(), false);
  std::set<std::size_t> fronts; // of faces whose triangles have two shells
  for(const auto& face : meshed.shape.model.faces())
    fronts.insert(face.other_side_of);
  for(std::size_t f = 0; f < triangles.size(); ++f)
    for(std::size_t i = 0; i < 3; ++i) {
      const auto& t = triangles[f];
      is_used[t[i]] = true;
      sides[std::minmax(t[i], t[(i + 1) % 3])] += fronts.count(patches[f]) > 0 ? 2 : 1;
    }
  EXPECT_TRUE(std::all_of(is_used.begin(), is_used.end(), [](bool b) { return b; }));
  EXPECT_TRUE(std::all_of(sides.begin(), sides.end(), [](const auto& side) { return side.second % 2 == 0; }));
}

// The triangles of what is left know their places in the domains of their faces.
TEST(Details, corners_stay_in_the_domain)
{
  CGAL::Open_cascade_model_3 shape = CGAL::make_model_of_open_cascade_shape(stepped_bar(0.01));
  Mesh mesh;
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  auto patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;
  CGAL::make_parametric_surface_mesh(shape.model, criteria_with_detail(shape.diagonal), mesh,
                                     CGAL::parameters::halfedge_uv_map(uv, CGAL::parameters::face_patch_id_map(patch)));
  for(const auto f : mesh.faces())
    for(const auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const auto p = shape.model.faces()[patch[f]].surface.point(uv[h].x(), uv[h].y());
      EXPECT_LT(CGAL::squared_distance(p, mesh.point(mesh.target(h))), CGAL::square(*criteria_with_detail(shape.diagonal).detail()));
    }
}

// Edges between faces are those of the model that are left, with their parameters but for where two of them are one now.
TEST(Details, edges_keep_their_places)
{
  CGAL::Open_cascade_model_3 shape = CGAL::make_model_of_open_cascade_shape(stepped_bar(0.01));
  Mesh mesh;
  auto patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;
  auto places = mesh.add_property_map<Mesh::Edge_index, CGAL::Parametric_surface_mesher::Edge_place>("e:place").first;
  CGAL::make_parametric_surface_mesh(shape.model, criteria_with_detail(shape.diagonal), mesh,
                                     CGAL::parameters::edge_place_map(places, CGAL::parameters::face_patch_id_map(patch)));
  for(const auto e : mesh.edges()) {
    const auto h = mesh.halfedge(e);
    EXPECT_EQ(patch[mesh.face(h)] != patch[mesh.face(mesh.opposite(h))], places[e].index != places[e].none);
    if(places[e].index == places[e].none)
      continue;
    for(std::size_t end : {0, 1}) {
      const double t = places[e].parameters[end];
      const auto& edge = shape.model.edges()[places[e].index];
      const Kernel::Point_3 source = shape.model.vertices()[edge.source], target = shape.model.vertices()[edge.target],
                            p = mesh.point(end == 0 ? mesh.source(h) : mesh.target(h));
      if(std::isnan(t)) {
        EXPECT_NEAR(25, p.x(), 1e-9);
      }
      else { // all edges are straight
        EXPECT_LT(CGAL::squared_distance(p, source + t * (target - source)), 1e-12);
      }
    }
  }
}
