// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_CRITERIA_WITH_OWN_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_CRITERIA_WITH_OWN_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/Triangle_view.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_judge.h>

#include <utility>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Where the user has no criterion.
struct No_triangle_criterion
{
  template <class Face_handle, class Oracle>
  double operator()(Face_handle, const Oracle&) const
  {
    return 0;
  }
};

// Shows the user's criterion what it may see of a face.
template <class Criterion>
class Viewing_criterion
{
  Criterion m_criterion;

public:
  explicit Viewing_criterion(Criterion criterion) : m_criterion(std::move(criterion)) {}

  template <class Face_handle, class Oracle>
  double operator()(Face_handle face, const Oracle& oracle) const
  {
    return m_criterion(Triangle_view<Face_handle, Oracle>(face, oracle));
  }
};

// The criteria that the user has filled in, with one of the user's own.
template <class Criterion>
class Criteria_with_own
  : public Parametric_surface_mesh_criteria
{
  Viewing_criterion<Criterion> m_own;

public:
  Criteria_with_own(const Parametric_surface_mesh_criteria& criteria, Criterion own)
    : Parametric_surface_mesh_criteria(criteria), m_own(std::move(own))
  {}

  const Viewing_criterion<Criterion>& own() const { return m_own; }
};

// The judge by some criteria. It refers to the oracle.
template <class Oracle>
Face_judge<Oracle, No_triangle_criterion> make_judge(const Oracle& oracle, const Parametric_surface_mesh_criteria& criteria)
{
  return Face_judge<Oracle, No_triangle_criterion>(oracle, criteria, No_triangle_criterion());
}

template <class Oracle, class Criterion>
Face_judge<Oracle, Viewing_criterion<Criterion>> make_judge(const Oracle& oracle, const Criteria_with_own<Criterion>& criteria)
{
  return Face_judge<Oracle, Viewing_criterion<Criterion>>(oracle, criteria, criteria.own());
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MEASURES_CRITERIA_WITH_OWN_H
