// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MAKE_MODEL_OF_RECTANGULAR_PATCHES_H
#define CGAL_MAKE_MODEL_OF_RECTANGULAR_PATCHES_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/curves/Equal_arc_curve.h>
#include <CGAL/Parametric_surface_mesher/internal/model/curve_box.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Parametric_surface_mesher/internal/support/group_points.h>
#include <CGAL/Parametric_surface_mesher/internal/support/has_finite_coordinates.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Parametric_surface_mesher/orient_faces.h>

#include <CGAL/Bbox_3.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

namespace Parametric_surface_mesher {
namespace internal {

// The bounding box of nine points of a patch. Its four corners alone may all be the same point. `index`: of the patch, for an error
template <class Surface>
Bbox_3 box_of_patch(const Surface& s, std::size_t index)
{
  Bbox_3 box;
  for(double u : {s.u_min(), 0.5 * (s.u_min() + s.u_max()), s.u_max()})
    for(double v : {s.v_min(), 0.5 * (s.v_min() + s.v_max()), s.v_max()}) {
      const auto p = s.point(u, v);
      if(!has_finite_coordinates(p))
        throw Parametric_surface_mesh_error(numbered("patch", index) + ": the surface is not finite at (u,v) = (" + describe(u) + ", "
                                            + describe(v) + ")");
      box += p.bbox();
    }
  return box;
}

// Finds the boundary curves that rectangular patches share.
template <class Surface>
class Patch_matcher
{
  typedef Parametric_surface_model_3<Surface> Model;
  typedef typename Surface::Geom_traits Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Model::Edge_use Edge_use;
  typedef typename Model::Curve Curve;

  static constexpr int number_of_samples = 9;
  typedef std::array<Point_3, number_of_samples> Samples;

  // A side of a patch, directed counterclockwise in its domain.
  struct Side
  {
    Point_2 from, to;
    Samples samples;
    std::size_t place = 0; // the index of the place in space where it begins
    std::size_t edge = 0;
    bool is_reversed = false, is_collapsed = false;
    std::shared_ptr<const Curve> curve; // the same curve with the parameters of the edge, if these differ
  };

  const std::vector<Surface>& m_surfaces;
  double m_squared_tolerance;
  std::vector<Side> m_sides;              // four for each patch
  std::vector<std::size_t> m_first_sides; // by edge
  Model m_model;

public:
  Patch_matcher(const std::vector<Surface>& surfaces, double tolerance)
    : m_surfaces(surfaces), m_squared_tolerance(tolerance * tolerance)
  {}

  Model operator()()
  {
    for(const Surface& surface : m_surfaces)
      append_sides(surface);
    number_places();
    match_sides();
    add_vertices_and_edges();
    for(std::size_t i = 0; i < m_surfaces.size(); ++i)
      m_model.add_face({m_surfaces[i], {{use(4 * i), use(4 * i + 1), use(4 * i + 2), use(4 * i + 3)}}});
    m_model.set_tolerance((std::max)(2 * std::sqrt(m_squared_tolerance), // both a side and the corner at its end may be off
                                     1e-6 * model_diagonal(m_model)));
    orient_faces(m_model);
    return std::move(m_model);
  }

private:
  void append_sides(const Surface& s)
  {
    const std::array<Point_2, 4> corners = {Point_2(s.u_min(), s.v_min()), Point_2(s.u_max(), s.v_min()),
                                            Point_2(s.u_max(), s.v_max()), Point_2(s.u_min(), s.v_max())};
    for(int i = 0; i < 4; ++i) {
      Side side;
      side.from = corners[i];
      side.to = corners[(i + 1) % 4];
      for(int k = 0; k < number_of_samples; ++k) {
        const double t = double(k) / (number_of_samples - 1);
        side.samples[k] = s.point((1 - t) * side.from.x() + t * side.to.x(), (1 - t) * side.from.y() + t * side.to.y());
      }
      m_sides.push_back(side);
    }
  }

  bool are_close(const Point_3& p, const Point_3& q) const { return squared_distance(p, q) <= m_squared_tolerance; }

  bool is_collapsed(const Side& side) const
  {
    return std::all_of(side.samples.begin(), side.samples.end(),
                       [&](const Point_3& p) { return are_close(p, side.samples.front()); });
  }

  // Finds the places of corners: corners closer than the tolerance are at the same place.
  void number_places()
  {
    std::vector<Point_3> corners;
    for(std::size_t i = 0; i < m_sides.size(); ++i)
      corners.push_back(corner(i));
    const std::vector<std::size_t> places = group_points(corners, std::sqrt(m_squared_tolerance));
    for(std::size_t i = 0; i < m_sides.size(); ++i)
      m_sides[i].place = places[i];
  }

  static std::size_t next_side(std::size_t i) { return i % 4 == 3 ? i - 3 : i + 1; }

  const Point_3& corner(std::size_t side) const { return m_sides[side].samples.front(); }

  bool are_equal(const Side& a, const Side& b, bool is_reversed) const
  {
    for(int k = 0; k < number_of_samples; ++k)
      if(!are_close(a.samples[k], b.samples[is_reversed ? number_of_samples - 1 - k : k]))
        return false;
    return true;
  }

  void match_sides()
  {
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> edges_between; // by the places of their ends
    for(std::size_t i = 0; i < m_sides.size(); ++i) {
      m_sides[i].is_collapsed = is_collapsed(m_sides[i]);
      const std::pair<std::size_t, std::size_t> places = std::minmax(m_sides[i].place, m_sides[next_side(i)].place);
      if(m_sides[i].is_collapsed
         || (!match(i, edges_between[places]) && !match_by_arc_length(i, edges_between[places]))) {
        m_sides[i].edge = m_first_sides.size();
        edges_between[places].push_back(m_sides[i].edge);
        m_first_sides.push_back(i);
      }
    }
  }

  bool match(std::size_t i, const std::vector<std::size_t>& edges)
  {
    Side& side = m_sides[i];
    for(std::size_t edge : edges)
      for(bool is_reversed : {true, false})
        if(are_equal(side, m_sides[m_first_sides[edge]], is_reversed)) {
          side.edge = edge;
          side.is_reversed = is_reversed;
          return true;
        }
    return false;
  }

  // Matches sides that are the same curve with different parametrisations.
  bool match_by_arc_length(std::size_t i, const std::vector<std::size_t>& edges)
  {
    Side& side = m_sides[i];
    for(std::size_t edge : edges) {
      const std::size_t first = m_first_sides[edge];
      for(bool is_reversed : {true, false}) {
        const Equal_arc_curve<Surface> curve(m_surfaces[first / 4], Curve::segment(m_sides[first].from, m_sides[first].to),
                                             m_surfaces[i / 4],
                                             is_reversed ? Curve::segment(side.to, side.from) : Curve::segment(side.from, side.to));
        const double rounding = 1e-8 * curve.length();
        if(curve.is_within(std::sqrt(m_squared_tolerance) + rounding, number_of_samples - 1)) {
          side.edge = edge;
          side.is_reversed = is_reversed;
          side.curve = std::make_shared<Curve>(curve.reparametrized());
          return true;
        }
      }
    }
    return false;
  }

  // Corners are the same vertex if matched sides join them. Pieces that only touch in a point keep separate vertices there.
  void add_vertices_and_edges()
  {
    std::vector<std::size_t> ranks(m_sides.size()), parents(m_sides.size());
    boost::disjoint_sets<std::size_t*, std::size_t*> corners(ranks.data(), parents.data());
    for(std::size_t i = 0; i < m_sides.size(); ++i)
      corners.make_set(i);
    for(std::size_t i = 0; i < m_sides.size(); ++i) {
      const std::size_t first = m_first_sides[m_sides[i].edge];
      corners.union_set(i, m_sides[i].is_reversed ? next_side(first) : first);
      corners.union_set(next_side(i), m_sides[i].is_reversed ? first : next_side(first));
      if(m_sides[i].is_collapsed)
        corners.union_set(i, next_side(i));
    }
    std::map<std::size_t, std::size_t> vertices; // by representative
    for(std::size_t i = 0; i < m_sides.size(); ++i)
      if(vertices.count(corners.find_set(i)) == 0)
        vertices[corners.find_set(i)] = m_model.add_vertex(corner(i));
    for(std::size_t first : m_first_sides)
      m_model.add_edge(vertices[corners.find_set(first)], vertices[corners.find_set(next_side(first))],
                       m_sides[first].is_collapsed);
  }

  Edge_use use(std::size_t i) const
  {
    const Side& side = m_sides[i];
    return {side.edge, side.is_reversed,
            side.curve ? *side.curve : side.is_reversed ? Curve::segment(side.to, side.from) : Curve::segment(side.from, side.to)};
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher

/*!
\ingroup PkgParametricSurfaceMesherModel

makes a model of patches over rectangles, for instance Bezier patches: boundary curves that are equal within `tolerance`
become one edge, and sides that are a point become collapsed edges. Two sides of one patch may match too: it closes on
itself along a seam. Patches are reversed by `Parametric_surface_mesher::orient_faces()`, so that neighbours face to the same side, and
closed pieces outward.

Where three or more patches meet in one curve the mesh is cut: see `Parametric_surface_model_3::Face::shell`.

Curves match if they are equal at equal parameters, or at equal shares of their lengths, in the same or the opposite
direction; they are compared at nine points. Patches that meet along a part of a side are not joined.

\param surfaces the patches
\param tolerance how far apart points may be that are to be one. 0 stands for 1e-9 of the diagonal of the bounding box (of
nine points of each patch).
\throws Parametric_surface_mesh_error if `tolerance` is negative, a patch is not finite at one of these points, or a connected piece is
not orientable

Complexity: `O(n log n)` for `n` patches whose corners are spread out in space.

\tparam Surface a model of `ParametricSurface_3` with members `u_min()`, `u_max()`, `v_min()`, `v_max()`
*/
template <class Surface>
Parametric_surface_model_3<Surface> make_model_of_rectangular_patches(const std::vector<Surface>& surfaces,
                                                                      double tolerance = 0)
{
  if(!(tolerance >= 0))
    throw Parametric_surface_mesh_error("the tolerance of patches must be at least 0, and is "
                                        + Parametric_surface_mesher::internal::describe(tolerance));
  if(tolerance == 0) {
    Bbox_3 box;
    for(std::size_t i = 0; i < surfaces.size(); ++i)
      box += Parametric_surface_mesher::internal::box_of_patch(surfaces[i], i);
    tolerance = 1e-9 * std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) + CGAL::square(box.z_span()));
  }
  return Parametric_surface_mesher::internal::Patch_matcher<Surface>(surfaces, tolerance)();
}

} // namespace CGAL

#endif // CGAL_MAKE_MODEL_OF_RECTANGULAR_PATCHES_H
