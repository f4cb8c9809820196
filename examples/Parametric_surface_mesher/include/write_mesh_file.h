// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef WRITE_MESH_FILE_H
#define WRITE_MESH_FILE_H

#include "Usage_error.h"

#include <CGAL/Surface_mesh/IO.h>
#include <CGAL/Surface_mesh/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/boost/graph/IO/PLY.h>
#include <CGAL/boost/graph/IO/STL.h>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>

namespace mesh_patch {

// The mesh in the format of the file's ending: .off, .obj, .ply or .stl.
template <class Point>
void write_mesh(std::ostream& out, const std::string& file_name, const CGAL::Surface_mesh<Point>& mesh)
{
  const auto precision = CGAL::parameters::stream_precision(17);
  bool is_written = false;
  if(has_ending(file_name, ".off"))
    is_written = CGAL::IO::write_OFF(out, mesh, precision);
  else if(has_ending(file_name, ".obj"))
    is_written = CGAL::IO::write_OBJ(out, mesh, precision);
  else if(has_ending(file_name, ".ply"))
    is_written = CGAL::IO::write_PLY(out, mesh, precision);
  else // as text, since a binary .stl has single precision
    is_written = CGAL::IO::write_STL(out, mesh, precision);
  if(!is_written)
    out.setstate(std::ios::failbit);
}

// The same for a mesh whose property "f:patch" is the index of the patch of each triangle. A .ply file gets, as `face_id`, the
// number that `number_of_patch` gives it.
template <class Point, class NumberOfPatch>
void write_mesh(std::ostream& out, const std::string& file_name, const CGAL::Surface_mesh<Point>& mesh,
                const NumberOfPatch& number_of_patch)
{
  if(!has_ending(file_name, ".ply"))
    return write_mesh(out, file_name, mesh);
  typedef typename CGAL::Surface_mesh<Point>::Face_index Face_index;
  CGAL::Surface_mesh<Point> numbered = mesh;
  auto patch = numbered.template add_property_map<Face_index, std::size_t>("f:patch").first;
  const auto face_id = numbered.template add_property_map<Face_index, std::uint32_t>("f:face_id").first;
  for(const Face_index triangle : numbered.faces())
    face_id[triangle] = std::uint32_t(number_of_patch(patch[triangle]));
  numbered.remove_property_map(patch);
  write_mesh(out, file_name, numbered);
}

} // namespace mesh_patch

#endif // WRITE_MESH_FILE_H
