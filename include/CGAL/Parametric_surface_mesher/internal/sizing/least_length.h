// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_LEAST_LENGTH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_LEAST_LENGTH_H

#include <cmath>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The smaller one of two wanted edge lengths. It is NaN if one of them is, so that the mesher refuses it.
inline double least_length(double a, double b) { return a < b || std::isnan(a) ? a : b; }

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_LEAST_LENGTH_H
