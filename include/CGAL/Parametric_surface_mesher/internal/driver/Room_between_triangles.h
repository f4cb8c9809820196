// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_ROOM_BETWEEN_TRIANGLES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_ROOM_BETWEEN_TRIANGLES_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Surface_curvature_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A triangle of a patch, as far as it takes to compare it with the surface.
template <class Surface>
struct Triangle_on_surface
{
  typedef typename Surface::Geom_traits Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;

  const Surface& surface;
  Bbox_2 domain; // of the patch
  std::array<Point_3, 3> corners;
  std::array<Point_2, 3> domain_corners;

  double longest_side() const
  {
    return std::sqrt((std::max)({squared_distance(corners[0], corners[1]), squared_distance(corners[1], corners[2]),
                                 squared_distance(corners[2], corners[0])}));
  }

  // The largest distance of the surface from the middles of the sides.
  double deviation() const
  {
    double result = 0;
    for(std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = (i + 1) % 3;
      const auto& p = domain_corners[i];
      const auto& q = domain_corners[k];
      result = (std::max)(result, squared_distance(surface.point((p.x() + q.x()) / 2, (p.y() + q.y()) / 2),
                                                   midpoint(corners[i], corners[k])));
    }
    return std::sqrt(result);
  }

  // Whether the triangle faces away from the surface in its middle.
  bool is_inverted() const
  {
    const auto &p = domain_corners[0], &q = domain_corners[1], &r = domain_corners[2];
    const auto jet = surface.jet((p.x() + q.x() + r.x()) / 3, (p.y() + q.y() + r.y()) / 3);
    const auto normal = cross_product(corners[1] - corners[0], corners[2] - corners[0]);
    const double domain_area = (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
    return domain_area * (normal * cross_product(jet.du, jet.dv)) < 0;
  }

  // That of the surface in the middle, or that of an arc over the longest side with the deviation, if it is larger.
  double curvature() const
  {
    const auto jet = surface.jet((domain_corners[0].x() + domain_corners[1].x() + domain_corners[2].x()) / 3,
                                 (domain_corners[0].y() + domain_corners[1].y() + domain_corners[2].y()) / 3);
    return (std::max)(Surface_curvature_3<Kernel>(jet).max_absolute_curvature(), 8 * deviation() / square(longest_side()));
  }

  // How far a point is from the surface near the triangle, positive on the side of the normal; none if the surface has no point below
  // it there.
  std::optional<double> signed_distance(const Point_3& p) const
  {
    const int max_number_of_steps = 8;
    const double largest_slant = 0.5; // the sine of the angle between the normal and the direction to the point
    Bbox_2 box = neighbourhood();
    double u = (domain_corners[0].x() + domain_corners[1].x() + domain_corners[2].x()) / 3,
           v = (domain_corners[0].y() + domain_corners[1].y() + domain_corners[2].y()) / 3;
    for(int i = 0; i < max_number_of_steps; ++i) { // of Gauss and Newton
      const auto jet = surface.jet(u, v);
      const auto d = p - jet.point;
      const double e = jet.du * jet.du, f = jet.du * jet.dv, g = jet.dv * jet.dv, det = e * g - f * f;
      if(!(det > 0))
        return std::nullopt;
      u = (std::min)((std::max)(u + (g * (d * jet.du) - f * (d * jet.dv)) / det, box.xmin()), box.xmax());
      v = (std::min)((std::max)(v + (e * (d * jet.dv) - f * (d * jet.du)) / det, box.ymin()), box.ymax());
    }
    const auto jet = surface.jet(u, v);
    const auto normal = cross_product(jet.du, jet.dv), d = p - jet.point;
    const double length = std::sqrt(normal * normal), along = normal * d / length;
    if(!(length > 0) || d * d - along * along > largest_slant * largest_slant * (d * d))
      return std::nullopt;
    return along;
  }

private:
  // The box of the triangle in the domain, three times as large.
  Bbox_2 neighbourhood() const
  {
    const Bbox_2 box = domain_corners[0].bbox() + domain_corners[1].bbox() + domain_corners[2].bbox();
    const double width = box.xmax() - box.xmin(), height = box.ymax() - box.ymin();
    return {(std::max)(domain.xmin(), box.xmin() - width), (std::max)(domain.ymin(), box.ymin() - height),
            (std::min)(domain.xmax(), box.xmax() + width), (std::min)(domain.ymax(), box.ymax() + height)};
  }
};

// The room that two surfaces leave for two triangles which pass through each other.
template <class Surface>
class Room_between_triangles
{
  typedef Triangle_on_surface<Surface> Triangle;

  const Triangle &m_first, &m_second;
  double m_precision; // lengths below it do not count

  struct Sides
  {
    std::optional<double> distance;          // the smallest one that counts
    bool is_above = false, is_below = false; // whether there are points above the surface, and below it
  };

public:
  Room_between_triangles(const Triangle& first, const Triangle& second, double precision)
    : m_first(first), m_second(second), m_precision(precision)
  {}

  // The distance between the surfaces there; none if they cross or touch.
  std::optional<double> width() const
  {
    const Sides first = sides(m_first, m_second), second = sides(m_second, m_first);
    if((first.is_above && first.is_below) || (second.is_above && second.is_below))
      return std::nullopt;
    if(first.distance && second.distance)
      return (std::min)(*first.distance, *second.distance);
    return first.distance ? first.distance : second.distance;
  }

private:
  // On which sides of the surface of one triangle the corners of the other are.
  Sides sides(const Triangle& triangle, const Triangle& of_surface) const
  {
    Sides result;
    for(const auto& corner : triangle.corners) {
      const std::optional<double> distance = of_surface.signed_distance(corner);
      if(!distance || std::fabs(*distance) < m_precision)
        continue;
      (*distance > 0 ? result.is_above : result.is_below) = true;
      result.distance = (std::min)(std::fabs(*distance), result.distance.value_or(std::fabs(*distance)));
    }
    return result;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_ROOM_BETWEEN_TRIANGLES_H
