// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_PAGE_3_H
#define CGAL_MESH_PAGE_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherFiles

What a page shows of a mesh: its triangles with the faces that they lie on and their places in the domains, lines along edges, values
of the triangles, and what was found. `points`, `triangles`, `triangle_faces` and `faces` are needed; all else may be empty. All arrays
may be filled by hand.

\sa `CGAL::make_mesh_page()`
\sa `CGAL::IO::write_HTML()`
*/
struct Mesh_page_3
{
  typedef std::array<double, 3> Point; ///< coordinates in space
  typedef std::array<double, 3> Color; ///< red, green and blue in sRGB, each between 0 and 1

  /// the index of what does not exist.
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /// a solid, or another body.
  struct Part
  {
    std::string name;
    std::optional<Color> color;
  };

  /// a face of the model.
  struct Face
  {
    std::size_t number = 0;  ///< what the page calls it by
    std::string name;        ///< empty if it has none
    std::size_t part = none; ///< the index of the part that it belongs to, or `none`
    std::optional<Color> color;
  };

  /// an edge of the mesh that lies on an edge of the model or on the border of the mesh.
  struct Line
  {
    std::array<std::size_t, 2> points; ///< the indices of both ends
    std::size_t number = 0;            ///< of the edge of the model; 0 if it is not known
  };

  /// how values change with the unit of length.
  enum class Dimension
  {
    NUMBER,           ///< not at all
    LENGTH,           ///< as lengths do
    RECIPROCAL_LENGTH ///< as curvatures do
  };

  /// a value of each triangle.
  struct Values
  {
    std::string name;
    Dimension dimension = Dimension::NUMBER;
    std::vector<double> values; ///< in the order of the triangles
  };

  /// something that is worth a look: it is in a list, of which each entry leads to its places.
  struct Finding
  {
    std::string kind;   ///< entries of one kind stand together, for instance "not met"
    std::string text;   ///< what it is, for instance "angle"
    std::string detail; ///< more about it, for instance "because of the boundary"
    std::vector<std::size_t> faces = {};     ///< the indices of faces that it is about, which are named before the text
    std::vector<std::size_t> triangles = {}; ///< the indices of triangles that it is about
    std::vector<Point> places = {};          ///< places that it is about
  };

  std::string title; ///< the name of the file or the surface
  std::string unit;  ///< the unit of length, for instance "mm"; empty if there is none
  bool is_closed = false; ///< whether the mesh has no border; then cuts show the inside as solid
  std::vector<std::string> summary; ///< lines about the mesh

  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles; ///< the indices of the corners, counterclockwise seen from outside
  std::vector<std::size_t> triangle_faces;           ///< for each triangle the index of its face
  /// for each triangle the parameters of its corners in the domain of its face
  std::vector<std::array<std::array<double, 2>, 3>> corner_parameters;
  /// for each triangle the components `E`, `F` and `G` of the metric tensor whose circles are its circumellipses
  std::vector<std::array<double, 3>> metric_tensors;
  std::vector<Face> faces;
  std::vector<Part> parts;
  std::vector<Line> lines;
  std::vector<Values> values; ///< beside the angles and ratios of radii, which need not be given
  std::vector<Finding> findings;

  /// multiplies all lengths by `factor`.
  void scale_lengths(double factor)
  {
    const auto scale = [factor](Point& p) {
      for(double& coordinate : p)
        coordinate *= factor;
    };
    for(Point& p : points)
      scale(p);
    for(Finding& finding : findings)
      for(Point& place : finding.places)
        scale(place);
    for(Values& named : values)
      for(double& value : named.values)
        value *= named.dimension == Dimension::LENGTH ? factor : named.dimension == Dimension::RECIPROCAL_LENGTH ? 1 / factor : 1;
  }
};

} // namespace CGAL

#endif // CGAL_MESH_PAGE_3_H
