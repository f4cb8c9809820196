// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_PATCH_JUDGEMENT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_PATCH_JUDGEMENT_H

#include <CGAL/Parametric_surface_mesher/Mesh_criterion.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The last judgement on the faces of a patch: by every criterion, at every edge, also those that refinement can do nothing
// about. After it, a face that fails has the reason why it was left so.
template <class Kernel, class Judge, class Refinement>
class Patch_judgement
{
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;

  const Judge& m_judge;
  Refinement& m_refinement; // tells why faces were left
  const double m_squared_sine; // of the angle that was asked for, if that is more than the judge asks for, or 0

public:
  // `angle`: in degrees, asked for beyond what the judge asks for; 0 for none
  Patch_judgement(const Judge& judge, Refinement& refinement, double angle)
    : m_judge(judge), m_refinement(refinement), m_squared_sine(squared_sine_of_degrees(angle))
  {}

  void operator()(Face_handle face) const
  {
    judge(face);
    if(m_squared_sine > 0)
      judge_wanted_angle(face);
  }

  // The same on a patch that was not finished: who has stopped it does not want to wait for evaluations of the surface, so
  // faces are judged by their shapes alone unless they were judged whole before.
  void judge_after_stop(Face_handle face) const
  {
    const Verdict before = face->verdict();
    if(before.scope() == Scope::WHOLE && !before.fails()) {
      judge_wanted_angle(face);
      return;
    }
    Verdict verdict(before.failed() | m_judge.failed_by_shape(face), before.scope() == Scope::WHOLE ? Scope::WHOLE : Scope::SHAPE);
    if(verdict.fails())
      verdict.refuse(before.is_refused() ? before.refusal() : Unmet_cause::STOPPED);
    face->set_verdict(verdict);
    judge_wanted_angle(face);
  }

private:
  void judge(Face_handle face) const
  {
    if(face->verdict().scope() != Scope::WHOLE) // split since it was refined
      face->set_verdict({m_judge.first_failed(face), Scope::WHOLE});
    const Verdict before = face->verdict();
    if(before.meets(Scope::WHOLE) && can_refine_all_edges(face))
      return;
    const Criterion_set failed = before.fails() ? m_judge.failed(face) : m_judge.failed_at_other_edges(face);
    face->set_verdict({failed, Scope::WHOLE});
    if(before.is_refused())
      face->refuse(before.refusal());
    else if(before.fails())
      face->refuse(m_refinement.why_left(face));
    else if(!failed.empty())
      face->refuse(cause_at_edges(face));
  }

  void judge_wanted_angle(Face_handle face) const
  {
    if(m_squared_sine == 0 || face->verdict().fails(Mesh_criterion::ANGLE) || !m_judge.has_smaller_angle(face, m_squared_sine))
      return;
    const Verdict before = face->verdict();
    Verdict verdict(before.failed() | Mesh_criterion::ANGLE, before.scope());
    verdict.refuse(before.is_refused() ? before.refusal() : Unmet_cause::ANGLE_LIMIT);
    face->set_verdict(verdict);
  }

  bool can_refine_all_edges(Face_handle face) const
  {
    return m_judge.can_refine(face, 0) && m_judge.can_refine(face, 1) && m_judge.can_refine(face, 2);
  }

  // Of a face that refinement had nothing to say against: it is for edges that no point inside the patch makes better.
  Unmet_cause cause_at_edges(Face_handle face) const
  {
    for(int i = 0; i < 3; ++i)
      if(face->is_constrained(i) && !face->is_close(i) && is_on_true_boundary(face, i))
        return Unmet_cause::BOUNDARY;
    return Unmet_cause::MINIMUM_EDGE;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_PATCH_JUDGEMENT_H
