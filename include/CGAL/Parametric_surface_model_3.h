// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MODEL_3_H
#define CGAL_PARAMETRIC_SURFACE_MODEL_3_H

#include <CGAL/Domain_curve_2.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherModel

Several patches that share boundary curves: vertices in space, edges between them, and faces. A face is a surface with loops of
edge uses, each with the edge's curve in the domain of that face. An edge is divided once, and all faces that use
it get the same points: their meshes fit without a crack.

An edge may be collapsed: both ends are one vertex and the curve is that point (a pole of the parametrisation).

\tparam Surface a model of `ParametricSurface_3`
*/
template <class Surface>
class Parametric_surface_model_3
{
public:
  typedef typename Surface::Geom_traits Geom_traits;
  typedef typename Geom_traits::Point_3 Point_3;
  typedef Domain_curve_2<Geom_traits> Curve;

  /// an edge between two vertices.
  struct Edge
  {
    std::size_t source; ///< the vertex where its curves begin
    std::size_t target; ///< the vertex where its curves end
    bool is_collapsed;  ///< whether it is a point in space
  };

  /// one use of an edge in the loop of a face.
  struct Edge_use
  {
    std::size_t edge; ///< the edge
    bool is_reversed; ///< whether the loop runs through it from target to source
    Curve curve;      ///< the edge in the domain; the same parameter gives the same point in space in all uses
  };

  typedef std::vector<Edge_use> Loop;

  /// a trimmed surface.
  struct Face
  {
    Surface surface;
    std::vector<Loop> loops;  ///< the outer one first
    bool is_reversed = false; ///< whether the triangles are to face against `S_u x S_v`
  };

private:
  std::vector<Point_3> m_vertices;
  std::vector<Edge> m_edges;
  std::vector<Face> m_faces;

public:
  /// \name Construction
  /// Each function returns the number of the new element.
  /// @{

  std::size_t add_vertex(const Point_3& p)
  {
    m_vertices.push_back(p);
    return m_vertices.size() - 1;
  }

  /// \pre the vertices exist; they are equal if the edge is collapsed
  std::size_t add_edge(std::size_t source, std::size_t target, bool is_collapsed = false)
  {
    CGAL_precondition(source < m_vertices.size() && target < m_vertices.size());
    CGAL_precondition(!is_collapsed || source == target);
    m_edges.push_back({source, target, is_collapsed});
    return m_edges.size() - 1;
  }

  /// \pre the edges of the uses exist
  std::size_t add_face(Face face)
  {
    m_faces.push_back(std::move(face));
    return m_faces.size() - 1;
  }
  /// @}

  /// \name Access
  /// @{
  const std::vector<Point_3>& vertices() const { return m_vertices; }
  const std::vector<Edge>& edges() const { return m_edges; }
  const std::vector<Face>& faces() const { return m_faces; }
  std::vector<Face>& faces() { return m_faces; }
  /// @}
};

} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MODEL_3_H
