// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_CORNER_ANGLES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_CORNER_ANGLES_H

#include <CGAL/Parametric_surface_mesher/internal/curing/Triangle_complex.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The angles that patches have at vertices of the model, before a mesh is changed: only these can excuse small angles of triangles.
// They are kept by the places of the vertices, since no place changes.
template <class Kernel>
class Corner_angles
{
  typedef Triangle_complex<Kernel> Complex;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;
  typedef std::size_t Index;

  std::map<std::pair<Point_3, Index>, double> m_angles; // in radians

public:
  // Adds the corners of a complex that are not known yet. Of several corners of a patch in a vertex the sharpest counts.
  void add(const Complex& complex)
  {
    Corner_angles added;
    for(Index v = 0; v < complex.vertices().size(); ++v)
      if(complex.vertex(v).dimension == 0 && !complex.vertex(v).is_fixed)
        for(Index t : complex.vertex(v).triangles)
          if(complex.is_on_patch_border(t, complex.triangle(t).corner(v)))
            added.add_corner(complex, v, t);
    m_angles.insert(added.m_angles.begin(), added.m_angles.end());
  }

  // Whether a patch has no larger angle at a vertex of the model than a triangle there has, but for what rounding and small moves
  // of other vertices change.
  bool has_corner_as_small(const Point_3& vertex, Index patch, double angle) const
  {
    const double least_share = 0.9;
    const auto corner = m_angles.find({vertex, patch});
    return corner != m_angles.end() && angle >= least_share * corner->second;
  }

  static double angle(const Vector_3& a, const Vector_3& b)
  {
    return std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b);
  }

private:
  // Adds the angle between the side of a triangle that runs from a vertex along the border and the next border side there.
  void add_corner(const Complex& complex, Index v, Index t)
  {
    const Index patch = complex.triangle(t).patch;
    double sum = 0;
    for(std::size_t number = complex.vertex(v).triangles.size(); number > 0; --number) { // more would go round for ever
      const std::size_t i = complex.triangle(t).corner(v);
      const Point_3& apex = complex.point(t, i);
      sum += angle(complex.point(t, i + 1) - apex, complex.point(t, i + 2) - apex);
      if(complex.is_on_patch_border(t, (i + 2) % 3))
        break;
      t = complex.neighbor_in_patch(t, (i + 2) % 3);
    }
    double& sharpest = m_angles.emplace(std::make_pair(complex.vertex(v).point, patch), sum).first->second;
    sharpest = (std::min)(sharpest, sum);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_CORNER_ANGLES_H
