// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_REGION_DIVISION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_REGION_DIVISION_H

#include <CGAL/Parametric_surface_mesher/internal/partition/Loop_inside.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Patch_region.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Divides a region at a cut. The directed edges of the boundary, and those of the cut in both directions, are followed by always
taking the next edge on the left; the loops that result bound the parts.
*/
template <class Kernel>
class Region_division
{
  typedef Patch_region<Kernel> Region;
  typedef Region_node<Kernel> Node;
  typedef typename Kernel::Point_2 Point_2;
  typedef std::vector<Node> Loop;

  const Region& m_region;
  std::vector<const Node*> m_nodes;
  std::vector<std::vector<std::size_t>> m_targets; // of the edges that begin at each node

public:
  Region_division(const Region& region, const Region_cut<Kernel>& cut) : m_region(region)
  {
    std::vector<std::size_t> starts;
    for(const Loop& loop : region.loops) {
      starts.push_back(m_nodes.size());
      for(const Node& node : loop)
        m_nodes.push_back(&node);
      for(std::size_t i = 0; i < loop.size(); ++i)
        m_targets.push_back({starts.back() + (i + 1) % loop.size()});
    }
    for(const auto& chain : cut.chains)
      add(chain, starts);
  }

  std::vector<Region> operator()()
  {
    std::vector<Region> result;
    std::vector<Loop> holes;
    for(Loop& loop : trace_loops())
      if(signed_area(loop) > 0) {
        result.emplace_back();
        result.back().loops.reserve(1 + m_region.loops.size()); // Loop_inside refers to the loops
        result.back().loops.push_back(std::move(loop));
      }
      else
        holes.push_back(std::move(loop));
    std::vector<Loop_inside<Kernel>> is_inside;
    for(const Region& part : result)
      is_inside.emplace_back(part.loops.front());
    const auto part_with = [&](const Point_2& p) -> Region& { // the last one if no other contains the point
      std::size_t i = 0;
      while(i + 1 < result.size() && !is_inside[i](p))
        ++i;
      return result[i];
    };
    for(const Loop& hole : holes)
      part_with(hole.front().domain_point).loops.push_back(hole);
    for(const auto& cell : m_region.cells)
      part_with(cell.center).cells.push_back(cell);
    return result;
  }

private:
  void add(const typename Region_cut<Kernel>::Chain& chain, const std::vector<std::size_t>& starts)
  {
    std::size_t previous = starts[chain.source.loop] + chain.source.number;
    for(std::size_t i = 1; i < chain.nodes.size(); ++i) {
      std::size_t next = m_nodes.size();
      if(i + 1 == chain.nodes.size())
        next = starts[chain.target.loop] + chain.target.number;
      else {
        m_nodes.push_back(&chain.nodes[i]);
        m_targets.emplace_back();
      }
      m_targets[previous].push_back(next);
      m_targets[next].push_back(previous);
      previous = next;
    }
  }

  std::vector<Loop> trace_loops() const
  {
    std::vector<Loop> result;
    std::vector<std::vector<bool>> is_used;
    for(const auto& targets : m_targets)
      is_used.emplace_back(targets.size(), false);
    for(std::size_t first = 0; first < m_nodes.size(); ++first)
      for(std::size_t k = 0; k < m_targets[first].size(); ++k)
        if(!is_used[first][k]) {
          result.emplace_back();
          for(std::size_t source = first, i = k; !is_used[source][i];) {
            is_used[source][i] = true;
            result.back().push_back(*m_nodes[source]);
            const std::size_t target = m_targets[source][i];
            i = leftmost(source, target);
            source = target;
          }
        }
    return result;
  }

  // The target of the edge from `here` that is next on the left when coming from `before`: the first one clockwise from there.
  std::size_t leftmost(std::size_t before, std::size_t here) const
  {
    if(m_targets[here].size() == 1) // nearly everywhere there is only one
      return 0;
    const double back = direction(here, before);
    std::size_t result = 0;
    double smallest_turn = 0;
    for(std::size_t i = 0; i < m_targets[here].size(); ++i) {
      double turn = back - direction(here, m_targets[here][i]);
      turn = m_targets[here][i] == before ? 2 * CGAL_PI : turn < 0 ? turn + 2 * CGAL_PI : turn;
      if(i == 0 || turn < smallest_turn) {
        result = i;
        smallest_turn = turn;
      }
    }
    return result;
  }

  double direction(std::size_t from, std::size_t to) const
  {
    const auto d = m_nodes[to]->domain_point - m_nodes[from]->domain_point;
    return std::atan2(d.y(), d.x());
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_REGION_DIVISION_H
