// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_FUZZ_RANDOM_H
#define PARAMETRIC_SURFACE_MESHER_TEST_FUZZ_RANDOM_H

#include <random_input.h>

#include <cmath>
#include <cstdint>

// The choices that the fuzz test makes.
class Fuzz_random : public Random_input
{
public:
  explicit Fuzz_random(std::uint64_t seed) : Random_input(seed) {}

  bool chance(double probability) { return real(0, 1) < probability; }

  // a number whose logarithm is spread evenly
  double magnitude(double low, double high) { return low * std::pow(high / low, real(0, 1)); }
};

#endif // PARAMETRIC_SURFACE_MESHER_TEST_FUZZ_RANDOM_H
