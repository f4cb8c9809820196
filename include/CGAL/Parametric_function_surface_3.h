// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_FUNCTION_SURFACE_3_H
#define CGAL_PARAMETRIC_FUNCTION_SURFACE_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesher/internal/surfaces/Taylor_polynomial_2.h>
#include <CGAL/Surface_jet_3.h>

#include <CGAL/Default.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

the three coordinates that the function of a `Parametric_function_surface_3` returns. Constants may be plain numbers:
`parametric_surface_point(u, 0, v * v)`.
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

template <std::size_t i, class Coordinates, std::enable_if_t<Is_indexable<Coordinates>::value, int> = 0>
auto coordinate(const Coordinates& coordinates)
{
  return coordinates[i];
}

template <std::size_t i, class Coordinates,
          std::enable_if_t<!Is_indexable<Coordinates>::value && (i < std::tuple_size<Coordinates>::value), int> = 0>
auto coordinate(const Coordinates& coordinates)
{
  return std::get<i>(coordinates);
}

template <class Coordinates, class = void>
struct Has_three_coordinates : std::false_type {};

template <class Coordinates>
struct Has_three_coordinates<Coordinates, std::void_t<decltype(coordinate<0>(std::declval<const Coordinates&>())),
                                                      decltype(coordinate<2>(std::declval<const Coordinates&>()))>>
  : std::true_type {};

template <class Function, class = void>
struct Has_one_signature : std::is_function<std::remove_pointer_t<Function>> {};

template <class Function>
struct Has_one_signature<Function, std::void_t<decltype(&Function::operator())>> : std::true_type {};

} // namespace internal
} // namespace Parametric_surface_mesher

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

The surface of a function of two variables; the derivatives come from automatic differentiation.

The function is a template in the types of `u` and `v`: a generic lambda. It is called with two `double`s for a
point, and with two numbers that carry derivatives, both of one type, for the jet. So it should declare its intermediate
values `auto`, and make the standard functions visible by `using std::exp;` and the like. Available functions are `sqrt`,
`cbrt`, `pow`, `hypot`, `exp`, `exp2`, `expm1`, `log`, `log1p`, `log2`, `log10`, `sin`, `cos`, `tan`, `asin`, `acos`, `atan`,
`atan2`, `sinh`, `cosh`, `tanh`, `asinh`, `acosh`, `atanh`, `erf`, `erfc`, `abs`, `fabs`, `floor`, `ceil`, `round`, `trunc`,
`fmod`, `fmin`, `fmax`, and comparisons. Code that would turn such a number into a `double` does not compile.

\code
auto peak = CGAL::make_parametric_function_surface([](auto u, auto v) {
  using std::exp;
  return CGAL::parametric_surface_point(u, v, 0.8 * exp(-(u * u + v * v) / 0.0288));
});
\endcode

The return type may be any type of three coordinates with an `operator[]` or `std::get()`, for instance
`std::array{x, y, z}` if all three depend on `u` or `v`.

Automatic differentiation is exact up to rounding, and costs three to four times as much as the point alone.
`Parametric_jet_surface_3` takes derivatives that are worked out by hand.

\tparam Function a callable `f(u, v)` as described above. It must be copyable, and its call operator `const`
\tparam Kernel a model of `Kernel` with `double` as number type

\cgalModels{ParametricSurface_3}

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
  typedef Parametric_surface_mesher::internal::Taylor_polynomial_2 Number;

  static_assert(std::is_same<typename Kernel::FT, double>::value,
                "The kernel of a parametric surface must have 'double' as its number type FT.");
  static constexpr bool is_generic = !Parametric_surface_mesher::internal::Has_one_signature<Function>::value;
  static_assert(is_generic, "The function of a parametric surface must be generic, as '[](auto u, auto v) {...}' is: it is "
                            "called with numbers that carry derivatives, too.");

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
    constexpr bool has_three = internal::Has_three_coordinates<std::decay_t<decltype(s)>>::value;
    static_assert(has_three, "The function of a parametric surface must return three coordinates, for instance by "
                             "CGAL::parametric_surface_point(x, y, z).");
    if constexpr(has_three)
      return Point_3(internal::coordinate<0>(s), internal::coordinate<1>(s), internal::coordinate<2>(s));
    else
      return Point_3(ORIGIN);
  }

  /// `S(u,v)` with all partial derivatives up to second order.
  Surface_jet_3<Kernel> jet(double u, double v) const
  {
    const Coordinates s = coordinates(u, v);
    const Number &x = s[0], &y = s[1], &z = s[2];
    // the same bits as from point(), which the rounding of the differentiated function need not give
    return { point(u, v), Vector_3(x.du, y.du, z.du), Vector_3(x.dv, y.dv, z.dv), Vector_3(x.duu, y.duu, z.duu),
             Vector_3(x.duv, y.duv, z.duv), Vector_3(x.dvv, y.dvv, z.dvv) };
  }

private:
  typedef std::array<Number, 3> Coordinates;

  Coordinates coordinates(double u, double v) const
  {
    namespace internal = Parametric_surface_mesher::internal;
    if constexpr(is_generic) {
      const auto s = m_function(Number::first_variable(u), Number::second_variable(v));
      if constexpr(internal::Has_three_coordinates<std::decay_t<decltype(s)>>::value) {
        static_assert(internal::Depend_on_parameters<decltype(internal::coordinate<0>(s)), decltype(internal::coordinate<1>(s)),
                                                     decltype(internal::coordinate<2>(s))>::value,
                      "The function of a parametric surface must return coordinates that depend on its parameters, or numbers: "
                      "those that it returns are all plain numbers, or of another type.");
        return {internal::coordinate<0>(s), internal::coordinate<1>(s), internal::coordinate<2>(s)};
      }
    }
    return {};
  }
};

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

The surface of a function that returns its derivatives itself.

\tparam Jet_function a callable that returns a `Surface_jet_3<Kernel>` for two `double`s
\tparam Kernel a model of `Kernel` with `double` as number type
\tparam Point_function a callable that returns a `Kernel::Point_3` for two `double`s, cheaper than the jet.
                       It must return the same point as the jet. By default the point is taken from the jet

\cgalModels{ParametricSurface_3}

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
