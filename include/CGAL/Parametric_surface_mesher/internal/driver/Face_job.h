// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_FACE_JOB_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_FACE_JOB_H

#include <CGAL/Parametric_surface_mesher/internal/driver/Meshed_faces.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/values_of_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Meshed_patch.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Split_patch_mesher.h>
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
  bool m_is_stopped = false, m_is_kept = false, m_has_waited = false;
  std::unique_ptr<Mesher> m_mesher; // until its triangles are collected
  Meshed_face<Kernel> m_meshed;

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
    m_is_kept = false;
    m_meshed = Meshed_face<Kernel>();
    m_meshed.values_of_criteria = values_of_criteria(criteria);
    m_meshed.max_number_of_vertices = criteria.max_number_of_vertices();
    m_mesher = std::make_unique<Mesher>(oracle, criteria, m_loops, progress);
    m_mesher->template operator()<ConcurrencyTag>(std::move(boundary));
    m_meshed.number_of_inner_vertices = m_mesher->number_of_inner_vertices();
    m_meshed.allowances = m_mesher->allowances();
    m_is_stopped = m_mesher->is_stopped();
    m_mesher->split_chords(m_meshed.chords);
  }

  // Takes over what an earlier run gave.
  void keep(Meshed_face<Kernel> meshed)
  {
    m_meshed = std::move(meshed);
    m_is_kept = true;
  }

  bool is_kept() const { return m_is_kept; }

  // Whether the mesh would be another one if no more vertices were allowed than `limit`.
  // \pre it is run
  bool is_limited_by(std::size_t limit) const { return m_meshed.is_limited_by(limit); }

  std::size_t number_of_inner_vertices() const { return m_meshed.number_of_inner_vertices; }
  bool is_stopped() const { return m_is_stopped; }

  // inner edges between boundary vertices
  const Chords& chords() const { return m_meshed.chords; }

  bool has_chord_among(const Chords& chords) const
  {
    return std::any_of(m_meshed.chords.begin(), m_meshed.chords.end(), [&](const auto& chord) { return chords.count(chord) > 0; });
  }

  // Splits chords that are among `chords`, and adds the others to these.
  void split_common_chords(Chords& chords)
  {
    m_has_waited = true;
    if(has_chord_among(chords))
      m_mesher->split_chords(chords);
    else
      chords.insert(m_meshed.chords.begin(), m_meshed.chords.end());
    if(m_mesher->has_cuts())
      remove_chords_at_cuts(chords);
  }

  bool is_collected() const { return !m_mesher; }

  template <class ConcurrencyTag>
  void collect(const Indexed_mesh<Kernel>& mesh)
  {
    m_meshed.patch = m_mesher->template collect<ConcurrencyTag>(mesh.keeps_domain_points, mesh.keeps_corner_points);
    m_mesher.reset();
  }

  // \pre it is collected
  Meshed_patch<Kernel>& result() { return m_meshed.patch; }

  // Whether another run may take over what this one gives: other faces have had no say in it.
  // \pre it is collected
  bool may_be_kept() const { return !m_has_waited && !m_is_stopped; }
  const Meshed_face<Kernel>& meshed() const { return m_meshed; }

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
