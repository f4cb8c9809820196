// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MESH_DIVIDED_PATCH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MESH_DIVIDED_PATCH_H

#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/Boundary_loops.h>
#include <CGAL/Parametric_surface_mesher/internal/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_evaluator.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_refinement.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulate_boundary.h>

#include <CGAL/Timer.h>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Adds the processor time of its own life to a number of seconds.
class Phase_timer
{
  Timer m_timer;
  double& m_seconds;

public:
  explicit Phase_timer(double& seconds) : m_seconds(seconds) { m_timer.start(); }
  ~Phase_timer() { m_seconds += m_timer.time(); }
  Phase_timer(const Phase_timer&) = delete;
  Phase_timer& operator=(const Phase_timer&) = delete;
};

// From the divided boundary of a patch to its triangles, which are appended to `mesh`: triangulation, refinement, output.
// \pre the boundary vertices are in `mesh` already
template <class Oracle, class Criteria, class Visitor>
void mesh_divided_patch(const Oracle& oracle, const Criteria& criteria,
                        const Boundary_loops<typename Oracle::Geom_traits>& loops, Visitor& visitor,
                        Indexed_mesh<typename Oracle::Geom_traits>& mesh, Parametric_surface_mesh_report& report)
{
  typedef typename Oracle::Geom_traits Kernel;
  typedef Patch_evaluator<Oracle> Evaluator;
  typedef Patch_refinement<Evaluator, Criteria, Visitor> Refinement;

  const Evaluator evaluator(oracle, criteria);
  Patch_triangulation_2<Kernel> triangulation;
  {
    Phase_timer timer(report.seconds.triangulation);
    visitor.on_phase("triangulation");
    Boundary_check<Kernel> check(loops);
    check();
    Boundary_triangulator<Kernel> triangulate(triangulation, loops);
    triangulate(evaluator);
    report.number_of_replaced_tensors += triangulate.number_of_replaced_tensors();
  }
  Refinement refine(triangulation, evaluator, criteria, visitor);
  {
    Phase_timer timer(report.seconds.refinement);
    visitor.on_phase("refinement");
    refine();
    report.number_of_replaced_tensors += refine.number_of_replaced_tensors();
  }
  Phase_timer timer(report.seconds.output);
  Patch_collector<Kernel> collect(triangulation, mesh, report);
  collect(refine);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MESH_DIVIDED_PATCH_H
