// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the report lists is what fails, by all criteria and at all edges, and for the cause that was found.
#include <gtest/gtest.h>

#include <CGAL/IO/read_bezier_patches.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>

#include <Sample_models.h>
#include <mesher_test_helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>

using namespace CGAL::Parametric_surface_mesher;

namespace {

const double pi = 4 * std::atan(1.);

// A triangle, with its corners in the domain.
struct Corners
{
  std::array<Point_3, 3> points;
  std::array<Point_2, 3> uv;
};

// What an edge or a triangle has of some measure: where the parametrisation changes its speed along an edge, the surface over its
// middle is displaced within itself, too, and the mesher may leave that out.
struct Range
{
  double low, high;
};

Range larger(const Range& a, const Range& b) { return {(std::max)(a.low, b.low), (std::max)(a.high, b.high)}; }

// Measures of a triangle, independently of the mesher.
template <class Surface>
class Audit
{
  const Surface& m_surface;
  const Corners& m_corners;

public:
  Audit(const Surface& surface, const Corners& corners) : m_surface(surface), m_corners(corners) {}

  double smallest_angle() const
  {
    const auto& p = m_corners.points;
    return (std::min)({angle_at(p[0], p[1], p[2]), angle_at(p[1], p[2], p[0]), angle_at(p[2], p[0], p[1])});
  }

  Range deviation() const { return larger(larger(ratio(0), ratio(1)), ratio(2)); }

  // At the middles and the centroid, and at most what is found in many places: where these come close to the bound the mesher
  // looks at more of them, and adds half a percent for the places between. (Here two percent are added, as its places are others.)
  Range distance() const
  {
    const Range coarse = larger(larger(above(1. / 3, 1. / 3), height(0)), larger(height(1), height(2)));
    Range fine = coarse;
    const int n = 24;
    for(int i = 0; i <= n; ++i)
      for(int k = 0; i + k <= n; ++k)
        fine = larger(fine, above(double(i) / n, double(k) / n));
    for(int i = 0; i < 3; ++i)
      for(int k = 1; k < n; ++k)
        fine = larger(fine, height(i, double(k) / n));
    return {coarse.low, 1.02 * fine.high};
  }

private:
  Vector_3 edge(int i) const { return m_corners.points[(i + 1) % 3] - m_corners.points[i]; }

  Range ratio(int i) const
  {
    const double length = std::sqrt(edge(i).squared_length());
    return {height(i).low / length, height(i).high / length};
  }

  // over the plane of the triangle, at the place with these barycentric coordinates
  Range above(double x, double y) const
  {
    const auto& uv = m_corners.uv;
    const Point_2 place = CGAL::barycenter(uv[0], x, uv[1], y, uv[2], 1 - x - y);
    const Vector_3 normal = cross_product(edge(0), edge(1));
    const double result = std::fabs(normal * (m_surface.point(place.x(), place.y()) - m_corners.points[0]))
                          / std::sqrt(normal.squared_length());
    return {result, result};
  }

  // over an edge, at a share of the way along it
  Range height(int i, double share = 0.5) const
  {
    const Point_2 place = m_corners.uv[i] + share * (m_corners.uv[(i + 1) % 3] - m_corners.uv[i]);
    const auto jet = m_surface.jet(place.x(), place.y());
    const Vector_3 to_surface = m_surface.point(place.x(), place.y()) - m_corners.points[i];
    const Vector_3 height = to_surface - (to_surface * edge(i) / edge(i).squared_length()) * edge(i);
    const Vector_3 normal = cross_product(jet.du, jet.dv);
    return {std::fabs(height * normal) / std::sqrt(normal.squared_length()), std::sqrt(height.squared_length())};
  }
};

// Counts triangles of which the report says something else than is found.
struct Disagreement
{
  std::size_t silent = 0, wrong = 0, listed = 0;

  // what is but for rounding at the bound counts as neither
  void compare(const Range& ratio, bool is_listed)
  {
    silent += ratio.low > 1 + 1e-6 && !is_listed;
    wrong += ratio.high < 1 - 1e-6 && is_listed;
    listed += is_listed;
  }

  static Range over(const Range& range, double bound) { return {range.low / bound, range.high / bound}; }

  template <class Surface>
  void add(const Surface& surface, const Corners& corners, const Criteria& criteria, Criterion_set failed)
  {
    const Audit<Surface> audit(surface, corners);
    const double angle = criteria.angle() / audit.smallest_angle();
    compare({angle, angle}, failed.contains(Mesh_criterion::ANGLE));
    compare(over(audit.deviation(), criteria.gamma()), failed.contains(Mesh_criterion::DEVIATION));
    if(criteria.distance())
      compare(over(audit.distance(), *criteria.distance()), failed.contains(Mesh_criterion::DISTANCE));
  }
};

std::map<std::size_t, Criterion_set> failed_by_face(const Report& report)
{
  std::map<std::size_t, Criterion_set> result;
  for(const auto& unmet : report.unmet) {
    EXPECT_FALSE(unmet.criteria.empty());
    EXPECT_TRUE(result.emplace(unmet.face, unmet.criteria).second) << unmet.face << " is listed twice";
  }
  return result;
}

// Compares the whole report of a patch with what its triangles fail.
template <class Surface>
Disagreement audit_patch(const Surface& surface, const Mesh& mesh, const Criteria& criteria, const Report& report)
{
  auto failed = failed_by_face(report);
  const Uv_map uv = uv_map(mesh);
  Disagreement result;
  for(const auto f : mesh.faces()) {
    const auto v = corners(mesh, f);
    result.add(surface, {{mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])}, {uv[v[0]], uv[v[1]], uv[v[2]]}}, criteria,
               failed[f]);
  }
  EXPECT_EQ(0u, result.silent) << "of " << mesh.number_of_faces() << " triangles, that fail and are not listed";
  EXPECT_EQ(0u, result.wrong) << "of " << mesh.number_of_faces() << " triangles, that are listed and do not fail";
  return result;
}

template <class Surface>
Report mesh_and_audit(const Surface& surface, const Domain& domain, const Criteria& criteria)
{
  Mesh mesh;
  const Report report = add_patch(surface, domain, criteria, mesh);
  audit_patch(surface, mesh, criteria, report);
  return report;
}

// a criterion that nothing can meet
struct Impossible
{
  template <class Triangle>
  double operator()(const Triangle&) const
  {
    return 2;
  }
};

} // namespace

TEST(Criterion_set, holds_what_was_added)
{
  Criterion_set set;
  EXPECT_TRUE(set.empty());
  EXPECT_EQ("", names(set));
  set |= Mesh_criterion::DISTANCE;
  set |= Mesh_criterion::ANGLE;
  EXPECT_TRUE(set.contains(Mesh_criterion::ANGLE));
  EXPECT_TRUE(set.contains(Mesh_criterion::DISTANCE));
  EXPECT_FALSE(set.contains(Mesh_criterion::SIZE));
  EXPECT_FALSE(set.contains(Mesh_criterion::INVERTED));
  EXPECT_EQ("angle, distance", names(set));
  EXPECT_TRUE(set == (Criterion_set(Mesh_criterion::ANGLE) | Mesh_criterion::DISTANCE));
  EXPECT_TRUE(set != Mesh_criterion::ANGLE);
}

TEST(Verdicts, all_have_names)
{
  for(const Mesh_criterion criterion : all_criteria())
    EXPECT_NE(std::string(), name(criterion));
  for(const Unmet_cause cause : all_causes())
    EXPECT_NE(std::string(), name(cause));
}

// No edge can be divided, and the surface is far away.
TEST(Verdicts, short_edges_have_a_distance)
{
  const CGAL::Parametric_sphere_3<Test_kernel> sphere(1);
  const Domain domain = Domain::rectangle(0, 1, -0.5, 0.5);
  const Criteria criteria = Criteria().set_max_edge(0.2).set_min_edge(0.14).set_distance(1e-5);
  const Report report = mesh_and_audit(sphere, domain, criteria);
  EXPECT_GT(report.number_of_faces, 20u);
  EXPECT_EQ(report.number_of_faces, report.count(Mesh_criterion::DISTANCE));
  EXPECT_GT(report.count(Mesh_criterion::DISTANCE, Unmet_cause::MINIMUM_EDGE), 0u);
}

TEST(Verdicts, distance_that_the_minimum_edge_forbids)
{
  const Sample peak = make_sample("peak");
  const Report report
    = mesh_and_audit(peak.surface, peak.domain, Criteria().set_distance(1e-9).set_min_edge(0.02).set_max_edge(0.1));
  EXPECT_GT(report.count(Mesh_criterion::DISTANCE, Unmet_cause::MINIMUM_EDGE), report.number_of_faces / 2);
}

// Four edges along a quarter of a circle each are too long for the ratio, and no point inside changes that.
TEST(Verdicts, edges_of_the_boundary_are_judged)
{
  const CGAL::Parametric_cylinder_3<Test_kernel> cylinder(1);
  Domain domain = Domain::rectangle(0, pi, 0, 1);
  domain.loops().front()[0].set_number_of_edges(4);
  domain.loops().front()[2].set_number_of_edges(4);
  const Report report = mesh_and_audit(cylinder, domain, Criteria().set_max_edge(1));
  EXPECT_GE(report.count(Mesh_criterion::DEVIATION, Unmet_cause::BOUNDARY), 8u);
}

TEST(Verdicts, triangles_list_all_that_they_fail)
{
  const Sample peak = make_sample("peak");
  const Report report = mesh_and_audit(
    peak.surface, peak.domain, Criteria().set_gamma(1e-4).set_distance(1e-6).set_min_edge(0.05).set_max_edge(0.1));
  EXPECT_GT(std::count_if(report.unmet.begin(), report.unmet.end(),
                          [](const Report::Unmet& unmet) {
                            return unmet.criteria == (Criterion_set(Mesh_criterion::DEVIATION) | Mesh_criterion::DISTANCE);
                          }),
            std::ptrdiff_t(report.number_of_faces) / 4);
}

// The minimum edge stops it everywhere, also at the boundary, where a few points are too close to that.
TEST(Verdicts, cause_is_what_was_found)
{
  const Sample flat = make_sample("flat");
  Mesh mesh;
  const Report report = add_patch(flat.surface, flat.domain, Criteria().set_max_edge(0.1).set_min_edge(0.05), mesh,
                                  CGAL::parameters::triangle_criterion(Impossible()));
  EXPECT_EQ(report.number_of_faces, report.unmet.size());
  EXPECT_EQ(report.number_of_faces, report.count(Mesh_criterion::USER));
  std::size_t at_boundary_for_minimum_edge = 0, inside_for_boundary = 0;
  for(const auto& unmet : report.unmet) {
    const bool touches = touches_border(mesh, Mesh::Face_index(Mesh::size_type(unmet.face)));
    at_boundary_for_minimum_edge += touches && unmet.cause == Unmet_cause::MINIMUM_EDGE;
    inside_for_boundary += !touches && unmet.cause == Unmet_cause::BOUNDARY;
  }
  EXPECT_GT(at_boundary_for_minimum_edge, 10u);
  EXPECT_LE(inside_for_boundary, report.number_of_faces / 50);
}

// Angles that thousands of triangles cannot have, since a side is finely divided and inner edges must be long, keep repair busy for longer than
// it may take.
TEST(Verdicts, work_limit_is_a_cause)
{
  const Sample flat = make_sample("flat");
  Domain domain = flat.domain;
  domain.loops().front().front().set_number_of_edges(5000);
  const Report report = mesh_and_audit(flat.surface, domain, Criteria().set_max_edge(0.1).set_min_edge(0.05));
  EXPECT_GT(report.number_of_work_limits, 0u);
  EXPECT_GT(report.count(Mesh_criterion::ANGLE, Unmet_cause::WORK_LIMIT), 0u);
}

// An angle that most triangles cannot have makes no more triangles than one that they can have, and is not forgotten.
TEST(Verdicts, angle_limit_is_a_cause)
{
  const Sample skew = make_sample("skew");
  const Report usual = mesh_and_audit(skew.surface, skew.domain, Criteria().set_max_edge(0.1)),
               report = mesh_and_audit(skew.surface, skew.domain, Criteria().set_max_edge(0.1).set_angle(50));
  EXPECT_GT(report.count(Mesh_criterion::ANGLE, Unmet_cause::ANGLE_LIMIT), 0u);
  EXPECT_LT(report.number_of_faces, 1.2 * double(usual.number_of_faces));
  EXPECT_GT(report.smallest_angle, 32 - 1e-9);
}

TEST(Verdicts, audit_of_patches)
{
  for(const char* name : {"peak", "hole", "bend", "skew"})
    for(const double distance : {1e-2, 1e-4}) {
      SCOPED_TRACE(name);
      const Sample sample = make_sample(name);
      mesh_and_audit(sample.surface, sample.domain, Criteria().set_max_edge(0.15).set_distance(distance).set_min_edge(0.02));
    }
}

TEST(Verdicts, audit_of_bezier_patches)
{
  const std::string file = std::string(CGAL_TEST_DATA_DIR) + "/teapot.bpt";
  std::size_t number_of_patches = 0;
  for(const auto& surface : CGAL::IO::read_bezier_patches<Test_kernel>(file)) {
    const bool is_regular = surface.point(0, 0) != surface.point(1, 0) && surface.point(0, 1) != surface.point(1, 1)
                            && surface.point(0, 0) != surface.point(0, 1) && surface.point(1, 0) != surface.point(1, 1);
    if(!is_regular)
      continue;
    SCOPED_TRACE(number_of_patches++);
    mesh_and_audit(surface, Domain::rectangle(0, 1, 0, 1), Criteria().set_max_edge(0.4).set_distance(1e-3).set_min_edge(0.05));
  }
  EXPECT_GT(number_of_patches, 10u);
}

TEST(Verdicts, audit_of_a_model)
{
  const Sample_model box = make_sample_model("box");
  const Criteria criteria = Criteria().set_max_edge(0.4).set_distance(1e-4).set_min_edge(0.05).set_angle(45);
  Mesh mesh;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv", Point_2(0, 0)).first;
  const auto patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch", 0).first;
  const Report report = CGAL::make_parametric_surface_mesh(
    box.model, criteria, mesh, CGAL::parameters::halfedge_uv_map(uv, CGAL::parameters::face_patch_id_map(patch)));
  auto failed = failed_by_face(report);
  Disagreement found;
  for(const auto f : mesh.faces()) {
    Corners corners;
    auto h = mesh.halfedge(f);
    for(int i = 0; i < 3; ++i, h = mesh.next(h)) {
      corners.points[i] = mesh.point(mesh.target(h));
      corners.uv[i] = uv[h];
    }
    found.add(box.model.faces()[patch[f]].surface, corners, criteria, failed[f]);
  }
  EXPECT_EQ(0u, found.silent);
  EXPECT_EQ(0u, found.wrong);
  EXPECT_GT(found.listed, 0u);
}
