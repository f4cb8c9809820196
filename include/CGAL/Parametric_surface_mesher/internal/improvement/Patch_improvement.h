// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_PATCH_IMPROVEMENT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_PATCH_IMPROVEMENT_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Patch_polishing.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Patch_repair.h>
#include <CGAL/Parametric_surface_mesher/internal/improvement/Patch_smoothing.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Mesh_progress.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Phase_timer.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The improvement of a patch, as long as there is time: before it is refined for the sake of deviation it is smoothed, then the
// worst triangles are repaired, and last it is polished, if that pays.
template <class Evaluator, class Judge>
class Patch_improvement
{
  typedef Patch_triangulation_2<typename Evaluator::Kernel> Triangulation;

  static constexpr unsigned int number_of_smoothing_sweeps = 2;
  static constexpr double least_share_of_moves = 0.01; // of the vertices, for which another sweep is made

  // Polishing costs as much as all else, and gains most where smoothing has not settled. A model of many small patches is
  // meshed faster without, if it is not asked for.
  static constexpr unsigned int default_number_of_polishing_sweeps = 3;
  static constexpr double least_share_of_moves_to_polish = 0.2;
  static constexpr std::size_t least_number_of_vertices_to_polish = 2000;

  Triangulation& m_triangulation;
  const Evaluator& m_evaluate;
  const Parametric_surface_mesh_criteria& m_criteria;
  const double& m_seconds_before; // spent on the patch so far
  Patch_progress& m_progress;
  double m_share_of_moves = 0;    // of the vertices, in the last sweep; 0 if there was none
  std::size_t m_number_of_work_limits = 0;
  bool m_has_new_failures = false;

public:
  Patch_improvement(Triangulation& triangulation, const Evaluator& evaluate, const Parametric_surface_mesh_criteria& criteria,
                    const double& seconds_before, Patch_progress& progress)
    : m_triangulation(triangulation), m_evaluate(evaluate), m_criteria(criteria), m_seconds_before(seconds_before),
      m_progress(progress)
  {}

  bool has_smoothing() const { return max_number_of_sweeps() > 0; }

  void smooth()
  {
    repeat(Patch_smoothing<Evaluator>(m_triangulation, m_evaluate, m_criteria),
           (std::min)(max_number_of_sweeps(), number_of_smoothing_sweeps));
  }

  // \pre the patch is refined
  void repair(const Judge& judge)
  {
    repair_by(judge, [](auto& repair, const auto& go_further) { return repair(go_further); });
  }

  // \pre the patch is repaired, and refined again
  void repair_failures(const Judge& judge)
  {
    repair_by(judge, [](auto& repair, const auto& go_further) { return repair.at_failures(go_further); });
  }

  // Whether the last repair has left faces that fail a criterion and are new to refinement.
  bool has_new_failures() const { return m_has_new_failures; }

  // how many faces the last repair has left because of the bound on its work
  std::size_t number_of_work_limits() const { return m_number_of_work_limits; }

  // \pre the patch is smoothed
  bool has_polishing() const { return number_of_polishing_sweeps() > 0; }

  // Neither makes the smallest angle smaller; after one there may be more for the other.
  // \pre the patch is repaired
  void polish(const Judge& judge)
  {
    repeat(Patch_polishing<Evaluator, Judge>(m_triangulation, m_evaluate, judge, m_criteria), number_of_polishing_sweeps());
    repair(judge);
  }

private:
  template <class Run>
  void repair_by(const Judge& judge, const Run& run)
  {
    Patch_repair<Evaluator, Judge> repair(m_triangulation, m_evaluate, judge, m_criteria);
    m_number_of_work_limits = run(repair, [has_time = clock(), this] { return m_progress.go_further() && has_time(); });
    m_has_new_failures = repair.has_new_failures();
  }

  unsigned int max_number_of_sweeps() const
  {
    return m_criteria.max_number_of_sweeps().value_or(number_of_smoothing_sweeps);
  }

  unsigned int number_of_polishing_sweeps() const
  {
    if(m_criteria.max_number_of_sweeps())
      return max_number_of_sweeps() - (std::min)(max_number_of_sweeps(), number_of_smoothing_sweeps);
    const bool pays = m_share_of_moves >= least_share_of_moves_to_polish
                      && m_triangulation.number_of_vertices() >= least_number_of_vertices_to_polish;
    return pays ? default_number_of_polishing_sweeps : 0;
  }

  template <class Sweep>
  void repeat(Sweep&& sweep, unsigned int number_of_sweeps)
  {
    const auto has_time = clock();
    for(unsigned int i = 0; i < number_of_sweeps && m_progress.go_further() && has_time(); ++i) {
      m_share_of_moves = double(sweep([this] { return m_progress.go_further(); })) / double(m_triangulation.number_of_vertices());
      if(m_share_of_moves < least_share_of_moves)
        return;
    }
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

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_PATCH_IMPROVEMENT_H
