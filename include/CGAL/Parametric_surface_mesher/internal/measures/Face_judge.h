// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_FACE_JUDGE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_FACE_JUDGE_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/Mesh_criterion.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <limits>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// What a judge says of a face that is to be refined.
struct Judgement
{
  Criterion_set failed;        // the first criterion that it fails
  double badness = 0;          // the squared ratio of what it has to what it may have, by that criterion; above 1
  bool is_well_shaped = false; // nearly equilateral: it can wait for others
};

/*
Judges the faces of a patch. While a patch is refined a face is judged by one criterion after the other, up to the first
one that it fails: size, angle, then what the user asks for, which make its shape; and, which takes evaluations of the
surface, the side that it is on and how far the surface is from it. Edges that no point inside the patch can make better are
not looked at then: those of the boundary, and those too short to be divided. In the end all criteria are judged, at all
edges.
*/
template <class Oracle, class TriangleCriterion>
class Face_judge
{
  // A triangle with no angle below some 46 degrees counts as well shaped. To split it costs shape around it, so it may be
  // larger than others (by sqrt(1.2)), and waits until the others are done: measured, this raises the mean radius ratio
  // from 0.906 to 0.916.
  static constexpr double squared_sine_of_good_shape = 0.51;
  static constexpr double allowance_of_good_shape = 1.2;

  static constexpr double badness_of_inverted = 2;

  // The squared circumradius is `product / area`. Quotients are left to bad triangles, as most live but a moment.
  struct Shape
  {
    double product;         // of the squared lengths
    double area;            // squared, times 16
    double sine;            // squared, of the smallest angle, times `4 product`
    double largest_product; // that the size allows
    bool is_well_shaped;
  };

  const Oracle& m_oracle;
  double m_squared_sine, m_squared_size_factor;
  Deviation_limits m_limits;
  TriangleCriterion m_criterion;

public:
  Face_judge(const Oracle& oracle, const Parametric_surface_mesh_criteria& criteria, const TriangleCriterion& criterion)
    : m_oracle(oracle), m_squared_sine(squared_sine_of_degrees(criteria.angle())),
      m_squared_size_factor(square(criteria.size_factor())),
      m_limits{criteria.gamma(), square(criteria.distance().value_or(0)), square(2 * criteria.min_edge())}, m_criterion(criterion)
  {}

  // the first of size, angle, and the criterion of the user
  template <class Face_handle>
  Judgement judge_shape(Face_handle f) const
  {
    const Shape shape = this->shape(f);
    if(!has_good_size(shape))
      return {Mesh_criterion::SIZE,
              shape.area > 0 ? shape.product / shape.largest_product : std::numeric_limits<double>::infinity(),
              shape.is_well_shaped};
    if(!has_good_angle(shape))
      return {Mesh_criterion::ANGLE, 4 * m_squared_sine * shape.product / shape.sine, shape.is_well_shaped};
    const double badness = m_criterion(f, m_oracle);
    if(badness > 1)
      return {Mesh_criterion::USER, badness, shape.is_well_shaped};
    return {{}, 0, shape.is_well_shaped};
  }

  // the first of deviation, side and distance, as far as refinement can help
  template <class Face_handle>
  Judgement judge_deviation(Face_handle f) const
  {
    const Squared_deviation deviation = squared_deviation_to_refine(f, m_oracle, m_limits);
    if(!deviation.has_ratio_within(m_limits))
      return {Mesh_criterion::DEVIATION, deviation.ratio / square(m_limits.gamma), false};
    if(is_inverted(f))
      return {Mesh_criterion::INVERTED, badness_of_inverted, false};
    if(!deviation.has_height_within(m_limits))
      return {Mesh_criterion::DISTANCE, deviation.height / m_limits.squared_distance, false};
    if(m_limits.squared_distance > 0 && has_divisible_edge(f, m_limits)) {
      const double inside = squared_distance_inside(f, m_oracle, m_limits);
      if(inside > m_limits.squared_distance)
        return {Mesh_criterion::DISTANCE, inside / m_limits.squared_distance, false};
    }
    return {};
  }

  // the first of all these
  template <class Face_handle>
  Criterion_set first_failed(Face_handle f) const
  {
    const Criterion_set by_shape = judge_shape(f).failed;
    return by_shape.empty() ? judge_deviation(f).failed : by_shape;
  }

  template <class Face_handle>
  bool is_inverted(Face_handle f) const
  {
    return internal::is_inverted(f, m_oracle);
  }

  // Whether a face has an angle whose squared sine is below that given.
  template <class Face_handle>
  bool has_smaller_angle(Face_handle f, double squared_sine) const
  {
    const Shape shape = this->shape(f);
    return 4 * squared_sine * shape.product > shape.sine;
  }

  // all criteria that a face fails
  template <class Face_handle>
  Criterion_set failed(Face_handle f) const
  {
    return failed_by_shape(f) | failed_by_deviation(f);
  }

  // Those of them that take no evaluation of the surface.
  template <class Face_handle>
  Criterion_set failed_by_shape(Face_handle f) const
  {
    Criterion_set result;
    const Shape shape = this->shape(f);
    if(!has_good_size(shape))
      result |= Mesh_criterion::SIZE;
    if(!has_good_angle(shape))
      result |= Mesh_criterion::ANGLE;
    if(m_criterion(f, m_oracle) > 1)
      result |= Mesh_criterion::USER;
    return result;
  }

  // Those of them that are judged by the surface.
  template <class Face_handle>
  Criterion_set failed_by_deviation(Face_handle f) const
  {
    Criterion_set result = failed_at_edges(f);
    if(is_inverted(f))
      result |= Mesh_criterion::INVERTED;
    if(is_too_far_inside(f))
      result |= Mesh_criterion::DISTANCE;
    return result;
  }

  // Those that a face fails which refinement has found nothing against: at the edges that refinement does not look at, and, if
  // there is no other edge, inside.
  template <class Face_handle>
  Criterion_set failed_at_other_edges(Face_handle f) const
  {
    Criterion_set result = failed_at_edges(f);
    if(!has_divisible_edge(f, m_limits) && is_too_far_inside(f))
      result |= Mesh_criterion::DISTANCE;
    return result;
  }

  // Whether refinement looks at an edge.
  template <class Face_handle>
  bool can_refine(Face_handle f, int i) const
  {
    return !f->is_constrained(i) && squared_length_in_space(f, i) > m_limits.squared_divisible_edge;
  }

private:
  // The criteria that a face fails at edges that are not known to be close to the surface.
  template <class Face_handle>
  Criterion_set failed_at_edges(Face_handle f) const
  {
    const Squared_deviation deviation = squared_deviation_of_edges(f, m_oracle, m_limits);
    Criterion_set result;
    if(!deviation.has_ratio_within(m_limits))
      result |= Mesh_criterion::DEVIATION;
    if(!deviation.has_height_within(m_limits))
      result |= Mesh_criterion::DISTANCE;
    return result;
  }

  template <class Face_handle>
  bool is_too_far_inside(Face_handle f) const
  {
    return m_limits.squared_distance > 0 && squared_distance_inside(f, m_oracle, m_limits) > m_limits.squared_distance;
  }

  template <class Face_handle>
  Shape shape(Face_handle f) const
  {
    const std::array<double, 3> l = squared_lengths(f, m_oracle.metric());
    Shape result;
    result.product = l[0] * l[1] * l[2];
    result.area = (std::max)(squared_area_16(l), 0.);
    result.sine = (std::min)({l[0], l[1], l[2]}) * result.area;
    result.is_well_shaped = result.sine > 4 * squared_sine_of_good_shape * result.product;
    const double spacing = f->vertex(0)->spacing() + f->vertex(1)->spacing() + f->vertex(2)->spacing();
    result.largest_product = (result.is_well_shaped ? 1 : 1 / allowance_of_good_shape) * m_squared_size_factor * spacing
                             * spacing * result.area;
    return result;
  }

  static bool has_good_size(const Shape& shape) { return shape.product < shape.largest_product; }
  bool has_good_angle(const Shape& shape) const
  {
    // (A triangle with an edge of length 0 has a product of 0.)
    return 4 * m_squared_sine * shape.product <= shape.sine && (shape.sine > 0 || m_squared_sine == 0);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_FACE_JUDGE_H
