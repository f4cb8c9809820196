// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every mesh of a trimmed patch must fulfil, whatever the input.
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_CHECK_INVARIANTS_H
#define PARAMETRIC_SURFACE_MESHER_TEST_CHECK_INVARIANTS_H

#include <CGAL/Triangle_mesh_quality.h>

#include <mesher_test_helpers.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

typedef CGAL::Parametric_surface_mesher::internal::Boundary_loops<Test_kernel> Boundary_loops;

// The division that the mesher starts from.
template <class Surface>
Boundary_loops division(const Surface& surface, const Domain& domain, const Criteria& criteria)
{
  using namespace CGAL::Parametric_surface_mesher::internal;
  const CGAL::First_fundamental_form_metric_2<Test_kernel> metric;
  const auto model = model_of_patch(surface, domain);
  Mesh_progress progress;
  Bad_faces bad_faces(false);
  Report report;
  auto divided = make_model_mesher(model, criteria, metric, progress, bad_faces, nullptr, report).divide();
  divided.number_along_edges();
  return divided.boundary_loops(0);
}

// The points of the division are the first vertices, in order and to the last bit; its edges are the border.
inline void check_boundary(const Mesh& mesh, const Boundary_loops& loops)
{
  typedef std::set<std::pair<std::size_t, std::size_t>> Edges;
  const Uv_map uv = uv_map(mesh);
  Edges expected, found;
  std::size_t first = 0;
  for(const auto& loop : loops) {
    for(std::size_t i = 0; i < loop.size(); ++i) {
      const Mesh::Vertex_index v(static_cast<Mesh::size_type>(first + i));
      ASSERT_LT(first + i, mesh.number_of_vertices());
      EXPECT_EQ(loop[i].domain_point, uv[v]);
      EXPECT_EQ(loop[i].surface_point, mesh.point(v));
      expected.insert(std::minmax(first + i, first + (i + 1) % loop.size()));
    }
    first += loop.size();
  }
  for(const auto e : mesh.edges())
    if(mesh.is_border(e))
      found.insert(std::minmax<std::size_t>(mesh.vertex(e, 0), mesh.vertex(e, 1)));
  EXPECT_EQ(expected, found);
}

inline void check_topology(const Mesh& mesh, std::size_t number_of_holes)
{
  EXPECT_TRUE(mesh.is_valid());
  const CGAL::Triangle_mesh_quality quality = CGAL::triangle_mesh_quality(mesh);
  EXPECT_TRUE(quality.is_manifold);
  EXPECT_EQ(1 - std::ptrdiff_t(number_of_holes), quality.euler_characteristic);
  EXPECT_EQ(1 + number_of_holes, quality.number_of_boundary_cycles);
  EXPECT_EQ(1u, quality.number_of_connected_components);
  EXPECT_EQ(0u, quality.number_of_isolated_vertices);
  EXPECT_EQ(0u, number_of_inverted_faces(mesh));
}

inline void check_identical(const Mesh& a, const Mesh& b)
{
  ASSERT_EQ(a.number_of_vertices(), b.number_of_vertices());
  ASSERT_EQ(a.number_of_faces(), b.number_of_faces());
  const Uv_map uv_a = uv_map(a), uv_b = uv_map(b);
  for(const auto v : a.vertices()) {
    ASSERT_EQ(a.point(v), b.point(v)) << v;
    ASSERT_EQ(uv_a[v], uv_b[v]) << v;
  }
  for(const auto f : a.faces())
    ASSERT_EQ(corners(a, f), corners(b, f)) << f;
}

// and the same halfedges
inline void check_identical_connectivity(const Mesh& a, const Mesh& b)
{
  ASSERT_EQ(a.number_of_halfedges(), b.number_of_halfedges());
  for(const auto h : a.halfedges()) {
    ASSERT_EQ(a.target(h), b.target(h)) << h;
    ASSERT_EQ(a.next(h), b.next(h)) << h;
    ASSERT_EQ(a.prev(h), b.prev(h)) << h;
    ASSERT_EQ(a.face(h), b.face(h)) << h;
  }
  for(const auto v : a.vertices())
    ASSERT_EQ(a.halfedge(v), b.halfedge(v)) << v;
}

// Compares what the report lists with what the triangles fail by the measures of mesher_test_helpers.h.
// The default metric is expected, and a mesh of one patch.
template <class Surface>
class Report_check
{
  typedef CGAL::Parametric_surface_mesher::Criterion_set Criterion_set;
  typedef CGAL::Parametric_surface_mesher::Mesh_criterion Mesh_criterion;
  typedef CGAL::Parametric_surface_mesher::Unmet_cause Unmet_cause;

  const Mesh& m_mesh;
  const Surface& m_surface;
  const Criteria& m_criteria;
  const Report& m_report;
  int m_rings;
  std::size_t m_number_left_inside = 0;
  double m_smallest_spacing; // that a vertex can have

public:
  // `rings`: how many rings of vertices away from the border faces may be left for want of a better point
  Report_check(const Mesh& mesh, const Surface& surface, const Criteria& criteria, const Report& report, int rings = 1)
    : m_mesh(mesh), m_surface(surface), m_criteria(criteria), m_report(report), m_rings(rings),
      m_smallest_spacing(1.4 * criteria.min_edge())
  {
    for(const auto v : mesh.vertices())
      if(mesh.is_border(v))
        m_smallest_spacing = (std::min)(m_smallest_spacing, border_spacing(v));
  }

  // Faces that do not touch the border, and are left although there is room for points.
  std::size_t number_left_inside() const { return m_number_left_inside; }

  void operator()()
  {
    EXPECT_EQ(m_mesh.number_of_vertices(), m_report.number_of_vertices);
    EXPECT_EQ(m_mesh.number_of_faces(), m_report.number_of_faces);
    const std::map<std::size_t, Report::Unmet> listed = unmet_by_face(m_report);
    double smallest_angle = 180;
    for(const auto f : m_mesh.faces()) {
      smallest_angle = (std::min)(smallest_angle, shape(m_mesh, f).min_angle);
      const auto unmet = listed.find(f);
      if(unmet == listed.end())
        expect_met(f);
      else
        expect_unmet(f, unmet->second);
    }
    EXPECT_NEAR(smallest_angle, m_report.smallest_angle, 1e-6);
  }

private:
  // half the way from the vertex before to the one behind, along the border
  double border_spacing(Mesh::Vertex_index v) const
  {
    double sum = 0;
    for(const auto h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if(m_mesh.is_border(m_mesh.edge(h)))
        sum += length(m_mesh, m_mesh.edge(h));
    return sum / 2;
  }

  // the circumradius over C times the sum of the spacings, of which those of inner vertices are only known to lie in a range
  double size_ratio(Mesh::Face_index f, double spacing_of_inner) const
  {
    double sum = 0;
    for(const auto v : corners(m_mesh, f))
      sum += m_mesh.is_border(v) ? border_spacing(v) : spacing_of_inner;
    return shape(m_mesh, f).circumradius / (m_criteria.size_factor() * sum);
  }

  double angle(Mesh::Face_index f) const { return shape(m_mesh, f).min_angle; }

  double deviation(Mesh::Face_index f) const { return ::deviation(m_mesh, f, m_surface); }

  double distance_ratio(Mesh::Face_index f) const
  {
    return m_criteria.distance() ? distance_to_surface(m_mesh, f, m_surface) / *m_criteria.distance() : 0;
  }

  // The same by the largest distance: more places are looked at where the middles and the centroid come close to the bound.
  double largest_distance_ratio(Mesh::Face_index f) const
  {
    return m_criteria.distance() ? largest_distance_to_surface(m_mesh, f, m_surface) / *m_criteria.distance() : 0;
  }

  // But for rounding, each of them is listed if, and only if, it is failed.
  void expect_met(Mesh::Face_index f, Criterion_set but_for = Criterion_set()) const
  {
    if(!but_for.contains(Mesh_criterion::SIZE)) {
      EXPECT_LT(size_ratio(f, m_criteria.max_edge()), 1 + 1e-9) << f;
    }
    if(!but_for.contains(Mesh_criterion::ANGLE)) {
      EXPECT_GT(angle(f), m_criteria.angle() * (1 - 1e-9)) << f;
    }
    if(!but_for.contains(Mesh_criterion::DEVIATION)) {
      EXPECT_LT(deviation(f), m_criteria.gamma() * (1 + 1e-6)) << f;
    }
    if(!but_for.contains(Mesh_criterion::DISTANCE)) {
      EXPECT_LT(distance_ratio(f), 1 + 1e-6) << f;
    }
  }

  void expect_unmet(Mesh::Face_index f, const Report::Unmet& unmet)
  {
    EXPECT_FALSE(unmet.criteria.empty()) << f;
    expect_met(f, unmet.criteria);
    if(unmet.criteria.contains(Mesh_criterion::SIZE)) {
      EXPECT_GT(size_ratio(f, m_smallest_spacing), 0.9) << f;
    }
    if(unmet.criteria.contains(Mesh_criterion::ANGLE)) {
      EXPECT_LT(angle(f), m_criteria.angle() * (1 + 1e-9)) << f;
    }
    if(unmet.criteria.contains(Mesh_criterion::DEVIATION)) {
      EXPECT_GT(deviation(f), m_criteria.gamma() * (1 - 1e-6)) << f;
    }
    if(unmet.criteria.contains(Mesh_criterion::DISTANCE)) {
      EXPECT_GT(largest_distance_ratio(f), 0.99) << f; // the mesher has a safety of half a percent
    }
    EXPECT_FALSE(unmet.criteria.contains(Mesh_criterion::USER)) << f << " fails a criterion that there is not";
    expect_cause(f, unmet.cause);
  }

  // Away from the boundary a face is left only where there is no room for points. Some faces near the boundary are left because
  // those on it are.
  void expect_cause(Mesh::Face_index f, Unmet_cause cause)
  {
    const bool has_room = shape(m_mesh, f).shortest >= 2.5 * m_criteria.min_edge();
    EXPECT_TRUE(cause != Unmet_cause::VERTEX_LIMIT && cause != Unmet_cause::STOPPED) << f << ": nobody has asked for that";
    EXPECT_FALSE(cause == Unmet_cause::MINIMUM_EDGE && has_room) << f << " has room for a point";
    EXPECT_TRUE(!has_room || is_near_border(f)) << f << " is left in the midst of the mesh because of the " << name(cause);
    m_number_left_inside += has_room && !touches_border(m_mesh, f);
  }

  bool is_near_border(Mesh::Face_index f) const
  {
    const auto v = corners(m_mesh, f);
    std::set<Mesh::Vertex_index> reached(v.begin(), v.end());
    for(int ring = 0; ring < m_rings; ++ring) {
      const std::set<Mesh::Vertex_index> inner = reached;
      for(const auto w : inner)
        for(const auto x : m_mesh.vertices_around_target(m_mesh.halfedge(w)))
          reached.insert(x);
    }
    return std::any_of(reached.begin(), reached.end(), [this](Mesh::Vertex_index w) { return m_mesh.is_border(w); });
  }
};

struct Checked_report
  : public Report
{
  std::size_t number_left_inside = 0; // see Report_check
};

// All of the above for one patch; returns the report.
template <class Surface>
Checked_report check_invariants(const Surface& surface, const Domain& domain, const Criteria& criteria, int rings = 1)
{
  Mesh mesh, again;
  Checked_report report{add_patch(surface, domain, criteria, mesh)};
  add_patch(surface, domain, criteria, again);
  check_topology(mesh, domain.loops().size() - 1);
  check_boundary(mesh, division(surface, domain, criteria));
  Report_check<Surface> check(mesh, surface, criteria, report, rings);
  check();
  report.number_left_inside = check.number_left_inside();
  check_identical(mesh, again);
  return report;
}

#endif // PARAMETRIC_SURFACE_MESHER_TEST_CHECK_INVARIANTS_H
