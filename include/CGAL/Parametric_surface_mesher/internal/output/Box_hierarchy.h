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
    for(int i = 0; i < 3; ++i) {
      lower[i] = (std::min)(lower[i], rounded_down(p[i]));
      upper[i] = (std::max)(upper[i], -rounded_down(-p[i]));
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

  int longest_axis() const
  {
    int result = 0;
    for(int i = 1; i < 3; ++i)
      if(upper[i] - lower[i] > upper[result] - lower[result])
        result = i;
    return result;
  }

private:
  static float rounded_down(double c)
  {
    const float result = float(c);
    return double(result) > c ? std::nextafter(result, -(std::numeric_limits<float>::infinity)()) : result;
  }
};

// A tree of boxes that finds all pairs of them which overlap. Nodes are halved when they are first looked into, so that boxes which are
// far from all others cost little. CGAL's `box_self_intersection_d()` looks at all boxes, which takes twice as long and more on CAD models.
class Box_hierarchy
{
  typedef std::uint32_t Index;

  static constexpr Index size_of_leaf = 4;

  struct Node
  {
    Small_box box;
    Index begin, end; // of its boxes in the order
    Index left;       // the index of its left child, before that of the right one; 0 if it is not halved
  };

  typedef std::vector<std::pair<Index, Index>> Pairs; // of nodes

  std::vector<Small_box> m_boxes;
  mutable std::vector<Index> m_order;
  mutable std::vector<Node> m_nodes;

public:
  explicit Box_hierarchy(std::vector<Small_box> boxes) : m_boxes(std::move(boxes)), m_order(m_boxes.size())
  {
    std::iota(m_order.begin(), m_order.end(), Index(0));
    append_node(0, Index(m_boxes.size()));
  }

  // The box of all boxes.
  const Small_box& box() const { return m_nodes.front().box; }

  // Calls `function` once with the indices of each two boxes that overlap.
  template <class Function>
  void for_each_overlapping_pair(const Function& function) const
  {
    visit_pairs(*this, function);
  }

  // Calls `function` with the indices of each box and a box of another hierarchy that overlap.
  template <class Function>
  void for_each_overlapping_pair(const Box_hierarchy& other, const Function& function) const
  {
    visit_pairs(other, function);
  }

private:
  void append_node(Index begin, Index end) const
  {
    Small_box box;
    for(Index i = begin; i != end; ++i)
      box.add(m_boxes[m_order[i]]);
    m_nodes.push_back({box, begin, end, 0});
  }

  // Halves a node, if it has not been, at the median of the centers along the longest axis of its box.
  // \pre it is no leaf
  Index left(Index node) const
  {
    if(m_nodes[node].left == 0) {
      const Index begin = m_nodes[node].begin, end = m_nodes[node].end, middle = begin + (end - begin) / 2;
      const int axis = m_nodes[node].box.longest_axis();
      std::nth_element(m_order.begin() + begin, m_order.begin() + middle, m_order.begin() + end, [&](Index a, Index b) {
        return std::make_pair(m_boxes[a].center(axis), a) < std::make_pair(m_boxes[b].center(axis), b);
      });
      m_nodes[node].left = Index(m_nodes.size());
      append_node(begin, middle);
      append_node(middle, end);
    }
    return m_nodes[node].left;
  }

  Index size(Index node) const { return m_nodes[node].end - m_nodes[node].begin; }

  template <class Function>
  void visit_pairs(const Box_hierarchy& other, const Function& function) const
  {
    Pairs pairs;
    add_pair(0, other, 0, pairs);
    while(!pairs.empty()) {
      const auto pair = pairs.back();
      pairs.pop_back();
      visit(pair.first, other, pair.second, pairs, function);
    }
  }

  void add_pair(Index node, const Box_hierarchy& other, Index other_node, Pairs& pairs) const
  {
    if(m_nodes[node].box.overlaps(other.m_nodes[other_node].box))
      pairs.emplace_back(node, other_node);
  }

  template <class Function>
  void visit(Index a, const Box_hierarchy& other, Index b, Pairs& pairs, const Function& function) const
  {
    if(size(a) <= size_of_leaf && other.size(b) <= size_of_leaf)
      compare(m_nodes[a], other, other.m_nodes[b], function);
    else if(this == &other && a == b) {
      const Index child = left(a);
      pairs.emplace_back(child, child);
      pairs.emplace_back(child + 1, child + 1);
      add_pair(child, other, child + 1, pairs);
    }
    else if(size(a) >= other.size(b)) {
      const Index child = left(a);
      add_pair(child, other, b, pairs);
      add_pair(child + 1, other, b, pairs);
    }
    else {
      const Index child = other.left(b);
      add_pair(a, other, child, pairs);
      add_pair(a, other, child + 1, pairs);
    }
  }

  template <class Function>
  void compare(const Node& m, const Box_hierarchy& other, const Node& n, const Function& function) const
  {
    for(Index i = m.begin; i != m.end; ++i)
      for(Index k = &m == &n ? i + 1 : n.begin; k != n.end; ++k)
        if(m_boxes[m_order[i]].overlaps(other.m_boxes[other.m_order[k]]))
          function(std::size_t(m_order[i]), std::size_t(other.m_order[k]));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_BOX_HIERARCHY_H
