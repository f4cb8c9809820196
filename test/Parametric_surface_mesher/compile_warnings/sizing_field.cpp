// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compiled without a warning, see ../CMakeLists.txt. It is not run.
#include <CGAL/Interpolated_sizing_field_3.h>

double length_at(const CGAL::Interpolated_sizing_field_3<>& field, const CGAL::Epick::Point_3& place) { return field(place); }
