// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_TRIANGULATE_BOUNDARY_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_TRIANGULATE_BOUNDARY_H

#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Evaluated_point_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/nesting_levels.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/spacing_of_neighbors.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A triangulation of the points of a divided boundary whose segments are its constraints.
template <class Kernel>
struct Boundary_triangulation
{
  typedef Patch_triangulation_2<Kernel> Triangulation;

  std::unique_ptr<Triangulation> triangulation;
  std::vector<typename Triangulation::Vertex_handle> vertices; // one for each point, loop by loop
};

// The faces, identified by the indices of their vertices, in an order along the boundary.
template <class Triangulation>
std::vector<typename Triangulation::Face_handle> faces_along_boundary(const Triangulation& triangulation)
{
  typedef typename Triangulation::Face_handle Face_handle;
  typedef std::pair<std::array<std::size_t, 3>, Face_handle> Numbered_face;
  std::vector<Numbered_face> faces;
  for(Face_handle face : triangulation.finite_face_handles()) {
    faces.push_back({{face->vertex(0)->index(), face->vertex(1)->index(), face->vertex(2)->index()}, face});
    std::sort(faces.back().first.begin(), faces.back().first.end());
  }
  std::stable_sort(faces.begin(), faces.end(),
                   [](const Numbered_face& a, const Numbered_face& b) { return a.first < b.first; });
  std::vector<Face_handle> result;
  for(const Numbered_face& face : faces)
    result.push_back(face.second);
  return result;
}

/*
Triangulates the divided boundary of a patch: the division's segments become constraints, faces are marked as inside or
outside the domain.

The points first all carry the mean of their tensors. Under one tensor the in-ellipse predicate is that of a true Delaunay
triangulation (of an affine image), with which CGAL inserts points and constraints. Only then they get tensors of their
own, and a bounded number of flips makes the triangulation locally Delaunay again.
*/
template <class Kernel>
class Boundary_triangulator
{
public:
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Point Point;
  typedef Evaluated_point<Kernel> Evaluated;

private:
  static constexpr double rounding_of_tensors = 1e-6; // relative; the tensors of a cylinder, all equal, differ by less
  static constexpr std::size_t max_number_of_flips_by_edge = 20; // in practice there is less than one

  Triangulation& m_triangulation;
  const Boundary_loops<Kernel>& m_loops;
  std::vector<std::size_t> m_starts; // where each loop begins in the arrays below
  std::vector<Point> m_points;
  std::vector<Vertex_handle> m_vertices;
  std::size_t m_number_of_replaced_tensors = 0, m_number_of_work_limits = 0;
  bool m_has_taken_over = false;

public:
  Boundary_triangulator(Triangulation& triangulation, const Boundary_loops<Kernel>& loops)
    : m_triangulation(triangulation), m_loops(loops)
  {}

  // \pre `Boundary_check` finds no mistakes
  template <class Evaluator>
  void operator()(const Evaluator& evaluate)
  {
    triangulate(evaluate_all(evaluate));
  }

  // Uses a triangulation of the points of the loops that was made before, with other tensors and spacings. If tensors vary, it
  // depends on the order of its points, and a new one is made instead.
  template <class Evaluator>
  void operator()(const Evaluator& evaluate, Boundary_triangulation<Kernel> given)
  {
    CGAL_precondition(given.vertices.size() == number_of_vertices<Kernel>(m_loops));
    const std::vector<Evaluated> evaluated = evaluate_all(evaluate);
    if(have_one_tensor(evaluated, rounding_of_tensors))
      take_over(std::move(given), evaluated);
    else
      triangulate(evaluated);
  }

  // The vertices of the points, loop by loop.
  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }

  // Whether a triangulation that was made before is used, so that the order of the faces is not the usual one.
  bool has_taken_over() const { return m_has_taken_over; }

  // The number of boundary vertices whose tensor was not positive definite and was replaced.
  std::size_t number_of_replaced_tensors() const { return m_number_of_replaced_tensors; }

  // Whether, and then 1, flips were given up before all edges were Delaunay.
  std::size_t number_of_work_limits() const { return m_number_of_work_limits; }

private:
  void triangulate(const std::vector<Evaluated>& evaluated)
  {
    const bool is_uniform = have_one_tensor(evaluated, 0);
    insert_points(is_uniform ? evaluated.front().point.tensor() : mean_tensor(evaluated));
    insert_constraints();
    mark_domain();
    set_points(evaluated);
    if(!is_uniform) // under a single tensor the triangulation is Delaunay already
      make_locally_delaunay();
    set_spacings_of_single_points(evaluated);
  }

  void take_over(Boundary_triangulation<Kernel> given, const std::vector<Evaluated>& evaluated)
  {
    m_has_taken_over = true;
    m_triangulation.swap(*given.triangulation);
    m_vertices = std::move(given.vertices);
    for(Vertex_handle vertex : m_vertices)
      vertex->set_on_boundary(false);
    set_points(evaluated);
    make_locally_delaunay();
    set_spacings_of_single_points(evaluated);
  }

  template <class Evaluator>
  std::vector<Evaluated> evaluate_all(const Evaluator& evaluate)
  {
    std::vector<Evaluated> result;
    result.reserve(number_of_vertices<Kernel>(m_loops));
    for(const auto& loop : m_loops) {
      m_starts.push_back(result.size());
      for(std::size_t i = 0; i < loop.size(); ++i) {
        result.push_back(evaluate(loop[i].domain_point, loop[i].surface_point, spacing(loop, i)));
        m_number_of_replaced_tensors += result.back().is_tensor_replaced;
      }
    }
    m_starts.push_back(result.size());
    if(std::all_of(result.begin(), result.end(), [](const Evaluated& e) { return e.is_degenerate; }))
      throw Parametric_surface_mesh_error("the surface is degenerate: its first derivatives are parallel or zero "
                                          "everywhere on the boundary, at (u,v) = "
                                          + describe(m_loops[0][0].domain_point) + " for one");
    return result;
  }

  // Whether all tensors are equal up to a relative tolerance.
  static bool have_one_tensor(const std::vector<Evaluated>& evaluated, double tolerance)
  {
    const Metric_tensor_2 first = evaluated.front().point.tensor();
    return std::all_of(evaluated.begin(), evaluated.end(), [&](const Evaluated& e) {
      const Metric_tensor_2 t = e.point.tensor();
      return std::fabs(t.e() - first.e()) <= tolerance * first.e() && std::fabs(t.g() - first.g()) <= tolerance * first.g()
             && std::fabs(t.f() - first.f()) <= tolerance * std::sqrt(first.e() * first.g());
    });
  }

  static Metric_tensor_2 mean_tensor(const std::vector<Evaluated>& evaluated)
  {
    Metric_tensor_2 sum(0, 0, 0);
    for(const Evaluated& e : evaluated)
      sum = sum + (1. / double(evaluated.size())) * e.point.tensor();
    return sum;
  }

  void insert_points(const Metric_tensor_2& tensor)
  {
    m_points.reserve(number_of_vertices<Kernel>(m_loops));
    for(const auto& loop : m_loops)
      for(const Boundary_vertex<Kernel>& vertex : loop)
        m_points.emplace_back(vertex.domain_point, vertex.surface_point, tensor);
    std::vector<std::size_t> order(m_points.size());
    std::iota(order.begin(), order.end(), 0);
    typedef typename Pointer_property_map<Point>::const_type Point_map;
    typedef Spatial_sort_traits_adapter_2<typename Triangulation::Geom_traits, Point_map> Sort_traits;
    spatial_sort(order.begin(), order.end(), Sort_traits(make_property_map(static_cast<const Point*>(m_points.data()))));
    m_vertices.resize(m_points.size());
    Face_handle hint;
    for(std::size_t i : order) {
      m_vertices[i] = m_triangulation.insert(m_points[i], hint);
      hint = m_vertices[i]->face();
    }
    if(m_triangulation.dimension() < 2 || !has_area())
      throw Parametric_surface_mesh_error("the domain has area zero: the points of its boundary are collinear, from "
                                          + describe(m_points.front()));
  }

  // Whether a loop encloses more than what rounding of points on a line may enclose, as a share of their box.
  bool has_area() const
  {
    const double rounding = 1e-12;
    for(const auto& loop : m_loops) {
      Bbox_2 box;
      double area = 0;
      const auto& origin = loop.front().domain_point;
      for(std::size_t i = 0; i < loop.size(); ++i) {
        const auto &p = loop[i].domain_point, &q = loop[i + 1 < loop.size() ? i + 1 : 0].domain_point;
        box += p.bbox();
        area += 0.5 * ((p.x() - origin.x()) * (q.y() - origin.y()) - (p.y() - origin.y()) * (q.x() - origin.x()));
      }
      if(std::fabs(area) > rounding * box.x_span() * box.y_span())
        return true;
    }
    return false;
  }

  template <class Visit>
  void for_each_segment(Visit visit) const
  {
    for(std::size_t l = 0; l + 1 < m_starts.size(); ++l)
      for(std::size_t i = m_starts[l]; i < m_starts[l + 1]; ++i)
        visit(l, m_vertices[i], m_vertices[i + 1 < m_starts[l + 1] ? i + 1 : m_starts[l]]);
  }

  // Most segments are edges of the triangulation already; it stays Delaunay if these are only marked as constrained.
  void insert_constraints()
  {
    for_each_segment([this](std::size_t l, Vertex_handle a, Vertex_handle b) {
      if(is_single_point(m_loops[l]))
        return;
      Face_handle face;
      int i = 0;
      if(m_triangulation.is_edge(a, b, face, i)) {
        face->neighbor(i)->set_constraint(m_triangulation.mirror_index(face, i), true);
        face->set_constraint(i, true);
      }
      else
        insert_constraint(a, b);
    });
  }

  void insert_constraint(Vertex_handle a, Vertex_handle b)
  {
    try {
      m_triangulation.insert_constraint(a, b);
    }
    catch(const typename Triangulation::Intersection_of_constraints_exception&) {
      throw Parametric_surface_mesh_error("the boundary crosses itself: a segment crosses the one from " + describe(a->point())
                                          + " to " + describe(b->point()));
    }
  }

  void mark_domain()
  {
    Inner_segments inner_segments;
    std::vector<bool> are_inside; // by loop
    for(std::size_t l = 0; l < m_loops.size(); ++l) {
      are_inside.push_back(lies_inside(m_loops[l]));
      if(are_inside.back() && !is_single_point(m_loops[l]))
        add_inner_segments(m_vertices.begin() + std::ptrdiff_t(m_starts[l]), m_vertices.begin() + std::ptrdiff_t(m_starts[l + 1]),
                           inner_segments);
    }
    set_nesting_levels(m_triangulation, inner_segments);
    std::vector<bool> is_checked(m_loops.size(), false);
    for_each_segment([&](std::size_t l, Vertex_handle a, Vertex_handle b) {
      if(are_inside[l])
        check_is_inside(m_triangulation, m_loops[l], l, a);
      else if(!is_checked[l])
        check_nesting(m_triangulation, l, a, b);
      is_checked[l] = true;
    });
  }

  // The spacing of a boundary vertex: the mean of the distances to its two neighbours (paper, section "Spacing function").
  // A single point has an infinite one until `set_spacings_of_single_points()` is called.
  static double spacing(const std::vector<Boundary_vertex<Kernel>>& loop, std::size_t i)
  {
    if(is_single_point(loop))
      return std::numeric_limits<double>::infinity();
    const auto &before = loop[(i + loop.size() - 1) % loop.size()].surface_point,
               &after = loop[(i + 1) % loop.size()].surface_point, &here = loop[i].surface_point;
    return (std::sqrt(squared_distance(before, here)) + std::sqrt(squared_distance(here, after))) / 2;
  }

  void set_points(const std::vector<Evaluated>& evaluated)
  {
    std::size_t position = 0;
    for(const auto& loop : m_loops)
      for(std::size_t i = 0; i < loop.size(); ++i, ++position) {
        const Vertex_handle vertex = m_vertices[position];
        vertex->set_point(evaluated[position].point);
        const double own = spacing(loop, i);
        vertex->set_spacing(vertex->is_on_boundary() ? (std::min)(vertex->spacing(), own) : own); // a vertex where loops touch is visited twice
        vertex->set_index(loop[i].index);
        vertex->set_on_boundary(true);
      }
  }

  // A single point gets the mean spacing of its neighbours, much like a point that refinement inserts, unless the sizes ask for less.
  void set_spacings_of_single_points(const std::vector<Evaluated>& evaluated)
  {
    for(std::size_t l = 0; l < m_loops.size(); ++l)
      if(is_single_point(m_loops[l]) && std::isinf(m_vertices[m_starts[l]]->spacing()))
        m_vertices[m_starts[l]]->set_spacing(
          (std::min)(spacing_of_neighbors(m_triangulation, m_vertices[m_starts[l]]), evaluated[m_starts[l]].spacing_limit));
  }

  // Under varying tensors such flips need not end, so their number is bounded.
  void make_locally_delaunay()
  {
    typedef typename Triangulation::Edge Edge;
    std::vector<Edge> stack;
    // The loop runs over faces, because which of the two faces of an edge the edge iterator returns depends on addresses.
    for(Face_handle face : m_triangulation.finite_face_handles())
      for(int i = 0; i < 3; ++i)
        stack.emplace_back(face, i);
    std::size_t flips_left = max_number_of_flips_by_edge * stack.size();
    while(!stack.empty() && flips_left > 0) {
      const Edge edge = stack.back();
      stack.pop_back();
      const Face_handle face = edge.first, across = face->neighbor(edge.second);
      if(!face->is_in_domain() || !m_triangulation.is_flipable(face, edge.second))
        continue;
      m_triangulation.flip(const_cast<Face_handle&>(face), edge.second);
      --flips_left;
      for(Face_handle changed : {face, across})
        for(int i = 0; i < 3; ++i)
          stack.emplace_back(changed, i);
    }
    m_number_of_work_limits += !stack.empty();
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_TRIANGULATE_BOUNDARY_H
