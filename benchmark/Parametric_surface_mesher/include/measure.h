// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Processor time and peak memory of parts of a program. For POSIX systems.
#ifndef MEASURE_H
#define MEASURE_H

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <type_traits>
#include <vector>

// Not CGAL::Timer: that leaves out the system's part, in which new memory is mapped.
inline double processor_seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// the time of `job` alone, without that of destroying its operands
template <class Job>
double seconds_of(const Job& job)
{
  const double begin = processor_seconds();
  job();
  return processor_seconds() - begin;
}

// The mean of what `run` returns, its own time in seconds: run again until the sum is far above the clock's resolution.
template <class Run>
double mean_seconds(const Run& run)
{
  const double measurable = 0.2;
  double sum = 0;
  std::size_t n = 0;
  do {
    sum += run();
    ++n;
  } while(sum < measurable);
  return sum / n;
}

// \pre `values` is not empty
inline double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

// the most memory that the process has held so far, in bytes
inline double peak_memory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return usage.ru_maxrss;
#else
  return 1024. * usage.ru_maxrss;
#endif
}

// What `function` returns when called in a child process: one call does not see memory that another has left free, and its
// `peak_memory()` starts from what the parent holds. Throws std::runtime_error if the child does not succeed.
template <class Function>
auto in_child_process(const Function& function) -> decltype(function())
{
  typedef decltype(function()) Result;
  static_assert(std::is_trivially_copyable<Result>::value, "the result goes through a pipe");
  int ends[2];
  if(pipe(ends) != 0)
    throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if(child < 0)
    throw std::runtime_error("no child process");
  if(child == 0) {
    bool is_sent = false;
    try {
      const Result result = function();
      is_sent = write(ends[1], &result, sizeof result) == static_cast<ssize_t>(sizeof result);
    } catch(const std::exception& e) {
      std::cerr << e.what() << "\n";
    }
    _exit(is_sent ? EXIT_SUCCESS : EXIT_FAILURE);
  }
  close(ends[1]);
  Result result;
  const ssize_t received = read(ends[0], &result, sizeof result); // less than a pipe's atomic size
  close(ends[0]);
  waitpid(child, nullptr, 0);
  if(received != static_cast<ssize_t>(sizeof result))
    throw std::runtime_error("the child process has failed");
  return result;
}

#endif // MEASURE_H
