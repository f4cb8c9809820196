// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_MAKE_MODEL_OF_RECTANGULAR_PATCHES_H
#define CGAL_MAKE_MODEL_OF_RECTANGULAR_PATCHES_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/orient_faces.h>
#include <CGAL/Parametric_surface_model_3.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

namespace Parametric_surface_mesher {
namespace internal {

// Finds the boundary curves that rectangular patches have in common.
template <class Surface>
class Patch_matcher
{
  typedef Parametric_surface_model_3<Surface> Model;
  typedef typename Surface::Geom_traits Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Model::Edge_use Edge_use;

  static const int number_of_samples = 9;
  typedef std::array<Point_3, number_of_samples> Samples;

  // a side of a patch, counterclockwise in its domain
  struct Side
  {
    Point_2 from, to;
    Samples samples;
    std::size_t source, target; // vertices
  };

  const std::vector<Surface>& m_surfaces;
  double m_squared_tolerance;
  std::vector<Side> m_sides; // four for each patch
  Model m_model;

public:
  Patch_matcher(const std::vector<Surface>& surfaces, double tolerance)
    : m_surfaces(surfaces), m_squared_tolerance(tolerance * tolerance)
  {}

  Model operator()()
  {
    for(const Surface& surface : m_surfaces)
      append_sides(surface);
    merge_corners();
    std::vector<Edge_use> uses = match_sides();
    for(std::size_t i = 0; i < m_surfaces.size(); ++i)
      m_model.add_face({m_surfaces[i], {{uses.begin() + 4 * i, uses.begin() + 4 * (i + 1)}}});
    orient_faces(m_model);
    return std::move(m_model);
  }

private:
  void append_sides(const Surface& s)
  {
    const std::array<Point_2, 4> corners = {Point_2(s.u_min(), s.v_min()), Point_2(s.u_max(), s.v_min()),
                                            Point_2(s.u_max(), s.v_max()), Point_2(s.u_min(), s.v_max())};
    for(int i = 0; i < 4; ++i) {
      Side side{corners[i], corners[(i + 1) % 4], {}, 0, 0};
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

  // Sweep along x: corners closer than the tolerance become one vertex.
  void merge_corners()
  {
    std::vector<std::size_t> order(m_sides.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
      return std::make_pair(corner(a).x(), a) < std::make_pair(corner(b).x(), b);
    });
    const double tolerance = std::sqrt(m_squared_tolerance);
    for(std::size_t i = 0; i < order.size(); ++i) {
      bool is_new = true;
      for(std::size_t k = i; is_new && k-- > 0 && corner(order[i]).x() - corner(order[k]).x() <= tolerance;)
        if(are_close(corner(order[i]), corner(order[k]))) {
          m_sides[order[i]].source = m_sides[order[k]].source;
          is_new = false;
        }
      if(is_new)
        m_sides[order[i]].source = m_model.add_vertex(corner(order[i]));
    }
    for(std::size_t i = 0; i < m_sides.size(); ++i)
      m_sides[i].target = m_sides[i % 4 == 3 ? i - 3 : i + 1].source;
  }

  const Point_3& corner(std::size_t side) const { return m_sides[side].samples.front(); }

  bool are_equal(const Side& a, const Side& b, bool is_reversed) const
  {
    for(int k = 0; k < number_of_samples; ++k)
      if(!are_close(a.samples[k], b.samples[is_reversed ? number_of_samples - 1 - k : k]))
        return false;
    return true;
  }

  std::vector<Edge_use> match_sides()
  {
    std::vector<Edge_use> uses;
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::pair<std::size_t, std::size_t>>> known; // edge, side
    for(std::size_t i = 0; i < m_sides.size(); ++i) {
      const Side& side = m_sides[i];
      if(is_collapsed(side)) {
        uses.push_back(use(m_model.add_edge(side.source, side.source, true), side, false));
        continue;
      }
      auto& candidates = known[std::minmax(side.source, side.target)];
      bool is_found = false;
      for(const auto& candidate : candidates)
        for(bool is_reversed : {true, false})
          if(!is_found && are_equal(side, m_sides[candidate.second], is_reversed)) {
            uses.push_back(use(candidate.first, side, is_reversed));
            is_found = true;
          }
      if(!is_found) {
        uses.push_back(use(m_model.add_edge(side.source, side.target), side, false));
        candidates.emplace_back(uses.back().edge, i);
      }
    }
    return uses;
  }

  static Edge_use use(std::size_t edge, const Side& side, bool is_reversed)
  {
    typedef Domain_curve_2<Kernel> Curve;
    return {edge, is_reversed,
            is_reversed ? Curve::segment(side.to, side.from) : Curve::segment(side.from, side.to)};
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher

/*!
\ingroup PkgParametricSurfaceMesherModel

makes a model of patches over rectangles, for instance Bezier patches: boundary curves that are equal within `tolerance` become one
edge, and sides that are a point become collapsed edges. Patches are reversed where needed, so that neighbours face
to the same side; the first patch of each connected piece keeps its direction.

Curves match if they are equal at equal parameters (in the same or the opposite direction), compared at nine points; patches that
meet along a part of a side, or with different parametrisations, are not joined.

\param surfaces the patches
\param tolerance how far apart points may be that are to be one. 0 stands for 1e-9 of the diagonal of the bounding box of all corners.
\throws Parametric_surface_mesh_error if three or more patches meet in one curve, or a connected piece is not orientable

Complexity: `O(n log n)` for `n` patches whose corners are spread out in space.

\tparam Surface a model of `ParametricSurface_3` with members `u_min()`, `u_max()`, `v_min()`, `v_max()`
*/
template <class Surface>
Parametric_surface_model_3<Surface> make_model_of_rectangular_patches(const std::vector<Surface>& surfaces,
                                                                      double tolerance = 0)
{
  if(!(tolerance > 0)) {
    Bbox_3 box;
    for(const Surface& s : surfaces)
      for(double u : {s.u_min(), s.u_max()})
        for(double v : {s.v_min(), s.v_max()})
          box += s.point(u, v).bbox();
    tolerance = 1e-9 * std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) + CGAL::square(box.z_span()));
  }
  return Parametric_surface_mesher::internal::Patch_matcher<Surface>(surfaces, tolerance)();
}

} // namespace CGAL

#endif // CGAL_MAKE_MODEL_OF_RECTANGULAR_PATCHES_H
