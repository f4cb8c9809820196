// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_SIZE_SOURCES_3_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_SIZE_SOURCES_3_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Wanted edge lengths at places in space, which grow with the distance from these: the smallest that any place asks for. A tree of
// boxes leaves out the places that are too far away to matter. (CGAL's search trees find the closest place, which need not ask for the
// smallest length.)
template <class Point_3>
class Size_sources_3
{
public:
  struct Source
  {
    Point_3 place;
    double length;
  };

  // How far a length holds, as a multiple of itself, and how fast it grows outside, as a share of the distance: as fast as edges of
  // well shaped triangles may.
  static constexpr double reach = 1.5, growth = 0.3;

private:
  static constexpr std::size_t size_of_leaf = 8;

  struct Node
  {
    Bbox_3 box;
    double length;       // the smallest below it
    std::size_t begin, end, right; // its sources; the index of its right child, after all that is below the left one, 0 for a leaf
  };

  std::vector<Source> m_sources;
  std::vector<Node> m_nodes;

public:
  explicit Size_sources_3(std::vector<Source> sources) : m_sources(std::move(sources))
  {
    if(!m_sources.empty())
      build(0, m_sources.size());
  }

  // The wanted length at a point; infinity if there are no sources.
  double operator()(const Point_3& p) const
  {
    double result = std::numeric_limits<double>::infinity();
    if(!m_nodes.empty())
      descend(0, p, result);
    return result;
  }

private:
  std::size_t build(std::size_t begin, std::size_t end)
  {
    const std::size_t node = m_nodes.size();
    Bbox_3 box;
    double length = m_sources[begin].length;
    for(std::size_t i = begin; i != end; ++i) {
      box += m_sources[i].place.bbox();
      length = (std::min)(length, m_sources[i].length);
    }
    m_nodes.push_back({box, length, begin, end, 0});
    if(end - begin > size_of_leaf) {
      int axis = 0;
      for(int i = 1; i < 3; ++i)
        if(box.max_coord(i) - box.min_coord(i) > box.max_coord(axis) - box.min_coord(axis))
          axis = i;
      const std::size_t middle = begin + (end - begin) / 2;
      std::nth_element(m_sources.begin() + begin, m_sources.begin() + middle, m_sources.begin() + end,
                       [&](const Source& a, const Source& b) { return a.place[axis] < b.place[axis]; });
      build(begin, middle);
      const std::size_t right = build(middle, end);
      m_nodes[node].right = right;
    }
    return node;
  }

  static double length_at(double distance, double length)
  {
    return length + growth * (std::max)(0., distance - reach * length);
  }

  // Not more than any source below a node asks for: the smallest length holds less far than others, but the growth is slow enough for
  // that not to matter.
  static double least_length(const Node& node, const Point_3& p)
  {
    double squared = 0;
    for(int i = 0; i < 3; ++i)
      squared += square((std::max)({0., node.box.min_coord(i) - p[i], p[i] - node.box.max_coord(i)}));
    return length_at(std::sqrt(squared), node.length);
  }

  void descend(std::size_t n, const Point_3& p, double& result) const
  {
    const Node& node = m_nodes[n];
    if(least_length(node, p) >= result)
      return;
    if(node.right != 0) {
      const bool is_left_first = least_length(m_nodes[n + 1], p) <= least_length(m_nodes[node.right], p);
      descend(is_left_first ? n + 1 : node.right, p, result);
      descend(is_left_first ? node.right : n + 1, p, result);
      return;
    }
    for(std::size_t i = node.begin; i != node.end; ++i)
      result = (std::min)(result, length_at(std::sqrt(squared_distance(p, m_sources[i].place)), m_sources[i].length));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_SIZE_SOURCES_3_H
