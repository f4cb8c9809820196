// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_NODE_VALUES_3_H
#define CGAL_NODE_VALUES_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherSizing

A value at each node of a mesh of triangles, of tetrahedra, or of both, as a solver writes it.

\sa `CGAL::IO::read_node_values()`
\sa `CGAL::Interpolated_sizing_field_3`
*/
struct Node_values_3
{
  std::vector<std::array<double, 3>> nodes;
  std::vector<double> values; ///< of the nodes
  std::vector<std::array<std::size_t, 3>> triangles;  ///< the indices of their nodes
  std::vector<std::array<std::size_t, 4>> tetrahedra; ///< the indices of their nodes
};

} // namespace CGAL

#endif // CGAL_NODE_VALUES_3_H
