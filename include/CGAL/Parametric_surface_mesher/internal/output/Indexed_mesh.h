// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_INDEXED_MESH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_INDEXED_MESH_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Place_in_model.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Partial_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/support/for_each_index.h>

#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The mesh of one or several patches before it is written to the user's data structure. Its points are, in this order, those that
// parts share, those of each part, and copies of shared ones.
template <class Kernel>
struct Indexed_mesh
{
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef Partial_mesh<Kernel> Part;

  std::vector<Point_3> points;        // those that parts share: of divided boundaries and of cuts
  std::vector<Point_2> domain_points; // for a vertex on several patches, in one of their domains
  std::vector<Place_in_model> places; // of those points
  std::vector<Part> parts;
  std::vector<std::size_t> copies;    // indices of the shared points that are copied

  // The pairs of boundary vertices that are joined by an edge already, smaller index first; one set for each shell.
  typedef std::set<std::pair<std::size_t, std::size_t>> Chords;
  std::map<std::size_t, Chords> chords;

  bool keeps_domain_points = false; // whether inner vertices keep them
  bool keeps_corner_points = false;
  bool has_other_sides = false; // whether faces that are the other sides of others have triangles of their own

private:
  std::size_t m_number_of_own_points = 0, m_number_of_faces = 0, m_number_of_edges = 0; // sums over all parts

public:
  std::size_t number_of_points() const { return points.size() + m_number_of_own_points + copies.size(); }
  std::size_t number_of_faces() const { return m_number_of_faces; }
  std::size_t number_of_inner_edges() const { return m_number_of_edges; }

  void append(Part part)
  {
    part.first_point = m_number_of_own_points;
    part.first_face = m_number_of_faces;
    part.first_edge = m_number_of_edges;
    m_number_of_own_points += part.points.size();
    m_number_of_faces += part.faces.size();
    m_number_of_edges += part.number_of_edges;
    parts.push_back(std::move(part));
  }

  // \pre none of the parts has a place in the mesh yet
  void replace_parts(std::vector<Part> new_parts)
  {
    parts.clear();
    m_number_of_own_points = m_number_of_faces = m_number_of_edges = 0;
    for(Part& part : new_parts)
      append(std::move(part));
  }

  // Takes those points of the division out of the shared points that no part has. The others keep their order.
  void remove_points_of_division(const std::vector<bool>& are_used)
  {
    std::vector<std::size_t> indices; // new ones, of the points of the division
    std::size_t number = 0;
    for(std::size_t i = 0; i < points.size(); ++i) {
      if(i < are_used.size())
        indices.push_back(number);
      if(i < are_used.size() && !are_used[i])
        continue;
      points[number] = points[i];
      places[number] = places[i];
      domain_points[number++] = domain_points[i];
    }
    const std::size_t number_of_removed = points.size() - number;
    points.resize(number);
    places.resize(number);
    domain_points.resize(number);
    for(Part& part : parts) {
      part.place_of_cuts -= number_of_removed;
      part.renumber_division(indices);
    }
  }

  // Gives each part its place in the mesh. Must be called once, when all shared points and all parts are known.
  template <class ConcurrencyTag>
  void finish()
  {
    const std::size_t largest_index = (std::numeric_limits<typename Part::Index>::max)();
    if(points.size() >= Part::first_cut_point || number_of_points() >= Part::first_own_point
       || 3 * number_of_faces() > largest_index / 2)
      throw Parametric_surface_mesh_error("the mesh has too many triangles for indices of 32 bits");
    for_each_index<ConcurrencyTag>(parts.size(), [this](std::size_t i) {
      parts[i].first_point += points.size();
      parts[i].take_place();
    });
  }

  // Adds a copy of a shared point and returns its index.
  std::size_t copy_of(std::size_t vertex)
  {
    copies.push_back(vertex);
    return number_of_points() - 1;
  }

  // The shared point that a vertex is a copy of, or the vertex itself.
  std::size_t original(std::size_t vertex) const
  {
    const std::size_t first_copy = number_of_points() - copies.size();
    return vertex < first_copy ? vertex : copies[vertex - first_copy];
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_INDEXED_MESH_H
