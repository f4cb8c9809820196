// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef WITH_THREADS_H
#define WITH_THREADS_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace mesh_cad {

// Calls a function with the concurrency tag for a number of threads, and lets it have no more than these.
template <class Function>
auto with_threads([[maybe_unused]] unsigned int number, const Function& function)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(number > 1) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, number);
    return function(CGAL::Parallel_tag());
  }
#endif
  return function(CGAL::Sequential_tag());
}

} // namespace mesh_cad

#endif // WITH_THREADS_H
