// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_PHASE_TIMER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_PHASE_TIMER_H

#include <chrono>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The time of a steady clock. CGAL::Timer measures processor time by a system call, which is too slow for the many short phases of
// small patches; CGAL::Real_timer uses the time of day, which may be set back, with a resolution of a microsecond.
inline double elapsed_seconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Adds the time of its own life to a number of seconds.
class Phase_timer
{
  double m_start;
  double& m_seconds;

public:
  explicit Phase_timer(double& seconds) : m_start(elapsed_seconds()), m_seconds(seconds) {}
  ~Phase_timer() { m_seconds += elapsed_seconds() - m_start; }
  Phase_timer(const Phase_timer&) = delete;
  Phase_timer& operator=(const Phase_timer&) = delete;
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_PHASE_TIMER_H
