// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_DIVISION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_DIVISION_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/Boundary_loops.h>
#include <CGAL/Parametric_surface_mesher/internal/Boundary_size.h>
#include <CGAL/Parametric_surface_mesher/internal/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/Model_uses.h>
#include <CGAL/Parametric_surface_mesher/internal/Pointed_apex.h>
#include <CGAL/Parametric_surface_mesher/internal/criteria_of_face.h>
#include <CGAL/Parametric_surface_mesher/internal/least_numbers_of_pieces.h>
#include <CGAL/Parametric_surface_mesher/internal/name_face.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/divide_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The edges of a model, each divided once: its curve in space, or that on the first face that uses it, with the sizes of
// all faces that do.
template <class Oracle>
class Model_division
{
public:
  typedef typename Oracle::Geom_traits Kernel;
  typedef typename Oracle::Surface Surface;
  typedef Parametric_surface_model_3<Surface> Model;
  typedef typename Model::Edge_use Edge_use;
  typedef typename Kernel::Point_3 Point_3;

  // a piece of a divided edge, from its point `number` to the next one
  struct Piece
  {
    std::size_t edge, number;

    bool operator<(const Piece& other) const
    {
      return std::make_pair(edge, number) < std::make_pair(other.edge, other.number);
    }
  };

private:
  typedef typename Model_uses<Model>::Use Use;

  struct Division
  {
    std::vector<double> parameters;
    std::vector<Point_3> points;
    std::size_t first_inner_index = 0; // in the mesh, of the second point
    double smallest_piece = 0;         // in the parameter
    bool keeps_first_piece = false, keeps_last_piece = false;
  };

  static const std::size_t no_index = std::size_t(-1);
  static constexpr double smallest_share = 1. / 4096; // of a piece that is halved again and again

  const Model& m_model;
  const std::vector<Oracle>& m_oracles; // of the faces
  const Parametric_surface_mesh_criteria& m_criteria;
  Model_uses<Model> m_uses;
  std::vector<Parametric_surface_mesh_criteria> m_face_criteria;
  std::vector<Boundary_size<Oracle>> m_sizes; // of the faces
  std::vector<Division> m_divisions;          // of the edges
  std::vector<std::size_t> m_vertex_indices;  // in the mesh
  std::size_t m_number_of_points = 0;

public:
  Model_division(const Model& model, const std::vector<Oracle>& oracles,
                 const Parametric_surface_mesh_criteria& criteria)
    : m_model(model), m_oracles(oracles), m_criteria(criteria), m_uses(model), m_divisions(model.edges().size())
  {
    const auto curve = [](const Edge_use& use) -> const auto& { return use.curve; };
    for(const auto& face : model.faces())
      m_face_criteria.push_back(criteria_of_face(criteria, face));
    for(std::size_t f = 0; f < model.faces().size(); ++f)
      m_sizes.emplace_back(oracles[f], m_face_criteria[f], domain_box(model.faces()[f].loops, curve));
    const std::vector<std::size_t> least_numbers = least_numbers_of_pieces(model, m_uses);
    const Pointed_apexes<Model> apexes(model);
    for(std::size_t edge : m_uses.order())
      about_face(m_uses[edge].front().face, [&] {
        divide(edge, least_numbers[edge]);
        join_at_apexes(edge, least_numbers[edge], apexes);
      });
    number_vertices_first();
  }

  const Model& model() const { return m_model; }
  const Model_uses<Model>& uses() const { return m_uses; }
  std::size_t number_of_points() const { return m_number_of_points; }

  // the number of edges of the division
  std::size_t number_of_edges() const
  {
    std::size_t result = 0;
    for(std::size_t e : m_uses.order())
      if(!m_model.edges()[e].is_collapsed)
        result += number_of_pieces(e);
    return result;
  }

  std::size_t number_of_pieces(std::size_t edge) const { return m_divisions[edge].parameters.size() - 1; }

  // the index in the mesh of a point of a divided edge
  std::size_t index(std::size_t edge, std::size_t i) const
  {
    return i == 0                         ? m_vertex_indices[m_model.edges()[edge].source]
           : i == number_of_pieces(edge)  ? m_vertex_indices[m_model.edges()[edge].target]
                                          : m_divisions[edge].first_inner_index + i - 1;
  }

  // Indices: first the vertices that are used, then the inner points of the edges in the order of their first use.
  void number_vertices_first()
  {
    start_numbering();
    std::vector<bool> is_used(m_vertex_indices.size(), false);
    for(std::size_t e : m_uses.order())
      is_used[m_model.edges()[e].source] = is_used[m_model.edges()[e].target] = true;
    for(std::size_t v = 0; v < m_vertex_indices.size(); ++v)
      if(is_used[v])
        number_vertex(v);
    for(std::size_t e : m_uses.order())
      number_inner_points(e);
  }

  // Indices: along the edges in the order of their first use.
  // \pre all edges are directed as they are first used
  void number_along_edges()
  {
    start_numbering();
    for(std::size_t e : m_uses.order()) {
      number_vertex(m_model.edges()[e].source);
      number_inner_points(e);
    }
    for(std::size_t e : m_uses.order())
      number_vertex(m_model.edges()[e].target);
  }

  // Halves a piece at the middle of its parameters, unless it is too short already, or the number of pieces is prescribed.
  bool can_be_split(const Piece& piece) const
  {
    const Division& division = m_divisions[piece.edge];
    return !m_model.edges()[piece.edge].is_collapsed && prescribed_number(piece.edge) == 0
           && std::fabs(division.parameters[piece.number + 1] - division.parameters[piece.number]) > division.smallest_piece;
  }

  // Marks a piece, if it is at an end of its edge, as one that had better stay whole.
  void keep(const Piece& piece)
  {
    Division& division = m_divisions[piece.edge];
    division.keeps_first_piece |= piece.number == 0;
    division.keeps_last_piece |= piece.number + 1 == number_of_pieces(piece.edge);
  }

  bool is_kept(const Piece& piece) const
  {
    const Division& division = m_divisions[piece.edge];
    return (piece.number == 0 && division.keeps_first_piece)
           || (piece.number + 1 == number_of_pieces(piece.edge) && division.keeps_last_piece);
  }

  // \pre all can be split; they are in order
  template <class Pieces>
  void split(const Pieces& pieces)
  {
    for(auto piece = pieces.begin(); piece != pieces.end();) {
      const std::size_t edge = piece->edge;
      std::vector<std::size_t> numbers;
      for(; piece != pieces.end() && piece->edge == edge; ++piece)
        numbers.push_back(piece->number);
      split(edge, numbers);
    }
    number_vertices_first();
  }

  // the faces that use the edges of pieces
  template <class Pieces>
  std::vector<std::size_t> faces_at(const Pieces& pieces) const
  {
    std::set<std::size_t> result;
    for(const Piece& piece : pieces)
      for(const auto& use : m_uses[piece.edge])
        result.insert(use.face);
    return std::vector<std::size_t>(result.begin(), result.end());
  }

  // the divided boundary of a face
  Boundary_loops<Kernel> boundary_loops(std::size_t face) const
  {
    Boundary_loops<Kernel> result;
    std::map<std::size_t, std::vector<typename Kernel::Point_2>> corners; // domain points of each vertex
    const double tolerance = 1e-9 * (m_sizes[face].box().x_span() + m_sizes[face].box().y_span());
    for(const auto& loop : m_model.faces()[face].loops) {
      result.emplace_back();
      for(const Edge_use& use : loop) {
        const std::size_t first = result.back().size();
        append(use, result.back());
        snap(result.back()[first], corners[result.back()[first].index], tolerance);
      }
    }
    return result;
  }

  // the piece that a segment of the boundary of a face is
  Piece piece(std::size_t face, std::size_t loop, std::size_t segment) const
  {
    auto use = m_model.faces()[face].loops[loop].begin();
    for(; segment >= number_of_pieces(use->edge); ++use)
      segment -= number_of_pieces(use->edge);
    return {use->edge, use->is_reversed ? number_of_pieces(use->edge) - 1 - segment : segment};
  }

  // Puts all points and the edges of the division into an empty mesh.
  void append_to(Indexed_mesh<Kernel>& mesh) const
  {
    mesh.points.resize(m_number_of_points);
    mesh.domain_points.resize(m_number_of_points);
    for(std::size_t v = 0; v < m_vertex_indices.size(); ++v)
      if(m_vertex_indices[v] != no_index)
        mesh.points[m_vertex_indices[v]] = m_model.vertices()[v];
    for(std::size_t e : m_uses.order()) {
      const Division& division = m_divisions[e];
      for(std::size_t i = 1; i + 1 < division.points.size(); ++i)
        mesh.points[index(e, i)] = division.points[i];
      for(const auto& shell : m_uses.by_shell(e))
        for(std::size_t i = 0; i < number_of_pieces(e); ++i)
          mesh.chords[shell.first].emplace(std::minmax(index(e, i), index(e, i + 1)));
    }
  }

  // Vertices where several pieces of the mesh may meet: those of the model, and all of edges that are not manifold.
  std::vector<std::size_t> meeting_points() const
  {
    std::vector<std::size_t> result;
    for(std::size_t index : m_vertex_indices)
      if(index != no_index)
        result.push_back(index);
    for(std::size_t e : m_uses.order())
      if(!m_uses.is_manifold(e))
        for(std::size_t i = 1; i < number_of_pieces(e); ++i)
          result.push_back(index(e, i));
    return result;
  }

private:
  std::size_t prescribed_number(std::size_t edge) const
  {
    std::size_t result = 0;
    for(const Use& use : m_uses[edge])
      result = (std::max)(result, std::size_t(use.use->curve.number_of_edges()));
    return result;
  }

  // Calls `function` with the curve of an edge in space.
  template <class Function>
  auto with_curve(std::size_t edge, Function function) const
  {
    if(m_model.edges()[edge].curve)
      return function(*m_model.edges()[edge].curve);
    const Use& use = m_uses[edge].front();
    return function(Curve_on_surface_3<Surface>(m_oracles[use.face].surface(), use.use->curve));
  }

  void divide(std::size_t number, std::size_t least_number_of_pieces)
  {
    Division& division = m_divisions[number];
    const std::size_t prescribed = prescribed_number(number);
    if(prescribed > 0 && prescribed < least_number_of_pieces && m_uses[number].size() > 1)
      throw Parametric_surface_mesh_error("edge " + std::to_string(number) + " is to be divided into "
                                          + std::to_string(prescribed) + " pieces, but it needs at least "
                                          + std::to_string(least_number_of_pieces)
                                          + ": with fewer, edges of the mesh would coincide");
    with_curve(number, [&](const auto& curve) {
      if(m_model.edges()[number].is_collapsed)
        division.parameters = {curve.begin(), curve.end()};
      else
        division.parameters = divide_curve(curve, criteria_of_edge(number), [&](double t) { return spacing_limit(number, t); },
                                           least_number_of_pieces, prescribed);
      for(double t : division.parameters)
        division.points.push_back(curve.point(t));
    });
    division.points.front() = m_model.vertices()[m_model.edges()[number].source];
    division.points.back() = m_model.vertices()[m_model.edges()[number].target];
    double smallest = std::fabs(division.parameters.back() - division.parameters.front());
    for(std::size_t i = 0; i + 1 < division.parameters.size(); ++i)
      smallest = (std::min)(smallest, std::fabs(division.parameters[i + 1] - division.parameters[i]));
    division.smallest_piece = smallest_share * smallest;
  }

  // makes the first two pieces at an end one, where that end is a pointed apex
  void join_at_apexes(std::size_t edge, std::size_t least_number_of_pieces, const Pointed_apexes<Model>& apexes)
  {
    Division& division = m_divisions[edge];
    for(bool is_at_source : {true, false}) {
      const std::size_t n = number_of_pieces(edge);
      if(n <= (std::max)(least_number_of_pieces, std::size_t(2)) || prescribed_number(edge) > 0)
        return;
      const auto squared_length = [&](std::size_t i, std::size_t k) {
        return squared_distance(division.points[is_at_source ? i : n - i], division.points[is_at_source ? k : n - k]);
      };
      const std::size_t vertex = is_at_source ? m_model.edges()[edge].source : m_model.edges()[edge].target;
      const double length = std::sqrt(squared_length(0, 2));
      if(length <= criteria_of_edge(edge).max_edge() && squared_length(1, 2) < 1.1 * squared_length(0, 1)
         && apexes.asks_for_one_piece(edge, vertex, length, m_criteria.min_edge())) {
        division.parameters.erase(division.parameters.begin() + (is_at_source ? 1 : n - 1));
        division.points.erase(division.points.begin() + (is_at_source ? 1 : n - 1));
      }
    }
  }

  // with the smallest of the sizes that the edge and its faces have of their own
  Parametric_surface_mesh_criteria criteria_of_edge(std::size_t edge) const
  {
    Parametric_surface_mesh_criteria result = m_criteria;
    limit_max_edge(m_model.edges()[edge].max_edge, result);
    for(const Use& use : m_uses[edge])
      limit_max_edge(m_model.faces()[use.face].max_edge, result);
    return result;
  }

  double spacing_limit(std::size_t edge, double t) const
  {
    double limit = m_criteria.max_edge();
    for(const Use& use : m_uses[edge])
      limit = (std::min)(limit, m_sizes[use.face](use.use->curve, t, use.is_domain_left));
    return limit;
  }

  void start_numbering()
  {
    m_vertex_indices.assign(m_model.vertices().size(), std::size_t(no_index));
    m_number_of_points = 0;
  }

  void number_vertex(std::size_t v)
  {
    if(m_vertex_indices[v] == no_index)
      m_vertex_indices[v] = m_number_of_points++;
  }

  void number_inner_points(std::size_t edge)
  {
    m_divisions[edge].first_inner_index = m_number_of_points;
    m_number_of_points += m_divisions[edge].parameters.size() - 2;
  }

  void split(std::size_t edge, const std::vector<std::size_t>& numbers)
  {
    Division& division = m_divisions[edge];
    std::vector<double> parameters;
    std::vector<Point_3> points;
    auto next = numbers.begin();
    for(std::size_t i = 0; i < division.parameters.size(); ++i) {
      parameters.push_back(division.parameters[i]);
      points.push_back(division.points[i]);
      if(next != numbers.end() && *next == i) {
        const double t = 0.5 * (division.parameters[i] + division.parameters[i + 1]);
        parameters.push_back(t);
        points.push_back(with_curve(edge, [&](const auto& curve) { return curve.point(t); }));
        ++next;
      }
    }
    division.parameters.swap(parameters);
    division.points.swap(points);
  }

  // the points of a use but for its last one, which begins the next use
  void append(const Edge_use& use, std::vector<Boundary_vertex<Kernel>>& loop) const
  {
    const Division& division = m_divisions[use.edge];
    const std::size_t n = number_of_pieces(use.edge);
    for(std::size_t k = 0; k < n; ++k) {
      const std::size_t i = use.is_reversed ? n - k : k;
      loop.push_back({use.curve.point(division.parameters[i]), division.points[i], index(use.edge, i)});
    }
  }

  // Loops that touch in a vertex have exactly the same point there.
  static void snap(Boundary_vertex<Kernel>& vertex, std::vector<typename Kernel::Point_2>& corners, double tolerance)
  {
    for(const auto& corner : corners)
      if(squared_distance(corner, vertex.domain_point) <= tolerance * tolerance) {
        vertex.domain_point = corner;
        return;
      }
    corners.push_back(vertex.domain_point);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_DIVISION_H
