// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_CHECK_DERIVATIVES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_CHECK_DERIVATIVES_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Parametric_surface_oracle_3.h>
#include <CGAL/Surface_jet_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Compares the jet of a surface at a place with differences of values around it. A surface is refused only if the differences
over three lengths tend to a limit, from both sides, that is not what the jet tells: so none is that has a crease there, is
undefined beside it, or is rougher than the differences can tell.
*/
template <class Surface>
class Derivative_check
{
  typedef typename Surface::Geom_traits Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_2 Vector_2;
  typedef typename Kernel::Vector_3 Vector_3;
  typedef Surface_jet_3<Kernel> Jet;

  static constexpr double wrong = 0.01;       // relative difference of a derivative that contradicts the values
  static constexpr double converged = 0.001;  // relative difference of two differences that tend to a limit
  static constexpr double agreeing = 0.003;   // relative difference of a Taylor polynomial that no more is asked of
  static constexpr double noise = 1e-6;       // relative: values may have been computed with `float`
  static constexpr double ratio_of_lengths = 7;

  const Surface& m_surface;
  const Point_2 m_place;
  const Jet m_jet;

public:
  Derivative_check(const Surface& surface, const Point_2& place)
    : m_surface(surface), m_place(place), m_jet(surface.jet(place.x(), place.y()))
  {}

  // `u_step`, `v_step`: lengths in the domain over which the surface is defined
  void operator()(double u_step, double v_step) const
  {
    if(!is_finite(m_jet))
      return; // another check tells that
    check_point(u_step, v_step);
    check(Vector_2(u_step, 0), "u", m_jet.du, m_jet.duu, m_jet.dv, m_jet.duv);
    check(Vector_2(0, v_step), "v", m_jet.dv, m_jet.dvv, m_jet.du, m_jet.duv);
  }

private:
  static bool is_finite(const Jet& jet)
  {
    const Vector_3 sum = jet.du + jet.dv + jet.duu + jet.duv + jet.dvv + (jet.point - ORIGIN);
    return std::isfinite(sum.squared_length());
  }

  static double length(const Vector_3& d) { return std::sqrt(d.squared_length()); }

  void check_point(double u_step, double v_step) const
  {
    const Point_3 p = m_surface.point(m_place.x(), m_place.y());
    const double size = length(m_jet.point - ORIGIN) + u_step * length(m_jet.du) + v_step * length(m_jet.dv);
    if(length(p - m_jet.point) > wrong * size)
      throw Parametric_surface_mesh_error("the surface contradicts itself at (u,v) = " + describe(m_place)
                                          + ": point() gives " + text(p - ORIGIN) + ", jet() " + text(m_jet.point - ORIGIN));
  }

  // In one direction: the first and second derivative by it, and those of the derivative by the other parameter.
  void check(const Vector_2& step, const std::string& name, const Vector_3& first, const Vector_3& second, const Vector_3& other,
             const Vector_3& mixed) const
  {
    if(agrees_with_taylor_polynomial(step, first, second, other, mixed))
      return;
    const auto of_jet = [this](const Point_2& p) { return m_surface.jet(p.x(), p.y()); };
    const bool is_by_u = step.y() == 0;
    const auto point = [&](const Point_2& p) { return m_surface.point(p.x(), p.y()) - ORIGIN; };
    const auto derivative = [&](const Point_2& p) { return is_by_u ? of_jet(p).du : of_jet(p).dv; };
    const auto other_derivative = [&](const Point_2& p) { return is_by_u ? of_jet(p).dv : of_jet(p).du; };
    check_limit(step, point, m_jet.point - ORIGIN, first, 0, "d/d" + name);
    const double irrelevant = converged / length(step); // of what changes the first derivatives this little
    check_limit(step, derivative, first, second, irrelevant * length(first), "d^2/d" + name + "^2");
    check_limit(step, other_derivative, other, mixed, irrelevant * length(other), "d^2/(du dv)");
  }

  static double length(const Vector_2& step) { return std::fabs(step.x()) + std::fabs(step.y()); }

  bool agrees_with_taylor_polynomial(const Vector_2& step, const Vector_3& first, const Vector_3& second, const Vector_3& other,
                                     const Vector_3& mixed) const
  {
    const double h = length(step) / ratio_of_lengths;
    const Point_2 p = m_place + step / ratio_of_lengths;
    const Jet jet = m_surface.jet(p.x(), p.y());
    const bool is_by_u = step.y() == 0;
    const Vector_3 point_error = (jet.point - m_jet.point) - h * first - 0.5 * h * h * second,
                   first_error = (is_by_u ? jet.du : jet.dv) - first - h * second,
                   other_error = (is_by_u ? jet.dv : jet.du) - other - h * mixed;
    return length(point_error) <= agreeing * h * length(first)
           && length(first_error) <= agreeing * (h * length(second) + agreeing * length(first))
           && length(other_error) <= agreeing * (h * length(mixed) + agreeing * length(other));
  }

  // Throws if differences of `function`, which is `value` here, tend to another limit than `given`.
  template <class Function>
  void check_limit(const Vector_2& step, const Function& function, const Vector_3& value, const Vector_3& given,
                   double irrelevant, const std::string& name) const
  {
    std::array<Vector_3, 3> limits;
    double h = length(step);
    Vector_2 d = step;
    for(std::size_t i = 0; i < limits.size(); ++i, h /= ratio_of_lengths, d = d / ratio_of_lengths) {
      const Vector_3 forward = (function(m_place + d) - value) / h, backward = (value - function(m_place - d)) / h;
      limits[i] = 0.5 * (forward + backward);
      const double size = (std::max)(length(limits[i]), length(given)),
                   rounding = noise * length(value) / h + irrelevant;
      if(!(length(limits[i] - given) > wrong * size + rounding) || !(length(forward - given) > wrong * size + rounding)
         || !(length(backward - given) > wrong * size + rounding))
        return; // not if a value is not finite, either
      if(i > 0 && !(length(limits[i] - limits[i - 1]) < converged * size))
        return;
    }
    throw Parametric_surface_mesh_error("the derivatives of the surface contradict its points at (u,v) = " + describe(m_place)
                                        + ": " + name + " is " + text(given) + " by jet(), but " + text(limits.back())
                                        + " by differences");
  }

  static std::string text(const Vector_3& d) { return "(" + describe(d.x()) + ", " + describe(d.y()) + ", " + describe(d.z()) + ")"; }
};

// Looks at the derivatives inside a triangle in the coordinates of a chart.
template <class ChartedSurface, class FaceHandle>
void check_derivatives_in_face(const ChartedSurface& surface, FaceHandle face)
{
  typedef typename ChartedSurface::Point_2 Point_2;
  constexpr double share = 0.05; // of the length from the centre to the sides, along `u` and `v`
  const auto corner = [&](int i) -> const Point_2& { return face->vertex(i)->point().domain_point(); };
  const Point_2 center = centroid(corner(0), corner(1), corner(2));
  // the domain points of a triangle half as large about the same centre
  std::array<Point_2, 3> p;
  for(int i = 0; i < 3; ++i)
    p[i] = place_in_domain(surface, midpoint(center, corner(i)));
  const double area = std::fabs((p[1].x() - p[0].x()) * (p[2].y() - p[0].y()) - (p[1].y() - p[0].y()) * (p[2].x() - p[0].x()));
  double width = 0, height = 0;
  for(int i = 0; i < 3; ++i) {
    width = (std::max)(width, std::fabs(p[(i + 1) % 3].x() - p[i].x()));
    height = (std::max)(height, std::fabs(p[(i + 1) % 3].y() - p[i].y()));
  }
  if(area > 0)
    Derivative_check<typename ChartedSurface::Domain_surface>(surface.domain_surface(), place_in_domain(surface, center))(
      share * area / height, share * area / width);
}

// Looks at the derivatives of the surface of a patch in a few places: in large triangles of the triangulation.
template <class ChartedSurface, class Triangulation>
void check_derivatives(const ChartedSurface& surface, const Triangulation& triangulation)
{
  constexpr std::size_t number_of_places = 4;
  std::array<typename Triangulation::Face_handle, number_of_places> faces;
  std::array<double, number_of_places> areas{};
  std::size_t i = 0;
  for(const auto face : triangulation.finite_face_handles())
    if(face->is_in_domain()) {
      const auto &p = face->vertex(0)->point(), &q = face->vertex(1)->point(), &r = face->vertex(2)->point();
      const double area = (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
      const std::size_t place = i++ % number_of_places;
      if(area > areas[place]) {
        areas[place] = area;
        faces[place] = face;
      }
    }
  for(std::size_t place = 0; place < number_of_places; ++place)
    if(areas[place] > 0)
      check_derivatives_in_face(surface, faces[place]);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_CHECK_DERIVATIVES_H
