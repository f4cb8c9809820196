// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_CURVED_ELEMENTS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_CURVED_ELEMENTS_H

#include <CGAL/Parametric_surface_mesher/internal/second_order/Quadratic_triangle_3.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Scaled_jacobian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The triangles of a mesh with curved sides, which neighbours share. A triangle that is squeezed too much is made better by curving
// its sides less: their nodes move, by quarters, towards the middles of the straight sides. A straight triangle is not
// squeezed at all, and nodes never move back, so this ends.
template <class Kernel>
class Curved_elements
{
public:
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;

  struct Side
  {
    Point_3 straight, curved; // its node, if it is straight and if it is curved
    int quarters = 4;         // how much it is curved

    bool is_curved_less() const { return quarters < 4; }

    Point_3 node() const
    {
      return is_curved_less() ? straight + 0.25 * quarters * (curved - straight) : curved;
    }
  };

  struct Element
  {
    std::array<Point_3, 3> corners;
    std::array<std::size_t, 3> sides; // those between corners 0 and 1, 1 and 2, 2 and 0
    Vector_3 facing;                  // the side that it is to face to
  };

private:
  std::vector<Side> m_sides;
  std::vector<Element> m_elements;
  std::vector<std::array<std::size_t, 2>> m_neighbors; // the elements at a side, the first one twice if it is alone
  double m_least;
  std::vector<double> m_jacobians; // of the elements

public:
  // `least`: the scaled Jacobian that elements are to have
  Curved_elements(std::vector<Side> sides, std::vector<Element> elements, double least)
    : m_sides(std::move(sides)), m_elements(std::move(elements)), m_neighbors(m_sides.size()), m_least(least)
  {
    std::vector<bool> is_known(m_sides.size());
    for(std::size_t e = 0; e < m_elements.size(); ++e)
      for(std::size_t s : m_elements[e].sides) {
        m_neighbors[s][1] = e;
        if(!is_known[s])
          m_neighbors[s][0] = e;
        is_known[s] = true;
      }
    for(std::size_t e = 0; e < m_elements.size(); ++e)
      m_jacobians.push_back(jacobian(e));
  }

  const std::vector<Side>& sides() const { return m_sides; }

  // The scaled Jacobian of each element.
  const std::vector<double>& jacobians() const { return m_jacobians; }

  // Curves sides less until no element fails, but those that would fail with straight sides, too.
  void curve_less()
  {
    std::deque<std::size_t> queue;
    for(std::size_t e = 0; e < m_elements.size(); ++e)
      if(fails(e))
        queue.push_back(e);
    for(; !queue.empty(); queue.pop_front())
      if(fails(queue.front()) && is_curved(queue.front()) && straight_jacobian(queue.front()) >= m_least)
        straighten(worst_side(queue.front()), queue);
  }

private:
  bool fails(std::size_t e) const { return !(m_jacobians[e] >= m_least); }

  bool is_curved(std::size_t e) const
  {
    return std::any_of(m_elements[e].sides.begin(), m_elements[e].sides.end(),
                       [this](std::size_t s) { return m_sides[s].quarters > 0; });
  }

  double jacobian(std::size_t e) const
  {
    const Element& element = m_elements[e];
    const auto& p = element.corners;
    const Quadratic_triangle_3<Kernel> triangle(
      {p[0], p[1], p[2], m_sides[element.sides[0]].node(), m_sides[element.sides[1]].node(), m_sides[element.sides[2]].node()});
    return scaled_jacobian(triangle, element.facing);
  }

  double straight_jacobian(std::size_t e)
  {
    std::array<int, 3> kept;
    for(std::size_t i = 0; i < 3; ++i)
      kept[i] = std::exchange(m_sides[m_elements[e].sides[i]].quarters, 0);
    const double result = jacobian(e);
    for(std::size_t i = 0; i < 3; ++i)
      m_sides[m_elements[e].sides[i]].quarters = kept[i];
    return result;
  }

  // The one that the element gains most from if it is curved less.
  std::size_t worst_side(std::size_t e)
  {
    std::size_t worst = 0;
    double best = 0;
    bool is_found = false;
    for(const std::size_t s : m_elements[e].sides) {
      if(m_sides[s].quarters == 0)
        continue;
      --m_sides[s].quarters;
      const double value = jacobian(e);
      ++m_sides[s].quarters;
      if(!is_found || value > best) {
        worst = s;
        best = value;
        is_found = true;
      }
    }
    return worst;
  }

  // Appends the elements at the side that fail afterwards.
  void straighten(std::size_t side, std::deque<std::size_t>& failing)
  {
    --m_sides[side].quarters;
    const auto [first, second] = m_neighbors[side];
    for(const std::size_t e : {first, second})
      m_jacobians[e] = jacobian(e);
    if(fails(first))
      failing.push_back(first);
    if(second != first && fails(second))
      failing.push_back(second);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_CURVED_ELEMENTS_H
