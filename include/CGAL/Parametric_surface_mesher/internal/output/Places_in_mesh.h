// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_PLACES_IN_MESH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_PLACES_IN_MESH_H

#include <CGAL/Parametric_surface_mesher/Model_places.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Place_in_model.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Border_edges.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Where the vertices and edges of a finished mesh lie in the model.
template <class Division>
class Places_in_mesh
{
  typedef typename Division::Kernel Kernel;
  typedef Indexed_mesh<Kernel> Mesh;
  typedef typename Border_edges<Kernel>::Side Side;

  // A model's edge that an edge of the mesh runs along, with the numbers of the ends among the points of its division.
  struct Run
  {
    std::size_t edge;
    std::array<std::size_t, 2> numbers;

    bool is_piece() const { return numbers[0] + 1 == numbers[1] || numbers[1] + 1 == numbers[0]; }
  };

  const Division& m_division;
  const Mesh& m_mesh;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> m_edges; // by their vertices, the smaller one first

public:
  Places_in_mesh(const Division& division, const Mesh& mesh) : m_division(division), m_mesh(mesh)
  {
    for(std::size_t e : division.uses().order())
      m_edges[std::minmax(edge(e).source, edge(e).target)].push_back(e);
  }

  // That of a point that parts share.
  Vertex_place vertex(std::size_t point) const
  {
    const Place_in_model& place = m_mesh.places[point];
    if(place.dimension != 1)
      return {place.dimension, place.entity, 0};
    if(place.entity == Place_in_model::none)
      return {1, Vertex_place::none, std::numeric_limits<double>::quiet_NaN()};
    return {1, place.entity, parameter(place.entity, place.number)};
  }

  // That of the edge of one side, or of two that are joined, from the source of the first one.
  Edge_place edge(const Side& side, const Side* joined) const
  {
    const Place_in_model source = place(m_mesh.parts[side.part].source(side.side)),
                         target = place(m_mesh.parts[side.part].target(side.side));
    if(source.dimension == 2 || target.dimension == 2)
      return {};
    const Run run = this->run(source, target, m_mesh.parts[side.part].patch);
    if(run.edge != Place_in_model::none && run.is_piece())
      return {run.edge, {parameter(run.edge, run.numbers[0]), parameter(run.edge, run.numbers[1])}};
    return is_on_border_of_patch(side, joined) ? place_of(run) : Edge_place();
  }

private:
  const typename Division::Model::Edge& edge(std::size_t e) const { return m_division.model().edges()[e]; }

  double parameter(std::size_t edge, std::size_t number) const
  {
    const auto& parameters = m_division.parameters(edge);
    return number < parameters.size() ? parameters[number] : std::numeric_limits<double>::quiet_NaN();
  }

  Place_in_model place(std::size_t vertex) const
  {
    const std::size_t point = m_mesh.original(vertex);
    return point < m_mesh.places.size() ? m_mesh.places[point] : Place_in_model();
  }

  Edge_place place_of(const Run& run) const
  {
    return run.edge == Place_in_model::none
             ? Edge_place()
             : Edge_place{run.edge, {parameter(run.edge, run.numbers[0]), parameter(run.edge, run.numbers[1])}};
  }

  // The edge that an edge of the mesh between two places runs along; where the mesh was cured it may have no ends on it.
  Run run(const Place_in_model& source, const Place_in_model& target, std::size_t patch) const
  {
    if(source.dimension == 0 && target.dimension == 0)
      return run_between_vertices(source.entity, target.entity, patch);
    if(source.dimension == 1 && target.dimension == 1)
      return {source.entity != Place_in_model::none ? source.entity : target.entity,
              {source.number, source.entity == target.entity ? target.number : Place_in_model::none}};
    return source.dimension == 1 ? Run{source.entity, {source.number, number_of_end(source, target.entity)}}
                                 : Run{target.entity, {number_of_end(target, source.entity), target.number}};
  }

  // An edge of one piece is preferred, and then one that the patch uses.
  Run run_between_vertices(std::size_t source, std::size_t target, std::size_t patch) const
  {
    const auto found = m_edges.find(std::minmax(source, target));
    if(found == m_edges.end())
      return {Place_in_model::none, {}};
    std::size_t best = found->second.front();
    for(std::size_t e : found->second)
      if(rank(e, patch) < rank(best, patch))
        best = e;
    const std::size_t last = m_division.number_of_pieces(best);
    return edge(best).source == source ? Run{best, {0, last}} : Run{best, {last, 0}};
  }

  int rank(std::size_t edge, std::size_t patch) const
  {
    bool is_used = false;
    for(const auto& use : m_division.uses()[edge])
      is_used = is_used || use.face == patch;
    return 2 * (m_division.number_of_pieces(edge) != 1) + !is_used;
  }

  // Among the points of an edge, the number of the end that is this vertex; of a closed edge, the end that is closer to a point.
  std::size_t number_of_end(const Place_in_model& on_edge, std::size_t vertex) const
  {
    if(on_edge.entity == Place_in_model::none)
      return Place_in_model::none;
    const std::size_t last = m_division.number_of_pieces(on_edge.entity);
    const bool is_source = edge(on_edge.entity).source == vertex, is_target = edge(on_edge.entity).target == vertex;
    if(is_source && is_target)
      return 2 * on_edge.number < last ? 0 : last;
    return is_source ? 0 : is_target ? last : Place_in_model::none;
  }

  // Whether the sides are not only where parts of a patch meet.
  bool is_on_border_of_patch(const Side& side, const Side* joined) const
  {
    if(joined == nullptr)
      return true;
    const auto &part = m_mesh.parts[side.part], &other = m_mesh.parts[joined->part];
    if(part.patch != other.patch)
      return true;
    return m_mesh.keeps_corner_points
           && (corner(part, side.side, 0) != corner(other, joined->side, 1) || corner(part, side.side, 1) != corner(other, joined->side, 0));
  }

  static typename Mesh::Point_2 corner(const typename Mesh::Part& part, std::size_t side, std::size_t end)
  {
    return part.corner_points[side / 3][(side % 3 + end) % 3];
  }
};

// In place of those where nobody asks for them.
struct No_places_in_mesh
{
  Vertex_place vertex(std::size_t) const { return {}; }

  template <class Side>
  Edge_place edge(const Side&, const Side*) const { return {}; }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_PLACES_IN_MESH_H
