// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVIDE_DOMAIN_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVIDE_DOMAIN_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Parametric_domain_2.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/Boundary_loops.h>
#include <CGAL/Parametric_surface_mesher/internal/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/Boundary_size.h>
#include <CGAL/divide_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The largest coordinate of a domain, by the end points of its curves: gaps are measured against it.
template <class Kernel>
double extent(const Parametric_domain_2<Kernel>& domain)
{
  double result = 0;
  for(const auto& loop : domain.loops())
    for(const auto& curve : loop)
      result = (std::max)({result, std::fabs(curve.source().x()), std::fabs(curve.source().y())});
  return result;
}

// Refuses loops whose curves do not join, and joins those that do exactly.
template <class Kernel>
void close_loops(Parametric_domain_2<Kernel>& domain)
{
  const double tolerance = 1e-9 * extent(domain);
  for(std::size_t l = 0; l < domain.loops().size(); ++l) {
    auto& loop = domain.loops()[l];
    if(loop.empty())
      throw Parametric_surface_mesh_error("loop " + std::to_string(l) + " has no curve");
    for(std::size_t i = 0; i < loop.size(); ++i) {
      auto &curve = loop[i], &next = loop[(i + 1) % loop.size()];
      const double gap = std::sqrt(squared_distance(curve.target(), next.source()));
      if(!(gap <= tolerance))
        throw Parametric_surface_mesh_error("loop " + std::to_string(l) + " is open: curve " + std::to_string(i)
                                            + " ends at (u,v) = " + describe(curve.target()) + ", the next one starts at "
                                            + describe(next.source()));
      curve.set_end_points(curve.source(), next.source());
    }
    const Bbox_2 box = loop_box(loop, [](const auto& curve) -> const auto& { return curve; });
    if(box.xmin() == box.xmax() && box.ymin() == box.ymax())
      throw Parametric_surface_mesh_error("loop " + std::to_string(l) + " has area zero: all of it is at (u,v) = "
                                          + describe(loop.front().source()));
  }
}

// The box around the image of a curve, at some points of it.
template <class Surface>
Bbox_3 curve_box(const Surface& surface, const Domain_curve_2<typename Surface::Geom_traits>& curve)
{
  Bbox_3 box;
  const Curve_on_surface_3<Surface> curve_on_surface(surface, curve);
  for(int i = 0; i <= 8; ++i)
    box += curve_on_surface.point(curve.begin() + (curve.end() - curve.begin()) * i / 8).bbox();
  return box;
}

inline double diagonal(const Bbox_3& box)
{
  return std::sqrt(square(box.x_span()) + square(box.y_span()) + square(box.z_span()));
}

template <class Surface>
double boundary_diagonal(const Surface& surface, const Parametric_domain_2<typename Surface::Geom_traits>& domain)
{
  Bbox_3 box;
  for(const auto& loop : domain.loops())
    for(const auto& curve : loop)
      box += curve_box(surface, curve);
  return diagonal(box);
}

// Fills in the sizes that the user left open.
inline void set_default_sizes(Parametric_surface_mesh_criteria& criteria, double diagonal)
{
  if(!(diagonal > 0) || !std::isfinite(diagonal))
    throw Parametric_surface_mesh_error("the surface is degenerate: its boundary is a point in space");
  if(!(criteria.max_edge() > 0))
    criteria.set_max_edge(diagonal / 20);
  if(!(criteria.min_edge() > 0))
    criteria.set_min_edge((std::min)(criteria.max_edge(), diagonal / 20) / 100);
  if(criteria.min_edge() > criteria.max_edge())
    throw Parametric_surface_mesh_error("the minimum edge length " + describe(criteria.min_edge())
                                        + " is larger than the maximum edge length " + describe(criteria.max_edge()));
}

// The side that closes a loop can be collapsed too: then the last point of the loop is its first one in space. `index` is
// the next free one; it is that of the last point if this is so.
template <class Kernel>
void merge_last_with_first(std::vector<Boundary_vertex<Kernel>>& loop, std::size_t index)
{
  for(std::size_t i = loop.size(); i > 0 && loop[i - 1].index == index; --i)
    loop[i - 1].index = loop.front().index;
}

// Whether a curve is a point in space.
template <class Surface>
bool is_collapsed(const Surface& surface, const Domain_curve_2<typename Surface::Geom_traits>& curve,
                  double boundary_diagonal)
{
  return diagonal(curve_box(surface, curve)) <= 1e-9 * boundary_diagonal;
}

// The images of the collapsed sides of a domain.
template <class Surface>
std::vector<typename Surface::Geom_traits::Point_3>
singular_points(const Surface& surface, const Parametric_domain_2<typename Surface::Geom_traits>& domain,
                double boundary_diagonal)
{
  std::vector<typename Surface::Geom_traits::Point_3> result;
  for(const auto& loop : domain.loops())
    for(const auto& curve : loop)
      if(is_collapsed(surface, curve, boundary_diagonal))
        result.push_back(surface.point(curve.source().x(), curve.source().y()));
  return result;
}

// Divides all boundary curves of a domain. The points get the indices 0, 1, 2, ... in the order of loops and curves.
template <class Oracle>
Boundary_loops<typename Oracle::Geom_traits>
divide_domain(const Oracle& oracle, const Parametric_domain_2<typename Oracle::Geom_traits>& domain,
              double boundary_diagonal, const Parametric_surface_mesh_criteria& criteria)
{
  typedef Curve_on_surface_3<typename Oracle::Surface> Curve_on_surface;
  const auto identity = [](const auto& curve) -> const auto& { return curve; };
  const Boundary_size<Oracle> size(oracle, criteria, domain_box(domain.loops(), identity));
  Boundary_loops<typename Oracle::Geom_traits> result;
  std::size_t index = 0;
  for(const auto& loop : domain.loops()) {
    const bool is_outer = result.empty();
    double double_area = 0;
    for(const auto& curve : loop)
      double_area += double_area_seen_from(loop.front().source(), curve);
    const bool is_domain_left = (double_area > 0) == is_outer;
    const std::size_t min_number_of_edges = loop.size() == 1 ? 3 : loop.size() == 2 ? 2 : 1;
    result.emplace_back();
    for(const auto& curve : loop) {
      const Curve_on_surface curve_on_surface(oracle.surface(), curve);
      const bool is_point = is_collapsed(oracle.surface(), curve, boundary_diagonal);
      const std::vector<double> parameters
        = is_point ? std::vector<double>{curve.begin(), curve.end()}
                   : divide_curve(curve_on_surface, criteria, [&](double t) { return size(curve, t, is_domain_left); },
                                  min_number_of_edges, curve.number_of_edges());
      // the last point is the first one of the next curve
      for(std::size_t i = 0; i + 1 < parameters.size(); ++i)
        result.back().push_back({curve.point(parameters[i]), curve_on_surface.point(parameters[i]), index++});
      if(is_point) // both ends are one point in space
        --index;
    }
    merge_last_with_first(result.back(), index);
  }
  return result;
}

// Puts the boundary vertices into the mesh; returns the number of edges between different ones.
template <class Kernel>
std::size_t append_boundary(const Boundary_loops<Kernel>& loops, Indexed_mesh<Kernel>& mesh)
{
  std::size_t number_of_edges = 0;
  for(const auto& loop : loops)
    for(std::size_t i = 0; i < loop.size(); ++i) {
      if(loop[i].index == mesh.points.size()) {
        mesh.points.push_back(loop[i].surface_point);
        mesh.domain_points.push_back(loop[i].domain_point);
      }
      number_of_edges += loop[i].index != loop[(i + 1) % loop.size()].index;
    }
  return number_of_edges;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVIDE_DOMAIN_H
