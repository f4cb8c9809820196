// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hard input for the mesher, and checks of what comes out that share no code with it.
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_STRESS_TEST_HELPERS_H
#define PARAMETRIC_SURFACE_MESHER_TEST_STRESS_TEST_HELPERS_H

#include <CGAL/Parametric_function_surface_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <Sample_models.h>
#include <mesher_test_helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <map>
#include <set>
#include <utility>
#include <vector>

typedef Sample_surface_model Model;
typedef sample_surfaces::Patch Patch;
typedef std::array<std::size_t, 3> Triangle;

using sample_surfaces::pi;

// the surface of a generic lambda, see Parametric_function_surface_3
template <class Function>
Sample_surface function_surface(Function function)
{
  return Sample_surface(CGAL::make_parametric_function_surface<Test_kernel>(function));
}

// the plane z = 0
inline Sample_surface flat() { return Sample_surface(sample_surfaces::Flat()); }

inline Model model_of_patches(const std::vector<Patch>& patches)
{
  return sample_surface_model(CGAL::make_model_of_rectangular_patches(patches));
}

class Union_find
{
  std::vector<std::size_t> m_parents;

public:
  explicit Union_find(std::size_t n)
  {
    for(std::size_t i = 0; i < n; ++i)
      m_parents.push_back(i);
  }

  std::size_t find(std::size_t i)
  {
    while(m_parents[i] != i)
      i = m_parents[i] = m_parents[m_parents[i]];
    return i;
  }

  void unite(std::size_t i, std::size_t j) { m_parents[find(i)] = find(j); }
};

// How triangles are joined, by the numbers of their vertices alone.
struct Topology
{
  std::size_t components = 0, border_cycles = 0, border_edges = 0;
  std::size_t edges_of_many = 0;    // of more than two triangles
  std::size_t turned_edges = 0;     // of two triangles that run through it in the same direction
  std::size_t vertices_of_fans = 0; // of more than one fan of triangles
  std::size_t isolated_vertices = 0;
  std::ptrdiff_t euler_characteristic = 0;

  bool is_manifold() const { return edges_of_many == 0 && turned_edges == 0 && vertices_of_fans == 0; }
};

// a side of a triangle: from its corner `number` to the next one
struct Triangle_side
{
  std::size_t triangle, number;

  std::size_t corner(std::size_t end) const { return 3 * triangle + (number + end) % 3; }
};

typedef std::map<std::pair<std::size_t, std::size_t>, std::vector<Triangle_side>> Sides_of_edges;

inline Sides_of_edges sides_of_edges(const std::vector<Triangle>& triangles)
{
  Sides_of_edges result;
  for(std::size_t t = 0; t < triangles.size(); ++t)
    for(std::size_t k = 0; k < 3; ++k)
      result[std::minmax(triangles[t][k], triangles[t][(k + 1) % 3])].push_back({t, k});
  return result;
}

class Topology_counter
{
  std::size_t m_number_of_vertices;
  const std::vector<Triangle>& m_triangles;
  const Sides_of_edges m_edges;

public:
  Topology_counter(std::size_t number_of_vertices, const std::vector<Triangle>& triangles)
    : m_number_of_vertices(number_of_vertices), m_triangles(triangles), m_edges(sides_of_edges(triangles))
  {}

  Topology operator()() const
  {
    Topology result;
    result.euler_characteristic = std::ptrdiff_t(m_number_of_vertices + m_triangles.size()) - std::ptrdiff_t(m_edges.size());
    count_edges(result);
    count_components(result);
    count_fans(result);
    return result;
  }

private:
  std::size_t vertex(std::size_t corner) const { return m_triangles[corner / 3][corner % 3]; }

  // border edges are joined to cycles by their ends
  void count_edges(Topology& result) const
  {
    Union_find ends(m_number_of_vertices);
    std::set<std::size_t> on_border;
    for(const auto& edge : m_edges) {
      const auto& sides = edge.second;
      result.edges_of_many += sides.size() > 2;
      result.turned_edges += sides.size() == 2 && vertex(sides[0].corner(0)) == vertex(sides[1].corner(0));
      if(sides.size() != 1)
        continue;
      ++result.border_edges;
      ends.unite(edge.first.first, edge.first.second);
      on_border.insert(edge.first.first);
    }
    std::set<std::size_t> cycles;
    for(std::size_t v : on_border)
      cycles.insert(ends.find(v));
    result.border_cycles = cycles.size();
  }

  void count_components(Topology& result) const
  {
    Union_find joined(m_triangles.size());
    for(const auto& edge : m_edges)
      for(const Triangle_side& side : edge.second)
        joined.unite(side.triangle, edge.second.front().triangle);
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
      result.components += joined.find(t) == t;
  }

  // a fan: corners at one vertex of triangles that are joined by edges there
  void count_fans(Topology& result) const
  {
    Union_find fans(3 * m_triangles.size());
    for(const auto& edge : m_edges)
      for(const Triangle_side& side : edge.second)
        for(std::size_t end : {0, 1}) {
          const bool is_same = vertex(side.corner(0)) == vertex(edge.second.front().corner(0));
          fans.unite(side.corner(end), edge.second.front().corner(is_same ? end : 1 - end));
        }
    std::vector<std::size_t> numbers(m_number_of_vertices);
    for(std::size_t c = 0; c < 3 * m_triangles.size(); ++c)
      numbers[vertex(c)] += fans.find(c) == c;
    for(std::size_t number : numbers) {
      result.vertices_of_fans += number > 1;
      result.isolated_vertices += number == 0;
    }
  }
};

// A mesh with all that is known about it.
struct Meshed
{
  Mesh mesh;
  Report report;
  std::vector<Triangle> triangles;
  std::vector<std::array<Point_2, 3>> corner_points; // in the domain
  std::vector<std::size_t> patch_ids;
  Topology topology;
  double area = 0;

  const Point_3& point(std::size_t v) const { return mesh.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(v))); }

  double min_angle(std::size_t t) const
  {
    const Point_3 &p = point(triangles[t][0]), &q = point(triangles[t][1]), &r = point(triangles[t][2]);
    return (std::min)({angle_at(p, q, r), angle_at(q, r, p), angle_at(r, p, q)});
  }

  double length(std::size_t t, std::size_t side) const
  {
    return distance(point(triangles[t][side]), point(triangles[t][(side + 1) % 3]));
  }

  // its area, in the direction of its normal
  Vector_3 area_vector(std::size_t t) const
  {
    const Point_3& p = point(triangles[t][0]);
    return 0.5 * cross_product(point(triangles[t][1]) - p, point(triangles[t][2]) - p);
  }

  double volume() const { return CGAL::to_double(CGAL::Polygon_mesh_processing::volume(mesh)); }
};

template <class CornerMap, class PatchMap>
void collect_triangles(Meshed& m, const CornerMap& corner_points, const PatchMap& patch_ids)
{
  for(const auto f : m.mesh.faces()) {
    const auto h = m.mesh.halfedge(f), next = m.mesh.next(h), last = m.mesh.next(next);
    m.triangles.push_back({m.mesh.target(h), m.mesh.target(next), m.mesh.target(last)});
    m.corner_points.push_back({corner_points[h], corner_points[next], corner_points[last]});
    m.patch_ids.push_back(patch_ids[f]);
    m.area += std::sqrt(m.area_vector(m.triangles.size() - 1).squared_length());
  }
  m.topology = Topology_counter(m.mesh.number_of_vertices(), m.triangles)();
}

// The report lists all triangles with an angle below the bound, and no other for its angle.
inline void check_listed_angles(const Meshed& m, double bound)
{
  const auto listed = unmet_by_face(m.report);
  std::size_t silent = 0, wrong = 0;
  double smallest = 180;
  for(std::size_t t = 0; t < m.triangles.size(); ++t) {
    const double angle = m.min_angle(t);
    const auto unmet = listed.find(t);
    silent += angle < bound - 1e-6 && unmet == listed.end();
    wrong += angle > bound + 1e-6 && unmet != listed.end() && unmet->second.criteria.contains(CGAL::Parametric_surface_mesher::Mesh_criterion::ANGLE);
    smallest = (std::min)(smallest, angle);
  }
  EXPECT_EQ(0u, silent) << "triangles with an angle below " << bound << " degrees are not in the report";
  EXPECT_EQ(0u, wrong) << "triangles in the report have no angle below " << bound << " degrees";
  EXPECT_TRUE(listed.empty() || listed.rbegin()->first < m.triangles.size());
  EXPECT_NEAR(smallest, m.report.smallest_angle, 1e-6);
}

// A circumradius of 0.28 times three spacings allows no edge longer than 1.68 times the maximum edge.
inline void check_listed_sizes(const Meshed& m, double max_edge)
{
  const auto listed = unmet_by_face(m.report);
  std::size_t silent = 0;
  for(std::size_t t = 0; t < m.triangles.size(); ++t)
    silent += (std::max)({m.length(t, 0), m.length(t, 1), m.length(t, 2)}) > 1.7 * max_edge && listed.count(t) == 0;
  EXPECT_EQ(0u, silent) << "triangles that are too large are not in the report";
}

// Every corner is where its domain point is on the surface of the patch.
inline void check_corner_points(const Meshed& m, const Model& model, double tolerance)
{
  double largest = 0;
  for(std::size_t t = 0; t < m.triangles.size(); ++t)
    for(std::size_t k = 0; k < 3; ++k) {
      ASSERT_LT(m.patch_ids[t], model.faces().size());
      const Point_2& uv = m.corner_points[t][k];
      const Point_3 p = model.faces()[m.patch_ids[t]].surface.point(uv.x(), uv.y());
      largest = (std::max)(largest, distance(p, m.point(m.triangles[t][k])));
    }
  EXPECT_LE(largest, tolerance) << "the domain point of a corner is not its own";
}

// On the whole, the triangles of a face of the model face to its side.
inline void check_sides(const Meshed& m, const Model& model)
{
  std::vector<double> sums(model.faces().size());
  for(std::size_t t = 0; t < m.triangles.size(); ++t) {
    const auto& face = model.faces()[m.patch_ids[t]];
    const Point_2 uv = CGAL::centroid(m.corner_points[t][0], m.corner_points[t][1], m.corner_points[t][2]);
    const auto jet = face.surface.jet(uv.x(), uv.y());
    const Vector_3 normal = (face.is_reversed ? -1 : 1) * cross_product(jet.du, jet.dv);
    const double size = std::sqrt(normal.squared_length());
    if(size > 0)
      sums[m.patch_ids[t]] += normal * m.area_vector(t) / size;
  }
  for(std::size_t f = 0; f < sums.size(); ++f)
    EXPECT_GT(sums[f], 0) << "face " << f << " of the model is turned over";
}

inline std::size_t number_of_degenerate_triangles(const Meshed& m)
{
  std::size_t result = 0;
  for(const Triangle& t : m.triangles)
    result += CGAL::collinear(m.point(t[0]), m.point(t[1]), m.point(t[2]));
  return result;
}

// What holds for every mesh, however hard the input.
inline void check_mesh(const Meshed& m, const Criteria& criteria)
{
  EXPECT_TRUE(m.mesh.is_valid());
  EXPECT_EQ(m.mesh.number_of_vertices(), m.report.number_of_vertices);
  EXPECT_EQ(m.mesh.number_of_faces(), m.report.number_of_faces);
  EXPECT_TRUE(m.topology.is_manifold());
  EXPECT_EQ(0u, m.topology.isolated_vertices);
  EXPECT_EQ(0u, number_of_degenerate_triangles(m));
  check_listed_angles(m, criteria.angle());
  check_listed_sizes(m, m.report.max_edge);
  EXPECT_EQ(0u, m.report.count(CGAL::Parametric_surface_mesher::Unmet_cause::STOPPED)) << "it takes too long";
}

inline double diagonal(const Mesh& mesh)
{
  CGAL::Bbox_3 box;
  for(const auto v : mesh.vertices())
    box += mesh.point(v).bbox();
  return std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) + CGAL::square(box.z_span()));
}

// Ends a refinement that takes so long that something must be wrong.
class Impatient_visitor : public CGAL::Parametric_surface_mesh_visitor
{
#ifdef __SANITIZE_ADDRESS__
  static const int max_number_of_seconds = 200;
#else
  static const int max_number_of_seconds = 40;
#endif

  std::clock_t m_start = std::clock();

public:
  bool go_further() const { return double(std::clock() - m_start) / CLOCKS_PER_SEC < max_number_of_seconds; }
};

// Meshes a model and checks what holds for every mesh.
inline Meshed mesh_and_check(const Model& model, const Criteria& criteria)
{
  Meshed m;
  const auto corner_points = m.mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  const auto patch_ids = m.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch", 99).first;
  m.report = CGAL::make_parametric_surface_mesh(
    model, criteria, m.mesh,
    CGAL::parameters::face_patch_id_map(
      patch_ids, CGAL::parameters::halfedge_uv_map(corner_points, CGAL::parameters::visitor(Impatient_visitor()))));
  collect_triangles(m, corner_points, patch_ids);
  check_mesh(m, criteria);
  check_corner_points(m, model, model.tolerance() > 0 ? model.tolerance() : 1e-6 * diagonal(m.mesh));
  check_sides(m, model);
  return m;
}

// The same for a patch.
inline Meshed mesh_and_check(const Sample_surface& surface, const Domain& domain, const Criteria& criteria)
{
  Meshed m;
  const auto corner_points = m.mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  const auto patch_ids = m.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch", 0).first;
  m.report = CGAL::make_parametric_surface_mesh(
    surface, domain, criteria, m.mesh,
    CGAL::parameters::halfedge_uv_map(corner_points, CGAL::parameters::visitor(Impatient_visitor())));
  collect_triangles(m, corner_points, patch_ids);
  check_mesh(m, criteria);
  Model model;
  model.add_face({surface, {}});
  check_corner_points(m, model, 1e-9 * diagonal(m.mesh));
  check_sides(m, model);
  return m;
}

inline void expect_topology(const Meshed& m, std::size_t components, std::size_t border_cycles,
                            std::ptrdiff_t euler_characteristic)
{
  EXPECT_EQ(components, m.topology.components);
  EXPECT_EQ(border_cycles, m.topology.border_cycles);
  EXPECT_EQ(euler_characteristic, m.topology.euler_characteristic);
}

// No two vertices are at one point: nothing is cut that should be joined.
inline void expect_distinct_points(const Mesh& mesh)
{
  std::set<Point_3> points;
  for(const auto v : mesh.vertices())
    points.insert(mesh.point(v));
  EXPECT_EQ(mesh.number_of_vertices(), points.size());
}

inline double number_of_equilateral_triangles(double area, double edge) { return 4 * area / (std::sqrt(3.) * edge * edge); }

// The largest principal curvature at a point of a surface.
inline double largest_curvature(const Sample_surface::Jet& jet)
{
  const Vector_3 normal = cross_product(jet.du, jet.dv);
  const double e = jet.du * jet.du, f = jet.du * jet.dv, g = jet.dv * jet.dv, det = normal.squared_length();
  const double l = jet.duu * normal, m = jet.duv * normal, n = jet.dvv * normal; // times the root of det
  const double mean = (e * n - 2 * f * m + g * l) / (2 * det), gauss = (l * n - m * m) / det;
  return (std::fabs(mean) + std::sqrt((std::max)(0., mean * mean - gauss))) / std::sqrt(det);
}

// The largest curvature of the images of straight lines of the domain, within the surface and off it.
inline double largest_curvature_of_lines(const Sample_surface::Jet& jet)
{
  const int number_of_directions = 16;
  const double e = jet.du * jet.du, f = jet.du * jet.dv, root = std::sqrt(cross_product(jet.du, jet.dv).squared_length());
  double result = 0;
  for(int i = 0; i < number_of_directions; ++i) {
    const double c = std::cos(i * pi / number_of_directions), s = std::sin(i * pi / number_of_directions);
    const double v = s * std::sqrt(e) / root, u = c / std::sqrt(e) - v * f / e; // of length 1 in space
    const Vector_3 first = u * jet.du + v * jet.dv, second = u * u * jet.duu + 2 * u * v * jet.duv + v * v * jet.dvv;
    result = (std::max)(result, std::sqrt(cross_product(first, second).squared_length()));
  }
  return result;
}

// Integrals over a surface over a rectangle, by the midpoint rule.
class Surface_integrals
{
  struct Sample_point
  {
    double area, curvature, curvature_of_lines;
  };

  std::vector<Sample_point> m_points;

public:
  double area = 0;
  double volume = 0; // under it, as seen from the origin

  Surface_integrals(const Sample_surface& surface, double u_min, double u_max, double v_min, double v_max)
  {
    const int n = 150;
    const double du = (u_max - u_min) / n, dv = (v_max - v_min) / n;
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j) {
        const auto jet = surface.jet(u_min + (i + 0.5) * du, v_min + (j + 0.5) * dv);
        const Vector_3 normal = cross_product(jet.du, jet.dv) * du * dv;
        m_points.push_back({std::sqrt(normal.squared_length()), largest_curvature(jet),
                            largest_curvature_of_lines(jet)});
        area += m_points.back().area;
        volume += (jet.point - CGAL::ORIGIN) * normal / 3;
      }
  }

  explicit Surface_integrals(const Patch& patch)
    : Surface_integrals(patch.surface(), patch.u_min(), patch.u_max(), patch.v_min(), patch.v_max())
  {}

  // of equilateral triangles whose edges have the maximum length, or are as long as gamma allows
  double number_of_triangles(double max_edge, double min_edge, double gamma) const
  {
    return number_of_triangles(max_edge, min_edge, gamma, &Sample_point::curvature);
  }

  // the same for edges that are straight in the domain
  double number_of_triangles_by_lines(double max_edge, double min_edge, double gamma) const
  {
    return number_of_triangles(max_edge, min_edge, gamma, &Sample_point::curvature_of_lines);
  }

private:
  double number_of_triangles(double max_edge, double min_edge, double gamma, double Sample_point::*curvature) const
  {
    double result = 0;
    for(const Sample_point& p : m_points)
      if(p.area > 0) {
        const double edge = (std::max)(min_edge, (std::min)(max_edge, 7 * gamma / (std::max)(p.*curvature, 1e-9)));
        result += number_of_equilateral_triangles(p.area, edge);
      }
    return result;
  }
};

#endif // PARAMETRIC_SURFACE_MESHER_TEST_STRESS_TEST_HELPERS_H
