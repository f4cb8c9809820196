// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes the faces of a STEP, IGES or BREP file from the command line: see mesh_cad --help.
#include "library/Meshed_cad_file.h"

int main(int argc, char** argv) { return run_mesh_cad(argc, argv); }
