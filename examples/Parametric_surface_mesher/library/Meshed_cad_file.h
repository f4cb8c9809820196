// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// mesh_cad as a library, without the types of CGAL and Open CASCADE: what uses it compiles fast.
#ifndef MESHED_CAD_FILE_H
#define MESHED_CAD_FILE_H

#include "Mesh_arrays.h"
#include "Mesh_callbacks.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

// The program as a whole; returns its exit status.
int run_mesh_cad(int argc, char** argv);

// The mesh of a CAD file, with all that is known about it. Errors are exceptions derived from std::exception.
class Meshed_cad_file
{
  struct Data;
  std::shared_ptr<const Data> m_data;

public:
  // Meshes a file. `arguments`: the file and the options of mesh_cad, as on its command line
  explicit Meshed_cad_file(const std::vector<std::string>& arguments, const Mesh_callbacks& callbacks = Mesh_callbacks());

  Mesh_arrays arrays() const;
  std::string json() const;    // what --json writes
  std::string summary() const; // what the program prints
  std::string page() const;    // what --page writes
  bool is_whole() const;       // whether the exit status would be 0

  // Writes the mesh, as --out does, into a file whose ending tells the format.
  void save(const std::string& file_name, bool is_binary, bool are_node_parameters_wanted) const;

  // The name and the description of each option.
  static std::vector<std::pair<std::string, std::string>> options();
};

#endif // MESHED_CAD_FILE_H
