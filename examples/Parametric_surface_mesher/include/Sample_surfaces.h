// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The named test surfaces of the example and benchmark programs, with their domains and areas: each a single patch. Closed
// surfaces are cut open along a seam here; Sample_models.h closes them.
#ifndef SAMPLE_SURFACES_H
#define SAMPLE_SURFACES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_domain_2.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Surface_jet_3.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Sample_kernel;

// One type for all of them, so that the mesher is compiled once: a model of ParametricSurface_3 over callables.
class Sample_surface
{
public:
  typedef Sample_kernel Geom_traits;
  typedef Geom_traits::Point_3 Point_3;
  typedef Geom_traits::Vector_3 Vector_3;
  typedef CGAL::Surface_jet_3<Geom_traits> Jet;

private:
  std::function<Point_3(double, double)> m_point;
  std::function<Jet(double, double)> m_jet;

public:
  template <class Surface>
  explicit Sample_surface(const Surface& surface)
    : m_point([surface](double u, double v) { return surface.point(u, v); }),
      m_jet([surface](double u, double v) { return surface.jet(u, v); })
  {}

  Point_3 point(double u, double v) const { return m_point(u, v); }
  Jet jet(double u, double v) const { return m_jet(u, v); }
};

namespace sample_surfaces {

// the length of the edges of `number_of_triangles` equilateral triangles with this area in all
inline double edge_length(double area, double number_of_triangles)
{
  return std::sqrt(4 * area / (std::sqrt(3.) * number_of_triangles));
}

} // namespace sample_surfaces

// A patch: a surface with its domain.
struct Sample
{
  std::string name;
  Sample_surface surface;
  CGAL::Parametric_domain_2<Sample_kernel> domain;
  double area;

  double edge_length(double number_of_triangles) const
  {
    return sample_surfaces::edge_length(area, number_of_triangles);
  }
};

namespace sample_surfaces {

typedef Sample_surface::Point_3 Point_3;
typedef Sample_surface::Vector_3 Vector_3;
typedef Sample_surface::Jet Jet;
typedef CGAL::Parametric_domain_2<Sample_kernel> Domain;

const double pi = 4 * std::atan(1.);

// a surface given by its jet alone
template <class Derived>
struct From_jet
{
  Point_3 point(double u, double v) const { return static_cast<const Derived&>(*this).jet(u, v).point; }
};

struct Flat : From_jet<Flat>
{
  Jet jet(double u, double v) const
  {
    const Vector_3 zero(0, 0, 0);
    return {Point_3(u, v, 0), Vector_3(1, 0, 0), Vector_3(0, 1, 0), zero, zero, zero};
  }
};

// A line, an arc of 90 degrees with radius 0.1, a line; u is the arc length, the arc lies in the middle of [0,2].
struct Bend : From_jet<Bend>
{
  static constexpr double radius = 0.1;

  Jet jet(double u, double v) const
  {
    const Vector_3 zero(0, 0, 0), dv(0, 1, 0);
    const double begin = 1 - radius * pi / 4, end = 1 + radius * pi / 4;
    if(u <= begin)
      return {Point_3(u, v, 0), Vector_3(1, 0, 0), dv, zero, zero, zero};
    if(u >= end)
      return {Point_3(begin + radius, v, radius + (u - end)), Vector_3(0, 0, 1), dv, zero, zero, zero};
    const double s = std::sin((u - begin) / radius), c = std::cos((u - begin) / radius);
    return {Point_3(begin + radius * s, v, radius * (1 - c)), Vector_3(c, 0, s), dv,
            Vector_3(-s / radius, 0, c / radius), zero, zero};
  }
};

// (u, v, 0.8 exp(-(u^2 + v^2) / (2 * 0.12^2)))
struct Peak : From_jet<Peak>
{
  Jet jet(double u, double v) const
  {
    const double w = 1 / (0.12 * 0.12), z = 0.8 * std::exp(-0.5 * w * (u * u + v * v));
    return {Point_3(u, v, z), Vector_3(1, 0, -w * u * z), Vector_3(0, 1, -w * v * z),
            Vector_3(0, 0, (w * w * u * u - w) * z), Vector_3(0, 0, w * w * u * v * z),
            Vector_3(0, 0, (w * w * v * v - w) * z)};
  }
};

// (u, v, 0.5 (u^2 + v^2))
struct Paraboloid : From_jet<Paraboloid>
{
  Jet jet(double u, double v) const
  {
    return {Point_3(u, v, 0.5 * (u * u + v * v)), Vector_3(1, 0, u), Vector_3(0, 1, v),
            Vector_3(0, 0, 1), Vector_3(0, 0, 0), Vector_3(0, 0, 1)};
  }
};

// (u + 3v, v, 0.2 sin u)
struct Skew : From_jet<Skew>
{
  Jet jet(double u, double v) const
  {
    const Vector_3 zero(0, 0, 0);
    return {Point_3(u + 3 * v, v, 0.2 * std::sin(u)), Vector_3(1, 0, 0.2 * std::cos(u)), Vector_3(3, 1, 0),
            Vector_3(0, 0, -0.2 * std::sin(u)), zero, zero};
  }
};

// (u/20, v, 0.1 sin(2 pi u/20))
struct Stretch : From_jet<Stretch>
{
  Jet jet(double u, double v) const
  {
    const Vector_3 zero(0, 0, 0);
    const double w = pi / 10;
    return {Point_3(u / 20, v, 0.1 * std::sin(w * u)), Vector_3(0.05, 0, 0.1 * w * std::cos(w * u)),
            Vector_3(0, 1, 0), Vector_3(0, 0, -0.1 * w * w * std::sin(w * u)), zero, zero};
  }
};

inline Domain square_with_hole()
{
  Domain domain = Domain::rectangle(-1, 1, -1, 1);
  domain.add_hole({Domain::Curve::circle(Domain::Point_2(0.2, 0.1), 0.25)});
  return domain;
}

// the parallelogram whose image over (x,y) is [0,6] x [0,2]
inline Domain sheared_rectangle()
{
  return Domain({Domain::Point_2(0, 0), Domain::Point_2(6, 0), Domain::Point_2(0, 2), Domain::Point_2(-6, 2)});
}

} // namespace sample_surfaces

inline std::vector<std::string> sample_names()
{
  return {"flat", "bend", "peak", "hole", "cap", "sphere", "torus", "cyl", "skew", "stretch"};
}

// The sample with this name; throws std::invalid_argument if there is none.
inline Sample make_sample(const std::string& name)
{
  using namespace sample_surfaces;
  if(name == "flat")
    return {name, Sample_surface(Flat()), Domain::rectangle(0, 1, 0, 1), 1};
  if(name == "bend")
    return {name, Sample_surface(Bend()), Domain::rectangle(0, 2, 0, 1), 2};
  if(name == "peak")
    return {name, Sample_surface(Peak()), Domain::rectangle(-1, 1, -1, 1), 4.4795539};
  if(name == "hole")
    return {name, Sample_surface(Paraboloid()), square_with_hole(), 4.9190438};
  if(name == "cap")
    return {name, Sample_surface(CGAL::Parametric_sphere_3<Sample_kernel>(1)),
            Domain::rectangle(0, pi / 2, -pi / 4, pi / 4), 2.2214415};
  if(name == "sphere")
    return {name, Sample_surface(CGAL::Parametric_sphere_3<Sample_kernel>(1)),
            Domain::rectangle(0, 2 * pi, -pi / 2, pi / 2), 12.566371};
  if(name == "torus")
    return {name, Sample_surface(CGAL::Parametric_torus_3<Sample_kernel>(1, 0.3)),
            Domain::rectangle(0, 2 * pi, 0, 2 * pi), 11.843525};
  if(name == "cyl")
    return {name, Sample_surface(CGAL::Parametric_cylinder_3<Sample_kernel>(1)),
            Domain::rectangle(0, 2 * pi, 0, 2), 12.566371};
  if(name == "skew")
    return {name, Sample_surface(Skew()), sheared_rectangle(), 13.124706};
  if(name == "stretch")
    return {name, Sample_surface(Stretch()), Domain::rectangle(0, 20, 0, 1), 1.0923835};
  throw std::invalid_argument("no sample surface is called '" + name + "'");
}

#endif // SAMPLE_SURFACES_H
