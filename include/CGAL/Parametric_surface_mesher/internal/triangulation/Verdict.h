// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_VERDICT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_VERDICT_H

#include <CGAL/Parametric_surface_mesher/Mesh_criterion.h>
#include <CGAL/assertions.h>

#include <cstdint>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// How much of a face was judged. Criteria come in this order, and most faces do not live to be judged by all of them.
enum class Scope : std::uint8_t
{
  NOTHING,
  SHAPE, // size, angle, and what the user asks for
  WHOLE
};

// What is known of a face: the criteria that it fails, as far as it was judged, and why the last attempt to mend it was
// refused. Until the last judgement a face that fails one need not have been judged by those after it.
class Verdict
{
  Criterion_set m_failed;
  std::uint8_t m_scope : 2;
  std::uint8_t m_refusal : 4; // a cause plus one, or 0

public:
  Verdict() : m_scope(0), m_refusal(0) {}
  Verdict(Criterion_set failed, Scope scope) : m_failed(failed), m_scope(std::uint8_t(scope) & 3), m_refusal(0) {}

  Criterion_set failed() const { return m_failed; }
  Scope scope() const { return Scope(m_scope); }

  bool is_known() const { return scope() != Scope::NOTHING; }
  bool fails() const { return !m_failed.empty(); }
  bool fails(Mesh_criterion criterion) const { return m_failed.contains(criterion); }

  // Whether it was judged by all criteria of the required scope, and fails none.
  bool meets(Scope required) const { return m_failed.empty() && scope() >= required; }

  bool is_refused() const { return m_refusal != 0; }
  Unmet_cause refusal() const
  {
    CGAL_assertion(is_refused());
    return Unmet_cause(m_refusal - 1);
  }
  void refuse(Unmet_cause cause) { m_refusal = std::uint8_t(int(cause) + 1) & 15; }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_VERDICT_H
