// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_INTERSECTING_TRIANGLES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_INTERSECTING_TRIANGLES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/intersections.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Whether two triangles have more in common than the corners that they share, which have the same coordinates. Nearly all pairs are
// told apart by a plane between them, in floating point numbers; the others are judged exactly.
class Intersecting_triangles
{
public:
  typedef Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Kernel::Point_3 Point_3;
  typedef Kernel::Vector_3 Vector_3;
  typedef std::array<Point_3, 3> Triangle;

private:
  // A signed distance from a plane counts only if it is above this share of the product of the lengths that it is computed from:
  // a bound of the rounding errors with room for several operations.
  static constexpr double rounding = 1e-14;

  // The corners that two triangles share, and how many these are.
  struct Shared
  {
    std::array<int, 3> in_first, in_second;
    int number = 0;
  };

public:
  bool operator()(const Triangle& a, const Triangle& b) const
  {
    const Shared shared = shared_corners(a, b);
    if(shared.number == 3)
      return true;
    if(shared.number == 2)
      return are_folded(a, b, shared);
    return !are_apart(a, b, shared) && intersect(a, b, shared);
  }

private:
  static Shared shared_corners(const Triangle& a, const Triangle& b)
  {
    Shared result;
    for(int i = 0; i < 3; ++i)
      for(int k = 0; k < 3; ++k)
        if(a[i].x() == b[k].x() && a[i] == b[k] && result.number < 3) {
          result.in_first[result.number] = i;
          result.in_second[result.number++] = k;
        }
    return result;
  }

  // Two triangles with a common edge meet elsewhere only if they lie in one plane, on the same side of the edge.
  static bool are_folded(const Triangle& a, const Triangle& b, const Shared& shared)
  {
    const Point_3 &p = a[shared.in_first[0]], &q = a[shared.in_first[1]],
                  &r = a[3 - shared.in_first[0] - shared.in_first[1]], &s = b[3 - shared.in_second[0] - shared.in_second[1]];
    return coplanar(p, q, r, s) && (collinear(p, q, r) || collinear(p, q, s) || coplanar_orientation(p, q, r, s) == POSITIVE);
  }

  // Whether a plane separates two triangles but for a shared corner. Planes through the triangles are tried, then those through their
  // sides along the mean normal, which separate triangles of a surface that is nearly flat.
  static bool are_apart(const Triangle& a, const Triangle& b, const Shared& shared)
  {
    const int ka = shared.number == 0 ? -1 : shared.in_first[0], kb = shared.number == 0 ? -1 : shared.in_second[0];
    const Vector_3 m = cross_product(a[1] - a[0], a[2] - a[0]), n = cross_product(b[1] - b[0], b[2] - b[0]);
    if(shared.number == 0 && (is_on_one_side(a[0], m, b, -1) || is_on_one_side(b[0], n, a, -1)))
      return true;
    const double mm = m * m, nn = n * n;
    if(!(mm > 0) || !(nn > 0))
      return false;
    const Vector_3 mean = std::sqrt(nn) * m + std::sqrt(mm) * n; // it has a positive product with both, unless they are opposed
    return separates_a_side(a, b, mean, ka, kb) || separates_a_side(b, a, mean, kb, ka);
  }

  // Whether a plane through a side of the first triangle, along `mean`, is between the triangles but for the shared corner.
  static bool separates_a_side(const Triangle& a, const Triangle& b, const Vector_3& mean, int shared_of_a, int shared_of_b)
  {
    for(int i = 0; i < 3; ++i) {
      const int k = (i + 1) % 3, opposite = (i + 2) % 3;
      if(opposite == shared_of_a)
        continue;
      const Vector_3 outward = cross_product(a[k] - a[i], mean);
      const double own = outward * (a[opposite] - a[i]);
      if(own < -bound(outward, a[opposite] - a[i]) && is_beyond(a[i], outward, b, shared_of_b))
        return true;
    }
    return false;
  }

  static double bound(const Vector_3& normal, const Vector_3& v)
  {
    return rounding * std::sqrt((normal * normal) * (v * v));
  }

  // Whether all corners but the one with the number `left_out` lie on the positive side of a plane.
  static bool is_beyond(const Point_3& p, const Vector_3& normal, const Triangle& t, int left_out)
  {
    for(int i = 0; i < 3; ++i)
      if(i != left_out && !(normal * (t[i] - p) > bound(normal, t[i] - p)))
        return false;
    return true;
  }

  static bool is_on_one_side(const Point_3& p, const Vector_3& normal, const Triangle& t, int left_out)
  {
    return is_beyond(p, normal, t, left_out) || is_beyond(p, -normal, t, left_out);
  }

  static bool intersect(const Triangle& a, const Triangle& b, const Shared& shared)
  {
    if(collinear(a[0], a[1], a[2]) || collinear(b[0], b[1], b[2]))
      return false; // the report has triangles without an area by their angle
    const Kernel::Triangle_3 first(a[0], a[1], a[2]), second(b[0], b[1], b[2]);
    if(shared.number == 0)
      return do_intersect(first, second);
    return do_intersect(first, opposite_side(b, shared.in_second[0])) || do_intersect(second, opposite_side(a, shared.in_first[0]));
  }

  static Kernel::Segment_3 opposite_side(const Triangle& t, int corner)
  {
    return {t[(corner + 1) % 3], t[(corner + 2) % 3]};
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_INTERSECTING_TRIANGLES_H
