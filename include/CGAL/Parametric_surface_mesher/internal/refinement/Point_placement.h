// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_POINT_PLACEMENT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_POINT_PLACEMENT_H

#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Parametric_surface_mesher/Point_placements.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Positions for a new point that improves a bad face. They are computed from the edge lengths under the metric, and the affine map
// of the face between space and domain turns them into domain points.
template <class Kernel>
class Point_placement
{
public:
  typedef typename Kernel::Point_2 Point_2;
  typedef Triangle_weights Weights; // barycentric coordinates in a face

  template <class Face_handle>
  static Point_2 barycentric(Face_handle face, const Weights& w)
  {
    double x = 0, y = 0;
    for(int i = 0; i < 3; ++i) {
      x += w[i] * face->vertex(i)->point().x();
      y += w[i] * face->vertex(i)->point().y();
    }
    return Point_2(x, y);
  }

  // Positions for a face whose circumcentre is not acceptable, the most promising one first: apices of isosceles triangles over its
  // shortest edge, and the centroid.
  static boost::container::static_vector<Weights, 4> alternatives(const Face_measures& measures)
  {
    const std::array<double, 3>& l = measures.squared_lengths;
    const std::size_t shortest = std::size_t(std::min_element(l.begin(), l.end()) - l.begin());
    const Weights center = Circumcenter_placement()(l, 0);
    const double distance = std::sqrt((std::max)(0., measures.squared_circumradius - l[shortest] / 4));
    boost::container::static_vector<Weights, 4> result;
    for(double height : heights_over_shortest_edge) {
      const double share = height * std::sqrt(l[shortest]) / distance;
      if(!(share < 1))
        continue;
      result.push_back(Off_center_placement::on_axis(shortest, share, center));
    }
    result.push_back({1. / 3, 1. / 3, 1. / 3});
    return result;
  }

  // The apex of an isosceles triangle on the left of the edge from `p` to `q`, under the tensors of these. The height is a multiple
  // of the length of the edge.
  template <class Point>
  static Point_2 apex(const Point& p, const Point& q, double height)
  {
    const Metric_tensor_2 m = p.tensor() + q.tensor();
    const double du = q.x() - p.x(), dv = q.y() - p.y(), scale = height / std::sqrt(m.determinant());
    return Point_2(0.5 * (p.x() + q.x()) - scale * (m.f() * du + m.g() * dv),
                   0.5 * (p.y() + q.y()) + scale * (m.e() * du + m.f() * dv));
  }

  // Appends positions over a boundary edge, which has the domain on its left.
  template <class Point>
  static void append_apices(const Point& p, const Point& q, std::vector<Point_2>& positions)
  {
    for(double height : heights_over_boundary)
      positions.push_back(apex(p, q, height));
  }

private:
  // Over the side; sqrt(3) / 2 is 0.866.
  static constexpr double height_of_equilateral = 0.87;
  // Heights of isosceles triangles over their bases, in the order in which they are tried: angles at the apex are 39, 60 and 80
  // degrees over an inner edge, where long triangles often fit better; 60, 80 and 45 degrees over the boundary.
  static constexpr double heights_over_shortest_edge[] = {1.4, height_of_equilateral, 0.6},
                          heights_over_boundary[] = {height_of_equilateral, 0.6, 1.2};
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_POINT_PLACEMENT_H
