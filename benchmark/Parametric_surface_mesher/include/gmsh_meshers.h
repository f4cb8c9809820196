// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Gmsh's Frontal-Delaunay mesher, by its C++ interface, with one thread. None without WITH_GMSH.
#ifndef GMSH_MESHERS_H
#define GMSH_MESHERS_H

#include "Sample_mesher.h"

#ifdef WITH_GMSH

#include "add_sample_to_gmsh.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace gmsh_meshers {

const int frontal_delaunay = 6; // Gmsh's number of the algorithm
const int triangle = 2;         // Gmsh's number of the type of elements

struct Session
{
  Session() { gmsh::initialize(0, nullptr, false); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session() { gmsh::finalize(); }
};

// The edge length alone decides the size.
inline void set_options(double edge_length)
{
  using gmsh::option::setNumber;
  setNumber("General.Terminal", 0);
  setNumber("General.NumThreads", 1);
  setNumber("Mesh.Algorithm", frontal_delaunay);
  setNumber("Mesh.MeshSizeMin", edge_length);
  setNumber("Mesh.MeshSizeMax", edge_length);
  setNumber("Mesh.MeshSizeFromPoints", 0);
  setNumber("Mesh.MeshSizeFromCurvature", 0);
  setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
}

// Gmsh faces each surface as it likes, and knows points that belong to no triangle.
inline void append_mesh(Sample_mesh& mesh)
{
  std::vector<std::size_t> tags, elements, corners;
  std::vector<double> coordinates, ignored;
  gmsh::model::mesh::getNodes(tags, coordinates, ignored);
  gmsh::model::mesh::getElementsByType(triangle, elements, corners);
  std::unordered_map<std::size_t, std::size_t> index_of_tag;
  for(std::size_t i = 0; i < tags.size(); ++i)
    index_of_tag[tags[i]] = i;

  std::vector<Sample_kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> index(tags.size(), std::size_t(-1));
  for(std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t node = index_of_tag.at(corners[i]);
    if(index[node] == std::size_t(-1)) {
      index[node] = points.size();
      points.emplace_back(coordinates[3 * node], coordinates[3 * node + 1], coordinates[3 * node + 2]);
    }
    if(i % 3 == 0)
      triangles.emplace_back();
    triangles.back()[i % 3] = index[node];
  }
  namespace PMP = CGAL::Polygon_mesh_processing;
  PMP::orient_polygon_soup(points, triangles);
  PMP::polygon_soup_to_polygon_mesh(points, triangles, mesh);
}

// The time is that of the division of the curves and of the meshing, without making the geometry.
inline Mesher_run mesh(const Sample& sample, double edge_length, Sample_mesh& mesh)
{
  try {
    const Session session;
    set_options(edge_length);
    add_sample_to_gmsh(sample);
    const Mesher_run run = run_of([] { gmsh::model::mesh::generate(2); });
    append_mesh(mesh);
    return run;
  } catch(const std::string& error) { // as some versions of Gmsh tell errors
    throw std::runtime_error("Gmsh: " + error);
  }
}

inline std::vector<Sample_mesher> meshers_of(const Sample& sample)
{
  return {{"Gmsh " + std::to_string(GMSH_API_VERSION_MAJOR) + "." + std::to_string(GMSH_API_VERSION_MINOR) + " Frontal-Delaunay",
           [sample](double edge_length, Sample_mesh& result) { return mesh(sample, edge_length, result); }}};
}

} // namespace gmsh_meshers

#else

namespace gmsh_meshers {

inline std::vector<Sample_mesher> meshers_of(const Sample&) { return {}; }

} // namespace gmsh_meshers

#endif // WITH_GMSH

#endif // GMSH_MESHERS_H
