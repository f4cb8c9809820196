// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_CORNERS_OF_FACE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_CORNERS_OF_FACE_H

#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>

#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Makes loops of a face that touch in a vertex have exactly the same point of the domain there.
template <class Kernel>
class Corners_of_face
{
  typedef typename Kernel::Point_2 Point_2;

  const double m_tolerance;
  std::map<std::size_t, std::vector<Point_2>> m_points; // by vertex; on a seam it has several

public:
  explicit Corners_of_face(double tolerance) : m_tolerance(tolerance) {}

  void snap(Boundary_vertex<Kernel>& vertex)
  {
    std::vector<Point_2>& corners = m_points[vertex.index];
    for(const Point_2& corner : corners)
      if(squared_distance(corner, vertex.domain_point) <= m_tolerance * m_tolerance) {
        vertex.domain_point = corner;
        return;
      }
    corners.push_back(vertex.domain_point);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_CORNERS_OF_FACE_H
