// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_BALANCED_CELLS_2_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_BALANCED_CELLS_2_H

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Cells of the plane with similar weights, made of given weighted points: a k-d tree that is halved at the weighted median along the
longer side of the box of its points. Cells with close indices are close to each other. Before divide() there is one cell.

CGAL's spatial_sort() would give groups of the given points, but not the cell of a point that is added later, and knows no
weights.
*/
template <class Point_2>
class Balanced_cells_2
{
public:
  struct Weighted_point
  {
    Point_2 point;
    double weight;
  };

private:
  typedef typename std::vector<Weighted_point>::iterator Iterator;

  // Points with a coordinate below `value` belong to child 2 i + 1 of node i, all others to child 2 i + 2. Children without a
  // split are cells.
  struct Split
  {
    int coordinate = 0;
    double value = std::numeric_limits<double>::infinity();
  };
  std::vector<Split> m_splits;

public:
  // Makes a number of cells that is a power of two, such that their mean weight is at most `weight_of_cell`. Takes O(n log^2 n)
  // time for n points.
  void divide(std::vector<Weighted_point> points, double weight_of_cell)
  {
    double weight = 0;
    for(const Weighted_point& p : points)
      weight += p.weight;
    std::size_t number_of_cells = 1;
    while(double(number_of_cells) * weight_of_cell < weight)
      number_of_cells *= 2;
    m_splits.assign(number_of_cells - 1, Split());
    split(points.begin(), points.end(), 0);
  }

  std::size_t size() const { return m_splits.size() + 1; }

  // the number of the cell of a point
  std::size_t operator()(const Point_2& p) const
  {
    std::size_t node = 0;
    while(node < m_splits.size())
      node = 2 * node + (p[m_splits[node].coordinate] < m_splits[node].value ? 1 : 2);
    return node - m_splits.size();
  }

private:
  void split(Iterator begin, Iterator end, std::size_t node)
  {
    if(node >= m_splits.size() || begin == end)
      return;
    Bbox_2 box;
    for(Iterator p = begin; p != end; ++p)
      box += p->point.bbox();
    const int coordinate = box.y_span() > box.x_span() ? 1 : 0;
    std::sort(begin, end, [=](const Weighted_point& p, const Weighted_point& q) {
      return p.point[coordinate] < q.point[coordinate];
    });
    const Iterator median = weighted_median(begin, end);
    m_splits[node] = {coordinate, median->point[coordinate]};
    split(begin, median, 2 * node + 1);
    split(median, end, 2 * node + 2);
  }

  // \pre there is a point
  static Iterator weighted_median(Iterator begin, Iterator end)
  {
    double above = 0, below = 0;
    for(Iterator p = begin; p != end; ++p)
      above += p->weight;
    Iterator median = begin;
    for(; median + 1 != end && below + median->weight <= above - median->weight; ++median) {
      below += median->weight;
      above -= median->weight;
    }
    return median;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_BALANCED_CELLS_2_H
