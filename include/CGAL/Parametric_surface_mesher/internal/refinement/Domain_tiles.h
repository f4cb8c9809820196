// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_DOMAIN_TILES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_DOMAIN_TILES_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Kernel/global_functions_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A grid of rectangles over the domain that are about squares in space and take about a thousand points of the mesh each. The
// number of points is estimated from the triangulation of the boundary. (spatial_sort() of CGAL orders points that are known, but
// a front makes its points one by one.)
class Domain_tiles
{
  // The faces between so many points, 230 kB with their vertices, fit into the second level cache.
  static constexpr double points_per_tile = 1000;
  static constexpr double max_number_of_tiles = 1e6; // bounds the memory if the estimate is far too high

  Bbox_2 m_box;
  std::size_t m_columns = 1, m_rows = 1;

public:
  template <class Triangulation>
  explicit Domain_tiles(const Triangulation& triangulation)
  {
    double number_of_points = 0, e = 0, g = 0;
    for(const auto face : triangulation.finite_face_handles()) {
      if(!face->is_in_domain())
        continue;
      number_of_points += 0.5 * number_of_equilateral_triangles(face);
      for(int i = 0; i < 3; ++i) {
        m_box += face->vertex(i)->point().bbox();
        e += face->vertex(i)->point().tensor().e();
        g += face->vertex(i)->point().tensor().g();
      }
    }
    divide(number_of_points / points_per_tile, width() * std::sqrt(e), height() * std::sqrt(g));
  }

  std::size_t size() const { return m_columns * m_rows; }

  // the number of the tile at, or nearest to, a point of the domain
  std::size_t operator()(double u, double v) const
  {
    return index((u - m_box.xmin()) / width(), m_columns) + m_columns * index((v - m_box.ymin()) / height(), m_rows);
  }

private:
  double width() const { return m_box.xmax() - m_box.xmin(); }
  double height() const { return m_box.ymax() - m_box.ymin(); }

  void divide(double number_of_tiles, double width_in_space, double height_in_space)
  {
    if(!(number_of_tiles > 1))
      return;
    const double n = (std::min)(number_of_tiles, max_number_of_tiles);
    m_columns = std::size_t((std::min)((std::max)(std::round(std::sqrt(n * width_in_space / height_in_space)), 1.), n));
    m_rows = std::size_t((std::max)(std::round(n / double(m_columns)), 1.));
  }

  static std::size_t index(double share, std::size_t n)
  {
    return share > 0 ? (std::min)(std::size_t(share * double(n)), n - 1) : 0;
  }

  // Of the wanted size, with the area of the face. By tensors, since the corners of a face that crosses a closed surface can
  // be one point in space.
  template <class Face_handle>
  static double number_of_equilateral_triangles(Face_handle face)
  {
    double stretch = 0, spacing = 0;
    for(int i = 0; i < 3; ++i) {
      stretch += std::sqrt((std::max)(face->vertex(i)->point().tensor().determinant(), 0.)) / 3;
      spacing += face->vertex(i)->spacing() / 3;
    }
    const auto &p = face->vertex(0)->point(), &q = face->vertex(1)->point(), &r = face->vertex(2)->point();
    return stretch * area(p.domain_point(), q.domain_point(), r.domain_point()) / (0.25 * std::sqrt(3.) * spacing * spacing);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_DOMAIN_TILES_H
