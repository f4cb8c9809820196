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
#include <CGAL/Parametric_surface_mesher/internal/partition/Meshed_patch.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Patch_mesher.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Patch_parts.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Patch_sketch.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Vertex_allowances.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/triangles_by_boundary.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Mesh_progress.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Phase_timer.h>
#include <CGAL/Parametric_surface_mesher/internal/support/for_each_index.h>
#include <CGAL/Parametric_surface_mesher/internal/support/run_jobs.h>
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

Patches with a singular point that have no chart stay whole, as do those whose loops touch, and those that would have many
more vertices than are allowed.
*/
template <class Oracle, class Criteria>
class Split_patch_mesher
{
  typedef Patch_mesher<Oracle, Criteria> Mesher;
  typedef typename Mesher::Kernel Kernel;
  typedef typename Mesher::Evaluator Evaluator;
  typedef typename Mesher::Triangulation Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef Boundary_loops<Kernel> Loops;
  typedef Boundary_vertex<Kernel> Shared_vertex; // of a cut; its index is that in the parts, none if it is not shared
  typedef typename Indexed_mesh<Kernel>::Chords Chords;
  typedef Partial_mesh<Kernel> Part;
  typedef Vertex_allowances::Allowance Allowance;

  static constexpr double triangles_in_sketch = 600; // of a patch just large enough to be split
  static constexpr double most_triangles_by_boundary = 3; // over the number that the boundary tells

  // of the time for improvement, for the parts and for the strips
  static constexpr double share_of_parts = 0.9, share_of_strips = 0.1;

  const Oracle& m_oracle;
  const Criteria m_criteria;
  const Charted_boundary<Kernel> m_boundary;
  Vertex_allowances m_allowances;
  Mesh_progress& m_run_progress;
  Patch_progress m_progress; // of what is done for the patch, not for a part
  std::vector<std::unique_ptr<Mesher>> m_parts; // with the strips, in the end
  std::vector<Shared_vertex> m_shared; // of parts and strips; by index, from the first index on
  std::size_t m_first_index = 0, m_number_of_inner_vertices = 0;
  Parametric_surface_mesh_report m_report;

public:
  // \pre no segments of the loops cross
  Split_patch_mesher(const Oracle& oracle, const Criteria& criteria, const Loops& loops, Mesh_progress& progress)
    : m_oracle(oracle), m_criteria(criteria), m_boundary(oracle.surface(), loops), m_run_progress(progress), m_progress(progress)
  {}

  // it refers to itself
  Split_patch_mesher(const Split_patch_mesher&) = delete;
  Split_patch_mesher& operator=(const Split_patch_mesher&) = delete;

  // Meshes the patch. `boundary`: a triangulation of the loops, if there is one
  template <class ConcurrencyTag>
  void operator()(Boundary_triangulation<Kernel> boundary)
  {
    if(m_progress.go_further() && may_be_split() && mesh_parts<ConcurrencyTag>())
      return;
    m_report.number_of_replaced_tensors = 0; // those of the sketch are counted once more
    m_parts.push_back(std::make_unique<Mesher>(m_oracle, m_criteria, m_boundary, m_boundary.loops(), no_vertex_index,
                                               m_run_progress));
    if(boundary.triangulation)
      (*m_parts.front())(std::move(boundary));
    else
      (*m_parts.front())();
    m_number_of_inner_vertices = m_parts.front()->number_of_inner_vertices();
    m_allowances.add({1., number_of_boundary_vertices(), m_number_of_inner_vertices});
  }

  // how the vertices that are allowed were shared out
  const Vertex_allowances& allowances() const { return m_allowances; }

  // Whether it is in parts that share points of cuts.
  bool has_cuts() const { return m_parts.size() > 1; }

  std::size_t number_of_inner_vertices() const { return m_number_of_inner_vertices; }

  // whether the visitor has stopped the run before the patch was done
  bool is_stopped() const
  {
    return std::any_of(m_parts.begin(), m_parts.end(), [](const auto& part) { return part->is_stopped(); });
  }

  // Splits chords of the patch that repeat others: those given, or one another. `chords`: what joins boundary vertices; those
  // of the patch are added. It may be done again, with more of them.
  void split_chords(Chords& chords)
  {
    if(has_cuts())
      for(const auto& part : m_parts)
        add_borders_at_cuts(part->triangulation(), chords);
    for(const auto& part : m_parts)
      part->split_chords(chords);
  }

  // Hands over the triangles, which then are gone from here.
  template <class ConcurrencyTag>
  Meshed_patch<Kernel> collect(bool keeps_domain_points, bool keeps_corner_points)
  {
    Meshed_patch<Kernel> result;
    result.report = m_report;
    for(const Shared_vertex& vertex : m_shared)
      if(vertex.index != no_vertex_index) {
        result.cut_points.push_back(vertex.surface_point);
        result.cut_domain_points.push_back(m_boundary.domain_point(vertex.domain_point));
      }
    std::vector<double> weights;
    for(const auto& part : m_parts)
      weights.push_back(double(part->triangulation().tds().number_of_faces()));
    result.parts.resize(m_parts.size());
    for_each_by_weight<ConcurrencyTag>(weights, [&](std::size_t i) {
      auto& part = result.parts[i];
      const std::unique_ptr<Mesher> mesher = std::move(m_parts[i]);
      part.mesh = mesher->collect(keeps_domain_points, keeps_corner_points, part.report);
    });
    return result;
  }

private:
  // The sides that parts share are edges of the mesh. On a patch that closes on itself, a chord of one part may join the same
  // vertices as a side of another one, on the other side of a seam.
  void add_borders_at_cuts(const Triangulation& triangulation, Chords& chords) const
  {
    for(Vertex_handle vertex : triangulation.finite_vertex_handles()) {
      if(!vertex->is_on_boundary() || vertex->index() < Part::first_cut_point)
        continue;
      auto face = triangulation.incident_faces(vertex);
      const auto first = face;
      do {
        const int i = face->index(vertex);
        if(face->is_in_domain() != face->neighbor(Triangulation::cw(i))->is_in_domain())
          chords.insert(std::minmax(vertex->index(), face->vertex(Triangulation::ccw(i))->index()));
      } while(++face != first);
    }
  }

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
    if(m_progress.is_stopped() || parts->regions().size() < 2)
      return false;
    std::vector<double> weights;
    for(const auto& region : parts->regions())
      weights.push_back(region.weight());
    const double total = std::accumulate(weights.begin(), weights.end(), 0.);
    if(Vertex_allowances::is_too_large(total, m_criteria.max_number_of_vertices()))
      return false;
    m_allowances.set_estimated_number_of_triangles(total);
    m_first_index = parts->first_index();
    m_parts.resize(weights.size());
    std::vector<Allowance> allowances;
    for(double weight : weights)
      allowances.push_back({weight / total, number_of_boundary_vertices() + parts->number_of_cut_points()});
    for_each_by_weight<ConcurrencyTag>(weights, [&](std::size_t i) {
      Loops loops = parts->regions()[i].boundary_loops();
      const std::size_t limit = number_of_vertices<Kernel>(loops) + allowed_number(allowances[i]);
      m_parts[i] = make_mesher(std::move(loops), share_of_parts * allowances[i].share, limit);
      (*m_parts[i])();
      allowances[i].number = m_parts[i]->number_of_inner_vertices();
    });
    for(const Allowance& allowance : allowances) {
      m_allowances.add(allowance);
      m_number_of_inner_vertices += allowance.number;
    }
    if(is_stopped())
      share_cuts(*parts);
    else
      join_parts<ConcurrencyTag>(*parts);
    number_shared_vertices<ConcurrencyTag>();
    return true;
  }

  std::size_t number_of_boundary_vertices() const { return number_of_vertices<Kernel>(m_boundary.loops()); }

  std::size_t allowed_number(const Allowance& allowance) const
  {
    return allowance.allowed_number(m_criteria.max_number_of_vertices());
  }

  std::unique_ptr<Patch_parts<Kernel>> split()
  {
    Phase_timer timer(m_report.seconds.triangulation);
    const typename Mesher::Surface surface(m_oracle.surface(), m_boundary.chart());
    const typename Mesher::Charted_oracle oracle(surface, m_oracle.metric(), m_oracle.singular_points());
    const Criteria criteria = chart_criteria(m_criteria, m_boundary.chart());
    const Evaluator evaluate(oracle, criteria, m_boundary.box());
    const double coarseness = (std::max)(2., std::sqrt(double(m_criteria.part_size()) / triangles_in_sketch));
    const Patch_sketch<Evaluator> sketch(evaluate, criteria, m_boundary.loops(), coarseness, m_progress);
    m_report.number_of_replaced_tensors = sketch.number_of_replaced_tensors();
    return std::make_unique<Patch_parts<Kernel>>(evaluate, sketch, m_boundary.loops(), double(m_criteria.part_size()),
                                                 m_progress);
  }

  // `share`: of the time for improvement
  std::unique_ptr<Mesher> make_mesher(Loops loops, double share, std::size_t max_number_of_vertices) const
  {
    Criteria criteria = m_criteria;
    if(std::isfinite(m_criteria.improvement_time())) // a share of 0 of an infinite time is not a number
      criteria.set_improvement_time(share * m_criteria.improvement_time());
    criteria.set_max_number_of_vertices(max_number_of_vertices);
    return std::make_unique<Mesher>(m_oracle, criteria, m_boundary, std::move(loops), m_first_index, m_run_progress);
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
    const std::size_t number_before
      = number_of_boundary_vertices() + parts.number_of_cut_points() + m_number_of_inner_vertices;
    std::vector<Allowance> allowances(meshers.size(), {1. / double(meshers.size()), number_before});
    for_each_by_weight<ConcurrencyTag>(strips.sizes(), [&](std::size_t i) {
      auto triangulation = std::make_unique<Triangulation>();
      const std::size_t number_on_border = strips.triangulate(i, *triangulation), number = triangulation->number_of_vertices();
      meshers[i] = make_mesher({}, share_of_strips / double(meshers.size()), number + allowed_number(allowances[i]));
      meshers[i]->triangulation().swap(*triangulation);
      meshers[i]->refine_and_improve(false);
      const std::size_t new_number = meshers[i]->triangulation().number_of_vertices();
      allowances[i].number = new_number - (std::min)(new_number, number); // repair may remove some
      numbers[i] = meshers[i]->number_of_inner_vertices() - number_on_border;
    });
    for_each_index<ConcurrencyTag>(m_parts.size(), [&](std::size_t i) { numbers_taken[i] = strips.close(i); });
    std::move(meshers.begin(), meshers.end(), std::back_inserter(m_parts));
    for(const Allowance& allowance : allowances)
      m_allowances.add(allowance);
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

  // Gives the vertices that parts and strips share their indices in the parts.
  template <class ConcurrencyTag>
  void number_shared_vertices()
  {
    std::size_t number = 0;
    for(Shared_vertex& vertex : m_shared)
      if(vertex.index != no_vertex_index)
        vertex.index = Part::first_cut_point + number++;
    m_number_of_inner_vertices += number;
    for_each_index<ConcurrencyTag>(m_parts.size(), [&](std::size_t i) {
      for(Vertex_handle vertex : m_parts[i]->triangulation().finite_vertex_handles())
        if(vertex->is_on_boundary() && vertex->index() >= m_first_index)
          vertex->set_index(m_shared[vertex->index() - m_first_index].index);
    });
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_SPLIT_PATCH_MESHER_H
