// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the mesher on a random input and audits what comes of it.
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_CHECK_FUZZ_CASE_H
#define PARAMETRIC_SURFACE_MESHER_TEST_CHECK_FUZZ_CASE_H

#include <Fuzz_case.h>
#include <Mesh_audit.h>
#include <Report_audit.h>
#include <mesh_fuzz_case.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

class Fuzz_check
{
  typedef Fuzz_domain::Curve Curve;
  typedef Audited_patch<Fuzz_surface, Curve> Patch;
  typedef Fuzz_kernel::Point_2 Point_2;

  const Fuzz_case& m_case;
  std::vector<Patch> m_patches;
  Audit_findings m_findings;
  Fuzz_mesh m_result;
  Fuzz_outcome m_outcome;

public:
  explicit Fuzz_check(const Fuzz_case& fuzz_case)
    : m_case(fuzz_case)
  {
    list_patches();
  }

  const Audit_findings& operator()()
  {
    m_outcome = mesh_fuzz_case(m_case, m_case.criteria, false, m_result);
    judge(m_outcome);
    if(m_outcome.is_mesh()) {
      audit_mesh();
      compare_boundary();
    }
    if(m_findings.empty())
      repeat();
    return m_findings;
  }

  const Fuzz_mesh& result() const { return m_result; }
  const std::string& refusal() const { return m_outcome.refusal; }

private:
  void list_patches()
  {
    if(m_case.model)
      for(const auto& face : m_case.model->faces()) {
        Patch patch{&face.surface, {}, face.is_reversed, m_case.model->tolerance()};
        for(const auto& loop : face.loops) {
          patch.loops.emplace_back();
          for(const auto& use : loop)
            patch.loops.back().push_back({&use.curve, use.is_reversed, m_case.model->edges()[use.edge].is_collapsed});
        }
        m_patches.push_back(patch);
      }
    else {
      Patch patch{&*m_case.surface, {}, false, 0};
      const double size = diagonal();
      for(const auto& loop : m_case.domain->loops()) {
        patch.loops.emplace_back();
        for(const auto& curve : loop)
          patch.loops.back().push_back({&curve, false, box(curve).second <= 1e-9 * size});
      }
      patch.tolerance = 1e-9 * size;
      m_patches.push_back(patch);
    }
  }

  static double span(const CGAL::Bbox_3& b)
  {
    return std::sqrt(CGAL::square(b.x_span()) + CGAL::square(b.y_span()) + CGAL::square(b.z_span()));
  }

  // the box of a curve in space, by samples, and its diagonal
  std::pair<CGAL::Bbox_3, double> box(const Curve& curve) const
  {
    CGAL::Bbox_3 result;
    for(int k = 0; k <= 16; ++k) {
      const Point_2 p = curve.point(k == 16 ? curve.end() : curve.begin() + k / 16. * (curve.end() - curve.begin()));
      result += m_case.surface->point(p.x(), p.y()).bbox();
    }
    return {result, span(result)};
  }

  double diagonal() const
  {
    CGAL::Bbox_3 result;
    for(const auto& loop : m_case.domain->loops())
      for(const auto& curve : loop)
        result += box(curve).first;
    return span(result);
  }

  // Whether the pieces of the boundary are short enough to cross where its curves do. If the minimum edge is as long as the whole shape,
  // each curve gets the fewest chords that it may have, and these may miss each other although the curves cross.
  bool are_curves_followed() const
  {
    return !m_case.surface || !m_case.criteria.sizing().min_edge || *m_case.criteria.sizing().min_edge < diagonal();
  }

  void judge(const Fuzz_outcome& outcome)
  {
    if(!outcome.broken.empty())
      m_findings.add("an exception that is none of the mesher's", outcome.broken);
    const bool is_over_limit = outcome.refusal.find("the allowed number of") != std::string::npos; // of vertices
    if(!outcome.refusal.empty() && m_case.expectation == Fuzz_expectation::MESH && !is_over_limit)
      m_findings.add("a good input is refused", outcome.refusal);
    if(outcome.is_mesh() && m_case.expectation == Fuzz_expectation::REFUSAL && are_curves_followed())
      m_findings.add("a wrong input is meshed");
    if(outcome.refusal.find("nan") != std::string::npos)
      m_findings.add("a message has nan in it", outcome.refusal);
  }

  void audit_mesh()
  {
    audit_connectivity(m_result, m_findings);
    audit_smallest_angle(m_result, m_findings);
    for(std::size_t i = 0; i < m_patches.size(); ++i)
      Patch_audit<Fuzz_kernel, Fuzz_surface, Curve>(m_result, i, m_patches[i], m_findings)();
    if(m_case.surface && !m_patches.front().has_collapsed_curve() && !m_case.number_of_questions)
      Report_audit<Fuzz_kernel, Fuzz_surface>(m_result, *m_case.surface, m_case.criteria, m_case.metric.is_default(), m_findings)();
    if(m_case.is_model_closed)
      for(const auto h : m_result.mesh.halfedges())
        if(m_result.mesh.is_border(h)) {
          m_findings.add("a closed model has a mesh with a border", h);
          break;
        }
  }

  std::vector<std::pair<Point_2, Point_2>> border(const Fuzz_mesh& result, std::size_t patch)
  {
    Audit_findings ignored;
    Patch_audit<Fuzz_kernel, Fuzz_surface, Curve> audit(result, patch, m_patches[patch], ignored);
    audit();
    return audit.border();
  }

  // Without a point inside, the division of the boundary is the same; unless a stop has ended it.
  void compare_boundary()
  {
    if(m_case.number_of_questions)
      return;
    Fuzz_mesh coarse;
    auto criteria = m_case.criteria;
    criteria.set_max_number_of_vertices(m_result.report.number_of_boundary_edges + 1);
    const Fuzz_outcome outcome = mesh_fuzz_case(m_case, criteria, false, coarse);
    if(!outcome.is_mesh()) {
      m_findings.add("no mesh without inner points", outcome.refusal, outcome.broken);
      return;
    }
    for(std::size_t i = 0; i < m_patches.size(); ++i)
      if(border(m_result, i) != border(coarse, i))
        m_findings.add("the division of the boundary depends on the points inside", "patch", i);
  }

  // The same input gives the same mesh, bit for bit, or the same message and nothing in a mesh that has a triangle already. How
  // far the mesher comes before a stop depends on the time.
  void repeat()
  {
    Fuzz_mesh again;
    if(!m_outcome.is_mesh())
      again.mesh.add_face(again.mesh.add_vertex({0, 0, 0}), again.mesh.add_vertex({1, 0, 0}), again.mesh.add_vertex({0, 1, 0}));
    const Fuzz_outcome outcome
      = mesh_fuzz_case(m_case, m_case.criteria, m_case.has_threads && !m_case.number_of_questions, again);
    if(m_case.number_of_questions)
      return;
    if(outcome.refusal != m_outcome.refusal || outcome.broken != m_outcome.broken)
      m_findings.add("the same input gives another message", m_outcome.refusal, outcome.refusal, outcome.broken);
    else if(m_outcome.is_mesh() && !is_same(m_result, again))
      m_findings.add("the same input gives another mesh", m_result.mesh.number_of_vertices(), again.mesh.number_of_vertices());
    else if(!m_outcome.is_mesh() && (again.mesh.number_of_vertices() != 3 || again.mesh.number_of_faces() != 1))
      m_findings.add("a refused input changed the mesh");
  }

  static bool is_same(const Fuzz_mesh& a, const Fuzz_mesh& b)
  {
    if(a.mesh.number_of_vertices() != b.mesh.number_of_vertices() || a.mesh.number_of_faces() != b.mesh.number_of_faces()
       || a.report.unmet.size() != b.report.unmet.size() || a.report.smallest_angle != b.report.smallest_angle)
      return false;
    for(const auto v : a.mesh.vertices())
      if(a.mesh.point(v) != b.mesh.point(v))
        return false;
    for(const auto f : a.mesh.faces()) {
      const auto h = a.halfedges(f), k = b.halfedges(f);
      for(std::size_t i = 0; i < 3; ++i)
        if(a.mesh.target(h[i]) != b.mesh.target(k[i]) || a.halfedge_uv[h[i]] != b.halfedge_uv[k[i]])
          return false;
    }
    return true;
  }
};

#endif // PARAMETRIC_SURFACE_MESHER_TEST_CHECK_FUZZ_CASE_H
