// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles given by indices, the input of the tests of mesh quality.
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_QUALITY_TEST_HELPERS_H
#define PARAMETRIC_SURFACE_MESHER_TEST_QUALITY_TEST_HELPERS_H

#include <CGAL/Surface_mesh.h>
#include <CGAL/number_type_config.h>

#include <surface_test_helpers.h>

#include <array>
#include <cstddef>
#include <vector>

typedef Test_kernel::Point_2 Point_2;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef std::vector<Point_3> Points;
typedef std::vector<std::array<std::size_t, 3>> Triangles;

const double pi = CGAL_PI;

#endif // PARAMETRIC_SURFACE_MESHER_TEST_QUALITY_TEST_HELPERS_H
