// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_TRIANGLE_MESH_QUALITY_H
#define CGAL_TRIANGLE_MESH_QUALITY_H

#include <CGAL/Parametric_surface_mesh_error.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
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

/*!
\ingroup PkgParametricSurfaceMesherQuality

How far a mesh lies from its parametric surface, as measured by `triangle_mesh_deviation()`.

The deviation ratio of an edge is `gamma = H/L`, with the length `L` of the edge and the distance `H`
to the edge's line of the surface point in the middle of the edge in the domain.
*/
struct Triangle_mesh_deviation
{
  double max_inner_deviation_ratio = 0;  ///< the largest deviation ratio of the edges of two faces
  double max_border_deviation_ratio = 0; ///< the largest deviation ratio of the edges of one face
  std::size_t number_of_skipped_edges = 0; ///< edges of length 0 or below the minimum, in neither of the two
  double max_distance_to_face = 0;       ///< the largest distance of a sampled surface point to its face
  double max_distance_to_vertex = 0;     ///< the largest distance of a vertex to the surface point with its parameters
  std::size_t number_of_inverted_faces = 0; ///< faces with the normal against `S_u x S_v` at the centroid
  std::size_t number_of_domain_violations = 0; ///< faces that are not counterclockwise in the domain
};

namespace Parametric_surface_mesher {
namespace internal {

template <class Point_3>
bool has_finite_coordinates(const Point_3& p)
{
  return is_finite(p.x()) && is_finite(p.y()) && is_finite(p.z());
}

// The initial values are those of a degenerate triangle.
struct Shape_of_triangle
{
  double min_angle = 0, max_angle = 180, radius_ratio = 0, area = 0;
  bool is_degenerate = true;
};

template <class Geom_traits>
Shape_of_triangle shape_of_triangle(const typename Geom_traits::Point_3& p,
                                    const typename Geom_traits::Point_3& q,
                                    const typename Geom_traits::Point_3& r,
                                    const Geom_traits& traits)
{
  Shape_of_triangle shape;
  if(!has_finite_coordinates(p) || !has_finite_coordinates(q) || !has_finite_coordinates(r)
     || traits.collinear_3_object()(p, q, r))
    return shape;

  const auto vector = traits.construct_vector_3_object();
  const std::array<typename Geom_traits::Vector_3, 3> side = {{vector(q, r), vector(r, p), vector(p, q)}};
  std::array<double, 3> length;
  for(std::size_t i = 0; i < 3; ++i)
    length[i] = std::sqrt(traits.compute_squared_length_3_object()(side[i]));

  // the product of the two shorter sides loses least to rounding, which a needle needs
  const std::size_t longest = std::max_element(length.begin(), length.end()) - length.begin();
  const std::size_t i = (longest + 1) % 3, j = (longest + 2) % 3;
  const double twice_area = std::sqrt(traits.compute_squared_length_3_object()(
    traits.construct_cross_product_vector_3_object()(side[i], side[j])));

  shape = {180, 0, 0, twice_area / 2, false};
  for(std::size_t k = 0; k < 3; ++k)
  {
    const double cosine_part = -traits.compute_scalar_product_3_object()(side[(k + 1) % 3], side[(k + 2) % 3]);
    const double angle = std::atan2(twice_area, cosine_part) * 180 / CGAL_PI;
    shape.min_angle = (std::min)(shape.min_angle, angle);
    shape.max_angle = (std::max)(shape.max_angle, angle);
  }
  // 2r/R = 16 area^2 / (perimeter * product of the sides), as two factors that stay in the range of double
  const double perimeter = length[0] + length[1] + length[2];
  shape.radius_ratio = 4 * (twice_area / (length[i] * length[j])) * (twice_area / (length[longest] * perimeter));
  return shape;
}

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

// The connectivity of triangles that need not form a surface mesh: their corners are united to fans
// across every edge of exactly two triangles. Corner `i` of triangle `t` is `3t+i`.
class Triangle_soup_connectivity
{
  struct Edge_use
  {
    std::size_t source, target; // points, in increasing order
    std::size_t source_corner, target_corner;

    friend bool operator<(const Edge_use& a, const Edge_use& b)
    {
      return std::tie(a.source, a.target, a.source_corner) < std::tie(b.source, b.target, b.source_corner);
    }
    bool is_same_edge(const Edge_use& other) const { return source == other.source && target == other.target; }
  };
  typedef std::vector<Edge_use>::const_iterator Edge_use_iterator;
  typedef boost::disjoint_sets_with_storage<> Partition;

  std::vector<std::size_t> m_points; // of the corners
  std::vector<Edge_use> m_uses;
  Partition m_fans, m_components;

public:
  // `points` has the three points of each triangle, one after the other
  explicit Triangle_soup_connectivity(const std::vector<std::size_t>& points)
    : m_points(points), m_fans(points.size()), m_components(points.size() / 3)
  {
    for(std::size_t corner = 0; corner < points.size(); ++corner)
      add_edge_use(corner, corner % 3 == 2 ? corner - 2 : corner + 1);
    std::sort(m_uses.begin(), m_uses.end());
  }

  // Calls `visit(source, target)` for each edge and adds the numbers about connectivity to `quality`.
  template <class Visitor>
  void measure(Triangle_mesh_quality& quality, const Visitor& visit)
  {
    std::vector<Edge_use> border;
    for(Edge_use_iterator first = m_uses.begin(), last; first != m_uses.end(); first = last)
    {
      last = std::find_if(first, m_uses.cend(), [first](const Edge_use& e) { return !e.is_same_edge(*first); });
      visit(first->source, first->target);
      unite_across(first, last);
      if(last - first == 1)
        border.push_back(*first);
      else if(last - first > 2)
        ++quality.number_of_non_manifold_edges;
    }
    quality.number_of_border_edges = border.size();
    count_fans(quality);
    quality.number_of_boundary_cycles = number_of_chains(border);
    for(std::size_t t = 0; t < m_points.size() / 3; ++t)
      quality.number_of_connected_components += m_components.find_set(t) == t;
  }

private:
  void add_edge_use(std::size_t a, std::size_t b)
  {
    if(m_points[a] == m_points[b]) // a triangle with a repeated point
      return;
    if(m_points[a] > m_points[b])
      std::swap(a, b);
    m_uses.push_back({m_points[a], m_points[b], a, b});
  }

  void unite_across(Edge_use_iterator first, Edge_use_iterator last)
  {
    for(Edge_use_iterator use = first + 1; use < last; ++use)
      m_components.union_set(first->source_corner / 3, use->source_corner / 3);
    if(last - first != 2)
      return;
    const Edge_use_iterator second = first + 1;
    m_fans.union_set(first->source_corner, second->source_corner);
    m_fans.union_set(first->target_corner, second->target_corner);
  }

  void count_fans(Triangle_mesh_quality& quality)
  {
    std::vector<std::size_t> fans(quality.number_of_vertices, 0);
    for(std::size_t corner = 0; corner < m_points.size(); ++corner)
      fans[m_points[corner]] += m_fans.find_set(corner) == corner;
    for(std::size_t number : fans)
    {
      quality.number_of_isolated_vertices += number == 0;
      quality.number_of_non_manifold_vertices += number > 1;
    }
  }

  // the chains that `border` forms, where two edges are joined by the fan between them
  std::size_t number_of_chains(const std::vector<Edge_use>& border)
  {
    Partition chains(m_points.size());
    for(const Edge_use& edge : border)
      chains.union_set(m_fans.find_set(edge.source_corner), m_fans.find_set(edge.target_corner));
    std::set<std::size_t> roots;
    for(const Edge_use& edge : border)
      roots.insert(chains.find_set(m_fans.find_set(edge.source_corner)));
    return roots.size();
  }
};

// The three points of each triangle of a soup, one after the other.
template <class TriangleRange>
std::vector<std::size_t> corners_of_soup(std::size_t number_of_points, const TriangleRange& triangles)
{
  std::vector<std::size_t> corners;
  std::size_t t = 0;
  for(const auto& triangle : triangles)
  {
    for(const auto& index : triangle)
      corners.push_back(static_cast<std::size_t>(index));
    if(corners.size() != 3 * (t + 1))
      throw Parametric_surface_mesh_error("face " + std::to_string(t) + " of the soup has not three points");
    if(*std::max_element(corners.end() - 3, corners.end()) >= number_of_points)
      throw Parametric_surface_mesh_error("triangle " + std::to_string(t) + " of the soup has a point index that is "
                                          "not below the number of points " + std::to_string(number_of_points));
    ++t;
  }
  return corners;
}

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

/*!
\ingroup PkgParametricSurfaceMesherQuality

measures how far a mesh lies from its parametric surface. Nothing is taken over from the mesher.

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

#endif // CGAL_TRIANGLE_MESH_QUALITY_H
