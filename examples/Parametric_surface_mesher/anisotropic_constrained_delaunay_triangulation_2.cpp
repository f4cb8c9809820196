// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A steep hill over a square: first a constrained outline and a constrained path across it are inserted, then points everywhere.
// The triangles follow the metric of the surface, and the constraints remain edges.
//
// Where the metric varies, insert the constraints first, with the Euclidean metric, and then the
// points with theirs: an insertion then flips only edges opposite the new point, which always ends.
#include <CGAL/Anisotropic_Delaunay_triangulation_traits_2.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Anisotropic_Delaunay_triangulation_traits_2<Kernel> Traits;
typedef CGAL::Constrained_Delaunay_triangulation_2<Traits> Triangulation;
typedef Traits::Point_2 Point;

double height(double u, double v) { return 0.8 * std::exp(-(u * u + v * v) / 0.03); }

// S(u,v) = (u, v, height(u,v)): the gradient of the height gives the first fundamental form.
Point point_on_surface(double u, double v)
{
  const double h = height(u, v), hu = -2 * u * h / 0.03, hv = -2 * v * h / 0.03;
  return Point(Kernel::Point_2(u, v), Kernel::Point_3(u, v, h),
               CGAL::Metric_tensor_2(1 + hu * hu, hu * hv, 1 + hv * hv));
}

Point constraint_point(double u, double v)
{
  return Point(Kernel::Point_2(u, v), Kernel::Point_3(u, v, height(u, v)), CGAL::Metric_tensor_2());
}

int main()
{
  Triangulation triangulation;

  std::vector<Point> outline;
  const int n = 20;
  for(int i = 0; i < n; ++i) outline.push_back(constraint_point(-1 + 2. * i / n, -1));
  for(int i = 0; i < n; ++i) outline.push_back(constraint_point(1, -1 + 2. * i / n));
  for(int i = 0; i < n; ++i) outline.push_back(constraint_point(1 - 2. * i / n, 1));
  for(int i = 0; i < n; ++i) outline.push_back(constraint_point(-1, 1 - 2. * i / n));
  triangulation.insert_constraint(outline.begin(), outline.end(), true);

  std::vector<Point> path;
  for(int i = 0; i <= 40; ++i)
    path.push_back(constraint_point(-0.8 + 1.6 * i / 40, 0.1 * std::sin(i / 4.)));
  triangulation.insert_constraint(path.begin(), path.end());

  CGAL::Random random(1);
  Triangulation::Face_handle near_last;
  for(int i = 0; i < 5000; ++i)
    near_last = triangulation.insert(point_on_surface(random.get_double(-1, 1), random.get_double(-1, 1)),
                                     near_last)->face();

  std::size_t constraints = 0, largest_degree = 0, inverted = 0;
  for(const auto& edge : triangulation.finite_edges())
    constraints += triangulation.is_constrained(edge);
  double area = 0;
  for(const auto& face : triangulation.finite_face_handles()) {
    const Point &p = face->vertex(0)->point(), &q = face->vertex(1)->point(), &r = face->vertex(2)->point();
    inverted += CGAL::orientation(p.domain_point(), q.domain_point(), r.domain_point()) != CGAL::LEFT_TURN;
    area += std::sqrt(CGAL::squared_area(p.surface_point(), q.surface_point(), r.surface_point()));
  }
  for(const auto& vertex : triangulation.finite_vertex_handles())
    largest_degree = (std::max)(largest_degree, std::size_t(triangulation.degree(vertex)));

  std::cout << triangulation.number_of_vertices() << " vertices, " << triangulation.number_of_faces()
            << " triangles, of them inverted: " << inverted << "\n"
            << "constrained edges: " << constraints << " of " << outline.size() + path.size() - 1 << " inserted\n"
            << "largest degree of a vertex: " << largest_degree << "\n"
            << "area of the triangles in space: " << area << "\n";
  return inverted == 0 && constraints == outline.size() + path.size() - 1 ? 0 : 1;
}
