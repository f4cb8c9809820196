// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_FOR_EACH_BY_WEIGHT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_FOR_EACH_BY_WEIGHT_H

#include <CGAL/Parametric_surface_mesher/internal/support/for_each_index.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Calls a function for 0, ..., n - 1, the heaviest first. Of several exceptions the one with the smallest number is thrown,
// when all calls are done.
template <class ConcurrencyTag, class Function>
void for_each_by_weight(const std::vector<double>& weights, const Function& function)
{
  std::vector<std::size_t> order(weights.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return weights[a] > weights[b]; });
  std::vector<std::exception_ptr> errors(weights.size());
  for_each_index<ConcurrencyTag>(order.size(), [&](std::size_t i) {
    try {
      function(order[i]);
    }
    catch(...) {
      errors[order[i]] = std::current_exception();
    }
  });
  for(const std::exception_ptr& error : errors)
    if(error)
      std::rethrow_exception(error);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_FOR_EACH_BY_WEIGHT_H
