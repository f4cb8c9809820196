// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_EDGE_DIVISION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_EDGE_DIVISION_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/charts/Pointed_apex.h>
#include <CGAL/Parametric_surface_mesher/internal/model/Model_uses.h>
#include <CGAL/Parametric_surface_mesher/internal/model/criteria_of_face.h>
#include <CGAL/Parametric_surface_mesher/internal/model/name_face.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Boundary_size.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Mesh_progress.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Parametric_surface_mesher/divide_curve.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The values at the points of an edge, with one more in the middle of some pieces: `make(i)` in that of piece `i`.
// `numbers`: of these pieces, in ascending order
template <class Value, class Make>
std::vector<Value> with_middles(const std::vector<Value>& values, const std::vector<std::size_t>& numbers, const Make& make)
{
  std::vector<Value> result;
  result.reserve(values.size() + numbers.size());
  auto next = numbers.begin();
  for(std::size_t i = 0; i < values.size(); ++i) {
    result.push_back(values[i]);
    if(next != numbers.end() && *next == i)
      result.push_back(make(*next++));
  }
  return result;
}

// The points of a divided edge.
template <class Kernel>
struct Edge_division
{
  std::vector<double> parameters;
  std::vector<typename Kernel::Point_3> points;
  double smallest_piece = 0;         // in parameters: pieces are not halved below this
  bool keeps_first_piece = false, keeps_last_piece = false;
};

// Divides the edges of a model. Each edge is divided once, along its own curve in space or else its image on the first face that
// uses it, with the sizes of all faces that use it.
template <class Oracle>
class Edge_divider
{
public:
  typedef typename Oracle::Geom_traits Kernel;
  typedef typename Oracle::Surface Surface;
  typedef Parametric_surface_model_3<Surface> Model;

private:
  typedef typename Model::Edge_use Edge_use;
  typedef typename Model_uses<Model>::Use Use;

  // The squared ratio of two pieces that count as equally long: 1.05 for the lengths.
  static constexpr double squared_ratio_of_equal_pieces = 1.1;
  static constexpr double smallest_share = 1. / 4096; // pieces are halved 12 times at most
  // Of a bent edge that is not divided by size, since the run is stopped: with fewer, holes could come to lie outside.
  static constexpr std::size_t number_of_pieces_after_stop = 16;

  // Thrown to get out of a division by size.
  struct Stopped
  {};

  const Model& m_model;
  const std::vector<Oracle>& m_oracles; // by face
  const Parametric_surface_mesh_criteria& m_criteria;
  Model_uses<Model> m_uses;
  std::vector<Parametric_surface_mesh_criteria> m_face_criteria;
  std::vector<Boundary_size<Oracle>> m_sizes; // by face
  Patch_progress& m_progress;

public:
  Edge_divider(const Model& model, const std::vector<Oracle>& oracles, const Parametric_surface_mesh_criteria& criteria,
               Patch_progress& progress)
    : m_model(model), m_oracles(oracles), m_criteria(criteria), m_uses(model), m_progress(progress)
  {
    const auto curve = [](const Edge_use& use) -> const auto& { return use.curve; };
    for(const auto& face : model.faces())
      m_face_criteria.push_back(criteria_of_face(criteria, face));
    for(std::size_t f = 0; f < model.faces().size(); ++f)
      m_sizes.emplace_back(oracles[f], m_face_criteria[f], domain_box(model.faces()[f].loops, curve));
  }

  const Model_uses<Model>& uses() const { return m_uses; }

  // Edges that no face uses any more are not to be divided.
  void leave_out(std::size_t face) { m_uses.leave_out(face); }

  // The bounding box of the loops of a face in its domain.
  const Bbox_2& box(std::size_t face) const { return m_sizes[face].box(); }

  // The prescribed number of pieces, or 0 if there is none.
  std::size_t prescribed_number(std::size_t edge) const
  {
    std::size_t result = 0;
    for(const Use& use : m_uses[edge])
      result = (std::max)(result, std::size_t(use.use->curve.number_of_edges()));
    return result;
  }

  // The point of an edge at a parameter of its curve.
  typename Kernel::Point_3 point(std::size_t edge, double t) const
  {
    return with_curve(edge, [&](const auto& curve) { return curve.point(t); });
  }

  Edge_division<Kernel> divide(std::size_t number, std::size_t least_number_of_pieces) const
  {
    Edge_division<Kernel> division;
    const std::size_t prescribed = prescribed_number(number);
    if(prescribed > 0 && prescribed < least_number_of_pieces && m_uses[number].size() > 1)
      throw Parametric_surface_mesh_error(numbered("edge", number) + " is to be divided into "
                                          + std::to_string(prescribed) + " pieces, but it needs at least "
                                          + std::to_string(least_number_of_pieces)
                                          + ": with fewer, edges of the mesh would coincide");
    with_curve(number, [&](const auto& curve) {
      if(m_model.edges()[number].is_collapsed)
        division.parameters = {curve.begin(), curve.end()};
      else
        division.parameters = parameters(number, curve, least_number_of_pieces, prescribed);
      for(double t : division.parameters)
        division.points.push_back(curve.point(t));
    });
    division.points.front() = m_model.vertices()[m_model.edges()[number].source];
    division.points.back() = m_model.vertices()[m_model.edges()[number].target];
    double smallest = std::fabs(division.parameters.back() - division.parameters.front());
    for(std::size_t i = 0; i + 1 < division.parameters.size(); ++i)
      smallest = (std::min)(smallest, std::fabs(division.parameters[i + 1] - division.parameters[i]));
    division.smallest_piece = smallest_share * smallest;
    return division;
  }

  // Joins the first two pieces at an end that is a pointed apex, and more of them where the edges opposite to it would be too short.
  void join_at_apexes(std::size_t edge, std::size_t least_number_of_pieces, const Pointed_apexes<Model>& apexes,
                      Edge_division<Kernel>& division) const
  {
    for(bool is_at_source : {true, false})
      for(bool is_first = true; joins_at_apex(edge, least_number_of_pieces, apexes, division, is_at_source, is_first); is_first = false) {
        const std::ptrdiff_t i = is_at_source ? 1 : std::ptrdiff_t(division.parameters.size()) - 2;
        division.parameters.erase(division.parameters.begin() + i);
        division.points.erase(division.points.begin() + i);
        // Closeness would halve so long a piece where the face is narrow.
        (is_at_source ? division.keeps_first_piece : division.keeps_last_piece) |= !is_first;
      }
  }

private:
  // `is_first`: whether none have been joined at this end
  bool joins_at_apex(std::size_t edge, std::size_t least_number_of_pieces, const Pointed_apexes<Model>& apexes,
                     const Edge_division<Kernel>& division, bool is_at_source, bool is_first) const
  {
    const std::size_t n = division.parameters.size() - 1;
    if(n <= (std::max)(least_number_of_pieces, std::size_t(2)) || prescribed_number(edge) > 0)
      return false;
    const auto squared_length = [&](std::size_t i, std::size_t k) {
      return squared_distance(division.points[is_at_source ? i : n - i], division.points[is_at_source ? k : n - k]);
    };
    const std::size_t vertex = is_at_source ? m_model.edges()[edge].source : m_model.edges()[edge].target;
    const double length = std::sqrt(squared_length(0, 2));
    const bool is_wanted = is_first ? squared_length(1, 2) < squared_ratio_of_equal_pieces * squared_length(0, 1)
                                    : apexes.asks_for_longer_piece(edge, vertex, std::sqrt(squared_length(0, 1)), m_criteria.min_edge());
    return is_wanted && length <= criteria_of_edge(edge).max_edge()
           && apexes.asks_for_one_piece(edge, vertex, length, m_criteria.min_edge());
  }

  // Calls `function` with the curve of an edge in space. Errors are those of the first face that uses it.
  template <class Function>
  auto with_curve(std::size_t edge, Function function) const
  {
    if(m_uses[edge].empty())
      throw Parametric_surface_mesh_error(numbered("edge", edge) + " is used by no face");
    const Use& use = m_uses[edge].front();
    return about_face(use.face, [&] {
      if(m_model.edges()[edge].curve)
        return function(*m_model.edges()[edge].curve);
      return function(Curve_on_surface_3<Surface>(m_oracles[use.face].surface(), use.use->curve));
    });
  }

  template <class Curve>
  std::vector<double> parameters(std::size_t edge, const Curve& curve, std::size_t least_number_of_pieces,
                                 std::size_t prescribed_number) const
  {
    if(!m_progress.go_further())
      return equal_parameters(edge, curve, least_number_of_pieces, prescribed_number);
    try {
      return divide_curve(
        curve, criteria_of_edge(edge),
        [&](double t) {
          if(!m_progress.go_further())
            throw Stopped();
          return spacing_limit(edge, t);
        },
        least_number_of_pieces, prescribed_number);
    }
    catch(const Stopped&) {
      return equal_parameters(edge, curve, least_number_of_pieces, prescribed_number);
    }
  }

  // without a look at sizes
  template <class Curve>
  std::vector<double> equal_parameters(std::size_t edge, const Curve& curve, std::size_t least_number_of_pieces,
                                       std::size_t prescribed_number) const
  {
    const bool is_straight = std::all_of(m_uses[edge].begin(), m_uses[edge].end(),
                                         [](const Use& use) { return use.use->curve.is_straight(); });
    std::size_t n = prescribed_number;
    if(n == 0)
      n = (std::max)(least_number_of_pieces, is_straight ? 1 : std::size_t(number_of_pieces_after_stop));
    std::vector<double> result;
    for(std::size_t i = 0; i < n; ++i)
      result.push_back(curve.begin() + double(i) / double(n) * (curve.end() - curve.begin()));
    result.push_back(curve.end());
    return result;
  }

  // The criteria with the smallest of the sizes that the edge and its faces have.
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
      limit = (std::min)(limit, about_face(use.face, [&] { return m_sizes[use.face](use.use->curve, t, use.is_domain_left); }));
    return limit;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_EDGE_DIVISION_H
