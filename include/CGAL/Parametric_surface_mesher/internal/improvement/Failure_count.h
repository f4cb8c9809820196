// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_FAILURE_COUNT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_FAILURE_COUNT_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/Mesh_criterion.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_judge.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>

#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// How many faces fail: one on the wrong side of the surface, or that fails another criterion than the angle, weighs more than
// any number of small angles.
struct Failures
{
  std::size_t others = 0, angles = 0;

  bool are_more_than(const Failures& limit) const
  {
    return others != limit.others ? others > limit.others : angles > limit.angles;
  }
};

const Failures no_limit_of_failures = {std::size_t(-1), std::size_t(-1)};

// Judges faces, and counts those that fail a criterion: what the repair may not raise.
template <class Judge>
class Failure_count
{
  static constexpr double share_of_far_below = 0.6; // of the squared sine of the criterion: 23 degrees, for one of 30
  static constexpr double share_of_needles = 0.47;  // 20 degrees

  const Judge& m_judge;
  double m_squared_sine_of_criterion;

public:
  Failure_count(const Judge& judge, const Parametric_surface_mesh_criteria& criteria)
    : m_judge(judge), m_squared_sine_of_criterion(squared_sine_of_degrees(criteria.angle()))
  {}

  bool is_needle(double squared_sine) const { return squared_sine < share_of_needles * m_squared_sine_of_criterion; }

  // To raise a smallest angle far below the criterion, others beside the boundary may get below it; those in the midst of the
  // mesh, where most often there is a better way, for that of a needle alone. Above `limit` the count may stop; else there is
  // a verdict on all faces after it.
  template <class Faces>
  Failures operator()(const Faces& faces, double squared_smallest_sine, const Failures& limit = no_limit_of_failures) const
  {
    const bool may_fail_angle = is_needle(squared_smallest_sine),
               may_fail_beside_boundary = squared_smallest_sine < share_of_far_below * m_squared_sine_of_criterion;
    Failures result;
    for(const auto& face : faces) {
      examine(face);
      if(!face->verdict().fails())
        continue;
      if(!face->verdict().fails(Mesh_criterion::ANGLE) || m_judge.is_inverted(face))
        ++result.others;
      else if(!may_fail_angle && !(may_fail_beside_boundary && is_beside_boundary(face)))
        ++result.angles;
      if(result.are_more_than(limit))
        break;
    }
    return result;
  }

  template <class Faces>
  void examine_all(const Faces& faces) const
  {
    for(const auto& face : faces)
      examine(face);
  }

private:
  template <class Face_handle>
  void examine(Face_handle face) const
  {
    if(face->verdict().meets(Scope::WHOLE))
      return;
    const Verdict before = face->verdict();
    Verdict verdict(is_collapsed(face) ? Criterion_set() : m_judge.first_failed(face), Scope::WHOLE);
    if(before.is_refused() && verdict.fails())
      verdict.refuse(before.refusal());
    face->set_verdict(verdict);
  }

  template <class Face_handle>
  static bool touches_boundary(Face_handle face)
  {
    return face->vertex(0)->is_on_boundary() || face->vertex(1)->is_on_boundary() || face->vertex(2)->is_on_boundary();
  }

  // itself or a neighbour
  template <class Face_handle>
  static bool is_beside_boundary(Face_handle face)
  {
    for(int i = 0; i < 3; ++i)
      if(face->neighbor(i) != Face_handle() && touches_boundary(face->neighbor(i)))
        return true;
    return touches_boundary(face);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_FAILURE_COUNT_H
