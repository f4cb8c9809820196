// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_PATCH_REGION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_PATCH_REGION_H

#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Patch_sketch.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A point of the boundary of a region, with its metric tensor.
template <class Kernel>
struct Region_node
  : Boundary_vertex<Kernel>
{
  Metric_tensor_2 tensor;

  Region_node(const Boundary_vertex<Kernel>& vertex, const Metric_tensor_2& t)
    : Boundary_vertex<Kernel>(vertex), tensor(t)
  {}
};

// Twice the area of a loop in the domain; positive if it runs counterclockwise.
template <class Kernel>
double signed_area(const std::vector<Region_node<Kernel>>& loop)
{
  double sum = 0;
  for(std::size_t i = 0; i < loop.size(); ++i) {
    const auto p = loop[i].domain_point - loop[0].domain_point,
               q = loop[(i + 1) % loop.size()].domain_point - loop[0].domain_point;
    sum += p.x() * q.y() - p.y() * q.x();
  }
  return sum;
}

// A patch or, after cuts, a part of it: its boundary, with the domain to the left and the outer loop first, and the cells of the
// sketch inside.
template <class Kernel>
struct Patch_region
{
  typedef Region_node<Kernel> Node;

  std::vector<std::vector<Node>> loops;
  std::vector<Sketch_cell<Kernel>> cells;

  double weight() const
  {
    double result = 0;
    for(const auto& cell : cells)
      result += cell.weight;
    return result;
  }

  Boundary_loops<Kernel> boundary_loops() const
  {
    Boundary_loops<Kernel> result;
    for(const auto& loop : loops)
      result.emplace_back(loop.begin(), loop.end());
    return result;
  }
};

// A node of the boundary of a region.
struct Region_place
{
  std::size_t loop, number;
};

// Polylines through a region, each from one node of its boundary to another, both included.
template <class Kernel>
struct Region_cut
{
  struct Chain
  {
    Region_place source, target;
    std::vector<Region_node<Kernel>> nodes;
  };

  std::vector<Chain> chains;
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_PATCH_REGION_H
