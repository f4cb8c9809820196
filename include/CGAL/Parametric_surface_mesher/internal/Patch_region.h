// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_REGION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_REGION_H

#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Parametric_surface_mesher/internal/Boundary_loops.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_sketch.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A point of the boundary of a region, with its tensor.
template <class Kernel>
struct Region_node
  : Boundary_vertex<Kernel>
{
  Metric_tensor_2 tensor;

  Region_node(const Boundary_vertex<Kernel>& vertex, const Metric_tensor_2& t) : Boundary_vertex<Kernel>(vertex), tensor(t) {}
};

// Twice the area of a loop in the domain; positive if it runs counterclockwise.
template <class Kernel>
double signed_area(const std::vector<Region_node<Kernel>>& loop)
{
  double sum = 0;
  for(std::size_t i = 0; i < loop.size(); ++i) {
    const auto p = loop[i].domain_point - loop[0].domain_point, q = loop[(i + 1) % loop.size()].domain_point - loop[0].domain_point;
    sum += p.x() * q.y() - p.y() * q.x();
  }
  return sum;
}

// A patch, or what cuts have left of it: its boundary, the domain to the left, outer loop first; and the cells of the sketch.
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

// A place on the boundary of a region.
struct Region_place
{
  std::size_t loop, number;
};

// Polylines through a region, each from one place on its boundary to another; both ends included.
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

// Tells whether points are inside a loop, roughly: on the loop itself either answer is possible.
template <class Kernel>
class Loop_inside
{
  typedef typename Kernel::Point_2 Point_2;

  static const int number_of_slices = 256;

  const std::vector<Region_node<Kernel>>& m_loop;
  double m_first, m_width; // of the slices by the second coordinate
  std::vector<std::vector<std::size_t>> m_edges; // that meet each slice

public:
  explicit Loop_inside(const std::vector<Region_node<Kernel>>& loop) : m_loop(loop), m_edges(number_of_slices)
  {
    const auto ends = std::minmax_element(loop.begin(), loop.end(), [](const auto& a, const auto& b) { return a.domain_point.y() < b.domain_point.y(); });
    m_first = ends.first->domain_point.y();
    m_width = (ends.second->domain_point.y() - m_first) / number_of_slices;
    for(std::size_t i = 0; i < loop.size(); ++i) {
      const auto slices = std::minmax({slice(loop[i].domain_point), slice(target(i))});
      for(std::size_t k = slices.first; k <= slices.second; ++k)
        m_edges[k].push_back(i);
    }
  }

  bool operator()(const Point_2& p) const
  {
    bool result = false;
    for(std::size_t i : m_edges[slice(p)]) {
      const Point_2 &a = m_loop[i].domain_point, &b = target(i);
      if((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
        result = !result;
    }
    return result;
  }

private:
  const Point_2& target(std::size_t i) const { return m_loop[i + 1 < m_loop.size() ? i + 1 : 0].domain_point; }

  std::size_t slice(const Point_2& p) const
  {
    return std::size_t((std::min)((std::max)((p.y() - m_first) / m_width, 0.), number_of_slices - 1.));
  }
};

/*
Takes a region apart at a cut: the edges of its boundary and both directions of the cut's are run through with the nearest
edge to the left next, and the loops that arise that way bound the parts.
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
  std::vector<std::vector<std::size_t>> m_targets; // of the edges from each node

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
        result.back().loops.reserve(1 + m_region.loops.size()); // they stay where they are
        result.back().loops.push_back(std::move(loop));
      }
      else
        holes.push_back(std::move(loop));
    std::vector<Loop_inside<Kernel>> is_inside;
    for(const Region& part : result)
      is_inside.emplace_back(part.loops.front());
    const auto part_with = [&](const Point_2& p) -> Region& { // if none is found, it is the last one
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

  // of the edges from `here`, for who comes from `before`: the first clockwise from where that is
  std::size_t leftmost(std::size_t before, std::size_t here) const
  {
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

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_REGION_H
