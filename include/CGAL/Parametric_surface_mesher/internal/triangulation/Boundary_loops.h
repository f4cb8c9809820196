// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_BOUNDARY_LOOPS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_BOUNDARY_LOOPS_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A point of the boundary division: in the domain, in space, and by its index in the mesh. The points of a collapsed side are
// different points of the domain with the same index.
template <class Kernel>
struct Boundary_vertex
{
  typename Kernel::Point_2 domain_point;
  typename Kernel::Point_3 surface_point;
  std::size_t index;
};

// The divided boundary of a patch, outer loop first. After the loops around the domain come those inside it, which the mesh follows on
// both sides: see `lies_inside()`.
template <class Kernel>
using Boundary_loops = std::vector<std::vector<Boundary_vertex<Kernel>>>;

template <class Kernel>
bool are_one(const Boundary_vertex<Kernel>& v, const Boundary_vertex<Kernel>& w)
{
  return v.index == w.index && v.domain_point == w.domain_point;
}

// Whether a loop is a single point inside the patch: there and back.
template <class Kernel>
bool is_single_point(const std::vector<Boundary_vertex<Kernel>>& loop)
{
  return loop.size() == 2 && are_one(loop[0], loop[1]);
}

// Whether a loop has the domain on both sides: it runs along an edge inside the patch, which has two pieces at least, and back
// again through the same points, or is a single point. Its segments are constraints, but not on the border of the domain. This is
// the one place that tells which these are.
template <class Kernel>
bool lies_inside(const std::vector<Boundary_vertex<Kernel>>& loop)
{
  const std::size_t n = loop.size();
  if(n < 4 || n % 2 != 0)
    return is_single_point(loop);
  for(std::size_t i = 1; i < n; ++i)
    if(!are_one(loop[i], loop[n - i]))
      return false;
  return true;
}

// Whether segment `i` of a loop in the domain is a collapsed side of the patch.
template <class Kernel>
bool is_collapsed_side(const std::vector<Boundary_vertex<Kernel>>& loop, std::size_t i)
{
  const Boundary_vertex<Kernel>&v = loop[i], &w = loop[(i + 1) % loop.size()];
  return v.index == w.index && v.domain_point != w.domain_point;
}

template <class Kernel>
Bbox_2 box_of_loops(const Boundary_loops<Kernel>& loops)
{
  Bbox_2 box;
  for(const auto& loop : loops)
    for(const Boundary_vertex<Kernel>& vertex : loop)
      box += vertex.domain_point.bbox();
  return box;
}

template <class Kernel>
std::size_t number_of_vertices(const Boundary_loops<Kernel>& loops)
{
  return std::accumulate(loops.begin(), loops.end(), std::size_t(0),
                         [](std::size_t n, const auto& loop) { return n + loop.size(); });
}

// Finds what prevents a division from bounding a domain: loops of fewer than three points, values that are not finite, segments
// of length zero, and segments that meet elsewhere than in a common vertex. All tests are exact and take O(n log n) time.
template <class Kernel>
class Boundary_check
{
public:
  typedef std::pair<std::size_t, std::size_t> Segment_id; // indices of the loop, and of the segment in it
  typedef std::pair<Segment_id, Segment_id> Crossing;

private:
  typedef typename Kernel::Segment_2 Segment_2;
  typedef Box_intersection_d::Box_with_info_d<double, 2, Segment_id> Box;

  const Boundary_loops<Kernel>& m_loops;

public:
  explicit Boundary_check(const Boundary_loops<Kernel>& loops) : m_loops(loops) {}

  // \throws Parametric_surface_mesh_error for loops that are too short, points that are not finite, and segments of length zero
  void check_segments() const
  {
    for(std::size_t l = 0; l < m_loops.size(); ++l) {
      if(m_loops[l].size() < 3 && !is_single_point(m_loops[l]))
        throw Parametric_surface_mesh_error(numbered("loop", l) + " is divided into "
                                            + std::to_string(m_loops[l].size())
                                            + " edges; at least 3 are needed: choose a smaller maximum edge");
      for(std::size_t i = 0; i < m_loops[l].size(); ++i)
        check_segment({l, i});
    }
  }

  // The pairs of segments that cross, overlap or touch, in ascending order.
  std::vector<Crossing> crossings() const
  {
    std::vector<Box> boxes;
    for(std::size_t l = 0; l < m_loops.size(); ++l) {
      const std::size_t way_back = lies_inside(m_loops[l]) ? m_loops[l].size() / 2 : 0;
      for(std::size_t i = 0; i + way_back < m_loops[l].size(); ++i)
        boxes.push_back(Box(segment({l, i}).bbox(), Segment_id(l, i)));
    }
    std::vector<Crossing> result;
    const std::ptrdiff_t cutoff = 500; // so many boxes are compared one by one, which is faster than a segment tree
    box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
      const Crossing pair = std::minmax(a.info(), b.info());
      if(cross(pair.first, pair.second))
        result.push_back(pair);
    }, cutoff);
    std::sort(result.begin(), result.end());
    return result;
  }

  std::string describe_crossing(const Crossing& crossing) const
  {
    const bool is_any_inside = lies_inside(m_loops[crossing.first.first]) || lies_inside(m_loops[crossing.second.first]);
    return (is_any_inside ? "what lies inside the face crosses or touches something: " : "the boundary crosses or touches itself: ")
           + name(crossing.first) + ", and " + name(crossing.second);
  }

private:
  const Boundary_vertex<Kernel>& vertex(std::size_t loop, std::size_t i) const
  {
    return m_loops[loop][i % m_loops[loop].size()];
  }

  Segment_2 segment(const Segment_id& id) const
  {
    return Segment_2(vertex(id.first, id.second).domain_point, vertex(id.first, id.second + 1).domain_point);
  }

  std::string name(const Segment_id& id) const
  {
    if(is_single_point(m_loops[id.first]))
      return "an inner point, " + describe(segment(id).source());
    return numbered("segment", id.second) + " of " + numbered("loop", id.first)
           + (lies_inside(m_loops[id.first]) ? ", an inner edge, " : ", ") + describe(segment(id).source()) + " to "
           + describe(segment(id).target());
  }

  void check_segment(const Segment_id& id) const
  {
    const auto p = segment(id).source();
    const auto& s = vertex(id.first, id.second).surface_point;
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()))
      throw Parametric_surface_mesh_error("the domain point of " + name(id) + " is not finite");
    if(!std::isfinite(s.x()) || !std::isfinite(s.y()) || !std::isfinite(s.z()))
      throw Parametric_surface_mesh_error("the surface is not finite at (u,v) = " + describe(p) + ", at the start of "
                                          + name(id));
    if(segment(id).is_degenerate() && !is_single_point(m_loops[id.first]))
      throw Parametric_surface_mesh_error(name(id) + ", has length zero in the domain");
  }

  // Segments may meet in a common vertex: neighbours on a loop, or segments of loops that touch there.
  bool cross(const Segment_id& a, const Segment_id& b) const
  {
    const Segment_2 s = segment(a), t = segment(b);
    for(std::size_t i : {0, 1})
      for(std::size_t k : {0, 1})
        if(are_one(vertex(a.first, a.second + i), vertex(b.first, b.second + k)))
          return overlap(i == 0 ? s.opposite() : s, k == 0 ? t : t.opposite());
    if(s.is_degenerate() || t.is_degenerate())
      return s.is_degenerate() ? t.has_on(s.source()) : s.has_on(t.source());
    return do_intersect(s, t);
  }

  // Whether two segments that are joined at `s.target()` have other points in common.
  static bool overlap(const Segment_2& s, const Segment_2& t)
  {
    return orientation(s.source(), s.target(), t.target()) == COLLINEAR
           && angle(s.source(), s.target(), t.target()) == ACUTE;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_BOUNDARY_LOOPS_H
