// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What comes out is the same in every face graph: arrays of a Surface_mesh that are filled, elements that are added one by
// one, and triangles that share points.
#include <gtest/gtest.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/make_parametric_surface_mesh.h>
#include <CGAL/make_parametric_surface_triangle_soup.h>

#include <Sample_models.h>
#include <check_invariants.h>
#include <mesher_test_helpers.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace {

const double number_of_triangles = 3000;

typedef std::array<Point_3, 3> Triangle;

template <class Graph>
Triangle triangle(const Graph& graph, typename boost::graph_traits<Graph>::face_descriptor f)
{
  const auto point = get(CGAL::vertex_point, graph);
  const auto h = halfedge(f, graph);
  return {get(point, source(h, graph)), get(point, target(h, graph)), get(point, target(next(h, graph), graph))};
}

template <class Graph>
std::vector<Triangle> triangles(const Graph& graph)
{
  std::vector<Triangle> result;
  for(const auto f : faces(graph))
    result.push_back(triangle(graph, f));
  return result;
}

struct Sample_mesh_of_model
{
  Sample_model sample;
  Criteria criteria;
  Mesh mesh;

  explicit Sample_mesh_of_model(const std::string& name)
    : sample(make_sample_model(name)), criteria(Criteria().set_max_edge(sample.edge_length(number_of_triangles)))
  {
    CGAL::make_parametric_surface_mesh(sample.model, criteria, mesh);
  }
};

const std::vector<std::string> names = {"sphere", "box", "ring", "cyl"};

void remove_all_faces(Mesh& mesh)
{
  for(const auto f : mesh.faces())
    mesh.remove_face(f);
  for(const auto e : mesh.edges())
    mesh.remove_edge(e);
  for(const auto v : mesh.vertices())
    mesh.remove_vertex(v);
}

} // namespace

TEST(Output, polyhedron)
{
  typedef CGAL::Polyhedron_3<Test_kernel, CGAL::Polyhedron_items_with_id_3> Polyhedron;
  for(const std::string& name : names) {
    SCOPED_TRACE(name);
    const Sample_mesh_of_model expected(name);
    Polyhedron polyhedron;
    CGAL::make_parametric_surface_mesh(expected.sample.model, expected.criteria, polyhedron);
    EXPECT_TRUE(polyhedron.is_valid());
    EXPECT_EQ(CGAL::is_closed(expected.mesh), CGAL::is_closed(polyhedron));
    EXPECT_EQ(triangles(expected.mesh), triangles(polyhedron));
  }
}

// Its free elements are used again.
TEST(Output, surface_mesh_with_garbage)
{
  for(const std::string& name : names) {
    SCOPED_TRACE(name);
    const Sample_mesh_of_model expected(name);
    Mesh mesh(expected.mesh);
    remove_all_faces(mesh);
    ASSERT_TRUE(mesh.has_garbage());
    CGAL::make_parametric_surface_mesh(expected.sample.model, expected.criteria, mesh);
    EXPECT_TRUE(mesh.is_valid());
    EXPECT_EQ(expected.mesh.number_of_faces(), mesh.number_of_faces());
    EXPECT_EQ(expected.mesh.number_of_faces(), mesh.num_faces());
    std::vector<Triangle> a = triangles(expected.mesh), b = triangles(mesh);
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    EXPECT_EQ(a, b);
  }
}

TEST(Output, after_what_a_surface_mesh_holds)
{
  for(const std::string& name : names) {
    SCOPED_TRACE(name);
    const Sample_mesh_of_model expected(name);
    Mesh mesh(expected.mesh);
    CGAL::make_parametric_surface_mesh(expected.sample.model, expected.criteria, mesh);
    EXPECT_TRUE(mesh.is_valid());
    std::vector<Triangle> twice = triangles(expected.mesh);
    twice.insert(twice.end(), twice.begin(), twice.begin() + expected.mesh.number_of_faces());
    EXPECT_EQ(twice, triangles(mesh));
    EXPECT_EQ(2 * expected.mesh.number_of_halfedges(), mesh.number_of_halfedges());
  }
}

// No vertex of these models is copied, so that triangles have the same indices.
TEST(Output, triangle_soup)
{
  for(const std::string& name : names) {
    SCOPED_TRACE(name);
    const Sample_mesh_of_model expected(name);
    std::vector<Point_3> points;
    std::vector<std::array<std::size_t, 3>> soup;
    std::vector<std::size_t> patches;
    CGAL::make_parametric_surface_triangle_soup(expected.sample.model, expected.criteria, points, soup, patches);
    ASSERT_EQ(expected.mesh.number_of_vertices(), points.size());
    ASSERT_EQ(expected.mesh.number_of_faces(), soup.size());
    ASSERT_EQ(soup.size(), patches.size());
    EXPECT_TRUE(std::is_sorted(patches.begin(), patches.end()));
    for(const auto v : expected.mesh.vertices())
      ASSERT_EQ(expected.mesh.point(v), points[v]);
    const std::vector<Triangle> expected_triangles = triangles(expected.mesh);
    for(std::size_t t = 0; t < soup.size(); ++t)
      ASSERT_EQ(expected_triangles[t], (Triangle{points[soup[t][0]], points[soup[t][1]], points[soup[t][2]]}));
  }
}

TEST(Output, triangle_soup_of_ranges_without_a_fixed_size)
{
  const Sample_mesh_of_model expected("box");
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> arrays;
  std::vector<std::vector<std::size_t>> vectors(1, {7, 7, 7, 7, 7});
  std::vector<std::size_t> patches;
  CGAL::make_parametric_surface_triangle_soup(expected.sample.model, expected.criteria, points, arrays, patches);
  CGAL::make_parametric_surface_triangle_soup(expected.sample.model, expected.criteria, points, vectors, patches);
  ASSERT_EQ(arrays.size(), vectors.size());
  for(std::size_t t = 0; t < arrays.size(); ++t)
    ASSERT_EQ(std::vector<std::size_t>(arrays[t].begin(), arrays[t].end()), vectors[t]);
}

// Maps of all kinds get the same values.
TEST(Output, property_maps)
{
  const Sample_mesh_of_model expected("box");
  Mesh arrays, trees;
  const auto uv = uv_map(arrays);
  const auto corner_uv = arrays.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  const auto patch = arrays.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;
  CGAL::make_parametric_surface_mesh(
    expected.sample.model, expected.criteria, arrays,
    CGAL::parameters::vertex_uv_map(uv,
      CGAL::parameters::halfedge_uv_map(corner_uv,
        CGAL::parameters::face_patch_id_map(patch))));
  std::map<Mesh::Vertex_index, Point_2> tree_of_vertices;
  std::map<Mesh::Halfedge_index, Point_2> tree_of_halfedges;
  std::map<Mesh::Face_index, std::size_t> tree_of_faces;
  CGAL::make_parametric_surface_mesh(
    expected.sample.model, expected.criteria, trees,
    CGAL::parameters::vertex_uv_map(boost::make_assoc_property_map(tree_of_vertices),
      CGAL::parameters::halfedge_uv_map(boost::make_assoc_property_map(tree_of_halfedges),
        CGAL::parameters::face_patch_id_map(boost::make_assoc_property_map(tree_of_faces)))));
  ASSERT_EQ(arrays.number_of_vertices(), tree_of_vertices.size());
  for(const auto& entry : tree_of_vertices)
    ASSERT_EQ(uv[entry.first], entry.second);
  ASSERT_EQ(arrays.number_of_halfedges(), tree_of_halfedges.size());
  for(const auto& entry : tree_of_halfedges)
    ASSERT_EQ(corner_uv[entry.first], entry.second);
  ASSERT_EQ(arrays.number_of_faces(), tree_of_faces.size());
  for(const auto& entry : tree_of_faces)
    ASSERT_EQ(patch[entry.first], entry.second);
}
