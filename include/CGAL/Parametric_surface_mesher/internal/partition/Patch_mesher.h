// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_PATCH_MESHER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_PATCH_MESHER_H

#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Charted_boundary.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Charted_surface_3.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Patch_improvement.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Chord_splitter.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Partial_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Criteria_with_own.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Patch_collector.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Patch_judgement.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Feature_search.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Patch_refinement.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Pole_ring.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Patch_evaluator.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Unit_evaluator.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/check_derivatives.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Mesh_progress.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Phase_timer.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/triangulate_boundary.h>
#include <CGAL/Parametric_surface_oracle_3.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The criteria as seen from a chart: the sizing field takes points of the domain.
template <class Criteria, class Chart>
Criteria chart_criteria(const Criteria& criteria, const Chart& chart)
{
  Criteria result = criteria;
  result.set_angle(criteria.angle_of_refinement());
  if(criteria.angle() > result.angle() && criteria.improvement_angle() > 0)
    result.set_improvement_angle((std::max)(criteria.angle(), criteria.improvement_angle()));
  if(criteria.sizing_field() && !chart.is_identity())
    result.set_sizing_field([field = criteria.sizing_field(), chart](double x, double y) {
      const auto uv = chart.domain_point(typename Chart::Point_2(x, y));
      return (*field)(uv.x(), uv.y());
    });
  return result;
}

// From the divided boundary of a patch, or of a part of one, to its triangles: triangulation, refinement, improvement. A patch
// with poles is meshed in the coordinates of a chart. Patches know nothing of each other until they are collected.
template <class Oracle, class Criteria>
class Patch_mesher
{
public:
  typedef typename Oracle::Geom_traits Kernel;
  typedef Charted_surface_3<typename Oracle::Surface> Surface;
  typedef Parametric_surface_oracle_3<Surface, typename Oracle::Metric_field> Charted_oracle;
  typedef Patch_evaluator<Charted_oracle> Evaluator;
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef decltype(make_judge(std::declval<const Charted_oracle&>(), std::declval<const Criteria&>())) Judge;
  typedef Patch_refinement<Evaluator, Judge> Refinement;

private:
  const Surface m_surface;
  const Charted_oracle m_oracle;
  const Criteria m_criteria;
  const double m_angle; // that was asked for, which may be more than what refinement goes for
  const Charted_boundary<Kernel>& m_boundary; // of the patch
  const Boundary_loops<Kernel> m_loops;       // in the chart
  const Evaluator m_evaluator;
  Patch_progress m_progress;
  Triangulation m_triangulation;
  std::size_t m_number_of_boundary_vertices = 0;
  const Judge m_judge;
  const std::size_t m_first_index_of_cuts; // of vertices; the patch is whole if there is none
  Refinement m_refine;
  bool m_has_taken_over = false; // a triangulation of the boundary
  Parametric_surface_mesh_report m_report;

public:
  // `boundary`: of the patch; it stays where it is. `loops`: of the patch or the part, in the chart. `first_index_of_cuts`: of
  // a part, from there on vertices of loops are not on the boundary of the patch
  // \pre no segments of the loops cross
  Patch_mesher(const Oracle& oracle, const Criteria& criteria, const Charted_boundary<Kernel>& boundary,
               Boundary_loops<Kernel> loops, std::size_t first_index_of_cuts, Mesh_progress& progress)
    : m_surface(oracle.surface(), boundary.chart()), m_oracle(m_surface, oracle.metric(), oracle.singular_points()),
      m_criteria(chart_criteria(criteria, boundary.chart())), m_angle(criteria.angle()), m_boundary(boundary), m_loops(std::move(loops)),
      m_evaluator(m_oracle, m_criteria, boundary.box()), m_progress(progress),
      m_judge(make_judge(m_oracle, m_criteria)), m_first_index_of_cuts(first_index_of_cuts),
      m_refine(m_triangulation, m_evaluator, m_criteria, m_judge, m_progress)
  {}

  // it refers to itself
  Patch_mesher(const Patch_mesher&) = delete;
  Patch_mesher& operator=(const Patch_mesher&) = delete;

  void operator()()
  {
    triangulate_and_refine([](auto& triangulate, const auto& evaluate) { triangulate(evaluate); });
  }

  // `given`: of the loops
  void operator()(Boundary_triangulation<Kernel> given)
  {
    triangulate_and_refine([&](auto& triangulate, const auto& evaluate) { triangulate(evaluate, std::move(given)); });
  }

  // Each phase is begun only if the run was not stopped before.
  // \pre there is a triangulation
  void refine_and_improve(bool has_front)
  {
    mark_cuts();
    Patch_improvement<Evaluator, Judge> improve(m_triangulation, m_evaluator, m_criteria, m_report.seconds.improvement,
                                                m_progress);
    in_phase("refinement", m_report.seconds.refinement, [&] {
      if(has_front)
        advance_front();
      m_refine(Scope::SHAPE);
    });
    if(improve.has_smoothing())
      in_phase("smoothing", m_report.seconds.improvement, [&] { improve.smooth(); });
    in_phase("refinement", m_report.seconds.refinement, [&] {
      m_refine(Scope::WHOLE);
      refine_at_features();
    });
    in_phase("improvement", m_report.seconds.improvement, [&] { improve.repair(m_judge); });
    if(improve.has_new_failures()) {
      in_phase("refinement", m_report.seconds.refinement, [&] { m_refine(Scope::WHOLE); });
      in_phase("improvement", m_report.seconds.improvement, [&] { improve.repair_failures(m_judge); });
    }
    if(improve.has_polishing())
      in_phase("polishing", m_report.seconds.improvement, [&] { improve.polish(m_judge); });
    m_report.number_of_replaced_tensors += m_refine.number_of_replaced_tensors();
    m_report.number_of_work_limits += m_refine.number_of_work_limits() + improve.number_of_work_limits();
  }

  // whether the visitor has stopped the run before the patch was done
  bool is_stopped() const { return m_progress.is_stopped(); }

  Triangulation& triangulation() { return m_triangulation; }
  const Refinement& refinement() const { return m_refine; }

  std::size_t number_of_inner_vertices() const { return m_triangulation.number_of_vertices() - m_number_of_boundary_vertices; }

  // No two patches are to have the same chord. `chords`: what joins boundary vertices of the patch's shell.
  void split_chords(typename Indexed_mesh<Kernel>::Chords& chords)
  {
    Phase_timer timer(m_report.seconds.improvement);
    Chord_splitter<Evaluator> split_chords(m_triangulation, m_evaluator, chords);
    split_chords();
  }

  // The triangles, and what is to be told of them.
  Partial_mesh<Kernel> collect(bool keeps_domain_points, bool keeps_corner_points, Parametric_surface_mesh_report& report)
  {
    report.seconds += m_report.seconds;
    report.number_of_replaced_tensors += m_report.number_of_replaced_tensors;
    report.number_of_work_limits += m_report.number_of_work_limits;
    Phase_timer timer(report.seconds.output);
    Patch_judgement<Kernel, Judge, Refinement> judge(m_judge, m_refine, m_angle > m_criteria.angle() ? m_angle : 0);
    Partial_mesh<Kernel> part;
    Patch_collector<Kernel> collect(m_triangulation, m_boundary, part, report);
    if(is_stopped())
      collect(keeps_domain_points, keeps_corner_points, [&](auto face) { judge.judge_after_stop(face); });
    else {
      Feature_search<Evaluator> features = feature_search();
      collect(keeps_domain_points, keeps_corner_points, [&](auto face) {
        judge(face);
        features.judge(face);
      });
    }
    return part;
  }

private:
  void mark_cuts()
  {
    if(m_first_index_of_cuts != no_vertex_index)
      for(auto vertex : m_triangulation.finite_vertex_handles())
        vertex->set_on_cut(vertex->is_on_boundary() && vertex->index() >= m_first_index_of_cuts);
  }

  template <class Run>
  void in_phase(const char* name, double& seconds, const Run& run)
  {
    if(!m_progress.go_further())
      return;
    Phase_timer timer(seconds);
    m_progress.on_phase(name);
    run();
  }

  template <class Triangulate>
  void triangulate_and_refine(const Triangulate& triangulate)
  {
    {
      Phase_timer timer(m_report.seconds.triangulation);
      m_progress.on_phase("triangulation");
      this->triangulate(triangulate);
    }
    refine_and_improve(m_criteria.placement() == Mesh_point_placement::FRONTAL);
  }

  // So a triangulation that was taken over gives the same mesh however it was made.
  void advance_front()
  {
    if(m_has_taken_over)
      m_refine.advance_front(faces_along_boundary(m_triangulation));
    else
      m_refine.advance_front(m_triangulation.finite_face_handles());
  }

  Feature_search<Evaluator> feature_search()
  {
    return {m_triangulation, m_evaluator, m_criteria, m_surface.surface_in_domain(), m_boundary.box()};
  }

  // Features that the triangles miss are looked for until there is none.
  void refine_at_features()
  {
    Feature_search<Evaluator> insert_at_features = feature_search();
    while(!m_progress.is_stopped() && insert_at_features()) {
      m_refine(Scope::SHAPE);
      m_refine(Scope::WHOLE);
    }
    m_report.number_of_replaced_tensors += insert_at_features.number_of_replaced_tensors();
  }

  // So that the mesh has no holes, this is done after a stop, too: then without evaluating the surface.
  // `run`: makes a triangulator triangulate, with the points that an evaluator gives
  template <class Run>
  void triangulate(const Run& run)
  {
    Boundary_triangulator<Kernel> triangulate(m_triangulation, m_loops);
    const Unit_evaluator<Surface> evaluate_after_stop(m_surface);
    run(triangulate, [&](const auto& uv, const auto& surface_point, double spacing) {
      return m_progress.go_further() ? m_evaluator(uv, surface_point, spacing) : evaluate_after_stop(uv, surface_point, spacing);
    });
    if(!m_progress.is_stopped())
      check_derivatives(m_surface, m_triangulation);
    if(m_first_index_of_cuts == no_vertex_index) // else they are counted for the patch
      m_report.number_of_replaced_tensors += triangulate.number_of_replaced_tensors();
    m_report.number_of_work_limits += triangulate.number_of_work_limits();
    m_has_taken_over = triangulate.has_taken_over();
    m_number_of_boundary_vertices = m_triangulation.number_of_vertices(); // loops may have vertices in common
    if(m_progress.is_stopped())
      return;
    Pole_ring<Evaluator> insert_rings(m_triangulation, m_evaluator, m_boundary);
    insert_rings(m_loops);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_PATCH_MESHER_H
