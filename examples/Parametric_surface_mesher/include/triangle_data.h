// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What mesh_cad measures of each triangle, for files that show it.
#ifndef TRIANGLE_DATA_H
#define TRIANGLE_DATA_H

#include "measure_cad_mesh.h"

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/pieces_of_patches.h>
#include <CGAL/Surface_curvature_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace mesh_cad {

// The largest distance between the triangle and the points of the surface over the middles of its sides and its centroid.
inline double deviation(const Triangle_corners& c, const CGAL::Open_cascade_surface_3& surface)
{
  const Kernel::Triangle_3 triangle(c.points[0], c.points[1], c.points[2]);
  double square = 0;
  for(const auto& w : places_in_triangle()) {
    const Kernel::Point_2 p = at(c, w);
    square = (std::max)(square, CGAL::squared_distance(surface.point(p.x(), p.y()), triangle));
  }
  return std::sqrt(square);
}

// The larger absolute value of the two principal curvatures of the surface over the centroid.
inline double curvature(const Triangle_corners& c, const CGAL::Open_cascade_surface_3& surface)
{
  const Kernel::Point_2 p = at(c, {1. / 3, 1. / 3, 1. / 3});
  return CGAL::Surface_curvature_3<Kernel>(surface.jet(p.x(), p.y())).max_absolute_curvature();
}

// For the triangles of an element mesh: those on the other side of a face between two parts are left out.
template <class ConcurrencyTag>
std::vector<CGAL::Element_mesh_3::Data> triangle_data(const Cad_mesh& mesh, const CGAL::Open_cascade_model_3& shape)
{
  using namespace CGAL::Parametric_surface_mesher::internal;
  const auto is_other_side = [&](std::size_t patch) { return shape.model.faces()[patch].other_side_of != Model::no_face; };
  std::vector<std::size_t> places(mesh.mesh.number_of_faces()); // of the faces in the result
  std::size_t number = 0;
  for(const auto f : mesh.mesh.faces())
    places[f] = is_other_side(mesh.patch[f]) ? number : number++;
  const std::vector<double> zeros(number);
  std::vector<CGAL::Element_mesh_3::Data> result{{"smallest_angle", 1, zeros}, {"deviation", 1, zeros}, {"curvature", 1, zeros}};
  const auto pieces = pieces_of_patches(mesh.mesh.faces(), [&](auto f) { return mesh.patch[f]; });
  for_each_piece<ConcurrencyTag>(shape.model, pieces, [&](const auto& piece, std::size_t, const CGAL::Open_cascade_surface_3& surface) {
    if(is_other_side(piece.patch))
      return;
    for(const auto f : piece.faces) {
      const Triangle_corners c = corners(mesh, f);
      result[0].values[places[f]] = smallest_angle(c.points).second;
      result[1].values[places[f]] = deviation(c, surface);
      result[2].values[places[f]] = curvature(c, surface);
    }
  });
  return result;
}

} // namespace mesh_cad

#endif // TRIANGLE_DATA_H
