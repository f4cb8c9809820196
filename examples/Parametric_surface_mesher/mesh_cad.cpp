// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes the faces of a STEP, IGES or BREP file from the command line: see mesh_cad --help.
#include "Mesh_cad_intersections.h"
#include "Mesh_cad_options.h"
#include "Mesh_cad_output.h"
#include "Mesh_cad_result.h"

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <string>

namespace {

// A single edge at the minimum length may be a little farther off than the distance allows; the summary says so. What is farther off is an error.
const double largest_share_of_distance = 1.5;

// Whether the mesh is one of all that the file has, and of what was asked for.
bool is_whole(const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  const bool is_part_wanted = !options.faces.empty() || !options.part_lists.empty();
  return result.left_out.empty() && result.file_faults.empty() && result.number_of_lost_faces == 0
         && (is_part_wanted || result.quality.is_closed || !result.shape.is_shape_closed) && !mesh_cad::intersects_itself(result)
         && !(mesh_cad::share_of_allowed_distance(result) > largest_share_of_distance);
}

// returns the exit status
int run(const Mesh_cad_options& options)
{
  if(options.is_list_wanted) {
    mesh_cad::list_parts(std::cout, options);
    return 0;
  }
  Mesh_cad_result result;
  const Output_files files = mesh_cad::output_files(options, result);
  mesh_cad::mesh_and_measure(options, result);
  files.write();
  if(!options.is_quiet)
    mesh_cad::print_summary(std::cout, options, result);
  return is_whole(options, result) ? 0 : 1;
}

int fail(std::string message)
{
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "mesh_cad: " << message << "\n";
  return 2;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    const Mesh_cad_options options = read_mesh_cad_options(argc, argv);
    if(!options.is_help_wanted)
      return run(options);
    mesh_cad::print_help(std::cout);
    return 0;
  }
  catch(const std::bad_alloc&) {
    return fail("the memory is too small for this mesh; choose a larger --max-edge or --min-edge");
  }
  catch(const std::exception& error) {
    return fail(error.what());
  }
}
