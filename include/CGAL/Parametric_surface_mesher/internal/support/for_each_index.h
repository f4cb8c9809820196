// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_FOR_EACH_INDEX_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_FOR_EACH_INDEX_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#endif

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

template <class ConcurrencyTag>
constexpr bool is_parallel()
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value, "Parallel_tag is enabled but TBB is unavailable.");
#endif
  return std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
}

// Calls a function for 0, ..., n - 1, one call a task where there are threads; begun in this order.
template <class ConcurrencyTag, class Function>
void for_each_index(std::size_t n, const Function& function)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel<ConcurrencyTag>()) {
    tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, n, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for(std::size_t i = range.begin(); i != range.end(); ++i)
          function(i);
      },
      tbb::simple_partitioner());
    return;
  }
#endif
  for(std::size_t i = 0; i < n; ++i)
    function(i);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_FOR_EACH_INDEX_H
