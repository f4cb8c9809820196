// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models of a wave with edges and points inside its faces.
#ifndef WAVE_MODEL_H
#define WAVE_MODEL_H

#include <CGAL/Any_parametric_surface_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Parametric_function_surface_3.h>
#include <CGAL/Parametric_surface_model_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Any_parametric_surface_3<Kernel> Surface;
typedef CGAL::Parametric_surface_model_3<Surface> Model;
typedef Model::Curve Curve;

inline Surface wave()
{
  return CGAL::make_parametric_function_surface([](auto u, auto v) {
    using std::sin;
    return CGAL::parametric_surface_point(u, v, 0.2 * sin(3 * u) * sin(2 * v));
  });
}

// A model whose first face is the square [0,1]^2 of the wave, and the next ones squares beside it.
struct Wave_model
{
  Surface surface = wave();
  Model model;
  std::map<std::pair<double, double>, std::size_t> vertices; // by parameters

  std::size_t vertex(double u, double v)
  {
    const auto found = vertices.find({u, v});
    return found != vertices.end() ? found->second : vertices[{u, v}] = model.add_vertex(surface.point(u, v));
  }

  std::size_t add_edge(const Point_2& p, const Point_2& q) { return model.add_edge(vertex(p.x(), p.y()), vertex(q.x(), q.y())); }

  std::size_t add_face(const std::vector<Point_2>& corners)
  {
    Model::Face face{surface, {{}}};
    for(std::size_t i = 0; i < corners.size(); ++i) {
      const Point_2 p = corners[i], q = corners[(i + 1) % corners.size()];
      const bool is_reversed = edges.count({q, p}) > 0;
      if(!is_reversed)
        edges[{p, q}] = add_edge(p, q);
      face.loops[0].push_back({is_reversed ? edges[{q, p}] : edges[{p, q}], is_reversed,
                               is_reversed ? Curve::segment(q, p) : Curve::segment(p, q)});
    }
    return model.add_face(face);
  }

  std::size_t add_inner_segment(std::size_t face, const Point_2& p, const Point_2& q)
  {
    const std::size_t edge = add_edge(p, q);
    model.add_inner_edge(face, edge, Curve::segment(p, q));
    return edge;
  }

  std::size_t add_inner_circle(std::size_t face, const Point_2& center, double radius)
  {
    const std::size_t v = vertex(center.x() + radius, center.y()), edge = model.add_edge(v, v);
    model.add_inner_edge(face, edge, Curve::circle(center, radius));
    return edge;
  }

  void add_inner_point(std::size_t face, const Point_2& p, double max_edge = 0)
  {
    model.add_inner_point(face, vertex(p.x(), p.y()), p, max_edge);
  }

private:
  std::map<std::pair<Point_2, Point_2>, std::size_t> edges;
};

// Networks of segments between points of a jittered grid, some on the boundary, with single points between them.
class Random_network
{
  static const int n = 5;

  std::mt19937 m_random;
  std::vector<Point_2> m_points; // of the grid
  std::vector<Kernel::Segment_2> m_segments;

public:
  Wave_model wave;
  std::set<std::size_t> edges;

  explicit Random_network(unsigned int seed) : m_random(seed)
  {
    const auto place = [this](int j) { return j == 0 ? 0. : j == n ? 1. : (j + 0.6 * (share() - 0.5)) / n; };
    for(int i = 0; i <= n; ++i)
      for(int k = 0; k <= n; ++k) {
        const double u = place(i), v = place(k);
        m_points.emplace_back(u, v);
      }
    wave.add_face(boundary());
    for(int i = 0; i < 40; ++i) {
      const Point_2 p = m_points[m_random() % m_points.size()], q = m_points[m_random() % m_points.size()];
      if(can_have(p, q)) {
        m_segments.emplace_back(p, q);
        edges.insert(wave.add_inner_segment(0, p, q));
      }
    }
    for(int i = 0; i < 5; ++i) {
      const double u = 0.02 + 0.96 * share(), v = 0.02 + 0.96 * share();
      if(std::all_of(m_segments.begin(), m_segments.end(), [&](const auto& s) { return is_far(Point_2(u, v), s); }))
        wave.add_inner_point(0, {u, v});
    }
  }

private:
  double share() { return double(m_random()) / double(m_random.max()); }

  std::vector<Point_2> boundary() const
  {
    std::vector<Point_2> result;
    const auto add = [&](int i, int k) { result.push_back(m_points[std::size_t(i * (n + 1) + k)]); };
    for(int i = 0; i < n; ++i)
      add(i, 0);
    for(int i = 0; i < n; ++i)
      add(n, i);
    for(int i = n; i > 0; --i)
      add(i, n);
    for(int i = n; i > 0; --i)
      add(0, i);
    return result;
  }

  static bool is_far(const Point_2& p, const Kernel::Segment_2& segment) { return CGAL::squared_distance(p, segment) > 1e-4; }

  // Whether a segment meets others in their ends at most, and comes close to no other point of the grid.
  bool can_have(const Point_2& p, const Point_2& q) const
  {
    const Kernel::Segment_2 segment(p, q);
    const auto is_in_the_way = [&](const Point_2& r) { return r != p && r != q && !is_far(r, segment); };
    const auto crosses = [&](const Kernel::Segment_2& s) {
      const bool have_common_end = s.source() == p || s.source() == q || s.target() == p || s.target() == q;
      return CGAL::do_intersect(s, segment) && (!have_common_end || s == segment || s == segment.opposite());
    };
    return p != q && (p.x() != q.x() || (p.x() != 0 && p.x() != 1)) && (p.y() != q.y() || (p.y() != 0 && p.y() != 1))
           && std::none_of(m_points.begin(), m_points.end(), is_in_the_way)
           && std::none_of(m_segments.begin(), m_segments.end(), crosses);
  }
};

#endif // WAVE_MODEL_H
