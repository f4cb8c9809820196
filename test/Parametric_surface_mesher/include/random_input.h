// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_RANDOM_INPUT_H
#define PARAMETRIC_SURFACE_MESHER_TEST_RANDOM_INPUT_H

#include <CGAL/Metric_tensor_2.h>

#include <cmath>
#include <cstdint>
#include <random>

// Random numbers that are the same with every standard library: its distributions are not.
class Random_input
{
  std::mt19937_64 m_engine;

public:
  explicit Random_input(std::uint64_t seed) : m_engine(seed) {}

  // a number in [0, n)
  std::uint64_t integer(std::uint64_t n) { return m_engine() % n; }

  // a number in [low, high]
  int integer(int low, int high)
  {
    return low + static_cast<int>(integer(static_cast<std::uint64_t>(high - low + 1)));
  }

  // a number in [low, high)
  double real(double low, double high)
  {
    return low + (high - low) * std::ldexp(static_cast<double>(m_engine() >> 11), -53);
  }

  // a multiple of 2^-bits in [-1, 1)
  double dyadic(int bits)
  {
    const std::uint64_t n = std::uint64_t(1) << bits;
    return std::ldexp(static_cast<double>(integer(2 * n)) - static_cast<double>(n), -bits);
  }

  // positive definite, with a ratio of the half axes of its ellipses of up to 10^decades
  CGAL::Metric_tensor_2 tensor(double decades)
  {
    const double alpha = real(-2, 2);
    const double k = std::pow(10., real(0, decades));
    return real(0.1, 10) * CGAL::Metric_tensor_2::from_ellipse(alpha, k);
  }
};

#endif // PARAMETRIC_SURFACE_MESHER_TEST_RANDOM_INPUT_H
