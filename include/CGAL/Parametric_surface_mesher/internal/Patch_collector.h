// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_COLLECTOR_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_COLLECTOR_H

#include <CGAL/Mesh_2/Face_badness.h>
#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/Boundary_loops.h>
#include <CGAL/Parametric_surface_mesher/internal/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_chart_2.h>
#include <CGAL/Parametric_surface_mesher/internal/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/Triangle_twins.h>
#include <CGAL/Parametric_surface_mesher/internal/for_each_with_lookahead.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Appends the triangles of a refined patch to a mesh that already holds its boundary vertices, and notes in the report
// what each of them fails.
template <class Kernel>
class Patch_collector
{
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Kernel::Point_2 Point_2;

  Triangulation& m_triangulation;
  const Patch_chart_2<Kernel>& m_chart;
  std::unordered_map<Vertex_handle, Point_2> m_boundary_points; // in the domain, of a patch with a chart
  Indexed_mesh<Kernel>& m_mesh;
  Parametric_surface_mesh_report& m_report;
  std::size_t m_first_inner_index;
  double m_squared_sine = 1, m_squared_sine_off_boundary = 1; // of the smallest angles

public:
  // `first_inner_index`: of the points of the mesh, 0 unless its first points are elsewhere
  Patch_collector(Triangulation& triangulation, const Patch_chart_2<Kernel>& chart, Indexed_mesh<Kernel>& mesh,
                  Parametric_surface_mesh_report& report, std::size_t first_inner_index = 0)
    : m_triangulation(triangulation), m_chart(chart), m_mesh(mesh), m_report(report), m_first_inner_index(first_inner_index)
  {}

  // To be called for a patch with a chart: on the way through the chart the domain points of boundary vertices would be
  // rounded.
  void set_domain_points(const std::vector<Vertex_handle>& vertices, const Boundary_loops<Kernel>& loops)
  {
    auto vertex = vertices.begin();
    for(const auto& loop : loops)
      for(const Boundary_vertex<Kernel>& point : loop)
        m_boundary_points.emplace(*vertex++, point.domain_point);
  }

  // `refinement` tells which faces are bad and why they were left
  template <class Refinement>
  void operator()(const Refinement& refinement)
  {
    append_vertices();
    make_room(m_mesh.faces, m_triangulation.number_of_faces());
    make_room(m_mesh.twins, 3 * m_triangulation.number_of_faces());
    for_each_face_with_lookahead(m_triangulation, [&](Face_handle face) {
      if(!face->is_in_domain())
        return;
      if(is_collapsed(face)) {
        ++m_report.number_of_collapsed_faces;
        return;
      }
      note(face, refinement);
      append(face);
    });
    m_report.smallest_angle = (std::min)(m_report.smallest_angle, degrees(m_squared_sine));
    m_report.smallest_angle_off_boundary
      = (std::min)(m_report.smallest_angle_off_boundary, degrees(m_squared_sine_off_boundary));
  }

private:
  // Reserves what a patch needs; with some more, so that many patches do not copy all before them each time.
  template <class T>
  static void make_room(std::vector<T>& v, std::size_t n)
  {
    if(v.size() + n > v.capacity())
      v.reserve((std::max)(v.size() + n, v.size() + v.size() / 2));
  }

  void append_vertices()
  {
    make_room(m_mesh.points, m_triangulation.number_of_vertices());
    make_room(m_mesh.domain_points, m_triangulation.number_of_vertices());
    for(const auto vertex : m_triangulation.finite_vertex_handles()) {
      if(vertex->is_on_boundary())
        continue;
      vertex->set_index(m_first_inner_index + m_mesh.points.size());
      m_mesh.points.push_back(vertex->point().surface_point());
      m_mesh.domain_points.push_back(m_chart.domain_point(vertex->point().domain_point()));
    }
  }

  void append(Face_handle face)
  {
    face->set_number(m_mesh.faces.size());
    m_mesh.faces.push_back({face->vertex(0)->index(), face->vertex(1)->index(), face->vertex(2)->index()});
    if(m_mesh.keeps_corner_points)
      m_mesh.corner_points.push_back({corner_point(face, 0), corner_point(face, 1), corner_point(face, 2)});
    append_twins(face);
  }

  // Inner edges have their twins in the triangulation. Others are found by their vertices, together with those of other
  // patches: edges of the boundary, edges beside a collapsed triangle, and edges between two boundary vertices, which other
  // patches might repeat.
  void append_twins(Face_handle face)
  {
    m_mesh.twins.resize(3 * m_mesh.faces.size(), std::size_t(Triangle_twins::none));
    for(int i = 0; i < 3; ++i)
      if(face->neighbor(i)->has_number() && has_inner_twin(face, i)) {
        const std::size_t twin = side(face->neighbor(i), face->neighbor(i)->index(face));
        m_mesh.twins[side(face, i)] = twin;
        m_mesh.twins[twin] = side(face, i);
      }
  }

  bool has_inner_twin(Face_handle face, int i) const
  {
    const bool v_is_inner = !face->vertex(Triangulation::ccw(i))->is_on_boundary(),
               w_is_inner = !face->vertex(Triangulation::cw(i))->is_on_boundary();
    return (v_is_inner && w_is_inner) || ((v_is_inner || w_is_inner) && !is_collapsed(face->neighbor(i)));
  }

  // side `k` of a triangle runs from corner `k` to the next one; edge `i` is opposite to corner `i`
  static std::size_t side(Face_handle face, int i) { return 3 * face->number() + Triangulation::ccw(i); }

  Point_2 domain_point(Vertex_handle vertex) const
  {
    const auto found = m_boundary_points.find(vertex);
    return found != m_boundary_points.end() ? found->second : m_chart.domain_point(vertex->point().domain_point());
  }

  // A pole is a side of the domain; of that side a triangle gets the point in the middle of its other corners.
  Point_2 corner_point(Face_handle face, int i) const
  {
    const Point_2 uv = domain_point(face->vertex(i));
    if(!m_chart.is_pole(face->vertex(i)->point().domain_point()))
      return uv;
    return m_chart.on_collapsed_side(uv, midpoint(domain_point(face->vertex((i + 1) % 3)), domain_point(face->vertex((i + 2) % 3))));
  }

  template <class Refinement>
  void note(Face_handle face, const Refinement& refinement)
  {
    const double squared_sine = squared_smallest_sine_in_space(face);
    m_squared_sine = (std::min)(m_squared_sine, squared_sine);
    // only what the refinement left cannot be good
    typename Refinement::Quality quality;
    if(face->state() != Face_state::GOOD && refinement.is_bad()(face, quality) != Mesh_2::NOT_BAD) {
      const Unmet_cause cause = refinement.cause(face);
      m_report.unmet.push_back({m_mesh.faces.size(), quality.criterion, cause});
      if(cause == Unmet_cause::BOUNDARY)
        return;
    }
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
