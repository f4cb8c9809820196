// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where vertices and edges of a mesh lie in the model.
#include "Sample_models.h"
#include "mesher_test_helpers.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace psm = CGAL::Parametric_surface_mesher;
typedef CGAL::Surface_mesh<Sample_kernel::Point_3> Mesh;

struct Placed_mesh
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Vertex_index, psm::Vertex_place> vertex_places
    = mesh.add_property_map<Mesh::Vertex_index, psm::Vertex_place>("v:place").first;
  Mesh::Property_map<Mesh::Edge_index, psm::Edge_place> edge_places
    = mesh.add_property_map<Mesh::Edge_index, psm::Edge_place>("e:place").first;
  Mesh::Property_map<Mesh::Face_index, std::size_t> patches = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;

  template <class Tag = CGAL::Sequential_tag>
  void make(const Sample_surface_model& model, const CGAL::Parametric_surface_mesh_criteria& criteria)
  {
    namespace params = CGAL::parameters;
    CGAL::make_parametric_surface_mesh<Tag>(
      model, criteria, mesh, params::vertex_place_map(vertex_places, params::edge_place_map(edge_places, params::face_patch_id_map(patches))));
  }
};

// the points of an edge at a parameter, one for each use
std::vector<Mesh::Point> points_of_edge(const Sample_surface_model& model, std::size_t edge, double t)
{
  std::vector<Mesh::Point> result;
  for(const auto& face : model.faces())
    for(const auto& loop : face.loops)
      for(const auto& use : loop)
        if(use.edge == edge) {
          const auto uv = use.curve.point(t);
          result.push_back(face.surface.point(uv.x(), uv.y()));
        }
  return result;
}

void expect_on_edge(const Sample_surface_model& model, const Mesh::Point& point, std::size_t edge, double t)
{
  for(const Mesh::Point& image : points_of_edge(model, edge, t))
    EXPECT_LT(CGAL::squared_distance(point, image), 1e-12) << "edge " << edge << " at " << t;
}

void expect_vertices_at_their_places(const Sample_surface_model& model, const Placed_mesh& placed)
{
  for(const auto v : placed.mesh.vertices()) {
    const psm::Vertex_place& place = placed.vertex_places[v];
    if(place.dimension == 0) {
      EXPECT_EQ(placed.mesh.point(v), model.vertices()[place.index]);
    }
    else if(place.dimension == 1)
      expect_on_edge(model, placed.mesh.point(v), place.index, place.parameter);
    else
      for(const auto h : placed.mesh.halfedges_around_target(placed.mesh.halfedge(v)))
        EXPECT_EQ(placed.patches[placed.mesh.face(h)], place.index);
  }
}

// Each edge of the model that is not a point is covered once for each border of the mesh there.
void expect_edges_at_their_places(const Sample_surface_model& model, const Placed_mesh& placed)
{
  std::map<std::size_t, double> covered; // by edge of the model
  for(const auto e : placed.mesh.edges()) {
    const psm::Edge_place& place = placed.edge_places[e];
    const auto h = placed.mesh.halfedge(e);
    const bool is_border = placed.mesh.is_border(e)
                           || placed.patches[placed.mesh.face(h)] != placed.patches[placed.mesh.face(placed.mesh.opposite(h))];
    if(is_border) {
      EXPECT_NE(place.index, psm::Edge_place::none);
    }
    if(place.index == psm::Edge_place::none) {
      EXPECT_TRUE(std::isnan(place.parameters[0]));
      continue;
    }
    covered[place.index] += std::fabs(place.parameters[1] - place.parameters[0]);
    expect_on_edge(model, placed.mesh.point(placed.mesh.source(h)), place.index, place.parameters[0]);
    expect_on_edge(model, placed.mesh.point(placed.mesh.target(h)), place.index, place.parameters[1]);
  }
  for(std::size_t e = 0; e < model.edges().size(); ++e)
    EXPECT_NEAR(covered[e], model.edges()[e].is_collapsed ? 0 : 1, 1e-9) << "edge " << e;
}

class Places : public testing::TestWithParam<std::string> {};

TEST_P(Places, are_those_of_the_model)
{
  const Sample_model sample = make_sample_model(GetParam());
  for(double number : {20., 1000., 5000.}) {
    CGAL::Parametric_surface_mesh_criteria criteria;
    criteria.set_max_edge(sample.edge_length(number));
    Placed_mesh placed;
    placed.make(sample.model, criteria);
    expect_vertices_at_their_places(sample.model, placed);
    expect_edges_at_their_places(sample.model, placed);
  }
}

// Cuts are no edges of the model, and points on them lie inside the face.
TEST_P(Places, are_those_of_the_model_after_cuts)
{
  const Sample_model sample = make_sample_model(GetParam());
  CGAL::Parametric_surface_mesh_criteria criteria;
  criteria.set_max_edge(sample.edge_length(10000)).set_part_size(2000);
  Placed_mesh placed;
  placed.make(sample.model, criteria);
  expect_vertices_at_their_places(sample.model, placed);
  expect_edges_at_their_places(sample.model, placed);
}

INSTANTIATE_TEST_SUITE_P(Samples, Places, testing::ValuesIn(sample_model_names()), [](const auto& sample) { return sample.param; });

// The curves of a domain are the edges.
TEST(Places_of_patch, are_those_of_the_curves)
{
  const Sample sample = make_sample("hole");
  CGAL::Parametric_surface_mesh_criteria criteria;
  criteria.set_max_edge(sample.edge_length(2000));
  Mesh mesh;
  auto places = mesh.add_property_map<Mesh::Edge_index, psm::Edge_place>("e:place").first;
  CGAL::make_parametric_surface_mesh(sample.surface, sample.domain, criteria, mesh, CGAL::parameters::edge_place_map(places));
  std::vector<const Domain::Curve*> curves;
  for(const auto& loop : sample.domain.loops())
    for(const auto& curve : loop)
      curves.push_back(&curve);
  for(const auto e : mesh.edges()) {
    EXPECT_EQ(mesh.is_border(e), places[e].index != psm::Edge_place::none);
    if(places[e].index == psm::Edge_place::none)
      continue;
    ASSERT_LT(places[e].index, curves.size());
    for(int end : {0, 1}) {
      const auto uv = curves[places[e].index]->point(places[e].parameters[std::size_t(end)]);
      const auto v = end == 0 ? mesh.source(mesh.halfedge(e)) : mesh.target(mesh.halfedge(e));
      EXPECT_LT(CGAL::squared_distance(mesh.point(v), sample.surface.point(uv.x(), uv.y())), 1e-20);
    }
  }
}

} // namespace
