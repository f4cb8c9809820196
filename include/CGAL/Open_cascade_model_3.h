// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_OPEN_CASCADE_MODEL_3_H
#define CGAL_OPEN_CASCADE_MODEL_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Open_cascade_surface_3.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

A shape of Open CASCADE as a model, and what was found on the way. Faces and edges of the shape are counted from 0 in the
order of `TopExp::MapShapes()`.

\sa `CGAL::make_model_of_open_cascade_shape()`
*/
struct Open_cascade_model_3
{
  typedef Parametric_surface_model_3<Open_cascade_surface_3> Model; ///< the type of the model

  /// the index of what the shape does not have.
  static constexpr std::size_t none = std::size_t(-1);

  /// a face of the shape that is not in the model, or not in the mesh.
  struct Left_out_face
  {
    std::size_t shape_face; ///< its index in the shape
    std::string reason;     ///< why
  };

  /// a face that is closed up: it is so narrow that the edges on both sides of it are one edge of the model, or so small
  /// that all of it is a vertex.
  struct Closed_up_face
  {
    std::size_t shape_face; ///< its index in the shape
    double width;           ///< the largest distance that was measured across it
  };

  /// an edge whose curves are farther apart than its tolerance in the shape says.
  struct Gap
  {
    std::size_t shape_edge; ///< the index of the edge in the shape, from 0
    std::size_t shape_face; ///< a face with a curve in its domain that is so far from the edge
    /// the largest distance in space, between the image of that curve and the edge, or of their ends and the vertices
    double distance;
    double tolerance;       ///< the largest tolerance of the edge and its vertices
  };

  /// an edge that a face has inside, not as a boundary.
  struct Inner_edge
  {
    std::size_t shape_edge; ///< the index of the edge in the shape, from 0
    std::size_t shape_face; ///< the index of the face in the shape, from 0
    std::string reason = ""; ///< why the mesh does not follow it; empty if it does
  };

  /// a vertex that a face has inside.
  struct Inner_vertex
  {
    std::size_t shape_vertex; ///< the index of the vertex in the shape, from 0
    std::size_t shape_face;   ///< the index of the face in the shape, from 0
    std::string reason = "";  ///< why it is no vertex of the mesh; empty if it is
  };

  /// its first edges are those of the shape, in their order; then come collapsed ones that the shape lacks. If a face is divided at
  /// a crease the order is another one: see `model_edges`.
  Model model;
  /// for each face of the model, its index in the shape; a face between two shells appears twice, and one with a crease several times
  std::vector<std::size_t> shape_faces;
  /// for each edge of the shape, those of the model along it: the same, unless a face is closed up or divided at a crease; none if it is a vertex
  std::vector<std::vector<std::size_t>> model_edges;
  /// for each vertex of the model, its index in the shape, or `none` at creases and on closed edges without vertices
  std::vector<std::size_t> shape_vertices;
  std::size_t number_of_shape_faces = 0;
  std::size_t number_of_shape_edges = 0;
  double diagonal = 0; ///< of the box of the shape
  bool is_shape_closed = true; ///< whether each edge has two uses in each shell that it is in, as far as faces lie on it

  std::vector<Left_out_face> left_out; ///< faces that could not be built
  std::vector<Closed_up_face> closed_up; ///< faces too narrow to be meshed; they are not in the model
  /// faces outside of shells that are in a shell, too: they are meshed with the shell only
  std::vector<std::size_t> repeated_faces;
  /// edges of the model along which faces of a shell cannot face to the same side: the mesh of the shell is open there
  std::vector<std::size_t> turned_edges;
  /// edges with the orientation `TopAbs_INTERNAL` or `TopAbs_EXTERNAL` in a face; the mesh follows those inside
  std::vector<Inner_edge> inner_edges;
  std::vector<Inner_vertex> inner_vertices; ///< vertices with such an orientation in a face, which the mesh has if they are inside
  std::vector<Gap> gaps;               ///< of edges that are less exact than the shape says
  /// the largest distance between an edge and the image of one of its curves, of all edges
  double largest_gap = 0;
  std::size_t number_of_rebuilt_curves = 0; ///< curves in domains that were missing, or far off, and made anew by projection
  std::size_t number_of_removed_slits = 0;  ///< edges left out because a face lies on both sides, on the same curve
  std::size_t number_of_joined_vertices = 0; ///< vertices that are others within their tolerances, and joined to them
  std::size_t number_of_reversed_faces = 0; ///< faces turned because neighbours in a shell did not face to the same side
};

} // namespace CGAL

#endif // CGAL_OPEN_CASCADE_MODEL_3_H
