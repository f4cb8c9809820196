// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PAGE_PAGE_MAKER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PAGE_PAGE_MAKER_H

#include <CGAL/First_fundamental_form_metric_2.h>
#include <CGAL/Mesh_page_3.h>
#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Parametric_surface_mesh_parameters.h>
#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Mesh_in_model.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Surface_curvature_3.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// What the report tells of triangles and faces, as entries of a list.
inline std::vector<Mesh_page_3::Finding> findings_of(const Parametric_surface_mesh_report& report)
{
  std::vector<Mesh_page_3::Finding> result;
  std::map<std::pair<Unmet_cause, Criterion_set>, std::size_t> known;
  for(const auto& unmet : report.unmet) {
    const auto found = known.emplace(std::make_pair(unmet.cause, unmet.criteria), result.size());
    if(found.second)
      result.push_back({"not met", names(unmet.criteria), std::string("because of the ") + name(unmet.cause)});
    result[found.first->second].triangles.push_back(unmet.face);
  }
  for(const auto& intersection : report.intersections)
    result.push_back({"intersection", std::to_string(intersection.number_of_pairs) + " pairs of triangles pass through each other",
                      intersection.is_of_surfaces ? "the surfaces do so, too" : "",
                      {intersection.faces[0], intersection.faces[1]},
                      {},
                      {intersection.place}});
  for(const auto& detail : report.removed_details)
    result.push_back({"simplified", detail.is_closed_up ? "closed up" : "detail removed",
                      std::to_string(detail.number_of_triangles) + " triangles, moved by at most " + describe(detail.moved),
                      {detail.face},
                      {},
                      {detail.place}});
  for(const auto& face : report.left_out)
    result.push_back({"left out", "not meshed", face.reason, {face.face}});
  return result;
}

// Makes the page of a mesh.
template <class Surface, class Mesh, class TriangleMesh, class MetricField>
class Page_maker
{
  typedef typename Surface::Geom_traits Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  // The tensor at a vertex, for the next triangle there.
  struct Known_tensor
  {
    std::size_t face = Mesh_page_3::none;
    std::array<double, 2> uv;
    Metric_tensor_2 tensor;
  };

  const Parametric_surface_model_3<Surface>& m_model;
  const Mesh& m_mesh; // knows its places in the model
  const TriangleMesh& m_tm;
  const MetricField& m_metric;
  Mesh_page_3 m_page;
  std::vector<Known_tensor> m_tensors; // by point
  typename boost::property_map<TriangleMesh, dynamic_vertex_property_t<std::size_t>>::const_type m_points;

public:
  Page_maker(const Parametric_surface_model_3<Surface>& model, const Mesh& mesh, const TriangleMesh& tm, const MetricField& metric)
    : m_model(model), m_mesh(mesh), m_tm(tm), m_metric(metric), m_points(get(dynamic_vertex_property_t<std::size_t>(), tm))
  {}

  Mesh_page_3 operator()(const Parametric_surface_mesh_report& report)
  {
    for(const auto v : vertices(m_tm)) {
      const auto& p = get(m_mesh.vertex_point_map, v);
      put(m_points, v, m_page.points.size());
      m_page.points.push_back({{p.x(), p.y(), p.z()}});
    }
    for(std::size_t f = 0; f < m_model.faces().size(); ++f) {
      m_page.faces.emplace_back();
      m_page.faces.back().number = f + 1;
    }
    m_tensors.resize(m_page.points.size());
    m_page.values = {{"distance from the surface", Mesh_page_3::Dimension::LENGTH, {}},
                     {"curvature", Mesh_page_3::Dimension::RECIPROCAL_LENGTH, {}}};
    for(const face_descriptor f : faces(m_tm))
      add_triangle(f);
    m_page.is_closed = true;
    for(const auto e : edges(m_tm))
      add_line(e);
    m_page.findings = findings_of(report);
    return std::move(m_page);
  }

private:
  void add_triangle(face_descriptor f)
  {
    const std::size_t patch = m_mesh.patch(f);
    const Surface& surface = m_model.faces()[patch].surface;
    std::array<std::size_t, 3> corners;
    std::array<std::array<double, 2>, 3> uv;
    std::array<double, 3> sum{{0, 0, 0}};
    const auto sides = m_mesh.sides(f);
    for(std::size_t i = 0; i < 3; ++i) {
      const auto& p = m_mesh.source_uv(sides[i]);
      corners[i] = get(m_points, source(sides[i], m_tm));
      uv[i] = {{p.x(), p.y()}};
      const Metric_tensor_2& tensor = tensor_at(corners[i], patch, uv[i]);
      sum[0] += tensor.e(), sum[1] += tensor.f(), sum[2] += tensor.g();
    }
    m_page.triangles.push_back(corners);
    m_page.triangle_faces.push_back(patch);
    m_page.corner_parameters.push_back(uv);
    m_page.metric_tensors.push_back(sum);
    const double third = 1. / 3;
    const auto center = surface.jet(third * (uv[0][0] + uv[1][0] + uv[2][0]), third * (uv[0][1] + uv[1][1] + uv[2][1]));
    m_page.values[0].values.push_back(distance(surface, sides, uv, center.point));
    m_page.values[1].values.push_back(Surface_curvature_3<Kernel>(center).max_absolute_curvature());
  }

  const Metric_tensor_2& tensor_at(std::size_t point, std::size_t patch, const std::array<double, 2>& uv)
  {
    Known_tensor& known = m_tensors[point];
    if(known.face != patch || known.uv != uv)
      known = {patch, uv, m_metric.tensor(m_model.faces()[patch].surface.jet(uv[0], uv[1]))};
    return known.tensor;
  }

  // The largest one between the triangle and the points of the surface over the middles of its sides and its centroid.
  template <class Sides, class Point_3>
  double distance(const Surface& surface, const Sides& sides, const std::array<std::array<double, 2>, 3>& uv, const Point_3& center) const
  {
    const Kernel kernel;
    const auto squared_distance = kernel.compute_squared_distance_3_object();
    const auto triangle
      = kernel.construct_triangle_3_object()(m_mesh.source_point(sides[0]), m_mesh.source_point(sides[1]), m_mesh.source_point(sides[2]));
    double result = squared_distance(center, triangle);
    for(std::size_t i = 0; i < 3; ++i) {
      const auto &a = uv[i], &b = uv[(i + 1) % 3];
      result = (std::max)(result, squared_distance(surface.point(0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])), triangle));
    }
    return std::sqrt(result);
  }

  void add_line(typename Graph_traits::edge_descriptor e)
  {
    const halfedge_descriptor h = halfedge(e, m_tm);
    const std::size_t edge = m_mesh.place(e).index;
    const bool is_on_border = m_mesh.is_on_border(h) || m_mesh.is_on_border(opposite(h, m_tm));
    if(is_on_border)
      m_page.is_closed = false;
    if(edge != Edge_place::none || is_on_border)
      m_page.lines.push_back({{{get(m_points, source(h, m_tm)), get(m_points, target(h, m_tm))}}, edge == Edge_place::none ? 0 : edge + 1});
  }
};

template <class Surface, class TriangleMesh, class NamedParameters>
Mesh_page_3 make_page(const Parametric_surface_model_3<Surface>& model, const TriangleMesh& tm,
                      const Parametric_surface_mesh_report& report, const NamedParameters& np)
{
  const auto mesh = make_mesh_in_model(tm, np);
  typedef First_fundamental_form_metric_2<typename Surface::Geom_traits> Default_metric;
  const auto metric = parameters::choose_parameter(parameters::get_parameter(np, Metric_field_t()), Default_metric());
  return Page_maker<Surface, std::decay_t<decltype(mesh)>, TriangleMesh, std::decay_t<decltype(metric)>>(model, mesh, tm, metric)(report);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PAGE_PAGE_MAKER_H
