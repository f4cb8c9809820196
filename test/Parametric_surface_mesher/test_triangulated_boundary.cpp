// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The triangulated boundary that follows the division: the same as one made anew.
#include <gtest/gtest.h>

#include <CGAL/First_fundamental_form_metric_2.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Triangulated_boundary.h>

#include <Sample_surfaces.h>
#include <random_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace internal = CGAL::Parametric_surface_mesher::internal;

namespace {

typedef Sample_kernel Kernel;
typedef Kernel::Point_2 Point_2;
typedef CGAL::Parametric_surface_oracle_3<Sample_surface, CGAL::First_fundamental_form_metric_2<Kernel>> Oracle;
typedef internal::Triangulated_boundary<Oracle> Boundary;
typedef internal::Boundary_loops<Kernel> Loops;
typedef std::set<std::array<std::size_t, 3>> Triangles;

// parameters of a flower with a hole in it, both in general position
class Divided_flower
{
  const Sample_surface m_surface;
  std::vector<std::vector<double>> m_parameters;

public:
  explicit Divided_flower(const Sample_surface& surface) : m_surface(surface), m_parameters(2)
  {
    for(std::size_t l = 0; l < 2; ++l)
      for(int i = 0; i < 12; ++i)
        m_parameters[l].push_back(i / 12.);
  }

  // halves one piece in three; returns how many
  std::size_t halve_some(Random_input& random)
  {
    std::size_t result = 0;
    for(auto& loop : m_parameters) {
      std::vector<double> halved;
      for(std::size_t i = 0; i < loop.size(); ++i) {
        halved.push_back(loop[i]);
        if(random.integer(3) == 0)
          halved.push_back((loop[i] + (i + 1 < loop.size() ? loop[i + 1] : 1)) / 2);
      }
      result += halved.size() - loop.size();
      loop.swap(halved);
    }
    return result;
  }

  void move_a_point(std::size_t loop) { m_parameters[loop][1] += 1e-3; }

  Loops loops() const
  {
    Loops result(2);
    std::size_t index = 0;
    for(std::size_t l = 0; l < 2; ++l)
      for(double t : m_parameters[l]) {
        const double angle = (l == 0 ? 1 : -1) * 8 * std::atan(1.) * t;
        const double radius
          = l == 0 ? 0.75 + 0.1 * std::sin(3 * angle) + 0.05 * std::cos(angle) : 0.3 + 0.05 * std::sin(2 * angle);
        const Point_2 p(radius * std::cos(angle) + 0.02 * double(l), radius * std::sin(angle));
        result[l].push_back({p, m_surface.point(p.x(), p.y()), index++});
      }
    return result;
  }
};

Triangles triangles(const Boundary::Triangulation& triangulation)
{
  Triangles result;
  for(auto face : triangulation.finite_face_handles())
    if(face->is_in_domain()) {
      std::array<std::size_t, 3> triangle{face->vertex(0)->index(), face->vertex(1)->index(), face->vertex(2)->index()};
      std::sort(triangle.begin(), triangle.end());
      result.insert(triangle);
    }
  return result;
}

void check_loops(const Loops& loops, const Boundary& boundary)
{
  ASSERT_EQ(loops.size(), boundary.loops().size());
  for(std::size_t l = 0; l < loops.size(); ++l) {
    const auto& loop = boundary.loops()[l];
    ASSERT_EQ(loops[l].size(), loop.vertices.size());
    ASSERT_EQ(loops[l].size(), loop.segments.size());
    for(std::size_t i = 0; i < loops[l].size(); ++i) {
      const auto v = loop.vertices[i], w = loop.vertices[(i + 1) % loops[l].size()];
      EXPECT_EQ(loops[l][i].index, v->index());
      EXPECT_EQ(loops[l][i].domain_point, Point_2(v->point().x(), v->point().y()));
      EXPECT_EQ(i, loop.segments[i]);
      EXPECT_TRUE(v->is_on_boundary());
      Boundary::Triangulation::Face_handle face;
      int k = 0;
      ASSERT_TRUE(boundary.triangulation().is_edge(v, w, face, k));
      EXPECT_TRUE(face->is_constrained(k));
      EXPECT_NE(face->is_in_domain(), face->neighbor(k)->is_in_domain());
    }
  }
}

std::size_t number_of_constraints(const Boundary& boundary)
{
  std::size_t result = 0;
  for(auto face : boundary.triangulation().all_face_handles())
    for(int i = 0; i < 3; ++i)
      result += face->is_constrained(i);
  return result / 2;
}

void check_like_new(const Oracle& oracle, const Loops& loops, const Boundary& boundary, bool is_unique)
{
  check_loops(loops, boundary);
  EXPECT_EQ(loops[0].size() + loops[1].size(), number_of_constraints(boundary));
  EXPECT_TRUE(boundary.triangulation().tds().is_valid());
  Boundary made_anew;
  made_anew.update(oracle, loops);
  const Triangles all = triangles(boundary.triangulation()), all_anew = triangles(made_anew.triangulation());
  EXPECT_EQ(loops[0].size() + loops[1].size(), all.size()); // a disk with a hole
  EXPECT_EQ(all_anew.size(), all.size());
  if(is_unique) {
    EXPECT_EQ(all_anew, all);
  }
  for(std::size_t l = 0; l < loops.size(); ++l)
    for(std::size_t i = 0; i < loops[l].size(); ++i)
      EXPECT_EQ(made_anew.loops()[l].vertices[i]->spacing(), boundary.loops()[l].vertices[i]->spacing());
}

} // namespace

// Sweeps over a large patch wait for memory: a face that does not fit into a line of the cache costs a tenth of all time.
TEST(Patch_triangulation, has_faces_of_a_cache_line)
{
  EXPECT_EQ(sizeof(void*) == 8 ? 64u : sizeof(internal::Patch_triangulation_2<Kernel>::Face),
            sizeof(internal::Patch_triangulation_2<Kernel>::Face));
}

// Under one tensor the constrained Delaunay triangulation of points in general position is unique.
TEST(Triangulated_boundary, follows_the_division)
{
  for(const bool is_flat : {true, false}) {
    const Sample_surface surface = make_sample(is_flat ? "flat" : "hole").surface;
    const Oracle oracle(surface, CGAL::First_fundamental_form_metric_2<Kernel>());
    Random_input random(7);
    for(int k = 0; k < 20; ++k) {
      Divided_flower flower(surface);
      Boundary boundary;
      boundary.update(oracle, flower.loops());
      for(int round = 0; round < 4; ++round) {
        ASSERT_GT(flower.halve_some(random), 0u);
        boundary.update(oracle, flower.loops());
        check_like_new(oracle, flower.loops(), boundary, is_flat);
      }
    }
  }
}

// What is handed over to the mesh of a face, which gives the points tensors of its own, and makes it anew where they vary.
TEST(Triangulated_boundary, is_taken_over)
{
  for(const std::string name : {"flat", "hole"}) {
    const Sample_surface surface = make_sample(name).surface;
    const Oracle oracle(surface, CGAL::First_fundamental_form_metric_2<Kernel>());
    Random_input random(9);
    Divided_flower flower(surface);
    Boundary boundary;
    boundary.update(oracle, flower.loops());
    flower.halve_some(random);
    const Loops loops = flower.loops();
    boundary.update(oracle, loops);
    Boundary::Triangulation triangulation, made_anew;
    internal::Boundary_triangulator<Kernel> take_over(triangulation, loops), make_anew(made_anew, loops);
    const internal::Metric_evaluator<Oracle> evaluate(oracle);
    take_over(evaluate, boundary.take());
    make_anew(evaluate);
    EXPECT_TRUE(triangulation.tds().is_valid());
    EXPECT_EQ(triangles(made_anew), triangles(triangulation));
    ASSERT_EQ(loops[0].size() + loops[1].size(), take_over.vertices().size());
    for(std::size_t i = 0; i < take_over.vertices().size(); ++i) {
      const auto v = take_over.vertices()[i], w = make_anew.vertices()[i];
      EXPECT_EQ(w->point().domain_point(), v->point().domain_point());
      EXPECT_EQ(w->point().tensor(), v->point().tensor());
      EXPECT_EQ(w->index(), v->index());
      EXPECT_EQ(w->spacing(), v->spacing());
      EXPECT_TRUE(v->is_on_boundary());
    }
    boundary.update(oracle, loops); // it has none any more
    check_like_new(oracle, loops, boundary, true);
  }
}

TEST(Triangulated_boundary, is_made_anew_when_points_have_moved)
{
  for(const std::size_t loop : {0, 1}) {
    const Sample_surface surface = make_sample("hole").surface;
    const Oracle oracle(surface, CGAL::First_fundamental_form_metric_2<Kernel>());
    Random_input random(8);
    Divided_flower flower(surface);
    Boundary boundary;
    boundary.update(oracle, flower.loops());
    const auto* before = &boundary.triangulation();
    boundary.update(oracle, flower.loops());
    EXPECT_EQ(before, &boundary.triangulation());
    flower.halve_some(random);
    flower.move_a_point(loop);
    boundary.update(oracle, flower.loops());
    check_like_new(oracle, flower.loops(), boundary, true);
  }
}
