// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The free function on the named surfaces: quality, output maps, visitor, limits, sizes and criteria of the user.
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Triangle_mesh_deviation.h>
#include <CGAL/Triangle_mesh_quality.h>

#include <gtest/gtest.h>

#include <Sample_surfaces.h>
#include <check_invariants.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace {

Criteria uniform(const Sample& sample, double number_of_triangles)
{
  return Criteria().set_max_edge(sample.edge_length(number_of_triangles));
}

// What every named surface must reach with default criteria.
void check_quality(const Sample& sample, const Criteria& criteria)
{
  Mesh mesh;
  const Report report = add_patch(sample.surface, sample.domain, criteria, mesh);
  EXPECT_EQ(0u, report.unmet.size());
  EXPECT_GE(report.smallest_angle, 30);
  check_topology(mesh, sample.domain.loops().size() - 1);
  const CGAL::Triangle_mesh_quality quality = CGAL::triangle_mesh_quality(mesh);
  EXPECT_GE(quality.min_angle, 30 - 1e-9);
  EXPECT_EQ(0, quality.share_below_30_degrees);
  EXPECT_GE(quality.mean_radius_ratio, 0.90);
  EXPECT_NEAR(sample.area, quality.area, 0.01 * sample.area);
  const auto deviation = CGAL::triangle_mesh_deviation(mesh, sample.surface, uv_map(mesh), 4, criteria.max_edge() / 100);
  EXPECT_LE(deviation.max_inner_deviation_ratio, criteria.gamma());
  EXPECT_EQ(0, deviation.max_distance_to_vertex);
  EXPECT_EQ(0u, deviation.number_of_inverted_faces);
  EXPECT_EQ(0u, deviation.number_of_domain_violations);
}

// counts its calls, and stops when `limit` vertices are there
struct Stopping_visitor : CGAL::Parametric_surface_mesh_visitor
{
  std::size_t limit, vertices = 0, progress_calls = 0;
  std::vector<std::string> phases;

  explicit Stopping_visitor(std::size_t number) : limit(number) {}

  void on_phase(const char* name) { phases.push_back(name); }

  void on_progress(std::size_t number_of_vertices, std::size_t)
  {
    EXPECT_GT(number_of_vertices, vertices);
    vertices = number_of_vertices;
    ++progress_calls;
  }

  bool go_further() { return vertices < limit; }
};

// An interrupted mesh is valid, and lists what is not done for `cause`.
void check_interrupted(const Sample& sample, const Mesh& mesh, const Report& report, CGAL::Parametric_surface_mesher::Unmet_cause cause)
{
  check_topology(mesh, sample.domain.loops().size() - 1);
  EXPECT_GT(report.unmet.size(), 0u);
  EXPECT_EQ(report.unmet.size(), report.count(cause));
  const auto unmet = unmet_by_face(report);
  for(const auto f : mesh.faces())
    EXPECT_TRUE(unmet.count(f) == 1 || shape(mesh, f).min_angle >= 30 - 1e-9) << f;
}

} // namespace

TEST(Make_parametric_surface_mesh, named_surfaces)
{
  for(const std::string name : {"flat", "bend", "peak", "hole", "cap", "torus", "cyl", "skew", "stretch"}) {
    SCOPED_TRACE(name);
    const Sample sample = make_sample(name);
    check_quality(sample, uniform(sample, 5000));
  }
}

TEST(Make_parametric_surface_mesh, graded_hole)
{
  Sample hole = make_sample("hole");
  for(auto& curve : hole.domain.loops()[0])
    curve.set_number_of_edges(10);
  hole.domain.loops()[1][0].set_number_of_edges(400);
  Mesh mesh;
  const Report report = add_patch(hole.surface, hole.domain, Criteria().set_max_edge(0.25), mesh);
  EXPECT_EQ(440u, report.number_of_boundary_edges);
  EXPECT_EQ(0u, report.unmet.size());
  check_topology(mesh, 1);
  EXPECT_GE(CGAL::triangle_mesh_quality(mesh).min_angle, 30 - 1e-9);
  EXPECT_LT(mesh.number_of_faces(), 6000u); // coarse away from the circle
}

TEST(Make_parametric_surface_mesh, report_and_identity)
{
  for(const std::string name : {"peak", "hole", "skew"}) {
    SCOPED_TRACE(name);
    const Sample sample = make_sample(name);
    const Report report
      = check_invariants(sample.surface, sample.domain, uniform(sample, 2000).set_min_edge(sample.edge_length(2000) / 100));
    EXPECT_GT(report.seconds.meshing(), 0);
    EXPECT_LE(report.smallest_angle, report.smallest_angle_off_boundary);
  }
}

TEST(Make_parametric_surface_mesh, polyhedron_gives_the_same_mesh)
{
  const Sample peak = make_sample("peak");
  Mesh mesh;
  add_patch(peak.surface, peak.domain, uniform(peak, 1000), mesh);
  CGAL::Polyhedron_3<Test_kernel> polyhedron;
  const Report report = CGAL::make_parametric_surface_mesh(peak.surface, peak.domain, uniform(peak, 1000), polyhedron);
  EXPECT_TRUE(polyhedron.is_valid());
  ASSERT_EQ(mesh.number_of_vertices(), polyhedron.size_of_vertices());
  EXPECT_EQ(mesh.number_of_faces(), polyhedron.size_of_facets());
  EXPECT_EQ(polyhedron.size_of_facets(), report.number_of_faces);
  auto v = polyhedron.vertices_begin();
  for(const auto w : mesh.vertices())
    EXPECT_EQ(mesh.point(w), (v++)->point());
}

TEST(Make_parametric_surface_mesh, property_maps)
{
  const Sample peak = make_sample("peak");
  Mesh mesh;
  const auto points = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:other_point").first;
  const auto corner_points = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  add_patch(peak.surface, peak.domain, uniform(peak, 500), mesh,
            CGAL::parameters::halfedge_uv_map(corner_points, CGAL::parameters::vertex_point_map(points)));
  const Uv_map uv = uv_map(mesh);
  for(const auto v : mesh.vertices())
    EXPECT_EQ(peak.surface.point(uv[v].x(), uv[v].y()), points[v]);
  for(const auto h : mesh.halfedges())
    EXPECT_TRUE(mesh.is_border(h) || corner_points[h] == uv[mesh.target(h)]);
}

TEST(Make_parametric_surface_mesh, adds_to_a_mesh)
{
  const Sample peak = make_sample("peak"), hole = make_sample("hole");
  Mesh mesh;
  const Report first = add_patch(peak.surface, peak.domain, uniform(peak, 500), mesh);
  const Mesh before = mesh;
  const Report second = add_patch(hole.surface, hole.domain, uniform(hole, 500), mesh);
  EXPECT_EQ(first.number_of_vertices + second.number_of_vertices, mesh.number_of_vertices());
  EXPECT_EQ(first.number_of_faces + second.number_of_faces, mesh.number_of_faces());
  for(const auto v : before.vertices())
    EXPECT_EQ(before.point(v), mesh.point(v));
  for(const auto f : before.faces())
    EXPECT_EQ(corners(before, f), corners(mesh, f));
}

TEST(Make_parametric_surface_mesh, visitor)
{
  const Sample peak = make_sample("peak");
  Stopping_visitor visitor(100000000);
  Mesh mesh;
  add_patch(peak.surface, peak.domain, uniform(peak, 10000).set_max_number_of_sweeps(3), mesh,
            CGAL::parameters::visitor(std::ref(visitor)));
  EXPECT_EQ((std::vector<std::string>{"division", "triangulation", "refinement", "smoothing", "refinement", "improvement",
                                      "polishing", "output"}),
            visitor.phases);
  EXPECT_GE(visitor.progress_calls, 5u);
  EXPECT_LE(visitor.vertices, mesh.number_of_vertices());
}

TEST(Make_parametric_surface_mesh, stopped_by_the_visitor)
{
  const Sample hole = make_sample("hole");
  Stopping_visitor visitor(2000);
  Mesh mesh;
  const Report report
    = add_patch(hole.surface, hole.domain, uniform(hole, 50000), mesh, CGAL::parameters::visitor(std::ref(visitor)));
  EXPECT_GE(mesh.number_of_vertices(), 2000u);
  EXPECT_LT(mesh.number_of_vertices(), 4000u);
  check_interrupted(hole, mesh, report, CGAL::Parametric_surface_mesher::Unmet_cause::STOPPED);
}

TEST(Make_parametric_surface_mesh, vertex_limit)
{
  const Sample hole = make_sample("hole");
  Mesh mesh;
  const Report report = add_patch(hole.surface, hole.domain, uniform(hole, 50000).set_max_number_of_vertices(3000), mesh);
  EXPECT_EQ(3000u, mesh.number_of_vertices());
  check_interrupted(hole, mesh, report, CGAL::Parametric_surface_mesher::Unmet_cause::VERTEX_LIMIT);
}
