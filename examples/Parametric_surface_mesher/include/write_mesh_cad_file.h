// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files of mesh_cad's option --out.
#ifndef WRITE_MESH_CAD_FILE_H
#define WRITE_MESH_CAD_FILE_H

#include "Mesh_cad_options.h"
#include "Mesh_cad_result.h"
#include "Picture_triangles.h"
#include "write_mesh_file.h"

#include <CGAL/IO/Color.h>
#include <CGAL/IO/write_BDF.h>
#include <CGAL/IO/write_GLB.h>
#include <CGAL/IO/write_INP.h>
#include <CGAL/IO/write_MSH.h>
#include <CGAL/IO/write_UNV.h>
#include <CGAL/IO/write_element_STL.h>
#include <CGAL/IO/write_element_VTU.h>
#include <CGAL/make_element_mesh.h>
#include <CGAL/write_triangulation_onto_open_cascade_shape.h>
#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_USE_MED
#include <CGAL/IO/write_MED.h>
#endif
#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_USE_3MF
#include <CGAL/IO/write_element_3MF.h>
#endif

#include <BRepTools.hxx>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace mesh_cad {

// A mesh as plain arrays.
struct Elements
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> face_ids; // of the triangles, at least 1
};

inline Elements elements(const Mesh_cad_result& result)
{
  Elements elements;
  auto arrays = mesh_picture::arrays<3>(result.mesh.mesh, [&](auto v) { return result.mesh.mesh.point(v); });
  elements.points = std::move(arrays.first);
  elements.triangles = std::move(arrays.second);
  for(const auto face : result.mesh.mesh.faces())
    elements.face_ids.push_back(result.shape.shape_faces[result.mesh.patch[face]] + 1);
  return elements;
}

// With the numbers of parts, faces, edges and vertices, and groups.
inline CGAL::Element_mesh_3 element_mesh(const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  const auto places = result.mesh.places();
  CGAL::Element_mesh_3 mesh
    = result.second_order
        ? CGAL::make_second_order_element_mesh(result.shape, result.names, result.mesh.mesh, result.mesh.mid_side_nodes, places)
        : CGAL::make_element_mesh(result.shape, result.names, result.mesh.mesh, places);
  mesh.triangle_data = result.triangle_data;
  if(!options.are_node_parameters_wanted)
    mesh.forget_parameters();
  return mesh;
}

// The numbers of the face and the part of each triangle, from 1, and colours, if the file has any.
inline void write_ply(std::ostream& out, const Mesh_cad_result& result)
{
  typedef Cad_mesh::Mesh::Face_index Face_index;
  Cad_mesh::Mesh mesh = result.mesh.mesh;
  auto patch = mesh.add_property_map<Face_index, std::size_t>("f:patch").first; // which is there
  const auto face_id = mesh.add_property_map<Face_index, std::uint32_t>("f:face_id").first,
             part_id = mesh.add_property_map<Face_index, std::uint32_t>("f:part_id").first;
  const auto parts = CGAL::Parametric_surface_mesher::internal::parts_of_model_faces(result.shape, result.names);
  const auto& colors = result.names.face_colors;
  for(const Face_index f : mesh.faces()) {
    face_id[f] = std::uint32_t(result.shape.shape_faces[patch[f]] + 1);
    part_id[f] = parts[patch[f]] == Names::none ? 0 : std::uint32_t(parts[patch[f]] + 1);
  }
  if(std::any_of(colors.begin(), colors.end(), [](const auto& color) { return color.has_value(); })) {
    const auto color = mesh.add_property_map<Face_index, CGAL::IO::Color>("f:color").first;
    const auto byte = [](double value) { return static_cast<unsigned char>((std::min)((std::max)(255 * value + 0.5, 0.), 255.)); };
    for(const Face_index f : mesh.faces()) {
      const Names::Color gray{0.75, 0.75, 0.75, 1}, c = colors[face_id[f] - 1].value_or(gray);
      color[f] = CGAL::IO::Color(byte(c.red), byte(c.green), byte(c.blue), byte(c.opacity));
    }
  }
  mesh.remove_property_map(patch);
  mesh_patch::write_mesh(out, "mesh.ply", mesh);
}

// For libraries that write to files of their own. `write` takes a name and tells whether there is a file.
template <class Function>
void write_through_file(std::ostream& out, const Function& write)
{
  const CGAL::Parametric_surface_mesher::internal::Temporary_file file;
  if(write(file.name()))
    out << std::ifstream(file.name(), std::ios::binary).rdbuf();
  else
    out.setstate(std::ios::failbit);
}

inline void write_glb(std::ostream& out, const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  const double metres_of_millimetre = 1e-3;
  write_through_file(out, [&](const std::string& name) {
    return CGAL::IO::write_GLB(name, element_mesh(options, result), metres_of_millimetre * unit_in_millimetres(options), result.names.parts.front().name);
  });
}

#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_USE_MED
inline void write_med(std::ostream& out, const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  write_through_file(out, [&](const std::string& name) {
    CGAL::IO::write_MED(name, element_mesh(options, result));
    return true;
  });
}
#else
inline void write_med(std::ostream&, const Mesh_cad_options&, const Mesh_cad_result&) {} // the ending is refused before
#endif

#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_USE_3MF
inline void write_3mf(std::ostream& out, const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  write_through_file(out, [&](const std::string& name) {
    CGAL::IO::write_3MF(name, element_mesh(options, result), unit_in_millimetres(options));
    return true;
  });
}
#else
inline void write_3mf(std::ostream&, const Mesh_cad_options&, const Mesh_cad_result&) {} // the ending is refused before
#endif

// The shape itself, in millimetres, with the mesh as its triangulation.
inline void write_brep(std::ostream& out, const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  const double unit = unit_in_millimetres(options);
  const auto points = boost::make_function_property_map<Cad_mesh::Mesh::Vertex_index, Kernel::Point_3>(
    [&mesh = result.mesh.mesh, unit](Cad_mesh::Mesh::Vertex_index v) {
      const auto& p = mesh.point(v);
      return Kernel::Point_3(unit * p.x(), unit * p.y(), unit * p.z());
    });
  CGAL::write_triangulation_onto_open_cascade_shape(
    result.shape, result.mesh.mesh, result.mesh.places(CGAL::parameters::vertex_point_map(points)), result.open_cascade_shape);
  BRepTools::Write(result.open_cascade_shape, out);
}

// The endings of files for solvers, which have elements of second order, too.
inline std::vector<std::string> endings_for_solvers()
{
#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_USE_MED
  return {".vtu", ".msh", ".msh2", ".inp", ".bdf", ".unv", ".med"};
#else
  return {".vtu", ".msh", ".msh2", ".inp", ".bdf", ".unv"};
#endif
}

inline std::vector<std::string> all_endings()
{
  std::vector<std::string> result{".off", ".obj", ".ply", ".stl", ".glb", ".brep"};
#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_USE_3MF
  result.push_back(".3mf");
#endif
  for(const std::string& ending : endings_for_solvers())
    result.push_back(ending);
  return result;
}

inline void write_result(std::ostream& out, const std::string& file_name, const Mesh_cad_options& options, const Mesh_cad_result& result)
{
  typedef bool (*Writer)(std::ostream&, const CGAL::Element_mesh_3&);
  const std::pair<const char*, Writer> writers[] = {{".vtu", CGAL::IO::write_VTU}, {".msh", CGAL::IO::write_MSH}, {".msh2", CGAL::IO::write_MSH_2},
                                                    {".inp", CGAL::IO::write_INP}, {".bdf", CGAL::IO::write_BDF}, {".unv", CGAL::IO::write_UNV},
                                                    {".stl", CGAL::IO::write_STL}};
  if(options.is_binary)
    CGAL::IO::set_binary_mode(out);
  for(const auto& writer : writers)
    if(mesh_patch::has_ending(file_name, writer.first)) {
      writer.second(out, element_mesh(options, result));
      return;
    }
  if(mesh_patch::has_ending(file_name, ".glb"))
    write_glb(out, options, result);
  else if(mesh_patch::has_ending(file_name, ".brep"))
    write_brep(out, options, result);
  else if(mesh_patch::has_ending(file_name, ".med"))
    write_med(out, options, result);
  else if(mesh_patch::has_ending(file_name, ".3mf"))
    write_3mf(out, options, result);
  else if(mesh_patch::has_ending(file_name, ".ply"))
    write_ply(out, result);
  else
    mesh_patch::write_mesh(out, file_name, result.mesh.mesh);
}

} // namespace mesh_cad

#endif // WRITE_MESH_CAD_FILE_H
