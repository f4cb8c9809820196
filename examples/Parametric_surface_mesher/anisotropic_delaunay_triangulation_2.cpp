// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random points on a wavy surface whose parametrisation is badly scaled: a step in u is at least ten times as long on
// the surface as in the plane. The Delaunay triangulation of the parameters ignores this; the anisotropic one
// uses the first fundamental form and gives better-shaped triangles on the surface.
#include <CGAL/Anisotropic_Delaunay_triangulation_traits_2.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Anisotropic_Delaunay_triangulation_traits_2<Kernel> Traits;
typedef CGAL::Delaunay_triangulation_2<Traits> Delaunay;
typedef Traits::Point_2 Point;

// S(u,v) = (10 u, v, sin(10 u + 3 v)), with its metric tensor: the scalar products of the partial derivatives.
Point point_on_surface(double u, double v)
{
  const double slope = std::cos(10 * u + 3 * v);
  const Kernel::Vector_3 du(10, 0, 10 * slope), dv(0, 1, 3 * slope);
  return Point(Kernel::Point_2(u, v),
               Kernel::Point_3(10 * u, v, std::sin(10 * u + 3 * v)),
               CGAL::Metric_tensor_2(du * du, du * dv, dv * dv));
}

// The mean over all triangles of the smallest angle, measured in space.
double mean_smallest_angle(const Delaunay& triangulation)
{
  double sum = 0;
  for(const auto& face : triangulation.finite_face_handles()) {
    double smallest = 180;
    for(int i = 0; i < 3; ++i)
      smallest = (std::min)(smallest, CGAL::approximate_angle(face->vertex((i + 1) % 3)->point().surface_point(),
                                                              face->vertex(i)->point().surface_point(),
                                                              face->vertex((i + 2) % 3)->point().surface_point()));
    sum += smallest;
  }
  return sum / double(triangulation.number_of_faces());
}

int main()
{
  CGAL::Random random(1);
  std::vector<Point> anisotropic, euclidean;
  for(int i = 0; i < 10000; ++i) {
    const Point p = point_on_surface(random.get_double(), random.get_double());
    anisotropic.push_back(p);
    // the same point with the tensor of the parameter plane
    euclidean.push_back(Point(p.domain_point(), p.surface_point(), CGAL::Metric_tensor_2()));
  }

  // The class chooses the order in which the range is inserted. Under a varying metric another order may give
  // another triangulation; each of them is valid.
  const Delaunay with_metric(anisotropic.begin(), anisotropic.end());
  const Delaunay without_metric(euclidean.begin(), euclidean.end());

  std::cout << with_metric.number_of_vertices() << " points on the surface\n"
            << "Delaunay of the parameters:   " << without_metric.number_of_faces() << " triangles, mean smallest angle "
            << mean_smallest_angle(without_metric) << " degrees\n"
            << "Delaunay under the metric:    " << with_metric.number_of_faces() << " triangles, mean smallest angle "
            << mean_smallest_angle(with_metric) << " degrees\n";
  return 0;
}
