// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes of test patches, and measures of their triangles that share no code with the mesher.
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_MESHER_TEST_HELPERS_H
#define PARAMETRIC_SURFACE_MESHER_TEST_MESHER_TEST_HELPERS_H

#include <CGAL/Surface_mesh.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <surface_test_helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

typedef Test_kernel::Point_2 Point_2;
typedef Test_kernel::Vector_2 Vector_2;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, Point_2> Uv_map;
typedef CGAL::Parametric_domain_2<Test_kernel> Domain;
typedef CGAL::Domain_curve_2<Test_kernel> Curve;
typedef CGAL::Parametric_surface_mesh_criteria Criteria;
typedef CGAL::Parametric_surface_mesh_report Report;

// The domain points of a mesh; the map is added if there is none.
inline Uv_map uv_map(Mesh& mesh) { return mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv", Point_2(0, 0)).first; }

// what Surface_mesh::property_map() returns in CGAL 5, and in CGAL 6
inline Uv_map value_of(const std::pair<Uv_map, bool>& found) { return found.first; }
inline Uv_map value_of(const std::optional<Uv_map>& found) { return found.value(); }

inline Uv_map uv_map(const Mesh& mesh) { return value_of(mesh.property_map<Mesh::Vertex_index, Point_2>("v:uv")); }

// Adds the mesh of a patch to `mesh`, with its domain points.
template <class Surface, class AnyCriteria, class... Parameters>
Report add_patch(const Surface& surface, const Domain& domain, const AnyCriteria& criteria, Mesh& mesh,
                 const Parameters&... parameters)
{
  return CGAL::make_parametric_surface_mesh(surface, domain, criteria, mesh,
                                            CGAL::parameters::vertex_uv_map(uv_map(mesh), parameters...));
}

inline std::array<Mesh::Vertex_index, 3> corners(const Mesh& mesh, Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
}

inline double distance(const Point_3& p, const Point_3& q) { return std::sqrt((q - p).squared_length()); }

inline double length(const Mesh& mesh, Mesh::Edge_index e)
{
  return distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
}

// A triangle in space; angles in degrees.
struct Triangle_shape
{
  double min_angle = 180, circumradius = 0, shortest = 0, longest = 0;
};

inline double angle_at(const Point_3& p, const Point_3& q, const Point_3& r)
{
  const Vector_3 a = q - p, b = r - p;
  return std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b) * 45 / std::atan(1.);
}

inline Triangle_shape shape(const Mesh& mesh, Mesh::Face_index f)
{
  const auto v = corners(mesh, f);
  const Point_3 &p = mesh.point(v[0]), &q = mesh.point(v[1]), &r = mesh.point(v[2]);
  const double a = distance(q, r), b = distance(r, p), c = distance(p, q);
  Triangle_shape result;
  result.min_angle = (std::min)({angle_at(p, q, r), angle_at(q, r, p), angle_at(r, p, q)});
  result.circumradius = a * b * c / (2 * std::sqrt(cross_product(q - p, r - p).squared_length()));
  result.shortest = (std::min)({a, b, c});
  result.longest = (std::max)({a, b, c});
  return result;
}

// The height H of the surface over an edge: the distance from its line of the surface point at its middle in the domain.
template <class Surface>
double height(const Mesh& mesh, Mesh::Edge_index e, const Surface& surface)
{
  const Uv_map uv = uv_map(mesh);
  const Mesh::Vertex_index v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
  const Point_2 middle = CGAL::midpoint(uv[v], uv[w]);
  const Vector_3 chord = mesh.point(w) - mesh.point(v);
  const Vector_3 to_surface = surface.point(middle.x(), middle.y()) - mesh.point(v);
  return std::sqrt(cross_product(chord, to_surface).squared_length() / chord.squared_length());
}

// The largest ratio H/L of the edges of a face.
template <class Surface>
double deviation(const Mesh& mesh, Mesh::Face_index f, const Surface& surface)
{
  double result = 0;
  for(const auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
    result = (std::max)(result, height(mesh, mesh.edge(h), surface) / length(mesh, mesh.edge(h)));
  return result;
}

// The distance of the surface from a face, at the middles of its edges and at the centroid.
template <class Surface>
double distance_to_surface(const Mesh& mesh, Mesh::Face_index f, const Surface& surface)
{
  double result = 0;
  for(const auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
    result = (std::max)(result, height(mesh, mesh.edge(h), surface));
  const Uv_map uv = uv_map(mesh);
  const auto v = corners(mesh, f);
  const Point_2 center = CGAL::centroid(uv[v[0]], uv[v[1]], uv[v[2]]);
  const Vector_3 normal = cross_product(mesh.point(v[1]) - mesh.point(v[0]), mesh.point(v[2]) - mesh.point(v[0]));
  const double above = normal * (surface.point(center.x(), center.y()) - mesh.point(v[0]));
  return (std::max)(result, std::fabs(above) / std::sqrt(normal.squared_length()));
}

// The same at many places of the edges and of the face.
template <class Surface>
double largest_distance_to_surface(const Mesh& mesh, Mesh::Face_index f, const Surface& surface)
{
  const int parts = 24;
  const Uv_map uv = uv_map(mesh);
  const auto v = corners(mesh, f);
  const Vector_3 normal = cross_product(mesh.point(v[1]) - mesh.point(v[0]), mesh.point(v[2]) - mesh.point(v[0]));
  double result = 0;
  for(int i = 1; i < parts; ++i)
    for(int k = 1; i + k < parts; ++k) {
      const Point_2 p = CGAL::barycenter(uv[v[0]], double(i), uv[v[1]], double(k), uv[v[2]], double(parts - i - k));
      const double above = normal * (surface.point(p.x(), p.y()) - mesh.point(v[0]));
      result = (std::max)(result, std::fabs(above) / std::sqrt(normal.squared_length()));
    }
  for(const auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
    for(int i = 1; i < parts; ++i) {
      const Mesh::Vertex_index a = mesh.source(h), b = mesh.target(h);
      const Point_2 p = CGAL::barycenter(uv[a], double(i), uv[b], double(parts - i));
      const Test_kernel::Line_3 line(mesh.point(a), mesh.point(b));
      result = (std::max)(result, std::sqrt(CGAL::squared_distance(surface.point(p.x(), p.y()), line)));
    }
  return result;
}

// Whether a face has a vertex on the border.
inline bool touches_border(const Mesh& mesh, Mesh::Face_index f)
{
  const auto v = corners(mesh, f);
  return std::any_of(v.begin(), v.end(), [&](Mesh::Vertex_index w) { return mesh.is_border(w); });
}

// How many faces are not counterclockwise in the domain, exactly.
inline std::size_t number_of_inverted_faces(const Mesh& mesh)
{
  const Uv_map uv = uv_map(mesh);
  return std::count_if(mesh.faces_begin(), mesh.faces_end(), [&](Mesh::Face_index f) {
    const auto v = corners(mesh, f);
    return CGAL::orientation(uv[v[0]], uv[v[1]], uv[v[2]]) != CGAL::LEFT_TURN;
  });
}

inline std::map<std::size_t, Report::Unmet> unmet_by_face(const Report& report)
{
  std::map<std::size_t, Report::Unmet> result;
  for(const auto& unmet : report.unmet)
    EXPECT_TRUE(result.emplace(unmet.face, unmet).second) << "face " << unmet.face << " is listed twice";
  return result;
}

// The triangles that fail a criterion, apart from those that are too far from the surface and are left so only because their edges
// are too short to be divided.
inline std::size_t number_of_unmet_but_at_short_edges(const Report& report)
{
  using namespace CGAL::Parametric_surface_mesher;
  const Criterion_set by_deviation = Criterion_set(Mesh_criterion::DEVIATION) | Mesh_criterion::DISTANCE;
  return std::size_t(std::count_if(report.unmet.begin(), report.unmet.end(), [&](const Report::Unmet& unmet) {
    return unmet.cause != Unmet_cause::MINIMUM_EDGE || (unmet.criteria | by_deviation) != by_deviation;
  }));
}

#endif // PARAMETRIC_SURFACE_MESHER_TEST_MESHER_TEST_HELPERS_H
