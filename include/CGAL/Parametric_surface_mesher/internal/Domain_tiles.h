// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DOMAIN_TILES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DOMAIN_TILES_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Parametric_surface_mesher/internal/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_triangulation_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A grid over the domain, of rectangles that are about squares in space and take about a thousand points of the mesh each:
// the faces between these fit the second level cache. How many points there will be is estimated from the triangulation of
// the boundary, and need not be true.
class Domain_tiles
{
  static constexpr double points_per_tile = 1000;
  static constexpr double max_number_of_tiles = 1e6;

  Bbox_2 m_box;
  std::size_t m_columns = 1, m_rows = 1;

public:
  template <class Triangulation, class MetricField>
  Domain_tiles(const Triangulation& triangulation, const MetricField& metric)
  {
    double number_of_points = 0, e = 0, g = 0;
    for(const auto face : triangulation.finite_face_handles()) {
      if(!face->is_in_domain() || is_collapsed(face))
        continue;
      number_of_points += 0.5 * number_of_equilateral_triangles(face, metric);
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

  // of the wanted size, with the area of the face
  template <class Face_handle, class MetricField>
  static double number_of_equilateral_triangles(Face_handle face, const MetricField& metric)
  {
    const double area = 0.25 * std::sqrt((std::max)(squared_area_16(squared_lengths(face, metric)), 0.));
    const double spacing = (face->vertex(0)->spacing() + face->vertex(1)->spacing() + face->vertex(2)->spacing()) / 3;
    return area / (0.25 * std::sqrt(3.) * spacing * spacing);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DOMAIN_TILES_H
