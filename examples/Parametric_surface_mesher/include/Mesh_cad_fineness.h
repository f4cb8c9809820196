// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sizes as engineers say them: three presets, and elements per turn.
#ifndef MESH_CAD_FINENESS_H
#define MESH_CAD_FINENESS_H

#include "Usage_error.h"

#include <cmath>
#include <string>

namespace mesh_cad {

// What the sizes are where no option gives them.
struct Fineness
{
  const char* name;
  double max_edge; // as a share of the diagonal
  double gamma, relative_distance, growth;
};

// Measured: with `coarse` CAD models have about as many triangles as Netgen gives them with its preset "moderate".
inline const Fineness& fineness_called(const std::string& name)
{
  static const Fineness presets[] = {{"coarse", 1. / 20, 0.08, 2e-3, 0.2}, {"normal", 1. / 20, 0.05, 5e-4, 0}, {"fine", 1. / 40, 0.03, 1.25e-4, 0}};
  for(const Fineness& preset : presets)
    if(name == preset.name)
      return preset;
  throw Usage_error("--fineness: '" + name + "' must be coarse, normal or fine");
}

// The deviation ratio of chords that divide a circle into so many pieces.
inline double gamma_of_elements_per_turn(double number)
{
  return 0.5 * std::tan(std::acos(-1.) / (2 * number));
}

} // namespace mesh_cad

#endif // MESH_CAD_FINENESS_H
