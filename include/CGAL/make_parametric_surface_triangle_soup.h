// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MAKE_PARAMETRIC_SURFACE_TRIANGLE_SOUP_H
#define CGAL_MAKE_PARAMETRIC_SURFACE_TRIANGLE_SOUP_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Container_helper.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/support/for_each_index.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {

namespace Parametric_surface_mesher {
namespace internal {

template <class ConcurrencyTag, class Kernel, class Point_3, class Triangle>
void fill_triangle_soup(const Indexed_mesh<Kernel>& mesh, std::vector<Point_3>& points, std::vector<Triangle>& triangles,
                        std::vector<std::size_t>& patch_ids)
{
  points.assign(mesh.points.begin(), mesh.points.end());
  points.resize(mesh.number_of_points());
  triangles.resize(mesh.number_of_faces());
  patch_ids.resize(mesh.number_of_faces());
  for_each_index<ConcurrencyTag>(mesh.parts.size(), [&](std::size_t i) {
    const auto& part = mesh.parts[i];
    std::copy(part.points.begin(), part.points.end(), points.begin() + part.first_point);
    for(std::size_t f = 0; f < part.faces.size(); ++f) {
      Triangle& triangle = triangles[part.first_face + f];
      CGAL::internal::resize(triangle, 3); // where it is not always three
      std::copy(part.faces[f].begin(), part.faces[f].end(), triangle.begin());
      patch_ids[part.first_face + f] = part.patch;
    }
  });
}

} // namespace internal
} // namespace Parametric_surface_mesher

/*!
\ingroup PkgParametricSurfaceMesherFunctions

meshes a model as `make_parametric_surface_mesh()` does, into triangles that share points: any number of them may meet in
an edge, so that a model with edges of three or more faces, or of several shells, is meshed without being cut. A face that is the other
side of another one (see `Parametric_surface_model_3::Face::other_side_of`) has no triangles of its own: those of that face, turned over,
are its triangles, too.

\tparam Surface a model of `ParametricSurface_3`
\tparam Point_3 the point type of the surfaces
\tparam Triangle a range of three numbers of points: `std::array<std::size_t, 3>`, or `std::vector<std::size_t>` as other
polygon soups have it
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters": `metric_field`, `visitor`, `kept_faces`
and `leaves_out_bad_faces` as for `make_parametric_surface_mesh()`

\param model the model
\param criteria what the triangles must meet
\param points takes the points: those vertices of the model that faces use, the inner points of its edges, the inner points
of its faces
\param triangles takes the triangles, counterclockwise as the faces of the model face
\param patch_ids takes the index, from 0, of the face of the model that each triangle lies on
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters"

What the three ranges held before is lost, unless the input is refused: then they stay as they were.

\return counts, smallest angles, what was not met and why, and the time of each phase
\throws Parametric_surface_mesh_error as `make_parametric_surface_mesh()`
*/
template <class ConcurrencyTag = Sequential_tag, class Surface, class Point_3, class Triangle,
          class NamedParameters = parameters::Default_named_parameters>
Parametric_surface_mesh_report
make_parametric_surface_triangle_soup(const Parametric_surface_model_3<Surface>& model,
                                      const Parametric_surface_mesh_criteria& criteria,
                                      std::vector<Point_3>& points, std::vector<Triangle>& triangles,
                                      std::vector<std::size_t>& patch_ids,
                                      const NamedParameters& np = parameters::default_values())
{
  using namespace Parametric_surface_mesher::internal;
  if constexpr(check_surface<Surface, typename Surface::Geom_traits>()
               && check_options<Parametric_surface_mesh_criteria, NamedParameters>())
    return with_good_faces(model, leaves_out_bad_faces(np), [&](const auto& checked_model, Bad_faces& bad_faces) {
      return mesh_model<ConcurrencyTag>(checked_model, bad_faces, criteria, np, false, false, false,
                                        [](auto& division) { division.number_vertices_first(); },
                                        [&](const auto&, const auto&, const auto& mesh) {
                                          fill_triangle_soup<ConcurrencyTag>(mesh, points, triangles, patch_ids);
                                        });
    });
  else
    return {};
}

} // namespace CGAL

#endif // CGAL_MAKE_PARAMETRIC_SURFACE_TRIANGLE_SOUP_H
