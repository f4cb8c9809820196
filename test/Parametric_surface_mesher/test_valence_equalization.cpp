// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edges that keep valences from being six are flipped where that makes triangles better, and nothing is changed elsewhere.
#include <CGAL/Parametric_surface_mesher/internal/improvement/Valence_equalization.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Edge_flip.h>

#include <Sample_surfaces.h>
#include <mesher_test_helpers.h>
#include <plane_patch.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace internal = CGAL::Parametric_surface_mesher::internal;

typedef Plane_triangulation Triangulation;
typedef Triangulation::Face_handle Face_handle;
typedef Triangulation::Vertex_handle Vertex_handle;
typedef std::set<std::pair<Point_2, Point_2>> Edges;

// A parallelogram of triangles in rows of this height, with edges of length 1 along the rows.
class Lattice
{
  static const int n = 9; // of vertices, along a side

  Triangulation m_triangulation;
  std::vector<Vertex_handle> m_vertices;

public:
  explicit Lattice(double height)
  {
    for(int j = 0; j < n; ++j)
      for(int i = 0; i < n; ++i) {
        m_vertices.push_back(m_triangulation.insert(at(Plane_kernel::Point_2(i + 0.5 * j, height * j))));
        m_vertices.back()->set_spacing(1);
        m_vertices.back()->set_on_boundary(i == 0 || j == 0 || i == n - 1 || j == n - 1);
      }
    for(Face_handle face : m_triangulation.finite_face_handles())
      face->set_in_domain(true);
  }

  Triangulation& triangulation() { return m_triangulation; }
  Vertex_handle vertex(int i, int j) const { return m_vertices[std::size_t(n * j + i)]; }
  int valence(int i, int j) const { return int(m_triangulation.degree(vertex(i, j))); }

  void flip(Vertex_handle v, Vertex_handle w)
  {
    Face_handle face;
    int i;
    ASSERT_TRUE(m_triangulation.is_edge(v, w, face, i));
    internal::Edge_flip<Triangulation> edge(m_triangulation, face, i);
    ASSERT_TRUE(edge.is_valid());
    edge.flip();
  }

  Edges edges() const
  {
    Edges result;
    for(const auto& e : m_triangulation.finite_edges())
      result.insert(std::minmax(e.first->vertex((e.second + 1) % 3)->point().domain_point(),
                                e.first->vertex((e.second + 2) % 3)->point().domain_point()));
    return result;
  }

  void equalize(Vertex_handle vertex, const Criteria& criteria = Criteria().set_min_edge(1e-6))
  {
    const Plane_evaluator evaluate{};
    internal::Valence_equalization<Plane_evaluator> equalize(m_triangulation, evaluate, criteria);
    equalize(vertex);
  }
};

// the flip leaves vertices with five and seven neighbours
void flip_in_the_middle(Lattice& lattice)
{
  lattice.flip(lattice.vertex(4, 4), lattice.vertex(5, 4));
  ASSERT_EQ(5, lattice.valence(4, 4));
  ASSERT_EQ(5, lattice.valence(5, 4));
  ASSERT_EQ(7, lattice.valence(4, 5));
  ASSERT_EQ(7, lattice.valence(5, 3));
}

void expect_unchanged(Lattice& lattice, const Criteria& criteria = Criteria().set_min_edge(1e-6))
{
  const Edges before = lattice.edges();
  lattice.equalize(lattice.vertex(4, 5), criteria);
  EXPECT_EQ(before, lattice.edges());
  EXPECT_TRUE(lattice.triangulation().tds().is_valid());
}

// those edges between inner vertices whose flip would bring valences closer to six
std::size_t number_of_flips_that_gain(const Mesh& mesh)
{
  std::size_t result = 0;
  for(const auto e : mesh.edges()) {
    const auto h = mesh.halfedge(e, 0), g = mesh.halfedge(e, 1);
    if(mesh.is_border(h) || mesh.is_border(g))
      continue;
    const auto v = mesh.source(h), w = mesh.target(h), left = mesh.target(mesh.next(h)), right = mesh.target(mesh.next(g));
    const auto is_inner = [&](Mesh::Vertex_index x) { return !mesh.is_border(x); };
    result += is_inner(v) && is_inner(w) && is_inner(left) && is_inner(right)
              && mesh.degree(v) + mesh.degree(w) > mesh.degree(left) + mesh.degree(right) + 2;
  }
  return result;
}

} // namespace

TEST(Valence_equalization, flips_back_what_was_flipped)
{
  for(bool is_seen_from_other_side : {false, true}) {
    Lattice lattice(0.875);
    const Edges before = lattice.edges();
    flip_in_the_middle(lattice);
    ASSERT_NE(before, lattice.edges());
    lattice.equalize(is_seen_from_other_side ? lattice.vertex(5, 3) : lattice.vertex(4, 5));
    for(int i = 3; i < 6; ++i)
      for(int j = 3; j < 6; ++j)
        EXPECT_EQ(6, lattice.valence(i, j)) << i << " " << j;
    EXPECT_TRUE(lattice.triangulation().is_valid());
  }
}

TEST(Valence_equalization, leaves_what_is_regular)
{
  Lattice lattice(0.875);
  expect_unchanged(lattice);
}

// In narrow triangles the flip leaves angles below 40 degrees.
TEST(Valence_equalization, undoes_what_is_not_good)
{
  Lattice lattice(1.6);
  flip_in_the_middle(lattice);
  expect_unchanged(lattice);
}

TEST(Valence_equalization, leaves_edges_at_vertices_that_stay)
{
  for(bool is_kept : {false, true}) {
    Lattice lattice(0.875);
    flip_in_the_middle(lattice);
    if(is_kept)
      lattice.vertex(5, 4)->set_kept(true);
    else
      lattice.vertex(4, 4)->set_on_boundary(true);
    expect_unchanged(lattice);
  }
}

// What misses a limit may do so by no more than before.
TEST(Star_limits, allow_what_is_within_or_no_worse)
{
  const internal::Star_limits limits(Criteria().set_size_factor(0.5).set_min_edge(2));
  const auto shape = [](double size, double distance) {
    internal::Star_shape result;
    result.squared_size = size * size;
    result.squared_distance = distance * distance;
    return result;
  };
  const auto allow = [&](const internal::Star_shape& after, const internal::Star_shape& before) {
    return limits.allow(after, [&] { return before; });
  };
  EXPECT_TRUE(allow(shape(0.49, 2.1), shape(0.1, 5)));
  EXPECT_FALSE(allow(shape(0.51, 2.1), shape(0.1, 5)));
  EXPECT_FALSE(allow(shape(0.49, 1.9), shape(0.1, 5)));
  EXPECT_TRUE(allow(shape(0.6, 1.5), shape(0.7, 1.4)));
  EXPECT_FALSE(allow(shape(0.6, 1.5), shape(0.55, 1.4)));
  EXPECT_FALSE(allow(shape(0.6, 1.5), shape(0.7, 1.6)));
}

TEST(Valence_equalization, leaves_few_edges_of_a_mesh)
{
  for(const char* const name : {"sphere", "torus"}) {
    SCOPED_TRACE(name);
    const Sample sample = make_sample(name);
    std::size_t numbers[2];
    for(unsigned int sweeps : {0u, 2u}) {
      Mesh mesh;
      const Criteria criteria
        = Criteria().set_max_edge(sample.edge_length(20000)).set_max_number_of_sweeps(sweeps).set_improvement_angle(0);
      CGAL::make_parametric_surface_mesh(sample.surface, sample.domain, criteria, mesh);
      numbers[sweeps / 2] = number_of_flips_that_gain(mesh);
    }
    EXPECT_GT(numbers[0], 40u);
    EXPECT_LE(4 * numbers[1], numbers[0]);
  }
}
