// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_MESH_MODEL_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_MESH_MODEL_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Closeness_refinement.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Crossing_refinement.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Model_division.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Triangulated_boundary.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/Faces_of_points.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/append_report.h>
#include <CGAL/Parametric_surface_mesher/internal/model/criteria_of_face.h>
#include <CGAL/Parametric_surface_mesher/internal/model/curve_box.h>
#include <CGAL/Parametric_surface_mesher/internal/model/name_face.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Partial_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/output/append_division.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Split_patch_mesher.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Synchronized_visitor.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Parametric_surface_mesher/internal/support/for_each_by_weight.h>
#include <CGAL/Parametric_surface_mesher/internal/support/for_each_index.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Parametric_surface_oracle_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Fills in the sizes that the user left open.
inline void set_default_sizes(Parametric_surface_mesh_criteria& criteria, double diagonal)
{
  if(!(diagonal > 0) || !std::isfinite(diagonal))
    throw Parametric_surface_mesh_error("the surface is degenerate: its boundary is a point in space");
  if(!criteria.sizing().max_edge)
    criteria.set_max_edge(diagonal / 20);
  if(!criteria.sizing().min_edge)
    criteria.set_min_edge((std::min)(criteria.max_edge(), diagonal / 20) / 200);
  if(criteria.min_edge() > criteria.max_edge())
    throw Parametric_surface_mesh_error("the minimum edge length " + describe(criteria.min_edge())
                                        + " is larger than the maximum edge length " + describe(criteria.max_edge()));
}

// The oracles of the faces of a model.
template <class Surface, class MetricField>
std::vector<Parametric_surface_oracle_3<Surface, MetricField>>
make_oracles(const Parametric_surface_model_3<Surface>& model, const MetricField& metric)
{
  std::vector<Parametric_surface_oracle_3<Surface, MetricField>> result;
  for(const auto& face : model.faces()) {
    std::vector<typename Surface::Geom_traits::Point_3> singular_points;
    for(const auto& loop : face.loops)
      for(const auto& use : loop)
        if(model.edges()[use.edge].is_collapsed)
          singular_points.push_back(model.vertices()[model.edges()[use.edge].source]);
    result.emplace_back(face.surface, metric, std::move(singular_points));
  }
  return result;
}

// From a model to its triangles: the division of the edges, then face by face.
template <class Model, class Criteria, class MetricField, class Visitor>
class Model_mesher
{
public:
  typedef Parametric_surface_oracle_3<typename Model::Surface_3, MetricField> Oracle;
  typedef Model_division<Oracle> Division;
  typedef Indexed_mesh<typename Model::Geom_traits> Mesh;

private:
  const Model& m_model;
  Criteria m_criteria;
  Synchronized_visitor<Visitor> m_visitor;
  std::vector<Oracle> m_oracles;
  std::vector<Triangulated_boundary<Oracle>> m_boundaries; // of the faces, or none; each is used up by the mesh of its face
  Parametric_surface_mesh_report& m_report;

public:
  Model_mesher(const Model& model, const Criteria& criteria, const MetricField& metric, Visitor& visitor,
               Parametric_surface_mesh_report& report)
    : m_model(model), m_criteria(criteria), m_visitor(visitor), m_oracles(make_oracles(model, metric)), m_report(report)
  {
    set_default_sizes(m_criteria, model_diagonal(model));
    m_report.max_edge = m_criteria.max_edge();
    m_report.min_edge = m_criteria.min_edge();
  }

  Division divide()
  {
    Phase_timer timer(m_report.seconds.division);
    m_visitor.on_phase("division");
    Division division(m_model, m_oracles, m_criteria);
    Crossing_refinement<Oracle> refine(division, m_oracles);
    refine();
    if(m_criteria.closeness()) {
      Closeness_refinement<Oracle> refine_narrow_faces(division, m_oracles, m_criteria, m_boundaries, refine);
      m_report.number_of_edges_split_by_closeness = refine_narrow_faces();
    }
    m_report.number_of_split_boundary_edges = refine.number_of_splits();
    m_report.number_of_boundary_edges = division.number_of_edges();
    return division;
  }

  // The mesh is the same with and without threads.
  // \pre the mesh is empty
  template <class ConcurrencyTag>
  void mesh_faces(const Division& division, Mesh& mesh)
  {
    append_division(division, mesh);
    if(!is_parallel<ConcurrencyTag>())
      mesh_one_by_one<ConcurrencyTag>(division, mesh);
    else if(!mesh_faces_at_the_same_time<ConcurrencyTag>(division, mesh)) {
      divide(); // the same once more: the triangulations of the boundaries are used up
      mesh_one_by_one<ConcurrencyTag>(division, mesh);
    }
    mesh.template finish<ConcurrencyTag>();
    m_report.number_of_faces = mesh.number_of_faces();
  }

private:
  typedef Split_patch_mesher<Oracle, Criteria, Synchronized_visitor<Visitor>> Face_mesher;

  typedef typename Model::Geom_traits Kernel;
  typedef Boundary_loops<Kernel> Loops;

  // a part of a face
  struct Part
  {
    Partial_mesh<typename Model::Geom_traits> mesh;
    Parametric_surface_mesh_report report;
  };

  // a face that is meshed, maybe while others are
  struct Task
  {
    std::size_t face, number_of_vertices; // the number that the mesh has before
    Loops loops;
    std::unique_ptr<Face_mesher> mesher;
    typename Mesh::Chords chords; // of a face that is not in parts
    std::vector<Part> parts;      // as far as they are collected
    std::exception_ptr error;
  };

  template <class ConcurrencyTag>
  void mesh_one_by_one(const Division& division, Mesh& mesh)
  {
    for(std::size_t f = 0; f < m_model.faces().size(); ++f)
      if(!m_model.faces()[f].loops.empty()) { // else it was left out
        std::vector<Task> tasks(1);
        tasks.front().face = f;
        tasks.front().loops = division.boundary_loops(f);
        tasks.front().number_of_vertices = mesh.number_of_points();
        run<ConcurrencyTag>(tasks.front());
        collect<ConcurrencyTag>(tasks, mesh);
      }
  }

  // Returns false, with the mesh as it was, if there are as many vertices as are allowed: then each face may have but what
  // those before it have left.
  template <class ConcurrencyTag>
  bool mesh_faces_at_the_same_time(const Division& division, Mesh& mesh)
  {
    std::vector<Task> tasks = tasks_by_size(division, mesh.number_of_points());
    const Faces_of_points faces_of_points = this->faces_of_points(tasks);
    for_each_index<ConcurrencyTag>(tasks.size(), [&](std::size_t i) {
      run_and_collect<ConcurrencyTag>(tasks[i], faces_of_points, mesh);
    });
    std::sort(tasks.begin(), tasks.end(), [](const Task& a, const Task& b) { return a.face < b.face; });
    std::size_t number_of_vertices = mesh.number_of_points();
    for(const Task& task : tasks)
      if(!task.error)
        number_of_vertices += task.mesher->number_of_inner_vertices();
    if(number_of_vertices >= m_criteria.max_number_of_vertices())
      return false;
    collect<ConcurrencyTag>(tasks, mesh);
    return true;
  }

  // the largest faces, by the edges of their boundaries, first
  std::vector<Task> tasks_by_size(const Division& division, std::size_t number_of_vertices) const
  {
    std::vector<Task> result;
    for(std::size_t f = 0; f < m_model.faces().size(); ++f)
      if(!m_model.faces()[f].loops.empty())
        result.push_back({f, number_of_vertices, division.boundary_loops(f), nullptr, {}, {}, nullptr});
    std::stable_sort(result.begin(), result.end(), [](const Task& a, const Task& b) {
      return internal::number_of_vertices<Kernel>(a.loops) > internal::number_of_vertices<Kernel>(b.loops);
    });
    return result;
  }

  template <class ConcurrencyTag>
  void run(Task& task)
  {
    with_name_of_face(m_model, task.face, [&] {
      const Criteria criteria = criteria_of_face(task.face, task.loops, task.number_of_vertices);
      task.mesher = std::make_unique<Face_mesher>(m_oracles[task.face], criteria, task.loops, m_visitor);
      task.mesher->template run<ConcurrencyTag>(triangulated_boundary(task));
      if(task.mesher->is_whole())
        task.chords = task.mesher->own_chords();
    });
  }

  // of the face of a task, if closeness has one
  Boundary_triangulation<Kernel> triangulated_boundary(const Task& task)
  {
    if(m_boundaries.empty())
      return {};
    Triangulated_boundary<Oracle>& boundary = m_boundaries[task.face];
    boundary.update(m_oracles[task.face], task.loops);
    return boundary.take();
  }

  // A face that is not in parts is collected at once, while its triangulation is in the cache, and to be rid of that; unless
  // it has a chord that may be that of another one.
  template <class ConcurrencyTag>
  void run_and_collect(Task& task, const Faces_of_points& faces_of_points, const Mesh& mesh) noexcept
  {
    try {
      run<ConcurrencyTag>(task);
      if(!task.mesher->is_whole() || may_have_common_chord(task, faces_of_points, mesh))
        return;
      task.parts.resize(1);
      collect(task, 0, mesh);
    }
    catch(...) {
      task.error = std::current_exception();
    }
  }

  // \pre the tasks are in the order of their faces
  template <class ConcurrencyTag>
  void collect(std::vector<Task>& tasks, Mesh& mesh)
  {
    std::vector<std::pair<Task*, std::size_t>> parts; // to be collected
    std::vector<double> weights;
    for(Task& task : tasks) {
      prepare<ConcurrencyTag>(task, mesh);
      for(std::size_t i = task.parts.size(); i < task.mesher->number_of_parts(); ++i) {
        parts.emplace_back(&task, i);
        weights.push_back(double(task.mesher->number_of_triangles(i)));
      }
      task.parts.resize(task.mesher->number_of_parts());
    }
    for_each_by_weight<ConcurrencyTag>(weights, [&](std::size_t i) { collect(*parts[i].first, parts[i].second, mesh); });
    for(Task& task : tasks)
      for(Part& part : task.parts) {
        append_report(part.report, mesh.number_of_faces(), m_report);
        mesh.append(std::move(part.mesh));
      }
  }

  void collect(Task& task, std::size_t number, const Mesh& mesh) const
  {
    Part& part = task.parts[number];
    part.mesh = with_name_of_face(m_model, task.face, [&] { return task.mesher->collect(number, mesh, part.report); });
    part.mesh.patch = task.face;
    if(m_model.faces()[task.face].is_reversed)
      part.mesh.reverse();
  }

  static Faces_of_points faces_of_points(const std::vector<Task>& tasks)
  {
    Faces_of_points result;
    for(const Task& task : tasks)
      result.add(task.face, task.loops);
    result.finish();
    return result;
  }

  // with another face, or an edge of the division
  bool may_have_common_chord(const Task& task, const Faces_of_points& faces_of_points, const Mesh& mesh) const
  {
    const auto division = mesh.chords.find(m_model.faces()[task.face].shell);
    return (division != mesh.chords.end() && has_common_chord(task.chords, division->second))
           || std::any_of(task.chords.begin(), task.chords.end(), [&](const auto& chord) {
                return faces_of_points.have_other_common_face(chord.first, chord.second, task.face);
              });
  }

  // What cannot be done for several faces at the same time.
  template <class ConcurrencyTag>
  void prepare(Task& task, Mesh& mesh)
  {
    if(task.error)
      std::rethrow_exception(task.error);
    for(const auto& loop : task.loops)
      for(const auto& vertex : loop)
        mesh.domain_points[vertex.index] = vertex.domain_point;
    typename Mesh::Chords& chords = mesh.chords[m_model.faces()[task.face].shell];
    if(task.mesher->is_whole() && !has_common_chord(task.chords, chords)) {
      chords.insert(task.chords.begin(), task.chords.end());
      task.mesher->add_to(m_report);
      return;
    }
    CGAL_assertion(task.parts.empty());
    with_name_of_face(m_model, task.face, [&] { task.mesher->template prepare<ConcurrencyTag>(mesh, chords, m_report); });
  }

  static bool has_common_chord(const typename Mesh::Chords& chords, const typename Mesh::Chords& others)
  {
    return std::any_of(chords.begin(), chords.end(), [&](const auto& chord) { return others.count(chord) > 0; });
  }

  // the number of vertices is limited for all faces together
  Criteria criteria_of_face(std::size_t face, const Loops& loops, std::size_t number_of_vertices) const
  {
    const std::size_t limit = m_criteria.max_number_of_vertices(), own = internal::number_of_vertices<Kernel>(loops);
    Criteria result = internal::criteria_of_face(m_criteria, m_model.faces()[face]);
    result.set_max_number_of_vertices(limit - (std::min)(limit, number_of_vertices) + own);
    return result;
  }
};

template <class Model, class Criteria, class MetricField, class Visitor>
Model_mesher<Model, Criteria, MetricField, Visitor>
make_model_mesher(const Model& model, const Criteria& criteria, const MetricField& metric, Visitor& visitor,
                  Parametric_surface_mesh_report& report)
{
  return Model_mesher<Model, Criteria, MetricField, Visitor>(model, criteria, metric, visitor, report);
}

// The shells of the faces of a model.
template <class Model>
std::vector<std::size_t> shells(const Model& model)
{
  std::vector<std::size_t> result;
  for(const auto& face : model.faces())
    result.push_back(face.shell);
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_MESH_MODEL_H
