// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_FAILURE_COUNT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_FAILURE_COUNT_H

#include <CGAL/Mesh_2/Face_badness.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>

#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Counts faces that fail a criterion: what the repair may not raise.
template <class Evaluator, class IsBad>
class Failure_count
{
  static constexpr double share_of_far_below = 0.6; // of the squared sine of the criterion: 23 degrees, for one of 30
  static constexpr double share_of_needles = 0.47;  // 20 degrees

  const Evaluator& m_evaluate;
  const IsBad& m_is_bad;
  double m_squared_sine_of_criterion;

public:
  Failure_count(const Evaluator& evaluate, const IsBad& is_bad, const Parametric_surface_mesh_criteria& criteria)
    : m_evaluate(evaluate), m_is_bad(is_bad), m_squared_sine_of_criterion(squared_sine_of_degrees(criteria.angle()))
  {}

  bool is_needle(double squared_sine) const { return squared_sine < share_of_needles * m_squared_sine_of_criterion; }

  // How many fail a criterion; one that fails another one than the angle counts more than a whole star that fails that. To
  // raise a smallest angle far below the criterion, others beside the boundary may get below it; those in the midst of the
  // mesh, where most often there is a better way, for that of a needle alone. Above `limit` the count may stop; else the
  // state of all faces is known after it.
  template <class Faces>
  std::size_t operator()(const Faces& faces, double squared_smallest_sine, std::size_t limit = std::size_t(-1)) const
  {
    const bool may_fail_angle = is_needle(squared_smallest_sine),
               may_fail_beside_boundary = squared_smallest_sine < share_of_far_below * m_squared_sine_of_criterion;
    std::size_t result = 0;
    for(const auto& face : faces) {
      if(face->state() == Face_state::GOOD)
        continue;
      const Mesh_2::Face_badness found = badness(face);
      face->set_state(found == Mesh_2::NOT_BAD ? Face_state::GOOD : Face_state::BLOCKED);
      if(found == Mesh_2::IMPERATIVELY_BAD)
        result += 1000;
      else if(found == Mesh_2::BAD && !may_fail_angle && !(may_fail_beside_boundary && is_beside_boundary(face)))
        ++result;
      if(result > limit)
        break;
    }
    return result;
  }

  // finds out their states
  template <class Faces>
  void examine(const Faces& faces) const
  {
    (*this)(faces, 1);
  }

private:
  // A face on the wrong side is worse than one with a small angle, which it may have, too.
  template <class Face_handle>
  Mesh_2::Face_badness badness(Face_handle face) const
  {
    if(is_collapsed(face))
      return Mesh_2::NOT_BAD;
    typename IsBad::Quality quality;
    const Mesh_2::Face_badness found = m_is_bad(face, quality);
    return found == Mesh_2::BAD && is_inverted(face, m_evaluate.oracle()) ? Mesh_2::IMPERATIVELY_BAD : found;
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
