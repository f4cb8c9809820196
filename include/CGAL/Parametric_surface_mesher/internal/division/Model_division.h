// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_MODEL_DIVISION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_MODEL_DIVISION_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Pointed_apex.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Corners_of_face.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Edge_division.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Point_numbering.h>
#include <CGAL/Parametric_surface_mesher/internal/model/Bad_faces.h>
#include <CGAL/Parametric_surface_mesher/internal/model/Model_uses.h>
#include <CGAL/Parametric_surface_mesher/internal/model/inner_elements.h>
#include <CGAL/Parametric_surface_mesher/internal/model/least_numbers_of_pieces.h>
#include <CGAL/Parametric_surface_mesher/internal/model/name_face.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Mesh_progress.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>
#include <CGAL/Parametric_surface_model_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The divided edges of a model, with the indices of their points in the mesh and the boundaries of faces that they form.
template <class Oracle>
class Model_division
{
public:
  typedef typename Oracle::Geom_traits Kernel;
  typedef typename Oracle::Surface Surface;
  typedef Parametric_surface_model_3<Surface> Model;
  typedef typename Model::Edge_use Edge_use;
  typedef typename Kernel::Point_3 Point_3;

  // A piece of a divided edge, from its point `number` to the next one.
  struct Piece
  {
    std::size_t edge, number;

    bool operator<(const Piece& other) const
    {
      return std::make_pair(edge, number) < std::make_pair(other.edge, other.number);
    }
  };

private:
  typedef typename Kernel::Point_2 Point_2;
  typedef std::vector<Point_2> Domain_points;

  const Model& m_model;
  Edge_divider<Oracle> m_divider;
  std::vector<Edge_division<Kernel>> m_divisions;          // by edge
  std::vector<std::vector<Domain_points>> m_domain_points; // by edge and use, so that each curve is evaluated once
  Point_numbering m_numbering;
  std::set<std::size_t> m_changed_edges; // see `take_changed_faces()`
  Bad_faces& m_bad_faces;

public:
  // A face that is the cause of an error is left out, if bad faces are to be.
  Model_division(const Model& model, const std::vector<Oracle>& oracles,
                 const Parametric_surface_mesh_criteria& criteria, Bad_faces& bad_faces, Patch_progress& progress)
    : m_model(model), m_divider(model, oracles, criteria, progress), m_divisions(model.edges().size()),
      m_domain_points(model.edges().size()), m_numbering(model.vertices().size(), model.edges().size()),
      m_bad_faces(bad_faces)
  {
    const std::vector<std::size_t> least_numbers = least_numbers_of_pieces(model, uses());
    const Pointed_apexes<Model> apexes(model);
    const std::vector<std::size_t> edges = uses().order();
    for(std::size_t edge : edges)
      change(edge, [&] {
        about_face(uses()[edge].front().face, [&] {
          Edge_division<Kernel> division = m_divider.divide(edge, least_numbers[edge]);
          m_divider.join_at_apexes(edge, least_numbers[edge], apexes, division);
          m_divisions[edge] = std::move(division);
        });
        m_domain_points[edge] = domain_points_at(edge, m_divisions[edge].parameters);
      });
    m_changed_edges.insert(uses().order().begin(), uses().order().end());
    number_vertices_first();
  }

  // Calls `function`, which concerns a face. Returns whether that face is good: if it is the cause of an error, it is left
  // out, or the error thrown on, as is wanted of bad faces. The division of edges that others use, too, stays.
  template <class Function>
  bool is_done_for(std::size_t face, const Function& function)
  {
    if(m_bad_faces.contains(face))
      return false;
    try {
      function();
      return true;
    }
    catch(const Parametric_surface_mesh_error& error) {
      if(!m_bad_faces.contains(face)) // else it was left out while the function went on
        leave_out(m_bad_faces.add(error));
      return false;
    }
  }

  // The face uses no edge any more. Points have new indices only when they are numbered again.
  void leave_out(std::size_t face)
  {
    for(const auto& loop : m_model.faces()[face].loops)
      for(const Edge_use& use : loop) {
        const auto& uses_of_edge = uses()[use.edge];
        auto& points = m_domain_points[use.edge];
        if(points.size() != uses_of_edge.size())
          continue; // the edge is not divided yet; or the loop comes to it again
        for(std::size_t i = points.size(); i-- > 0;)
          if(uses_of_edge[i].face == face)
            points.erase(points.begin() + std::ptrdiff_t(i));
      }
    m_divider.leave_out(face);
  }

  const Model& model() const { return m_model; }
  const Model_uses<Model>& uses() const { return m_divider.uses(); }

  // The bounding box of the loops of a face in its domain.
  const Bbox_2& box(std::size_t face) const { return m_divider.box(face); }

  std::size_t number_of_points() const { return m_numbering.number_of_points(); }

  // The number of edges of the division.
  std::size_t number_of_edges() const
  {
    std::size_t result = 0;
    for(std::size_t e : uses().order())
      if(!m_model.edges()[e].is_collapsed)
        result += number_of_pieces(e);
    return result;
  }

  std::size_t number_of_pieces(std::size_t edge) const { return m_divisions[edge].parameters.size() - 1; }

  // The index in the mesh of point `i` of a divided edge.
  std::size_t index(std::size_t edge, std::size_t i) const
  {
    return i == 0                        ? m_numbering.vertex(m_model.edges()[edge].source)
           : i == number_of_pieces(edge) ? m_numbering.vertex(m_model.edges()[edge].target)
                                         : m_numbering.inner_point(edge, i - 1);
  }

  // Gives indices first to the vertices that are used, then to the inner points of the edges in the order of their first use.
  void number_vertices_first()
  {
    m_numbering.clear();
    std::vector<bool> is_used(m_model.vertices().size(), false);
    for(std::size_t e : uses().order())
      is_used[m_model.edges()[e].source] = is_used[m_model.edges()[e].target] = true;
    for(std::size_t v : inner_points())
      is_used[v] = true;
    for(std::size_t v = 0; v < is_used.size(); ++v)
      if(is_used[v])
        m_numbering.add_vertex(v);
    for(std::size_t e : uses().order())
      m_numbering.add_inner_points(e, number_of_pieces(e) - 1);
  }

  // Gives indices along the edges in the order of their first use.
  // \pre the first use of each edge runs in its direction
  void number_along_edges()
  {
    m_numbering.clear();
    for(std::size_t e : uses().order()) {
      m_numbering.add_vertex(m_model.edges()[e].source);
      m_numbering.add_inner_points(e, number_of_pieces(e) - 1);
    }
    for(std::size_t e : uses().order())
      m_numbering.add_vertex(m_model.edges()[e].target);
    for(std::size_t v : inner_points())
      m_numbering.add_vertex(v);
  }

  // The vertices inside faces that are not left out.
  std::vector<std::size_t> inner_points() const { return internal::inner_points(m_model, m_bad_faces); }

  // Whether a piece may be halved: not if it is too short already, or if the number of pieces is prescribed.
  bool can_be_split(const Piece& piece) const
  {
    const Edge_division<Kernel>& division = m_divisions[piece.edge];
    return !m_model.edges()[piece.edge].is_collapsed && m_divider.prescribed_number(piece.edge) == 0
           && std::fabs(division.parameters[piece.number + 1] - division.parameters[piece.number]) > division.smallest_piece;
  }

  const std::vector<double>& parameters(std::size_t edge) const { return m_divisions[edge].parameters; }

  // The point of an edge at a parameter of its curve.
  Point_3 point(std::size_t edge, double t) const { return m_divider.point(edge, t); }

  // Replaces the points of an edge.
  // \pre the points at its ends are the same as before
  void set_parameters(std::size_t edge, const std::vector<double>& parameters)
  {
    const std::size_t old_number = number_of_pieces(edge), old_number_of_uses = uses()[edge].size();
    change(edge, [&] {
      Edge_division<Kernel> division = m_divisions[edge];
      division.points.resize(1);
      for(std::size_t i = 1; i + 1 < parameters.size(); ++i)
        division.points.push_back(m_divider.point(edge, parameters[i]));
      division.points.push_back(m_model.vertices()[m_model.edges()[edge].target]);
      division.parameters = parameters;
      m_domain_points[edge] = domain_points_at(edge, parameters);
      m_divisions[edge] = std::move(division);
      m_changed_edges.insert(edge);
    });
    if(number_of_pieces(edge) != old_number || uses()[edge].size() != old_number_of_uses)
      number_vertices_first();
  }

  // Marks a piece as one that should not be halved, if it is at an end of its edge.
  void keep(const Piece& piece)
  {
    Edge_division<Kernel>& division = m_divisions[piece.edge];
    division.keeps_first_piece |= piece.number == 0;
    division.keeps_last_piece |= piece.number + 1 == number_of_pieces(piece.edge);
  }

  bool is_kept(const Piece& piece) const
  {
    const Edge_division<Kernel>& division = m_divisions[piece.edge];
    return (piece.number == 0 && division.keeps_first_piece)
           || (piece.number + 1 == number_of_pieces(piece.edge) && division.keeps_last_piece);
  }

  // Halves pieces. Those that no face uses any more stay whole.
  // \pre all of them can be split, and they are in ascending order
  template <class Pieces>
  void split(const Pieces& pieces)
  {
    for(auto piece = pieces.begin(); piece != pieces.end();) {
      const std::size_t edge = piece->edge;
      std::vector<std::size_t> numbers;
      for(; piece != pieces.end() && piece->edge == edge; ++piece)
        numbers.push_back(piece->number);
      change(edge, [&] { split(edge, numbers); });
    }
    number_vertices_first();
  }

  // The faces with edges whose division has changed since the last call.
  std::vector<std::size_t> take_changed_faces()
  {
    std::set<std::size_t> result;
    for(std::size_t edge : m_changed_edges)
      for(const auto& use : uses()[edge])
        result.insert(use.face);
    m_changed_edges.clear();
    return std::vector<std::size_t>(result.begin(), result.end());
  }

  // The faces that use the edges of these pieces.
  template <class Pieces>
  std::vector<std::size_t> faces_at(const Pieces& pieces) const
  {
    std::set<std::size_t> result;
    for(const Piece& piece : pieces)
      for(const auto& use : uses()[piece.edge])
        result.insert(use.face);
    return std::vector<std::size_t>(result.begin(), result.end());
  }

  // The divided boundary of a face.
  Boundary_loops<Kernel> boundary_loops(std::size_t face) const
  {
    Boundary_loops<Kernel> result;
    const double rounding = 1e-9; // of points at the ends of curves, relative to the domain
    Corners_of_face<Kernel> corners(rounding * (m_divider.box(face).x_span() + m_divider.box(face).y_span()));
    for(const auto& loop : m_model.faces()[face].loops) {
      result.emplace_back();
      result.back().reserve(number_of_segments(loop));
      for(const Edge_use& use : loop) {
        const std::size_t first = result.back().size();
        append(use, result.back());
        corners.snap(result.back()[first]);
      }
    }
    for(const auto& point : m_model.faces()[face].inner_points)
      result.push_back({2, {point.parameters, m_model.vertices()[point.vertex], m_numbering.vertex(point.vertex)}});
    return result;
  }

  // The piece of an edge that is this segment of the boundary of a face.
  Piece piece(std::size_t face, std::size_t loop, std::size_t segment) const
  {
    auto use = m_model.faces()[face].loops[loop].begin();
    for(; segment >= number_of_pieces(use->edge); ++use)
      segment -= number_of_pieces(use->edge);
    return {use->edge, use->is_reversed ? number_of_pieces(use->edge) - 1 - segment : segment};
  }

  // The points of a divided edge.
  const std::vector<Point_3>& points(std::size_t edge) const { return m_divisions[edge].points; }

  // Whether a vertex of the model belongs to an edge that is used.
  bool is_used(std::size_t vertex) const { return m_numbering.has_vertex(vertex); }

  // The index in the mesh of a vertex of the model that is used.
  std::size_t vertex_index(std::size_t vertex) const { return m_numbering.vertex(vertex); }

private:
  // Calls `function`, which divides an edge, and changes nothing if it fails. A face that is the cause of an error is left
  // out; then the edge is divided for the others.
  template <class Function>
  void change(std::size_t edge, const Function& function)
  {
    while(!uses()[edge].empty())
      try {
        function();
        return;
      }
      catch(const Parametric_surface_mesh_error& error) {
        leave_out(m_bad_faces.add(error));
      }
  }

  // for each use
  std::vector<Domain_points> domain_points_at(std::size_t edge, const std::vector<double>& parameters) const
  {
    std::vector<Domain_points> result;
    for(const auto& use : uses()[edge]) {
      result.emplace_back();
      for(double t : parameters)
        result.back().push_back(domain_point(use, t));
    }
    return result;
  }

  template <class Use>
  Point_2 domain_point(const Use& use, double t) const
  {
    return with_name_of_face(m_model, use.face, [&] { return use.use->curve.point(t); });
  }

  const Domain_points& domain_points(const Edge_use& use) const
  {
    std::size_t i = 0;
    while(uses()[use.edge][i].use != &use)
      ++i;
    return m_domain_points[use.edge][i];
  }

  void split(std::size_t edge, const std::vector<std::size_t>& numbers)
  {
    Edge_division<Kernel>& division = m_divisions[edge];
    const auto middle = [&t = division.parameters](std::size_t i) { return 0.5 * (t[i] + t[i + 1]); };
    std::vector<Domain_points> domain_points;
    for(std::size_t u = 0; u < m_domain_points[edge].size(); ++u)
      domain_points.push_back(with_middles(m_domain_points[edge][u], numbers,
                                           [&](std::size_t i) { return domain_point(uses()[edge][u], middle(i)); }));
    std::vector<Point_3> points
      = with_middles(division.points, numbers, [&](std::size_t i) { return m_divider.point(edge, middle(i)); });
    division.parameters = with_middles(division.parameters, numbers, middle);
    division.points.swap(points);
    m_domain_points[edge].swap(domain_points);
    m_changed_edges.insert(edge);
  }

  // Appends the points of a use except for the last one, with which the next use begins.
  void append(const Edge_use& use, std::vector<Boundary_vertex<Kernel>>& loop) const
  {
    const Edge_division<Kernel>& division = m_divisions[use.edge];
    const Domain_points& points = domain_points(use);
    const std::size_t n = number_of_pieces(use.edge);
    for(std::size_t k = 0; k < n; ++k) {
      const std::size_t i = use.is_reversed ? n - k : k;
      loop.push_back({points[i], division.points[i], index(use.edge, i)});
    }
  }

  std::size_t number_of_segments(const typename Model::Loop& loop) const
  {
    return std::accumulate(loop.begin(), loop.end(), std::size_t(0),
                           [this](std::size_t n, const Edge_use& use) { return n + number_of_pieces(use.edge); });
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_MODEL_DIVISION_H
