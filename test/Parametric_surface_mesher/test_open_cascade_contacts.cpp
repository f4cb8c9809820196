// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solids that share faces: each of these is meshed once, and has the same triangles on both sides.
#include "open_cascade_test_helpers.h"

#include <CGAL/fuse_open_cascade_solids.h>
#include <CGAL/make_element_mesh.h>
#include <CGAL/make_parametric_surface_triangle_soup.h>

#include <BOPAlgo_Builder.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gp_Ax2.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Open_cascade_model_3::Model Model;

TopoDS_Shape fused(const std::vector<TopoDS_Shape>& parts)
{
  BOPAlgo_Builder builder;
  for(const TopoDS_Shape& part : parts)
    builder.AddArgument(part);
  builder.Perform();
  return builder.Shape();
}

// two boxes with a wall in common, and a pin through both
TopoDS_Shape pinned_boxes(double step = 0)
{
  return fused({BRepPrimAPI_MakeBox(20, 20, 20).Shape(), BRepPrimAPI_MakeBox(gp_Pnt(20, step, 0), 20, 20, 20).Shape(),
                BRepPrimAPI_MakeCylinder(gp_Ax2({5, 10, 10}, {1, 0, 0}), 4, 30).Shape()});
}

std::vector<std::size_t> backs(const Model& model)
{
  std::vector<std::size_t> result;
  for(std::size_t f = 0; f < model.faces().size(); ++f)
    if(model.faces()[f].other_side_of != Model::no_face)
      result.push_back(f);
  return result;
}

typedef std::set<std::set<Kernel::Point_3>> Triangles;

std::map<std::size_t, Triangles> triangles_by_patch(const Meshed_shape& meshed)
{
  std::map<std::size_t, Triangles> result;
  for(const auto f : meshed.mesh.faces()) {
    std::set<Kernel::Point_3> triangle;
    for(const auto v : meshed.mesh.vertices_around_face(meshed.mesh.halfedge(f)))
      triangle.insert(meshed.mesh.point(v));
    result[meshed.patch[f]].insert(triangle);
  }
  return result;
}

double signed_volume(const Meshed_shape& meshed, std::size_t shell)
{
  double result = 0;
  for(const auto f : meshed.mesh.faces())
    if(meshed.shape.model.faces()[meshed.patch[f]].shell == shell) {
      std::array<Kernel::Point_3, 3> p;
      auto corner = p.begin();
      for(const auto v : meshed.mesh.vertices_around_face(meshed.mesh.halfedge(f)))
        *corner++ = meshed.mesh.point(v);
      result += CGAL::volume(Kernel::Point_3(0, 0, 0), p[0], p[1], p[2]);
    }
  return result;
}

void expect_same_triangles_on_both_sides(const Meshed_shape& meshed)
{
  EXPECT_TRUE(meshed.mesh.is_valid(false));
  EXPECT_TRUE(meshed.quality.is_closed);
  auto triangles = triangles_by_patch(meshed);
  for(std::size_t back : backs(meshed.shape.model)) {
    EXPECT_FALSE(triangles[back].empty());
    EXPECT_EQ(triangles[back], triangles[meshed.shape.model.faces()[back].other_side_of]);
  }
  EXPECT_EQ(meshed.mesh.number_of_faces(), meshed.report.number_of_faces);
  EXPECT_EQ(meshed.mesh.number_of_vertices(), meshed.report.number_of_vertices);
}

} // namespace

TEST(Contacts, are_meshed_once)
{
  const Meshed_shape meshed(pinned_boxes());
  const std::size_t number_of_contacts = backs(meshed.shape.model).size();
  EXPECT_EQ(6u, number_of_contacts); // the wall around the pin and that across it, and the pin's mantle in two pieces with their ends
  expect_same_triangles_on_both_sides(meshed);
  std::set<std::size_t> shells;
  for(const auto& face : meshed.shape.model.faces())
    shells.insert(face.shell);
  double sum = 0;
  for(std::size_t shell : shells) {
    EXPECT_GT(signed_volume(meshed, shell), 0);
    sum += signed_volume(meshed, shell);
  }
  EXPECT_NEAR(2 * 8000, sum, 1e-6); // what the facets of the pin lack is in the boxes
}

// Triangles with all points in common: each one of a contact is there once.
TEST(Contacts, have_triangles_once_in_a_soup)
{
  const Meshed_shape meshed(pinned_boxes());
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> patches;
  const auto report = CGAL::make_parametric_surface_triangle_soup(meshed.shape.model, cad_criteria(meshed.shape.diagonal), points,
                                                                  triangles, patches);
  EXPECT_EQ(report.number_of_faces, triangles.size());
  const auto by_patch = triangles_by_patch(meshed);
  std::size_t number_of_doubled = 0;
  for(std::size_t back : backs(meshed.shape.model))
    number_of_doubled += by_patch.at(back).size();
  EXPECT_EQ(meshed.mesh.number_of_faces(), triangles.size() + number_of_doubled);
  EXPECT_EQ(points.size(), std::set<Kernel::Point_3>(points.begin(), points.end()).size());

  // each shell is closed: its own triangles, and those that it is behind
  std::map<std::size_t, std::map<std::pair<std::size_t, std::size_t>, int>> sides;
  const auto add = [&](std::size_t shell, const std::array<std::size_t, 3>& t, int sign) {
    for(std::size_t i = 0; i < 3; ++i) {
      const std::size_t v = t[i], w = t[(i + 1) % 3];
      sides[shell][std::minmax(v, w)] += v < w ? sign : -sign;
    }
  };
  const auto& faces = meshed.shape.model.faces();
  for(std::size_t i = 0; i < triangles.size(); ++i) {
    add(faces[patches[i]].shell, triangles[i], 1);
    for(std::size_t back : backs(meshed.shape.model))
      if(faces[back].other_side_of == patches[i])
        add(faces[back].shell, triangles[i], -1);
  }
  for(const auto& shell : sides)
    for(const auto& side : shell.second)
      EXPECT_EQ(0, side.second);
}

TEST(Contacts, have_the_same_cuts_on_both_sides)
{
  const Meshed_shape meshed(pinned_boxes(), [](double diagonal) {
    auto criteria = cad_criteria(diagonal);
    return criteria.set_max_edge(diagonal / 150).set_part_size(500);
  });
  expect_same_triangles_on_both_sides(meshed);
}

// A step that is lower than the width of detail, in the outline of the contact.
TEST(Contacts, are_the_same_where_detail_vanishes)
{
  const auto criteria_with_detail = [](double diagonal) {
    auto criteria = cad_criteria(diagonal);
    return criteria.set_detail(0.5 * *criteria.distance());
  };
  const Meshed_shape meshed(pinned_boxes(0.005), criteria_with_detail);
  EXPECT_FALSE(meshed.report.removed_details.empty());
  expect_same_triangles_on_both_sides(meshed);
}

// What a triangle does not meet is said of it on both sides.
TEST(Contacts, have_the_same_failures_on_both_sides)
{
  const Meshed_shape meshed(pinned_boxes(), [](double diagonal) {
    auto criteria = cad_criteria(diagonal);
    return criteria.set_angle(42);
  });
  std::map<std::size_t, std::size_t> numbers; // by patch
  for(const auto& unmet : meshed.report.unmet)
    ++numbers[meshed.patch[Mesh::Face_index(Mesh::size_type(unmet.face))]];
  std::size_t number_on_contacts = 0;
  for(std::size_t back : backs(meshed.shape.model)) {
    EXPECT_EQ(numbers[back], numbers[meshed.shape.model.faces()[back].other_side_of]);
    number_on_contacts += numbers[back];
  }
  EXPECT_GT(number_on_contacts, 0u);
}

// A face whose other side cannot be meshed is left out with it.
TEST(Contacts, are_left_out_on_both_sides)
{
  CGAL::Open_cascade_model_3 shape = CGAL::make_model_of_open_cascade_shape(pinned_boxes());
  const std::size_t back = backs(shape.model).front(), front = shape.model.faces()[back].other_side_of;
  for(std::size_t f : {front, back})
    shape.model.faces()[f].sizing_field = [](double, double) { return -1.; };
  Mesh mesh;
  const auto report = CGAL::make_parametric_surface_mesh(shape.model, cad_criteria(shape.diagonal), mesh,
                                                         CGAL::parameters::leaves_out_bad_faces(true));
  ASSERT_EQ(2u, report.left_out.size());
  EXPECT_EQ(front, report.left_out[0].face);
  EXPECT_EQ(back, report.left_out[1].face);
}

// A wrong other side is refused.
TEST(Contacts, that_do_not_fit_are_refused)
{
  const Model good = CGAL::make_model_of_open_cascade_shape(pinned_boxes()).model;
  const std::size_t back = backs(good).front(), front = good.faces()[back].other_side_of;
  const auto expect_error = [&](const std::string& text, const auto& change) {
    Model model = good;
    change(model);
    try {
      CGAL::Parametric_surface_mesher::validate(model);
      ADD_FAILURE() << text;
    }
    catch(const CGAL::Parametric_surface_mesh_error& error) {
      EXPECT_NE(std::string::npos, std::string(error.what()).find(text)) << error.what();
    }
  };
  expect_error("does not come before it", [&](Model& model) { model.faces()[back].other_side_of = back; });
  expect_error("is in the same shell", [&](Model& model) { model.faces()[back].shell = model.faces()[front].shell; });
  expect_error("has other loops", [&](Model& model) {
    model.faces()[back].other_side_of = 0 == front ? 1 : 0;
    model.faces()[back].is_reversed = !model.faces()[model.faces()[back].other_side_of].is_reversed;
  });
}

// Boxes side by side, the second one higher: it has a face of which a part touches.
TEST(Fusing, divides_faces_that_touch_in_part)
{
  const TopoDS_Shape assembly
    = compound_of({BRepPrimAPI_MakeBox(10, 10, 10).Shape(), BRepPrimAPI_MakeBox(gp_Pnt(10, 0, 0), 10, 10, 15).Shape(),
                   BRepPrimAPI_MakeBox(gp_Pnt(0, 10.01, 0), 5, 5, 5).Shape()});
  const auto fused = CGAL::fuse_open_cascade_solids(assembly, 0, 0.1);
  ASSERT_EQ(1u, fused.contacts.size());
  EXPECT_EQ(0u, fused.contacts[0].first);
  EXPECT_EQ(1u, fused.contacts[0].second);
  EXPECT_EQ(1u, fused.contacts[0].number_of_faces);
  EXPECT_NEAR(100, fused.contacts[0].area, 1e-9);
  EXPECT_TRUE(fused.overlaps.empty());
  ASSERT_EQ(1u, fused.gaps.size());
  EXPECT_EQ(0u, fused.gaps[0].first);
  EXPECT_EQ(2u, fused.gaps[0].second);
  EXPECT_NEAR(0.01, fused.gaps[0].distance, 1e-9);
  const Meshed_shape meshed(fused.shape);
  EXPECT_EQ(1u, backs(meshed.shape.model).size());
  expect_same_triangles_on_both_sides(meshed);
  EXPECT_NEAR(1000 + 1500 + 125, meshed.volume(), 1e-9);

  const auto joined = CGAL::fuse_open_cascade_solids(assembly, 0.02, 0.1);
  EXPECT_EQ(2u, joined.contacts.size());
  EXPECT_TRUE(joined.gaps.empty());
}

TEST(Fusing, tells_of_overlaps)
{
  const TopoDS_Shape assembly
    = compound_of({BRepPrimAPI_MakeBox(10, 10, 10).Shape(), BRepPrimAPI_MakeBox(gp_Pnt(9, 0, 0), 10, 10, 10).Shape()});
  const auto fused = CGAL::fuse_open_cascade_solids(assembly);
  ASSERT_EQ(1u, fused.overlaps.size());
  EXPECT_NEAR(100, fused.overlaps[0].volume, 1e-9);
  const Meshed_shape meshed(fused.shape);
  expect_same_triangles_on_both_sides(meshed);
  EXPECT_NEAR(1900, meshed.volume(), 1e-9);
}

TEST(Fusing, leaves_a_single_solid_as_it_is)
{
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  const auto fused = CGAL::fuse_open_cascade_solids(box);
  EXPECT_TRUE(fused.shape.IsSame(box));
  EXPECT_TRUE(fused.history.IsNull());
  for(double fuzzy : {-1., 1e9, 0.2}) // the diagonal is 17.3
    EXPECT_THROW(CGAL::fuse_open_cascade_solids(box, fuzzy), CGAL::Parametric_surface_mesh_error) << fuzzy;
}

// The complex of two boxes and a pin in them: contacts are there once, and have a part on either side.
TEST(Complex, has_contacts_once)
{
  namespace psm = CGAL::Parametric_surface_mesher;
  namespace params = CGAL::parameters;
  const CGAL::Open_cascade_model_3 shape = CGAL::make_model_of_open_cascade_shape(pinned_boxes());
  std::size_t number_of_shells = 0;
  for(const auto& face : shape.model.faces())
    number_of_shells = (std::max)(number_of_shells, face.shell + 1);
  CGAL::Open_cascade_names_3 names;
  names.shell_names.resize(number_of_shells);
  names.face_names.resize(shape.number_of_shape_faces);
  for(std::size_t shell = 0; shell < number_of_shells; ++shell) {
    names.parts.emplace_back();
    names.parts.back().name = names.parts.back().path = "part " + std::to_string(shell);
    names.parts.back().shells = {shell};
  }
  Mesh mesh;
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  auto patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;
  auto vertex_places = mesh.add_property_map<Mesh::Vertex_index, psm::Vertex_place>("v:place").first;
  auto edge_places = mesh.add_property_map<Mesh::Edge_index, psm::Edge_place>("e:place").first;
  const auto np = params::halfedge_uv_map(
    uv, params::face_patch_id_map(patch, params::vertex_place_map(vertex_places, params::edge_place_map(edge_places))));
  CGAL::make_parametric_surface_mesh(shape.model, cad_criteria(shape.diagonal), mesh, np);
  const CGAL::Element_mesh_3 complex = CGAL::make_element_mesh(shape, names, mesh, np);

  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> patches;
  CGAL::make_parametric_surface_triangle_soup(shape.model, cad_criteria(shape.diagonal), points, triangles, patches);
  EXPECT_EQ(points.size(), complex.nodes.size());
  EXPECT_EQ(triangles.size(), complex.triangles.size());
  EXPECT_EQ(complex.nodes.size(), complex.places.size());
  EXPECT_EQ(shape.number_of_shape_faces, complex.surfaces.size());

  std::size_t number_of_contacts = 0;
  std::map<std::size_t, std::map<std::pair<std::size_t, std::size_t>, int>> sides; // by part
  for(const auto& surface : complex.surfaces)
    number_of_contacts += surface.parts[1] != complex.none;
  EXPECT_EQ(backs(shape.model).size(), number_of_contacts);
  for(std::size_t t = 0; t < complex.triangles.size(); ++t)
    for(std::size_t side : {0, 1}) {
      const std::size_t part = complex.surfaces[complex.triangle_surfaces[t]].parts[side];
      for(std::size_t i = 0; i < 3; ++i) {
        const std::size_t v = complex.triangles[t][i], w = complex.triangles[t][(i + 1) % 3];
        sides[part][std::minmax(v, w)] += (v < w) == (side == 0) ? 1 : -1;
      }
    }
  sides.erase(complex.none);
  EXPECT_EQ(number_of_shells, sides.size());
  for(const auto& part : sides)
    for(const auto& side : part.second)
      EXPECT_EQ(0, side.second);
}
