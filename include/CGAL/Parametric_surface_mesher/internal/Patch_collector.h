// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_COLLECTOR_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_COLLECTOR_H

#include <CGAL/Mesh_2/Face_badness.h>
#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_triangulation_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Appends the triangles of a refined patch to a mesh that already holds its boundary vertices, and notes in the report
// what each of them fails. `cause_off_boundary` is why a triangle away from the boundary can be bad.
template <class Kernel, class IsBad>
class Patch_collector
{
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;

  Triangulation& m_triangulation;
  const IsBad& m_is_bad;
  Indexed_mesh<Kernel>& m_mesh;
  Parametric_surface_mesh_report& m_report;
  double m_squared_sine = 1, m_squared_sine_off_boundary = 1; // of the smallest angles

public:
  Patch_collector(Triangulation& triangulation, const IsBad& is_bad, Indexed_mesh<Kernel>& mesh,
                  Parametric_surface_mesh_report& report)
    : m_triangulation(triangulation), m_is_bad(is_bad), m_mesh(mesh), m_report(report)
  {}

  void operator()(Unmet_cause cause_off_boundary)
  {
    append_vertices();
    for(Face_handle face : m_triangulation.finite_face_handles()) {
      if(!face->is_in_domain())
        continue;
      if(is_collapsed(face)) {
        ++m_report.number_of_collapsed_faces;
        continue;
      }
      note(face, cause_off_boundary);
      m_mesh.faces.push_back({face->vertex(0)->index(), face->vertex(1)->index(), face->vertex(2)->index()});
      if(m_mesh.keeps_corner_points)
        m_mesh.corner_points.push_back({face->vertex(0)->point().domain_point(), face->vertex(1)->point().domain_point(),
                                        face->vertex(2)->point().domain_point()});
    }
    m_report.smallest_angle = (std::min)(m_report.smallest_angle, degrees(m_squared_sine));
    m_report.smallest_angle_off_boundary
      = (std::min)(m_report.smallest_angle_off_boundary, degrees(m_squared_sine_off_boundary));
  }

private:
  void append_vertices()
  {
    for(const auto vertex : m_triangulation.finite_vertex_handles()) {
      if(vertex->is_on_boundary())
        continue;
      vertex->set_index(m_mesh.points.size());
      m_mesh.points.push_back(vertex->point().surface_point());
      m_mesh.domain_points.push_back(vertex->point().domain_point());
    }
  }

  void note(Face_handle face, Unmet_cause cause_off_boundary)
  {
    typename IsBad::Quality quality;
    const bool touches_boundary = face->vertex(0)->is_on_boundary() || face->vertex(1)->is_on_boundary()
                                  || face->vertex(2)->is_on_boundary();
    // only what the refinement left cannot be good
    const bool is_bad = face->state() != Face_state::GOOD && m_is_bad(face, quality) != Mesh_2::NOT_BAD;
    if(is_bad) {
      const bool is_interrupted = cause_off_boundary != Unmet_cause::MINIMUM_EDGE;
      const Unmet_cause cause = touches_boundary && !is_interrupted ? Unmet_cause::BOUNDARY : cause_off_boundary;
      m_report.unmet.push_back({m_mesh.faces.size(), quality.criterion, cause});
    }
    const double squared_sine = squared_smallest_sine_in_space(face);
    m_squared_sine = (std::min)(m_squared_sine, squared_sine);
    if(!(is_bad && touches_boundary))
      m_squared_sine_off_boundary = (std::min)(m_squared_sine_off_boundary, squared_sine);
  }

  static double squared_smallest_sine_in_space(Face_handle face)
  {
    const auto &p = face->vertex(0)->point().surface_point(), &q = face->vertex(1)->point().surface_point(),
               &r = face->vertex(2)->point().surface_point();
    return face_measures({squared_distance(q, r), squared_distance(r, p), squared_distance(p, q)}).squared_smallest_sine;
  }

  static double degrees(double squared_sine) { return std::asin(std::sqrt(squared_sine)) * 45 / std::atan(1.); }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_COLLECTOR_H
