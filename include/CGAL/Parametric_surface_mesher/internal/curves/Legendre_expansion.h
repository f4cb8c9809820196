// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURVES_LEGENDRE_EXPANSION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURVES_LEGENDRE_EXPANSION_H

#include <Eigen/Core>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/legendre.hpp>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A function on [-1,1] as a sum of Legendre polynomials, found by projection with Gauss quadrature, and its integral.
class Legendre_expansion
{
  static constexpr int number_of_nodes = 15;
  typedef Eigen::Matrix<double, number_of_nodes, 1> Values;

  Values m_coefficients;
  int m_degree = 0; // coefficients above are rounding noise

public:
  // Evaluates `function(x)` at the 15 nodes.
  template <class Function>
  explicit Legendre_expansion(const Function& function)
  {
    const Projection& projection = Legendre_expansion::projection();
    Values values;
    for(int i = 0; i < number_of_nodes; ++i)
      values[i] = function(projection.nodes[i]);
    m_coefficients = projection.matrix * values;
    for(int k = 1; k < number_of_nodes; ++k)
      if(!(std::fabs(m_coefficients[k]) <= 1e-14 * std::fabs(m_coefficients[0])))
        m_degree = k;
  }

  // Whether the last coefficients are small compared with the first one.
  bool has_converged(double tolerance) const
  {
    return m_coefficients.tail<3>().lpNorm<1>() <= tolerance * std::fabs(m_coefficients[0]);
  }

  bool is_constant() const { return m_degree == 0; }

  double value(double x) const
  {
    double sum = m_coefficients[0], previous = 1, current = x;
    for(int k = 1; k <= m_degree; ++k) {
      sum += m_coefficients[k] * current;
      const double next = boost::math::legendre_next(unsigned(k), x, current, previous);
      previous = current;
      current = next;
    }
    return sum;
  }

  // The integral from -1 to `x`.
  double integral(double x) const
  {
    double sum = m_coefficients[0] * (x + 1), previous = 1, current = x;
    for(int k = 1; k <= m_degree; ++k) {
      const double next = boost::math::legendre_next(unsigned(k), x, current, previous);
      sum += m_coefficients[k] * (next - previous) / (2 * k + 1);
      previous = current;
      current = next;
    }
    return sum;
  }

private:
  struct Projection
  {
    Values nodes;
    Eigen::Matrix<double, number_of_nodes, number_of_nodes> matrix; // maps values at the nodes to coefficients
  };

  static const Projection& projection()
  {
    static const Projection result = [] {
      typedef boost::math::quadrature::gauss<double, number_of_nodes> Gauss; // has the nodes from 0 to 1
      const int last = number_of_nodes - 1;
      Projection p;
      for(int i = 0; i < number_of_nodes; ++i) {
        const auto mirrored = std::size_t(i < last - i ? last / 2 - i : i - last / 2);
        p.nodes[i] = i < last - i ? -Gauss::abscissa()[mirrored] : Gauss::abscissa()[mirrored];
        for(int k = 0; k < number_of_nodes; ++k)
          p.matrix(k, i) = (k + 0.5) * Gauss::weights()[mirrored] * boost::math::legendre_p(k, p.nodes[i]);
      }
      return p;
    }();
    return result;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURVES_LEGENDRE_EXPANSION_H
