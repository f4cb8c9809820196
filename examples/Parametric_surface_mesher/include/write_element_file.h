// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files for simulations: triangles with the number of the face that they lie on.
#ifndef WRITE_ELEMENT_FILE_H
#define WRITE_ELEMENT_FILE_H

#include <array>
#include <cstddef>
#include <ostream>
#include <vector>

namespace mesh_cad {

// A mesh as plain arrays.
struct Elements
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::array<std::size_t, 3>> mid_side_nodes; // of the triangles: after each corner; empty for elements of first order
  std::vector<std::size_t> face_ids; // of the triangles, at least 1

  bool is_second_order() const { return !mid_side_nodes.empty(); }
  std::size_t nodes_of_triangle() const { return is_second_order() ? 6 : 3; }

  // Writes the nodes of a triangle, counted from `first`.
  void write_nodes(std::ostream& out, std::size_t triangle, std::size_t first, const char* separator) const
  {
    const auto& t = triangles[triangle];
    out << t[0] + first << separator << t[1] + first << separator << t[2] + first;
    if(is_second_order())
      for(const std::size_t node : mid_side_nodes[triangle])
        out << separator << node + first;
    out << '\n';
  }
};

// An unstructured grid of VTK, for ParaView; the cell array is `face_id`.
inline void write_vtu(std::ostream& out, const Elements& mesh)
{
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
      << "<Piece NumberOfPoints=\"" << mesh.points.size() << "\" NumberOfCells=\"" << mesh.triangles.size() << "\">\n"
      << "<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for(const auto& p : mesh.points)
    out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  out << "</DataArray>\n</Points>\n<Cells>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  for(std::size_t t = 0; t < mesh.triangles.size(); ++t)
    mesh.write_nodes(out, t, 0, " ");
  out << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  for(std::size_t t = 1; t <= mesh.triangles.size(); ++t)
    out << mesh.nodes_of_triangle() * t << '\n';
  out << "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n";
  for(std::size_t t = 0; t < mesh.triangles.size(); ++t)
    out << (mesh.is_second_order() ? "22\n" : "5\n"); // VTK_QUADRATIC_TRIANGLE, VTK_TRIANGLE
  out << "</DataArray>\n</Cells>\n<CellData Scalars=\"face_id\">\n"
         "<DataArray type=\"Int64\" Name=\"face_id\" format=\"ascii\">\n";
  for(const std::size_t id : mesh.face_ids)
    out << id << '\n';
  out << "</DataArray>\n</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

} // namespace mesh_cad

#endif // WRITE_ELEMENT_FILE_H
