// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes a sample surface or a file of Bezier patches from the command line: see mesh_patch --help.
#include "Mesh_patch_input.h"
#include "Mesh_patch_options.h"
#include "Mesh_patch_output.h"
#include "Mesh_patch_result.h"
#include "print_version.h"

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <string>

namespace {

// returns the exit status
int run(const Mesh_patch_options& options)
{
  const Mesh_patch_input input = mesh_patch::read_input(options);
  Mesh_patch_result result;
  const Output_files files = mesh_patch::output_files(options, input, result);
  mesh_patch::mesh_and_measure(input, options, result);
  files.write();
  if(!options.is_quiet)
    mesh_patch::print_summary(std::cout, input, result);
  return mesh_patch::findings(input, result).faults.empty() ? 0 : 1;
}

int fail(std::string message)
{
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "mesh_patch: " << message << "\n";
  return 2;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    const Mesh_patch_options options = read_mesh_patch_options(argc, argv);
    if(options.is_help_wanted)
      mesh_patch::print_help(std::cout);
    else if(options.is_version_wanted)
      print_version(std::cout, "mesh_patch");
    else
      return run(options);
    return 0;
  }
  catch(const std::bad_alloc&) {
    return fail("the memory is too small for this mesh; choose a larger --max-edge or --gamma");
  }
  catch(const std::exception& error) {
    return fail(error.what());
  }
}
