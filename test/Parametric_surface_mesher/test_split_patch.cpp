// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A patch that is split into parts gives a mesh as good as one that is whole, and the same on any number of threads.
#include <gtest/gtest.h>

#include <CGAL/Parametric_surface_mesh_visitor.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Loop_inside.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Triangle_mesh_quality.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <Sample_models.h>
#include <Sample_surfaces.h>
#include <check_invariants.h>
#include <mesher_test_helpers.h>
#include <random_input.h>

#include <tbb/global_control.h>

#include <cmath>
#include <algorithm>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <set>
#include <vector>

namespace {

const std::size_t number_of_triangles = 20000, part_size = 6000; // so the parts have up to 3000

Criteria criteria_of(const Sample& sample, std::size_t size_of_parts)
{
  return Criteria().set_max_edge(sample.edge_length(number_of_triangles)).set_part_size(size_of_parts);
}

// counts triangulations: of a patch that is not split there is one
struct Part_counter : CGAL::Parametric_surface_mesh_visitor
{
  std::size_t number_of_parts = 0;

  void on_phase(const char* name) { number_of_parts += std::string(name) == "triangulation"; }
};

struct Result
{
  Mesh mesh;
  Report report;
  std::size_t number_of_parts;
};

template <class ConcurrencyTag = CGAL::Sequential_tag, class Surface>
Result mesh_patch(const Surface& surface, const Domain& domain, const Criteria& criteria, int number_of_threads = 1)
{
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, std::size_t(number_of_threads));
  Result result;
  Part_counter counter;
  result.report = CGAL::make_parametric_surface_mesh<ConcurrencyTag>(
    surface, domain, criteria, result.mesh, CGAL::parameters::vertex_uv_map(uv_map(result.mesh)).visitor(std::ref(counter)));
  result.number_of_parts = counter.number_of_parts;
  return result;
}

template <class ConcurrencyTag = CGAL::Sequential_tag>
Result mesh_sample(const Sample& sample, const Criteria& criteria, int number_of_threads = 1)
{
  return mesh_patch<ConcurrencyTag>(sample.surface, sample.domain, criteria, number_of_threads);
}

void check_same(const Result& a, const Result& b)
{
  check_identical(a.mesh, b.mesh);
  check_identical_connectivity(a.mesh, b.mesh);
  EXPECT_EQ(a.report.smallest_angle, b.report.smallest_angle);
  EXPECT_EQ(a.report.number_of_replaced_tensors, b.report.number_of_replaced_tensors);
  ASSERT_EQ(a.report.unmet.size(), b.report.unmet.size());
  for(std::size_t i = 0; i < a.report.unmet.size(); ++i) {
    EXPECT_EQ(a.report.unmet[i].face, b.report.unmet[i].face);
    EXPECT_EQ(a.report.unmet[i].cause, b.report.unmet[i].cause);
  }
}

// the division, with one copy of each pole
template <class Surface>
Boundary_loops boundary_of(const Surface& surface, const Domain& domain, const Criteria& criteria)
{
  return CGAL::Parametric_surface_mesher::internal::without_collapsed_sides(division(surface, domain, criteria));
}

// the seams and the boundary are those of the domain, whatever is split
std::size_t number_of_holes(const Sample& sample) { return sample.domain.loops().size() - 1; }

class Split_patch : public testing::TestWithParam<std::string>
{};

// the unit square with a narrow channel from one side: parts of it meet along three sides of the channel
Domain horseshoe()
{
  return Domain({Point_2(0, 0), Point_2(1, 0), Point_2(1, 1), Point_2(0.6, 1), Point_2(0.6, 0.3), Point_2(0.4, 0.3),
                 Point_2(0.4, 1), Point_2(0, 1)});
}

} // namespace

TEST(Split_patch_criteria, size_of_parts_by_placement)
{
  EXPECT_EQ(100000u, Criteria().part_size());
  EXPECT_EQ(2000000u, Criteria().set_placement(CGAL::Parametric_surface_mesher::Mesh_point_placement::CIRCUMCENTER).part_size());
  EXPECT_EQ(2000000u, Criteria().set_placement(CGAL::Parametric_surface_mesher::Mesh_point_placement::OFF_CENTER).part_size());
  EXPECT_EQ(7u, Criteria().set_part_size(7).set_placement(CGAL::Parametric_surface_mesher::Mesh_point_placement::CIRCUMCENTER).part_size());
  EXPECT_EQ(0u, Criteria().set_part_size(0).part_size());
}

// Stars, most of whose edges run up and down, against CGAL's polygons.
TEST(Loop_inside, is_as_polygons_tell)
{
  namespace internal = CGAL::Parametric_surface_mesher::internal;
  typedef internal::Region_node<Test_kernel> Node;
  Random_input random(7);
  for(int n : {3, 4, 10, 300}) {
    CGAL::Polygon_2<Test_kernel> polygon;
    std::vector<Node> loop;
    for(int i = 0; i < n; ++i) {
      const double angle = 8 * std::atan(1.) * i / n, radius = random.real(0.3, 1);
      polygon.push_back(Point_2(1 + radius * std::cos(angle), 20 * radius * std::sin(angle)));
      loop.emplace_back(internal::Boundary_vertex<Test_kernel>{polygon[std::size_t(i)], CGAL::ORIGIN, 0}, CGAL::Metric_tensor_2());
    }
    const internal::Loop_inside<Test_kernel> is_inside(loop);
    for(int i = 0; i < 2000; ++i) {
      const Point_2 p(random.real(-0.2, 2.2), random.real(-22, 22));
      EXPECT_EQ(polygon.has_on_bounded_side(p), is_inside(p)) << n << " " << p;
    }
  }
}

TEST_P(Split_patch, is_as_good_as_whole)
{
  const Sample sample = make_sample(GetParam());
  const Criteria criteria = criteria_of(sample, part_size);
  const Result split = mesh_sample(sample, criteria), whole = mesh_sample(sample, criteria_of(sample, 0));
  EXPECT_GE(split.number_of_parts, 2 * number_of_triangles / part_size);
  EXPECT_LE(split.number_of_parts, 8 * number_of_triangles / part_size);
  EXPECT_EQ(1u, whole.number_of_parts);

  check_boundary(split.mesh, boundary_of(sample.surface, sample.domain, criteria));
  check_topology(split.mesh, number_of_holes(sample));

  const CGAL::Triangle_mesh_quality q = CGAL::triangle_mesh_quality(split.mesh), q0 = CGAL::triangle_mesh_quality(whole.mesh);
  EXPECT_NEAR(q0.area, q.area, 2e-4 * q0.area);
  // where sizes differ much the division of the cuts costs triangles
  EXPECT_NEAR(double(q0.number_of_faces), double(q.number_of_faces), (GetParam() == "peak" ? 0.16 : 0.05) * double(q0.number_of_faces));
  EXPECT_GT(q.min_angle, 36);
  EXPECT_GT(q.mean_radius_ratio, 0.99);
  // in both, pieces of the boundary that meet at right angles may have squares, with a diagonal across
  EXPECT_LT((std::max)(q.max_edge_length, q0.max_edge_length), 1.42 * criteria.max_edge());
  EXPECT_TRUE(split.report.unmet.empty());
  EXPECT_NEAR(q.min_angle, split.report.smallest_angle, 1e-6);
}

TEST_P(Split_patch, is_the_same_on_any_number_of_threads)
{
  const Sample sample = make_sample(GetParam());
  const Criteria criteria = criteria_of(sample, part_size);
  const Result sequential = mesh_sample(sample, criteria);
  check_same(sequential, mesh_sample<CGAL::Parallel_tag>(sample, criteria, 1));
  check_same(sequential, mesh_sample<CGAL::Parallel_tag>(sample, criteria, 4));
}

INSTANTIATE_TEST_SUITE_P(Samples, Split_patch, testing::Values("flat", "bend", "peak", "hole", "cap", "sphere", "torus", "cyl", "skew",
                                                                       "stretch"),
                         [](const auto& parameter) { return parameter.param; });

// Lines meet such a domain several times, and leave more than two parts.
TEST(Split_patch_of_odd_shape, horseshoe)
{
  const Sample flat = make_sample("flat");
  const Criteria criteria = criteria_of(flat, part_size);
  const Result split = mesh_patch(flat.surface, horseshoe(), criteria);
  EXPECT_GE(split.number_of_parts, 4u);
  check_boundary(split.mesh, division(flat.surface, horseshoe(), criteria));
  check_topology(split.mesh, 0);
  const CGAL::Triangle_mesh_quality q = CGAL::triangle_mesh_quality(split.mesh);
  EXPECT_NEAR(0.86, q.area, 1e-9);
  EXPECT_GT(q.min_angle, 36);
  EXPECT_GT(q.mean_radius_ratio, 0.99);
}

// Boundaries may run either way.
TEST(Split_patch_of_odd_shape, clockwise_disk_with_holes)
{
  Domain domain(Domain::Loop{Curve::arc(Point_2(0, 0), 1, 8 * std::atan(1.), 0)});
  for(double x : {-0.5, 0., 0.4})
    domain.add_hole({Curve::circle(Point_2(x, 0.3 * x), 0.1)});
  const Sample flat = make_sample("flat");
  const Criteria criteria = Criteria().set_max_edge(0.02).set_part_size(part_size);
  const Result split = mesh_patch(flat.surface, domain, criteria);
  EXPECT_GE(split.number_of_parts, 4u);
  check_boundary(split.mesh, division(flat.surface, domain, criteria));
  check_topology(split.mesh, 3);
  const CGAL::Triangle_mesh_quality q = CGAL::triangle_mesh_quality(split.mesh);
  EXPECT_GT(q.min_angle, 36);
  EXPECT_GT(q.mean_radius_ratio, 0.99);
}

// The spacing of cuts follows that of the mesh: from a fine hole outwards, and as a sizing field wants.
TEST(Split_patch_of_odd_shape, graded_spacing)
{
  const Sample flat = make_sample("flat");
  const Criteria criteria = Criteria()
                              .set_max_edge(0.02)
                              .set_part_size(part_size)
                              .set_sizing_field([](double u, double v) { return 0.002 + 0.03 * std::hypot(u - 0.3, v - 0.4); });
  const Result split = mesh_sample(flat, criteria), whole = mesh_sample(flat, Criteria(criteria).set_part_size(0));
  EXPECT_GE(split.number_of_parts, 3u);
  check_topology(split.mesh, 0);
  EXPECT_NEAR(double(whole.report.number_of_faces), double(split.report.number_of_faces), 0.05 * double(whole.report.number_of_faces));
  EXPECT_GT(split.report.smallest_angle, 33);
  EXPECT_GT(CGAL::triangle_mesh_quality(split.mesh).mean_radius_ratio, 0.98);
}

TEST(Split_patch_of_odd_shape, finely_divided_hole)
{
  Domain domain = Domain::rectangle(-1, 1, -1, 1);
  Curve circle = Curve::circle(Point_2(0.2, 0.1), 0.25);
  circle.set_number_of_edges(500);
  domain.add_hole({circle});
  const Sample flat = make_sample("flat");
  const Criteria criteria = Criteria().set_max_edge(0.04).set_part_size(part_size);
  const Result split = mesh_patch(flat.surface, domain, criteria),
               whole = mesh_patch(flat.surface, domain, Criteria(criteria).set_part_size(0));
  EXPECT_GE(split.number_of_parts, 4u);
  check_topology(split.mesh, 1);
  EXPECT_NEAR(double(whole.report.number_of_faces), double(split.report.number_of_faces), 0.16 * double(whole.report.number_of_faces));
  EXPECT_GT(split.report.smallest_angle, 36);
  EXPECT_GT(CGAL::triangle_mesh_quality(split.mesh).mean_radius_ratio, 0.98);
}

// One pole, all around which the patch lies; cuts are straight in its chart.
TEST(Split_patch_of_odd_shape, hemisphere)
{
  const auto surface = CGAL::make_parametric_function_surface([](auto u, auto v) {
    using std::cos;
    using std::sin;
    return CGAL::parametric_surface_point(cos(u) * cos(v), sin(u) * cos(v), sin(v));
  });
  const Domain domain = Domain::rectangle(0, 2 * CGAL_PI, 0, CGAL_PI / 2);
  const Criteria criteria = Criteria().set_max_edge(0.03).set_part_size(part_size);
  const Result split = mesh_patch(surface, domain, criteria),
               whole = mesh_patch(surface, domain, Criteria(criteria).set_part_size(0));
  EXPECT_GE(split.number_of_parts, 4u);
  check_boundary(split.mesh, boundary_of(surface, domain, criteria));
  check_topology(split.mesh, 0);
  const CGAL::Triangle_mesh_quality q = CGAL::triangle_mesh_quality(split.mesh);
  EXPECT_NEAR(2 * CGAL_PI, q.area, 2e-3); // the triangles lie inside
  EXPECT_GT(q.min_angle, 36);
  EXPECT_GT(q.mean_radius_ratio, 0.99);
  EXPECT_NEAR(double(whole.report.number_of_faces), double(split.report.number_of_faces), 0.03 * double(whole.report.number_of_faces));
  EXPECT_TRUE(split.report.unmet.empty());
}

// The field takes points of the domain, whatever the chart.
TEST(Split_patch_of_odd_shape, sizing_field_of_a_patch_with_poles)
{
  const Sample sphere = make_sample("sphere");
  const auto field = [&](double u, double v) { return 0.02 + 0.012 * sphere.surface.point(u, v).x(); };
  const Criteria criteria = Criteria().set_max_edge(0.1).set_part_size(part_size).set_sizing_field(field);
  const Result split = mesh_sample(sphere, criteria), whole = mesh_sample(sphere, Criteria(criteria).set_part_size(0));
  EXPECT_GE(split.number_of_parts, 3u);
  EXPECT_NEAR(double(whole.report.number_of_faces), double(split.report.number_of_faces), 0.05 * double(whole.report.number_of_faces));
  EXPECT_GT(split.report.smallest_angle, 36);
}

// Whether a vertex of the face, or one at most two edges away from such a one, is on the boundary of the patch, whose vertices
// are the first ones.
bool is_beside_boundary(const Result& result, Mesh::Face_index face)
{
  const auto vertices = corners(result.mesh, face);
  std::set<Mesh::Vertex_index> reached(vertices.begin(), vertices.end());
  for(int ring = 0; ring < 2; ++ring) {
    const std::set<Mesh::Vertex_index> inner = reached;
    for(const auto v : inner)
      for(const auto w : result.mesh.vertices_around_target(result.mesh.halfedge(v)))
        reached.insert(w);
  }
  return std::any_of(reached.begin(), reached.end(),
                     [&](Mesh::Vertex_index v) { return std::size_t(v) < result.report.number_of_boundary_edges; });
}

// A triangle that is reported fails what it is said to fail, and all that fail are reported.
TEST(Split_patch_report, names_the_right_triangles)
{
  const Sample sample = make_sample("peak");
  const double bound = 36;
  const Result split = mesh_sample(
    sample, criteria_of(sample, part_size)
              .set_angle(bound)
              .set_improvement_angle(0)
              .set_placement(CGAL::Parametric_surface_mesher::Mesh_point_placement::CIRCUMCENTER)
              .set_max_number_of_sweeps(0));
  EXPECT_GE(split.number_of_parts, 4u);
  ASSERT_FALSE(split.report.unmet.empty());
  std::vector<bool> is_reported(split.mesh.number_of_faces(), false);
  for(const auto& unmet : split.report.unmet) {
    is_reported.at(unmet.face) = true;
    if(unmet.criteria.contains(CGAL::Parametric_surface_mesher::Mesh_criterion::ANGLE)) {
      EXPECT_LT(shape(split.mesh, Mesh::Face_index(Mesh::size_type(unmet.face))).min_angle, bound + 0.05);
    }
  }
  for(const auto f : split.mesh.faces())
    if(shape(split.mesh, f).min_angle < bound - 0.05) {
      EXPECT_TRUE(is_reported[f]) << f;
    }
  // only what is beside the boundary of the patch is limited by it: no cut is told of
  for(const auto& unmet : split.report.unmet)
    if(unmet.cause == CGAL::Parametric_surface_mesher::Unmet_cause::BOUNDARY) {
      EXPECT_TRUE(is_beside_boundary(split, Mesh::Face_index(Mesh::size_type(unmet.face)))) << unmet.face;
    }
}

TEST(Split_patch_report, limit_of_vertices)
{
  const Sample sample = make_sample("torus");
  const Criteria criteria = criteria_of(sample, part_size);
  const std::size_t n = mesh_sample(sample, criteria).report.number_of_vertices;
  for(const std::size_t limit : {n / 3, n / 2}) {
    const Criteria limited = Criteria(criteria).set_max_number_of_vertices(limit);
    const Result result = mesh_sample(sample, limited);
    EXPECT_LE(result.mesh.number_of_vertices(), limit);
    EXPECT_GT(result.mesh.number_of_vertices(), 9 * limit / 10);
    EXPECT_GT(result.report.count(CGAL::Parametric_surface_mesher::Unmet_cause::VERTEX_LIMIT), 0u);
    check_topology(result.mesh, 0);
    check_same(result, mesh_sample<CGAL::Parallel_tag>(sample, limited, 2));
  }
}

// Wherever it is stopped there is a mesh, and it says so.
TEST(Split_patch_report, stop_by_visitor)
{
  struct Stopping_visitor : CGAL::Parametric_surface_mesh_visitor
  {
    std::size_t questions_left; // once the boundary is divided
    bool is_divided = false;
    void on_phase(const char* name) { is_divided = is_divided || std::string(name) != "division"; }
    bool go_further() { return !is_divided || (questions_left > 0 && --questions_left > 0); }
  };
  const Sample sample = make_sample("hole");
  for(const std::size_t number_of_questions : {1u, 5u, 12u}) {
    SCOPED_TRACE(number_of_questions);
    Stopping_visitor visitor;
    visitor.questions_left = number_of_questions;
    Mesh mesh;
    const Criteria criteria = criteria_of(sample, part_size);
    const Report report = add_patch(sample.surface, sample.domain, criteria, mesh);
    Mesh stopped;
    const Report report_of_stopped
      = CGAL::make_parametric_surface_mesh(sample.surface, sample.domain, criteria, stopped,
                                           CGAL::parameters::vertex_uv_map(uv_map(stopped)).visitor(std::ref(visitor)));
    EXPECT_GT(report_of_stopped.count(CGAL::Parametric_surface_mesher::Unmet_cause::STOPPED), 0u);
    EXPECT_LT(report_of_stopped.number_of_faces, report.number_of_faces);
    check_boundary(stopped, division(sample.surface, sample.domain, criteria));
    check_topology(stopped, 1);
  }
}

// of a part; the mesh stays as it was
TEST(Split_patch_report, error_in_a_part)
{
  struct Throwing_surface
  {
    typedef Test_kernel Geom_traits;
    typedef Geom_traits::Point_3 Point_3;

    Point_3 point(double u, double v) const { return jet(u, v).point; }

    CGAL::Surface_jet_3<Test_kernel> jet(double u, double v) const
    {
      if(std::hypot(u - 0.2, v - 0.2) < 0.02 || std::hypot(u - 0.8, v - 0.8) < 0.02)
        throw std::domain_error(u < 0.5 ? "lower" : "upper");
      return sample_surfaces::Flat().jet(u, v);
    }
  };
  std::vector<std::string> errors;
  for(const int number_of_threads : {1, 4, 4}) {
    try {
      mesh_patch<CGAL::Parallel_tag>(Throwing_surface(), make_sample("flat").domain,
                                     Criteria().set_max_edge(0.005).set_part_size(part_size), number_of_threads);
    }
    catch(const std::domain_error& error) {
      errors.push_back(error.what());
    }
  }
  ASSERT_EQ(3u, errors.size());
  EXPECT_EQ(errors[0], errors[1]);
  EXPECT_EQ(errors[0], errors[2]);
}

// Faces of a model are split, too; the mesh is closed, and each corner knows its place in its own domain.
TEST(Split_patch_of_model, all_around)
{
  for(const std::string name : {"box", "ring", "sphere", "cone"}) {
    SCOPED_TRACE(name);
    const Sample_model sample = make_sample_model(name);
    const Criteria criteria = Criteria().set_max_edge(sample.edge_length(30000)).set_part_size(2000);
    Part_counter counter;
    Mesh sequential, parallel;
    CGAL::make_parametric_surface_mesh(sample.model, criteria, sequential,
                                       CGAL::parameters::vertex_uv_map(uv_map(sequential)).visitor(std::ref(counter)));
    EXPECT_GT(counter.number_of_parts, 2 * sample.model.faces().size());
    CGAL::make_parametric_surface_mesh<CGAL::Parallel_tag>(sample.model, criteria, parallel,
                                                           CGAL::parameters::vertex_uv_map(uv_map(parallel)));
    check_identical(sequential, parallel);
    check_identical_connectivity(sequential, parallel);
    const CGAL::Triangle_mesh_quality q = CGAL::triangle_mesh_quality(sequential);
    EXPECT_TRUE(q.is_manifold);
    EXPECT_TRUE(q.is_closed);
    EXPECT_GT(q.min_angle, 33);
  }
}

TEST(Split_patch_of_model, domain_points_of_corners)
{
  const Sample sample = make_sample("torus");
  Mesh mesh;
  auto corner_uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv", Point_2(0, 0)).first;
  CGAL::make_parametric_surface_mesh(sample.surface, sample.domain, criteria_of(sample, part_size), mesh,
                                     CGAL::parameters::vertex_uv_map(uv_map(mesh), CGAL::parameters::halfedge_uv_map(corner_uv)));
  const Uv_map uv = uv_map(mesh);
  for(const auto h : mesh.halfedges())
    if(!mesh.is_border(h)) {
      ASSERT_EQ(uv[mesh.target(h)], corner_uv[h]);
    }
}
