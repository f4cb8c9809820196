// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PHASE_TIMER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PHASE_TIMER_H

#include <ctime>
#include <time.h>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The processor time of the calling thread; where there is no clock for that, of the process.
inline double thread_seconds()
{
#ifdef CLOCK_THREAD_CPUTIME_ID
  timespec time;
  if(clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0)
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
#endif
  return double(std::clock()) / CLOCKS_PER_SEC;
}

// Adds the processor time of its own life to a number of seconds.
class Phase_timer
{
  double m_start;
  double& m_seconds;

public:
  explicit Phase_timer(double& seconds) : m_start(thread_seconds()), m_seconds(seconds) {}
  ~Phase_timer() { m_seconds += thread_seconds() - m_start; }
  Phase_timer(const Phase_timer&) = delete;
  Phase_timer& operator=(const Phase_timer&) = delete;
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PHASE_TIMER_H
