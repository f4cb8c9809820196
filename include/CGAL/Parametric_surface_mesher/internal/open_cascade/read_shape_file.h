// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_READ_SHAPE_FILE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_READ_SHAPE_FILE_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Child_process.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/exchange_file_faults.h>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A shape, and a sentence for each kind of thing that its file has and the shape has not.
struct Shape_of_file
{
  TopoDS_Shape shape;
  std::vector<std::string> faults;
};

// The part of a file name after its last dot, in small letters.
inline std::string ending_of(const std::string& file_name)
{
  const std::size_t dot = file_name.find_last_of("./");
  std::string result = dot == std::string::npos || file_name[dot] == '/' ? "" : file_name.substr(dot + 1);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return result;
}

// Sets the unit that lengths are converted to, "MM" for instance, and puts the old one back.
class Exchange_unit
{
  std::string m_old;

public:
  explicit Exchange_unit(const std::string& unit) : m_old(Interface_Static::CVal("xstep.cascade.unit"))
  {
    if(!Interface_Static::SetCVal("xstep.cascade.unit", unit.c_str()))
      throw Parametric_surface_mesh_error("'" + unit + "' is not a unit of length that Open CASCADE knows");
  }
  ~Exchange_unit() { Interface_Static::SetCVal("xstep.cascade.unit", m_old.c_str()); }
};

template <class Reader>
Shape_of_file read_exchange_file(const std::string& file_name, const std::string& unit, const char* format)
{
  Reader reader; // its constructor sets the parameters up, the unit among them
  const Exchange_unit conversion(unit);
  if(reader.ReadFile(file_name.c_str()) != IFSelect_RetDone)
    throw Parametric_surface_mesh_error("cannot read " + file_name + " as " + format);
  reader.TransferRoots();
  return {reader.OneShape(), faults_of_file(reader, file_name)};
}

// A BREP file ends with the number and the place of its shape, after the asterisk that ends the last part of it; from some
// programs with a zero after these. The reader of Open CASCADE never comes back from a file that has lost its end.
inline bool is_whole_brep_file(const std::string& file_name)
{
  const std::streamoff largest_end = 200; // in bytes
  std::ifstream file(file_name, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  file.seekg((std::max)(std::streamoff(0), size - largest_end));
  const std::string end{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::size_t asterisk = end.rfind('*');
  const std::regex shape("\\s*[-+ie]\\d+ \\d+\\s*(0\\s*)?");
  return asterisk != std::string::npos && std::regex_match(end.substr(asterisk + 1), shape);
}

inline Shape_of_file read_brep_file(const std::string& file_name)
{
  if(!is_whole_brep_file(file_name))
    throw Parametric_surface_mesh_error("cannot read " + file_name + " as BREP: its end is missing");
  Shape_of_file result;
  if(!BRepTools::Read(result.shape, file_name.c_str(), BRep_Builder()))
    throw Parametric_surface_mesh_error("cannot read " + file_name + " as BREP");
  return result;
}

// Reads a file in this process. Damaged files let the readers of Open CASCADE crash, or never return.
inline Shape_of_file read_shape_file(const std::string& file_name, const std::string& unit)
{
  const std::string ending = ending_of(file_name);
  return guarded([&]() -> Shape_of_file {
    Shape_of_file result = ending == "brep" || ending == "rle" ? read_brep_file(file_name)
                           : ending == "step" || ending == "stp"
                             ? read_exchange_file<STEPControl_Reader>(file_name, unit, "STEP")
                             : read_exchange_file<IGESControl_Reader>(file_name, unit, "IGES");
    if(result.shape.IsNull())
      throw Parametric_surface_mesh_error(file_name + " contains no shape"
                                          + (result.faults.empty() ? "" : ": " + result.faults.front()));
    return result;
  });
}

#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_HAS_CHILD_PROCESSES

// A file that is there as long as the object.
class Temporary_file
{
  std::string m_name;

public:
  Temporary_file()
  {
    const char* folder = std::getenv("TMPDIR");
    m_name = std::string(folder != nullptr && *folder != '\0' ? folder : "/tmp") + "/shape-XXXXXX";
    const int file = ::mkstemp(&m_name[0]);
    if(file < 0)
      throw Parametric_surface_mesh_error("cannot make a temporary file, " + m_name);
    ::close(file);
  }
  ~Temporary_file() { ::unlink(m_name.c_str()); }
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;

  const std::string& name() const { return m_name; }
};

// Whole files take 0.3 seconds and less a megabyte, and less than a hundred times their size in memory.
inline Process_limits limits_of_reading(const std::string& file_name)
{
  const unsigned int least_seconds = 10, seconds_per_megabyte = 5;
  const double least_bytes = 4e9, bytes_per_byte = 500;
  const double size = double(std::ifstream(file_name, std::ios::binary | std::ios::ate).tellg());
  return {least_seconds + unsigned(seconds_per_megabyte * size / 1e6), least_bytes + bytes_per_byte * size};
}

// Reads a file in a process of its own, which hands the shape over in Open CASCADE's binary format.
inline Shape_of_file read_shape_file_safely(const std::string& file_name, const std::string& unit)
{
  const Process_limits limits = limits_of_reading(file_name);
  const Temporary_file handed_over;
  const Child_process reading(limits, [&]() -> std::string {
    const Shape_of_file read = read_shape_file(file_name, unit);
    std::string faults;
    for(const std::string& fault : read.faults)
      faults += fault + "\n";
    std::ofstream file(handed_over.name(), std::ios::binary);
    guarded([&] { BinTools::Write(read.shape, file); });
    if(!file.flush())
      throw Parametric_surface_mesh_error("cannot write the temporary file " + handed_over.name());
    return faults;
  });
  const Process_end end = reading();
  switch(end.kind) {
  case Process_end::OUT_OF_TIME:
    throw Parametric_surface_mesh_error("cannot read " + file_name + ": Open CASCADE has not finished after "
                                        + std::to_string(limits.seconds) + " seconds; the file is probably damaged");
  case Process_end::CRASHED:
    throw Parametric_surface_mesh_error("cannot read " + file_name + ": Open CASCADE crashed on it (" + end.text
                                        + "); the file is probably damaged");
  case Process_end::FAILED:
    throw Parametric_surface_mesh_error(end.text);
  case Process_end::DONE:
    break;
  }
  Shape_of_file result;
  std::ifstream file(handed_over.name(), std::ios::binary);
  guarded([&] { BinTools::Read(result.shape, file); });
  std::istringstream faults(end.text);
  for(std::string fault; std::getline(faults, fault);)
    result.faults.push_back(fault);
  return result;
}

#else

inline Shape_of_file read_shape_file_safely(const std::string& file_name, const std::string& unit)
{
  return read_shape_file(file_name, unit);
}

#endif

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_READ_SHAPE_FILE_H
