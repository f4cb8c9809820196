// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random trimmed patches never break an invariant: orientation, boundary, topology, an honest report, determinism.
#include <gtest/gtest.h>

#include <Sample_surfaces.h>
#include <check_invariants.h>
#include <random_patches.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace {

// What may be left for want of a better point, and neither on the boundary nor because of the minimum edge.
struct Allowance
{
  double share; // of the triangles
  int rings;    // of vertices between them and the boundary
};

const Allowance nearly_nothing = {0.0001, 1}, beside_coarse_divisions = {0.001, 3};

template <class MakePatch>
void check_patches(std::uint64_t seed, int number_of_patches, const Allowance& allowance, const MakePatch& make_patch)
{
  Random_patch_generator generator(seed);
  std::size_t number_of_faces = 0, number_left = 0;
  for(int i = 0; i < number_of_patches; ++i) {
    SCOPED_TRACE("patch " + std::to_string(i));
    const Random_patch patch = make_patch(generator);
    Checked_report report;
    ASSERT_NO_THROW(report = check_invariants(patch.surface, patch.domain, patch.criteria, allowance.rings));
    ASSERT_FALSE(::testing::Test::HasFailure()) << "one broken patch tells enough";
    number_of_faces += report.number_of_faces;
    number_left += report.number_left_inside;
  }
  EXPECT_GT(number_of_faces, 200u * number_of_patches);
  EXPECT_LE(number_left, allowance.share * number_of_faces);
}

} // namespace

// each patch with another placement, and with or without improvement
class Placement_invariants
  : public ::testing::TestWithParam<CGAL::Parametric_surface_mesher::Mesh_point_placement>
{};

TEST_P(Placement_invariants, sums_of_waves)
{
  unsigned int number_of_sweeps = 0;
  check_patches(11, 40, nearly_nothing, [&](Random_patch_generator& generator) {
    Random_patch patch = generator.graph<Wave>();
    patch.criteria.set_placement(GetParam()).set_max_number_of_sweeps(number_of_sweeps++ % 5);
    patch.criteria.set_improvement_angle(number_of_sweeps % 2 == 0 ? 0 : 40);
    return patch;
  });
}

TEST_P(Placement_invariants, sharp_corners_and_uneven_divisions)
{
  check_patches(12, 25, beside_coarse_divisions, [](Random_patch_generator& generator) {
    Random_patch patch = generator.rough_graph<Bump>();
    patch.criteria.set_placement(GetParam());
    return patch;
  });
}

// large enough for bad faces to be refined in several cells of the domain
TEST_P(Placement_invariants, large_patches)
{
  for(const char* name : {"hole", "cap"}) {
    SCOPED_TRACE(name);
    const Sample sample = make_sample(name);
    const double size = sample.edge_length(80000);
    const Report report = check_invariants(sample.surface, sample.domain,
                                           Criteria().set_max_edge(size).set_min_edge(size / 100).set_placement(GetParam()));
    EXPECT_GT(report.number_of_faces, 70000u);
    EXPECT_TRUE(report.unmet.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Every_placement, Placement_invariants,
                         ::testing::Values(CGAL::Parametric_surface_mesher::Mesh_point_placement::CIRCUMCENTER, CGAL::Parametric_surface_mesher::Mesh_point_placement::OFF_CENTER,
                                           CGAL::Parametric_surface_mesher::Mesh_point_placement::FRONTAL));

TEST(Refinement_invariants, sums_of_waves)
{
  check_patches(1, 100, nearly_nothing, [](Random_patch_generator& generator) { return generator.graph<Wave>(); });
}

TEST(Refinement_invariants, sums_of_bumps)
{
  check_patches(2, 100, nearly_nothing, [](Random_patch_generator& generator) { return generator.graph<Bump>(); });
}

TEST(Refinement_invariants, primitive_surfaces)
{
  check_patches(3, 100, nearly_nothing, [](Random_patch_generator& generator) { return generator.primitive(); });
}

TEST(Refinement_invariants, sharp_corners_and_uneven_divisions)
{
  check_patches(4, 50, beside_coarse_divisions, [](Random_patch_generator& generator) {
    return generator.rough_graph<Wave>();
  });
}

TEST(Refinement_invariants, sharp_corners_and_uneven_divisions_on_bumps)
{
  check_patches(5, 50, beside_coarse_divisions, [](Random_patch_generator& generator) {
    return generator.rough_graph<Bump>();
  });
}
