// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random surfaces of all kinds.
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_RANDOM_FUZZ_SURFACE_H
#define PARAMETRIC_SURFACE_MESHER_TEST_RANDOM_FUZZ_SURFACE_H

#include <CGAL/B_spline_surface_3.h>
#include <CGAL/Bezier_surface_3.h>
#include <CGAL/Parametric_frame_3.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>

#include <Fuzz_case.h>
#include <Fuzz_random.h>
#include <Second_order_jet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// A surface by its formula, which maps two `Second_order_jet`s to an array of three.
template <class Formula>
struct Fuzz_formula_surface
{
  typedef Fuzz_kernel::Vector_3 Vector_3;

  Formula formula;

  Fuzz_kernel::Point_3 point(double u, double v) const { return jet(u, v).point; }

  CGAL::Surface_jet_3<Fuzz_kernel> jet(double u, double v) const
  {
    const std::array<Second_order_jet, 3> s = formula(Second_order_jet(u, 1, 0, 0, 0, 0), Second_order_jet(v, 0, 1, 0, 0, 0));
    return {{s[0].value, s[1].value, s[2].value},
            Vector_3(s[0].u, s[1].u, s[2].u), Vector_3(s[0].v, s[1].v, s[2].v),
            Vector_3(s[0].uu, s[1].uu, s[2].uu), Vector_3(s[0].uv, s[1].uv, s[2].uv), Vector_3(s[0].vv, s[1].vv, s[2].vv)};
  }
};

template <class Formula>
Fuzz_formula_surface<Formula> make_fuzz_formula_surface(const Formula& formula)
{
  return {formula};
}

// A surface, and what is known of it.
struct Random_fuzz_surface
{
  Fuzz_surface surface;
  std::string name;
  bool is_regular = true; // without singular points and creases inside its rectangle
};

class Random_fuzz_surface_maker
{
  typedef Fuzz_kernel::Point_3 Point_3;
  typedef Fuzz_kernel::Vector_3 Vector_3;
  typedef CGAL::Parametric_frame_3<Fuzz_kernel> Frame;

  Fuzz_random& m_random;

public:
  explicit Random_fuzz_surface_maker(Fuzz_random& random) : m_random(random) {}

  Random_fuzz_surface operator()()
  {
    switch(m_random.integer(0, 11)) {
    case 0: return {plane(), "plane"};
    case 1: return {cylinder(), "cylinder"};
    case 2: return cone();
    case 3: return sphere();
    case 4: return {torus(), "torus"};
    case 5: return bezier();
    case 6: return b_spline(false);
    case 7: return b_spline(true);
    case 8:
    case 9: return graph();
    case 10: return {spiral(), "spiral"};
    default: return singular();
    }
  }

  Fuzz_surface plane()
  {
    const Vector_3 a = vector(), b = vector();
    const bool is_thin = cross_product(a, b).squared_length() < 1e-4;
    return Fuzz_surface(CGAL::Parametric_plane_3<Fuzz_kernel>(point(), a, is_thin ? Vector_3(-a.y(), a.x(), a.z() + 1) : b),
                        -1, 1, -1, 1);
  }

  Fuzz_surface cylinder()
  {
    const double begin = m_random.real(-4, 4), height = m_random.magnitude(0.05, 5);
    return Fuzz_surface(CGAL::Parametric_cylinder_3<Fuzz_kernel>(m_random.magnitude(0.1, 10), frame()), begin,
                        begin + m_random.real(0.2, 6), -height, height);
  }

  // with or without its apex
  Random_fuzz_surface cone()
  {
    const double angle = m_random.real(0.1, 1.4), begin = m_random.real(-4, 4), end = begin + m_random.real(0.2, 6),
                 radius = m_random.chance(0.5) ? 0 : m_random.magnitude(0.01, 2);
    const CGAL::Parametric_cone_3<Fuzz_kernel> cone(radius, angle, frame());
    return {Fuzz_surface(cone, begin, end, 0, m_random.magnitude(0.2, 3)), radius > 0 ? "cone" : "cone with apex", radius > 0};
  }

  // with none, one, or two poles
  Random_fuzz_surface sphere()
  {
    const double half_pi = CGAL_PI / 2, begin = m_random.real(-4, 4), end = begin + m_random.real(0.2, 6);
    const bool has_north = m_random.chance(0.3), has_south = m_random.chance(0.3);
    return {Fuzz_surface(CGAL::Parametric_sphere_3<Fuzz_kernel>(m_random.magnitude(0.1, 10), frame()), begin, end,
                         has_south ? -half_pi : m_random.real(-1.4, 0), has_north ? half_pi : m_random.real(0.1, 1.5)),
            "sphere", !has_north && !has_south};
  }

  Fuzz_surface torus()
  {
    const double u = m_random.real(-4, 4), v = m_random.real(-4, 4);
    return Fuzz_surface(CGAL::Parametric_torus_3<Fuzz_kernel>(1, m_random.real(0.05, 0.9), frame()), u, u + m_random.real(0.2, 6),
                        v, v + m_random.real(0.2, 6));
  }

  Random_fuzz_surface bezier()
  {
    const int n = m_random.integer(1, 6), m = m_random.integer(1, 6);
    std::vector<Point_3> net = control_net(n + 1, m + 1);
    const bool is_collapsed = m_random.chance(0.2);
    if(is_collapsed)
      std::fill(net.begin(), net.begin() + n + 1, net.front());
    return {Fuzz_surface(CGAL::Bezier_surface_3<Fuzz_kernel>(n, m, net), 0, 1, 0, 1),
            is_collapsed ? "Bezier surface with a collapsed side" : "Bezier surface", false};
  }

  Random_fuzz_surface b_spline(bool is_rational)
  {
    const int p = m_random.integer(1, 5), q = m_random.integer(1, 5);
    const std::vector<double> u = knots(p), v = knots(q);
    const int n = int(u.size()) - p - 1, m = int(v.size()) - q - 1;
    std::vector<double> weights;
    if(is_rational)
      for(int i = 0; i < n * m; ++i)
        weights.push_back(m_random.magnitude(0.2, 5));
    const CGAL::B_spline_surface_3<Fuzz_kernel> surface(p, q, u, v, control_net(n, m), weights);
    return {Fuzz_surface(surface, surface.u_min(), surface.u_max(), surface.v_min(), surface.v_max()),
            is_rational ? "NURBS surface" : "B-spline surface", false};
  }

  // hills, waves, saddles and ridges over the unit square
  Random_fuzz_surface graph()
  {
    const int kind = m_random.integer(0, 4);
    std::array<double, 6> c;
    for(double& x : c)
      x = m_random.real(-1, 1);
    const double width = m_random.magnitude(0.03, 1), frequency = m_random.magnitude(0.5, 8);
    const auto formula = [=](const Second_order_jet& x, const Second_order_jet& y) {
      const Second_order_jet s = x - Second_order_jet(c[0]), t = y - Second_order_jet(c[1]);
      Second_order_jet z;
      switch(kind) {
      case 0: z = exp((s * s + t * t) * (-0.5 / (width * width))) * c[2]; break;
      case 1: z = sin(x * (frequency * c[2]) + y * (frequency * c[3])) * (c[4] / frequency); break;
      case 2: z = s * s * c[2] + s * t * (2 * c[3]) + t * t * c[4] + s * s * s * c[5]; break;
      case 3: z = sqrt((s * c[2] + t * c[3]) * (s * c[2] + t * c[3]) + Second_order_jet(0.01 * width * width)); break;
      default: z = tanh((s * c[2] + t * c[3]) * (1 / width)) * c[4]; break;
      }
      return std::array<Second_order_jet, 3>{x, y, z};
    };
    static const char* const names[] = {"hill", "wave", "saddle", "ridge", "step"};
    return {Fuzz_surface(make_fuzz_formula_surface(formula), -1, 1, -1, 1), names[kind]};
  }

  Fuzz_surface spiral()
  {
    const double pitch = m_random.magnitude(0.02, 2), inner = m_random.real(0.05, 1), turns = m_random.real(1, 12);
    const auto formula = [=](const Second_order_jet& x, const Second_order_jet& y) {
      return std::array<Second_order_jet, 3>{y * cos(x), y * sin(x), x * pitch};
    };
    return Fuzz_surface(make_fuzz_formula_surface(formula), 0, turns, inner, inner + 1);
  }

  // surfaces with singular points, jumps of derivatives, or no area
  Random_fuzz_surface singular()
  {
    const int kind = m_random.integer(0, 7);
    const double c = m_random.real(-0.5, 0.5), k = m_random.real(1, 8);
    const auto formula = [=](const Second_order_jet& x, const Second_order_jet& y) {
      const Second_order_jet s = x - Second_order_jet(c);
      std::array<Second_order_jet, 3> result = {x, y, Second_order_jet()};
      switch(kind) {
      case 0: result[0] = s * s * s; break;                  // a line where it stands still
      case 1: result[2] = abs(s) * k; break;                 // a crease
      case 2: result = {exp(x * k), y, Second_order_jet()}; break; // very different speeds
      case 3: result = {x, x * 2., x * -1.}; break;          // a curve
      case 4: result = {c, c, c}; break;                     // a point
      case 5: result[2] = sqrt(s); break;                    // not defined everywhere
      case 6: result[0] = s * s; break;                      // a fold
      default: result = {s * s - y * y, s * y * 2., s * k}; break;
      }
      return result;
    };
    static const char* const names[] = {"plane that stands still", "crease", "exponential", "curve", "point",
                                        "surface with a hole in its definition", "fold", "self-intersecting surface"};
    return {Fuzz_surface(make_fuzz_formula_surface(formula), -1, 1, -1, 1), names[kind], kind == 7};
  }

  // a net over the unit square, with its points moved by up to some of their distance
  std::vector<Point_3> control_net(int n, int m)
  {
    const double wildness = m_random.chance(0.7) ? m_random.real(0, 0.45) : m_random.real(0.5, 3),
                 height = m_random.magnitude(0.05, 2);
    std::vector<Point_3> result;
    for(int j = 0; j < m; ++j)
      for(int i = 0; i < n; ++i)
        result.emplace_back((i + wildness * m_random.real(-1, 1)) / (n - 1), (j + wildness * m_random.real(-1, 1)) / (m - 1),
                            height * m_random.real(-1, 1));
    return result;
  }

  Frame frame()
  {
    const double t = m_random.real(0, 7), s = m_random.real(-1.5, 1.5);
    const Vector_3 axis(std::cos(s) * std::cos(t), std::cos(s) * std::sin(t), std::sin(s)), hint(-std::sin(t), std::cos(t), 0);
    return m_random.chance(0.3) ? Frame() : Frame(point(), axis, hint);
  }

  Vector_3 vector() { return Vector_3(m_random.real(-1, 1), m_random.real(-1, 1), m_random.real(-1, 1)); }

private:
  Point_3 point()
  {
    const double size = m_random.chance(0.1) ? 1e4 : 1;
    return CGAL::ORIGIN + size * vector();
  }

  // with inner knots of any multiplicity that is allowed
  std::vector<double> knots(int degree)
  {
    std::vector<double> result(std::size_t(degree) + 1, 0.);
    double last = 0;
    for(int n = m_random.integer(0, 3); n > 0; --n) {
      last += m_random.magnitude(0.01, 1);
      result.insert(result.end(), std::size_t(m_random.chance(0.7) ? 1 : m_random.integer(1, degree)), last);
    }
    last += m_random.magnitude(0.05, 1);
    result.insert(result.end(), std::size_t(degree) + 1, last);
    return result;
  }
};

#endif // PARAMETRIC_SURFACE_MESHER_TEST_RANDOM_FUZZ_SURFACE_H
