// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_FOLD_SEARCH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_FOLD_SEARCH_H

#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Origin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Finds folds: two triangles with a common edge that face each other, although the surfaces there do not. They share an edge, and so
// do not count as passing through each other.
template <class Model>
class Fold_search
{
  typedef typename Model::Geom_traits Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;
  typedef Indexed_mesh<Kernel> Mesh;
  typedef Parametric_surface_mesh_report::Fold Fold;
  typedef std::map<std::array<std::size_t, 2>, Fold> Folds; // by patches

  // The normals of folded triangles enclose at least 160 degrees, those of the surfaces there at most 120.
  static constexpr double largest_cosine = -0.94, least_cosine_of_surfaces = -0.5;

  struct Side
  {
    std::size_t part, number; // side `3 f + k` is that from corner `k` of triangle `f`
  };

  const Model& m_model;
  const Mesh& m_mesh;

public:
  Fold_search(const Model& model, const Mesh& mesh) : m_model(model), m_mesh(mesh) {}

  // Returns the folds, in ascending order of their patches. Triangles of two patches are compared if they bound a common solid.
  // `solids`: by patch, the solids that its triangles bound
  // \pre the parts of the mesh have their places in it, and corner points
  std::vector<Fold> operator()(const std::vector<std::vector<std::size_t>>& solids) const
  {
    Folds folds;
    std::vector<std::tuple<std::size_t, std::size_t, Side>> border; // vertices in ascending order, and the side between them
    for(std::size_t p = 0; p < m_mesh.parts.size(); ++p)
      compare_inside(p, folds, border);
    std::sort(border.begin(), border.end(), [](const auto& a, const auto& b) {
      const Side &s = std::get<2>(a), &t = std::get<2>(b);
      return std::make_tuple(std::get<0>(a), std::get<1>(a), s.part, s.number)
             < std::make_tuple(std::get<0>(b), std::get<1>(b), t.part, t.number);
    });
    for(std::size_t i = 0; i < border.size(); ++i)
      for(std::size_t k = i + 1; k < border.size() && std::get<0>(border[i]) == std::get<0>(border[k])
                                 && std::get<1>(border[i]) == std::get<1>(border[k]); ++k)
        if(belong_together(solids, std::get<2>(border[i]), std::get<2>(border[k])))
          compare(std::get<2>(border[i]), std::get<2>(border[k]), folds);
    std::vector<Fold> result;
    for(const auto& fold : folds)
      result.push_back(fold.second);
    return result;
  }

private:
  template <class Border>
  void compare_inside(std::size_t p, Folds& folds, Border& border) const
  {
    const auto& part = m_mesh.parts[p];
    const std::size_t none = (std::numeric_limits<std::size_t>::max)();
    std::vector<bool> is_border(3 * part.faces.size(), false);
    for(const auto side : part.border)
      is_border[side] = true;
    std::vector<std::size_t> first_sides(part.number_of_edges, none);
    for(std::size_t side = 0; side < is_border.size(); ++side) {
      if(is_border[side]) {
        const auto ends = std::minmax({std::size_t(part.source(side)), std::size_t(part.target(side))});
        border.emplace_back(ends.first, ends.second, Side{p, side});
        continue;
      }
      std::size_t& first = first_sides[part.halfedge(side) / 2 - part.first_edge];
      if(first == none)
        first = side;
      else
        compare({p, first}, {p, side}, folds);
    }
  }

  bool belong_together(const std::vector<std::vector<std::size_t>>& solids, const Side& a, const Side& b) const
  {
    const std::size_t first = patch(a), second = patch(b);
    return first == second || std::any_of(solids[first].begin(), solids[first].end(), [&](std::size_t solid) {
             return std::find(solids[second].begin(), solids[second].end(), solid) != solids[second].end();
           });
  }

  void compare(const Side& a, const Side& b, Folds& folds) const
  {
    const double sign = source(a) == source(b) ? -1 : 1; // of triangles that are oriented alike, the sides run against each other
    const Vector_3 m = normal(a), n = normal(b);
    const double squared = (m * m) * (n * n);
    if(!(squared > 0) || !(sign * (m * n) < largest_cosine * std::sqrt(squared)))
      return;
    if(!(sign * (surface_normal(a) * surface_normal(b)) > least_cosine_of_surfaces))
      return;
    std::array<std::size_t, 2> patches{{patch(a), patch(b)}};
    std::sort(patches.begin(), patches.end());
    const Point_3 p = point(a.part, source(a));
    ++folds.emplace(patches, Fold{patches, 0, {{to_double(p.x()), to_double(p.y()), to_double(p.z())}}}).first->second.number_of_pairs;
  }

  std::size_t patch(const Side& side) const { return m_mesh.parts[side.part].patch; }
  std::size_t source(const Side& side) const { return m_mesh.parts[side.part].source(side.number); }

  Point_3 point(std::size_t p, std::size_t v) const
  {
    const auto& part = m_mesh.parts[p];
    return v < m_mesh.points.size() ? m_mesh.points[v] : part.points[v - part.first_point];
  }

  Vector_3 normal(const Side& side) const
  {
    const auto& corners = m_mesh.parts[side.part].faces[side.number / 3];
    const Point_3 p = point(side.part, corners[0]);
    return cross_product(point(side.part, corners[1]) - p, point(side.part, corners[2]) - p);
  }

  // The unit normal of the surface in the middle of a side, on the side that the triangle should face to; 0 where there is none.
  Vector_3 surface_normal(const Side& side) const
  {
    const auto& part = m_mesh.parts[side.part];
    const auto& corners = part.corner_points[side.number / 3];
    const Point_2 &p = corners[side.number % 3], &q = corners[(side.number % 3 + 1) % 3], &r = corners[(side.number % 3 + 2) % 3];
    const auto jet = m_model.faces()[part.patch].surface.jet((p.x() + q.x()) / 2, (p.y() + q.y()) / 2);
    const Vector_3 normal = cross_product(jet.du, jet.dv);
    const double length = std::sqrt(normal * normal),
                 double_area = (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
    return length > 0 && std::isfinite(length) ? (double_area < 0 ? -1 / length : 1 / length) * normal : Vector_3(NULL_VECTOR);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_FOLD_SEARCH_H
