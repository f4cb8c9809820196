// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a user can ask of the size of triangles: edge lengths, a sizing field, a distance, a criterion of their own.
#include <CGAL/Triangle_mesh_deviation.h>

#include <gtest/gtest.h>

#include <Sample_surfaces.h>
#include <mesher_test_helpers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

// inner edges must be short to the right of u = 0.5
struct Right_side_criterion
{
  double max_edge;

  template <class Triangle>
  double operator()(const Triangle& triangle) const
  {
    double result = 0;
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      if(!triangle.is_on_boundary((i + 2) % 3) && triangle.domain_point(i).x() > 0.5 && triangle.domain_point(j).x() > 0.5)
        result = (std::max)(result, squared_distance(triangle.point(i), triangle.point(j)) / (max_edge * max_edge));
    }
    return result;
  }
};

TEST(Mesh_sizes, closeness_divides_the_sides_of_a_narrow_patch)
{
  const Sample flat = make_sample("flat");
  const auto strip = sample_surfaces::Domain::rectangle(0, 10, 0, 0.3);
  Mesh coarse, mesh;
  const Report without = add_patch(flat.surface, strip, Criteria().set_max_edge(2), coarse);
  const Report with = add_patch(flat.surface, strip, Criteria().set_max_edge(2).set_closeness(1.8), mesh);
  EXPECT_EQ(without.number_of_edges_split_by_closeness, 0u);
  EXPECT_LT(without.smallest_angle, 20);
  EXPECT_GT(with.number_of_edges_split_by_closeness, 0u);
  EXPECT_GE(with.smallest_angle, 25);
  EXPECT_LT(mesh.number_of_faces(), 200u);
}

TEST(Mesh_sizes, closeness_grades_the_sides_of_a_patch)
{
  // the side at v = 0 has pieces of 2, that at v = 1.5 has pieces of 0.02: both are short enough for the width
  const Sample flat = make_sample("flat");
  auto strip = sample_surfaces::Domain::rectangle(0, 10, 0, 1.5);
  strip.loops().front()[2].set_number_of_edges(500);
  Mesh mesh;
  const Report report = add_patch(flat.surface, strip, Criteria().set_max_edge(2).set_min_edge(0.01).set_closeness(1.8), mesh);
  EXPECT_GT(report.number_of_edges_split_by_closeness, 0u);
  EXPECT_GE(report.smallest_angle, 20);
}

double smallest_angle(const Mesh& mesh, Mesh::Face_index face)
{
  double result = 180;
  for(const auto h : mesh.halfedges_around_face(mesh.halfedge(face)))
    result = (std::min)(result, CGAL::approximate_angle(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                                        mesh.point(mesh.target(mesh.next(h)))));
  return result;
}

// the number of triangles with an angle below some degrees
std::size_t number_of_sharp_triangles(const Mesh& mesh, double degrees)
{
  std::size_t result = 0;
  for(const auto face : mesh.faces())
    result += smallest_angle(mesh, face) < degrees;
  return result;
}

TEST(Mesh_sizes, the_tip_of_a_cusp_is_one_triangle)
{
  typedef sample_surfaces::Domain Domain;
  typedef Domain::Curve Curve;
  const auto parabola = [](auto t) { return std::make_pair(1 - t, 0.25 * (1 - t) * (1 - t)); };
  const Domain domain(Domain::Loop{Curve::segment({0, 0}, {1, 0}), Curve::segment({1, 0}, {1, 0.25}),
                                   Curve::from_function(parabola, 0, 1)});
  Mesh mesh;
  add_patch(make_sample("flat").surface, domain, Criteria().set_max_edge(0.3).set_min_edge(0.02).set_closeness(1.8), mesh);
  EXPECT_LE(number_of_sharp_triangles(mesh, 15), 1u);
}

// Its sides have pieces of 0.15, opposite to each other, which cannot be halved. Pieces of 0.115 have room, a third more, and
// are moved against each other as far as that helps.
TEST(Mesh_sizes, closeness_staggers_the_sides_of_a_strip)
{
  const Sample flat = make_sample("flat");
  const Criteria criteria = Criteria().set_max_edge(0.15).set_min_edge(0.1);
  double best = 0;
  for(double width : {0.05, 0.06, 0.07})
    for(double strip_length : {3., 4.5, 6.1, 9., 12.}) {
      const auto strip = sample_surfaces::Domain::rectangle(0, strip_length, 0, width);
      Mesh aligned, mesh;
      const double angle = add_patch(flat.surface, strip, criteria, aligned).smallest_angle;
      const Report report = add_patch(flat.surface, strip, Criteria(criteria).set_closeness(1.8), mesh);
      EXPECT_GE(report.smallest_angle, angle + 3) << width << " x " << strip_length;
      EXPECT_LE(mesh.number_of_faces(), 1.35 * aligned.number_of_faces());
      best = (std::max)(best, report.smallest_angle - angle);
      for(const auto e : mesh.edges())
        if(mesh.is_border(e) && std::fabs(mesh.point(mesh.vertex(e, 0)).y() - mesh.point(mesh.vertex(e, 1)).y()) < 0.01) {
          EXPECT_GE(length(mesh, e), criteria.min_edge());
          EXPECT_LT(length(mesh, e), 2 * criteria.min_edge());
        }
    }
  EXPECT_GT(best, 6);
}

// The ring is narrower than the arcs of its pieces are high: these must stay beside each other, else they cross.
TEST(Mesh_sizes, staggering_makes_no_pieces_cross)
{
  typedef sample_surfaces::Domain Domain;
  Domain ring(Domain::Loop{Domain::Curve::circle({0, 0}, 125)});
  ring.add_hole({Domain::Curve::circle({0, 0}, 124.7)});
  for(double min_edge : {10., 11., 12.}) {
    Mesh mesh;
    const Criteria criteria = Criteria().set_max_edge(16).set_min_edge(min_edge).set_distance(5);
    add_patch(make_sample("flat").surface, ring, Criteria(criteria).set_closeness(1.8), mesh);
    for(const auto e : mesh.edges()) {
      if(mesh.is_border(e)) {
        EXPECT_GT(length(mesh, e), 0.9 * min_edge);
      }
    }
  }
}

// Two slots in a plate, with a bridge between them that is much narrower than the minimum edge is long.
TEST(Mesh_sizes, closeness_divides_thin_strips_below_the_minimum_edge)
{
  typedef sample_surfaces::Domain Domain;
  const auto rectangle = [](double x0, double x1, double y0, double y1) { return Domain::rectangle(x0, x1, y0, y1).loops().front(); };
  for(double slant : {0., 0.01}) {
    Domain plate = Domain::rectangle(0, 10, 0, 10);
    plate.add_hole(rectangle(4, 6, 5, 5.5));
    plate.add_hole({Domain::Curve::segment({4, 4.5}, {6, 4.5}), Domain::Curve::segment({6, 4.5}, {6, 4.99 - slant}),
                    Domain::Curve::segment({6, 4.99 - slant}, {4, 4.99}), Domain::Curve::segment({4, 4.99}, {4, 4.5})});
    const Criteria criteria = Criteria().set_max_edge(0.2).set_min_edge(0.08);
    Mesh without, mesh;
    EXPECT_LT(add_patch(make_sample("flat").surface, plate, criteria, without).smallest_angle, 4);
    const Report report = add_patch(make_sample("flat").surface, plate, Criteria(criteria).set_closeness(1.8), mesh);
    EXPECT_GT(report.smallest_angle, 13) << slant;
    EXPECT_GT(report.number_of_edges_added_to_thin_strips, 0u);
    EXPECT_LT(mesh.number_of_faces(), 1.1 * without.number_of_faces());
  }
}

// A plate with a finger much narrower than the minimum edge is long: at its tip, points of both
// sides are opposite to each other.
TEST(Mesh_sizes, closeness_divides_thin_strips_up_to_their_ends)
{
  typedef sample_surfaces::Domain Domain;
  for(double width : {0.011, 0.0125, 0.0141}) {
    std::vector<Domain::Curve> outline;
    const std::vector<Domain::Point_2> corners
      = {{0, 0}, {10, 0}, {10, 5}, {12, 5}, {12, 5 + width}, {10, 5 + width}, {10, 10}, {0, 10}};
    for(std::size_t i = 0; i < corners.size(); ++i)
      outline.push_back(Domain::Curve::segment(corners[i], corners[(i + 1) % corners.size()]));
    Mesh mesh;
    const Criteria criteria = Criteria().set_max_edge(0.2).set_min_edge(0.08).set_closeness(1.8);
    add_patch(make_sample("flat").surface, Domain(outline), criteria, mesh);
    for(const auto face : mesh.faces())
      if(mesh.point(mesh.source(mesh.halfedge(face))).x() > 10.5) {
        EXPECT_GT(smallest_angle(mesh, face), 11) << width;
      }
  }
}

// The ring is all that there is: edges short enough for it would make ten times as many triangles.
TEST(Mesh_sizes, closeness_keeps_the_minimum_edge_where_it_would_cost_too_much)
{
  typedef sample_surfaces::Domain Domain;
  Domain ring(Domain::Loop{Domain::Curve::circle({0, 0}, 5.01)});
  ring.add_hole({Domain::Curve::circle({0, 0}, 5)});
  Mesh mesh;
  const Report report
    = add_patch(make_sample("flat").surface, ring, Criteria().set_max_edge(5).set_min_edge(0.1).set_closeness(1.8), mesh);
  for(const auto e : mesh.edges())
    if(mesh.is_border(e)) {
      EXPECT_GT(length(mesh, e), 0.1);
    }
}

TEST(Mesh_sizes, closeness_keeps_the_minimum_edge)
{
  const Sample flat = make_sample("flat");
  const auto strip = sample_surfaces::Domain::rectangle(0, 10, 0, 0.001);
  Mesh mesh;
  const Report report
    = add_patch(flat.surface, strip, Criteria().set_max_edge(2).set_min_edge(0.1).set_closeness(1.8), mesh);
  EXPECT_EQ(report.number_of_edges_split_by_closeness, 0u); // no division that is allowed would help
}

} // namespace

TEST(Mesh_sizes, number_of_triangles)
{
  for(const std::string name : {"flat", "cap", "skew", "stretch"})
    for(double n : {1000., 10000.}) {
      const Sample sample = make_sample(name);
      Mesh mesh;
      add_patch(sample.surface, sample.domain, Criteria().set_max_edge(sample.edge_length(n)), mesh);
      EXPECT_NEAR(n, double(mesh.number_of_faces()), 0.2 * n) << name;
    }
}

TEST(Mesh_sizes, default_sizes)
{
  const Sample cap = make_sample("cap");
  Mesh mesh;
  const Report report = add_patch(cap.surface, cap.domain, Criteria(), mesh);
  EXPECT_EQ(0u, report.unmet.size());
  EXPECT_GT(mesh.number_of_faces(), 200u);
  EXPECT_LT(mesh.number_of_faces(), 5000u);
}

TEST(Mesh_sizes, sizing_field)
{
  const Sample hole = make_sample("hole");
  const auto size = [](double u, double v) { return 0.02 + 0.15 * std::hypot(u + 0.5, v + 0.5); };
  Mesh mesh;
  const Report report
    = add_patch(hole.surface, hole.domain, Criteria().set_max_edge(1).set_min_edge(0.001).set_sizing_field(size), mesh);
  EXPECT_EQ(0u, report.unmet.size());
  const Uv_map uv = uv_map(mesh);
  double sum = 0;
  for(const auto e : mesh.edges()) {
    const Point_2 middle = CGAL::midpoint(uv[mesh.vertex(e, 0)], uv[mesh.vertex(e, 1)]);
    const double ratio = length(mesh, e) / size(middle.x(), middle.y());
    EXPECT_LT(ratio, 2) << middle;
    EXPECT_GT(ratio, 0.25) << middle;
    sum += ratio;
  }
  EXPECT_NEAR(0.9, sum / double(mesh.number_of_edges()), 0.2);
}

TEST(Mesh_sizes, growth)
{
  const Sample flat = make_sample("flat");
  Domain domain = flat.domain;
  for(Curve& side : domain.loops().front()) // fine all around
    side.set_number_of_edges(100);
  const Criteria criteria = Criteria().set_max_edge(0.2);
  Mesh even, growing;
  add_patch(flat.surface, domain, criteria, even);
  const Report report = add_patch(flat.surface, domain, Criteria(criteria).set_growth(0.1), growing);
  EXPECT_LT(growing.number_of_faces(), 0.2 * even.number_of_faces());
  EXPECT_EQ(0u, report.unmet.size());
  double longest = 0;
  for(const auto e : growing.edges())
    longest = (std::max)(longest, length(growing, e));
  EXPECT_GT(longest, 0.04);
  EXPECT_LT(longest, 0.4);
}

TEST(Mesh_sizes, minimum_edge)
{
  // gamma asks for far less than the minimum edge
  const Sample peak = make_sample("peak");
  Mesh mesh;
  const Criteria criteria = Criteria().set_max_edge(0.2).set_min_edge(0.02).set_gamma(0.001);
  const Report report = add_patch(peak.surface, peak.domain, criteria, mesh);
  double shortest = std::numeric_limits<double>::infinity();
  for(const auto e : mesh.edges())
    shortest = (std::min)(shortest, length(mesh, e));
  EXPECT_GE(shortest, 0.5 * criteria.min_edge()); // a new point may be nearer to others than to its own triangle
  const auto unmet = unmet_by_face(report);
  for(const auto f : mesh.faces())
    EXPECT_TRUE(unmet.count(f) == 1 || deviation(mesh, f, peak.surface) <= 0.001 * (1 + 1e-6)) << f;
}

TEST(Mesh_sizes, distance)
{
  for(const std::string name : {"peak", "cap", "bend"}) {
    const Sample sample = make_sample(name);
    for(double distance : {0.01, 0.001}) {
      SCOPED_TRACE(name + " " + std::to_string(distance));
      Mesh mesh;
      const Criteria criteria = Criteria().set_max_edge(0.5).set_min_edge(1e-4).set_gamma(1).set_distance(distance);
      const Report report = add_patch(sample.surface, sample.domain, criteria, mesh);
      for(const auto& unmet : report.unmet)
        EXPECT_TRUE(unmet.criteria == CGAL::Parametric_surface_mesher::Mesh_criterion::ANGLE) << unmet.face; // next to the coarse boundary
      EXPECT_LE(report.unmet.size(), 4 + 0.002 * double(report.number_of_faces));
      // sampled at 45 points of each triangle, where the mesher looks at four: hence the allowance
      const auto found = CGAL::triangle_mesh_deviation(mesh, sample.surface, uv_map(mesh), 8);
      EXPECT_LE(found.max_distance_to_face, 1.3 * distance);
      EXPECT_GE(found.max_distance_to_face, 0.2 * distance) << "the mesh is much too fine";
    }
  }
}

TEST(Mesh_sizes, criterion_of_the_user)
{
  const Sample flat = make_sample("flat");
  Mesh mesh;
  const Report report = add_patch(flat.surface, flat.domain, Criteria().set_max_edge(0.1).set_min_edge(0.001), mesh,
                                  CGAL::parameters::triangle_criterion(Right_side_criterion{0.05}));
  const auto unmet = unmet_by_face(report);
  std::size_t on_the_right = 0;
  for(const auto f : mesh.faces()) {
    const auto v = corners(mesh, f);
    const bool is_right = mesh.point(v[0]).x() > 0.5 && mesh.point(v[1]).x() > 0.5 && mesh.point(v[2]).x() > 0.5;
    on_the_right += is_right;
    EXPECT_TRUE(!is_right || touches_border(mesh, f) || unmet.count(f) == 1 || shape(mesh, f).longest <= 0.05 * (1 + 1e-9))
      << f;
  }
  EXPECT_GT(on_the_right, 3 * mesh.number_of_faces() / 4);
}

TEST(Mesh_sizes, criterion_of_the_user_that_cannot_be_met_is_reported)
{
  const Sample flat = make_sample("flat");
  Mesh mesh;
  const Report report = add_patch(flat.surface, flat.domain, Criteria().set_max_edge(0.1).set_min_edge(0.03), mesh,
                                  CGAL::parameters::triangle_criterion(Right_side_criterion{0.01}));
  EXPECT_GT(report.count(CGAL::Parametric_surface_mesher::Mesh_criterion::USER, CGAL::Parametric_surface_mesher::Unmet_cause::MINIMUM_EDGE), 0u);
}
