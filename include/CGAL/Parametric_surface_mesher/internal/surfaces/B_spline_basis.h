// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_B_SPLINE_BASIS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_B_SPLINE_BASIS_H

#include <CGAL/Parametric_surface_mesh_error.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Bounds the arrays on the stack of an evaluation. Open CASCADE has the same limit.
constexpr int max_degree = 25;

// The degree + 1 basis functions that do not vanish on an interval, at one parameter value.
struct Basis_functions
{
  double value[max_degree + 1];
};

// These functions with their first and second derivatives.
struct Basis_function_jets
{
  double value[max_degree + 1], first[max_degree + 1], second[max_degree + 1];
};

// A parameter value `t` and the knots around its interval.
class Knot_interval
{
  const double* m_knot; // the last knot before the interval
  double m_t;

public:
  Knot_interval(const double* knot, double t) : m_knot(knot), m_t(t) {}

  // The length of the support of function `r` of degree `d` on the interval.
  double support_length(int d, int r) const { return m_knot[r + 1] - m_knot[r - d]; }
  double rest_of_support(int r) const { return m_knot[r + 1] - m_t; }
};

// The interval between the knots 0 and 1 of full multiplicity, whose B-splines are the Bernstein polynomials.
class Unit_interval
{
  double m_t;

public:
  explicit Unit_interval(double t) : m_t(t) {}

  double support_length(int, int) const { return 1; }
  double rest_of_support(int) const { return 1 - m_t; }
};

// Turns the values of the functions of degree `d - 1` into those of degree `d`: the recurrence of Cox and de Boor.
// At the ends of the interval the factors are exactly 0 and 1.
template <class Interval>
void raise_degree(const Interval& interval, int d, double* value)
{
  double carry = 0;
  for(int r = 0; r < d; ++r) {
    const double falling = interval.rest_of_support(r) / interval.support_length(d - 1, r);
    const double from_r = value[r];
    value[r] = carry + falling * from_r;
    carry = (1 - falling) * from_r;
  }
  value[d] = carry;
}

// Turns the functions of degree `d - 1`, or a derivative of them, into the next derivative of those of degree `d`.
// `value` and `derivative` may be the same array.
template <class Interval>
void differentiate(const Interval& interval, int d, const double* value, double* derivative)
{
  double carry = 0;
  for(int r = 0; r < d; ++r) {
    const double slope = d * value[r] / interval.support_length(d - 1, r);
    derivative[r] = carry - slope;
    carry = slope;
  }
  derivative[d] = carry;
}

template <class Interval>
void evaluate_basis(const Interval& interval, int degree, Basis_functions& basis)
{
  basis.value[0] = 1;
  for(int d = 1; d <= degree; ++d)
    raise_degree(interval, d, basis.value);
}

template <class Interval>
void evaluate_basis(const Interval& interval, int degree, Basis_function_jets& basis)
{
  basis.value[0] = 1;
  for(int d = 1; d <= degree - 2; ++d)
    raise_degree(interval, d, basis.value);
  if(degree == 1) {
    basis.second[0] = basis.second[1] = 0;
  } else {
    differentiate(interval, degree - 1, basis.value, basis.second);
    raise_degree(interval, degree - 1, basis.value);
    differentiate(interval, degree, basis.second, basis.second);
  }
  differentiate(interval, degree, basis.value, basis.first);
  raise_degree(interval, degree, basis.value);
}

inline void check_degree(const std::string& place, int degree)
{
  if(degree >= 1 && degree <= max_degree)
    return;
  std::ostringstream message;
  message << place << ": expected a degree from 1 to " << max_degree << ", found " << degree;
  throw Parametric_surface_mesh_error(message.str());
}

// A knot vector, checked, with each knot as often as its multiplicity.
class Knot_vector
{
  int m_degree;
  std::vector<double> m_knots;
  std::size_t m_first, m_last; // the knots before the first and the last interval that is not empty

public:
  Knot_vector(const std::string& place, int degree, std::vector<double> knots)
    : m_degree(degree), m_knots(std::move(knots))
  {
    check_degree(place, degree);
    check_order(place);
    m_first = std::upper_bound(m_knots.begin(), m_knots.end(), min()) - m_knots.begin() - 1;
    m_last = std::lower_bound(m_knots.begin(), m_knots.end(), max()) - m_knots.begin() - 1;
    check_multiplicities(place);
  }

  int degree() const { return m_degree; }
  const std::vector<double>& knots() const { return m_knots; }
  int number_of_functions() const { return int(m_knots.size()) - m_degree - 1; }

  // The ends of the range on which the basis functions sum to 1.
  double min() const { return m_knots[m_degree]; }
  double max() const { return m_knots[number_of_functions()]; }

  // The interval that contains `t`, or the nearest one, and the index of the first function that does not vanish there.
  std::pair<Knot_interval, int> locate(double t) const
  {
    const double* knots = m_knots.data();
    const double* after = std::upper_bound(knots + m_first + 1, knots + m_last + 1, t);
    return { Knot_interval(after - 1, t), int(after - 1 - knots) - m_degree };
  }

private:
  void check_order(const std::string& place) const
  {
    if(m_knots.size() < 2 * std::size_t(m_degree + 1))
      refuse(place, "at least 2 (degree + 1) knots", "degree", m_degree, "number of knots", double(m_knots.size()));
    for(std::size_t i = 0; i < m_knots.size(); ++i) {
      if(!std::isfinite(m_knots[i]))
        refuse(place, "finite knots", "index", double(i), "knot", m_knots[i]);
      if(i > 0 && m_knots[i] < m_knots[i - 1])
        refuse(place, "nondecreasing knots", "knot", m_knots[i - 1], "followed by", m_knots[i]);
    }
    if(min() == max())
      refuse(place, "a knot range that is not empty", "first", min(), "last", max());
  }

  // A surface has a gap at an inner knot of multiplicity degree + 1; with a higher multiplicity, a function vanishes everywhere.
  void check_multiplicities(const std::string& place) const
  {
    for(auto it = m_knots.begin(); it != m_knots.end();) {
      const auto next = std::upper_bound(it, m_knots.end(), *it);
      const bool inside = *it > min() && *it < max();
      const int bound = inside ? m_degree : m_degree + 1;
      if(next - it > bound)
        refuse(place, inside ? "inner knots of multiplicity at most the degree"
                             : "knots of multiplicity at most degree + 1",
               "knot", *it, "multiplicity", double(next - it));
      it = next;
    }
  }

  [[noreturn]] static void refuse(const std::string& place, const char* expected,
                                  const char* what, double value, const char* other, double other_value)
  {
    std::ostringstream message;
    message.precision(17);
    message << place << ": expected " << expected << ", found " << what << ' ' << value
            << ", " << other << ' ' << other_value;
    throw Parametric_surface_mesh_error(message.str());
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_B_SPLINE_BASIS_H
