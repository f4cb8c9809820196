// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SECOND_ORDER_MESH_REPORT_H
#define CGAL_SECOND_ORDER_MESH_REPORT_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <cstddef>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherSecondOrder

What `make_second_order_mesh()` did.

The *scaled Jacobian* of a curved triangle is the smallest value of its normal `X_s x X_t`, in the direction of its mean, over that mean:
1 for a straight triangle, 0 or less for one that is folded.
*/
struct Second_order_mesh_report
{
  /// a triangle whose scaled Jacobian is not proved to be large enough.
  struct Uncertified
  {
    std::size_t face;       ///< index of the face, in the order of `faces(tm)`
    double scaled_jacobian; ///< its lower bound; minus infinity if the triangle has no area, or faces to the wrong side
  };

  std::size_t number_on_curves = 0;   ///< nodes in the middle of a piece of an edge of the model
  std::size_t number_on_surfaces = 0; ///< nodes on the surface of a face
  /// nodes of pieces of edges whose parameters are not known: they are on the edge near the middle of the straight piece, or
  /// else on a surface
  std::size_t number_of_projected = 0;
  std::size_t number_of_straight = 0;    ///< edges that stay straight, since no place for their nodes was found
  std::size_t number_of_curved_less = 0; ///< nodes that were moved towards the straight edge so that no triangle fails
  double smallest_scaled_jacobian = 1;   ///< the least lower bound of those triangles that are certified
  std::vector<Uncertified> uncertified;  ///< all others
};

} // namespace CGAL

#endif // CGAL_SECOND_ORDER_MESH_REPORT_H
