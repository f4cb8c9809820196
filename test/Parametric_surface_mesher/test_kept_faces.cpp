// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A model that is meshed several times with other sizes: which faces keep their triangles.
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Parametric_surface_mesher/Kept_faces.h>
#include <CGAL/Rectangular_patch_3.h>
#include <CGAL/make_model_of_rectangular_patches.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <gtest/gtest.h>

#include <mesher_test_helpers.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <set>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Parametric_cylinder_3<Test_kernel> Cylinder;
typedef CGAL::Parametric_surface_model_3<CGAL::Rectangular_patch_3<Cylinder>> Model;
typedef CGAL::Parametric_surface_mesher::Kept_faces<Test_kernel> Kept_faces;

constexpr std::size_t number_of_patches = 4;

// a cylinder of quarters
Model quarters(double radius = 1)
{
  std::vector<CGAL::Rectangular_patch_3<Cylinder>> patches;
  for(std::size_t i = 0; i < number_of_patches; ++i)
    patches.emplace_back(Cylinder(radius), double(i) * CGAL_PI / 2, double(i + 1) * CGAL_PI / 2, 0, 2);
  return CGAL::make_model_of_rectangular_patches(patches);
}

// sizes around a point in space, out to `reach`
std::function<double(const Point_3&)> sizes_around(const Point_3& center, double length, double reach)
{
  return [=](const Point_3& p) { return distance(center, p) < reach ? length : 0.2; };
}

// in the middle of the first quarter
const Point_3 middle(std::sqrt(0.5), std::sqrt(0.5), 1);

template <class... Parameters>
Mesh mesh(const Model& model, const Criteria& criteria, Kept_faces& kept, const Parameters&... parameters)
{
  Mesh result;
  CGAL::make_parametric_surface_mesh(model, criteria, result, CGAL::parameters::kept_faces(std::ref(kept), parameters...));
  return result;
}

// Compares with a mesh in whose making nothing was kept.
void expect_fresh(const Mesh& kept, const Model& model, const Criteria& criteria)
{
  Mesh fresh;
  CGAL::make_parametric_surface_mesh(model, criteria, fresh);
  ASSERT_EQ(fresh.number_of_vertices(), kept.number_of_vertices());
  ASSERT_EQ(fresh.number_of_faces(), kept.number_of_faces());
  for(auto v : fresh.vertices())
    ASSERT_EQ(fresh.point(v), kept.point(v)) << v;
  for(auto f : fresh.faces())
    ASSERT_EQ(corners(fresh, f), corners(kept, f)) << f;
}

const Criteria criteria = Criteria().set_max_edge(0.3);

} // namespace

TEST(Kept_faces, are_all_if_nothing_changes)
{
  Kept_faces kept;
  mesh(quarters(), criteria, kept);
  EXPECT_EQ(0u, kept.number_of_kept_faces());
  const Mesh again = mesh(quarters(), criteria, kept);
  EXPECT_EQ(number_of_patches, kept.number_of_kept_faces());
  expect_fresh(again, quarters(), criteria);
}

TEST(Kept_faces, are_those_where_sizes_are_the_same)
{
  Kept_faces kept;
  Model model = quarters();
  for(double length : {0.2, 0.1, 0.05}) {
    model.set_sizing_field(sizes_around(middle, length, 0.3));
    const Mesh m = mesh(model, criteria, kept);
    if(length < 0.2) {
      EXPECT_EQ(number_of_patches - 1, kept.number_of_kept_faces());
    }
    expect_fresh(m, model, criteria);
  }
}

// The sizes change on an edge of the first quarter, too: its points are others then, with other numbers.
TEST(Kept_faces, have_the_same_boundary)
{
  Kept_faces kept;
  Model model = quarters();
  model.set_sizing_field(sizes_around(middle, 0.2, 0.3));
  mesh(model, criteria, kept);
  model.set_sizing_field(sizes_around(Point_3(1, 0, 1), 0.05, 0.3));
  const Mesh m = mesh(model, criteria, kept);
  EXPECT_EQ(number_of_patches - 2, kept.number_of_kept_faces());
  expect_fresh(m, model, criteria);
}

TEST(Kept_faces, are_none_with_other_criteria_or_surfaces)
{
  Kept_faces kept;
  mesh(quarters(), criteria, kept);
  mesh(quarters(), Criteria(criteria).set_gamma(0.04), kept);
  EXPECT_EQ(0u, kept.number_of_kept_faces());
  mesh(quarters(1.0001), Criteria(criteria).set_gamma(0.04), kept);
  EXPECT_EQ(0u, kept.number_of_kept_faces());
}

// A strip between two pieces of a cylinder, whose lower side moves: the points on its upper side stay as they are, but the wanted edge
// length beside the strip, which is a multiple of its width, does not.
TEST(Kept_faces, have_the_same_sizes_beside_thin_strips)
{
  const auto pieces_with_strip = [](double width) {
    std::vector<CGAL::Rectangular_patch_3<Cylinder>> patches;
    for(const auto& heights : {std::make_pair(-0.3, -width), std::make_pair(-width, 0.), std::make_pair(0., 0.3)})
      patches.emplace_back(Cylinder(1), 0, 0.3, heights.first, heights.second);
    return CGAL::make_model_of_rectangular_patches(patches);
  };
  const double width = 0.0075, similar_width = 0.00751;
  const Criteria narrow = Criteria().set_max_edge(0.1).set_min_edge(0.08).set_closeness(1.8);
  Kept_faces kept;
  const auto upper_side = [&](double w) {
    const Mesh m = mesh(pieces_with_strip(w), narrow, kept);
    expect_fresh(m, pieces_with_strip(w), narrow);
    std::set<Point_3> result;
    for(auto v : m.vertices())
      if(m.point(v).z() == 0)
        result.insert(m.point(v));
    return result;
  };
  const auto points = upper_side(width);
  EXPECT_GT(points.size(), 5u); // there would be five points without a division of the strip
  EXPECT_EQ(points, upper_side(width));
  EXPECT_EQ(3u, kept.number_of_kept_faces());
  EXPECT_EQ(points, upper_side(similar_width));
  EXPECT_EQ(0u, kept.number_of_kept_faces());
}

// What a function of the user says cannot be foreseen.
TEST(Kept_faces, are_none_with_a_criterion_of_the_user)
{
  Kept_faces kept;
  const auto any = CGAL::parameters::triangle_criterion([](const auto&) { return true; });
  for(int i = 0; i < 2; ++i) {
    mesh(quarters(), criteria, kept, any);
    EXPECT_EQ(0u, kept.number_of_kept_faces());
  }
}

TEST(Kept_faces, are_none_after_a_run_that_failed)
{
  Kept_faces kept;
  mesh(quarters(), criteria, kept);
  Model bad = quarters();
  bad.faces()[2].sizing_field = [](double, double) { return -1; };
  EXPECT_THROW(mesh(bad, criteria, kept), CGAL::Parametric_surface_mesh_error);
  const Mesh m = mesh(quarters(), criteria, kept);
  EXPECT_EQ(0u, kept.number_of_kept_faces());
  expect_fresh(m, quarters(), criteria);
}

// Two spheres that are close to each other are refined in a second round, and not kept for the next run. The third one is far away.
TEST(Kept_faces, are_not_those_refined_where_a_mesh_intersects_itself)
{
  typedef CGAL::Parametric_sphere_3<Test_kernel> Sphere;
  std::vector<CGAL::Rectangular_patch_3<Sphere>> patches;
  for(double radius : {1., 1.02, 2.})
    patches.emplace_back(Sphere(radius), 0, 2 * CGAL_PI, -CGAL_PI / 2, CGAL_PI / 2);
  const auto model = CGAL::make_model_of_rectangular_patches(patches);
  const Criteria coarse
    = Criteria().set_max_edge(0.6).set_gamma(1).set_self_intersections(CGAL::Parametric_surface_mesher::Self_intersections::REFINED);
  Kept_faces kept;
  Mesh first, second, fresh;
  CGAL::make_parametric_surface_mesh(model, coarse, fresh);
  CGAL::make_parametric_surface_mesh(model, coarse, first, CGAL::parameters::kept_faces(std::ref(kept)));
  CGAL::make_parametric_surface_mesh(model, coarse, second, CGAL::parameters::kept_faces(std::ref(kept)));
  EXPECT_EQ(1u, kept.number_of_kept_faces());
  for(const Mesh* m : {&first, &second}) {
    ASSERT_EQ(fresh.number_of_vertices(), m->number_of_vertices());
    EXPECT_TRUE(std::equal(fresh.points().begin(), fresh.points().end(), m->points().begin()));
  }
}
