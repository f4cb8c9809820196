// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random trimmed patches: shapes within the unit circle, taken into the domain by a random linear map.
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_RANDOM_PATCHES_H
#define PARAMETRIC_SURFACE_MESHER_TEST_RANDOM_PATCHES_H

#include <CGAL/Parametric_function_surface_3.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>

#include <Sample_surfaces.h>
#include <mesher_test_helpers.h>
#include <random_input.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

// (u,v) -> (a u + b v, c u + d v)
struct Linear_map_2
{
  double a = 1, b = 0, c = 0, d = 1;

  Vector_2 operator()(const Vector_2& x) const { return Vector_2(a * x.x() + b * x.y(), c * x.x() + d * x.y()); }

  Linear_map_2 inverse() const
  {
    const double determinant = a * d - b * c;
    return {d / determinant, -b / determinant, -c / determinant, a / determinant};
  }

  // a rotation, different scales up to a ratio of `max_ratio`, a shear
  static Linear_map_2 random(Random_input& random, double max_ratio)
  {
    const double t = random.real(0, 7), scale = std::pow(10., random.real(-2, 2)), shear = random.real(-1.5, 1.5),
                 s = scale * std::pow(max_ratio, random.real(-1, 1));
    return {scale * std::cos(t), shear * scale * std::cos(t) - s * std::sin(t),
            scale * std::sin(t), shear * scale * std::sin(t) + s * std::cos(t)};
  }
};

// `factor S(map(u,v))`
template <class Surface>
struct Mapped_surface
{
  typedef Test_kernel Geom_traits;

  Surface surface;
  Linear_map_2 map;
  double factor;

  Point_3 point(double u, double v) const
  {
    const Vector_2 x = map(Vector_2(u, v));
    return scaled(surface.point(x.x(), x.y()));
  }

  CGAL::Surface_jet_3<Test_kernel> jet(double u, double v) const
  {
    const Vector_2 x = map(Vector_2(u, v));
    const auto s = surface.jet(x.x(), x.y());
    const double a = map.a, b = map.b, c = map.c, d = map.d;
    return {scaled(s.point), factor * (a * s.du + c * s.dv), factor * (b * s.du + d * s.dv),
            factor * (a * a * s.duu + 2 * a * c * s.duv + c * c * s.dvv),
            factor * (a * b * s.duu + (a * d + b * c) * s.duv + c * d * s.dvv),
            factor * (b * b * s.duu + 2 * b * d * s.duv + d * d * s.dvv)};
  }

private:
  Point_3 scaled(const Point_3& p) const { return CGAL::ORIGIN + factor * (p - CGAL::ORIGIN); }
};

// a sin(k x + l y + phase)
struct Wave
{
  double a, k, l, phase;

  // the value, and the derivatives by x, y, xx, xy, yy
  std::array<double, 6> jet(double x, double y) const
  {
    const double s = a * std::sin(k * x + l * y + phase), c = a * std::cos(k * x + l * y + phase);
    return {s, k * c, l * c, -k * k * s, -k * l * s, -l * l * s};
  }

  static Wave random(Random_input& random)
  {
    return {random.real(-0.2, 0.2), random.real(-5, 5), random.real(-5, 5), random.real(0, 7)};
  }
};

// a exp(-((x - x0)^2 + (y - y0)^2) w / 2)
struct Bump
{
  double a, x0, y0, w;

  std::array<double, 6> jet(double x, double y) const
  {
    x -= x0;
    y -= y0;
    const double z = a * std::exp(-0.5 * w * (x * x + y * y));
    return {z, -w * x * z, -w * y * z, (w * w * x * x - w) * z, w * w * x * y * z, (w * w * y * y - w) * z};
  }

  static Bump random(Random_input& random)
  {
    const double width = random.real(0.12, 0.6);
    return {random.real(-1, 1) * width, random.real(-1, 1), random.real(-1, 1), 1 / (width * width)};
  }
};

// the graph over (x,y) of the sum of one to four random terms
template <class Term>
auto random_graph(Random_input& random)
{
  std::vector<Term> terms;
  for(int n = random.integer(1, 4); n > 0; --n)
    terms.push_back(Term::random(random));
  return CGAL::make_parametric_jet_surface([terms](double x, double y) {
    std::array<double, 6> z{};
    for(const Term& term : terms) {
      const std::array<double, 6> jet = term.jet(x, y);
      for(int i = 0; i < 6; ++i)
        z[i] += jet[i];
    }
    return CGAL::Surface_jet_3<Test_kernel>{Point_3(x, y, z[0]), Vector_3(1, 0, z[1]), Vector_3(0, 1, z[2]),
                                            Vector_3(0, 0, z[3]), Vector_3(0, 0, z[4]), Vector_3(0, 0, z[5])};
  });
}

struct Random_patch
{
  Sample_surface surface;
  Domain domain;
  Criteria criteria;
};

class Random_patch_generator
{
  Random_input m_random;
  Linear_map_2 m_shape_to_domain;
  double m_factor = 1;

public:
  explicit Random_patch_generator(std::uint64_t seed) : m_random(seed) {}

  Random_input& random() { return m_random; }

  template <class Term>
  Random_patch graph()
  {
    return patch(random_graph<Term>(m_random), {}, Domain_kind::SMOOTH);
  }

  // a piece of plane, cylinder, cone, sphere or torus
  Random_patch primitive()
  {
    const double first = m_random.real(0.5, 1.5);
    switch(m_random.integer(0, 4)) {
    case 0: return patch(CGAL::Parametric_plane_3<Test_kernel>(), {}, Domain_kind::SMOOTH);
    case 1: return patch(CGAL::Parametric_cylinder_3<Test_kernel>(1), {first, 0, 0, 1}, Domain_kind::SMOOTH);
    case 2: return patch(CGAL::Parametric_cone_3<Test_kernel>(1, 0.4), {first, 0, 0, 0.8}, Domain_kind::SMOOTH);
    case 3: return patch(CGAL::Parametric_sphere_3<Test_kernel>(1), {first, 0, 0, 1.1}, Domain_kind::SMOOTH);
    default: return patch(CGAL::Parametric_torus_3<Test_kernel>(1, 0.4), {first, 0, 0, 2}, Domain_kind::SMOOTH);
    }
  }

  // sharp corners, narrow gaps, and divisions that do not fit to each other
  template <class Term>
  Random_patch rough_graph()
  {
    return patch(random_graph<Term>(m_random), {}, Domain_kind::ROUGH);
  }

private:
  enum class Domain_kind
  {
    SMOOTH,
    ROUGH
  };

  // `shape_to_surface` takes the unit circle to the domain of `surface`
  template <class Surface>
  Random_patch patch(const Surface& surface, const Linear_map_2& shape_to_surface, Domain_kind kind)
  {
    m_shape_to_domain = Linear_map_2::random(m_random, 10);
    m_factor = std::pow(10., m_random.real(-2, 2));
    const Linear_map_2 back = m_shape_to_domain.inverse();
    const Linear_map_2 map = {shape_to_surface.a * back.a, shape_to_surface.a * back.b, shape_to_surface.d * back.c,
                              shape_to_surface.d * back.d};
    return {Sample_surface(Mapped_surface<Surface>{surface, map, m_factor}), random_domain(kind), random_criteria()};
  }

  Domain random_domain(Domain_kind kind)
  {
    const bool is_rough = kind == Domain_kind::ROUGH;
    Domain domain(is_rough || m_random.integer(2) == 0 ? star(is_rough ? 0.25 : 0.6) : ellipse(Vector_2(0, 0), 0.9, 0.7));
    const int number_of_holes = m_random.integer(0, 3);
    const double turn = m_random.real(0, 7);
    for(int i = 0; i < number_of_holes; ++i) {
      const double angle = turn + 2.0944 * i + m_random.real(-0.2, 0.2), distance = is_rough ? 0.075 : 0.2;
      const double largest = 0.6 * distance; // two of them do not meet
      domain.add_hole(ellipse(distance * Vector_2(std::cos(angle), std::sin(angle)),
                              m_random.real(0.3, 1) * largest, m_random.real(0.3, 1) * largest));
    }
    if(is_rough)
      prescribe_divisions(domain);
    return domain;
  }

  // a star-shaped polygon with its corners at distances from `inner` to 1
  Domain::Loop star(double inner)
  {
    std::vector<Point_2> points;
    const int n = m_random.integer(6, 14);
    for(int i = 0; i < n; ++i) {
      const double angle = 6.2831853 * (i + m_random.real(-0.3, 0.3)) / n, r = m_random.real(inner, 1);
      points.push_back(CGAL::ORIGIN + m_shape_to_domain(r * Vector_2(std::cos(angle), std::sin(angle))));
    }
    return Domain::polygon(points);
  }

  Domain::Loop ellipse(const Vector_2& center, double a, double b)
  {
    const Point_2 c = CGAL::ORIGIN + m_shape_to_domain(center);
    const Vector_2 x = m_shape_to_domain(Vector_2(a, 0)), y = m_shape_to_domain(Vector_2(0, b));
    return {Curve(
      [c, x, y](double t) {
        const double cosine = std::cos(t), sine = std::sin(t);
        return Curve::Jet{c + cosine * x + sine * y, cosine * y - sine * x, -cosine * x - sine * y};
      },
      0, 8 * std::atan(1.))};
  }

  void prescribe_divisions(Domain& domain)
  {
    for(auto& loop : domain.loops())
      for(auto& curve : loop)
        if(m_random.integer(2) == 0)
          curve.set_number_of_edges(m_random.integer(curve.is_straight() ? 1 : 8, 40));
  }

  Criteria random_criteria()
  {
    Criteria criteria;
    const double max_edge = m_factor * m_random.real(0.06, 0.3);
    criteria.set_max_edge(max_edge).set_min_edge(max_edge / std::pow(10., m_random.real(0.5, 2)));
    criteria.set_gamma(m_random.real(0.03, 0.2)).set_angle(m_random.real(15, 30));
    if(m_random.integer(2) == 0)
      criteria.set_size_factor(m_random.real(0.2, 0.5));
    if(m_random.integer(4) == 0)
      criteria.set_distance(max_edge * m_random.real(0.005, 0.1));
    if(m_random.integer(4) == 0)
      criteria.set_curve_deviation(CGAL::Parametric_surface_mesher::Curve_deviation::HEIGHT_OVER_RADIUS);
    if(m_random.integer(4) == 0)
      criteria.set_sizing_field([max_edge](double u, double v) { return max_edge * (0.6 + 0.3 * std::sin(u + v)); });
    return criteria;
  }
};

#endif // PARAMETRIC_SURFACE_MESHER_TEST_RANDOM_PATCHES_H
