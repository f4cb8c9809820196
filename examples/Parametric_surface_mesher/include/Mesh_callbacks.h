// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MESH_CALLBACKS_H
#define MESH_CALLBACKS_H

#include <cstddef>
#include <functional>

// What a program that uses the mesher as a library is asked and told. Empty functions are not called. With threads they are
// called by one thread at a time, but for `size`.
struct Mesh_callbacks
{
  std::function<void(const char* phase)> on_phase;
  std::function<void(std::size_t number_of_vertices, std::size_t number_of_bad_faces)> on_progress;
  std::function<bool()> go_further; // false stops meshing, with a valid mesh; asked every few milliseconds
  std::function<double(double x, double y, double z)> size; // the wanted edge length at a point
};

#endif // MESH_CALLBACKS_H
