// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_READ_NODE_VALUES_H
#define CGAL_IO_READ_NODE_VALUES_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Node_values_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Medit_reader.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Msh_reader.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Vtu_reader.h>
#include <CGAL/Parametric_surface_mesher/internal/support/ending_of.h>

#include <string>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgParametricSurfaceMesherSizing

reads scalar values at the nodes of a mesh, such as the edge lengths that an error estimate of a solver asks for:
- point data of an unstructured grid of VTK, `.vtu`: as text, binary, or appended; compressed by zlib, if
`CGAL_LINKED_WITH_BOOST_IOSTREAMS` is defined (link with the target `CGAL::Boost_iostreams_support`);
- node data of an ASCII file of Gmsh, `.msh`, of version 2.2 or 4.1; the last of several steps;
- an ASCII file `.mesh` of Medit, with its values in a file `.sol` of the same name beside it; either name may be given.

Of elements of higher order the corners count; quadrilaterals are divided into two triangles; points and lines are left out.

\param file_name the file; the ending tells the format
\param name the name of the values, if there are several scalar ones

\throws Parametric_surface_mesh_error if the file cannot be read, has elements of other kinds, or has no such values
*/
inline Node_values_3 read_node_values(const std::string& file_name, const std::string& name = std::string())
{
  using namespace Parametric_surface_mesher::internal;
  const std::string ending = ending_of(file_name);
  if(ending == "vtu")
    return Vtu_reader(file_name).read(name);
  if(ending == "msh")
    return Msh_reader(file_name).read(name);
  if(ending != "mesh" && ending != "sol")
    throw_file_error(file_name, "the name of a file with values at nodes must end in .vtu, .msh, .mesh or .sol");
  if(!name.empty())
    throw_file_error(file_name, "values of Medit have no names");
  const std::string stem = file_name.substr(0, file_name.size() - ending.size());
  return read_medit(ending == "mesh" ? file_name : stem + "mesh", ending == "sol" ? file_name : stem + "sol");
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_READ_NODE_VALUES_H
