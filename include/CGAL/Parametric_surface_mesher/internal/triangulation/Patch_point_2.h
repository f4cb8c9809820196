// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_PATCH_POINT_2_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_PATCH_POINT_2_H

#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Parametric_point_2.h>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A point of a patch in the coordinates in which the patch is meshed, with its place in the coordinates in which edges are
// straight: for most charts those of the domain. The second place is kept because every edge of a vertex needs it, and computing
// it costs as much as an evaluation of the surface.
template <class Kernel>
class Patch_point_2
  : public Parametric_point_2<Kernel>
{
  typedef Parametric_point_2<Kernel> Base;
  typedef typename Kernel::Point_2 Point_2;

  Point_2 m_line_point;

public:
  Patch_point_2() : m_line_point(0, 0) {}

  explicit Patch_point_2(const Point_2& p) : Base(p), m_line_point(p) {}

  // A point whose edges are straight in the coordinates in which the patch is meshed.
  Patch_point_2(const Point_2& p, const typename Kernel::Point_3& surface_point, const Metric_tensor_2& tensor)
    : Base(p, surface_point, tensor), m_line_point(p)
  {}

  void set_line_point(const Point_2& p) { m_line_point = p; }
  const Point_2& line_point() const { return m_line_point; }
};

// Sets the place of a point in the coordinates in which edges are straight. A surface without a chart has nothing to set;
// `Charted_surface_3` has an overload.
template <class Surface, class Kernel>
void set_line_point(const Surface&, Patch_point_2<Kernel>&)
{}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_PATCH_POINT_2_H
