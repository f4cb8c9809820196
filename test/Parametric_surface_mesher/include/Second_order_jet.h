// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_SECOND_ORDER_JET_H
#define PARAMETRIC_SURFACE_MESHER_TEST_SECOND_ORDER_JET_H

#include <cmath>

// A number that carries its derivatives by `u` and `v` up to second order: formulas of test surfaces are written with it. It
// compiles in a fraction of the time of Boost's automatic differentiation.
struct Second_order_jet
{
  double value = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;

  Second_order_jet(double x = 0) : value(x) {}
  Second_order_jet(double x, double du, double dv, double duu, double duv, double dvv)
    : value(x), u(du), v(dv), uu(duu), uv(duv), vv(dvv)
  {}

  // `f(x)`, by the values of `f`, `f'` and `f''` at `x`
  Second_order_jet composed(double f, double d, double dd) const
  {
    return {f, d * u, d * v, dd * u * u + d * uu, dd * u * v + d * uv, dd * v * v + d * vv};
  }

  friend Second_order_jet operator+(const Second_order_jet& a, const Second_order_jet& b)
  {
    return {a.value + b.value, a.u + b.u, a.v + b.v, a.uu + b.uu, a.uv + b.uv, a.vv + b.vv};
  }

  friend Second_order_jet operator-(const Second_order_jet& a, const Second_order_jet& b) { return a + b * -1.; }

  friend Second_order_jet operator*(const Second_order_jet& a, const Second_order_jet& b)
  {
    return {a.value * b.value,
            a.u * b.value + a.value * b.u,
            a.v * b.value + a.value * b.v,
            a.uu * b.value + 2 * a.u * b.u + a.value * b.uu,
            a.uv * b.value + a.u * b.v + a.v * b.u + a.value * b.uv,
            a.vv * b.value + 2 * a.v * b.v + a.value * b.vv};
  }
};

inline Second_order_jet sin(const Second_order_jet& x)
{
  return x.composed(std::sin(x.value), std::cos(x.value), -std::sin(x.value));
}

inline Second_order_jet cos(const Second_order_jet& x)
{
  return x.composed(std::cos(x.value), -std::sin(x.value), -std::cos(x.value));
}

inline Second_order_jet exp(const Second_order_jet& x)
{
  return x.composed(std::exp(x.value), std::exp(x.value), std::exp(x.value));
}

inline Second_order_jet tanh(const Second_order_jet& x)
{
  const double t = std::tanh(x.value), d = 1 - t * t;
  return x.composed(t, d, -2 * t * d);
}

inline Second_order_jet sqrt(const Second_order_jet& x)
{
  const double s = std::sqrt(x.value);
  return x.composed(s, 0.5 / s, -0.25 / (s * x.value));
}

inline Second_order_jet abs(const Second_order_jet& x)
{
  return x.composed(std::fabs(x.value), x.value < 0 ? -1 : 1, 0);
}

#endif // PARAMETRIC_SURFACE_MESHER_TEST_SECOND_ORDER_JET_H
