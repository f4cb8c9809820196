// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_GUARDED_CHANGE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_GUARDED_CHANGE_H

#include <CGAL/Parametric_surface_mesher/internal/improvement/Failure_count.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Transaction.h>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A change for the sake of the smallest angle of some faces, that is taken back where it makes more of them fail.
template <class Triangulation, class Judge>
class Guarded_change
{
  const Failure_count<Judge>& m_number_of_failures;
  Transaction<Triangulation> m_transaction;
  double m_squared_sine = 0;
  Failures m_failures_before;

public:
  explicit Guarded_change(const Failure_count<Judge>& number_of_failures) : m_number_of_failures(number_of_failures) {}

  // `faces`: all that will change; `squared_sine`: of their smallest angle
  template <class Faces>
  void begin(const Faces& faces, double squared_sine)
  {
    m_squared_sine = squared_sine;
    m_failures_before = m_number_of_failures(faces, squared_sine);
    m_transaction.begin(faces);
  }

  // by which the change is made
  Transaction<Triangulation>& transaction() { return m_transaction; }

  // Whether no more fail than before, where `faces` are what those before it have become.
  template <class Faces>
  bool is_allowed(const Faces& faces) const
  {
    return !m_number_of_failures(faces, m_squared_sine, m_failures_before).are_more_than(m_failures_before);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_GUARDED_CHANGE_H
