// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_PATCH_PARTS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_PATCH_PARTS_H

#include <CGAL/Parametric_surface_mesher/internal/partition/Patch_region.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Patch_sketch.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Region_cutter.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Region_division.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
The parts of a patch that would have more triangles than a patch may have. The patch is cut in two, and so are its parts, until
each has at most half of that number or a fiftieth of the patch, or until no good cut is found. The result depends on the input
alone, and not on the number of threads.

Points of cuts have indices from `first_index()` on. Each belongs to a strip, in which the trace of the cut will be removed: the
strip of its cut or, close to where cuts meet, that of the meeting point.
*/
template <class Kernel>
class Patch_parts
{
  typedef Patch_region<Kernel> Region;
  typedef Region_cut<Kernel> Cut;
  typedef std::vector<std::size_t> Chain; // indices of nodes

  static constexpr std::size_t no_strip = std::size_t(-1);
  // The largest part, as a share of the largest patch that is not split: 50 000 triangles fit into the caches of most processors.
  static constexpr double share_of_part = 0.5;
  // The largest part is at least this share of the patch: with more parts, joining them takes longer than caches save.
  static constexpr double least_share_of_patch = 0.02;
  // How far the strip of a meeting point reaches along the cuts, in edges: twice the rings of a strip, so that the strips of its
  // cuts do not meet.
  static constexpr std::size_t reach_of_meeting_point = 8;

  std::size_t m_first_index = 0, m_number_of_strips = 0;
  std::vector<Region> m_regions;
  std::vector<std::size_t> m_strips; // by point of a cut
  std::vector<Chain> m_chains;

public:
  template <class Evaluator>
  Patch_parts(const Evaluator& evaluate, const Patch_sketch<Evaluator>& sketch, const Boundary_loops<Kernel>& loops,
              double max_weight, Patch_progress& progress)
  {
    std::vector<Region> stack(1, region_of_patch(evaluate, sketch, loops));
    const double max_weight_of_part
      = (std::max)(share_of_part * max_weight, least_share_of_patch * stack.front().weight());
    const Region_cutter<Evaluator> find_cut(evaluate, sketch);
    while(!stack.empty() && progress.go_further()) {
      Region region = std::move(stack.back());
      stack.pop_back();
      std::vector<Region> parts;
      if(region.weight() > (m_chains.empty() ? max_weight : max_weight_of_part)) {
        Cut cut = find_cut(region);
        number_nodes(cut);
        parts = Region_division<Kernel>(region, cut)();
      }
      if(parts.size() > 1)
        std::move(parts.rbegin(), parts.rend(), std::back_inserter(stack));
      else
        m_regions.push_back(std::move(region));
    }
    find_strips();
  }

  const std::vector<Region>& regions() const { return m_regions; }
  std::size_t first_index() const { return m_first_index; }
  std::size_t number_of_cut_points() const { return m_strips.size(); }
  std::size_t number_of_strips() const { return m_number_of_strips; }

  // The strip of the point of a cut with index `first_index() + i`.
  std::size_t strip(std::size_t i) const { return m_strips[i]; }

private:
  template <class Evaluator>
  Region region_of_patch(const Evaluator& evaluate, const Patch_sketch<Evaluator>& sketch,
                         const Boundary_loops<Kernel>& loops)
  {
    Region result;
    result.cells = sketch.cells();
    for(const auto& loop : loops) {
      result.loops.emplace_back();
      for(const Boundary_vertex<Kernel>& vertex : loop) {
        const auto position = evaluate.position(vertex.domain_point, sketch.spacing(vertex.domain_point));
        result.loops.back().emplace_back(vertex, position.point.tensor());
        m_first_index = (std::max)(m_first_index, vertex.index + 1);
      }
      const bool is_outer = result.loops.size() == 1;
      if((signed_area(result.loops.back()) > 0) != is_outer)
        std::reverse(result.loops.back().begin(), result.loops.back().end());
    }
    return result;
  }

  void number_nodes(Cut& cut)
  {
    for(auto& chain : cut.chains) {
      for(std::size_t i = 1; i + 1 < chain.nodes.size(); ++i) {
        chain.nodes[i].index = m_first_index + m_strips.size();
        m_strips.push_back(m_chains.size());
      }
      m_chains.emplace_back();
      for(const auto& node : chain.nodes)
        m_chains.back().push_back(node.index);
    }
  }

  bool is_of_cut(std::size_t index) const { return index >= m_first_index; }

  // First each chain has one strip. Then each point where a chain ends on another one gets a strip around it.
  void find_strips()
  {
    const std::size_t n = m_chains.size();
    const std::vector<std::size_t> chains = m_strips; // by point
    m_number_of_strips = n;
    for(std::size_t c = 0; c < n; ++c) {
      Chain chain = m_chains[c];
      for(int end = 0; end < 2; ++end, std::reverse(chain.begin(), chain.end()))
        if(is_of_cut(chain.front())) {
          const std::size_t strip = strip_of_meeting_point(chain.front(), m_chains[chains[chain.front() - m_first_index]]);
          mark(chain, 0, strip);
        }
    }
  }

  std::size_t strip_of_meeting_point(std::size_t index, const Chain& chain)
  {
    std::size_t strip = m_strips[index - m_first_index];
    if(strip < m_chains.size())
      strip = m_number_of_strips++;
    mark(chain, std::find(chain.begin(), chain.end(), index) - chain.begin(), strip);
    return strip;
  }

  void mark(const Chain& chain, std::size_t i, std::size_t strip)
  {
    const std::size_t first = i - (std::min)(i, std::size_t(reach_of_meeting_point)), last = i + reach_of_meeting_point;
    for(std::size_t k = first; k <= last && k < chain.size(); ++k)
      if(is_of_cut(chain[k]))
        m_strips[chain[k] - m_first_index] = strip;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_PATCH_PARTS_H
