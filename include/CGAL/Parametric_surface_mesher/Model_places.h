// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_MODEL_PLACES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_MODEL_PLACES_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Parametric_surface_mesher {

/*!
\ingroup PkgParametricSurfaceMesherRef

What a vertex of a mesh lies on in the model that was meshed: a vertex, an edge or a face of it.

\sa `CGAL::parameters::vertex_place_map()`
*/
struct Vertex_place
{
  static constexpr std::size_t none = std::size_t(-1); ///< in place of an index that is not known

  int dimension = 2; ///< 0 on a vertex of the model, 1 on an edge, 2 inside a face
  /// the index of that vertex, edge or face, from 0. It is `none` for a vertex that was put into an edge of the model where detail was removed.
  std::size_t index = none;
  double parameter = 0; ///< on an edge: the parameter of its curves, else 0; not a number if it is not known
};

/*!
\ingroup PkgParametricSurfaceMesherRef

Which edge of the model an edge of the mesh is a piece of.

\sa `CGAL::parameters::edge_place_map()`
*/
struct Edge_place
{
  static constexpr std::size_t none = std::size_t(-1); ///< in place of an index: the edge of the mesh is inside a face

  std::size_t index = none; ///< the index of the edge of the model, from 0, or `none`
  /// the parameters of the source and the target of `halfedge(e, tm)` on its curves. They are not numbers where they are not known: where detail was removed, the
  /// ends may be those of other edges.
  std::array<double, 2> parameters = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
};

} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_MODEL_PLACES_H
