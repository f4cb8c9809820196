// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ELEMENT_MESH_3_H
#define CGAL_ELEMENT_MESH_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Open_cascade_names_3.h>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherFiles

A mesh as a solver takes it: nodes, triangles, lines and points, each with the face, edge or vertex of the model that it lies on, and named
groups of these. Elements are of first or of second order. All arrays may be filled by hand.

\sa `CGAL::make_element_mesh()`
\sa `CGAL::IO::write_MSH()`, `CGAL::IO::write_INP()`
*/
struct Element_mesh_3
{
  typedef std::array<double, 3> Point;       ///< the coordinates of a node
  typedef Open_cascade_names_3::Color Color; ///< a colour in sRGB

  /// the index of what does not exist.
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /// a solid, or another body.
  struct Part
  {
    std::size_t number = 0; ///< from 1, in the list of parts that it comes from
    std::string name;
    std::optional<Color> color;
  };

  /// a face, an edge or a vertex of the model, as far as it belongs to one part. What several parts have, with elements for each
  /// of them, are several entities with the same number.
  struct Entity
  {
    std::size_t number = 0; ///< from 1, in the model
    /// the index of the part, or `none`. A face between two parts whose elements both of them have has both: first the one that its
    /// triangles face out of.
    std::array<std::size_t, 2> parts{{none, none}};
    std::string name; ///< empty if it has none
    std::optional<Color> color;
  };

  /// what is called by one name: surfaces, curves or vertices; or parts.
  struct Group
  {
    std::string name;
    int dimension = 2;                 ///< 0 for vertices, 1 for curves, 2 for surfaces, 3 for parts
    std::vector<std::size_t> entities; ///< their indices
  };

  /// where a node lies: on a vertex, on a curve with parameter `u`, or inside a surface at `u` and `v`.
  struct Place
  {
    int dimension = 2;         ///< 0 on a vertex, 1 on a curve, 2 on a surface
    std::size_t entity = none; ///< the index of it
    double u = std::numeric_limits<double>::quiet_NaN(), v = std::numeric_limits<double>::quiet_NaN(); ///< not numbers if not known
  };

  /// three corners, counterclockwise seen from outside, and the nodes in the middles of the sides from the first corner to the second,
  /// from there to the third, and from there to the first one; `none` in elements of first order.
  typedef std::array<std::size_t, 6> Triangle;
  /// both ends, and the node in the middle, or `none`.
  typedef std::array<std::size_t, 3> Line;

  /// values of all triangles, or of all nodes.
  struct Data
  {
    std::string name;
    std::size_t number_of_components = 1;
    std::vector<double> values;
  };

  bool is_second_order = false;
  std::vector<Point> nodes;
  std::vector<Place> places;              ///< of the nodes; may be empty
  std::vector<Triangle> triangles;
  std::vector<std::size_t> triangle_surfaces; ///< for each triangle the index of its surface
  std::vector<Line> lines;
  std::vector<std::size_t> line_curves;   ///< for each line the index of its curve
  std::vector<std::size_t> points;        ///< the nodes that are elements, since they lie on vertices of the model
  std::vector<std::size_t> point_vertices; ///< for each of these the index of the vertex

  std::vector<Part> parts;
  std::vector<Entity> vertices, curves, surfaces;
  std::vector<Group> groups;
  std::vector<Data> triangle_data, node_data;

  /// forgets the parameters of nodes, so that files do not have them. Some programs cannot read files that do.
  void forget_parameters()
  {
    for(Place& place : places)
      place.u = place.v = Place().u;
  }

  /// the number of nodes of a triangle, 3 or 6.
  std::size_t nodes_of_triangle() const { return is_second_order ? 6 : 3; }
  /// the number of nodes of a line, 2 or 3.
  std::size_t nodes_of_line() const { return is_second_order ? 3 : 2; }
};

} // namespace CGAL

#endif // CGAL_ELEMENT_MESH_3_H
