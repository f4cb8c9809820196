// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MESH_DIVIDED_PATCH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MESH_DIVIDED_PATCH_H

#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_oracle_3.h>
#include <CGAL/Parametric_surface_mesher/internal/Boundary_loops.h>
#include <CGAL/Parametric_surface_mesher/internal/Charted_surface_3.h>
#include <CGAL/Parametric_surface_mesher/internal/Chord_splitter.h>
#include <CGAL/Parametric_surface_mesher/internal/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_collector.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_evaluator.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_refinement.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_improvement.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/Pole_ring.h>
#include <CGAL/Parametric_surface_mesher/internal/find_chart.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulate_boundary.h>

#include <ctime>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Adds the processor time of its own life to a number of seconds.
class Phase_timer
{
  std::clock_t m_start;
  double& m_seconds;

public:
  explicit Phase_timer(double& seconds) : m_start(std::clock()), m_seconds(seconds) {}
  ~Phase_timer() { m_seconds += double(std::clock() - m_start) / CLOCKS_PER_SEC; }
  Phase_timer(const Phase_timer&) = delete;
  Phase_timer& operator=(const Phase_timer&) = delete;
};

// The criteria as seen from a chart: the sizing field takes points of the domain.
template <class Criteria, class Chart>
Criteria chart_criteria(const Criteria& criteria, const Chart& chart)
{
  Criteria result = criteria;
  if(criteria.sizing_field() && !chart.is_identity())
    result.set_sizing_field([field = criteria.sizing_field(), chart](double x, double y) {
      const auto uv = chart.domain_point(typename Chart::Point_2(x, y));
      return field(uv.x(), uv.y());
    });
  return result;
}

// From the divided boundary of a patch to its triangles, which are appended to `mesh`: triangulation, refinement,
// improvement, output. A patch with poles is meshed in the coordinates of a chart.
// `chords`: what joins boundary vertices of the patch's shell.
// \pre the boundary vertices are in `mesh` already, and no segments of the loops cross
template <class Oracle, class Criteria, class Visitor>
void mesh_divided_patch(const Oracle& oracle, const Criteria& criteria,
                        const Boundary_loops<typename Oracle::Geom_traits>& loops, Visitor& visitor,
                        Indexed_mesh<typename Oracle::Geom_traits>& mesh,
                        typename Indexed_mesh<typename Oracle::Geom_traits>::Chords& chords,
                        Parametric_surface_mesh_report& report)
{
  typedef typename Oracle::Geom_traits Kernel;
  typedef Charted_surface_3<typename Oracle::Surface> Surface;
  typedef Parametric_surface_oracle_3<Surface, typename Oracle::Metric_field> Charted_oracle;
  typedef Patch_evaluator<Charted_oracle> Evaluator;
  typedef Patch_refinement<Evaluator, Criteria, Visitor> Refinement;

  const Surface surface(oracle.surface(), find_chart(oracle.surface(), loops));
  const Charted_oracle charted_oracle(surface, oracle.metric(), oracle.singular_points());
  const Criteria charted_criteria = chart_criteria(criteria, surface.chart());
  const Boundary_loops<Kernel> charted_loops = chart_loops(loops, surface.chart());
  const Evaluator evaluator(charted_oracle, charted_criteria, box_of_loops(charted_loops));
  Patch_triangulation_2<Kernel> triangulation;
  Patch_collector<Kernel> collect(triangulation, surface.chart(), mesh, report);
  {
    Phase_timer timer(report.seconds.triangulation);
    visitor.on_phase("triangulation");
    Boundary_triangulator<Kernel> triangulate(triangulation, charted_loops);
    triangulate(evaluator);
    report.number_of_replaced_tensors += triangulate.number_of_replaced_tensors();
    if(!surface.chart().is_identity())
      collect.set_domain_points(triangulate.vertices(), without_collapsed_sides(loops));
    Pole_ring<Evaluator> insert_rings(triangulation, evaluator);
    insert_rings(loops);
  }
  Refinement refine(triangulation, evaluator, charted_criteria, visitor);
  Patch_improvement<Evaluator, Refinement> improve(triangulation, evaluator, charted_criteria, report.seconds.improvement);
  const auto in_phase = [&](const char* name, double& seconds, auto run) {
    Phase_timer timer(seconds);
    visitor.on_phase(name);
    run();
  };
  in_phase("refinement", report.seconds.refinement, [&] {
    if(charted_criteria.placement() == Mesh_point_placement::FRONTAL)
      refine.advance_front();
    if(improve.has_sweeps())
      refine.refine_by_shape();
  });
  if(improve.has_sweeps() && !refine.is_stopped())
    in_phase("smoothing", report.seconds.improvement, [&] { improve.smooth(); });
  in_phase("refinement", report.seconds.refinement, [&] { refine(); });
  report.number_of_replaced_tensors += refine.number_of_replaced_tensors();
  if(!refine.is_stopped())
    in_phase("improvement", report.seconds.improvement, [&] { improve.repair(refine.is_bad()); });
  {
    Phase_timer timer(report.seconds.improvement);
    Chord_splitter<Evaluator> split_chords(triangulation, evaluator, chords);
    split_chords();
  }
  Phase_timer timer(report.seconds.output);
  collect(refine);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MESH_DIVIDED_PATCH_H
