// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef DISTANCE_FINDINGS_H
#define DISTANCE_FINDINGS_H

#include "Mesh_findings.h"

#include <string>

namespace mesh_patch {

// Says that a mesh is farther from the shape than is wanted. A single edge at the minimum length may be a little farther off than that;
// what is much farther off is wrong. `shape`: what it is called; `allowed`: what is wanted, and what the shape is off itself
inline void add_distance(const std::string& shape, double distance, double allowed, Mesh_findings& findings)
{
  const double largest_share = 1.5, rounding = 1e-6;
  const std::string hint = "; a smaller --min-edge or --max-edge would help";
  if(distance > largest_share * allowed)
    findings.faults.push_back("the mesh is much farther from the " + shape + " than allowed" + hint);
  else if(distance > (1 + rounding) * allowed)
    findings.notes.push_back("the mesh is a little farther from the " + shape + " than allowed" + hint);
}

} // namespace mesh_patch

#endif // DISTANCE_FINDINGS_H
