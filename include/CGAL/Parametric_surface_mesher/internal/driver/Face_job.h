// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_FACE_JOB_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_FACE_JOB_H

#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Meshed_patch.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Split_patch_mesher.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Vertex_allowances.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Mesh_progress.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/triangulate_boundary.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iterator>
#include <memory>
#include <utility>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The meshing of one face of a model: from its divided boundary to its triangles, with nothing else that changes. So jobs run
// at the same time, in any order.
template <class Oracle, class Criteria>
class Face_job
{
public:
  typedef typename Oracle::Geom_traits Kernel;
  typedef typename Indexed_mesh<Kernel>::Chords Chords;

private:
  typedef Split_patch_mesher<Oracle, Criteria> Mesher;

  std::size_t m_face;
  Boundary_loops<Kernel> m_loops;
  bool m_is_exclusive;
  std::size_t m_max_number_of_vertices = 0, m_number_of_inner_vertices = 0;
  Vertex_allowances m_allowances;
  bool m_is_stopped = false;
  std::unique_ptr<Mesher> m_mesher; // until its triangles are collected
  Chords m_chords;
  Meshed_patch<Kernel> m_result;

public:
  std::exception_ptr error; // if it has failed

  // `loops`: the divided boundary in the domain. `is_exclusive`: see `run_jobs()`
  Face_job(std::size_t face, Boundary_loops<Kernel> loops, bool is_exclusive)
    : m_face(face), m_loops(std::move(loops)), m_is_exclusive(is_exclusive)
  {}

  std::size_t face() const { return m_face; }
  const Boundary_loops<Kernel>& loops() const { return m_loops; }
  bool is_exclusive() const { return m_is_exclusive; }
  std::size_t number_of_boundary_vertices() const { return number_of_vertices<Kernel>(m_loops); }

  // Meshes the face; may be called again. `boundary`: a triangulation of the loops, if there is one
  template <class ConcurrencyTag>
  void run(const Oracle& oracle, const Criteria& criteria, Boundary_triangulation<Kernel> boundary, Mesh_progress& progress)
  {
    m_max_number_of_vertices = criteria.max_number_of_vertices();
    m_chords.clear();
    m_mesher = std::make_unique<Mesher>(oracle, criteria, m_loops, progress);
    m_mesher->template operator()<ConcurrencyTag>(std::move(boundary));
    m_number_of_inner_vertices = m_mesher->number_of_inner_vertices();
    m_allowances = m_mesher->allowances();
    m_is_stopped = m_mesher->is_stopped();
    m_mesher->split_chords(m_chords);
  }

  // Whether the mesh would be another one if no more vertices were allowed than `limit`.
  // \pre it is run
  bool is_limited_by(std::size_t limit) const { return limit != m_max_number_of_vertices && m_allowances.is_limited_by(limit); }

  std::size_t number_of_inner_vertices() const { return m_number_of_inner_vertices; }
  bool is_stopped() const { return m_is_stopped; }

  // inner edges between boundary vertices
  const Chords& chords() const { return m_chords; }

  bool has_chord_among(const Chords& chords) const
  {
    return std::any_of(m_chords.begin(), m_chords.end(), [&](const auto& chord) { return chords.count(chord) > 0; });
  }

  // Splits chords that are among `chords`, and adds the others to these.
  void split_common_chords(Chords& chords)
  {
    if(has_chord_among(chords))
      m_mesher->split_chords(chords);
    else
      chords.insert(m_chords.begin(), m_chords.end());
    if(m_mesher->has_cuts())
      remove_chords_at_cuts(chords);
  }

  bool is_collected() const { return !m_mesher; }

  template <class ConcurrencyTag>
  void collect(const Indexed_mesh<Kernel>& mesh)
  {
    m_result = m_mesher->template collect<ConcurrencyTag>(mesh.keeps_domain_points, mesh.keeps_corner_points);
    m_mesher.reset();
  }

  // \pre it is collected
  Meshed_patch<Kernel>& result() { return m_result; }

private:
  // those between points that no other face has; another one may have points with the same numbers
  static void remove_chords_at_cuts(Chords& chords)
  {
    for(auto chord = chords.begin(); chord != chords.end();)
      chord = chord->second >= Partial_mesh<Kernel>::first_cut_point ? chords.erase(chord) : std::next(chord);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_FACE_JOB_H
