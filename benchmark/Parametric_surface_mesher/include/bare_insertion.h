// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's range insertion into a constrained Delaunay triangulation, which times are compared with.
#ifndef BARE_INSERTION_H
#define BARE_INSERTION_H

#include "Sample_surfaces.h"
#include "measure.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Random.h>
#include <CGAL/point_generators_2.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace bare_insertion {

typedef Sample_kernel::Point_2 Point_2;

// of a triangulation with some `number_of_triangles`: nearly two for each point
inline std::vector<Point_2> random_points(std::size_t number_of_triangles)
{
  CGAL::Random random(1);
  CGAL::Random_points_in_square_2<Point_2> generator(0.5, random);
  std::vector<Point_2> points;
  std::copy_n(generator, number_of_triangles / 2 + 10, std::back_inserter(points));
  return points;
}

inline double seconds_per_triangle(const std::vector<Point_2>& points)
{
  CGAL::Constrained_Delaunay_triangulation_2<Sample_kernel> triangulation;
  const double seconds = seconds_of([&] { triangulation.insert(points.begin(), points.end()); });
  return seconds / triangulation.number_of_faces();
}

} // namespace bare_insertion

#endif // BARE_INSERTION_H
