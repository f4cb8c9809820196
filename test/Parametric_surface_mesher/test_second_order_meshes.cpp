// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Six-node triangles of finished meshes: where their nodes are, and how close the curved triangles come to the surfaces.
#include "Sample_models.h"

#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_parametric_surface_mesh.h>
#include <CGAL/make_second_order_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace psm = CGAL::Parametric_surface_mesher;
typedef Sample_kernel::Point_2 Point_2;
typedef Sample_kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

// A mesh with its places in a model and its mid-side nodes.
struct Curved_mesh
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Halfedge_index, Point_2> uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  Mesh::Property_map<Mesh::Face_index, std::size_t> patches = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;
  Mesh::Property_map<Mesh::Edge_index, psm::Edge_place> places
    = mesh.add_property_map<Mesh::Edge_index, psm::Edge_place>("e:place").first;
  Mesh::Property_map<Mesh::Edge_index, Point_3> nodes = mesh.add_property_map<Mesh::Edge_index, Point_3>("e:node").first;

  auto maps() const
  {
    namespace params = CGAL::parameters;
    return params::halfedge_uv_map(uv, params::face_patch_id_map(patches, params::edge_place_map(places)));
  }

  template <class Model>
  void make_triangles(const Model& model, double max_edge)
  {
    CGAL::Parametric_surface_mesh_criteria criteria;
    criteria.set_max_edge(max_edge).set_min_edge(max_edge / 10).set_gamma(0.2);
    CGAL::make_parametric_surface_mesh(model, criteria, mesh, maps());
  }

  template <class Model>
  CGAL::Second_order_mesh_report make_nodes(const Model& model)
  {
    return CGAL::make_second_order_mesh(model, mesh, nodes, maps());
  }

  template <class Model>
  double distance(const Model& model, unsigned int subdivisions = 6) const
  {
    return CGAL::second_order_mesh_distance(model, mesh, nodes, maps(), subdivisions);
  }

  void straighten()
  {
    for(const auto e : mesh.edges())
      nodes[e] = CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
  }

  double mean_edge() const
  {
    double sum = 0;
    for(const auto e : mesh.edges())
      sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
    return sum / double(mesh.number_of_edges());
  }
};

double distance(const Point_3& p, const Point_3& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

// How far a node is from being equally far from both ends of its edge, as a share of its length.
double imbalance(const Curved_mesh& curved, Mesh::Edge_index e)
{
  const Point_3 &p = curved.mesh.point(curved.mesh.vertex(e, 0)), &q = curved.mesh.point(curved.mesh.vertex(e, 1));
  return std::fabs(distance(p, curved.nodes[e]) - distance(q, curved.nodes[e])) / distance(p, q);
}

// One triangle with the given parameters on a surface.
template <class Surface>
Curved_mesh one_triangle(const Surface& surface, const Point_2& p, const Point_2& q, const Point_2& r)
{
  Curved_mesh result;
  std::vector<Mesh::Vertex_index> vertices;
  for(const Point_2& uv : {p, q, r})
    vertices.push_back(result.mesh.add_vertex(surface.point(uv.x(), uv.y())));
  const auto h = result.mesh.halfedge(result.mesh.add_face(vertices));
  for(const auto g : result.mesh.halfedges_around_face(h))
    result.uv[g] = result.mesh.target(g) == vertices[0] ? p : result.mesh.target(g) == vertices[1] ? q : r;
  result.patches[result.mesh.face(h)] = 0;
  return result;
}

// A model of one triangle without edges of its own.
template <class Surface>
CGAL::Parametric_surface_model_3<Surface> model_of_face(const Surface& surface)
{
  CGAL::Parametric_surface_model_3<Surface> model;
  model.add_face({surface, {}});
  return model;
}

class Second_order_mesh : public testing::TestWithParam<std::string>
{};

} // namespace

// Whatever has seams, poles, corners and edges between faces. At the apex of the cone three triangles turn around it, which are curved
// a lot.
TEST_P(Second_order_mesh, of_a_sample_is_close_to_its_surface_and_certified)
{
  const Sample_model sample = make_sample_model(GetParam());
  const bool has_apex = GetParam() == "cone";
  Curved_mesh curved;
  curved.make_triangles(sample.model, sample.edge_length(1500));
  curved.straighten();
  const double straight_distance = curved.distance(sample.model);
  const auto report = curved.make_nodes(sample.model);
  EXPECT_EQ(report.number_on_curves + report.number_on_surfaces, curved.mesh.number_of_edges());
  EXPECT_EQ(report.number_of_projected + report.number_of_straight, 0u);
  EXPECT_LE(report.number_of_curved_less, has_apex ? 2u : 0u);
  EXPECT_TRUE(report.uncertified.empty());
  EXPECT_GT(report.smallest_scaled_jacobian, has_apex ? 0.1 : 0.5);
  if(has_apex)
    return;
  EXPECT_LT(curved.distance(sample.model, 2), 1e-8); // corners and nodes
  EXPECT_LE(curved.distance(sample.model), straight_distance / 20 + 1e-12);
  for(const auto e : curved.mesh.edges())
    EXPECT_LT(imbalance(curved, e), curved.places[e].index == psm::Edge_place::none ? 1e-8 : 0.02);
}

INSTANTIATE_TEST_SUITE_P(Samples, Second_order_mesh, testing::ValuesIn(sample_model_names()));

// The nodes of seams and of edges between faces are where the surfaces on both sides are: they are looked for from both.
TEST(Second_order_mesh, has_nodes_of_edges_of_the_model_on_their_curves)
{
  const Sample_model cone = make_sample_model("cone");
  Curved_mesh curved;
  curved.make_triangles(cone.model, 0.3);
  curved.make_nodes(cone.model);
  std::size_t number_on_rim = 0;
  for(const auto e : curved.mesh.edges()) {
    const auto h = curved.mesh.halfedge(e);
    if(curved.patches[curved.mesh.face(h)] == curved.patches[curved.mesh.face(curved.mesh.opposite(h))])
      continue;
    ++number_on_rim;
    EXPECT_NEAR(curved.nodes[e].z(), 0, 1e-12);
    EXPECT_NEAR(std::hypot(curved.nodes[e].x(), curved.nodes[e].y()), 1, 1e-12);
  }
  EXPECT_GT(number_on_rim, 10u);
}

namespace {

// The distance of a mesh with edges of about this length, and that length.
struct Distance_at_length
{
  double distance, length;
};

Distance_at_length measure(const Sample_surface_model& model, double max_edge)
{
  Curved_mesh curved;
  curved.make_triangles(model, max_edge);
  curved.make_nodes(model);
  return {curved.distance(model), curved.mean_edge()};
}

} // namespace

TEST(Second_order_mesh, has_a_distance_of_third_order)
{
  for(const char* name : {"sphere", "torus"}) {
    const Sample_model sample = make_sample_model(name);
    const Distance_at_length coarse = measure(sample.model, 0.2), fine = measure(sample.model, 0.035);
    EXPECT_GT(std::log(coarse.distance / fine.distance) / std::log(coarse.length / fine.length), 2.9)
      << name << ", distances " << coarse.distance << " and " << fine.distance;
  }
}

TEST(Second_order_mesh, of_a_plane_is_straight)
{
  const auto model = model_of_face(CGAL::Parametric_plane_3<Sample_kernel>(Point_3(1, 2, 3), {1, 0, 1}, {0, 2, 1}));
  Curved_mesh curved = one_triangle(model.faces()[0].surface, {0, 0}, {1, 0}, {0.3, 0.8});
  EXPECT_EQ(curved.make_nodes(model).number_on_surfaces, 3u);
  for(const auto e : curved.mesh.edges())
    EXPECT_LT(distance(curved.nodes[e], CGAL::midpoint(curved.mesh.point(curved.mesh.vertex(e, 0)), curved.mesh.point(curved.mesh.vertex(e, 1)))),
              1e-12);
}

TEST(Second_order_mesh, has_its_nodes_on_a_quadric)
{
  const auto model = model_of_face(CGAL::make_parametric_function_surface<Sample_kernel>(
    [](auto u, auto v) { return CGAL::parametric_surface_point(u, v, u * u + 0.5 * v * v); }));
  Curved_mesh curved = one_triangle(model.faces()[0].surface, {-0.2, -0.1}, {0.2, -0.1}, {0, 0.2});
  EXPECT_EQ(curved.make_nodes(model).number_on_surfaces, 3u);
  for(const auto e : curved.mesh.edges()) {
    const Point_3& p = curved.nodes[e];
    EXPECT_NEAR(p.z(), p.x() * p.x() + 0.5 * p.y() * p.y(), 1e-12);
    EXPECT_LT(imbalance(curved, e), 1e-9);
  }
  EXPECT_LT(curved.distance(model), 1e-3);
}

namespace {

// (cos u^2, sin u^2, v^2), whose speed along u is that of u.
struct Unevenly_turned
{
  template <class Number>
  auto operator()(Number u, Number v) const
  {
    using std::cos;
    using std::sin;
    return CGAL::parametric_surface_point(cos(u * u), sin(u * u), v * v);
  }
};

// A triangle on it with the side from the first corner to the second on an edge of the model.
struct Uneven_triangle
{
  typedef decltype(CGAL::make_parametric_function_surface<Sample_kernel>(Unevenly_turned())) Surface;
  typedef CGAL::Parametric_surface_model_3<Surface> Model;

  const Point_2 p = {0.2, 1}, q = {1.3, 1};
  Model model = model_of_face(CGAL::make_parametric_function_surface<Sample_kernel>(Unevenly_turned()));
  Curved_mesh curved;
  Mesh::Edge_index side;

  Uneven_triangle() : curved(one_triangle(model.faces()[0].surface, p, q, {0.8, 0.2}))
  {
    const std::size_t source = model.add_vertex(model.faces()[0].surface.point(p.x(), p.y())),
                      target = model.add_vertex(model.faces()[0].surface.point(q.x(), q.y())),
                      edge = model.add_edge(source, target);
    model.faces()[0].loops.push_back({{edge, false, Model::Curve::segment(p, q)}});
    const auto h = curved.mesh.halfedge(Mesh::Vertex_index(0), Mesh::Vertex_index(1));
    side = curved.mesh.edge(h);
    curved.places[side].index = edge;
    curved.places[side].parameters = {0, 1};
    if(curved.mesh.halfedge(side) != h)
      std::swap(curved.places[side].parameters[0], curved.places[side].parameters[1]);
  }

  // The angle of the node of the side about the axis.
  double angle() const { return std::atan2(curved.nodes[side].y(), curved.nodes[side].x()); }
};

} // namespace

// The middle is that in space, not that of the parameters.
TEST(Second_order_mesh, has_nodes_in_the_middle_by_length)
{
  Uneven_triangle t;
  const auto report = t.curved.make_nodes(t.model);
  EXPECT_EQ(report.number_on_curves, 1u);
  EXPECT_EQ(report.number_on_surfaces, 2u);
  EXPECT_NEAR(t.angle(), (0.2 * 0.2 + 1.3 * 1.3) / 2, 1e-9);
  EXPECT_NEAR(t.curved.nodes[t.side].z(), 1, 1e-12);
}

// Where detail was removed the parameters of pieces of edges are not known.
TEST(Second_order_mesh, has_nodes_on_the_edge_nearby_if_its_parameters_are_not_known)
{
  Uneven_triangle t;
  t.curved.places[t.side].parameters[1] = std::numeric_limits<double>::quiet_NaN();
  const auto report = t.curved.make_nodes(t.model);
  EXPECT_EQ(report.number_on_curves, 0u);
  EXPECT_EQ(report.number_of_projected, 1u);
  EXPECT_NEAR(t.angle(), (0.2 * 0.2 + 1.3 * 1.3) / 2, 1e-6); // a circle: the closest point is the middle, too
}

TEST(Second_order_mesh, has_straight_edges_where_no_place_is_found)
{
  Uneven_triangle t;
  for(const auto h : t.curved.mesh.halfedges())
    t.curved.uv[h] = Point_2(std::numeric_limits<double>::quiet_NaN(), 0);
  const auto report = t.curved.make_nodes(t.model);
  EXPECT_EQ(report.number_of_straight, 2u);
  EXPECT_EQ(report.number_on_curves, 1u);
  EXPECT_TRUE(report.uncertified.empty());
}

// A triangle in a plane below an arc that bulges over its third corner.
TEST(Second_order_mesh, is_curved_less_where_it_would_be_folded)
{
  typedef CGAL::Parametric_plane_3<Sample_kernel> Plane;
  auto model = model_of_face(Plane(Point_3(0, 0, 0), {1, 0, 0}, {0, 1, 0}));
  typedef decltype(model)::Curve Curve;
  const double angle = 0.5; // of the arc at its ends; that of the triangle is less
  const Curve arc = Curve::arc({0, -1}, 1, CGAL_PI / 2 - angle, CGAL_PI / 2 + angle);
  const std::size_t target = model.add_vertex({arc.target().x(), arc.target().y(), 0}),
                    source = model.add_vertex({arc.source().x(), arc.source().y(), 0});
  model.add_edge(source, target);
  model.faces()[0].loops.push_back({{0, false, arc}});
  Curved_mesh curved = one_triangle(model.faces()[0].surface, arc.target(), arc.source(), {0, 0.05});
  const auto e = curved.mesh.edge(curved.mesh.halfedge(Mesh::Vertex_index(0), Mesh::Vertex_index(1)));
  curved.places[e].index = 0;
  curved.places[e].parameters = {arc.end(), arc.begin()};
  const auto report = curved.make_nodes(model);
  EXPECT_EQ(report.number_on_curves, 1u);
  EXPECT_EQ(report.number_of_curved_less, 1u);
  EXPECT_TRUE(report.uncertified.empty());
  EXPECT_GE(report.smallest_scaled_jacobian, 0.1);
  EXPECT_GT(curved.nodes[e].y(), arc.source().y());
  EXPECT_LT(curved.nodes[e].y(), 0);
}

TEST(Second_order_mesh, names_triangles_without_area)
{
  const auto model = model_of_face(CGAL::Parametric_plane_3<Sample_kernel>(Point_3(0, 0, 0), {1, 0, 0}, {0, 1, 0}));
  Curved_mesh curved = one_triangle(model.faces()[0].surface, {0, 0}, {1, 0}, {2, 0});
  const auto report = curved.make_nodes(model);
  ASSERT_EQ(report.uncertified.size(), 1u);
  EXPECT_EQ(report.uncertified[0].face, 0u);
}
