// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_TAYLOR_POLYNOMIAL_2_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_TAYLOR_POLYNOMIAL_2_H

#include <cmath>
#include <type_traits>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
The value of a function of `u` and `v` with its derivatives up to second order: the number type of automatic differentiation.
`u`, `v` and all that is computed from them have this one type. Boost.Math's `autodiff_fvar` gives each variable a type of its
own (a sum `z = z + f(u,v)` that begins with the type of `u` loses the derivatives by `v`) and, with one type for both, carries
nine coefficients; this class takes half of its time, to compile as well as to compute.
*/
class Taylor_polynomial_2
{
public:
  double value = 0, du = 0, dv = 0, duu = 0, duv = 0, dvv = 0;

  Taylor_polynomial_2() = default;

  // a constant
  template <class Number, class = std::enable_if_t<std::is_arithmetic<Number>::value>>
  Taylor_polynomial_2(Number x) : value(double(x)) {}

  Taylor_polynomial_2(double f, double f_u, double f_v, double f_uu, double f_uv, double f_vv)
    : value(f), du(f_u), dv(f_v), duu(f_uu), duv(f_uv), dvv(f_vv)
  {}

  static Taylor_polynomial_2 first_variable(double u) { return {u, 1, 0, 0, 0, 0}; }
  static Taylor_polynomial_2 second_variable(double v) { return {v, 0, 1, 0, 0, 0}; }

  // It is there for the sentence that it fails with: what takes a `double` loses the derivatives.
  template <class Number, class = std::enable_if_t<std::is_same<Number, double>::value>>
  operator Number() const
  {
    static_assert(!std::is_same<Number, double>::value,
                  "A formula must not turn what depends on its parameters into a double, which has no derivatives: declare "
                  "parameters and values 'auto', and write 'using std::sin; sin(u)' in place of 'std::sin(u)'.");
    return value;
  }

  // `f(*this)`, from the value and the first two derivatives of f there
  Taylor_polynomial_2 composed(double f, double first, double second) const
  {
    return {f,
            first * du,
            first * dv,
            first * duu + second * (du * du),
            first * duv + second * (du * dv),
            first * dvv + second * (dv * dv)};
  }

  Taylor_polynomial_2 operator-() const { return {-value, -du, -dv, -duu, -duv, -dvv}; }
  Taylor_polynomial_2 operator+() const { return *this; }

  Taylor_polynomial_2& operator+=(const Taylor_polynomial_2& b) { return *this = *this + b; }
  Taylor_polynomial_2& operator-=(const Taylor_polynomial_2& b) { return *this = *this - b; }
  Taylor_polynomial_2& operator*=(const Taylor_polynomial_2& b) { return *this = *this * b; }
  Taylor_polynomial_2& operator/=(const Taylor_polynomial_2& b) { return *this = *this / b; }

  friend Taylor_polynomial_2 operator+(const Taylor_polynomial_2& a, const Taylor_polynomial_2& b)
  {
    return {a.value + b.value, a.du + b.du, a.dv + b.dv, a.duu + b.duu, a.duv + b.duv, a.dvv + b.dvv};
  }

  friend Taylor_polynomial_2 operator-(const Taylor_polynomial_2& a, const Taylor_polynomial_2& b)
  {
    return {a.value - b.value, a.du - b.du, a.dv - b.dv, a.duu - b.duu, a.duv - b.duv, a.dvv - b.dvv};
  }

  friend Taylor_polynomial_2 operator*(const Taylor_polynomial_2& a, const Taylor_polynomial_2& b)
  {
    return {a.value * b.value,
            a.du * b.value + a.value * b.du,
            a.dv * b.value + a.value * b.dv,
            a.duu * b.value + 2 * (a.du * b.du) + a.value * b.duu,
            a.duv * b.value + a.du * b.dv + a.dv * b.du + a.value * b.duv,
            a.dvv * b.value + 2 * (a.dv * b.dv) + a.value * b.dvv};
  }

  // from `q b = a`
  friend Taylor_polynomial_2 operator/(const Taylor_polynomial_2& a, const Taylor_polynomial_2& b)
  {
    const double q = a.value / b.value, inverse = 1 / b.value;
    const double q_u = (a.du - q * b.du) * inverse, q_v = (a.dv - q * b.dv) * inverse;
    return {q, q_u, q_v,
            (a.duu - 2 * (q_u * b.du) - q * b.duu) * inverse,
            (a.duv - q_u * b.dv - q_v * b.du - q * b.duv) * inverse,
            (a.dvv - 2 * (q_v * b.dv) - q * b.dvv) * inverse};
  }

  // with plain numbers, at less cost

  template <class Number>
  using If_number = std::enable_if_t<std::is_arithmetic<Number>::value, Taylor_polynomial_2>;

  template <class Number>
  friend If_number<Number> operator+(const Taylor_polynomial_2& a, Number b)
  {
    return {a.value + double(b), a.du, a.dv, a.duu, a.duv, a.dvv};
  }

  template <class Number>
  friend If_number<Number> operator+(Number a, const Taylor_polynomial_2& b)
  {
    return {double(a) + b.value, b.du, b.dv, b.duu, b.duv, b.dvv};
  }

  template <class Number>
  friend If_number<Number> operator-(const Taylor_polynomial_2& a, Number b)
  {
    return {a.value - double(b), a.du, a.dv, a.duu, a.duv, a.dvv};
  }

  template <class Number>
  friend If_number<Number> operator-(Number a, const Taylor_polynomial_2& b)
  {
    return {double(a) - b.value, -b.du, -b.dv, -b.duu, -b.duv, -b.dvv};
  }

  template <class Number>
  friend If_number<Number> operator*(const Taylor_polynomial_2& a, Number b)
  {
    const double x = double(b);
    return {a.value * x, a.du * x, a.dv * x, a.duu * x, a.duv * x, a.dvv * x};
  }

  template <class Number>
  friend If_number<Number> operator*(Number a, const Taylor_polynomial_2& b)
  {
    return b * a;
  }

  template <class Number>
  friend If_number<Number> operator/(const Taylor_polynomial_2& a, Number b)
  {
    const double x = double(b);
    return {a.value / x, a.du / x, a.dv / x, a.duu / x, a.duv / x, a.dvv / x};
  }

  template <class Number>
  friend If_number<Number> operator/(Number a, const Taylor_polynomial_2& b)
  {
    const double inverse = 1 / b.value, q = double(a) / b.value, first = -q * inverse;
    return b.composed(q, first, -2 * first * inverse);
  }
};

// The value that a comparison sees.
inline double value_of(const Taylor_polynomial_2& x) { return x.value; }

template <class Number, class = std::enable_if_t<std::is_arithmetic<Number>::value>>
Number value_of(Number x)
{
  return x;
}

// Whether operands are numbers or depend on the parameters, and one of them does that.
template <class... Operands>
struct Depend_on_parameters
  : std::bool_constant<(std::is_same<Operands, Taylor_polynomial_2>::value || ...)
                       && ((std::is_same<Operands, Taylor_polynomial_2>::value || std::is_arithmetic<Operands>::value) && ...)>
{};

template <class Result, class... Operands>
using If_depend_on_parameters = std::enable_if_t<Depend_on_parameters<Operands...>::value, Result>;

template <class A, class B>
If_depend_on_parameters<bool, A, B> operator<(const A& a, const B& b) { return value_of(a) < value_of(b); }

template <class A, class B>
If_depend_on_parameters<bool, A, B> operator>(const A& a, const B& b) { return value_of(a) > value_of(b); }

template <class A, class B>
If_depend_on_parameters<bool, A, B> operator<=(const A& a, const B& b) { return value_of(a) <= value_of(b); }

template <class A, class B>
If_depend_on_parameters<bool, A, B> operator>=(const A& a, const B& b) { return value_of(a) >= value_of(b); }

template <class A, class B>
If_depend_on_parameters<bool, A, B> operator==(const A& a, const B& b) { return value_of(a) == value_of(b); }

template <class A, class B>
If_depend_on_parameters<bool, A, B> operator!=(const A& a, const B& b) { return value_of(a) != value_of(b); }

/// \name Functions
/// They are found by the names of the standard functions, `using std::sin; sin(x)`.
/// @{

inline Taylor_polynomial_2 sqrt(const Taylor_polynomial_2& x)
{
  const double f = std::sqrt(x.value), first = 0.5 / f;
  return x.composed(f, first, -0.5 * first / x.value);
}

inline Taylor_polynomial_2 cbrt(const Taylor_polynomial_2& x)
{
  const double f = std::cbrt(x.value), first = 1 / (3 * f * f);
  return x.composed(f, first, -2 * first / (3 * x.value));
}

inline Taylor_polynomial_2 exp(const Taylor_polynomial_2& x)
{
  const double f = std::exp(x.value);
  return x.composed(f, f, f);
}

inline Taylor_polynomial_2 exp2(const Taylor_polynomial_2& x)
{
  const double f = std::exp2(x.value), log_2 = std::log(2.);
  return x.composed(f, f * log_2, f * log_2 * log_2);
}

inline Taylor_polynomial_2 expm1(const Taylor_polynomial_2& x)
{
  const double derivative = std::exp(x.value);
  return x.composed(std::expm1(x.value), derivative, derivative);
}

inline Taylor_polynomial_2 log(const Taylor_polynomial_2& x)
{
  const double inverse = 1 / x.value;
  return x.composed(std::log(x.value), inverse, -inverse * inverse);
}

inline Taylor_polynomial_2 log1p(const Taylor_polynomial_2& x)
{
  const double inverse = 1 / (1 + x.value);
  return x.composed(std::log1p(x.value), inverse, -inverse * inverse);
}

inline Taylor_polynomial_2 log2(const Taylor_polynomial_2& x) { return log(x) / std::log(2.); }
inline Taylor_polynomial_2 log10(const Taylor_polynomial_2& x) { return log(x) / std::log(10.); }

inline Taylor_polynomial_2 sin(const Taylor_polynomial_2& x)
{
  const double s = std::sin(x.value);
  return x.composed(s, std::cos(x.value), -s);
}

inline Taylor_polynomial_2 cos(const Taylor_polynomial_2& x)
{
  const double c = std::cos(x.value);
  return x.composed(c, -std::sin(x.value), -c);
}

inline Taylor_polynomial_2 tan(const Taylor_polynomial_2& x)
{
  const double f = std::tan(x.value), first = 1 + f * f;
  return x.composed(f, first, 2 * f * first);
}

inline Taylor_polynomial_2 asin(const Taylor_polynomial_2& x)
{
  const double square = 1 - x.value * x.value, first = 1 / std::sqrt(square);
  return x.composed(std::asin(x.value), first, x.value * first / square);
}

inline Taylor_polynomial_2 acos(const Taylor_polynomial_2& x)
{
  const double square = 1 - x.value * x.value, first = -1 / std::sqrt(square);
  return x.composed(std::acos(x.value), first, x.value * first / square);
}

inline Taylor_polynomial_2 atan(const Taylor_polynomial_2& x)
{
  const double first = 1 / (1 + x.value * x.value);
  return x.composed(std::atan(x.value), first, -2 * x.value * first * first);
}

// Its derivatives are those of the angle of a point of the plane, whatever the quadrant.
template <class Y, class X>
If_depend_on_parameters<Taylor_polynomial_2, Y, X> atan2(const Y& y, const X& x)
{
  const Taylor_polynomial_2 a = y, b = x;
  Taylor_polynomial_2 result = std::fabs(b.value) > std::fabs(a.value) ? atan(a / b) : -atan(b / a);
  result.value = std::atan2(a.value, b.value);
  return result;
}

inline Taylor_polynomial_2 sinh(const Taylor_polynomial_2& x)
{
  const double s = std::sinh(x.value);
  return x.composed(s, std::cosh(x.value), s);
}

inline Taylor_polynomial_2 cosh(const Taylor_polynomial_2& x)
{
  const double c = std::cosh(x.value);
  return x.composed(c, std::sinh(x.value), c);
}

inline Taylor_polynomial_2 tanh(const Taylor_polynomial_2& x)
{
  const double f = std::tanh(x.value), first = 1 - f * f;
  return x.composed(f, first, -2 * f * first);
}

inline Taylor_polynomial_2 asinh(const Taylor_polynomial_2& x)
{
  const double square = 1 + x.value * x.value, first = 1 / std::sqrt(square);
  return x.composed(std::asinh(x.value), first, -x.value * first / square);
}

inline Taylor_polynomial_2 acosh(const Taylor_polynomial_2& x)
{
  const double square = x.value * x.value - 1, first = 1 / std::sqrt(square);
  return x.composed(std::acosh(x.value), first, -x.value * first / square);
}

inline Taylor_polynomial_2 atanh(const Taylor_polynomial_2& x)
{
  const double first = 1 / (1 - x.value * x.value);
  return x.composed(std::atanh(x.value), first, 2 * x.value * first * first);
}

inline Taylor_polynomial_2 erf(const Taylor_polynomial_2& x)
{
  const double first = 2 / std::sqrt(4 * std::atan(1.)) * std::exp(-x.value * x.value);
  return x.composed(std::erf(x.value), first, -2 * x.value * first);
}

inline Taylor_polynomial_2 erfc(const Taylor_polynomial_2& x) { return 1 - erf(x); }

// At a base of 0 the derivatives that vanish are 0, not infinity times 0.
template <class Number>
Taylor_polynomial_2::If_number<Number> pow(const Taylor_polynomial_2& x, Number exponent)
{
  const double n = double(exponent);
  return x.composed(std::pow(x.value, n), n == 0 ? 0 : n * std::pow(x.value, n - 1),
                    n == 0 || n == 1 ? 0 : n * (n - 1) * std::pow(x.value, n - 2));
}

inline Taylor_polynomial_2 pow(const Taylor_polynomial_2& x, const Taylor_polynomial_2& y) { return exp(y * log(x)); }

template <class Number>
Taylor_polynomial_2::If_number<Number> pow(Number base, const Taylor_polynomial_2& y)
{
  const double f = std::pow(double(base), y.value), log_of_base = std::log(double(base));
  return y.composed(f, f * log_of_base, f * log_of_base * log_of_base);
}

template <class X, class Y>
If_depend_on_parameters<Taylor_polynomial_2, X, Y> hypot(const X& x, const Y& y)
{
  return sqrt(Taylor_polynomial_2(x * x + y * y));
}

template <class X, class Y, class Z>
If_depend_on_parameters<Taylor_polynomial_2, X, Y, Z> hypot(const X& x, const Y& y, const Z& z)
{
  return sqrt(Taylor_polynomial_2(x * x + y * y + z * z));
}

inline Taylor_polynomial_2 fabs(const Taylor_polynomial_2& x) { return x.value < 0 ? -x : x; }
inline Taylor_polynomial_2 abs(const Taylor_polynomial_2& x) { return fabs(x); }
inline Taylor_polynomial_2 floor(const Taylor_polynomial_2& x) { return std::floor(x.value); }
inline Taylor_polynomial_2 ceil(const Taylor_polynomial_2& x) { return std::ceil(x.value); }
inline Taylor_polynomial_2 round(const Taylor_polynomial_2& x) { return std::round(x.value); }
inline Taylor_polynomial_2 trunc(const Taylor_polynomial_2& x) { return std::trunc(x.value); }

template <class X, class Y>
If_depend_on_parameters<Taylor_polynomial_2, X, Y> fmod(const X& x, const Y& y)
{
  return x - std::trunc(value_of(x) / value_of(y)) * y;
}

template <class X, class Y>
If_depend_on_parameters<Taylor_polynomial_2, X, Y> fmin(const X& x, const Y& y)
{
  return y < x ? Taylor_polynomial_2(y) : Taylor_polynomial_2(x);
}

template <class X, class Y>
If_depend_on_parameters<Taylor_polynomial_2, X, Y> fmax(const X& x, const Y& y)
{
  return x < y ? Taylor_polynomial_2(y) : Taylor_polynomial_2(x);
}

inline bool isfinite(const Taylor_polynomial_2& x) { return std::isfinite(x.value); }
inline bool isnan(const Taylor_polynomial_2& x) { return std::isnan(x.value); }
/// @}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_TAYLOR_POLYNOMIAL_2_H
