// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edges that would be in the mesh twice, in two patches or across a seam.
#include <CGAL/Parametric_surface_mesher/internal/output/Chord_splitter.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace internal = CGAL::Parametric_surface_mesher::internal;

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Plane_kernel;
typedef internal::Patch_triangulation_2<Plane_kernel> Triangulation;
typedef Triangulation::Vertex_handle Vertex_handle;
typedef internal::Indexed_mesh<Plane_kernel>::Chords Chords;

Triangulation::Point at(const Plane_kernel::Point_2& p)
{
  return Triangulation::Point(p, Plane_kernel::Point_3(p.x(), p.y(), 0), CGAL::Metric_tensor_2(1, 0, 1));
}

// a plane
struct Evaluator
{
  typedef Plane_kernel Kernel;

  struct Position
  {
    Triangulation::Point point;
  };

  Position position(const Plane_kernel::Point_2& p, double) const { return {at(p)}; }
};

// A rhombus whose short diagonal from (0, -1) to (0, 1) is an edge, with these indices of its corners. Vertices become those
// of the boundary after it is made, as on the borders of the parts of a patch.
std::vector<Vertex_handle> make_rhombus(Triangulation& t, const std::vector<std::size_t>& indices)
{
  const std::vector<Plane_kernel::Point_2> corners = {{-2, 0}, {0, -1}, {2, 0}, {0, 1}};
  std::vector<Vertex_handle> result;
  for(const auto& p : corners)
    result.push_back(t.insert(at(p)));
  for(std::size_t i = 0; i < 4; ++i) {
    t.insert_constraint(result[i], result[(i + 1) % 4]);
    result[i]->set_index(indices[i]);
    result[i]->set_on_boundary(true);
  }
  for(auto face : t.finite_face_handles())
    face->set_in_domain(true);
  return result;
}

void split_chords(Triangulation& t, Chords& chords)
{
  const Evaluator evaluate;
  internal::Chord_splitter<Evaluator> split(t, evaluate, chords);
  split();
}

} // namespace

TEST(Chord_splitter, leaves_the_first_of_two_chords)
{
  Chords chords;
  Triangulation first, second;
  make_rhombus(first, {0, 1, 2, 3});
  make_rhombus(second, {4, 3, 5, 1}); // its diagonal joins the same two vertices
  split_chords(first, chords);
  EXPECT_EQ(4u, first.number_of_vertices());
  EXPECT_EQ((Chords{{1, 3}}), chords);
  split_chords(second, chords);
  EXPECT_EQ(5u, second.number_of_vertices());
  EXPECT_EQ(4u, second.number_of_faces());
  EXPECT_TRUE(second.is_valid());
  EXPECT_EQ((Chords{{1, 3}}), chords);
}

TEST(Chord_splitter, leaves_chords_between_other_vertices)
{
  Chords chords;
  Triangulation first, second;
  make_rhombus(first, {0, 1, 2, 3});
  make_rhombus(second, {1, 0, 3, 2});
  split_chords(first, chords);
  split_chords(second, chords);
  EXPECT_EQ(4u, second.number_of_vertices());
  EXPECT_EQ((Chords{{1, 3}, {0, 2}}), chords);
}

// Both ends of the diagonal are one vertex of the mesh, as across a patch that is one edge wide between two sides of a seam.
// Its middle is then joined to both, which is split in turn.
TEST(Chord_splitter, splits_what_joins_a_vertex_to_itself)
{
  Chords chords;
  Triangulation t;
  make_rhombus(t, {0, 1, 2, 1});
  split_chords(t, chords);
  EXPECT_EQ(6u, t.number_of_vertices());
}

// an inner vertex in the middle of a rhombus whose left and right corners are one vertex of the mesh
TEST(Chord_splitter, splits_one_of_two_edges_to_copies_of_a_vertex)
{
  Chords chords;
  Triangulation t;
  make_rhombus(t, {0, 1, 0, 3});
  const Vertex_handle inner = t.insert(at({0.1, 0.1}));
  for(auto face : t.finite_face_handles())
    face->set_in_domain(true);
  split_chords(t, chords);
  EXPECT_EQ(6u, t.number_of_vertices());
  std::size_t number_of_spokes = 0;
  auto v = t.incident_vertices(inner);
  const auto first = v;
  do
    number_of_spokes += v->is_on_boundary() && v->index() == 0;
  while(++v != first);
  EXPECT_EQ(1u, number_of_spokes);
}

namespace {

// A trapezoid with these indices of its corners, the lower ones first; its lower side is collapsed if they are equal.
std::vector<Vertex_handle> make_trapezoid(Triangulation& t, const std::vector<std::size_t>& indices)
{
  const std::vector<Plane_kernel::Point_2> corners = {{-1, 0}, {1, 0}, {2, 3}, {-2, 3}};
  std::vector<Vertex_handle> result;
  for(const auto& p : corners)
    result.push_back(t.insert(at(p)));
  for(std::size_t i = 0; i < 4; ++i) {
    t.insert_constraint(result[i], result[(i + 1) % 4]);
    result[i]->set_index(indices[i]);
    result[i]->set_on_boundary(true);
  }
  return result;
}

void set_in_domain(Triangulation& t)
{
  for(auto face : t.finite_face_handles())
    face->set_in_domain(true);
}

} // namespace

// The triangle between the two edges is collapsed: in the mesh they are one edge. Each split would make the next triangle of
// this kind, down to nothing.
TEST(Chord_splitter, leaves_edges_to_both_ends_of_a_collapsed_side)
{
  Chords chords;
  Triangulation t;
  make_trapezoid(t, {0, 0, 1, 2});
  t.insert(at({0, 1}));
  set_in_domain(t);
  split_chords(t, chords);
  EXPECT_EQ(5u, t.number_of_vertices());
}

// Without an inner vertex the diagonal and the side beside the collapsed triangle are one edge, which is that of the boundary.
TEST(Chord_splitter, leaves_a_chord_that_is_one_with_an_edge_of_the_boundary)
{
  Chords chords = {{0, 1}, {1, 2}, {0, 2}};
  Triangulation t;
  make_trapezoid(t, {0, 0, 1, 2});
  set_in_domain(t);
  split_chords(t, chords);
  EXPECT_EQ(4u, t.number_of_vertices());
  EXPECT_EQ((Chords{{0, 1}, {1, 2}, {0, 2}}), chords);
}
