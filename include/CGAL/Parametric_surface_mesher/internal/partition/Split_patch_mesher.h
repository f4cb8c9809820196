// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_SPLIT_PATCH_MESHER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_SPLIT_PATCH_MESHER_H

#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Charted_boundary.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Cut_strips.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Patch_mesher.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Patch_parts.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Patch_sketch.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/triangles_by_boundary.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Phase_timer.h>
#include <CGAL/Parametric_surface_mesher/internal/support/for_each_by_weight.h>
#include <CGAL/Parametric_surface_mesher/internal/support/for_each_index.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Meshes a patch: whole or, if it is large, cut into parts that are meshed at the same time and then joined. The strips along
the cuts are improved once more with the points of the cuts as inner vertices, so that no trace of them is left. The mesh
depends neither on the number of threads nor on their order.

Patches with a singular point that have no chart stay whole, as do those whose loops touch, and those that may have as many
vertices as are allowed.
*/
template <class Oracle, class Criteria, class Visitor>
class Split_patch_mesher
{
  typedef Patch_mesher<Oracle, Criteria, Visitor> Mesher;
  typedef typename Mesher::Kernel Kernel;
  typedef typename Mesher::Evaluator Evaluator;
  typedef typename Mesher::Triangulation Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef Boundary_loops<Kernel> Loops;
  typedef Boundary_vertex<Kernel> Shared_vertex; // its index is that in the mesh, once it is there; none if not shared

  static constexpr double triangles_in_sketch = 600; // of a patch just large enough to be split
  static constexpr double most_triangles_by_boundary = 3; // over the number that the boundary tells

  const Oracle& m_oracle;
  const Criteria m_criteria;
  const Charted_boundary<Kernel> m_boundary;
  Visitor& m_visitor;
  std::vector<std::unique_ptr<Mesher>> m_parts; // with the strips, in the end
  bool m_is_whole = false;                      // then there is one part
  std::vector<Shared_vertex> m_shared; // of parts and strips; by index, from the first index on
  std::size_t m_first_index = 0, m_number_of_inner_vertices = 0;
  bool m_is_stopped = false;
  Parametric_surface_mesh_report m_report;

public:
  // \pre no segments of the loops cross
  Split_patch_mesher(const Oracle& oracle, const Criteria& criteria, const Loops& loops, Visitor& visitor)
    : m_oracle(oracle), m_criteria(criteria), m_boundary(oracle.surface(), loops), m_visitor(visitor)
  {}

  // it refers to itself
  Split_patch_mesher(const Split_patch_mesher&) = delete;
  Split_patch_mesher& operator=(const Split_patch_mesher&) = delete;

  // `boundary`: a triangulation of the loops, if there is one
  template <class ConcurrencyTag>
  void run(Boundary_triangulation<Kernel> boundary)
  {
    if(may_be_split() && mesh_parts<ConcurrencyTag>())
      return;
    m_parts.clear();
    m_shared.clear();
    m_is_whole = true;
    m_report.number_of_replaced_tensors = 0; // of the sketch
    m_parts.push_back(std::make_unique<Mesher>(m_oracle, m_criteria, m_boundary, m_boundary.loops(), no_vertex_index, m_visitor));
    if(boundary.triangulation)
      (*m_parts.front())(std::move(boundary));
    else
      (*m_parts.front())();
    m_number_of_inner_vertices = m_parts.front()->number_of_inner_vertices();
  }

  std::size_t number_of_inner_vertices() const { return m_number_of_inner_vertices; }

  // else it is in parts
  bool is_whole() const { return m_is_whole; }

  // Of a patch that is whole: none is left twice in the patch.
  typename Indexed_mesh<Kernel>::Chords own_chords()
  {
    typename Indexed_mesh<Kernel>::Chords result;
    m_parts.front()->split_chords(result);
    return result;
  }

  // Makes all ready to be collected: puts points that parts share into the mesh, and splits chords.
  // `chords`: what joins boundary vertices of the patch's shell
  template <class ConcurrencyTag>
  void prepare(Indexed_mesh<Kernel>& mesh, typename Indexed_mesh<Kernel>::Chords& chords,
               Parametric_surface_mesh_report& report)
  {
    add_to(report);
    for(Shared_vertex& vertex : m_shared) {
      if(vertex.index == no_vertex_index)
        continue;
      vertex.index = mesh.points.size();
      mesh.points.push_back(vertex.surface_point);
      mesh.domain_points.push_back(m_boundary.domain_point(vertex.domain_point));
    }
    for_each_index<ConcurrencyTag>(m_parts.size(), [&](std::size_t i) {
      if(!m_is_whole)
        number_shared_vertices(m_parts[i]->triangulation());
    });
    for(const auto& part : m_parts)
      part->split_chords(chords);
  }

  // of what is not told of the parts
  void add_to(Parametric_surface_mesh_report& report) const
  {
    report.seconds += m_report.seconds;
    report.number_of_replaced_tensors += m_report.number_of_replaced_tensors;
  }

  std::size_t number_of_parts() const { return m_parts.size(); }

  // about as many, for a part
  std::size_t number_of_triangles(std::size_t part) const { return m_parts[part]->triangulation().tds().number_of_faces(); }

  // Collects the triangles of a part, which then is gone. This may be done for several at the same time.
  // \pre `prepare()` was called, or the patch is whole
  Partial_mesh<Kernel> collect(std::size_t part, const Indexed_mesh<Kernel>& mesh, Parametric_surface_mesh_report& report)
  {
    const std::unique_ptr<Mesher> mesher = std::move(m_parts[part]);
    return mesher->collect(mesh, report);
  }

private:
  // Cheap tests. The number of triangles is bounded by that of the boundary's edges, and by their lengths, unless spacing is
  // much smaller inside.
  bool may_be_split() const
  {
    const double number_of_edges = double(number_of_vertices<Kernel>(m_boundary.loops()));
    const double part_size = double(m_criteria.part_size());
    const bool has_chart = !m_boundary.chart().is_identity();
    if(part_size == 0 || (!has_chart && !m_oracle.singular_points().empty())
       || 0.5 * number_of_edges * number_of_edges < part_size)
      return false;
    if(!has_chart && most_triangles_by_boundary * number_of_triangles_by_boundary(m_oracle, m_boundary.loops()) < part_size)
      return false;
    std::set<typename Kernel::Point_2> points;
    for(const auto& loop : m_boundary.loops())
      for(const auto& vertex : loop)
        if(!points.insert(vertex.domain_point).second)
          return false;
    return true;
  }

  // Returns false if there are no parts, or there would be too many vertices.
  template <class ConcurrencyTag>
  bool mesh_parts()
  {
    const std::unique_ptr<Patch_parts<Kernel>> parts = split();
    if(parts->regions().size() < 2)
      return false;
    std::vector<double> weights;
    for(const auto& region : parts->regions())
      weights.push_back(region.weight());
    const double total = std::accumulate(weights.begin(), weights.end(), 0.);
    if(total / 2 > 2 * double(m_criteria.max_number_of_vertices()))
      return false;
    m_first_index = parts->first_index();
    m_parts.resize(weights.size());
    for_each_by_weight<ConcurrencyTag>(weights, [&](std::size_t i) {
      m_parts[i] = make_mesher(parts->regions()[i].boundary_loops(), 0.9 * weights[i] / total);
      (*m_parts[i])();
    });
    for(const auto& part : m_parts) {
      m_number_of_inner_vertices += part->number_of_inner_vertices();
      m_is_stopped = m_is_stopped || part->refinement().is_stopped();
    }
    if(m_is_stopped)
      share_cuts(*parts);
    else
      join_parts<ConcurrencyTag>(*parts);
    for(const Shared_vertex& vertex : m_shared)
      m_number_of_inner_vertices += vertex.index != no_vertex_index;
    return m_number_of_inner_vertices + number_of_vertices<Kernel>(m_boundary.loops()) < m_criteria.max_number_of_vertices();
  }

  std::unique_ptr<Patch_parts<Kernel>> split()
  {
    Phase_timer timer(m_report.seconds.triangulation);
    const typename Mesher::Surface surface(m_oracle.surface(), m_boundary.chart());
    const typename Mesher::Charted_oracle oracle(surface, m_oracle.metric(), m_oracle.singular_points());
    const Criteria criteria = chart_criteria(m_criteria, m_boundary.chart());
    const Evaluator evaluate(oracle, criteria, m_boundary.box());
    const double coarseness = (std::max)(2., std::sqrt(double(m_criteria.part_size()) / triangles_in_sketch));
    const Patch_sketch<Evaluator> sketch(evaluate, criteria, m_boundary.loops(), coarseness);
    m_report.number_of_replaced_tensors = sketch.number_of_replaced_tensors();
    return std::make_unique<Patch_parts<Kernel>>(evaluate, sketch, m_boundary.loops(), double(m_criteria.part_size()));
  }

  // `share`: of the time for improvement
  std::unique_ptr<Mesher> make_mesher(Loops loops, double share) const
  {
    Criteria criteria = m_criteria;
    if(std::isfinite(m_criteria.improvement_time())) // a share of 0 of an infinite time is not a number
      criteria.set_improvement_time(share * m_criteria.improvement_time());
    return std::make_unique<Mesher>(m_oracle, criteria, m_boundary, std::move(loops), m_first_index, m_visitor);
  }

  template <class ConcurrencyTag>
  void join_parts(const Patch_parts<Kernel>& parts)
  {
    std::vector<Triangulation*> triangulations;
    for(const auto& part : m_parts)
      triangulations.push_back(&part->triangulation());
    Cut_strips<Kernel> strips(parts, std::move(triangulations));
    for_each_index<ConcurrencyTag>(m_parts.size(), [&](std::size_t i) { strips.take_out(i); });
    strips.connect();
    std::vector<std::unique_ptr<Mesher>> meshers(strips.sizes().size()); // of the strips
    std::vector<std::size_t> numbers(meshers.size()), numbers_taken(m_parts.size());
    for_each_by_weight<ConcurrencyTag>(strips.sizes(), [&](std::size_t i) {
      meshers[i] = make_mesher({}, 0.1 / double(meshers.size()));
      const std::size_t number_on_border = strips.triangulate(i, meshers[i]->triangulation());
      meshers[i]->refine_and_improve(false);
      numbers[i] = meshers[i]->number_of_inner_vertices() - number_on_border;
    });
    for_each_index<ConcurrencyTag>(m_parts.size(), [&](std::size_t i) { numbers_taken[i] = strips.close(i); });
    std::move(meshers.begin(), meshers.end(), std::back_inserter(m_parts));
    m_number_of_inner_vertices += std::accumulate(numbers.begin(), numbers.end(), std::size_t(0));
    m_number_of_inner_vertices -= std::accumulate(numbers_taken.begin(), numbers_taken.end(), std::size_t(0));
    for(std::size_t i = 0; i < strips.border().size(); ++i) {
      const auto& point = strips.border()[i];
      m_shared.push_back({point.domain_point(), point.surface_point(), strips.is_on_border(i) ? 0 : no_vertex_index});
    }
  }

  // when there are no strips
  void share_cuts(const Patch_parts<Kernel>& parts)
  {
    m_shared.resize(parts.number_of_cut_points());
    for(const auto& region : parts.regions())
      for(const auto& loop : region.loops)
        for(const Shared_vertex& vertex : loop)
          if(vertex.index >= m_first_index)
            m_shared[vertex.index - m_first_index] = {vertex.domain_point, vertex.surface_point, 0};
  }

  void number_shared_vertices(Triangulation& triangulation) const
  {
    for(Vertex_handle vertex : triangulation.finite_vertex_handles())
      if(vertex->is_on_boundary() && vertex->index() >= m_first_index)
        vertex->set_index(m_shared[vertex->index() - m_first_index].index);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_SPLIT_PATCH_MESHER_H
