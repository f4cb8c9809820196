// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADED_SIZING_FIELD_3_H
#define CGAL_GRADED_SIZING_FIELD_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Distances_3.h>
#include <CGAL/Parametric_surface_mesher/internal/support/check_value.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherSizing

An edge length that is wanted in a part of space, and grows outside with the distance from it.

\cgalModels{ParametricSurfaceSizingField_3}

\tparam Kernel a model of `Kernel` with `double` as number type

\sa `CGAL::Least_sizing_field_3`
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel>
class Graded_sizing_field_3
{
public:
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Segment_3 Segment_3;
  typedef typename Kernel::Triangle_3 Triangle_3;
  typedef typename Kernel::Iso_cuboid_3 Iso_cuboid_3;

private:
  typedef Parametric_surface_mesher::internal::Distance_kernel Distance_kernel;
  typedef std::function<double(const Distance_kernel::Point_3&)> Distance;

  Distance m_distance;
  double m_length, m_growth, m_reach = 0;

  Graded_sizing_field_3(Distance distance, double length, double growth)
    : m_distance(std::move(distance)), m_length(length), m_growth(growth)
  {
    Parametric_surface_mesher::internal::check_positive_and_finite("length of a sizing field", length);
    Parametric_surface_mesher::internal::check_not_negative_and_finite("growth of a sizing field", growth);
  }

public:
  /// \name Creation
  /// `length` is the wanted edge length. Outside it grows by `growth` times the distance; up to 0.2 leaves room for well-shaped triangles.
  /// All of these throw `Parametric_surface_mesh_error` if the length is not positive and finite, or the growth is negative or not finite.
  /// @{

  /// in a box.
  static Graded_sizing_field_3 in_box(const Iso_cuboid_3& box, double length, double growth = 0.2)
  {
    return Graded_sizing_field_3(Parametric_surface_mesher::internal::Distance_from_box_3{box.bbox()}, length, growth);
  }

  /// in a ball around a point.
  /// \throws Parametric_surface_mesh_error if the radius is negative
  static Graded_sizing_field_3 in_ball(const Point_3& center, double radius, double length, double growth = 0.2)
  {
    using namespace Parametric_surface_mesher::internal;
    check_not_negative_and_finite("radius of a ball", radius);
    return Graded_sizing_field_3(Distance_from_ball_3{distance_point(center), radius}, length, growth);
  }

  /// in a cylinder with flat ends around a segment.
  /// \throws Parametric_surface_mesh_error if the radius is negative, or the segment is a point
  static Graded_sizing_field_3 in_cylinder(const Segment_3& axis, double radius, double length, double growth = 0.2)
  {
    using namespace Parametric_surface_mesher::internal;
    check_not_negative_and_finite("radius of a cylinder", radius);
    if(axis.source() == axis.target())
      throw Parametric_surface_mesh_error("the axis of a cylinder begins and ends at " + describe_place(axis.source()));
    return Graded_sizing_field_3(Distance_from_cylinder_3(distance_point(axis.source()), distance_point(axis.target()), radius), length,
                                 growth);
  }

  /*!
  near points, segments or triangles: those of an edge or a face, for example.
  \tparam Range a range of `Point_3`, `Segment_3` or `Triangle_3`
  \param length the wanted edge length
  \param growth by how much it grows with the distance, as a share of that
  \param reach the distance up to which the length does not grow. For a curved edge or face that is given by segments or triangles, it
  should be at least the distance between these and the curve or surface.
  \throws Parametric_surface_mesh_error if the range is empty, a segment or triangle is degenerate, or `reach` is negative or not finite
  */
  template <class Range>
  static Graded_sizing_field_3 near(const Range& range, double length, double growth = 0.2, double reach = 0)
  {
    Parametric_surface_mesher::internal::check_not_negative_and_finite("reach of a sizing field", reach);
    if(std::begin(range) == std::end(range))
      throw Parametric_surface_mesh_error("a sizing field near nothing: the range is empty");
    Graded_sizing_field_3 result(distance_from(range), length, growth);
    result.m_reach = reach;
    return result;
  }
  /// @}

  /// the least of its values.
  double length() const { return m_length; }

  /// the wanted edge length at a point.
  double operator()(const Point_3& p) const
  {
    const double distance = m_distance(Parametric_surface_mesher::internal::distance_point(p));
    return m_length + m_growth * (std::max)(0., distance - m_reach);
  }

private:
  template <class Range>
  static Distance distance_from(const Range& range)
  {
    using namespace Parametric_surface_mesher::internal;
    typedef std::decay_t<decltype(*std::begin(range))> Piece;
    if constexpr(std::is_same_v<Piece, Point_3>) {
      std::vector<Distance_kernel::Point_3> points;
      for(const Point_3& p : range)
        points.push_back(distance_point(p));
      return Distance_from_points_3(points);
    }
    else {
      static_assert(std::is_same_v<Piece, Segment_3> || std::is_same_v<Piece, Triangle_3>,
                    "The range must be one of points, segments or triangles of the kernel");
      typedef std::conditional_t<std::is_same_v<Piece, Segment_3>, Distance_kernel::Segment_3, Distance_kernel::Triangle_3> Own_piece;
      std::vector<Own_piece> pieces;
      for(const Piece& piece : range) {
        if(piece.is_degenerate())
          throw Parametric_surface_mesh_error("a sizing field near a degenerate segment or triangle at " + describe_place(piece.vertex(0)));
        pieces.push_back(own(piece));
      }
      return Distance_from_pieces_3<Own_piece>(pieces);
    }
  }

  static Distance_kernel::Segment_3 own(const Segment_3& s)
  {
    using Parametric_surface_mesher::internal::distance_point;
    return Distance_kernel::Segment_3(distance_point(s.source()), distance_point(s.target()));
  }

  static Distance_kernel::Triangle_3 own(const Triangle_3& t)
  {
    using Parametric_surface_mesher::internal::distance_point;
    return Distance_kernel::Triangle_3(distance_point(t.vertex(0)), distance_point(t.vertex(1)), distance_point(t.vertex(2)));
  }
};

} // namespace CGAL

#endif // CGAL_GRADED_SIZING_FIELD_3_H
