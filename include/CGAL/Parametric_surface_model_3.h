// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MODEL_3_H
#define CGAL_PARAMETRIC_SURFACE_MODEL_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Domain_curve_2.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/support/check_value.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/least_length.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Space_curve_3.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherModel

Several patches that share boundary curves: vertices in space, edges between them, and faces. A face is a surface with
loops of edge uses, each with the edge's curve in the domain of that face. An edge is divided once, and all faces that use
it get the same points: their meshes fit without a crack.

- An edge may be used twice by one face: a *seam*, along which the face closes on itself.
- An edge may be *collapsed*: both ends are one vertex and the curve is that point (a pole of the parametrisation).
- An edge may be used by three or more faces, or by several shells: see `Face::shell`.
- Loops of a face may touch in a common vertex.
- An edge may lie inside a face: see `add_inner_edge()`. The mesh follows it, with triangles of the face on both sides. It may dangle,
  touch other edges in common vertices, close on itself, and be used by other faces, too.
- A vertex may lie inside a face: see `add_inner_point()`.

Meshing begins with `Parametric_surface_mesher::validate()`: loops must close, and the uses of an edge be the
same curve in space within the `tolerance()`.

\tparam Surface a model of `ParametricSurface_3`

\sa `CGAL::make_model_of_rectangular_patches()`
\sa `CGAL::Parametric_surface_mesher::orient_faces()`
*/
template <class Surface>
class Parametric_surface_model_3
{
public:
  typedef Surface Surface_3;
  typedef typename Surface::Geom_traits Geom_traits;
  typedef typename Geom_traits::Point_3 Point_3;
  typedef Domain_curve_2<Geom_traits> Curve;
  typedef Space_curve_3<Geom_traits> Space_curve;

  static constexpr std::size_t no_face = std::size_t(-1); ///< in place of the index of a face

  /// an edge between two vertices.
  struct Edge
  {
    std::size_t source; ///< the vertex where its curves begin
    std::size_t target; ///< the vertex where its curves end
    bool is_collapsed = false; ///< whether it is a point in space
    /// the curve that is divided; without it, the image of the first use's curve
    std::shared_ptr<const Space_curve> curve = nullptr;
    double tolerance = 0; ///< the largest distance between its uses, if that is more than the model's tolerance
    double max_edge = 0;  ///< the longest edge of its division, if that is less than the criteria's; 0 if it has no own one
    /// whether two faces of a shell may face to different sides along it, as on a Moebius strip; they are not joined there then
    bool allows_turned_faces = false;
  };

  /// one use of an edge in the loop of a face.
  struct Edge_use
  {
    std::size_t edge; ///< the edge
    bool is_reversed; ///< whether the loop runs through it from target to source
    Curve curve;      ///< the edge in the domain; the same parameter gives the same point in space in all uses
  };

  typedef std::vector<Edge_use> Loop;

  /// a vertex inside a face.
  struct Inner_point
  {
    std::size_t vertex;                      ///< the vertex
    typename Geom_traits::Point_2 parameters; ///< its place in the domain of the face
    double max_edge = 0;  ///< the wanted edge length there, if that is less than elsewhere; 0 if it has no own one
    double tolerance = 0; ///< the distance between the vertex and the surface, if that is more than the model's tolerance
  };

  /// a trimmed surface.
  struct Face
  {
    Surface surface;
    /// The outer one first, then holes, and loops inside the domain: of two uses, there and back, of an edge that the mesh is to follow.
    std::vector<Loop> loops;
    bool is_reversed = false; ///< whether the triangles are to face against `S_u x S_v`
    /// Faces of one shell are joined along an edge that two of them use; those of different shells are not, and an edge
    /// with three or more uses in one shell is a border of each of its faces. So the mesh of a shell is always manifold.
    std::size_t shell = 0;
    /// The index of a face before this one that has the same surface, the same loops and another shell, if this is the other side of it, as where two
    /// solids touch. It is meshed with that face, by the sizes of that one, and has the same triangles, turned over.
    std::size_t other_side_of = no_face;
    /// Triangles of faces with the same number are not to pass through each other: see
    /// `Parametric_surface_mesh_criteria::set_self_intersections()`. Those of faces without one may.
    std::optional<std::size_t> solid = 0;
    double max_edge = 0; ///< the wanted edge length, if that is less than the criteria's; 0 if the face has no own one
    double min_edge = 0; ///< the minimum edge length, if that is less than the criteria's; 0 if the face has no own one
    /// wanted edge lengths at the parameters `(u,v)`, if there is such a field, in place of that of the criteria
    std::function<double(double u, double v)> sizing_field = nullptr;
    std::vector<Inner_point> inner_points = {}; ///< what is to be a vertex of the mesh
  };

private:
  std::vector<Point_3> m_vertices;
  std::vector<Edge> m_edges;
  std::vector<Face> m_faces;
  double m_tolerance = 0;

public:
  /// \name Construction
  /// Each function returns the index, from 0, of the new element.
  /// @{

  std::size_t add_vertex(const Point_3& p)
  {
    m_vertices.push_back(p);
    return m_vertices.size() - 1;
  }

  /// \throws Parametric_surface_mesh_error if one of the vertices does not exist, or they differ though the edge is collapsed
  std::size_t add_edge(std::size_t source, std::size_t target, bool is_collapsed = false)
  {
    Edge edge;
    edge.source = source;
    edge.target = target;
    edge.is_collapsed = is_collapsed;
    return add_edge(std::move(edge));
  }

  /// \throws Parametric_surface_mesh_error as above
  std::size_t add_edge(Edge edge)
  {
    check_vertices(edge, m_edges.size());
    m_edges.push_back(std::move(edge));
    return m_edges.size() - 1;
  }

  /// The edges of the uses may be added later.
  std::size_t add_face(Face face)
  {
    m_faces.push_back(std::move(face));
    return m_faces.size() - 1;
  }

  /// makes an edge lie inside a face: adds a loop that runs along it and back again. The mesh follows it as it follows the boundary. It may
  /// meet other edges in common vertices only. If it ends on the boundary, it ends in a vertex of the boundary.
  /// \param curve the edge in the domain of the face
  /// \throws Parametric_surface_mesh_error if there is no such face
  void add_inner_edge(std::size_t face, std::size_t edge, const Curve& curve)
  {
    check_face(face);
    m_faces[face].loops.push_back({{edge, false, curve}, {edge, true, curve}});
  }

  /// makes a vertex lie inside a face, where the mesh has it then. It must not lie on an edge.
  /// \param parameters the place of the vertex in the domain of the face
  /// \param max_edge the wanted edge length around it; edges grow with the distance from it. 0 if it is as elsewhere
  /// \throws Parametric_surface_mesh_error if there is no such face
  void add_inner_point(std::size_t face, std::size_t vertex, const typename Geom_traits::Point_2& parameters, double max_edge = 0)
  {
    check_face(face);
    m_faces[face].inner_points.push_back({vertex, parameters, max_edge});
  }
  /// @}

  /// \name Access
  /// @{
  const std::vector<Point_3>& vertices() const { return m_vertices; }
  const std::vector<Edge>& edges() const { return m_edges; }
  std::vector<Edge>& edges() { return m_edges; }
  const std::vector<Face>& faces() const { return m_faces; }
  std::vector<Face>& faces() { return m_faces; }
  /// @}

  /// removes faces: those for whose index `is_unwanted` returns `true`. The others keep their order; one that was the other side of a removed face is a face
  /// of its own.
  template <class Predicate>
  void remove_faces(const Predicate& is_unwanted)
  {
    std::vector<std::size_t> new_indices;
    std::vector<Face> rest;
    for(std::size_t f = 0; f < m_faces.size(); ++f) {
      const bool is_removed = is_unwanted(f);
      new_indices.push_back(is_removed ? std::size_t(no_face) : rest.size());
      if(!is_removed)
        rest.push_back(std::move(m_faces[f]));
    }
    for(Face& face : rest)
      if(face.other_side_of != no_face)
        face.other_side_of = new_indices[face.other_side_of];
    m_faces.swap(rest);
  }

  /// gives all faces, as they are now, a sizing field in space.
  /// \tparam Field a model of `ParametricSurfaceSizingField_3`
  template <class Field>
  void set_sizing_field(const Field& field)
  {
    for(Face& face : m_faces)
      face.sizing_field = [surface = face.surface, field](double u, double v) { return field(surface.point(u, v)); };
  }

  /// adds a sizing field in space to those that the faces have: the least length counts.
  /// \tparam Field a model of `ParametricSurfaceSizingField_3`
  template <class Field>
  void add_sizing_field(const Field& field)
  {
    for(Face& face : m_faces)
      face.sizing_field = [before = face.sizing_field, surface = face.surface, field](double u, double v) {
        const double length = field(surface.point(u, v));
        return before ? Parametric_surface_mesher::internal::least_length(length, before(u, v)) : length;
      };
  }

  /// \name Tolerance
  /// @{

  /// sets the largest distance in space between the uses of an edge, and between their ends and the vertices. 0, the default,
  /// stands for 1e-6 of the diagonal of the model's bounding box.
  /// \throws Parametric_surface_mesh_error if `tolerance` is negative or not finite
  void set_tolerance(double tolerance)
  {
    Parametric_surface_mesher::internal::check_not_negative_and_finite("tolerance of the model", tolerance);
    m_tolerance = tolerance;
  }

  double tolerance() const { return m_tolerance; }
  /// @}

  /// \name Validation
  /// @{

  /// \throws Parametric_surface_mesh_error if a vertex of the edge with this index does not exist, or they differ though the
  /// edge is collapsed
  void check_vertices_of_edge(std::size_t number) const { check_vertices(m_edges[number], number); }
  /// @}

private:
  void check_face(std::size_t face) const
  {
    if(face >= m_faces.size())
      throw Parametric_surface_mesh_error("there is no face with index " + std::to_string(face) + ", only "
                                          + std::to_string(m_faces.size()) + " faces");
  }

  void check_vertices(const Edge& edge, std::size_t number) const
  {
    using Parametric_surface_mesher::internal::numbered;
    for(std::size_t vertex : {edge.source, edge.target})
      if(vertex >= m_vertices.size())
        throw Parametric_surface_mesh_error(numbered("edge", number) + ": there is no vertex with index "
                                            + std::to_string(vertex) + ", only " + std::to_string(m_vertices.size()) + " vertices");
    if(edge.is_collapsed && edge.source != edge.target)
      throw Parametric_surface_mesh_error(numbered("edge", number) + " is collapsed and must end at the vertex where it begins, "
                                          "but runs from " + numbered("vertex", edge.source) + " to "
                                          + numbered("vertex", edge.target));
  }
};

} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MODEL_3_H
