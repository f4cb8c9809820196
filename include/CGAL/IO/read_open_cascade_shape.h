// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_READ_OPEN_CASCADE_SHAPE_H
#define CGAL_IO_READ_OPEN_CASCADE_SHAPE_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Open_cascade_names_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/read_shape_file.h>

#include <TopoDS_Shape.hxx>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

reads a shape from a STEP (`.step`, `.stp`), IGES (`.iges`, `.igs`) or BREP file (`.brep`, `.rle`). The ending may be in capitals.

On POSIX systems the file is read in a process of its own: if Open CASCADE crashes on a damaged file, or does not end, this
function throws an exception. The limit of the processor time is 10 seconds and 5 more for each megabyte.

\param file_name the name of the file
\param unit the unit of length of the result. Lengths in STEP and IGES files are converted from the unit of the file; a BREP
            file has no unit, and its lengths are not changed. Tolerances of Open CASCADE are absolute: a shape whose lengths are
            far below 1 loses faces. Read it in millimetres, and scale the mesh.
\param faults takes a sentence for each kind of thing that is in the file but not in the shape: faces that could not be read,
              damaged loops, a missing end. It is empty for a file that was read completely.
\param names takes the parts of the assembly, and names, colours, layers and materials, as far as the file tells of them. A BREP
             file tells of none, and its parts are its bodies with their numbers. If names cannot be read, so are those of other files;
             `Open_cascade_names_3::faults` tells why.

\throws Parametric_surface_mesh_error if the file cannot be read or contains no shape
*/
inline TopoDS_Shape read_open_cascade_shape(const std::string& file_name, const std::string& unit, std::vector<std::string>& faults,
                                            Open_cascade_names_3& names)
{
  using namespace Parametric_surface_mesher::internal;
  errno = 0;
  if(!std::ifstream(file_name))
    throw Parametric_surface_mesh_error("cannot open " + file_name + (errno != 0 ? std::string(": ") + std::strerror(errno) : ""));
  if(std::filesystem::is_directory(file_name))
    throw Parametric_surface_mesh_error(file_name + " is a folder, not a file");
  const std::string ending = ending_of(file_name);
  if(ending != "brep" && ending != "rle" && ending != "step" && ending != "stp" && ending != "iges" && ending != "igs")
    throw Parametric_surface_mesh_error(file_name + ": expected a file that ends in .step, .stp, .iges, .igs, .brep or .rle");
  Shape_of_file result = read_shape_file_safely(file_name, unit);
  faults = std::move(result.faults);
  names = std::move(result.names);
  return result.shape;
}

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

reads a shape as above, without its names.
*/
inline TopoDS_Shape read_open_cascade_shape(const std::string& file_name, const std::string& unit, std::vector<std::string>& faults)
{
  Open_cascade_names_3 names;
  return read_open_cascade_shape(file_name, unit, faults, names);
}

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

reads a shape as above, and throws an exception if anything of the file could not be read.

\throws Parametric_surface_mesh_error if the file cannot be read, contains no shape, or something of it could not be read
*/
inline TopoDS_Shape read_open_cascade_shape(const std::string& file_name, const std::string& unit = "MM")
{
  std::vector<std::string> faults;
  const TopoDS_Shape result = read_open_cascade_shape(file_name, unit, faults);
  if(!faults.empty())
    throw Parametric_surface_mesh_error(file_name + ": " + faults.front());
  return result;
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_READ_OPEN_CASCADE_SHAPE_H
