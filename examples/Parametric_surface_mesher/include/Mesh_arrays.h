// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MESH_ARRAYS_H
#define MESH_ARRAYS_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

// A mesh as plain arrays, for programs that do not know the types of CGAL and Open CASCADE.
struct Mesh_arrays
{
  // What is called by one name: 0 vertices, 1 edges, 2 faces or 3 parts, by their numbers from 1.
  struct Group
  {
    std::string name;
    int dimension;
    std::vector<std::size_t> numbers;
  };

  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles; // counterclockwise seen from outside
  std::vector<std::size_t> face_ids, part_ids;       // of the triangles, from 1; part 0 for none
  std::vector<std::array<double, 6>> uv;             // of the corners of the triangles, in the domains of their faces
  std::vector<std::array<std::size_t, 2>> edges;     // those edges of the mesh that lie on edges of the model
  std::vector<std::size_t> edge_ids;                 // of these, from 1
  std::vector<Group> groups;
};

#endif // MESH_ARRAYS_H
