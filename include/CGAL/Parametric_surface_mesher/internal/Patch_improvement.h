// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_IMPROVEMENT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_IMPROVEMENT_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_repair.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_smoothing.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/Phase_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The improvement of a refined patch, as long as there is time: sweeps over all vertices, then the worst triangles.
template <class Evaluator, class Refinement>
class Patch_improvement
{
  typedef Patch_triangulation_2<typename Evaluator::Kernel> Triangulation;

  typedef Patch_smoothing<Evaluator> Smoothing;

  static constexpr unsigned int number_of_thrifty_sweeps = 2;
  static constexpr double smallest_share_of_moves = 0.01; // of the vertices, for which another sweep is made

  Triangulation& m_triangulation;
  const Evaluator& m_evaluate;
  const Parametric_surface_mesh_criteria& m_criteria;
  const double& m_seconds_before; // spent on the patch so far

public:
  Patch_improvement(Triangulation& triangulation, const Evaluator& evaluate, const Parametric_surface_mesh_criteria& criteria,
                    const double& seconds_before)
    : m_triangulation(triangulation), m_evaluate(evaluate), m_criteria(criteria), m_seconds_before(seconds_before)
  {}

  bool has_sweeps() const { return m_criteria.max_number_of_sweeps() > 0; }

  void smooth()
  {
    const auto has_time = clock();
    Smoothing sweep(m_triangulation, m_evaluate, m_criteria);
    const unsigned int n = m_criteria.max_number_of_sweeps();
    repeat(sweep, (std::min)(n, number_of_thrifty_sweeps), has_time);
    if(n > number_of_thrifty_sweeps && has_time()) {
      sweep.be_thorough();
      repeat(sweep, n - number_of_thrifty_sweeps, has_time);
    }
  }

  void repair(const typename Refinement::Is_bad& is_bad)
  {
    Patch_repair<Evaluator, typename Refinement::Is_bad> repair(m_triangulation, m_evaluate, is_bad, m_criteria);
    repair(clock());
  }

private:
  template <class HasTime>
  void repeat(Smoothing& sweep, unsigned int number_of_sweeps, const HasTime& has_time) const
  {
    for(unsigned int i = 0; i < number_of_sweeps && has_time(); ++i)
      if(sweep() < smallest_share_of_moves * double(m_triangulation.number_of_vertices()))
        return;
  }

  // tells whether there is time left; without a limit it does not ask the clock again
  auto clock() const
  {
    const double limit = m_criteria.improvement_time() - m_seconds_before;
    return [limit, start = elapsed_seconds()] { return std::isinf(limit) || elapsed_seconds() - start < limit; };
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_IMPROVEMENT_H
