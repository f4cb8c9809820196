// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_BOUNDARY_LOOPS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_BOUNDARY_LOOPS_H

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/describe.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/enum.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A point of the boundary division: in the domain, in space, and by its index in the mesh. Points of a collapsed side
// are several in the domain and have the same index.
template <class Kernel>
struct Boundary_vertex
{
  typename Kernel::Point_2 domain_point;
  typename Kernel::Point_3 surface_point;
  std::size_t index;
};

// The divided boundary of a patch, outer loop first.
template <class Kernel>
using Boundary_loops = std::vector<std::vector<Boundary_vertex<Kernel>>>;

// Refuses divisions that do not bound a domain: fewer than three points, values that are not finite, segments of
// length zero or segments that meet elsewhere than at the common point of neighbours. All tests are exact; O(n log n).
template <class Kernel>
class Boundary_check
{
  typedef typename Kernel::Segment_2 Segment_2;
  typedef std::pair<std::size_t, std::size_t> Segment_id; // loop, number in the loop
  typedef Box_intersection_d::Box_with_info_d<double, 2, Segment_id> Box;

  const Boundary_loops<Kernel>& m_loops;

public:
  explicit Boundary_check(const Boundary_loops<Kernel>& loops) : m_loops(loops) {}

  void operator()() const
  {
    for(std::size_t l = 0; l < m_loops.size(); ++l) {
      if(m_loops[l].size() < 3)
        throw Parametric_surface_mesh_error("loop " + std::to_string(l) + " is divided into "
                                            + std::to_string(m_loops[l].size())
                                            + " edges; at least 3 are needed: choose a smaller maximum edge");
      for(std::size_t i = 0; i < m_loops[l].size(); ++i)
        check_segment({l, i});
    }
    check_crossings();
  }

private:
  const typename Kernel::Point_2& point(std::size_t loop, std::size_t i) const
  {
    return m_loops[loop][i % m_loops[loop].size()].domain_point;
  }

  Segment_2 segment(const Segment_id& id) const
  {
    return Segment_2(point(id.first, id.second), point(id.first, id.second + 1));
  }

  std::string name(const Segment_id& id) const
  {
    return "segment " + std::to_string(id.second) + " of loop " + std::to_string(id.first) + ", "
           + describe(segment(id).source()) + " to " + describe(segment(id).target());
  }

  void check_segment(const Segment_id& id) const
  {
    const auto p = segment(id).source();
    const auto& s = m_loops[id.first][id.second].surface_point;
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()))
      throw Parametric_surface_mesh_error("the domain point of " + name(id) + " is not finite");
    if(!std::isfinite(s.x()) || !std::isfinite(s.y()) || !std::isfinite(s.z()))
      throw Parametric_surface_mesh_error("the surface is not finite at (u,v) = " + describe(p) + ", at the start of "
                                          + name(id));
    if(segment(id).is_degenerate())
      throw Parametric_surface_mesh_error(name(id) + ", has length zero in the domain");
  }

  void check_crossings() const
  {
    std::vector<Box> boxes;
    for(std::size_t l = 0; l < m_loops.size(); ++l)
      for(std::size_t i = 0; i < m_loops[l].size(); ++i)
        boxes.push_back(Box(segment({l, i}).bbox(), Segment_id(l, i)));
    bool is_found = false;
    std::pair<Segment_id, Segment_id> first; // smallest crossing pair, as the order of the calls is not fixed
    box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
      const std::pair<Segment_id, Segment_id> pair = std::minmax(a.info(), b.info());
      if((!is_found || pair < first) && cross(pair.first, pair.second)) {
        is_found = true;
        first = pair;
      }
    });
    if(is_found)
      throw Parametric_surface_mesh_error("the boundary crosses or touches itself: " + name(first.first) + ", and "
                                          + name(first.second));
  }

  bool cross(const Segment_id& a, const Segment_id& b) const
  {
    const Segment_2 s = segment(a), t = segment(b);
    const std::size_t n = m_loops[a.first].size();
    if(a.first == b.first && (a.second + 1) % n == b.second)
      return folds_back(s, t);
    if(a.first == b.first && (b.second + 1) % n == a.second)
      return folds_back(t, s);
    return do_intersect(s, t);
  }

  // whether two segments joined at s.target() overlap
  static bool folds_back(const Segment_2& s, const Segment_2& t)
  {
    return orientation(s.source(), s.target(), t.target()) == COLLINEAR
           && angle(s.source(), s.target(), t.target()) == ACUTE;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_BOUNDARY_LOOPS_H
