// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_VOLUME_UNDER_FACE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_VOLUME_UNDER_FACE_H

#include <CGAL/Parametric_surface_mesher/internal/sizing/Boundary_size.h>
#include <CGAL/Surface_jet_3.h>

#include <boost/math/quadrature/gauss.hpp>

#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The integral of a function over [a,b], by a Gauss rule on each of several equal intervals.
template <class Function>
double integral(Function function, double a, double b, int number_of_parts)
{
  double sum = 0;
  for(int i = 0; i < number_of_parts; ++i)
    sum += boost::math::quadrature::gauss<double, 7>::integrate(function, a + (b - a) * i / number_of_parts,
                                                                a + (b - a) * (i + 1) / number_of_parts);
  return sum;
}

// The signed volume between a face of a model and a point; summed over the faces of a closed surface it is the volume enclosed.
// The integral of S (S_u x S_v) / 3 over the domain is taken along the loops, by Green's theorem. Only its sign is needed: four
// intervals for each curve are accurate enough for a surface of few faces, and one is for many.
template <class Face, class Point_3>
double volume_under_face(const Face& face, const Point_3& origin, int number_of_parts)
{
  const auto curve_of = [](const auto& use) -> const auto& { return use.curve; };
  const double u_min = domain_box(face.loops, curve_of).xmin();
  double volume = 0;
  for(std::size_t l = 0; l < face.loops.size(); ++l) {
    double sum = 0, double_area = 0;
    for(const auto& use : face.loops[l]) {
      const double sign = use.is_reversed ? -1 : 1;
      double_area += sign * double_area_seen_from(face.loops[l].front().curve.source(), use.curve);
      sum += sign * integral([&](double t) {
        const auto c = use.curve.jet(t);
        if(c.first.y() == 0)
          return 0.;
        return c.first.y() * integral([&](double u) {
          const auto jet = face.surface.jet(u, c.point.y());
          return (jet.point - origin) * cross_product(jet.du, jet.dv) / 3;
        }, u_min, c.point.x(), number_of_parts);
      }, use.curve.begin(), use.curve.end(), number_of_parts);
    }
    volume += (double_area > 0) == (l == 0) ? sum : -sum;
  }
  return face.is_reversed ? -volume : volume;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_VOLUME_UNDER_FACE_H
