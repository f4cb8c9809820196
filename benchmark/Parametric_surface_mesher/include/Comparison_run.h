// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One mesher on one shape: found sizes, measured times and memory, and the verdict on the mesh. Every run has a process of its own.
#ifndef COMPARISON_RUN_H
#define COMPARISON_RUN_H

#include "Mesh_sizes.h"
#include "judge_comparison_mesh.h"
#include "measure.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// What meshes are asked for: about so many triangles, or a distance.
struct Comparison_target
{
  enum Kind { TRIANGLES, DISTANCE } kind;
  double value;

  // What a mesher is asked for if an edge of the length `edge_length` would do; longer edges than `longest` are not wanted.
  Mesh_sizes sizes(double edge_length, double longest) const
  {
    if(kind == TRIANGLES)
      return {edge_length, {}};
    return {longest, edge_length * edge_length / 8};
  }

  // how many times as long edges may be, since the number of triangles goes with their inverse square and the distance with their square
  double correction(const Comparison_verdict& verdict) const
  {
    return std::sqrt(kind == TRIANGLES ? verdict.faces / value : value / verdict.distance);
  }
};

struct Comparison_mesher
{
  std::string name;
  std::function<Mesher_run(const Mesh_sizes& sizes, Sample_mesh& mesh)> run;
};

struct Comparison_run
{
  std::string shape, mesher;
  Comparison_target target;
  Mesh_sizes sizes{};
  std::vector<double> seconds = {};
  double memory = 0; // by how much the peak memory grew, in bytes
  Comparison_verdict verdict{};
};

namespace comparison {

struct Cost
{
  double seconds, memory;
};

// Memory that is free here would hide what a child process takes.
inline void return_free_memory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

inline Cost cost_of(const Comparison_mesher& mesher, const Mesh_sizes& sizes)
{
  return_free_memory();
  return in_child_process([&] {
    Cost cost{0, -1};
    cost.seconds = mean_seconds([&] {
      Sample_mesh mesh;
      const Mesher_run run = mesher.run(sizes, mesh);
      if(cost.memory < 0)
        cost.memory = run.memory;
      return run.seconds;
    });
    return cost;
  });
}

inline Comparison_verdict verdict_on(const Comparison_mesher& mesher, const Mesh_sizes& sizes, const Comparison_shape& shape,
                                     const std::vector<Point_3>& points)
{
  return in_child_process([&] {
    Sample_mesh mesh;
    mesher.run(sizes, mesh);
    return judge_comparison_mesh(mesh, shape, points);
  });
}

} // namespace comparison

// Finds sizes with which the mesher reaches the target within a few percent, if there are any: meshes up to `trials` times.
inline Comparison_run calibrated_run(const Comparison_mesher& mesher, const Comparison_shape& shape, const Comparison_target& target,
                                     double edge_length, const std::vector<comparison::Point_3>& points, int trials)
{
  const double longest = 0.5;    // edges, on shapes with an extent of 2
  const double close = 0.02;     // the error of the edge length that is good enough
  const double largest_step = 2; // of the edge length: surfaces are not smooth, and distances may jump
  Comparison_run best{shape.name, mesher.name, target};
  double least_error = 1e9;
  for(int i = 0; i < trials && least_error > close; ++i) {
    const Mesh_sizes sizes = target.sizes(edge_length, longest);
    const Comparison_verdict verdict = comparison::verdict_on(mesher, sizes, shape, points);
    const double factor = (std::min)((std::max)(target.correction(verdict), 1 / largest_step), largest_step);
    if(std::abs(std::log(factor)) < least_error) {
      least_error = std::abs(std::log(factor));
      best.sizes = sizes, best.verdict = verdict;
    }
    edge_length *= factor;
  }
  return best;
}

#endif // COMPARISON_RUN_H
