// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How good triangles are with each placement, and what improvement adds.
#include <gtest/gtest.h>

#include <CGAL/Triangle_mesh_quality.h>

#include <Sample_surfaces.h>
#include <mesher_test_helpers.h>
#include <random_patches.h>

#include <algorithm>
#include <string>

namespace {

CGAL::Triangle_mesh_quality quality(const Sample& sample, const Criteria& criteria)
{
  Mesh mesh;
  const Report report = add_patch(sample.surface, sample.domain, criteria, mesh);
  EXPECT_EQ(0u, report.unmet.size());
  return CGAL::triangle_mesh_quality(mesh);
}

Criteria uniform(const Sample& sample, double number_of_triangles)
{
  return Criteria().set_max_edge(sample.edge_length(number_of_triangles));
}

Criteria unimproved(Criteria criteria) { return criteria.set_max_number_of_sweeps(0).set_improvement_angle(0); }

class Sample_shapes : public ::testing::TestWithParam<std::string>
{};

} // namespace

TEST_P(Sample_shapes, defaults)
{
  const Sample sample = make_sample(GetParam());
  const CGAL::Triangle_mesh_quality q = quality(sample, uniform(sample, 5000));
  const bool is_steep = GetParam() == "peak";
  EXPECT_GT(q.min_angle, 35);
  EXPECT_GT(q.mean_min_angle, is_steep ? 55.5 : 57);
  EXPECT_GT(q.mean_radius_ratio, is_steep ? 0.98 : 0.99);
}

TEST_P(Sample_shapes, front_alone)
{
  const Sample sample = make_sample(GetParam());
  const CGAL::Triangle_mesh_quality q = quality(sample, unimproved(uniform(sample, 5000)));
  EXPECT_GT(q.min_angle, 30 - 1e-9);
  EXPECT_GT(q.mean_radius_ratio, GetParam() == "peak" ? 0.95 : 0.97);
}

TEST_P(Sample_shapes, circumcenters_alone)
{
  const Sample sample = make_sample(GetParam());
  const CGAL::Triangle_mesh_quality q
    = quality(sample, unimproved(uniform(sample, 5000)).set_placement(CGAL::Parametric_surface_mesher::Mesh_point_placement::CIRCUMCENTER));
  EXPECT_GT(q.min_angle, 30 - 1e-9);
  EXPECT_GT(q.mean_min_angle, 48);
  EXPECT_GT(q.mean_radius_ratio, 0.91);
}

TEST_P(Sample_shapes, off_centers_alone)
{
  const Sample sample = make_sample(GetParam());
  const CGAL::Triangle_mesh_quality q
    = quality(sample, unimproved(uniform(sample, 5000)).set_placement(CGAL::Parametric_surface_mesher::Mesh_point_placement::OFF_CENTER));
  EXPECT_GT(q.min_angle, 30 - 1e-9);
  EXPECT_GT(q.mean_radius_ratio, 0.9);
}

TEST_P(Sample_shapes, own_placement)
{
  namespace psm = CGAL::Parametric_surface_mesher;
  const Sample sample = make_sample(GetParam());
  const auto criteria = unimproved(uniform(sample, 5000));
  const CGAL::Triangle_mesh_quality q = quality(sample, Criteria(criteria).set_placement(psm::Mesh_point_placement::CIRCUMCENTER)),
    same = quality(sample, Criteria(criteria).set_placement(psm::Circumcenter_placement())),
    other = quality(sample, Criteria(criteria).set_placement([](const psm::Triangle_weights& squared_lengths, double) {
      psm::Triangle_weights weights = psm::Circumcenter_placement()(squared_lengths, 0);
      for(double& w : weights) // half way to the centroid
        w = 0.5 * w + 0.5 / 3;
      return weights;
    }));
  EXPECT_EQ(q.number_of_faces, same.number_of_faces);
  EXPECT_EQ(q.mean_min_angle, same.mean_min_angle);
  EXPECT_NE(q.number_of_faces, other.number_of_faces);
  EXPECT_GT(other.min_angle, 25);
}

INSTANTIATE_TEST_SUITE_P(Samples, Sample_shapes, ::testing::ValuesIn(sample_names()),
                         [](const auto& parameter) { return parameter.param; });

// Large enough for the queue of bad faces to be in cells: no more triangles, and as good ones, as in one.
TEST(Circumcenters, cell_by_cell)
{
  for(const char* name : {"peak", "hole", "sphere"}) {
    const Sample sample = make_sample(name);
    const double n = 150000;
    const CGAL::Triangle_mesh_quality q
      = quality(sample, unimproved(uniform(sample, n)).set_placement(CGAL::Parametric_surface_mesher::Mesh_point_placement::CIRCUMCENTER));
    EXPECT_LT(double(q.number_of_faces), 1.15 * n) << name; // on `peak` curvature asks for some
    EXPECT_GT(q.min_angle, 30 - 1e-9) << name;
    EXPECT_GT(q.mean_min_angle, 48.3) << name;
    EXPECT_GT(q.mean_radius_ratio, 0.914) << name;
  }
}

TEST(Improvement, no_time)
{
  const Sample torus = make_sample("torus");
  const CGAL::Triangle_mesh_quality none = quality(torus, uniform(torus, 5000).set_improvement_time(0)),
                                    all = quality(torus, uniform(torus, 5000));
  EXPECT_LT(none.mean_radius_ratio, all.mean_radius_ratio - 0.005);
  EXPECT_LT(none.min_angle, 36);
}

// Polishing adds no vertices, even where nearly all triangles are as large as the deviation allows.
TEST(Improvement, polishing)
{
  for(const char* name : {"torus", "peak"}) {
    const Sample sample = make_sample(name);
    const CGAL::Triangle_mesh_quality two = quality(sample, uniform(sample, 5000).set_max_number_of_sweeps(2)),
                                      three = quality(sample, uniform(sample, 5000).set_max_number_of_sweeps(3)),
                                      twelve = quality(sample, uniform(sample, 5000).set_max_number_of_sweeps(12));
    EXPECT_GT(three.mean_min_angle, two.mean_min_angle + 0.2) << name;
    EXPECT_GT(twelve.mean_min_angle, two.mean_min_angle + 0.6) << name;
    EXPECT_GT(three.mean_radius_ratio, two.mean_radius_ratio) << name;
    EXPECT_GT(twelve.mean_radius_ratio, three.mean_radius_ratio) << name;
    EXPECT_GT(twelve.min_angle, 38) << name;
    EXPECT_EQ(two.number_of_faces, twelve.number_of_faces) << name;
  }
}

// Whatever the boundary: the smallest angle is no smaller, where it is below 40 degrees, and no more criteria are missed.
TEST(Improvement, polishing_makes_nothing_worse)
{
  Random_patch_generator generator(31);
  double gain = 0;
  for(int i = 0; i < 25; ++i) {
    SCOPED_TRACE("patch " + std::to_string(i));
    const Random_patch patch = i % 2 == 0 ? generator.rough_graph<Bump>() : generator.graph<Wave>();
    CGAL::Triangle_mesh_quality qualities[2];
    std::size_t unmet[2];
    for(unsigned int k : {0u, 1u}) {
      Mesh mesh;
      Criteria criteria = patch.criteria;
      unmet[k] = add_patch(patch.surface, patch.domain, criteria.set_max_number_of_sweeps(2 + 4 * k), mesh).unmet.size();
      qualities[k] = CGAL::triangle_mesh_quality(mesh);
    }
    EXPECT_GE(qualities[1].min_angle, (std::min)(40 - 1e-9, qualities[0].min_angle - 1e-9));
    EXPECT_LE(unmet[1], unmet[0]);
    gain += qualities[1].mean_min_angle - qualities[0].mean_min_angle;
  }
  EXPECT_GT(gain, 25 * 0.3);
}

// By default it is for large patches that smoothing has not settled.
TEST(Improvement, default_number_of_sweeps)
{
  const auto mean_angle = [](const char* name, double number_of_triangles, bool has_two_sweeps) {
    const Sample sample = make_sample(name);
    Criteria criteria = uniform(sample, number_of_triangles);
    if(has_two_sweeps)
      criteria.set_max_number_of_sweeps(2);
    return quality(sample, criteria).mean_min_angle;
  };
  EXPECT_GT(mean_angle("torus", 5000, false), 57);
  EXPECT_LT(mean_angle("torus", 5000, true), 57);
  EXPECT_EQ(mean_angle("torus", 2000, true), mean_angle("torus", 2000, false));
  EXPECT_EQ(mean_angle("flat", 5000, true), mean_angle("flat", 5000, false));
}

TEST(Improvement, angle_that_is_aimed_at)
{
  const Sample cap = make_sample("cap");
  double previous = 0;
  for(double angle : {0., 36., 40.}) {
    const CGAL::Triangle_mesh_quality q
      = quality(cap, uniform(cap, 20000).set_max_number_of_sweeps(0).set_improvement_angle(angle));
    EXPECT_GE(q.min_angle, previous);
    previous = q.min_angle;
  }
  EXPECT_GT(previous, 33);
}

// Whatever the order in which the front advances: sizes are to grow with the distance from short edges.
TEST(Grading, triangles_grow_away_from_a_finely_divided_hole)
{
  const Sample flat = make_sample("flat");
  Domain domain = Domain::rectangle(-1, 1, -1, 1);
  Curve circle = Curve::circle(Point_2(0.2, 0.1), 0.25);
  circle.set_number_of_edges(2000);
  domain.add_hole({circle});
  Mesh mesh;
  const Report report = add_patch(flat.surface, domain, Criteria().set_max_edge(0.04), mesh);
  EXPECT_EQ(0u, report.unmet.size());
  // the ring around the hole has 4000, and the rest would have some 5400
  EXPECT_LT(report.number_of_faces, 50000u);
  EXPECT_GT(report.smallest_angle, 30 - 1e-9);
}

// Beside long edges of the boundary points inside may have to go again: without that, angles below 16 degrees are left.
TEST(Grading, long_edges_close_to_a_finely_divided_hole)
{
  const Sample flat = make_sample("flat");
  for(std::size_t on_side : {8, 11})
    for(std::size_t on_circle : {40, 80, 160, 300})
      for(double radius : {0.5, 1., 2.}) {
        Domain domain = Domain::rectangle(0, 10, 0, 10);
        for(Curve& side : domain.loops().front())
          side.set_number_of_edges(on_side);
        Curve circle = Curve::circle(Point_2(5, 0.7 + radius), radius);
        circle.set_number_of_edges(on_circle);
        domain.add_hole({circle});
        Mesh mesh;
        const Report report = add_patch(flat.surface, domain, Criteria().set_max_edge(3), mesh);
        EXPECT_GT(report.smallest_angle, 20) << on_side << " " << on_circle << " " << radius;
      }
}

TEST(Own_placement, must_give_barycentric_coordinates)
{
  namespace psm = CGAL::Parametric_surface_mesher;
  const Sample sample = make_sample("peak");
  for(const psm::Triangle_weights& weights : {psm::Triangle_weights{1, 1, 1}, {0. / 0., 0, 1}})
    EXPECT_THROW(quality(sample, uniform(sample, 1000).set_placement([&](const psm::Triangle_weights&, double) { return weights; })),
                 CGAL::Parametric_surface_mesh_error);
}

