// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_READ_SHAPE_FILE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_READ_SHAPE_FILE_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Open_cascade_names_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Child_process.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Part_builder.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Text_archive.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/exchange_file_faults.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/names_of_exchange_file.h>
#include <CGAL/Parametric_surface_mesher/internal/support/ending_of.h>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A shape, a sentence for each kind of thing that its file has and the shape has not, and the names of what it consists of.
struct Shape_of_file
{
  TopoDS_Shape shape;
  std::vector<std::string> faults;
  Open_cascade_names_3 names;
};

// A file name without folders and ending.
inline std::string stem_of(const std::string& file_name)
{
  const std::size_t slash = file_name.find_last_of('/'), begin = slash == std::string::npos ? 0 : slash + 1;
  return file_name.substr(begin, file_name.find_last_of('.') - begin);
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

// Completes what was read, once there is a shape: bodies have their numbers for names.
inline void check_shape(const std::string& file_name, Shape_of_file& read)
{
  if(read.shape.IsNull())
    throw Parametric_surface_mesh_error(file_name + " contains no shape" + (read.faults.empty() ? "" : ": " + read.faults.front()));
  read.names = names_of_bodies(read.shape, stem_of(file_name));
}

// Calls `on_shape` with the shape before the names are read, in which many files have faults of their own.
template <class Reader, class Function>
Shape_of_file read_exchange_file(const std::string& file_name, const std::string& unit, const char* format, Function on_shape)
{
  Reader reader; // its constructor sets the parameters up, the unit among them
  auto& shapes = reader_of_shapes(reader);
  const Exchange_unit conversion(unit);
  if(shapes.ReadFile(file_name.c_str()) != IFSelect_RetDone)
    throw Parametric_surface_mesh_error("cannot read " + file_name + " as " + format);
  shapes.TransferRoots();
  Shape_of_file result{shapes.OneShape(), faults_of_file(shapes, file_name), {}};
  check_shape(file_name, result);
  on_shape(result);
  try {
    result.names = guarded([&] { return names_of_exchange_file(reader, result.shape, stem_of(file_name)); });
  }
  catch(const std::exception& error) {
    result.names.faults.push_back(error.what());
  }
  return result;
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

// Reads a file in this process. Damaged files let the readers of Open CASCADE crash, or never return. `on_shape` is called with the
// shape when its names are still missing.
template <class Function>
Shape_of_file read_shape_file(const std::string& file_name, const std::string& unit, Function on_shape)
{
  const std::string ending = ending_of(file_name);
  return guarded([&]() -> Shape_of_file {
    if(ending == "step" || ending == "stp")
      return read_exchange_file<STEPCAFControl_Reader>(file_name, unit, "STEP", on_shape);
    if(ending == "iges" || ending == "igs")
      return read_exchange_file<IGESCAFControl_Reader>(file_name, unit, "IGES", on_shape);
    Shape_of_file result = read_brep_file(file_name);
    check_shape(file_name, result);
    on_shape(result);
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

// What one process reads and hands over to another: the shape in Open CASCADE's binary format, and then what else there is.
class Handed_over_shape
{
  Temporary_file m_shape, m_rest, m_rest_with_names; // the last one is written when the names are known, or never

public:
  void write_shape(const TopoDS_Shape& shape) const
  {
    std::ofstream file(m_shape.name(), std::ios::binary);
    guarded([&] { BinTools::Write(shape, file); });
    check(file, m_shape);
  }

  void write_rest(Shape_of_file& read) const { write(read, m_rest); }
  void write_rest_with_names(Shape_of_file& read) const { write(read, m_rest_with_names); }

  // None if the shape or the rest is not whole. What was written first counts if what came later is not whole.
  std::optional<Shape_of_file> read() const
  {
    std::optional<Shape_of_file> result = rest_in(m_rest_with_names);
    if(!result)
      result = rest_in(m_rest);
    if(!result)
      return std::nullopt;
    std::ifstream shape(m_shape.name(), std::ios::binary);
    guarded([&] { BinTools::Read(result->shape, shape); });
    return result;
  }

private:
  static void write(Shape_of_file& read, const Temporary_file& name)
  {
    std::ofstream file(name.name(), std::ios::binary);
    Text_writer write(file);
    write(read.faults, read.names);
    check(file, name);
  }

  // All that is written ends with the end of a line.
  static std::optional<Shape_of_file> rest_in(const Temporary_file& name)
  {
    std::ifstream file(name.name(), std::ios::binary);
    Shape_of_file result;
    Text_reader read(file);
    read(result.faults, result.names);
    return file && file.get() == '\n' ? std::optional<Shape_of_file>(std::move(result)) : std::nullopt;
  }

  static void check(std::ofstream& file, const Temporary_file& name)
  {
    if(!file.flush())
      throw Parametric_surface_mesh_error("cannot write the temporary file " + name.name());
  }
};

// Why a process that read a file has handed over nothing.
inline std::string reason_of(const Process_end& end, const Process_limits& limits)
{
  switch(end.kind) {
  case Process_end::OUT_OF_TIME:
    return "Open CASCADE has not finished after " + std::to_string(limits.seconds) + " seconds; the file is probably damaged";
  case Process_end::CRASHED:
    return "Open CASCADE crashed on it (" + end.text + "); the file is probably damaged";
  default:
    return end.text;
  }
}

// Reads a file in a process of its own. If that ends early when it has the shape, names are missing, and nothing else.
inline Shape_of_file read_shape_file_safely(const std::string& file_name, const std::string& unit)
{
  const Process_limits limits = limits_of_reading(file_name);
  const Handed_over_shape handed_over;
  const Child_process reading(limits, [&]() -> std::string {
    Shape_of_file read = read_shape_file(file_name, unit, [&](Shape_of_file& without_names) {
      handed_over.write_shape(without_names.shape);
      handed_over.write_rest(without_names);
    });
    handed_over.write_rest_with_names(read);
    return "";
  });
  const Process_end end = reading();
  if(end.kind == Process_end::FAILED)
    throw Parametric_surface_mesh_error(end.text);
  std::optional<Shape_of_file> result = handed_over.read();
  if(!result)
    throw Parametric_surface_mesh_error("cannot read " + file_name + ": " + reason_of(end, limits));
  if(end.kind != Process_end::DONE)
    result->names.faults.push_back("names, colours and layers could not be read: " + reason_of(end, limits));
  return std::move(*result);
}

#else

inline Shape_of_file read_shape_file_safely(const std::string& file_name, const std::string& unit)
{
  return read_shape_file(file_name, unit, [](const Shape_of_file&) {});
}

#endif

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_READ_SHAPE_FILE_H
