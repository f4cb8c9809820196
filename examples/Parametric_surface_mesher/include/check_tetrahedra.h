// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether tetrahedra fill a surface and keep it, down to the last bit.
#ifndef CHECK_TETRAHEDRA_H
#define CHECK_TETRAHEDRA_H

#include "Tetrahedra.h"

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace tetrahedra {

// three points counterclockwise from outside, the smallest number first
typedef std::array<std::size_t, 3> Facet;

inline Facet make_facet(std::size_t a, std::size_t b, std::size_t c)
{
  Facet result = {a, b, c};
  std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
  return result;
}

inline std::array<Facet, 4> facets_of(const Tetrahedra::Cell& c)
{
  return {make_facet(c[1], c[2], c[3]), make_facet(c[0], c[3], c[2]), make_facet(c[0], c[1], c[3]),
          make_facet(c[0], c[2], c[1])};
}

inline std::set<Facet> facets_of(const Tetrahedra::Surface& surface)
{
  std::vector<std::size_t> number(surface.num_vertices());
  std::size_t i = 0;
  for(const auto v : surface.vertices())
    number[v] = i++;
  std::set<Facet> result;
  for(const auto f : surface.faces()) {
    const auto h = surface.halfedge(f);
    result.insert(make_facet(number[surface.source(h)], number[surface.target(h)], number[surface.target(surface.next(h))]));
  }
  return result;
}

inline void check_points(const Tetrahedra::Surface& surface, const Tetrahedra& tetrahedra)
{
  if(tetrahedra.points.size() < surface.number_of_vertices())
    throw std::runtime_error("there are fewer points than on the surface");
  auto p = tetrahedra.points.begin();
  for(const auto v : surface.vertices())
    if(surface.point(v) != *p++)
      throw std::runtime_error("point " + std::to_string(std::size_t(v)) + " of the surface has been moved");
}

// The facets of the cells that have no cell on their other side.
inline std::set<Facet> boundary_of(const Tetrahedra& tetrahedra)
{
  std::set<Facet> all, result;
  for(const Tetrahedra::Cell& cell : tetrahedra.cells)
    for(const Facet& facet : facets_of(cell))
      if(!all.insert(facet).second)
        throw std::runtime_error("two tetrahedra are on the same side of a facet");
  for(const Facet& facet : all)
    if(all.count(make_facet(facet[0], facet[2], facet[1])) == 0)
      result.insert(facet);
  return result;
}

inline void check_boundary(const Tetrahedra::Surface& surface, const Tetrahedra& tetrahedra)
{
  const std::set<Facet> wanted = facets_of(surface), found = boundary_of(tetrahedra);
  const auto missing = std::count_if(wanted.begin(), wanted.end(), [&](const Facet& f) { return found.count(f) == 0; });
  const auto added = std::count_if(found.begin(), found.end(), [&](const Facet& f) { return wanted.count(f) == 0; });
  if(missing != 0 || added != 0)
    throw std::runtime_error("the boundary of the tetrahedra lacks " + std::to_string(missing) + " triangles of the surface"
                             + " and has " + std::to_string(added) + " others");
}

// The orientation is decided exactly; the sum of volumes is not exact.
inline void check_volume(const Tetrahedra::Surface& surface, const Tetrahedra& tetrahedra)
{
  const std::vector<Tetrahedra::Point_3>& p = tetrahedra.points;
  double sum = 0;
  for(const Tetrahedra::Cell& c : tetrahedra.cells) {
    if(CGAL::orientation(p[c[0]], p[c[1]], p[c[2]], p[c[3]]) != CGAL::POSITIVE)
      throw std::runtime_error("the volume of a tetrahedron is not positive");
    sum += CGAL::volume(p[c[0]], p[c[1]], p[c[2]], p[c[3]]);
  }
  const double volume = CGAL::Polygon_mesh_processing::volume(surface);
  if(!(std::fabs(sum - volume) <= 1e-9 * volume)) {
    std::ostringstream message;
    message << "the tetrahedra have the volume " << sum << ", the surface has " << volume << " inside";
    throw std::runtime_error(message.str());
  }
}

} // namespace tetrahedra

// Throws std::runtime_error unless the points of the surface are the first ones of the tetrahedra, its triangles, seen from
// outside, are their boundary, and their volumes are positive and add up to the one inside.
inline void check_tetrahedra(const Tetrahedra::Surface& surface, const Tetrahedra& tetrahedra)
{
  tetrahedra::check_points(surface, tetrahedra);
  tetrahedra::check_boundary(surface, tetrahedra);
  tetrahedra::check_volume(surface, tetrahedra);
}

#endif // CHECK_TETRAHEDRA_H
