// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_THIN_STRIP_CHOICE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_THIN_STRIP_CHOICE_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Sizes_beside_strips.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Thin_strips.h>
#include <CGAL/Parametric_surface_mesher/internal/division/Triangulated_boundary.h>
#include <CGAL/Parametric_surface_mesher/internal/model/criteria_of_face.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Spacing_limit.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Chooses the thin strips that are divided into pieces shorter than the minimum edge, and how finely they are. The cheapest come first, and
it ends when the model would get more than a few percent more triangles.
Numbers of triangles are estimates: those of a face follow from the wanted sizes along its boundary, those beside a strip from sizes that
grow with the distance from it.
*/
template <class Oracle>
class Thin_strip_choice
{
public:
  typedef Thin_strips<Oracle> Strips;
  typedef typename Strips::Division Division;
  typedef typename Strips::Places Places;

private:
  typedef Triangulated_boundary<Oracle> Boundary;

  // The lengths of pieces, in widths of their strip. Where points are opposite to the middles of pieces, the first one gives angles of 11
  // degrees, and the second one, which is taken if there is room for more triangles, 16.
  static constexpr double wanted_ratios[] = {10, 7};
  // The triangles that strips may add by the estimates: a share of those of the model, and a number that any model may have. The estimates
  // are two to three times too high, so models grow by less than a tenth.
  static constexpr double largest_share = 0.15, harmless_number = 200;
  // Of the triangles beside a piece, for a growth of 1. It was measured beside a ring; sizes that grow evenly would give twice as many.
  static constexpr double factor_of_triangles_beside = 1.2;

  struct Face_sizes
  {
    double number_of_triangles = 0, size = 0;
  };

  const Division& m_division;
  const std::vector<Oracle>& m_oracles;
  const Parametric_surface_mesh_criteria& m_criteria;
  const std::vector<Boundary>& m_boundaries;
  std::vector<Face_sizes> m_face_sizes; // by face
  Sizes_beside_strips m_sizes;

public:
  Thin_strip_choice(const Division& division, const std::vector<Oracle>& oracles, const Parametric_surface_mesh_criteria& criteria,
                    const std::vector<Boundary>& boundaries)
    : m_division(division), m_oracles(oracles), m_criteria(criteria), m_boundaries(boundaries)
  {}

  // `strips`: by face. Returns the places to be divided, with their wanted lengths.
  Places operator()(const std::map<std::size_t, Places>& strips)
  {
    double allowed = harmless_number;
    for(std::size_t f = 0; f < m_oracles.size(); ++f) {
      m_face_sizes.push_back(face_sizes(f));
      allowed += largest_share * m_face_sizes.back().number_of_triangles;
    }
    std::map<std::size_t, double> chosen; // ratios, by face
    for(const double ratio : wanted_ratios) {
      std::vector<std::pair<double, std::size_t>> faces; // by what they cost more than before
      for(const auto& face : strips) {
        const auto before = chosen.find(face.first);
        faces.emplace_back(cost(face.first, face.second, ratio, strips)
                             - (before == chosen.end() ? 0 : cost(face.first, face.second, before->second, strips)),
                           face.first);
      }
      std::sort(faces.begin(), faces.end());
      for(const auto& face : faces)
        if(face.first < allowed) {
          allowed -= face.first;
          chosen[face.second] = ratio;
        }
    }
    Places result;
    for(const auto& face : chosen)
      take(strips.at(face.first), face.second, result);
    return result;
  }

  // The sizes of the faces beside the strips that were chosen.
  const Sizes_beside_strips& sizes() const { return m_sizes; }

private:
  double growth() const { return (std::max)(m_criteria.growth(), Sizes_beside_strips::growth); }

  static double wanted_length(const typename Strips::Place& place, double ratio) { return (std::min)(ratio * place.width, place.length); }

  // The number of triangles that a piece adds to a face whose edges grow from its length to that inside.
  double triangles_beside(double length, double inside) const
  {
    return length < inside ? factor_of_triangles_beside / growth() * (1 - length / inside) : 0;
  }

  double cost(std::size_t face, const Places& places, double ratio, const std::map<std::size_t, Places>& strips) const
  {
    double result = 0;
    for(const auto& edge : places)
      for(const auto& place : edge.second) {
        const double length = place.second.length, wanted = wanted_length(place.second, ratio), number = length / wanted;
        result += number - 1;
        for(const auto& use : m_division.uses()[edge.first])
          if(use.face != face && strips.count(use.face) == 0)
            result += number * triangles_beside(wanted, m_face_sizes[use.face].size)
                      - triangles_beside(length, m_face_sizes[use.face].size);
      }
    return result;
  }

  void take(const Places& places, double ratio, Places& result)
  {
    for(const auto& edge : places)
      for(const auto& place : edge.second) {
        auto with_length = place.second;
        with_length.wanted_length = wanted_length(with_length, ratio);
        const auto known = result[edge.first].emplace(place.first, with_length);
        if(!known.second && with_length.wanted_length < known.first->second.wanted_length)
          known.first->second = with_length;
        if(with_length.wanted_length < m_criteria.min_edge())
          for(const auto& use : m_division.uses()[edge.first])
            m_sizes.add(use.face, with_length.wanted_length);
      }
  }

  // The estimated number of triangles of a face, and their mean size, which is that along the boundary.
  Face_sizes face_sizes(std::size_t face) const
  {
    Face_sizes result;
    const Boundary& boundary = m_boundaries[face];
    if(boundary.loops().empty())
      return result; // it is left out
    const auto criteria = criteria_of_face(m_criteria, m_division.model().faces()[face]);
    const Spacing_limit<Oracle> limit(m_oracles[face], criteria, m_division.box(face));
    double length = 0, density = 0;
    for(const auto& loop : m_division.boundary_loops(face))
      for(std::size_t i = 0; i < loop.size(); ++i) {
        const double l = std::sqrt(squared_distance(loop[i].surface_point, loop[(i + 1) % loop.size()].surface_point));
        length += l;
        density += l / square(limit(loop[i].domain_point));
      }
    double area = 0;
    for(const auto& f : boundary.triangulation().finite_face_handles())
      if(f->is_in_domain())
        area += area_of(f);
    const double area_of_equilateral = std::sqrt(3.) / 4;
    result.size = std::sqrt(length / density);
    result.number_of_triangles = area * density / length / area_of_equilateral;
    return result;
  }

  // The area of a triangle in space, by the metric at its corners.
  template <class Face_handle>
  static double area_of(Face_handle f)
  {
    const auto &p = f->vertex(0)->point(), &q = f->vertex(1)->point(), &r = f->vertex(2)->point();
    const double in_domain = 0.5 * ((q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x()));
    double sum = 0; // of the factors of areas at the corners
    for(const auto* corner : {&p, &q, &r})
      sum += std::sqrt(corner->tensor().determinant());
    return in_domain * sum / 3;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_THIN_STRIP_CHOICE_H
