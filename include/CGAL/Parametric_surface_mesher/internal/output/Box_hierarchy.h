// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_BOX_HIERARCHY_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_BOX_HIERARCHY_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A box with coordinates of 32 bits, rounded outwards.
struct Small_box
{
  std::array<float, 3> lower, upper;

  Small_box()
  {
    lower.fill((std::numeric_limits<float>::infinity)());
    upper.fill(-(std::numeric_limits<float>::infinity)());
  }

  template <class Point>
  void add(const Point& p)
  {
    const float infinity = (std::numeric_limits<float>::infinity)();
    for(int i = 0; i < 3; ++i) {
      const float c = float(p[i]);
      lower[i] = (std::min)(lower[i], double(c) > p[i] ? std::nextafter(c, -infinity) : c);
      upper[i] = (std::max)(upper[i], double(c) < p[i] ? std::nextafter(c, infinity) : c);
    }
  }

  void add(const Small_box& other)
  {
    for(int i = 0; i < 3; ++i) {
      lower[i] = (std::min)(lower[i], other.lower[i]);
      upper[i] = (std::max)(upper[i], other.upper[i]);
    }
  }

  bool overlaps(const Small_box& other) const
  {
    return lower[0] <= other.upper[0] && other.lower[0] <= upper[0] && lower[1] <= other.upper[1] && other.lower[1] <= upper[1]
           && lower[2] <= other.upper[2] && other.lower[2] <= upper[2];
  }

  float center(int axis) const { return 0.5f * (lower[axis] + upper[axis]); }
};

// A tree of boxes that finds all pairs of them which overlap. Unlike `box_self_intersection_d()` it takes about 40 bytes a box, and
// the order of boxes that is close to that in space is made use of.
class Box_hierarchy
{
  typedef std::uint32_t Index;

  static constexpr Index size_of_leaf = 4;

  struct Node
  {
    Small_box box;
    Index begin, end;    // of its boxes in the order
    Index right;         // the index of its right child, after which come all below the left one; 0 for a leaf
  };

  const std::vector<Small_box>& m_boxes;
  std::vector<Index> m_order;
  std::vector<Node> m_nodes;

public:
  explicit Box_hierarchy(const std::vector<Small_box>& boxes) : m_boxes(boxes), m_order(boxes.size())
  {
    std::iota(m_order.begin(), m_order.end(), Index(0));
    if(!boxes.empty())
      build(0, Index(boxes.size()));
  }

  // Calls `function` once with the indices of each two boxes that overlap.
  template <class Function>
  void for_each_overlapping_pair(const Function& function) const
  {
    std::vector<std::pair<Index, Index>> pairs; // of nodes
    if(!m_nodes.empty())
      pairs.emplace_back(0, 0);
    while(!pairs.empty()) {
      const auto pair = pairs.back();
      pairs.pop_back();
      visit(pair.first, pair.second, pairs, function);
    }
  }

private:
  // Halves the boxes at the median of their centers along the longest axis.
  Index build(Index begin, Index end)
  {
    const Index node = Index(m_nodes.size());
    m_nodes.push_back({Small_box(), begin, end, 0});
    Small_box box;
    for(Index i = begin; i != end; ++i)
      box.add(m_boxes[m_order[i]]);
    m_nodes[node].box = box;
    if(end - begin > size_of_leaf) {
      int axis = 0;
      for(int i = 1; i < 3; ++i)
        if(box.upper[i] - box.lower[i] > box.upper[axis] - box.lower[axis])
          axis = i;
      const Index middle = begin + (end - begin) / 2;
      std::nth_element(m_order.begin() + begin, m_order.begin() + middle, m_order.begin() + end, [&](Index a, Index b) {
        return std::make_pair(m_boxes[a].center(axis), a) < std::make_pair(m_boxes[b].center(axis), b);
      });
      build(begin, middle);
      const Index right = build(middle, end);
      m_nodes[node].right = right;
    }
    return node;
  }

  template <class Function>
  void visit(Index a, Index b, std::vector<std::pair<Index, Index>>& pairs, const Function& function) const
  {
    const Node &m = m_nodes[a], &n = m_nodes[b];
    const auto add = [&](Index i, Index k) {
      if(i == k || m_nodes[i].box.overlaps(m_nodes[k].box))
        pairs.emplace_back(i, k);
    };
    if(a == b && m.right != 0) {
      add(a + 1, a + 1);
      add(m.right, m.right);
      add(a + 1, m.right);
    }
    else if(m.right != 0 && (n.right == 0 || m.end - m.begin >= n.end - n.begin)) {
      add(a + 1, b);
      add(m.right, b);
    }
    else if(n.right != 0) {
      add(a, b + 1);
      add(a, n.right);
    }
    else
      compare(m, n, a == b, function);
  }

  template <class Function>
  void compare(const Node& m, const Node& n, bool are_same, const Function& function) const
  {
    for(Index i = m.begin; i != m.end; ++i)
      for(Index k = are_same ? i + 1 : n.begin; k != n.end; ++k)
        if(m_boxes[m_order[i]].overlaps(m_boxes[m_order[k]]))
          function(std::size_t(m_order[i]), std::size_t(m_order[k]));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_BOX_HIERARCHY_H
