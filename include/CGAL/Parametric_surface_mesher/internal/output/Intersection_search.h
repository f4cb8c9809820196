// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_INTERSECTION_SEARCH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_INTERSECTION_SEARCH_H

#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Box_hierarchy.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Flat_pieces.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Intersecting_triangles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Finds where a mesh intersects itself.
template <class Kernel>
class Intersection_search
{
public:
  typedef Indexed_mesh<Kernel> Mesh;

  // A triangle: its part of the mesh, and its number there.
  struct Place
  {
    std::uint32_t part, face;

    friend bool operator<(const Place& a, const Place& b) { return a.part < b.part || (a.part == b.part && a.face < b.face); }
  };

  typedef std::array<Place, 2> Pair; // in ascending order

private:
  const Mesh& m_mesh;

public:
  // \pre the parts of the mesh have their places in it
  explicit Intersection_search(const Mesh& mesh) : m_mesh(mesh) {}

  // All pairs of triangles of one solid that pass through each other or lie on each other, in ascending order. `solids`: by patch, the
  // solids that its triangles bound; triangles of patches without one are not looked at
  std::vector<Pair> operator()(const std::vector<std::vector<std::size_t>>& solids) const
  {
    std::map<std::size_t, std::vector<std::size_t>> parts; // by solid
    for(std::size_t p = 0; p < m_mesh.parts.size(); ++p)
      for(std::size_t solid : solids[m_mesh.parts[p].patch])
        parts[solid].push_back(p);
    std::vector<Pair> result;
    for(const auto& solid : parts)
      append_pairs(solid.second, result);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end(), are_same), result.end()); // two solids may have both triangles
    return result;
  }

  Intersecting_triangles::Triangle triangle(const Place& place) const
  {
    const auto& part = m_mesh.parts[place.part];
    const auto& face = part.faces[place.face];
    return {point(part, face[0]), point(part, face[1]), point(part, face[2])};
  }

private:
  static bool are_same(const Pair& a, const Pair& b) { return !(a < b) && !(b < a); }

  Intersecting_triangles::Point_3 point(const typename Mesh::Part& part, std::size_t v) const
  {
    const auto& p = v < m_mesh.points.size() ? m_mesh.points[v] : part.points[v - part.first_point];
    return {to_double(p.x()), to_double(p.y()), to_double(p.z())};
  }

  // A piece of the surface of a solid.
  struct Piece
  {
    std::uint32_t part;
    std::vector<std::uint32_t> faces; // of the part
    Box_hierarchy boxes;
  };

  // Pieces with triangles that cannot meet each other are not looked into but where others are close.
  void append_pairs(const std::vector<std::size_t>& parts, std::vector<Pair>& result) const
  {
    std::vector<Piece> pieces;
    std::vector<Small_box> boxes;
    for(const std::size_t p : parts) {
      const auto& part = m_mesh.parts[p];
      Flat_pieces<typename Mesh::Part> flat_pieces(part);
      for(auto& flat : flat_pieces([&](std::size_t v) { return point(part, v); })) {
        pieces.push_back({std::uint32_t(p), std::move(flat.faces), Box_hierarchy({})});
        Piece& piece = pieces.back();
        piece.boxes = Box_hierarchy(boxes_of(piece));
        boxes.push_back(piece.boxes.box());
        if(!flat.is_apart)
          piece.boxes.for_each_overlapping_pair([&](std::size_t i, std::size_t k) { compare(piece, i, piece, k, result); });
      }
    }
    Box_hierarchy(std::move(boxes)).for_each_overlapping_pair([&](std::size_t a, std::size_t b) {
      pieces[a].boxes.for_each_overlapping_pair(pieces[b].boxes, [&](std::size_t i, std::size_t k) {
        compare(pieces[a], i, pieces[b], k, result);
      });
    });
  }

  std::vector<Small_box> boxes_of(const Piece& piece) const
  {
    std::vector<Small_box> result(piece.faces.size());
    for(std::size_t i = 0; i < result.size(); ++i)
      for(const auto& corner : triangle({piece.part, piece.faces[i]}))
        result[i].add(corner);
    return result;
  }

  void compare(const Piece& a, std::size_t i, const Piece& b, std::size_t k, std::vector<Pair>& result) const
  {
    const Place first{a.part, a.faces[i]}, second{b.part, b.faces[k]};
    if(Intersecting_triangles()(triangle(first), triangle(second)))
      result.push_back({(std::min)(first, second), (std::max)(first, second)});
  }
};

// Counts the pairs of triangles by the patches that they lie on. `is_of_surfaces`: tells of a pair whether the surfaces themselves meet
// there. The place that is reported is that of a pair for which they do not, if there is one.
template <class Kernel, class Predicate>
std::vector<Parametric_surface_mesh_report::Intersection>
report_of_intersections(const Intersection_search<Kernel>& search, const Indexed_mesh<Kernel>& mesh,
                        const std::vector<typename Intersection_search<Kernel>::Pair>& pairs, const Predicate& is_of_surfaces)
{
  std::map<std::pair<std::size_t, std::size_t>, Parametric_surface_mesh_report::Intersection> intersections;
  for(const auto& pair : pairs) {
    const std::pair<std::size_t, std::size_t> patches = std::minmax(mesh.parts[pair[0].part].patch, mesh.parts[pair[1].part].patch);
    const auto corner = search.triangle(pair[0])[0];
    auto& intersection = intersections.emplace(patches, Parametric_surface_mesh_report::Intersection{
      {patches.first, patches.second}, 0, {corner.x(), corner.y(), corner.z()}, true}).first->second;
    ++intersection.number_of_pairs;
    if(intersection.is_of_surfaces && !is_of_surfaces(pair)) {
      intersection.is_of_surfaces = false;
      intersection.place = {corner.x(), corner.y(), corner.z()};
    }
  }
  std::vector<Parametric_surface_mesh_report::Intersection> result;
  for(const auto& intersection : intersections)
    result.push_back(intersection.second);
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_INTERSECTION_SEARCH_H
