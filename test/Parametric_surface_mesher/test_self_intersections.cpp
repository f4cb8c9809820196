// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes that would pass through themselves: what is found, refined and reported.
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Rectangular_patch_3.h>
#include <CGAL/make_model_of_rectangular_patches.h>
#include <CGAL/make_parametric_surface_mesh.h>
#include <CGAL/make_parametric_surface_triangle_soup.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/Fold_search.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Box_hierarchy.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Intersecting_triangles.h>

#include <gtest/gtest.h>

#include <mesher_test_helpers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using CGAL::Parametric_surface_mesher::Self_intersections;
using CGAL::Parametric_surface_mesher::internal::Box_hierarchy;
using CGAL::Parametric_surface_mesher::internal::Intersecting_triangles;
using CGAL::Parametric_surface_mesher::internal::Small_box;

namespace {

typedef CGAL::Parametric_sphere_3<Test_kernel> Sphere;
typedef CGAL::Parametric_plane_3<Test_kernel> Plane;
typedef std::array<Point_3, 3> Triangle;

// spheres around one point
CGAL::Parametric_surface_model_3<CGAL::Rectangular_patch_3<Sphere>> spheres(const std::vector<double>& radii)
{
  std::vector<CGAL::Rectangular_patch_3<Sphere>> patches;
  for(double radius : radii)
    patches.emplace_back(Sphere(radius), 0, 2 * CGAL_PI, -CGAL_PI / 2, CGAL_PI / 2);
  return CGAL::make_model_of_rectangular_patches(patches);
}

// so coarse that spheres with a distance of 0.02 pass through each other
Criteria coarse_criteria(Self_intersections handling)
{
  return Criteria().set_max_edge(0.6).set_gamma(1).set_self_intersections(handling);
}

template <class Model>
Report mesh(const Model& model, const Criteria& criteria, Mesh& result)
{
  return CGAL::make_parametric_surface_mesh(model, criteria, result);
}

std::size_t number_of_intersections(const Mesh& mesh)
{
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
  return pairs.size();
}

// two squares that cross, or one square over another at a height
CGAL::Parametric_surface_model_3<CGAL::Rectangular_patch_3<Plane>> squares(const Point_3& origin, const Vector_3& a, const Vector_3& b)
{
  std::vector<CGAL::Rectangular_patch_3<Plane>> patches;
  patches.emplace_back(Plane(Point_3(0, 0, 0), Vector_3(1, 0, 0), Vector_3(0, 1, 0)), 0, 1, 0, 1);
  patches.emplace_back(Plane(origin, a, b), 0, 1, 0, 1);
  return CGAL::make_model_of_rectangular_patches(patches);
}

} // namespace

TEST(Self_intersections, are_those_of_the_mesh)
{
  Mesh m;
  const Report report = mesh(spheres({1, 1.02}), coarse_criteria(Self_intersections::REPORTED), m);
  ASSERT_EQ(1u, report.intersections.size());
  EXPECT_EQ((std::array<std::size_t, 2>{0, 1}), report.intersections[0].faces);
  EXPECT_EQ(number_of_intersections(m), report.intersections[0].number_of_pairs);
  EXPECT_FALSE(report.intersections[0].is_of_surfaces);
}

TEST(Self_intersections, are_refined)
{
  Mesh coarse, fine;
  mesh(spheres({1, 1.02}), coarse_criteria(Self_intersections::IGNORED), coarse);
  const Report report = mesh(spheres({1, 1.02}), coarse_criteria(Self_intersections::REFINED), fine);
  EXPECT_LT(0u, number_of_intersections(coarse));
  EXPECT_EQ(0u, number_of_intersections(fine));
  EXPECT_TRUE(report.intersections.empty());
  EXPECT_LT(fine.number_of_faces(), 12 * coarse.number_of_faces());
  EXPECT_LT(25., report.smallest_angle);
}

// Who stops when the search begins has the whole mesh of the first round, and is told that the rest was not done.
TEST(Self_intersections, a_stop_before_the_search_keeps_the_mesh)
{
  struct Stopping_visitor : CGAL::Parametric_surface_mesh_visitor
  {
    bool is_stopping = false;
    void on_phase(const char* name) { is_stopping = is_stopping || name == std::string("intersections"); }
    bool go_further() { return !is_stopping; }
  };
  Mesh ignored, stopped;
  Stopping_visitor visitor;
  mesh(spheres({1, 1.02}), coarse_criteria(Self_intersections::IGNORED), ignored);
  const Report report = CGAL::make_parametric_surface_mesh(spheres({1, 1.02}), coarse_criteria(Self_intersections::REFINED), stopped,
                                                           CGAL::parameters::visitor(std::ref(visitor)));
  EXPECT_TRUE(report.is_stopped);
  EXPECT_TRUE(report.unmet.empty());
  ASSERT_EQ(ignored.number_of_vertices(), stopped.number_of_vertices());
  EXPECT_TRUE(std::equal(ignored.points().begin(), ignored.points().end(), stopped.points().begin()));
}

TEST(Self_intersections, leave_a_good_mesh_as_it_is)
{
  Mesh ignored, refined;
  mesh(spheres({1, 1.5}), coarse_criteria(Self_intersections::IGNORED), ignored);
  mesh(spheres({1, 1.5}), coarse_criteria(Self_intersections::REFINED), refined);
  ASSERT_EQ(ignored.number_of_vertices(), refined.number_of_vertices());
  EXPECT_TRUE(std::equal(ignored.points().begin(), ignored.points().end(), refined.points().begin()));
}

TEST(Self_intersections, of_different_solids_do_not_count)
{
  auto model = spheres({1, 1.02, 1.04});
  model.faces()[1].solid = 1;
  model.faces()[2].solid = std::nullopt;
  Mesh m;
  EXPECT_TRUE(mesh(model, coarse_criteria(Self_intersections::REPORTED), m).intersections.empty());
  EXPECT_LT(0u, number_of_intersections(m));
}

// Where surfaces cross, shorter edges do not help: the mesh has the sizes that were asked for.
TEST(Self_intersections, of_surfaces_are_not_refined)
{
  const auto model = squares(Point_3(0.3, 0.2, -0.4), Vector_3(0.1, 1, 0), Vector_3(0, 0.2, 1));
  Mesh reported, refined;
  const Report report = mesh(model, Criteria().set_max_edge(0.2).set_self_intersections(Self_intersections::REPORTED), reported),
               other = mesh(model, Criteria().set_max_edge(0.2).set_self_intersections(Self_intersections::REFINED), refined);
  for(const Report& r : {report, other}) {
    ASSERT_EQ(1u, r.intersections.size());
    EXPECT_TRUE(r.intersections[0].is_of_surfaces);
  }
  EXPECT_EQ(reported.number_of_faces(), refined.number_of_faces());
}

// A square that is the boundary of two solids, and one of the second solid that crosses it. A soup has the triangles of the first one once.
TEST(Self_intersections, of_the_second_solid_at_a_face_are_found_in_a_soup)
{
  auto model = squares(Point_3(0.3, 0.2, -0.4), Vector_3(0.1, 1, 0), Vector_3(0, 0.2, 1));
  auto back = model.faces()[0];
  back.other_side_of = 0;
  back.is_reversed = !back.is_reversed;
  back.shell = 7;
  back.solid = model.faces()[1].solid = 1;
  model.faces()[0].solid = 0;
  model.add_face(back);
  const Criteria criteria = Criteria().set_max_edge(0.2).set_self_intersections(Self_intersections::REPORTED);
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> patches;
  const Report of_soup = CGAL::make_parametric_surface_triangle_soup(model, criteria, points, triangles, patches);
  ASSERT_EQ(1u, of_soup.intersections.size());
  EXPECT_EQ((std::array<std::size_t, 2>{0, 1}), of_soup.intersections[0].faces);
  Mesh m;
  const Report of_mesh = mesh(model, criteria, m);
  ASSERT_EQ(1u, of_mesh.intersections.size());
  EXPECT_EQ((std::array<std::size_t, 2>{1, 2}), of_mesh.intersections[0].faces);
  EXPECT_EQ(of_soup.intersections[0].number_of_pairs, of_mesh.intersections[0].number_of_pairs);
}

TEST(Self_intersections, of_faces_on_each_other_are_found)
{
  Mesh m;
  const Criteria criteria = Criteria().set_max_edge(0.2).set_self_intersections(Self_intersections::REFINED);
  const Report report = mesh(squares(Point_3(0.25, 0.25, 0), Vector_3(1, 0, 0), Vector_3(0, 1, 0)), criteria, m);
  ASSERT_EQ(1u, report.intersections.size());
  EXPECT_TRUE(report.intersections[0].is_of_surfaces);
}

// Two triangles of a plane, the second of which is turned about their common edge; that is inside a part of the mesh, or between two.
std::size_t number_of_folds(const Point_3& turned_corner, bool is_between_parts)
{
  typedef CGAL::Parametric_surface_model_3<CGAL::Rectangular_patch_3<Plane>> Model;
  namespace internal = CGAL::Parametric_surface_mesher::internal;
  Model model = squares(Point_3(0, 0, 9), Vector_3(1, 0, 0), Vector_3(0, 1, 0));
  internal::Indexed_mesh<Test_kernel> mesh;
  mesh.points = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), turned_corner};
  typedef internal::Partial_mesh<Test_kernel> Part;
  Part first, second;
  first.faces.push_back({{0, 1, 2}});
  first.corner_points.push_back({{Point_2(0, 0), Point_2(1, 0), Point_2(1, 1)}});
  second.faces.push_back({{0, 2, 3}});
  second.corner_points.push_back({{Point_2(0, 0), Point_2(1, 1), Point_2(0, 1)}});
  if(is_between_parts) {
    for(Part* part : {&first, &second}) {
      part->halfedges.push_back({{0, 0, 0}});
      part->border = {0, 1, 2};
      mesh.append(*part);
    }
  }
  else {
    first.faces.push_back(second.faces[0]);
    first.corner_points.push_back(second.corner_points[0]);
    first.halfedges.push_back({{0, 0, 0}});
    first.halfedges.push_back({{1, 0, 0}});
    first.border = {0, 1, 4, 5};
    first.number_of_edges = 1;
    mesh.append(first);
  }
  const auto folds = internal::Fold_search<Model>(model, mesh)({{}, {}});
  return folds.empty() ? 0 : folds[0].number_of_pairs;
}

TEST(Fold_search, finds_neighbours_that_face_each_other)
{
  for(const bool is_between_parts : {false, true}) {
    EXPECT_EQ(0u, number_of_folds(Point_3(0, 1, 0), is_between_parts));
    EXPECT_EQ(0u, number_of_folds(Point_3(0.5, 0.5, 1), is_between_parts)); // a right angle
    EXPECT_EQ(1u, number_of_folds(Point_3(0.9, 0.1, 0), is_between_parts));
    EXPECT_EQ(1u, number_of_folds(Point_3(0.9, 0.1, 0.1), is_between_parts));
  }
}

TEST(Intersecting_triangles, know_shared_corners)
{
  const Intersecting_triangles intersect;
  const Point_3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(1, 1, 0), e(0.2, 0.2, 0), f(-1, -1, 0);
  EXPECT_FALSE(intersect({a, b, c}, {c, b, d})); // neighbours in a plane
  EXPECT_TRUE(intersect({a, b, c}, {b, c, e}));  // folded over
  EXPECT_TRUE(intersect({a, b, c}, {c, a, b}));  // the same
  EXPECT_FALSE(intersect({a, b, c}, {a, f, Point_3(-1, 0, 0)}));
  EXPECT_TRUE(intersect({a, b, c}, {a, e, Point_3(0, 0.3, 0)}));
  EXPECT_TRUE(intersect({a, b, c}, {a, Point_3(0.3, 0.3, 1), Point_3(0.3, 0.3, -1)}));
  EXPECT_TRUE(intersect({a, b, c}, {e, Point_3(1, 1, 1), Point_3(2, 1, 1)})); // a corner inside
}

// Points on a grid give triangles that touch, lie in one plane and share corners.
TEST(Intersecting_triangles, agree_with_exact_predicates)
{
  std::mt19937 random(1);
  const auto corner = [&] { return Point_3(random() % 4 / 3., random() % 4 / 3., random() % 3 / 3.); };
  int number_of_intersections = 0;
  for(int i = 0; i < 20000; ++i) {
    const Triangle s{corner(), corner(), corner()}, t{corner(), corner(), corner()};
    const bool share = std::any_of(s.begin(), s.end(), [&](const Point_3& p) { return std::count(t.begin(), t.end(), p) > 0; });
    if(share || CGAL::collinear(s[0], s[1], s[2]) || CGAL::collinear(t[0], t[1], t[2]))
      continue;
    const bool expected = CGAL::do_intersect(Test_kernel::Triangle_3(s[0], s[1], s[2]), Test_kernel::Triangle_3(t[0], t[1], t[2]));
    EXPECT_EQ(expected, Intersecting_triangles()(s, t)) << i;
    number_of_intersections += expected;
  }
  EXPECT_LT(1000, number_of_intersections);
}

TEST(Box_hierarchy, finds_each_pair_once)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(0, 1), size(0, 0.1);
  std::vector<Small_box> boxes(300);
  for(Small_box& box : boxes) {
    const Point_3 p(coordinate(random), coordinate(random), coordinate(random));
    box.add(p);
    box.add(p + Vector_3(size(random), size(random), size(random)));
  }
  std::set<std::pair<std::size_t, std::size_t>> expected, found;
  for(std::size_t i = 0; i < boxes.size(); ++i)
    for(std::size_t k = 0; k < i; ++k)
      if(boxes[i].overlaps(boxes[k]))
        expected.emplace(k, i);
  std::size_t number = 0;
  Box_hierarchy(boxes).for_each_overlapping_pair([&](std::size_t i, std::size_t k) {
    found.emplace((std::min)(i, k), (std::max)(i, k));
    ++number;
  });
  EXPECT_EQ(expected, found);
  EXPECT_EQ(found.size(), number);
}
