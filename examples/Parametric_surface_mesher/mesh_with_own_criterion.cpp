// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A user-defined criterion in addition to those of the package: no edge may climb more than a given height, for instance because
// contour lines will be drawn on the mesh.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_function_surface_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

struct Climb_criteria : CGAL::Parametric_surface_mesh_criteria
{
  typedef CGAL::Parametric_surface_mesh_criteria Base;
  double max_climb;

  explicit Climb_criteria(double height) : max_climb(height) {}

  template <class Oracle>
  struct Is_bad : Base::Is_bad<Oracle>
  {
    double max_climb;

    Is_bad(const Climb_criteria& criteria, const Oracle& oracle)
      : Base::Is_bad<Oracle>(criteria, oracle), max_climb(criteria.max_climb)
    {}

    using Base::Is_bad<Oracle>::operator();

    template <class Face_handle>
    CGAL::Mesh_2::Face_badness operator()(Face_handle f, Quality& quality) const
    {
      const CGAL::Mesh_2::Face_badness badness = Base::Is_bad<Oracle>::operator()(f, quality);
      if(badness != CGAL::Mesh_2::NOT_BAD)
        return badness;
      const auto z = [&](int i) { return f->vertex(i)->point().surface_point().z(); };
      quality.badness = CGAL::square(((std::max)({z(0), z(1), z(2)}) - (std::min)({z(0), z(1), z(2)})) / max_climb);
      quality.criterion = CGAL::Mesh_criterion::USER;
      return (*this)(quality); // a triangle is bad if its badness is above 1
    }
  };

  template <class Oracle>
  Is_bad<Oracle> is_bad_object(const Oracle& oracle) const { return Is_bad<Oracle>(*this, oracle); }
};

int main()
{
  const auto hill = CGAL::make_parametric_function_surface([](auto u, auto v) {
    using std::exp;
    return CGAL::parametric_surface_point(u, v, exp(-2 * (u * u + v * v)));
  });
  const auto domain = CGAL::Parametric_domain_2<Kernel>::rectangle(-2, 2, -2, 2);
  for(const double max_climb : {1., 0.05, 0.02}) {
    Climb_criteria criteria(max_climb);
    criteria.set_max_edge(0.2);
    Mesh mesh;
    const auto report = CGAL::make_parametric_surface_mesh(hill, domain, criteria, mesh);
    double found = 0;
    for(const auto e : mesh.edges())
      found = (std::max)(found, std::fabs(mesh.point(mesh.vertex(e, 0)).z() - mesh.point(mesh.vertex(e, 1)).z()));
    std::cout << "climb up to " << max_climb << ": " << mesh.number_of_faces() << " triangles, largest climb " << found
              << ", smallest angle " << report.smallest_angle << " degrees\n";
    if(report.unmet.empty() && found > max_climb)
      return 1;
  }
  return 0;
}
