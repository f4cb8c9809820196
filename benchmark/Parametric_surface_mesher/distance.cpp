// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes all CAD models of a folder as mesh_cad does with a relative distance, and measures how far mesh and shape are apart,
// over the bound: from dense samples of the faces and their edges to the nearest triangle, and from dense samples of the
// triangles to the nearest point of the surface. It shares no code with what judges triangles while they are made. Each model
// has a process and 300 seconds of its own.
#include "Mesh_cad_options.h"
#include "Mesh_cad_result.h"
#include "Text_table.h"
#include "text_in_process.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

const unsigned int seconds_for_a_model = 300;
const int samples_along_side = 8;  // of a triangle: 45 samples
const int samples_along_edge = 800; // of the model

typedef mesh_cad::Kernel Kernel;
typedef CGAL::Open_cascade_surface_3 Surface;

// The largest distances over the bound, and how many triangles have one above it.
struct Distances
{
  double from_faces = 0, from_edges = 0, from_triangles = 0;
  std::size_t number_of_triangles = 0, unreported_triangles = 0;
  double unreported = 0; // the largest of triangles that the report does not list
};

// The squared distance of `p` to the surface around `uv`: Newton steps to the foot of the perpendicular as far as they help,
// then steps along the coordinates that become shorter, as the surface need not be smooth.
double squared_distance_to_surface(const Kernel::Point_3& p, const Kernel::Point_2& uv, const Surface& surface, double step_u,
                                   double step_v)
{
  double u = uv.x(), v = uv.y(), best = CGAL::squared_distance(p, surface.point(u, v));
  const auto move = [&](double new_u, double new_v) {
    const double distance = CGAL::squared_distance(p, surface.point(new_u, new_v));
    if(!(distance < best))
      return false;
    best = distance;
    u = new_u;
    v = new_v;
    return true;
  };
  for(int step = 0; step < 10; ++step) {
    const auto s = surface.jet(u, v);
    const Kernel::Vector_3 d = s.point - p;
    const double a = s.du * s.du + d * s.duu, b = s.du * s.dv + d * s.duv, c = s.dv * s.dv + d * s.dvv;
    const double f = d * s.du, g = d * s.dv, determinant = a * c - b * b;
    if(!move(u - (c * f - b * g) / determinant, v - (a * g - b * f) / determinant))
      break;
  }
  for(int shrinking = 0; shrinking < 20; ++shrinking) {
    for(int step = 0; step < 8 && (move(u + step_u, v) || move(u - step_u, v) || move(u, v + step_v) || move(u, v - step_v)
                                   || move(u + step_u, v + step_v) || move(u - step_u, v - step_v)
                                   || move(u + step_u, v - step_v) || move(u - step_u, v + step_v));
        ++step)
      ;
    step_u *= 0.5;
    step_v *= 0.5;
  }
  return best;
}

// Whether a point of the domain of a face is inside its loops, which are looked at as polygons.
class Domain_polygons
{
  std::vector<std::vector<std::array<Kernel::Point_2, 2>>> m_segments; // of the faces

public:
  explicit Domain_polygons(const mesh_cad::Model& model)
  {
    const int n = 200; // segments of a curve
    for(const auto& face : model.faces()) {
      m_segments.emplace_back();
      for(const auto& loop : face.loops)
        for(const auto& use : loop)
          for(int i = 0; i < n; ++i) {
            const auto& c = use.curve;
            const double from = c.begin() + (c.end() - c.begin()) * i / n, to = c.begin() + (c.end() - c.begin()) * (i + 1) / n;
            m_segments.back().push_back({c.point(from), c.point(to)});
          }
    }
  }

  bool operator()(std::size_t face, const Kernel::Point_2& p) const
  {
    bool is_inside = false;
    for(const auto& s : m_segments[face])
      if((s[0].y() > p.y()) != (s[1].y() > p.y())
         && p.x() < s[0].x() + (p.y() - s[0].y()) / (s[1].y() - s[0].y()) * (s[1].x() - s[0].x()))
        is_inside = !is_inside;
    return is_inside;
  }
};

class Distance_measure
{
  const Mesh_cad_result& m_result;
  const double m_bound;
  mesh_cad::Triangle_tree m_tree;
  const Domain_polygons m_is_inside;
  Distances m_distances;

public:
  explicit Distance_measure(const Mesh_cad_result& result)
    : m_result(result), m_bound(result.criteria.distance().value()),
      m_tree(faces(result.mesh.mesh).begin(), faces(result.mesh.mesh).end(), result.mesh.mesh),
      m_is_inside(result.shape.model)
  {}

  Distances operator()()
  {
    std::set<std::size_t> reported;
    for(const auto& unmet : m_result.report.unmet)
      reported.insert(unmet.face);
    for(const auto face : m_result.mesh.mesh.faces())
      measure(face, reported.count(std::size_t(face)) > 0);
    measure_edges();
    return m_distances;
  }

private:
  void measure(Cad_mesh::Mesh::Face_index face, bool is_reported)
  {
    const mesh_cad::Triangle_corners c = mesh_cad::corners(m_result.mesh, face);
    const Surface& surface = m_result.shape.model.faces()[m_result.mesh.patch[face]].surface;
    const Kernel::Triangle_3 triangle(c.points[0], c.points[1], c.points[2]);
    double to_mesh = 0, to_surface = 0;
    const auto [min_u, max_u] = std::minmax({c.uv[0].x(), c.uv[1].x(), c.uv[2].x()});
    const auto [min_v, max_v] = std::minmax({c.uv[0].y(), c.uv[1].y(), c.uv[2].y()});
    const double n = samples_along_side, step_u = (max_u - min_u) / n, step_v = (max_v - min_v) / n;
    for(int i = 0; i <= samples_along_side; ++i)
      for(int k = 0; i + k <= samples_along_side; ++k) {
        const double x = i / n, y = k / n, z = 1 - x - y;
        const Kernel::Point_2 uv(x * c.uv[0].x() + y * c.uv[1].x() + z * c.uv[2].x(),
                                 x * c.uv[0].y() + y * c.uv[1].y() + z * c.uv[2].y());
        const Kernel::Point_3 s = surface.point(uv.x(), uv.y());
        const Kernel::Point_3 p = CGAL::barycenter(c.points[0], x, c.points[1], y, c.points[2], z);
        if(CGAL::squared_distance(s, triangle) > CGAL::square((std::max)(to_mesh, 0.9) * m_bound)
           && m_is_inside(m_result.mesh.patch[face], uv))
          to_mesh = (std::max)(to_mesh, std::sqrt(m_tree.squared_distance(s)) / m_bound);
        if(CGAL::squared_distance(s, p) > CGAL::square((std::max)(to_surface, 0.9) * m_bound))
          to_surface = (std::max)(to_surface, std::sqrt(squared_distance_to_surface(p, uv, surface, step_u, step_v)) / m_bound);
      }
    add(to_mesh, to_surface, is_reported);
  }

  void add(double to_mesh, double to_surface, bool is_reported)
  {
    m_distances.from_faces = (std::max)(m_distances.from_faces, to_mesh);
    m_distances.from_triangles = (std::max)(m_distances.from_triangles, to_surface);
    const double larger = (std::max)(to_mesh, to_surface);
    m_distances.number_of_triangles += larger > 1;
    if(is_reported)
      return;
    m_distances.unreported_triangles += larger > 1;
    m_distances.unreported = (std::max)(m_distances.unreported, larger);
  }

  void measure_edges()
  {
    std::set<std::size_t> edges;
    for(const std::size_t face : std::set<std::size_t>(m_result.mesh.patch.begin(), m_result.mesh.patch.end()))
      for(const auto& loop : m_result.shape.model.faces()[face].loops)
        for(const auto& use : loop)
          edges.insert(use.edge);
    const int n = samples_along_edge;
    for(const std::size_t e : edges)
      if(const auto& curve = m_result.shape.model.edges()[e].curve)
        for(int i = 0; i <= n; ++i) {
          const auto p = curve->point(curve->begin() + (curve->end() - curve->begin()) * i / n);
          m_distances.from_edges = (std::max)(m_distances.from_edges, std::sqrt(m_tree.squared_distance(p)) / m_bound);
        }
  }
};

// the cells of a line but for the name, separated by tabs
std::string cells(const std::string& file_name, double relative_distance)
{
  Mesh_cad_options options;
  options.input = file_name;
  options.is_quiet = true;
  options.relative_distance = relative_distance;
  Mesh_cad_result result;
  mesh_cad::mesh_and_measure(options, result);
  const Distances distances = Distance_measure(result)();
  using CGAL::Parametric_surface_mesher::Mesh_criterion;
  std::size_t reported = 0;
  for(const auto& unmet : result.report.unmet)
    reported += unmet.criteria.contains(Mesh_criterion::DEVIATION) || unmet.criteria.contains(Mesh_criterion::DISTANCE);
  std::ostringstream out;
  out << result.quality.number_of_faces << "\t" << text_of_number("%.2f", result.meshing_seconds) << "\t"
      << text_of_number("%.3f", distances.from_faces) << "\t" << text_of_number("%.3f", distances.from_edges) << "\t"
      << text_of_number("%.3f", distances.from_triangles) << "\t" << distances.number_of_triangles << "\t" << reported << "\t"
      << distances.unreported_triangles << "\t" << text_of_number("%.3f", distances.unreported);
  return out.str();
}

Text_table::Line line(const std::string& file_name, double relative_distance, std::size_t number_of_cells)
{
  Text_table::Line result(1, std::filesystem::path(file_name).filename().string());
  std::istringstream in(text_in_process(seconds_for_a_model, [&] { return cells(file_name, relative_distance); }));
  for(std::string cell; std::getline(in, cell, '\t');)
    result.push_back(cell);
  result.resize(number_of_cells);
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  const double relative_distance = argc > 2 ? std::atof(argv[1]) : 0;
  if(!(relative_distance > 0)) {
    std::cerr << "Usage: distance RELATIVE_DISTANCE FOLDER_OR_FILE...\n";
    return 2;
  }
  const Text_table::Line titles = {"model", "triangles", "CPU s", "faces to mesh", "edges to mesh", "mesh to faces",
                                   "triangles off", "reported", "off and not reported", "by"};
  Text_table table(titles);
  for(int i = 2; i < argc; ++i)
    if(std::filesystem::is_directory(argv[i]))
      for(const std::string& file : cad_files_in(argv[i]))
        table.add_line(line(file, relative_distance, titles.size()));
    else
      table.add_line(line(argv[i], relative_distance, titles.size()));
  table.print(std::cout, Text_table::PLAIN);
  return 0;
}
