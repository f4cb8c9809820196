// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_RUN_JOBS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_RUN_JOBS_H

#include <CGAL/Parametric_surface_mesher/internal/support/for_each_index.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// What the scheduler has to know of a job.
struct Job
{
  double weight;     // tells about how long it takes: long ones come first
  bool is_exclusive; // whether no other job that is exclusive may run at the same time
};

// The scheduler: calls `function` with the numbers 0, ..., n - 1 of all jobs, for several at the same time where there are
// threads. Returns the exceptions that they have thrown, by the numbers of the jobs; null for those that were done. A job
// must not depend on others, and one that is exclusive must not wait for other threads: then neither results nor errors
// depend on the number of threads.
template <class ConcurrencyTag, class Function>
std::vector<std::exception_ptr> run_jobs(const std::vector<Job>& jobs, const Function& function)
{
  std::vector<std::size_t> order(jobs.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return jobs[a].weight > jobs[b].weight; });
  // The exclusive jobs are one after the other on one thread, which is begun first: no job waits for a lock.
  const auto first_concurrent = std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return jobs[i].is_exclusive; });
  const std::size_t number_of_exclusive = std::size_t(first_concurrent - order.begin()),
                    number_of_chains = number_of_exclusive > 0 ? 1 : 0;
  std::vector<std::exception_ptr> errors(jobs.size());
  const auto run = [&](std::size_t i) {
    try {
      function(i);
    }
    catch(...) {
      errors[i] = std::current_exception();
    }
  };
  for_each_index<ConcurrencyTag>(number_of_chains + order.size() - number_of_exclusive, [&](std::size_t i) {
    if(i < number_of_chains)
      std::for_each(order.begin(), first_concurrent, run);
    else
      run(order[number_of_exclusive + i - number_of_chains]);
  });
  return errors;
}

// The same for jobs with these weights, none of them exclusive. Of several exceptions the one with the smallest number is
// thrown, when all jobs are done.
template <class ConcurrencyTag, class Function>
void for_each_by_weight(const std::vector<double>& weights, const Function& function)
{
  std::vector<Job> jobs;
  for(double weight : weights)
    jobs.push_back({weight, false});
  for(const std::exception_ptr& error : run_jobs<ConcurrencyTag>(jobs, function))
    if(error)
      std::rethrow_exception(error);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_RUN_JOBS_H
