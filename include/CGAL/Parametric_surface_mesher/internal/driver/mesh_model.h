// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_MESH_MODEL_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_MESH_MODEL_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/curing/Mesh_curing.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Closeness_refinement.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Crossing_refinement.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Model_division.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Place_in_model.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Sizes_beside_strips.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Triangulated_boundary.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/Face_job.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/Faces_of_points.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/Meshed_faces.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/append_report.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/is_turned_by_division.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/make_oracles.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/set_default_sizes.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/values_of_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/model/Bad_faces.h>
#include <CGAL/Parametric_surface_mesher/internal/model/criteria_of_face.h>
#include <CGAL/Parametric_surface_mesher/internal/model/curve_box.h>
#include <CGAL/Parametric_surface_mesher/internal/model/Other_sides.h>
#include <CGAL/Parametric_surface_mesher/internal/model/name_face.h>
#include <CGAL/Parametric_surface_mesher/internal/model/shells_of_faces.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/output/append_division.h>
#include <CGAL/Parametric_surface_mesher/internal/output/append_other_sides.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Mesh_progress.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Parametric_surface_mesher/internal/support/for_each_index.h>
#include <CGAL/Parametric_surface_mesher/internal/support/run_jobs.h>
#include <CGAL/Parametric_surface_mesher/internal/surfaces/are_copies_independent.h>
#include <CGAL/Parametric_surface_model_3.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// From a model to its triangles: the division of the edges, then the faces, as jobs for a scheduler, then all together.
template <class Model, class Criteria, class MetricField>
class Model_mesher
{
public:
  typedef Parametric_surface_oracle_3<typename Model::Surface_3, MetricField> Oracle;
  typedef Model_division<Oracle> Division;
  typedef typename Model::Geom_traits Kernel;
  typedef Indexed_mesh<Kernel> Mesh;

private:
  typedef internal::Face_job<Oracle, Criteria> Face_job;
  typedef typename Face_job::Chords Chords;

  const Model& m_model;
  Criteria m_criteria;
  // Of the faces, copied for this run: what a surface remembers of its evaluation comes from this run alone, and from one
  // thread at a time.
  const std::vector<typename Model::Surface_3> m_surfaces;
  const std::vector<Oracle> m_oracles;
  std::vector<Triangulated_boundary<Oracle>> m_boundaries; // of the faces, if closeness has made them; a job takes its own
  Sizes_beside_strips m_sizes_beside_strips;
  std::vector<bool> m_are_reversed; // by face, as far as they are appended
  std::optional<Other_sides> m_other_sides; // once the edges are divided
  Mesh_progress& m_progress;
  Bad_faces& m_bad_faces;
  Meshed_faces<Kernel>* m_meshed_faces;
  Parametric_surface_mesh_report& m_report;
  std::vector<std::size_t> m_meeting_points;

public:
  // Faces without loops are left out. `meshed_faces`: of an earlier run, then of this one; a null pointer if none are kept
  Model_mesher(const Model& model, const Criteria& criteria, const MetricField& metric, Mesh_progress& progress,
               Bad_faces& bad_faces, Meshed_faces<Kernel>* meshed_faces, Parametric_surface_mesh_report& report)
    : m_model(model), m_criteria(criteria), m_surfaces(copy_surfaces(model)), m_oracles(make_oracles(model, m_surfaces, metric)),
      m_are_reversed(model.faces().size()), m_progress(progress), m_bad_faces(bad_faces), m_meshed_faces(meshed_faces), m_report(report)
  {
    set_default_sizes(m_criteria, model_diagonal(model));
    m_report.max_edge = m_criteria.max_edge();
    m_report.min_edge = m_criteria.min_edge();
  }

  Division divide()
  {
    Phase_timer timer(m_report.seconds.division);
    Patch_progress progress(m_progress);
    progress.on_phase("division");
    Division division(m_model, m_oracles, m_criteria, m_bad_faces, progress);
    Crossing_refinement<Oracle> refine(division, m_oracles, progress);
    refine();
    if(m_criteria.closeness() && progress.go_further()) {
      Closeness_refinement<Oracle> refine_narrow_faces(division, m_oracles, m_criteria, m_boundaries, refine, progress);
      m_report.number_of_edges_split_by_closeness = refine_narrow_faces();
      m_report.number_of_edges_added_to_thin_strips = refine_narrow_faces.thin_strips().number_of_pieces;
      m_sizes_beside_strips = refine_narrow_faces.thin_strips().sizes;
    }
    m_report.number_of_split_boundary_edges = refine.number_of_splits();
    m_bad_faces.check_that_some_are_good(m_model.faces().size());
    m_report.is_stopped = progress.is_stopped();
    return division;
  }

  // The mesh is the same with and without threads. `number_points`: gives the points of the division their indices
  // \pre the mesh is empty
  template <class ConcurrencyTag, class Numbering>
  void mesh_faces(Division& division, const Numbering& number_points, Mesh& mesh)
  {
    number_points(division);
    append_division(division, mesh);
    m_other_sides.emplace(m_model, m_bad_faces);
    std::vector<Face_job> jobs = make_jobs(division);
    const Faces_of_points faces_of_points = this->faces_of_points(jobs);
    run<ConcurrencyTag>(jobs, faces_of_points, mesh);
    keep_limit<ConcurrencyTag>(jobs, faces_of_points, mesh);
    split_common_chords<ConcurrencyTag>(jobs, mesh);
    leave_out_failed(jobs, division);
    append(jobs, mesh);
    remove_unused_points(division, number_points, mesh);
    m_meeting_points = internal::meeting_points(division);
    if(m_criteria.detail() && !m_report.is_stopped)
      cure(mesh);
    if(mesh.has_other_sides)
      append_other_sides(*m_other_sides, m_are_reversed, mesh, m_report);
    mesh.template finish<ConcurrencyTag>();
    m_report.number_of_boundary_edges = division.number_of_edges();
    m_report.number_of_faces = mesh.number_of_faces();
    m_report.left_out = m_bad_faces.left_out();
  }

  // Where several pieces of the mesh may meet: see `separate_pieces()`.
  // \pre the faces are meshed
  const std::vector<std::size_t>& meeting_points() const { return m_meeting_points; }

private:
  // One for each face, in their order, apart from those that are left out and those that are the other sides of others.
  std::vector<Face_job> make_jobs(const Division& division) const
  {
    std::vector<Face_job> result;
    for(std::size_t f = 0; f < m_model.faces().size(); ++f)
      if(!m_model.faces()[f].loops.empty() && !m_bad_faces.contains(f) && m_other_sides->front(f) == Other_sides::none) {
        result.emplace_back(f, division.boundary_loops(f), !are_copies_independent(m_model.faces()[f].surface));
        if(m_meshed_faces)
          if(auto meshed = m_meshed_faces->take(f, result.back().loops(), values_of_criteria(criteria_of(f))))
            result.back().keep(std::move(*meshed));
      }
    return result;
  }

  static Faces_of_points faces_of_points(const std::vector<Face_job>& jobs)
  {
    Faces_of_points result;
    for(const Face_job& job : jobs)
      result.add(job.face(), job.loops());
    result.finish();
    return result;
  }

  // Calls `function` with all jobs that have not failed: with threads those of the largest faces, by the edges of their
  // boundaries, first, else in their order. A job that fails notes its error. If that is going to be thrown, jobs of faces
  // after it need not be done. `function`: takes a concurrency tag, too
  template <class ConcurrencyTag, class Function>
  void for_each_job(std::vector<Face_job>& jobs, const Function& function) const
  {
    std::vector<Job> properties;
    for(const Face_job& job : jobs)
      properties.push_back({is_parallel<ConcurrencyTag>() ? double(job.number_of_boundary_vertices()) : 0., job.is_exclusive()});
    std::atomic<std::size_t> first_failed{jobs.size()};
    run_jobs<ConcurrencyTag>(properties, [&](std::size_t i) {
      if(jobs[i].error || first_failed < i)
        return;
      call<ConcurrencyTag>(jobs[i], function);
      if(jobs[i].error && !m_bad_faces.are_left_out())
        for(std::size_t first = first_failed; i < first && !first_failed.compare_exchange_weak(first, i);)
          continue;
    });
  }

  template <class ConcurrencyTag, class Function>
  void call(Face_job& job, const Function& function) const
  {
    try {
      with_name_of_face(m_model, job.face(), [&] {
        if(job.is_exclusive())
          function(Sequential_tag(), job);
        else
          function(ConcurrencyTag(), job);
      });
    }
    catch(...) {
      job.error = std::current_exception();
    }
  }

  template <class ConcurrencyTag>
  void run(std::vector<Face_job>& jobs, const Faces_of_points& faces_of_points, const Mesh& mesh)
  {
    std::size_t number_of_vertices = mesh.number_of_points(); // of the faces before, if these are done
    m_progress.begin_faces(jobs.size());
    for_each_job<ConcurrencyTag>(jobs, [&](auto tag, Face_job& job) {
      m_progress.on_face();
      run_and_collect(tag, job, number_of_vertices, faces_of_points, mesh);
      if(!is_parallel<ConcurrencyTag>())
        number_of_vertices += job.number_of_inner_vertices();
    });
  }

  // A face may have as many vertices as those before it have left. Where others were meshed at the same time it might have too
  // many: it and those after it are meshed once more.
  template <class ConcurrencyTag>
  void keep_limit(std::vector<Face_job>& jobs, const Faces_of_points& faces_of_points, const Mesh& mesh)
  {
    std::size_t number_of_vertices = mesh.number_of_points();
    for(Face_job& job : jobs) {
      if(!job.error && !job.is_stopped() && job.is_limited_by(limit_of_face(job, number_of_vertices)))
        call<ConcurrencyTag>(job, [&](auto tag, Face_job& again) {
          run_and_collect(tag, again, number_of_vertices, faces_of_points, mesh);
        });
      if(!job.error)
        number_of_vertices += job.number_of_inner_vertices();
    }
  }

  // A face that is kept from an earlier run is as if it were collected. Another one is collected at once, while its triangulation is in the
  // cache, and to be rid of that; unless it has a chord that may be that of another one. `number_of_vertices`: of the faces before
  template <class ConcurrencyTag>
  void run_and_collect(ConcurrencyTag, Face_job& job, std::size_t number_of_vertices, const Faces_of_points& faces_of_points,
                       const Mesh& mesh)
  {
    if(job.is_kept() && !job.is_limited_by(limit_of_face(job, number_of_vertices)) && !may_have_common_chord(job, faces_of_points, mesh))
      return;
    Criteria criteria = criteria_of(job.face());
    criteria.set_max_number_of_vertices(limit_of_face(job, number_of_vertices));
    job.template run<ConcurrencyTag>(m_oracles[job.face()], criteria, triangulated_boundary(job), m_progress);
    if(!may_have_common_chord(job, faces_of_points, mesh))
      job.template collect<ConcurrencyTag>(mesh);
  }

  // The criteria that a face is meshed by, once the edges are divided, but for its limit of vertices.
  Criteria criteria_of(std::size_t face) const
  {
    Criteria result = criteria_of_face(m_criteria, m_model.faces()[face]);
    m_sizes_beside_strips.set(face, result);
    return result;
  }

  std::size_t limit_of_face(const Face_job& job, std::size_t number_of_vertices) const
  {
    const std::size_t limit = m_criteria.max_number_of_vertices();
    return limit - (std::min)(limit, number_of_vertices) + job.number_of_boundary_vertices();
  }

  // of the face of a job, if closeness has one; not after a stop, when it may be behind the division
  Boundary_triangulation<Kernel> triangulated_boundary(const Face_job& job)
  {
    if(m_boundaries.empty() || m_progress.is_stopped())
      return {};
    Triangulated_boundary<Oracle>& boundary = m_boundaries[job.face()];
    boundary.update(m_oracles[job.face()], job.loops());
    return boundary.take();
  }

  // with another face, or an edge of the division
  bool may_have_common_chord(const Face_job& job, const Faces_of_points& faces_of_points, const Mesh& mesh) const
  {
    return has_chord_among_those_of(m_model.faces()[job.face()].shell, job, mesh)
           || (back(job) != Other_sides::none && has_chord_among_those_of(m_model.faces()[back(job)].shell, job, mesh))
           || std::any_of(job.chords().begin(), job.chords().end(), [&](const auto& chord) {
                return faces_of_points.have_other_common_face(chord.first, chord.second, job.face());
              });
  }

  static bool has_chord_among_those_of(std::size_t shell, const Face_job& job, const Mesh& mesh)
  {
    const auto chords = mesh.chords.find(shell);
    return chords != mesh.chords.end() && job.has_chord_among(chords->second);
  }

  // the other side of the face of a job, or none
  std::size_t back(const Face_job& job) const { return m_other_sides->back(job.face()); }

  // Sees to the jobs that are not collected, in their order.
  template <class ConcurrencyTag>
  void split_common_chords(std::vector<Face_job>& jobs, Mesh& mesh) const
  {
    for(Face_job& job : jobs)
      if(!job.error && !job.is_collected())
        call<ConcurrencyTag>(job, [&](auto, Face_job& waiting) { split_common_chords(waiting, mesh); });
    for_each_job<ConcurrencyTag>(jobs, [&](auto tag, Face_job& job) {
      if(!job.is_collected())
        job.template collect<decltype(tag)>(mesh);
    });
  }

  // With the other side of its face a job has two shells to look at.
  void split_common_chords(Face_job& job, Mesh& mesh) const
  {
    Chords& chords = mesh.chords[m_model.faces()[job.face()].shell];
    if(back(job) == Other_sides::none) {
      job.split_common_chords(chords);
      return;
    }
    Chords& behind = mesh.chords[m_model.faces()[back(job)].shell];
    Chords both = chords;
    both.insert(behind.begin(), behind.end());
    job.split_common_chords(both);
    chords = behind = both;
  }

  void leave_out_failed(std::vector<Face_job>& jobs, Division& division)
  {
    for(const Face_job& job : jobs)
      if(job.error)
        try {
          std::rethrow_exception(job.error);
        }
        catch(const Parametric_surface_mesh_error& error) {
          division.leave_out(m_bad_faces.add(error));
          if(back(job) != Other_sides::none)
            division.leave_out(m_bad_faces.add(Parametric_surface_mesh_error(
              "is the other side of " + numbered("face", job.face()) + ", which cannot be meshed", back(job))));
        }
    jobs.erase(std::remove_if(jobs.begin(), jobs.end(), [](const Face_job& job) { return bool(job.error); }), jobs.end());
    m_bad_faces.check_that_some_are_good(m_model.faces().size());
  }

  void append(std::vector<Face_job>& jobs, Mesh& mesh)
  {
    for(Face_job& job : jobs) {
      for(const auto& loop : job.loops())
        for(const auto& vertex : loop)
          mesh.domain_points[vertex.index] = vertex.domain_point;
      m_report.is_stopped = m_report.is_stopped || job.is_stopped();
      if(m_meshed_faces && job.may_be_kept())
        m_meshed_faces->keep(job.face(), job.loops(), job.meshed());
      append_report(job.result().report, 0, m_report);
      const std::size_t place_of_cuts = mesh.points.size();
      mesh.points.insert(mesh.points.end(), job.result().cut_points.begin(), job.result().cut_points.end());
      mesh.domain_points.insert(mesh.domain_points.end(), job.result().cut_domain_points.begin(),
                                job.result().cut_domain_points.end());
      mesh.places.resize(mesh.points.size(), {2, job.face(), Place_in_model::none});
      const auto& face = m_model.faces()[job.face()];
      const bool is_turned = is_turned_by_division(face, job.loops()), is_reversed = face.is_reversed != is_turned;
      m_are_reversed[job.face()] = is_reversed;
      if(back(job) != Other_sides::none)
        m_are_reversed[back(job)] = m_model.faces()[back(job)].is_reversed != is_turned;
      for(auto& part : job.result().parts) {
        part.mesh.patch = job.face();
        part.mesh.place_of_cuts = place_of_cuts;
        if(is_reversed)
          part.mesh.reverse();
        append_report(part.report, mesh.number_of_faces(), m_report);
        mesh.append(std::move(part.mesh));
      }
    }
  }

  void cure(Mesh& mesh)
  {
    Phase_timer timer(m_report.seconds.improvement);
    Patch_progress progress(m_progress);
    progress.on_phase("curing");
    Mesh_curing<Kernel, typename Model::Surface_3> curing(
      mesh, m_criteria, m_surfaces, shells_on_both_sides(m_model, *m_other_sides), m_are_reversed, m_meeting_points, m_report);
    curing([&] { return progress.go_further(); });
    m_meeting_points = curing.meeting_points();
    m_report.is_stopped = m_progress.is_stopped();
  }

  // Points that only faces have that were left out after their edges were divided.
  template <class Numbering>
  void remove_unused_points(Division& division, const Numbering& number_points, Mesh& mesh) const
  {
    if(m_bad_faces.is_empty())
      return;
    mesh.remove_points_of_division(are_points_used(division));
    number_points(division);
  }
};

template <class Model, class Criteria, class MetricField>
Model_mesher<Model, Criteria, MetricField>
make_model_mesher(const Model& model, const Criteria& criteria, const MetricField& metric, Mesh_progress& progress,
                  Bad_faces& bad_faces, Meshed_faces<typename Model::Geom_traits>* meshed_faces, Parametric_surface_mesh_report& report)
{
  return Model_mesher<Model, Criteria, MetricField>(model, criteria, metric, progress, bad_faces, meshed_faces, report);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_MESH_MODEL_H
