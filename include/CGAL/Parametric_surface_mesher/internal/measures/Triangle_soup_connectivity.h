// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_TRIANGLE_SOUP_CONNECTIVITY_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_TRIANGLE_SOUP_CONNECTIVITY_H

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The connectivity of triangles that need not form a surface mesh. Their corners are joined to fans across every edge of exactly two
// triangles. Corner `i` of triangle `t` has the index `3t+i`.
class Triangle_soup_connectivity
{
  struct Edge_use
  {
    std::size_t source, target; // points, in increasing order
    std::size_t source_corner, target_corner;

    friend bool operator<(const Edge_use& a, const Edge_use& b)
    {
      return std::tie(a.source, a.target, a.source_corner) < std::tie(b.source, b.target, b.source_corner);
    }
    bool is_same_edge(const Edge_use& other) const { return source == other.source && target == other.target; }
  };
  typedef std::vector<Edge_use>::const_iterator Edge_use_iterator;
  typedef boost::disjoint_sets_with_storage<> Partition;

  std::vector<std::size_t> m_points; // by corner
  std::vector<Edge_use> m_uses;
  Partition m_fans, m_components;

public:
  // `points` has the three points of each triangle, one triangle after the other.
  explicit Triangle_soup_connectivity(const std::vector<std::size_t>& points)
    : m_points(points), m_fans(points.size()), m_components(points.size() / 3)
  {
    for(std::size_t corner = 0; corner < points.size(); ++corner)
      add_edge_use(corner, corner % 3 == 2 ? corner - 2 : corner + 1);
    std::sort(m_uses.begin(), m_uses.end());
  }

  // Calls `visit(source, target)` for each edge and adds the numbers about connectivity to `quality`,
  // a `Triangle_mesh_quality` with its number of vertices.
  template <class Quality, class Visitor>
  void measure(Quality& quality, const Visitor& visit)
  {
    std::vector<Edge_use> border;
    for(Edge_use_iterator first = m_uses.begin(), last; first != m_uses.end(); first = last)
    {
      last = std::find_if(first, m_uses.cend(), [first](const Edge_use& e) { return !e.is_same_edge(*first); });
      visit(first->source, first->target);
      unite_across(first, last);
      if(last - first == 1)
        border.push_back(*first);
      else if(last - first > 2)
        ++quality.number_of_non_manifold_edges;
    }
    quality.number_of_border_edges = border.size();
    count_fans(quality);
    quality.number_of_boundary_cycles = number_of_chains(border);
    for(std::size_t t = 0; t < m_points.size() / 3; ++t)
      quality.number_of_connected_components += m_components.find_set(t) == t;
  }

private:
  void add_edge_use(std::size_t a, std::size_t b)
  {
    if(m_points[a] == m_points[b]) // a triangle with a repeated point
      return;
    if(m_points[a] > m_points[b])
      std::swap(a, b);
    m_uses.push_back({m_points[a], m_points[b], a, b});
  }

  void unite_across(Edge_use_iterator first, Edge_use_iterator last)
  {
    for(Edge_use_iterator use = first + 1; use < last; ++use)
      m_components.union_set(first->source_corner / 3, use->source_corner / 3);
    if(last - first != 2)
      return;
    const Edge_use_iterator second = first + 1;
    m_fans.union_set(first->source_corner, second->source_corner);
    m_fans.union_set(first->target_corner, second->target_corner);
  }

  template <class Quality>
  void count_fans(Quality& quality)
  {
    std::vector<std::size_t> fans(quality.number_of_vertices, 0);
    for(std::size_t corner = 0; corner < m_points.size(); ++corner)
      fans[m_points[corner]] += m_fans.find_set(corner) == corner;
    for(std::size_t number : fans)
    {
      quality.number_of_isolated_vertices += number == 0;
      quality.number_of_non_manifold_vertices += number > 1;
    }
  }

  // The number of chains that `border` forms; two edges are joined by the fan between them.
  std::size_t number_of_chains(const std::vector<Edge_use>& border)
  {
    Partition chains(m_points.size());
    for(const Edge_use& edge : border)
      chains.union_set(m_fans.find_set(edge.source_corner), m_fans.find_set(edge.target_corner));
    std::set<std::size_t> roots;
    for(const Edge_use& edge : border)
      roots.insert(chains.find_set(m_fans.find_set(edge.source_corner)));
    return roots.size();
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_TRIANGLE_SOUP_CONNECTIVITY_H
