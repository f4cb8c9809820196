// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_PATCH_REFINEMENT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_PATCH_REFINEMENT_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/Mesh_criterion.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_judge.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Advancing_front.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Bad_face_queue.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Inner_points.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Position_search.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Mesh_progress.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/for_each_with_lookahead.h>

#include <cstddef>
#include <optional>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Refinement of a patch (paper, section "Procedure"): while a triangle is bad, a point is inserted for its sake. All
// triangles get a verdict, and those for which no point can be inserted the reason.
template <class Evaluator, class Judge>
class Patch_refinement
{
  typedef typename Evaluator::Kernel Kernel;
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef internal::Inner_points<Evaluator> Inner_points;
  typedef typename Inner_points::Candidate Candidate;

  Triangulation& m_triangulation;
  const Judge& m_judge;
  Patch_progress& m_progress;
  Inner_points m_points;
  Position_search<Evaluator> m_find_position;
  Bad_face_queue<Face_handle> m_queue;
  const std::size_t m_max_number_of_vertices;
  Scope m_scope = Scope::WHOLE; // of the judgements

public:
  Patch_refinement(Triangulation& triangulation, const Evaluator& evaluate, const Parametric_surface_mesh_criteria& criteria,
                   const Judge& judge, Patch_progress& progress)
    : m_triangulation(triangulation), m_judge(judge), m_progress(progress), m_points(triangulation, evaluate),
      m_find_position(m_points, evaluate, criteria),
      m_max_number_of_vertices(criteria.max_number_of_vertices())
  {}

  // The first points, from the boundary inwards.
  template <class Faces>
  void advance_front(const Faces& faces)
  {
    Advancing_front<Evaluator> advance(m_triangulation, m_points, m_max_number_of_vertices, m_progress);
    advance(faces);
  }

  // Refines until no triangle fails a criterion of the scope, as far as they can be met. Those of the shape cost little to
  // judge: most triangles on the way do not live to be judged whole.
  void operator()(Scope scope)
  {
    m_scope = scope;
    for_each_face_with_lookahead(m_triangulation, [this](Face_handle face) {
      if(face->is_in_domain() && !is_settled(face) && m_progress.go_further())
        examine(face);
    });
    for(std::size_t n = 1; m_progress.go_further(); ++n) {
      const Face_handle face = m_queue.pop();
      if(face == Face_handle())
        break;
      refine(face);
      if(n % 512 == 0)
        m_progress.on_progress(m_triangulation.number_of_vertices(), m_queue.size());
    }
  }

  // Why a face is left as it is, of which that was not noted: one that improvement has changed. Where a point would help, it
  // was the end of the work that kept it from being inserted.
  // \pre the face fails a criterion
  Unmet_cause why_left(Face_handle face)
  {
    if(m_progress.is_stopped())
      return Unmet_cause::STOPPED;
    if(is_full())
      return Unmet_cause::VERTEX_LIMIT;
    Candidate candidate;
    return m_find_position(face, candidate).value_or(Unmet_cause::WORK_LIMIT);
  }

  std::size_t number_of_replaced_tensors() const { return m_points.number_of_replaced_tensors(); }

  // how many walks and stars were given up
  std::size_t number_of_work_limits() const { return m_points.number_of_work_limits(); }

private:
  bool is_full() const { return m_triangulation.number_of_vertices() >= m_max_number_of_vertices; }

  // Whether nothing is to be said of a face that was not said before, since it has changed.
  bool is_settled(Face_handle face) const
  {
    const Verdict verdict = face->verdict();
    return verdict.scope() >= m_scope && (!verdict.fails() || verdict.is_refused());
  }

  void examine(Face_handle face)
  {
    const Judgement judgement = is_collapsed(face) ? Judgement() : judge(face);
    face->set_verdict({judgement.failed, m_scope});
    if(!judgement.failed.empty())
      m_queue.push(face, judgement.badness, urgency(judgement));
  }

  Judgement judge(Face_handle face) const
  {
    if(m_scope == Scope::SHAPE)
      return m_judge.judge_shape(face);
    if(face->verdict().meets(Scope::SHAPE)) {
      const Judgement deviation = m_judge.judge_deviation(face);
      return deviation.failed.empty() ? deviation : with_shape(deviation, m_judge.judge_shape(face));
    }
    const Judgement shape = m_judge.judge_shape(face);
    return shape.failed.empty() ? with_shape(m_judge.judge_deviation(face), shape) : shape;
  }

  static Judgement with_shape(Judgement deviation, const Judgement& shape)
  {
    deviation.is_well_shaped = shape.is_well_shaped;
    return deviation;
  }

  static Urgency urgency(const Judgement& judgement)
  {
    if(judgement.is_well_shaped)
      return Urgency::LAST;
    return judgement.failed.contains(Mesh_criterion::ANGLE) ? Urgency::NORMAL : Urgency::FIRST;
  }

  void refine(Face_handle face)
  {
    if(is_full()) {
      face->refuse(Unmet_cause::VERTEX_LIMIT);
      return;
    }
    Candidate candidate;
    if(const std::optional<Unmet_cause> refusal = m_find_position(face, candidate))
      face->refuse(*refusal);
    else
      insert(candidate);
  }

  // A face that was refused has another chance if one beside it has changed.
  void insert(Candidate& candidate)
  {
    m_points.insert(candidate);
    for(Face_handle face : m_points.star()) {
      examine(face);
      const Face_handle across = face->neighbor(0);
      if(across->verdict().is_refused())
        examine(across);
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_REFINEMENT_PATCH_REFINEMENT_H
