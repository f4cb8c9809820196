// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Insertion one by one against CGAL's own, taking out, the order of a front and its tiles, and iteration with lookahead.
#include <CGAL/First_fundamental_form_metric_2.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Domain_tiles.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Front_queue.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Last_value.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Domain_walk.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Star_of_point.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Transaction.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Vertex_insertion.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Vertex_removal.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/for_each_with_lookahead.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <random_input.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace internal = CGAL::Parametric_surface_mesher::internal;
using CGAL::Parametric_surface_mesher::Criterion_set;
using CGAL::Parametric_surface_mesher::Mesh_criterion;
using CGAL::Parametric_surface_mesher::Unmet_cause;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_2 Point_2;
typedef internal::Patch_triangulation_2<Kernel> Triangulation;
typedef Triangulation::Face_handle Face_handle;
typedef Triangulation::Vertex_handle Vertex_handle;
typedef internal::Location<Triangulation> Location;
typedef CGAL::Constrained_Delaunay_triangulation_2<Kernel> Euclidean_triangulation;
typedef std::set<std::pair<Point_2, Point_2>> Edges;

namespace {

Triangulation::Point at(const Point_2& p)
{
  return Triangulation::Point(p, Kernel::Point_3(p.x(), p.y(), 0), CGAL::Metric_tensor_2(1, 0, 1));
}

// a square from (-1, -1) to (1, 1) with a constrained diagonal of its upper left quarter, all of it in the domain
template <class AnyTriangulation, class MakePoint>
void add_square(AnyTriangulation& t, const MakePoint& make_point)
{
  const std::vector<Point_2> corners = {Point_2(-1, -1), Point_2(1, -1), Point_2(1, 1), Point_2(-1, 1)};
  std::vector<typename AnyTriangulation::Vertex_handle> vertices;
  for(const Point_2& p : corners)
    vertices.push_back(t.insert(make_point(p)));
  for(std::size_t i = 0; i < 4; ++i)
    t.insert_constraint(vertices[i], vertices[(i + 1) % 4]);
  t.insert_constraint(t.insert(make_point(Point_2(-1, 0))), t.insert(make_point(Point_2(0, 1))));
}

template <class AnyTriangulation>
Edges edges(const AnyTriangulation& t)
{
  Edges result;
  for(auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e) {
    const Point_2 p = e->first->vertex((e->second + 1) % 3)->point(), q = e->first->vertex((e->second + 2) % 3)->point();
    result.insert(p < q ? std::make_pair(p, q) : std::make_pair(q, p));
  }
  return result;
}

void check_star(const std::vector<Face_handle>& star, Vertex_handle vertex)
{
  for(std::size_t i = 0; i < star.size(); ++i) {
    EXPECT_EQ(vertex, star[i]->vertex(0));
    EXPECT_EQ(star[i]->vertex(2), star[(i + 1) % star.size()]->vertex(1));
    EXPECT_TRUE(star[i]->is_in_domain());
  }
}

} // namespace

// Points in general position, as many with coordinates of few bits, which lie on edges and on common circles: with those the
// triangulations may differ, but both must be valid.
TEST(Vertex_insertion, is_that_of_CGAL)
{
  for(int number_of_bits : {40, 5}) {
    Triangulation t;
    add_square(t, at);
    for(Face_handle face : t.finite_face_handles())
      face->set_in_domain(true);
    Euclidean_triangulation expected;
    add_square(expected, [](const Point_2& p) { return p; });

    internal::Vertex_insertion<Triangulation> insertion(t);
    Random_input random(number_of_bits);
    std::size_t number_in_faces = 0, number_on_edges = 0;
    Face_handle hint = t.finite_faces_begin();
    for(int n = 0; n < 2000; ++n) {
      const Point_2 p(random.dyadic(number_of_bits), random.dyadic(number_of_bits));
      const Location location = internal::walk_in_domain(t, hint, p);
      hint = location.face;
      Vertex_handle vertex;
      if(location.kind == Location::IN_FACE)
        vertex = insertion.insert_in_face(at(p), location.face);
      else if(location.kind == Location::ON_EDGE && !location.face->is_constrained(location.index))
        vertex = insertion.insert_in_edge(at(p), location.face, location.index);
      else
        continue;
      ++(location.kind == Location::IN_FACE ? number_in_faces : number_on_edges);
      check_star(insertion.star(), vertex);
      expected.insert(p);
    }
    EXPECT_TRUE(t.is_valid());
    EXPECT_EQ(expected.number_of_vertices(), t.number_of_vertices());
    EXPECT_EQ(expected.number_of_faces(), t.number_of_faces());
    EXPECT_GT(number_in_faces, 100u);
    if(number_of_bits == 40)
      EXPECT_EQ(edges(expected), edges(t));
    else
      EXPECT_GT(number_on_edges, 100u);
  }
}

// A walk, and a star, that would take more steps than they may say so.
TEST(Work_limits, of_walks_and_stars)
{
  Triangulation t;
  add_square(t, at);
  for(Face_handle face : t.finite_face_handles())
    face->set_in_domain(true);
  Random_input random(2);
  internal::Vertex_insertion<Triangulation> insertion(t);
  for(int n = 0; n < 200; ++n) {
    const Point_2 p(random.dyadic(40), random.dyadic(40));
    const Location location = internal::walk_in_domain(t, t.finite_faces_begin(), p);
    if(location.kind == Location::IN_FACE)
      insertion.insert_in_face(at(p), location.face);
  }
  const Face_handle start = t.finite_faces_begin();
  std::size_t number_lost = 0, number_cut_short = 0;
  for(Face_handle face : t.finite_face_handles()) {
    if(!face->is_in_domain())
      continue;
    const Point_2 p = CGAL::centroid(face->vertex(0)->point().domain_point(), face->vertex(1)->point().domain_point(),
                                     face->vertex(2)->point().domain_point());
    const Location location = internal::walk_in_domain(t, start, p);
    EXPECT_NE(Location::LOST, location.kind);
    number_lost += internal::walk_in_domain(t, start, p, 2).kind == Location::LOST;
    internal::Star_of_point<Triangulation> star(t), small_star(t, 3);
    number_cut_short += star.compute(at(p), face).size() > 5 && (small_star.compute(at(p), face), small_star.is_cut_short());
    EXPECT_FALSE(star.is_cut_short());
  }
  EXPECT_GT(number_lost, t.number_of_faces() / 2);
  EXPECT_GT(number_cut_short, t.number_of_faces() / 10);
}

// A move, flips and the verdicts on all that they change are taken back, however often it is tried.
TEST(Transaction, takes_back_all)
{
  Triangulation t;
  add_square(t, at);
  for(Face_handle face : t.finite_face_handles())
    face->set_in_domain(true);
  internal::Vertex_insertion<Triangulation> insertion(t);
  Random_input random(3);
  for(int n = 0; n < 100; ++n) {
    const Point_2 p(random.dyadic(40), random.dyadic(40));
    const Location location = internal::walk_in_domain(t, t.finite_faces_begin(), p);
    if(location.kind == Location::IN_FACE)
      insertion.insert_in_face(at(p), location.face);
  }
  std::vector<Face_handle> faces;
  for(Face_handle face : t.finite_face_handles()) {
    internal::Verdict verdict(faces.size() % 2 == 0 ? Criterion_set() : Mesh_criterion::ANGLE,
                              internal::Scope::WHOLE);
    if(verdict.fails())
      verdict.refuse(Unmet_cause::SPACING);
    face->set_verdict(verdict);
    faces.push_back(face);
  }
  const Edges before = edges(t);
  internal::Transaction<Triangulation> transaction;
  transaction.begin(faces);
  for(int attempt = 0; attempt < 2; ++attempt) {
    std::size_t number_of_changes = 0;
    for(Face_handle face : faces)
      for(int i = 0; i < 3; ++i) {
        if(face->is_constrained(i) || t.is_infinite(face->neighbor(i)))
          continue;
        const internal::Edge_flip<Triangulation> edge(t, face, i);
        if(!edge.is_valid())
          continue;
        transaction.flip(edge);
        const Vertex_handle vertex = face->vertex(0);
        const Point_2 old_point = vertex->point().domain_point();
        transaction.move(vertex, at(old_point + CGAL::Vector_2<Kernel>(1e-9, 0)));
        ++number_of_changes;
      }
    EXPECT_GT(number_of_changes, 20u);
    EXPECT_NE(before, edges(t));
    transaction.roll_back();
    EXPECT_EQ(before, edges(t));
    for(std::size_t k = 0; k < faces.size(); ++k) {
      const internal::Verdict verdict = faces[k]->verdict();
      EXPECT_EQ(internal::Scope::WHOLE, verdict.scope());
      EXPECT_EQ(k % 2 == 1, verdict.fails(Mesh_criterion::ANGLE));
      EXPECT_EQ(k % 2 == 1, verdict.is_refused() && verdict.refusal() == Unmet_cause::SPACING);
    }
  }
}

// Inner vertices are taken out, in every second case after it was undone, until those of the square and a few others are
// left.
TEST(Vertex_removal, leaves_a_triangulation)
{
  Triangulation t;
  add_square(t, at);
  for(Face_handle face : t.finite_face_handles()) {
    face->set_in_domain(true);
    for(int i = 0; i < 3; ++i)
      face->vertex(i)->set_on_boundary(true);
  }
  const std::size_t number_on_boundary = t.number_of_vertices();
  Random_input random(1);
  internal::Vertex_insertion<Triangulation> insertion(t);
  for(int n = 0; n < 500; ++n) {
    const Point_2 p(random.dyadic(40), random.dyadic(40));
    const Location location = internal::walk_in_domain(t, t.finite_faces_begin(), p);
    if(location.kind == Location::IN_FACE)
      insertion.insert_in_face(at(p), location.face);
  }
  const CGAL::First_fundamental_form_metric_2<Kernel> metric;
  const auto sine = [](const std::array<double, 3>& l) { return internal::face_measures(l).squared_smallest_sine; };
  std::size_t number_of_removals = 0;
  for(auto v = t.finite_vertices_begin(); v != t.finite_vertices_end();) {
    const Vertex_handle vertex = v++;
    if(vertex->is_on_boundary())
      continue;
    const Edges before = edges(t);
    internal::Transaction<Triangulation> transaction;
    transaction.begin(std::vector<Face_handle>());
    internal::Vertex_removal<Triangulation> removal(t, vertex, transaction);
    const bool is_possible = removal.cut_ears(metric, sine, 1e-6);
    if(!is_possible || number_of_removals % 2 == 0) {
      transaction.roll_back();
      EXPECT_EQ(before, edges(t));
    }
    if(is_possible && (number_of_removals % 2 == 1 || removal.cut_ears(metric, sine, 1e-6))) {
      const std::size_t number_of_faces = t.number_of_faces();
      EXPECT_EQ(removal.faces().size(), 3u);
      const Face_handle face = removal.remove();
      EXPECT_TRUE(face->is_in_domain());
      EXPECT_EQ(t.number_of_faces() + 2, number_of_faces);
      ++number_of_removals;
    }
  }
  EXPECT_GT(number_of_removals, 400u);
  EXPECT_LT(t.number_of_vertices(), number_on_boundary + 50);
  EXPECT_TRUE(t.tds().is_valid());
  std::size_t number_of_constraints = 0;
  for(auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e) {
    EXPECT_EQ(e->first->is_constrained(e->second), t.mirror_edge(*e).first->is_constrained(t.mirror_edge(*e).second));
    number_of_constraints += t.is_constrained(*e);
  }
  EXPECT_EQ(number_of_constraints, 7u);
  for(Face_handle face : t.finite_face_handles())
    EXPECT_EQ(t.orientation(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point()), CGAL::LEFT_TURN);
}

// Octaves first, in an octave tile by tile, and first in first out; a changed face is skipped.
TEST(Front_queue, order)
{
  Triangulation t;
  add_square(t, at);
  std::vector<Face_handle> faces;
  for(Face_handle face : t.all_face_handles())
    faces.push_back(face);
  ASSERT_GE(faces.size(), 6u);
  internal::Front_queue<Face_handle> queue(3);
  queue.push(faces[0], 1.5, 0);
  queue.push(faces[1], 5, 1);
  queue.push(faces[2], 4.5, 2);
  queue.push(faces[3], 7, 1);
  queue.push(faces[4], 6, 0);
  queue.push(faces[5], 1e9, 2);
  faces[3]->touch();
  EXPECT_EQ(faces[5], queue.pop());
  EXPECT_EQ(faces[4], queue.pop()); // of the tile that is the current one at the beginning
  EXPECT_EQ(faces[2], queue.pop());
  queue.push(faces[4], 1e9, 1);
  EXPECT_EQ(faces[4], queue.pop());
  EXPECT_EQ(faces[1], queue.pop());
  EXPECT_EQ(faces[0], queue.pop());
  EXPECT_EQ(Face_handle(), queue.pop());
  EXPECT_EQ(0u, queue.size());
}

TEST(For_each_with_lookahead, visits_all_in_order)
{
  for(int n : {0, 1, 3, 4, 7, 8, 9, 100}) {
    std::vector<int> range, announced_early, announced, visited;
    for(int i = 0; i < n; ++i)
      range.push_back(i);
    internal::for_each_with_lookahead<int>(range, [&](int i) { announced_early.push_back(i); },
                                           [&](int i) {
                                             EXPECT_LT(std::size_t(i), announced_early.size());
                                             announced.push_back(i);
                                           },
                                           [&](int i) { visited.push_back(i); });
    EXPECT_EQ(range, announced_early);
    EXPECT_EQ(range, visited);
    EXPECT_EQ(n > 4 ? std::size_t(n) - 4 : 0u, announced.size());
  }
}

TEST(Last_value, is_that_of_the_function)
{
  internal::Last_value<Point_2, double> last;
  int number_of_calls = 0;
  const auto function = [&](const Point_2& p) {
    ++number_of_calls;
    return p.x() + 1000 * p.y();
  };
  for(int repeat = 0; repeat < 3; ++repeat)
    for(int i = 0; i < 50; ++i) {
      const Point_2 p(i % 10, i / 10);
      number_of_calls = 0;
      EXPECT_EQ(p.x() + 1000 * p.y(), last(p, function));
      EXPECT_EQ(p.x() + 1000 * p.y(), last(p, function));
      EXPECT_EQ(1, number_of_calls);
    }
}

// A closed surface before it has any inner vertex: all corners of its domain are one point in space.
TEST(Domain_tiles, are_counted_by_tensors)
{
  Triangulation t;
  for(const Point_2& p : {Point_2(0, 0), Point_2(4, 0), Point_2(4, 1), Point_2(0, 1)})
    t.insert(Triangulation::Point(p, CGAL::ORIGIN, CGAL::Metric_tensor_2(1, 0, 1)))->set_spacing(0.01);
  for(Face_handle face : t.finite_face_handles())
    face->set_in_domain(true);
  const internal::Domain_tiles tiles(t); // for 4 / (sqrt(3) / 2 * 0.01^2) = 46,188 points
  EXPECT_GE(tiles.size(), 30u);
  EXPECT_LE(tiles.size(), 60u);
  EXPECT_EQ(0u, tiles(0, 0));
  EXPECT_EQ(tiles.size() - 1, tiles(4, 1));
  EXPECT_EQ(tiles(1, 0.1), tiles(1.1, 0.05)); // as wide as high, in space
}
