// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tetrahedra that fill a closed triangle mesh and keep its triangles. They are made by TetGen, which is under the AGPL.
#ifndef TETRAHEDRA_H
#define TETRAHEDRA_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

// Without it TetGen is a program, which has no function to call, and exits on errors.
#ifndef TETLIBRARY
#define TETLIBRARY
#endif
#include <tetgen.h>

struct Tetrahedra
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point_3;
  typedef CGAL::Surface_mesh<Point_3> Surface;
  typedef std::array<std::size_t, 4> Cell;

  std::vector<Point_3> points; // first those of the surface, in its order
  std::vector<Cell> cells;     // four points each, positively oriented
};

namespace tetrahedra {

// what a tetgenio frees by itself
inline tetgenio::polygon* make_triangle(const std::array<int, 3>& corners)
{
  tetgenio::polygon* result = new tetgenio::polygon[1]();
  result->vertexlist = new int[3]{corners[0], corners[1], corners[2]};
  result->numberofvertices = 3;
  return result;
}

// Points are numbered in the order of the vertices, every triangle is a facet.
inline void copy(const Tetrahedra::Surface& surface, tetgenio& result)
{
  std::vector<int> number(surface.num_vertices()); // that counts removed vertices, too
  result.pointlist = new double[3 * surface.number_of_vertices()];
  for(const auto v : surface.vertices()) {
    number[v] = result.numberofpoints++;
    for(int i = 0; i < 3; ++i)
      result.pointlist[3 * number[v] + i] = surface.point(v)[i];
  }
  result.facetlist = new tetgenio::facet[surface.number_of_faces()]();
  for(const auto f : surface.faces()) {
    const auto h = surface.halfedge(f);
    tetgenio::facet& facet = result.facetlist[result.numberoffacets++];
    facet.polygonlist
      = make_triangle({number[surface.source(h)], number[surface.target(h)], number[surface.target(surface.next(h))]});
    facet.numberofpolygons = 1;
  }
}

inline Tetrahedra to_tetrahedra(const tetgenio& output)
{
  Tetrahedra result;
  for(const double* p = output.pointlist; p != output.pointlist + 3 * output.numberofpoints; p += 3)
    result.points.emplace_back(p[0], p[1], p[2]);
  for(const int* c = output.tetrahedronlist; c != output.tetrahedronlist + 4 * output.numberoftetrahedra; c += 4)
    result.cells.push_back({std::size_t(c[0]), std::size_t(c[1]), std::size_t(c[2]), std::size_t(c[3])});
  return result;
}

} // namespace tetrahedra

// Tetrahedra inside `surface`, of which no part is a cavity in another one.
//
// The switches of TetGen: p fills a closed surface, Y keeps its triangles, M all of its points, and q bounds the shape: the
// ratio of circumradius to shortest edge by 1.4 and dihedral angles by 10 degrees, as far as the surface allows. Q is quiet.
//
// Throws std::invalid_argument if the surface is not closed or intersects itself, which makes TetGen 1.5.0 crash.
inline Tetrahedra fill_with_tetrahedra(const Tetrahedra::Surface& surface, std::string switches = "pYMq1.4/10Q")
{
  if(surface.is_empty() || !CGAL::is_triangle_mesh(surface) || !CGAL::is_closed(surface))
    throw std::invalid_argument("the surface to fill is not a closed mesh of triangles");
  if(CGAL::Polygon_mesh_processing::does_self_intersect(surface))
    throw std::invalid_argument("the surface to fill intersects itself");
  tetgenio input, output;
  tetrahedra::copy(surface, input);
  try {
    tetrahedralize(&switches[0], &input, &output);
  }
  catch(int error) {
    throw std::runtime_error("TetGen has given up with error " + std::to_string(error));
  }
  return tetrahedra::to_tetrahedra(output);
}

// Writes a legacy VTK file, as ParaView reads it. The precision is that of the stream.
inline void write_VTK(std::ostream& out, const Tetrahedra& tetrahedra)
{
  out << "# vtk DataFile Version 3.0\n"
      << "tetrahedra\n"
      << "ASCII\n"
      << "DATASET UNSTRUCTURED_GRID\n"
      << "POINTS " << tetrahedra.points.size() << " double\n";
  for(const Tetrahedra::Point_3& p : tetrahedra.points)
    out << p.x() << " " << p.y() << " " << p.z() << "\n";
  out << "CELLS " << tetrahedra.cells.size() << " " << 5 * tetrahedra.cells.size() << "\n";
  for(const Tetrahedra::Cell& c : tetrahedra.cells)
    out << "4 " << c[0] << " " << c[1] << " " << c[2] << " " << c[3] << "\n";
  out << "CELL_TYPES " << tetrahedra.cells.size() << "\n";
  for(std::size_t i = 0; i < tetrahedra.cells.size(); ++i)
    out << "10\n"; // a tetrahedron
}

#endif // TETRAHEDRA_H
