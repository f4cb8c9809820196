// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_FUNCTION_SURFACE_3_H
#define CGAL_PARAMETRIC_FUNCTION_SURFACE_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Surface_jet_3.h>

#include <CGAL/Default.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>

#include <boost/math/differentiation/autodiff.hpp>

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

the three coordinates that the function of a `Parametric_function_surface_3` returns. They may be of different
types, as they are under automatic differentiation, and constants may be plain numbers: `parametric_surface_point(u,
0, v * v)`.
*/
template <class X, class Y, class Z>
std::tuple<X, Y, Z> parametric_surface_point(const X& x, const Y& y, const Z& z)
{
  return std::tuple<X, Y, Z>(x, y, z);
}

namespace Parametric_surface_mesher {
namespace internal {

template <class Coordinates, class = void>
struct Is_indexable : std::false_type {};

template <class Coordinates>
struct Is_indexable<Coordinates, std::void_t<decltype(std::declval<const Coordinates&>()[0])>> : std::true_type {};

template <std::size_t i, class Coordinates>
decltype(auto) coordinate(const Coordinates& coordinates)
{
  if constexpr(Is_indexable<Coordinates>::value)
    return coordinates[i];
  else
    return std::get<i>(coordinates);
}

// The Taylor coefficients of one coordinate function, whatever variables it depends on.
class Taylor_polynomial
{
  typedef boost::math::differentiation::autodiff_fvar<double, 2, 2> Variable;

  Variable m_value;

public:
  template <class T>
  explicit Taylor_polynomial(const T& value) : m_value(value) {}

  // `d^(i+j) / (du^i dv^j)` for `i, j <= 2`. Not Boost's `derivative()`, which copies a table of 171 factorials.
  double derivative(std::size_t i, std::size_t j) const
  {
    return m_value.at(i, j) * (i == 2 ? 2 : 1) * (j == 2 ? 2 : 1);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

The surface of a function of two variables; the derivatives come from the automatic differentiation of Boost.Math.

The function is a template in the types of `u` and `v`: a generic lambda. It is called with two `double`s for a
point, and with two *different* number types of Boost.Math for the derivatives. So it should declare its
intermediate values `auto`, make the standard functions visible by `using std::exp;` and the like, and
return its coordinates by `parametric_surface_point()`, which lets them have different types:

\code
auto peak = CGAL::make_parametric_function_surface([](auto u, auto v) {
  using std::exp;
  return CGAL::parametric_surface_point(u, v, 0.8 * exp(-(u * u + v * v) / 0.0288));
});
\endcode

Anything else that holds three coordinates and has an `operator[]` or `std::get()` will do as return type, such
as `std::array<decltype(u * v), 3>`: the type of `u * v` can hold any expression in `u` and `v`.

Automatic differentiation is exact up to rounding, and slow: about half a microsecond for one or two transcendental
functions. `Parametric_jet_surface_3` takes derivatives worked out by hand.

\tparam Function a callable `f(u, v)` as described above. It must be copyable, and its call operator `const`
\tparam Kernel a model of `Kernel` with `double` as number type

\cgalModels `ParametricSurface_3`

\sa `CGAL::make_parametric_function_surface()`
\sa `CGAL::Parametric_jet_surface_3`
*/
template <class Function, class Kernel = Exact_predicates_inexact_constructions_kernel>
class Parametric_function_surface_3
{
public:
  typedef Kernel Geom_traits;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;

private:
  Function m_function;

public:
  explicit Parametric_function_surface_3(const Function& function = Function()) : m_function(function) {}

  /// the function.
  const Function& function() const { return m_function; }

  /// `S(u,v)`
  Point_3 point(double u, double v) const
  {
    namespace internal = Parametric_surface_mesher::internal;
    const auto s = m_function(u, v);
    return Point_3(internal::coordinate<0>(s), internal::coordinate<1>(s), internal::coordinate<2>(s));
  }

  /// `S(u,v)` with all partial derivatives up to second order.
  Surface_jet_3<Kernel> jet(double u, double v) const
  {
    namespace internal = Parametric_surface_mesher::internal;
    const auto variables = boost::math::differentiation::make_ftuple<double, 2, 2>(u, v);
    const auto s = m_function(std::get<0>(variables), std::get<1>(variables));
    const internal::Taylor_polynomial x(internal::coordinate<0>(s)),
                                      y(internal::coordinate<1>(s)),
                                      z(internal::coordinate<2>(s));
    const auto derivative = [&](std::size_t i, std::size_t j)
    {
      return Vector_3(x.derivative(i, j), y.derivative(i, j), z.derivative(i, j));
    };
    // the same bits as from point(), which the rounding of the differentiated function need not give
    return { point(u, v),
             derivative(1, 0), derivative(0, 1), derivative(2, 0), derivative(1, 1), derivative(0, 2) };
  }
};

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

The surface of a function that returns its derivatives itself.

\tparam Jet_function a callable that returns a `Surface_jet_3<Kernel>` for two `double`s
\tparam Kernel a model of `Kernel` with `double` as number type
\tparam Point_function a callable that returns a `Kernel::Point_3` for two `double`s, cheaper than the jet.
                       It must return the same point as the jet. By default the point is taken from the jet

\cgalModels `ParametricSurface_3`

\sa `CGAL::make_parametric_jet_surface()`
*/
template <class Jet_function,
          class Kernel = Exact_predicates_inexact_constructions_kernel,
          class Point_function = Default>
class Parametric_jet_surface_3
{
public:
  typedef Kernel Geom_traits;
  typedef typename Kernel::Point_3 Point_3;

private:
  Jet_function m_jet_function;
  Point_function m_point_function;

public:
  explicit Parametric_jet_surface_3(const Jet_function& jet_function = Jet_function(),
                                    const Point_function& point_function = Point_function())
    : m_jet_function(jet_function), m_point_function(point_function)
  {}

  /// `S(u,v)`
  Point_3 point(double u, double v) const
  {
    if constexpr(std::is_same<Point_function, Default>::value)
      return m_jet_function(u, v).point;
    else
      return m_point_function(u, v);
  }

  /// `S(u,v)` with all partial derivatives up to second order.
  Surface_jet_3<Kernel> jet(double u, double v) const { return m_jet_function(u, v); }
};

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

returns the surface of `function`, differentiated automatically.
See `Parametric_function_surface_3` for how to write the function.

\tparam Kernel a model of `Kernel` with `double` as number type
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel, class Function>
Parametric_function_surface_3<Function, Kernel> make_parametric_function_surface(Function function)
{
  return Parametric_function_surface_3<Function, Kernel>(function);
}

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

returns the surface of `jet_function`, which maps two `double`s to a `Surface_jet_3`. The kernel is that of the jet.
`point_function`, if given, returns the point alone, at less cost.
*/
template <class Jet_function, class Point_function = Default>
auto make_parametric_jet_surface(Jet_function jet_function, Point_function point_function = Point_function())
{
  typedef decltype(jet_function(0., 0.).point) Point_3;
  typedef typename Kernel_traits<Point_3>::Kernel Kernel;
  return Parametric_jet_surface_3<Jet_function, Kernel, Point_function>(jet_function, point_function);
}

} // namespace CGAL

#endif // CGAL_PARAMETRIC_FUNCTION_SURFACE_3_H
