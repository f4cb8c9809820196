// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TRIANGLE_MESH_DEVIATION_H
#define CGAL_TRIANGLE_MESH_DEVIATION_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/support/has_finite_coordinates.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherQuality

How far a mesh lies from its parametric surface, as measured by `triangle_mesh_deviation()`.

The deviation ratio of an edge is `gamma = H/L`, with the length `L` of the edge and the distance `H`
to the edge's line of the surface point in the middle of the edge in the domain.
*/
struct Triangle_mesh_deviation
{
  double max_inner_deviation_ratio = 0;  ///< the largest deviation ratio of the edges of two faces
  /// the same with the part of `H` along the surface normal alone: the rest tells how far the image of the straight domain
  /// line bends within the surface, as it does around a pole however short the edge is
  double max_inner_normal_deviation_ratio = 0;
  double max_border_deviation_ratio = 0; ///< the largest deviation ratio of the edges of one face
  std::size_t number_of_skipped_edges = 0; ///< edges of length 0 or below the minimum, in neither of the two
  double max_distance_to_face = 0;       ///< the largest distance of a sampled surface point to its face
  double max_distance_to_vertex = 0;     ///< the largest distance of a vertex to the surface point with its parameters
  std::size_t number_of_inverted_faces = 0; ///< faces with the normal against `S_u x S_v` at the centroid
  std::size_t number_of_domain_violations = 0; ///< faces that are not counterclockwise in the domain
};

namespace Parametric_surface_mesher {
namespace internal {

// Measures a mesh against its surface with evaluations of its own, independent of how the mesh was made.
template <class Surface, class Geom_traits>
class Deviation_from_surface
{
  typedef typename Geom_traits::Point_2 Point_2;
  typedef typename Geom_traits::Point_3 Point_3;
  typedef typename Geom_traits::Vector_3 Vector_3;

public:
  // A mesh vertex: its parameters and its point.
  struct Vertex
  {
    Point_2 uv;
    Point_3 point;
  };

private:
  const Surface& m_surface;
  const Geom_traits& m_traits;
  unsigned int m_subdivisions;
  double m_min_edge_length;
  Triangle_mesh_deviation m_deviation;

public:
  Deviation_from_surface(const Surface& surface, const Geom_traits& traits,
                         unsigned int subdivisions, double min_edge_length)
    : m_surface(surface), m_traits(traits), m_subdivisions(subdivisions), m_min_edge_length(min_edge_length)
  {}

  const Triangle_mesh_deviation& deviation() const { return m_deviation; }

  void add_vertex(const Vertex& p)
  {
    check(is_finite(p.uv.x()) && is_finite(p.uv.y()) && has_finite_coordinates(p.point),
          "the mesh has a vertex that is not finite", p.uv.x(), p.uv.y());
    const double squared = m_traits.compute_squared_distance_3_object()(p.point, surface_point(p.uv.x(), p.uv.y()));
    raise(m_deviation.max_distance_to_vertex, std::sqrt(squared));
  }

  void add_edge(const Vertex& p, const Vertex& q, bool is_border)
  {
    const Vector_3 chord = m_traits.construct_vector_3_object()(p.point, q.point);
    const double length = norm(chord);
    if(length == 0 || length < m_min_edge_length)
    {
      ++m_deviation.number_of_skipped_edges;
      return;
    }
    const Point_3 middle = surface_point((p.uv.x() + q.uv.x()) / 2, (p.uv.y() + q.uv.y()) / 2);
    const Vector_3 moment = cross(chord, m_traits.construct_vector_3_object()(p.point, middle));
    raise(is_border ? m_deviation.max_border_deviation_ratio : m_deviation.max_inner_deviation_ratio,
          norm(moment) / length / length);
    if(!is_border)
      raise(m_deviation.max_inner_normal_deviation_ratio, height_along_normal(p, q, chord, middle) / length);
  }

  void add_face(const Vertex& p, const Vertex& q, const Vertex& r)
  {
    m_deviation.number_of_domain_violations += m_traits.orientation_2_object()(p.uv, q.uv, r.uv) != POSITIVE;
    m_deviation.number_of_inverted_faces += is_inverted(p, q, r);

    const auto triangle = m_traits.construct_triangle_3_object()(p.point, q.point, r.point);
    const double n = m_subdivisions;
    for(unsigned int i = 0; i <= m_subdivisions; ++i)
      for(unsigned int j = 0; i + j <= m_subdivisions; ++j)
      {
        const double a = i / n, b = j / n, c = (m_subdivisions - i - j) / n;
        const Point_3 sample = surface_point(a * p.uv.x() + b * q.uv.x() + c * r.uv.x(),
                                             a * p.uv.y() + b * q.uv.y() + c * r.uv.y());
        raise(m_deviation.max_distance_to_face,
              std::sqrt(m_traits.compute_squared_distance_3_object()(sample, triangle)));
      }
  }

private:
  // Of the vector from the edge's line to the surface point over its middle, the part along the normal there.
  double height_along_normal(const Vertex& p, const Vertex& q, const Vector_3& chord, const Point_3& middle) const
  {
    const auto jet = m_surface.jet((p.uv.x() + q.uv.x()) / 2, (p.uv.y() + q.uv.y()) / 2);
    const Vector_3 normal = cross(jet.du, jet.dv), side = middle - p.point;
    const Vector_3 height = side - (side * chord) / (chord * chord) * chord;
    return norm(normal) > 0 ? std::fabs(height * normal) / norm(normal) : norm(height);
  }

  static void raise(double& largest, double value) { largest = (std::max)(largest, value); }

  static void check(bool is_good, const char* what, double u, double v)
  {
    if(is_good)
      return;
    std::ostringstream message;
    message.precision(17);
    message << what << " at (u,v) = (" << u << ", " << v << ")";
    throw Parametric_surface_mesh_error(message.str());
  }

  Vector_3 cross(const Vector_3& a, const Vector_3& b) const
  {
    return m_traits.construct_cross_product_vector_3_object()(a, b);
  }

  double norm(const Vector_3& a) const { return std::sqrt(m_traits.compute_squared_length_3_object()(a)); }

  Point_3 surface_point(double u, double v) const
  {
    const auto p = m_surface.point(u, v);
    check(has_finite_coordinates(p), "the surface point is not finite", u, v);
    return Point_3(p.x(), p.y(), p.z());
  }

  bool is_inverted(const Vertex& p, const Vertex& q, const Vertex& r) const
  {
    const double u = (p.uv.x() + q.uv.x() + r.uv.x()) / 3, v = (p.uv.y() + q.uv.y() + r.uv.y()) / 3;
    const auto jet = m_surface.jet(u, v);
    check(has_finite_coordinates(jet.du) && has_finite_coordinates(jet.dv),
          "the derivatives of the surface are not finite", u, v);
    const auto vector = m_traits.construct_vector_3_object();
    const Vector_3 face_normal = cross(vector(p.point, q.point), vector(p.point, r.point));
    const Vector_3 surface_normal = cross(Vector_3(jet.du.x(), jet.du.y(), jet.du.z()),
                                          Vector_3(jet.dv.x(), jet.dv.y(), jet.dv.z()));
    return m_traits.compute_scalar_product_3_object()(face_normal, surface_normal) < 0;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher

/*!
\ingroup PkgParametricSurfaceMesherQuality

measures how far a mesh lies from its parametric surface, independently of the mesher.

The surface is sampled at the points whose barycentric coordinates in a domain triangle are
multiples of `1/subdivisions`: `(subdivisions+1)(subdivisions+2)/2` points for each face, its corners and points
on its edges among them.

One vertex has one pair of parameters: where a periodic surface closes, its vertices must not be merged.

\tparam TriangleMesh a model of `HalfedgeListGraph` and `FaceListGraph`
\tparam Surface a model of `ParametricSurface_3`
\tparam ParameterMap a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
        as key type and `%Point_2` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param surface the surface
\param uv_map the parameters `(u,v)` of each vertex
\param subdivisions the number of pieces into which a side of a triangle is cut for sampling
\param min_edge_length edges that are shorter, or of length 0, have no deviation ratio
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
                   as key type and `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd

  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class model of `Kernel` with `double` as number type}
    \cgalParamDefault{a \cgal Kernel deduced from the point type, using `CGAL::Kernel_traits`}
    \cgalParamExtra{The orientation of faces in the domain is exact if its predicates are.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre all faces of `tm` are triangles, and `subdivisions >= 1`

\throws Parametric_surface_mesh_error if a vertex or a value of the surface is not finite
*/
template <class TriangleMesh, class Surface, class ParameterMap, class CGAL_NP_TEMPLATE_PARAMETERS>
Triangle_mesh_deviation triangle_mesh_deviation(const TriangleMesh& tm, const Surface& surface,
                                                const ParameterMap& uv_map,
                                                unsigned int subdivisions = 8, double min_edge_length = 0,
                                                const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename GetGeomTraits<TriangleMesh, CGAL_NP_CLASS>::type Geom_traits;
  typedef Parametric_surface_mesher::internal::Deviation_from_surface<Surface, Geom_traits> Deviation;
  using parameters::choose_parameter;
  using parameters::get_parameter;

  CGAL_precondition(is_triangle_mesh(tm) && subdivisions >= 1);
  const Geom_traits traits = choose_parameter<Geom_traits>(get_parameter(np, internal_np::geom_traits));
  const auto point = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                      get_const_property_map(vertex_point, tm));
  const auto vertex = [&](vertex_descriptor v) { return typename Deviation::Vertex{get(uv_map, v), get(point, v)}; };

  Deviation deviation(surface, traits, subdivisions, min_edge_length);
  for(auto v : vertices(tm))
    deviation.add_vertex(vertex(v));
  for(auto e : edges(tm))
    deviation.add_edge(vertex(source(e, tm)), vertex(target(e, tm)), is_border(e, tm));
  for(auto f : faces(tm))
  {
    const auto h = halfedge(f, tm);
    deviation.add_face(vertex(source(h, tm)), vertex(target(h, tm)), vertex(target(next(h, tm), tm)));
  }
  return deviation.deviation();
}

} // namespace CGAL

#endif // CGAL_TRIANGLE_MESH_DEVIATION_H
