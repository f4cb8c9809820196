// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TRIANGLE_MESH_QUALITY_H
#define CGAL_TRIANGLE_MESH_QUALITY_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesher/internal/measures/Shape_of_triangle.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Triangle_soup_connectivity.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/corners_of_soup.h>
#include <CGAL/Parametric_surface_mesher/internal/support/has_finite_coordinates.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherQuality

The shape and the connectivity of a triangle mesh in numbers, as measured by `triangle_mesh_quality()` and
`triangle_soup_quality()`. Angles are in degrees and measured in space. All numbers are 0 for an empty mesh.

A *degenerate* face has three collinear vertices (the test is that of the kernel) or one
with a coordinate that is not finite. It counts with the angles 0 and 180, radius ratio 0 and area 0.
*/
struct Triangle_mesh_quality
{
  /// \name Size
  /// @{
  std::size_t number_of_vertices = 0; ///< isolated ones included
  std::size_t number_of_edges = 0;
  std::size_t number_of_faces = 0;
  double area = 0;
  /// @}

  /// \name Shape
  /// @{
  double min_angle = 0;              ///< the smallest angle of all faces
  double mean_min_angle = 0;         ///< the mean over the faces of the smallest angle of each
  double max_angle = 0;              ///< the largest angle of all faces
  double share_below_10_degrees = 0; ///< the share, from 0 to 1, of faces with an angle below 10 degrees
  double share_below_20_degrees = 0; ///< the same for 20 degrees
  double share_below_30_degrees = 0; ///< the same for 30 degrees
  double min_radius_ratio = 0;       ///< the smallest `2r/R` of inscribed and circumscribed circle: 1 if equilateral
  double mean_radius_ratio = 0;      ///< the mean of `2r/R` over the faces
  double min_edge_length = 0;        ///< over the edges with finite end points, as the next two
  double mean_edge_length = 0;
  double max_edge_length = 0;
  std::size_t number_of_degenerate_faces = 0;
  /// @}

  /// \name Connectivity
  /// @{
  std::size_t number_of_border_edges = 0;         ///< edges of one face
  std::size_t number_of_boundary_cycles = 0;      ///< closed chains of border edges
  std::size_t number_of_connected_components = 0; ///< sets of faces connected through edges
  std::size_t number_of_isolated_vertices = 0;    ///< vertices of no face
  std::size_t number_of_non_manifold_edges = 0;   ///< edges of more than two faces: only in a soup
  std::size_t number_of_non_manifold_vertices = 0; ///< vertices whose faces do not form a single fan
  std::ptrdiff_t euler_characteristic = 0;        ///< vertices - edges + faces, isolated vertices included
  bool is_closed = true;                          ///< tells whether there is no border edge
  bool is_manifold = true;                        ///< tells whether there is no non-manifold edge or vertex
  /// @}
};

namespace Parametric_surface_mesher {
namespace internal {

// Gathers the numbers about size and shape, one face and one edge at a time.
template <class Geom_traits>
class Shape_statistics
{
  typedef typename Geom_traits::Point_3 Point_3;

  const Geom_traits& m_traits;
  Triangle_mesh_quality& m_quality;
  std::size_t m_measured_edges = 0;
  std::array<std::size_t, 3> m_faces_below = {{0, 0, 0}};

public:
  Shape_statistics(const Geom_traits& traits, Triangle_mesh_quality& quality)
    : m_traits(traits), m_quality(quality)
  {}

  void add_face(const Point_3& p, const Point_3& q, const Point_3& r)
  {
    const Shape_of_triangle shape = shape_of_triangle(p, q, r, m_traits);
    const bool is_first = m_quality.number_of_faces++ == 0;
    m_quality.area += shape.area;
    m_quality.mean_min_angle += shape.min_angle;
    m_quality.mean_radius_ratio += shape.radius_ratio;
    m_quality.number_of_degenerate_faces += shape.is_degenerate;
    m_quality.max_angle = (std::max)(m_quality.max_angle, shape.max_angle);
    m_quality.min_angle = is_first ? shape.min_angle : (std::min)(m_quality.min_angle, shape.min_angle);
    m_quality.min_radius_ratio = is_first ? shape.radius_ratio
                                          : (std::min)(m_quality.min_radius_ratio, shape.radius_ratio);
    for(std::size_t i = 0; i < 3; ++i)
      m_faces_below[i] += shape.min_angle < 10. * (i + 1);
  }

  void add_edge(const Point_3& p, const Point_3& q)
  {
    ++m_quality.number_of_edges;
    if(!has_finite_coordinates(p) || !has_finite_coordinates(q))
      return;
    const double length = std::sqrt(m_traits.compute_squared_distance_3_object()(p, q));
    m_quality.min_edge_length = m_measured_edges == 0 ? length : (std::min)(m_quality.min_edge_length, length);
    m_quality.max_edge_length = (std::max)(m_quality.max_edge_length, length);
    m_quality.mean_edge_length += length;
    ++m_measured_edges;
  }

  // Turns the sums into means and shares.
  void finish()
  {
    if(m_measured_edges != 0)
      m_quality.mean_edge_length /= m_measured_edges;
    if(m_quality.number_of_faces == 0)
      return;
    const double faces = static_cast<double>(m_quality.number_of_faces);
    m_quality.mean_min_angle /= faces;
    m_quality.mean_radius_ratio /= faces;
    m_quality.share_below_10_degrees = m_faces_below[0] / faces;
    m_quality.share_below_20_degrees = m_faces_below[1] / faces;
    m_quality.share_below_30_degrees = m_faces_below[2] / faces;
  }
};

inline void deduce_topology(Triangle_mesh_quality& quality)
{
  quality.euler_characteristic = static_cast<std::ptrdiff_t>(quality.number_of_vertices + quality.number_of_faces)
                                 - static_cast<std::ptrdiff_t>(quality.number_of_edges);
  quality.is_closed = quality.number_of_border_edges == 0;
  quality.is_manifold = quality.number_of_non_manifold_edges == 0 && quality.number_of_non_manifold_vertices == 0;
}

template <class TriangleMesh>
void measure_connectivity(const TriangleMesh& tm, Triangle_mesh_quality& quality)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  namespace PMP = Polygon_mesh_processing;

  for(vertex_descriptor v : vertices(tm))
  {
    ++quality.number_of_vertices;
    quality.number_of_isolated_vertices += halfedge(v, tm) == boost::graph_traits<TriangleMesh>::null_halfedge();
  }
  for(halfedge_descriptor h : halfedges(tm))
    quality.number_of_border_edges += is_border(h, tm);

  std::vector<halfedge_descriptor> found;
  PMP::extract_boundary_cycles(tm, std::back_inserter(found));
  quality.number_of_boundary_cycles = found.size();

  found.clear();
  PMP::non_manifold_vertices(tm, std::back_inserter(found));
  std::set<vertex_descriptor> non_manifold; // a vertex is found once for each of its fans
  for(halfedge_descriptor h : found)
    non_manifold.insert(target(h, tm));
  quality.number_of_non_manifold_vertices = non_manifold.size();

  quality.number_of_connected_components
    = PMP::connected_components(tm, get(dynamic_face_property_t<std::size_t>(), tm));
}

} // namespace internal
} // namespace Parametric_surface_mesher

/*!
\ingroup PkgParametricSurfaceMesherQuality

measures the shape and the connectivity of a triangle mesh.

Angles are computed from the cross and scalar products of the sides, and so are accurate for needles too.

\tparam TriangleMesh a model of `HalfedgeListGraph` and `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
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
    \cgalParamExtra{Degenerate faces are found exactly if its predicates are exact.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre all faces of `tm` are triangles

\sa `triangle_soup_quality()`
\sa `triangle_mesh_deviation()`
*/
template <class TriangleMesh, class CGAL_NP_TEMPLATE_PARAMETERS>
Triangle_mesh_quality triangle_mesh_quality(const TriangleMesh& tm,
                                            const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef typename GetGeomTraits<TriangleMesh, CGAL_NP_CLASS>::type Geom_traits;
  using parameters::choose_parameter;
  using parameters::get_parameter;

  CGAL_precondition(is_triangle_mesh(tm));
  const Geom_traits traits = choose_parameter<Geom_traits>(get_parameter(np, internal_np::geom_traits));
  const auto point = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                      get_const_property_map(vertex_point, tm));
  Triangle_mesh_quality quality;
  Parametric_surface_mesher::internal::Shape_statistics<Geom_traits> statistics(traits, quality);
  for(auto f : faces(tm))
  {
    const auto h = halfedge(f, tm);
    statistics.add_face(get(point, source(h, tm)), get(point, target(h, tm)), get(point, target(next(h, tm), tm)));
  }
  for(auto e : edges(tm))
    statistics.add_edge(get(point, source(e, tm)), get(point, target(e, tm)));
  statistics.finish();
  Parametric_surface_mesher::internal::measure_connectivity(tm, quality);
  Parametric_surface_mesher::internal::deduce_topology(quality);
  return quality;
}

/*!
\ingroup PkgParametricSurfaceMesherQuality

measures the shape and the connectivity of triangles given by indices, which need not form a surface mesh.

The numbers are those of `triangle_mesh_quality()`. Edges of more than two triangles are non-manifold, as are their
end points; triangles are connected across them, and a chain of border edges that ends there counts as a boundary
cycle. The orientation of the triangles plays no role.

\tparam PointRange a model of `RandomAccessContainer` whose value type is the point type
\tparam TriangleRange a model of `ConstRange` whose value type is a model of `ConstRange` of three indices
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points
\param triangles the triangles: indices of their points in `points`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class model of `Kernel` with `double` as number type}
    \cgalParamDefault{a \cgal Kernel deduced from the point type, using `CGAL::Kernel_traits`}
    \cgalParamExtra{Degenerate faces are found exactly if its predicates are exact.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Parametric_surface_mesh_error if a face has not three indices or an index is not below `points.size()`
*/
template <class PointRange, class TriangleRange, class CGAL_NP_TEMPLATE_PARAMETERS>
Triangle_mesh_quality triangle_soup_quality(const PointRange& points, const TriangleRange& triangles,
                                            const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef typename Kernel_traits<typename PointRange::value_type>::Kernel Kernel;
  typedef typename internal_np::Lookup_named_param_def<internal_np::geom_traits_t, CGAL_NP_CLASS, Kernel>::type
    Geom_traits;
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const std::vector<std::size_t> corners
    = Parametric_surface_mesher::internal::corners_of_soup(points.size(), triangles);
  const Geom_traits traits = choose_parameter<Geom_traits>(get_parameter(np, internal_np::geom_traits));
  Triangle_mesh_quality quality;
  quality.number_of_vertices = points.size();
  Parametric_surface_mesher::internal::Shape_statistics<Geom_traits> statistics(traits, quality);
  for(std::size_t i = 0; i < corners.size(); i += 3)
    statistics.add_face(points[corners[i]], points[corners[i + 1]], points[corners[i + 2]]);
  Parametric_surface_mesher::internal::Triangle_soup_connectivity(corners).measure(
    quality, [&](std::size_t a, std::size_t b) { statistics.add_edge(points[a], points[b]); });
  statistics.finish();
  Parametric_surface_mesher::internal::deduce_topology(quality);
  return quality;
}

} // namespace CGAL

#endif // CGAL_TRIANGLE_MESH_QUALITY_H
