// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_READ_OPEN_CASCADE_SHAPE_H
#define CGAL_IO_READ_OPEN_CASCADE_SHAPE_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string>

namespace CGAL {

namespace Parametric_surface_mesher {
namespace internal {

// The part of a file name after its last dot, in small letters.
inline std::string ending_of(const std::string& file_name)
{
  const std::size_t dot = file_name.find_last_of("./");
  std::string result = dot == std::string::npos || file_name[dot] == '/' ? "" : file_name.substr(dot + 1);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return result;
}

template <class Reader>
TopoDS_Shape read_exchange_file(const std::string& file_name, const char* format)
{
  Reader reader;
  if(reader.ReadFile(file_name.c_str()) != IFSelect_RetDone)
    throw Parametric_surface_mesh_error(file_name + " is no " + format + " file that Open CASCADE can read");
  reader.TransferRoots();
  return reader.OneShape();
}

inline TopoDS_Shape read_brep_file(const std::string& file_name)
{
  TopoDS_Shape shape;
  if(!BRepTools::Read(shape, file_name.c_str(), BRep_Builder()))
    throw Parametric_surface_mesh_error(file_name + " is no BREP file that Open CASCADE can read");
  return shape;
}

// Sets the unit that lengths are converted to, "MM" for instance, and puts the old one back.
class Exchange_unit
{
  std::string m_old;

public:
  explicit Exchange_unit(const std::string& unit) : m_old(Interface_Static::CVal("xstep.cascade.unit"))
  {
    if(!Interface_Static::SetCVal("xstep.cascade.unit", unit.c_str()))
      throw Parametric_surface_mesh_error("'" + unit + "' is no unit of length that Open CASCADE knows");
  }
  ~Exchange_unit() { Interface_Static::SetCVal("xstep.cascade.unit", m_old.c_str()); }
};

} // namespace internal
} // namespace Parametric_surface_mesher

namespace IO {

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

reads a shape from a STEP (`.step`, `.stp`), IGES (`.iges`, `.igs`) or BREP file (`.brep`, `.rle`); capitals do as well.

\param file_name the name of the file
\param unit the unit of length of the result: STEP and IGES files name theirs, and lengths are converted. A BREP file has
            no unit and is taken as it is.

\throws Parametric_surface_mesh_error if the file cannot be read or contains no shape
*/
inline TopoDS_Shape read_open_cascade_shape(const std::string& file_name, const std::string& unit = "MM")
{
  using namespace Parametric_surface_mesher::internal;
  if(!std::ifstream(file_name))
    throw Parametric_surface_mesh_error("cannot open " + file_name);
  const std::string ending = ending_of(file_name);
  return guarded([&] {
    TopoDS_Shape shape;
    if(ending == "brep" || ending == "rle")
      shape = read_brep_file(file_name);
    else if(ending == "step" || ending == "stp") {
      STEPControl_Reader initialize_parameters;
      const Exchange_unit conversion(unit);
      shape = read_exchange_file<STEPControl_Reader>(file_name, "STEP");
    }
    else if(ending == "iges" || ending == "igs") {
      IGESControl_Reader initialize_parameters;
      const Exchange_unit conversion(unit);
      shape = read_exchange_file<IGESControl_Reader>(file_name, "IGES");
    }
    else
      throw Parametric_surface_mesh_error(file_name + ": expected a file that ends in .step, .stp, .iges, .igs, .brep or .rle");
    if(shape.IsNull())
      throw Parametric_surface_mesh_error(file_name + " contains no shape");
    return shape;
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_READ_OPEN_CASCADE_SHAPE_H
