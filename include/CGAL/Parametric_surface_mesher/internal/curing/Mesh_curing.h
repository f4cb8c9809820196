// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_MESH_CURING_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_MESH_CURING_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/curing/Complex_in_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/curing/Corner_angles.h>
#include <CGAL/Parametric_surface_mesher/internal/curing/Detail_curing.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Lets detail of a model vanish from its mesh: see `Parametric_surface_mesh_criteria::set_detail()`.
template <class Kernel, class Surface>
class Mesh_curing
{
  typedef Indexed_mesh<Kernel> Mesh;
  typedef Complex_in_mesh<Kernel> Region;
  typedef Detail_curing<Kernel, Surface> Curing;
  typedef Detail_judge<Kernel, Surface> Judge;
  typedef std::size_t Index;

  // What is left after a round may be farther off the triangles that it began with; more rounds than two are rare.
  static constexpr int max_number_of_rounds = 4;

  Mesh& m_mesh;
  const Parametric_surface_mesh_criteria& m_criteria;
  const std::vector<Surface>& m_surfaces; // by patch, and so are the next two
  std::vector<std::array<Index, 2>> m_shells;
  std::vector<bool> m_are_reversed;
  std::vector<Index> m_meeting_points;
  typename Region::Moves m_moves;
  Corner_angles<Kernel> m_corner_angles;
  std::map<Index, Parametric_surface_mesh_report::Removed_detail> m_details; // by patch
  bool m_is_changed = false;
  Parametric_surface_mesh_report& m_report;

public:
  // `shells`: by face, on both sides. `meeting_points`: those at which several pieces of the mesh may meet
  Mesh_curing(Mesh& mesh, const Parametric_surface_mesh_criteria& criteria, const std::vector<Surface>& surfaces,
              std::vector<std::array<Index, 2>> shells, std::vector<bool> are_reversed, std::vector<Index> meeting_points,
              Parametric_surface_mesh_report& report)
    : m_mesh(mesh), m_criteria(criteria), m_surfaces(surfaces), m_shells(std::move(shells)),
      m_are_reversed(std::move(are_reversed)), m_meeting_points(std::move(meeting_points)),
      m_report(report)
  {}

  // \pre the parts have their corner points, and no place in the mesh yet
  template <class GoFurther>
  void operator()(const GoFurther& go_further)
  {
    for(int round = 0; round < max_number_of_rounds && go_further(); ++round) {
      const std::vector<Index> faces = faces_with_small_angles();
      if(faces.empty() || !cure(faces, go_further))
        break;
    }
    if(m_is_changed)
      update_report();
  }

  // The points at which several pieces may meet, as they are afterwards.
  const std::vector<Index>& meeting_points() const { return m_meeting_points; }

private:
  // The faces with small angles, in ascending order, numbered over all parts.
  std::vector<Index> faces_with_small_angles() const
  {
    std::vector<Index> result;
    Index p = 0;
    for(const auto& unmet : m_report.unmet) {
      while(unmet.face >= m_mesh.parts[p].first_face + m_mesh.parts[p].faces.size())
        ++p;
      if(unmet.criteria.contains(Mesh_criterion::ANGLE)
         && squared_sine(p, unmet.face - m_mesh.parts[p].first_face) < square(Curing::small_sine))
        result.push_back(unmet.face);
    }
    return result;
  }

  // The squared sine of the smallest angle of a face.
  double squared_sine(Index part, Index face) const
  {
    const auto corners = Region::corners(m_mesh, m_mesh.parts[part], face);
    return squared_smallest_sine({squared_distance(corners[1], corners[2]), squared_distance(corners[2], corners[0]),
                                  squared_distance(corners[0], corners[1])});
  }

  // Returns whether something has changed.
  template <class GoFurther>
  bool cure(const std::vector<Index>& faces, const GoFurther& go_further)
  {
    Region region(m_mesh, m_shells, m_moves, faces);
    m_corner_angles.add(region.complex());
    Curing curing(region.complex(), m_surfaces, m_are_reversed, m_corner_angles, *m_criteria.detail(),
                  m_criteria.distance().value_or(std::numeric_limits<double>::infinity()));
    curing(go_further);
    if(curing.number_of_changes() == 0 || !curing.is_good())
      return false;
    m_is_changed = true;
    note(curing.removals());
    region.put_back();
    renumber_points(region);
    renumber_unmet(region);
    return true;
  }

  void note(const std::vector<typename Curing::Removal>& removals)
  {
    for(const auto& removal : removals) {
      auto& detail = m_details.emplace(removal.patch, Parametric_surface_mesh_report::Removed_detail{
        removal.patch, 0, 0, {removal.place.x(), removal.place.y(), removal.place.z()}, false}).first->second;
      ++detail.number_of_triangles;
      detail.moved = (std::max)(detail.moved, removal.moved);
    }
  }

  void renumber_points(const Region& region)
  {
    std::vector<Place_in_model> places(m_mesh.points.size(), Place_in_model());
    for(Index n = 0; n < m_mesh.places.size(); ++n)
      if(region.new_points[n] != Region::none)
        places[region.new_points[n]] = m_mesh.places[n];
    std::set<Index> meeting_points;
    for(Index n : m_meeting_points)
      if(region.new_points[n] != Region::none)
        meeting_points.insert(region.new_points[n]);
    for(Index v = 0; v < region.complex().vertices().size(); ++v) {
      const auto& vertex = region.complex().vertex(v);
      const Index n = region.shared_point(v);
      if(vertex.displacement.length() > 0)
        m_moves[vertex.point] = vertex.displacement;
      if(n != Region::none) {
        places[n] = region.place(v);
        meeting_points.insert(n);
      }
    }
    m_mesh.places.swap(places);
    m_meeting_points.assign(meeting_points.begin(), meeting_points.end());
  }

  void renumber_unmet(const Region& region)
  {
    std::vector<Parametric_surface_mesh_report::Unmet> unmet;
    for(const auto& old : m_report.unmet)
      if(region.new_faces[old.face] != Region::none)
        unmet.push_back({region.new_faces[old.face], old.criteria, old.cause});
    const Judge judge(region.complex(), m_surfaces, m_are_reversed, m_corner_angles);
    for(Index t = 0; t < region.added_faces.size(); ++t)
      if(region.added_faces[t] != Region::none) {
        const Criterion_set failed = judge.failed(t, m_criteria);
        if(!failed.empty())
          unmet.push_back({region.added_faces[t], failed, Unmet_cause::BOUNDARY});
      }
    std::sort(unmet.begin(), unmet.end(), [](const auto& a, const auto& b) { return a.face < b.face; });
    m_report.unmet.swap(unmet);
  }

  void update_report() const
  {
    std::set<Index> limited, patches; // faces limited by the boundary, and patches with faces
    for(const auto& unmet : m_report.unmet)
      if(unmet.criteria.contains(Mesh_criterion::ANGLE) && unmet.cause == Unmet_cause::BOUNDARY)
        limited.insert(unmet.face);
    double smallest = 1, smallest_off_boundary = 1;
    for(Index p = 0; p < m_mesh.parts.size(); ++p)
      for(Index f = 0; f < m_mesh.parts[p].faces.size(); ++f) {
        const double sine = squared_sine(p, f);
        patches.insert(m_mesh.parts[p].patch);
        smallest = (std::min)(smallest, sine);
        if(limited.count(m_mesh.parts[p].first_face + f) == 0)
          smallest_off_boundary = (std::min)(smallest_off_boundary, sine);
      }
    const auto degrees = [](double squared_sine) { return std::asin(std::sqrt(squared_sine)) * 45 / std::atan(1.); };
    m_report.smallest_angle = degrees(smallest);
    m_report.smallest_angle_off_boundary = degrees(smallest_off_boundary);
    for(const auto& detail : m_details) {
      m_report.removed_details.push_back(detail.second);
      m_report.removed_details.back().is_closed_up = patches.count(detail.first) == 0;
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_MESH_CURING_H
