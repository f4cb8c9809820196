// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_PATCH_COLLECTOR_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_PATCH_COLLECTOR_H

#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Charted_boundary.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Patch_chart_2.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Partial_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/for_each_with_lookahead.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Makes a part of a mesh of a refined patch, whose boundary vertices are in the mesh already, and notes in the report what
// each triangle fails.
template <class Kernel>
class Patch_collector
{
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Kernel::Point_2 Point_2;
  typedef Partial_mesh<Kernel> Part;
  typedef typename Part::Index Index;

  Triangulation& m_triangulation;
  const Charted_boundary<Kernel>& m_boundary; // of the patch
  Part& m_part;
  Parametric_surface_mesh_report& m_report;
  double m_squared_sine = 1, m_squared_sine_off_boundary = 1; // of the smallest angles

public:
  // \pre the part is empty
  Patch_collector(Triangulation& triangulation, const Charted_boundary<Kernel>& boundary, Part& part,
                  Parametric_surface_mesh_report& report)
    : m_triangulation(triangulation), m_boundary(boundary), m_part(part), m_report(report)
  {}

  // `judge`: gives a face its last verdict
  template <class Judge>
  void operator()(bool keeps_domain_points, bool keeps_corner_points, const Judge& judge)
  {
    append_vertices(keeps_domain_points);
    m_part.faces.reserve(m_triangulation.number_of_faces());
    m_part.halfedges.reserve(m_triangulation.number_of_faces());
    for_each_face_with_lookahead(m_triangulation, [&](Face_handle face) {
      if(!face->is_in_domain())
        return;
      if(is_collapsed(face)) {
        ++m_report.number_of_collapsed_faces;
        return;
      }
      judge(face);
      note(face);
      append(face);
      if(keeps_corner_points)
        m_part.corner_points.push_back({corner_point(face, 0), corner_point(face, 1), corner_point(face, 2)});
    });
    m_report.smallest_angle = (std::min)(m_report.smallest_angle, degrees(m_squared_sine));
    m_report.smallest_angle_off_boundary
      = (std::min)(m_report.smallest_angle_off_boundary, degrees(m_squared_sine_off_boundary));
  }

private:
  void append_vertices(bool keeps_domain_points)
  {
    m_part.points.reserve(m_triangulation.number_of_vertices());
    m_part.domain_points.reserve(keeps_domain_points ? m_triangulation.number_of_vertices() : 0);
    for(const auto vertex : m_triangulation.finite_vertex_handles()) {
      if(vertex->is_on_boundary())
        continue;
      vertex->set_index(Part::first_own_point + m_part.points.size());
      m_part.points.push_back(vertex->point().surface_point());
      if(keeps_domain_points)
        m_part.domain_points.push_back(chart().domain_point(vertex->point().domain_point()));
    }
  }

  void append(Face_handle face)
  {
    face->set_number(m_part.faces.size());
    std::array<Index, 3> halfedges = {};
    for(int i = 0; i < 3; ++i)
      if(has_inner_twin(face, i))
        halfedges[Triangulation::ccw(i)] = halfedge(face->neighbor(i), face);
      else
        m_part.border.push_back(Index(3 * face->number() + Triangulation::ccw(i)));
    m_part.halfedges.push_back(halfedges);
    m_part.faces.push_back({index(face->vertex(0)), index(face->vertex(1)), index(face->vertex(2))});
  }

  static Index index(Vertex_handle vertex) { return Index(vertex->index()); }

  // of the side towards `neighbor`, which has one of the same edge if it was appended before
  Index halfedge(Face_handle neighbor, Face_handle face)
  {
    if(!neighbor->has_number())
      return Index(2 * m_part.number_of_edges++);
    return m_part.halfedges[neighbor->number()][Triangulation::ccw(neighbor->index(face))] + 1;
  }

  // Whether edge `i` is an edge of two triangles of the part. Others are found by their vertices, together with those of
  // other parts: edges of the boundary, edges beside a collapsed triangle, and edges between two boundary vertices, which
  // other parts might repeat. Side `k` of a triangle runs from corner `k` to the next one; edge `i` is opposite to corner
  // `i`.
  bool has_inner_twin(Face_handle face, int i) const
  {
    const bool v_is_inner = !face->vertex(Triangulation::ccw(i))->is_on_boundary(),
               w_is_inner = !face->vertex(Triangulation::cw(i))->is_on_boundary();
    return (v_is_inner && w_is_inner) || ((v_is_inner || w_is_inner) && !is_collapsed(face->neighbor(i)));
  }

  const Patch_chart_2<Kernel>& chart() const { return m_boundary.chart(); }

  Point_2 domain_point(Vertex_handle vertex) const
  {
    const Point_2& z = vertex->point().domain_point();
    return vertex->is_on_boundary() ? m_boundary.domain_point(z) : chart().domain_point(z);
  }

  // A pole is a side of the domain; of that side a triangle gets the point in the middle of its other corners.
  Point_2 corner_point(Face_handle face, int i) const
  {
    const Point_2 uv = domain_point(face->vertex(i));
    if(!chart().is_pole(face->vertex(i)->point().domain_point()))
      return uv;
    return chart().on_collapsed_side(uv, midpoint(domain_point(face->vertex((i + 1) % 3)), domain_point(face->vertex((i + 2) % 3))));
  }

  void note(Face_handle face)
  {
    const double squared_sine = squared_smallest_sine_in_space(face);
    const Verdict verdict = face->verdict();
    m_squared_sine = (std::min)(m_squared_sine, squared_sine);
    if(verdict.scope() != Scope::WHOLE)
      ++m_report.number_of_unjudged_faces;
    if(verdict.fails())
      m_report.unmet.push_back({m_part.faces.size(), verdict.failed(), verdict.refusal()});
    if(!verdict.fails(Mesh_criterion::ANGLE) || verdict.refusal() != Unmet_cause::BOUNDARY)
      m_squared_sine_off_boundary = (std::min)(m_squared_sine_off_boundary, squared_sine);
  }

  static double squared_smallest_sine_in_space(Face_handle face)
  {
    const auto &p = face->vertex(0)->point().surface_point(), &q = face->vertex(1)->point().surface_point(),
               &r = face->vertex(2)->point().surface_point();
    return squared_smallest_sine({squared_distance(q, r), squared_distance(r, p), squared_distance(p, q)});
  }

  static double degrees(double squared_sine) { return std::asin(std::sqrt(squared_sine)) * 45 / std::atan(1.); }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_PATCH_COLLECTOR_H
