// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_TRIANGULATED_BOUNDARY_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_TRIANGULATED_BOUNDARY_H

#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Parametric_point_2.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Charted_surface_3.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/find_chart.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/regular_tensor.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/nesting_levels.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/triangulate_boundary.h>
#include <CGAL/Parametric_surface_oracle_3.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Evaluates the metric at a point, without the spacing.
template <class Oracle>
class Metric_evaluator
{
public:
  typedef typename Oracle::Geom_traits Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;

private:
  const Oracle& m_oracle;

public:
  explicit Metric_evaluator(const Oracle& oracle) : m_oracle(oracle) {}

  Evaluated_point<Kernel> operator()(const Point_2& uv, const Point_3& surface_point, double /* spacing */) const
  {
    const Metric_tensor_2 tensor = tensor_of_field(m_oracle, uv, m_oracle.surface().jet(uv.x(), uv.y()));
    Patch_point_2<Kernel> point(uv, surface_point, regular_tensor(tensor).tensor);
    set_line_point(m_oracle.surface(), point);
    return {{point, Surface_jet_3<Kernel>(), false, false}, 0};
  }
};

/*
The divided boundary of a face and a triangulation of its points, which tells what lies across the face. It follows the
division: where pieces were halved their middles are put in; if points have moved, or the face has a chart, all is made anew.
The spacing of a vertex is the length of the shorter of the pieces at it.
*/
template <class Oracle>
class Triangulated_boundary
{
public:
  typedef typename Oracle::Geom_traits Kernel;
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Vertex_handle Vertex_handle;

  struct Loop
  {
    std::vector<Vertex_handle> vertices;
    std::vector<std::size_t> segments; // by vertex: the index in the domain of the segment that begins there; a chart has none between copies of a pole
  };

private:
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Point Point;
  typedef typename Kernel::Point_2 Point_2;
  typedef Boundary_vertex<Kernel> Vertex;
  typedef Charted_surface_3<typename Oracle::Surface> Surface;
  typedef Parametric_surface_oracle_3<Surface, typename Oracle::Metric_field> Charted_oracle;

  std::unique_ptr<Triangulation> m_triangulation;
  std::vector<Loop> m_loops; // with single points as the last ones
  std::size_t m_number_of_loops = 0; // without these

public:
  // Changes the triangulation to that of these loops, which are in the domain.
  void update(const Oracle& oracle, const Boundary_loops<Kernel>& loops)
  {
    const Surface surface(oracle.surface(), find_chart(oracle.surface(), loops));
    const Charted_oracle charted_oracle(surface, oracle.metric(), oracle.singular_points());
    const Metric_evaluator<Charted_oracle> evaluate(charted_oracle);
    const Boundary_loops<Kernel> charted_loops = chart_loops(loops, surface.chart());
    if(!is_of(charted_loops) && (!surface.chart().is_identity() || !put_in_middles(loops, evaluate)))
      make(charted_loops, evaluate);
    m_number_of_loops = std::size_t(std::find_if(loops.begin(), loops.end(), is_single_point<Kernel>) - loops.begin());
    for(std::size_t l = 0; l < loops.size(); ++l) {
      set_indices(charted_loops[l], m_loops[l].vertices);
      m_loops[l].segments = segments(loops[l], charted_loops[l].size());
      if(!is_single_point(loops[l]))
        set_spacings(m_loops[l].vertices);
    }
  }

  // Moves the triangulation of the loops of the last `update()` out of this object.
  Boundary_triangulation<Kernel> take()
  {
    Boundary_triangulation<Kernel> result;
    result.triangulation = std::move(m_triangulation);
    for(const Loop& loop : m_loops)
      result.vertices.insert(result.vertices.end(), loop.vertices.begin(), loop.vertices.end());
    m_loops.clear();
    m_number_of_loops = 0;
    return result;
  }

  const Triangulation& triangulation() const { return *m_triangulation; }

  // The loops without single points inside the face, which have no segments: these are vertices of the triangulation only.
  boost::iterator_range<typename std::vector<Loop>::const_iterator> loops() const
  {
    return {m_loops.begin(), m_loops.begin() + std::ptrdiff_t(m_number_of_loops)};
  }

  // The distance in space.
  static double length(Vertex_handle v, Vertex_handle w)
  {
    return std::sqrt(squared_distance(v->point().surface_point(), w->point().surface_point()));
  }

private:
  template <class Evaluator>
  void make(const Boundary_loops<Kernel>& loops, const Evaluator& evaluate)
  {
    m_triangulation = std::make_unique<Triangulation>();
    Boundary_triangulator<Kernel> triangulate(*m_triangulation, loops);
    triangulate(evaluate);
    auto vertices = triangulate.vertices().begin();
    m_loops.clear();
    for(const auto& loop : loops) {
      m_loops.push_back({{vertices, vertices + loop.size()}, {}});
      vertices += loop.size();
    }
  }

  bool is_of(const Boundary_loops<Kernel>& loops) const
  {
    return std::equal(loops.begin(), loops.end(), m_loops.begin(), m_loops.end(), [](const auto& loop, const Loop& own) {
      return std::equal(loop.begin(), loop.end(), own.vertices.begin(), own.vertices.end(),
                        [](const Vertex& vertex, Vertex_handle handle) { return is_at(handle, vertex.domain_point); });
    });
  }

  // Returns false if the loops differ in more than inserted middles, or if a segment with a new middle is no edge.
  template <class Evaluator>
  bool put_in_middles(const Boundary_loops<Kernel>& loops, const Evaluator& evaluate)
  {
    if(m_loops.size() != loops.size())
      return false;
    for(std::size_t l = 0; l < loops.size(); ++l)
      if(!are_among(m_loops[l].vertices, loops[l]))
        return false;
    for(std::size_t l = 0; l < loops.size(); ++l)
      put_in_middles(loops[l], evaluate, m_loops[l].vertices);
    for(std::size_t l = 0; l < loops.size(); ++l)
      if(!is_single_point(loops[l]) && !constrain(loops[l], m_loops[l].vertices))
        return false;
    Inner_segments inner_segments;
    for(std::size_t l = 0; l < loops.size(); ++l)
      if(lies_inside(loops[l]) && !is_single_point(loops[l]))
        add_inner_segments(m_loops[l].vertices.begin(), m_loops[l].vertices.end(), inner_segments);
    set_nesting_levels(*m_triangulation, inner_segments);
    return true;
  }

  static bool is_at(Vertex_handle vertex, const Point_2& p)
  {
    return vertex->point().x() == p.x() && vertex->point().y() == p.y();
  }

  // Whether the vertices occur among the points of the loop in their order, beginning with the first one.
  static bool are_among(const std::vector<Vertex_handle>& vertices, const std::vector<Vertex>& loop)
  {
    if(!is_at(vertices.front(), loop.front().domain_point))
      return false;
    auto next = vertices.begin();
    for(auto vertex = loop.begin(); vertex != loop.end() && next != vertices.end(); ++vertex)
      next += is_at(*next, vertex->domain_point);
    return next == vertices.end();
  }

  // Points may be inserted under varying tensors, since each flip is at the new vertex.
  template <class Evaluator>
  void put_in_middles(const std::vector<Vertex>& loop, const Evaluator& evaluate, std::vector<Vertex_handle>& vertices)
  {
    std::vector<Vertex_handle> result;
    auto next = vertices.begin();
    for(const Vertex& vertex : loop)
      if(next != vertices.end() && is_at(*next, vertex.domain_point))
        result.push_back(*next++);
      else {
        if(result.back() == *(next - 1)) // this is the first middle of its segment
          set_constraint(result.back(), next != vertices.end() ? *next : vertices.front(), false);
        const Point point = evaluate(vertex.domain_point, vertex.surface_point, 0).point;
        result.push_back(m_triangulation->insert(point, result.back()->face()));
        result.back()->set_on_boundary(true);
      }
    vertices.swap(result);
  }

  static void set_indices(const std::vector<Vertex>& loop, const std::vector<Vertex_handle>& vertices)
  {
    for(std::size_t i = 0; i < loop.size(); ++i)
      vertices[i]->set_index(loop[i].index);
  }

  bool constrain(const std::vector<Vertex>& loop, const std::vector<Vertex_handle>& vertices)
  {
    for(std::size_t i = 0; i < loop.size(); ++i)
      if(!set_constraint(vertices[i], vertices[(i + 1) % loop.size()], true))
        return false;
    return true;
  }

  // Returns false if there is no such edge.
  bool set_constraint(Vertex_handle v, Vertex_handle w, bool is_constrained)
  {
    Face_handle face;
    int i = 0;
    if(!m_triangulation->is_edge(v, w, face, i))
      return false;
    face->neighbor(i)->set_constraint(m_triangulation->mirror_index(face, i), is_constrained);
    face->set_constraint(i, is_constrained);
    return true;
  }

  static std::vector<std::size_t> segments(const std::vector<Vertex>& loop, std::size_t number_in_chart)
  {
    std::vector<std::size_t> result;
    for(std::size_t i = 0; i < loop.size(); ++i)
      if(number_in_chart == loop.size() || !is_collapsed_side(loop, i))
        result.push_back(i);
    return result;
  }

  static void set_spacings(const std::vector<Vertex_handle>& loop)
  {
    const std::size_t n = loop.size();
    for(std::size_t i = 0; i < n; ++i)
      loop[i]->set_spacing((std::min)(length(loop[(i + n - 1) % n], loop[i]), length(loop[i], loop[(i + 1) % n])));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_TRIANGULATED_BOUNDARY_H
