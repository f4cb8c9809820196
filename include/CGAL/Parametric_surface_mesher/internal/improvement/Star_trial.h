// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_STAR_TRIAL_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_STAR_TRIAL_H

#include <CGAL/Parametric_surface_mesher/internal/improvement/Failure_count.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Kept_states.h>

#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Moves the centre of a star to see whether more of its faces fail a criterion, and back if so.
template <class Star, class FailureCount>
class Star_trial
{
  typedef typename Star::Point Point;

  Star& m_star;
  const FailureCount& m_number_of_failures;
  Kept_states<typename Star::Face_handle> m_states;
  Point m_old_point;
  double m_old_sine = 0; // squared
  Failures m_old_failures;
  bool m_has_moved = false;

public:
  Star_trial(Star& star, const FailureCount& number_of_failures) : m_star(star), m_number_of_failures(number_of_failures)
  {}

  // of the star as it is; `squared_sine`: of its smallest angle
  void begin(double squared_sine)
  {
    m_old_point = m_star.center();
    m_old_sine = squared_sine;
    m_has_moved = false;
  }

  // Whether no more faces fail than before. The centre stays there until the next move, or the end.
  bool move_to(const Point& point)
  {
    if(!m_has_moved) {
      m_old_failures = m_number_of_failures(m_star.faces(), m_old_sine);
      m_states.keep(m_star.faces());
      m_has_moved = true;
    }
    m_star.try_at(point);
    return !m_number_of_failures(m_star.faces(), m_old_sine, m_old_failures).are_more_than(m_old_failures);
  }

  // all as it was
  void give_up()
  {
    if(!m_has_moved)
      return;
    m_star.try_at(m_old_point);
    m_states.give_back();
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_STAR_TRIAL_H
