// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_DISTANCES_3_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_DISTANCES_3_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Piece_tree_3.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>

#include <CGAL/number_utils.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Distances are no decisions: rounding does them no harm, and exact predicates would take several times as long.
typedef Simple_cartesian<double> Distance_kernel;

template <class Point>
Distance_kernel::Point_3 distance_point(const Point& p)
{
  return Distance_kernel::Point_3(p.x(), p.y(), p.z());
}

// 0 inside.
struct Distance_from_box_3
{
  Bbox_3 box;

  double operator()(const Distance_kernel::Point_3& p) const
  {
    double squared = 0;
    for(int i = 0; i < 3; ++i)
      squared += square((std::max)({0., box.min_coord(i) - p[i], p[i] - box.max_coord(i)}));
    return std::sqrt(squared);
  }
};

// 0 inside.
struct Distance_from_ball_3
{
  Distance_kernel::Point_3 center;
  double radius;

  double operator()(const Distance_kernel::Point_3& p) const
  {
    return (std::max)(0., std::sqrt(squared_distance(p, center)) - radius);
  }
};

// A cylinder with flat ends; 0 inside.
class Distance_from_cylinder_3
{
  Distance_kernel::Point_3 m_source;
  Distance_kernel::Vector_3 m_direction; // of length 1
  double m_height, m_radius;

public:
  Distance_from_cylinder_3(const Distance_kernel::Point_3& source, const Distance_kernel::Point_3& target, double radius)
    : m_source(source), m_height(std::sqrt(squared_distance(source, target))), m_radius(radius)
  {
    m_direction = (target - source) / m_height;
  }

  double operator()(const Distance_kernel::Point_3& p) const
  {
    const Distance_kernel::Vector_3 d = p - m_source;
    const double height = d * m_direction, across = std::sqrt((d - height * m_direction).squared_length());
    return std::hypot((std::max)({0., -height, height - m_height}), (std::max)(0., across - m_radius));
  }
};

// Copies share the tree, which no query changes: it is whole once this is made.
class Distance_from_points_3
{
  typedef Search_traits_3<Distance_kernel> Traits;
  typedef Orthogonal_k_neighbor_search<Traits> Search;

  std::shared_ptr<typename Search::Tree> m_tree;

public:
  explicit Distance_from_points_3(const std::vector<Distance_kernel::Point_3>& points)
    : m_tree(std::make_shared<typename Search::Tree>(points.begin(), points.end()))
  {
    m_tree->build();
  }

  double operator()(const Distance_kernel::Point_3& p) const { return std::sqrt(Search(*m_tree, p, 1).begin()->second); }
};

// From segments or triangles. Copies share the tree, which no query changes: it is whole once this is made.
template <class Piece>
class Distance_from_pieces_3
{
  typedef Piece_tree_3<Distance_kernel, Piece> Tree;

  std::shared_ptr<Tree> m_tree;

public:
  explicit Distance_from_pieces_3(const std::vector<Piece>& pieces) : m_tree(std::make_shared<Tree>())
  {
    add_pieces(pieces, *m_tree);
    m_tree->build();
    m_tree->accelerate_distance_queries();
  }

  double operator()(const Distance_kernel::Point_3& p) const { return std::sqrt(m_tree->squared_distance(p)); }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_DISTANCES_3_H
