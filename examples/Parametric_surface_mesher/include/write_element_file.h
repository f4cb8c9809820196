// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files for simulations: triangles with the number of the face that they lie on.
#ifndef WRITE_ELEMENT_FILE_H
#define WRITE_ELEMENT_FILE_H

#include <array>
#include <cstddef>
#include <map>
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

  std::map<std::size_t, std::vector<std::size_t>> triangles_of_faces() const
  {
    std::map<std::size_t, std::vector<std::size_t>> result;
    for(std::size_t t = 0; t < triangles.size(); ++t)
      result[face_ids[t]].push_back(t);
    return result;
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

// Gmsh's format, version 2.2: a face is a physical group, and an entity of the same number.
inline void write_msh(std::ostream& out, const Elements& mesh)
{
  const auto faces = mesh.triangles_of_faces();
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" << faces.size() << "\n";
  for(const auto& face : faces)
    out << "2 " << face.first << " \"face_" << face.first << "\"\n";
  out << "$EndPhysicalNames\n$Nodes\n" << mesh.points.size() << "\n";
  for(std::size_t i = 0; i < mesh.points.size(); ++i)
    out << i + 1 << ' ' << mesh.points[i][0] << ' ' << mesh.points[i][1] << ' ' << mesh.points[i][2] << '\n';
  out << "$EndNodes\n$Elements\n" << mesh.triangles.size() << "\n";
  for(std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    out << t + 1 << (mesh.is_second_order() ? " 9 2 " : " 2 2 ") << mesh.face_ids[t] << ' ' << mesh.face_ids[t] << ' ';
    mesh.write_nodes(out, t, 1, " ");
  }
  out << "$EndElements\n";
}

// An input file of Abaqus and CalculiX: shell elements S3 or S6, each face an element set FACE_<number>.
inline void write_inp(std::ostream& out, const Elements& mesh)
{
  out << "*HEADING\nTriangles of the faces of a shape\n*NODE\n";
  for(std::size_t i = 0; i < mesh.points.size(); ++i)
    out << i + 1 << ", " << mesh.points[i][0] << ", " << mesh.points[i][1] << ", " << mesh.points[i][2] << '\n';
  for(const auto& face : mesh.triangles_of_faces()) {
    out << "*ELEMENT, TYPE=" << (mesh.is_second_order() ? "S6" : "S3") << ", ELSET=FACE_" << face.first << '\n';
    for(const std::size_t t : face.second) {
      out << t + 1 << ", ";
      mesh.write_nodes(out, t, 1, ", ");
    }
  }
}

} // namespace mesh_cad

#endif // WRITE_ELEMENT_FILE_H
