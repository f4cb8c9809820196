// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An audit of meshes that shares no code with the mesher: what must hold for every mesh, whatever the input and whether or not
// criteria are met.
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_MESH_AUDIT_H
#define PARAMETRIC_SURFACE_MESHER_TEST_MESH_AUDIT_H

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/number_utils.h>

#include <Mesh_with_domain.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// A curve of a boundary loop, and the direction in which the loop runs through it.
template <class Curve>
struct Audited_curve
{
  const Curve* curve;
  bool is_reversed;
  bool is_collapsed; // to a point in space

  const auto& source() const { return is_reversed ? curve->target() : curve->source(); }
  const auto& target() const { return is_reversed ? curve->source() : curve->target(); }
};

// What a patch was made of.
template <class Surface, class Curve>
struct Audited_patch
{
  const Surface* surface;
  std::vector<std::vector<Audited_curve<Curve>>> loops;
  bool is_reversed = false; // whether its triangles face against `S_u x S_v`
  double tolerance = 0;     // of points of its boundary in space

  bool has_collapsed_curve() const
  {
    for(const auto& loop : loops)
      for(const auto& curve : loop)
        if(curve.is_collapsed)
          return true;
    return false;
  }
};

// Collects what is wrong.
class Audit_findings
{
  std::vector<std::string> m_texts;
  std::map<std::string, std::size_t> m_numbers; // by kind

public:
  // `details` are kept for the first few of a kind
  template <class... Details>
  void add(const std::string& kind, const Details&... details)
  {
    if(++m_numbers[kind] > 3)
      return;
    std::ostringstream text;
    text.precision(17);
    text << kind << ":";
    (void)std::initializer_list<int>{((text << " " << details), 0)...};
    m_texts.push_back(text.str());
  }

  bool empty() const { return m_texts.empty(); }
  const std::vector<std::string>& texts() const { return m_texts; }
  const std::map<std::string, std::size_t>& numbers() const { return m_numbers; }
};

// The halfedge structure: consistent, without isolated vertices, and with one fan of faces at each vertex.
template <class Kernel>
void audit_connectivity(const Mesh_with_domain<Kernel>& result, Audit_findings& findings)
{
  const auto& mesh = result.mesh;
  if(!mesh.is_valid(false))
    findings.add("halfedges are not consistent");
  for(const auto f : mesh.faces()) {
    const auto h = result.halfedges(f);
    if(mesh.next(h[2]) != h[0] || mesh.target(h[0]) == mesh.target(h[1]) || mesh.target(h[1]) == mesh.target(h[2])
       || mesh.target(h[2]) == mesh.target(h[0]))
      findings.add("a face is no triangle", f);
  }
  std::vector<std::size_t> degrees(mesh.number_of_vertices(), 0), border_degrees(mesh.number_of_vertices(), 0);
  for(const auto h : mesh.halfedges()) {
    ++degrees[mesh.target(h)];
    border_degrees[mesh.target(h)] += mesh.is_border(h);
  }
  for(const auto v : mesh.vertices()) {
    if(mesh.is_isolated(v)) {
      findings.add("a vertex is isolated", v);
      continue;
    }
    std::size_t fan = 0;
    for(auto h = mesh.halfedge(v); fan <= degrees[v]; h = mesh.opposite(mesh.next(h))) {
      ++fan;
      if(mesh.opposite(mesh.next(h)) == mesh.halfedge(v))
        break;
    }
    if(fan != degrees[v] || border_degrees[v] > 1)
      findings.add("a vertex has several fans", v);
  }
  if(result.report.number_of_vertices != mesh.number_of_vertices() || result.report.number_of_faces != mesh.number_of_faces())
    findings.add("the report counts otherwise", result.report.number_of_vertices, mesh.number_of_vertices(),
                 result.report.number_of_faces, mesh.number_of_faces());
}

// Smallest angle of a triangle in degrees.
template <class Point_3>
double audited_smallest_angle(const Point_3& p, const Point_3& q, const Point_3& r)
{
  const auto angle = [](const Point_3& a, const Point_3& b, const Point_3& c) {
    const auto x = b - a, y = c - a;
    return std::atan2(std::sqrt(cross_product(x, y).squared_length()), x * y) * 180 / CGAL_PI;
  };
  return (std::min)({angle(p, q, r), angle(q, r, p), angle(r, p, q)});
}

template <class Kernel>
void audit_smallest_angle(const Mesh_with_domain<Kernel>& result, Audit_findings& findings)
{
  double smallest = 180;
  for(const auto f : result.mesh.faces()) {
    const auto h = result.halfedges(f);
    smallest = (std::min)(smallest, audited_smallest_angle(result.mesh.point(result.mesh.target(h[0])),
                                                           result.mesh.point(result.mesh.target(h[1])),
                                                           result.mesh.point(result.mesh.target(h[2]))));
  }
  // The report has it from lengths of edges, whose rounding counts most where angles are smallest.
  if(!(std::fabs(result.report.smallest_angle - smallest) <= 1e-5))
    findings.add("the report has another smallest angle", result.report.smallest_angle, smallest);
}

// One patch of a mesh, in its parameter domain.
template <class Kernel, class Surface, class Curve>
class Patch_audit
{
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef Mesh_with_domain<Kernel> Result;
  typedef typename Result::Face_index Face_index;
  typedef Audited_patch<Surface, Curve> Patch;
  typedef std::pair<Point_2, Point_2> Domain_edge;

  struct Border_edge
  {
    Point_2 target;
    std::size_t source_vertex, target_vertex;
    bool is_used = false;
  };

  const Result& m_result;
  const Patch& m_patch;
  std::vector<Face_index> m_faces;
  std::string m_name;
  Audit_findings& m_findings;
  std::multimap<Point_2, Border_edge> m_border; // edges with the domain on their left, by their sources
  bool m_is_any_loop_without_area = false;
  double m_extent = 0;                          // the largest coordinate of the domain

public:
  Patch_audit(const Result& result, std::size_t number, const Patch& patch, Audit_findings& findings)
    : m_result(result), m_patch(patch), m_name("patch " + std::to_string(number) + ","), m_findings(findings)
  {
    for(const auto f : result.mesh.faces())
      if(result.patch_id[f] == number)
        m_faces.push_back(f);
    for(const auto& loop : patch.loops)
      for(const auto& curve : loop)
        m_extent = (std::max)({m_extent, std::fabs(curve.source().x()), std::fabs(curve.source().y())});
  }

  void operator()()
  {
    audit_points();
    if(m_patch.has_collapsed_curve())
      return; // where corners have no single place in the domain
    audit_orientation();
    find_border();
    audit_loops();
  }

  // of the triangles of the patch, with the domain on the left
  std::vector<Domain_edge> border() const
  {
    std::vector<Domain_edge> result;
    for(const auto& edge : m_border)
      result.emplace_back(edge.first, edge.second.target);
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  // the corners of a face, counterclockwise in the domain if the face is as it should be
  std::array<std::pair<Point_2, std::size_t>, 3> corners(Face_index f) const
  {
    const auto h = m_result.halfedges(f);
    std::array<std::pair<Point_2, std::size_t>, 3> result;
    for(std::size_t i = 0; i < 3; ++i)
      result[i] = {m_result.halfedge_uv[h[i]], m_result.mesh.target(h[i])};
    if(m_patch.is_reversed)
      std::swap(result[1], result[2]);
    return result;
  }

  void audit_points()
  {
    double size = 0;
    for(const auto f : m_faces)
      for(const auto& corner : corners(f)) {
        const Point_3& p = m_result.mesh.point(typename Result::Vertex_index(typename Result::Mesh::size_type(corner.second)));
        size = (std::max)({size, std::fabs(p.x()), std::fabs(p.y()), std::fabs(p.z())});
      }
    for(const auto f : m_faces)
      for(const auto& corner : corners(f)) {
        const typename Result::Vertex_index v(typename Result::Mesh::size_type(corner.second));
        const Point_3 &p = m_result.mesh.point(v), q = m_patch.surface->point(corner.first.x(), corner.first.y());
        const double distance = std::sqrt((q - p).squared_length());
        if(!std::isfinite(p.x() + p.y() + p.z() + corner.first.x() + corner.first.y()))
          m_findings.add("a vertex is not finite", m_name, v, p, corner.first);
        else if(!(distance <= 1e-12 * size + (m_result.mesh.is_border(v) || m_patch.tolerance > 0 ? m_patch.tolerance : 0)))
          m_findings.add("a vertex is not on the surface", m_name, v, p, corner.first, distance);
      }
  }

  void audit_orientation()
  {
    for(const auto f : m_faces) {
      const auto c = corners(f);
      if(typename Kernel::Orientation_2()(c[0].first, c[1].first, c[2].first) != CGAL::LEFT_TURN)
        m_findings.add("a triangle is not positively oriented", m_name, f, c[0].first, c[1].first, c[2].first);
    }
  }

  // Edges that the triangle on the other side has, too, are no border. So the triangles and the border have the same area,
  // and cover each point as often as the border winds around it: once, if it is the boundary of the domain.
  void find_border()
  {
    std::map<Domain_edge, std::pair<std::size_t, std::size_t>> edges;
    std::set<Point_2> points;
    std::size_t number_of_inner_edges = 0;
    for(const auto f : m_faces) {
      const auto c = corners(f);
      for(std::size_t i = 0; i < 3; ++i) {
        const auto &from = c[i], &to = c[(i + 1) % 3];
        points.insert(from.first);
        if(!edges.insert({{from.first, to.first}, {from.second, to.second}}).second)
          m_findings.add("an edge has two triangles on one side", m_name, from.first, to.first);
      }
    }
    for(const auto& edge : edges)
      if(edges.count({edge.first.second, edge.first.first}) == 0)
        m_border.insert({edge.first.first, {edge.first.second, edge.second.first, edge.second.second, false}});
      else
        ++number_of_inner_edges;
    const std::ptrdiff_t euler = std::ptrdiff_t(points.size()) - std::ptrdiff_t(m_border.size() + number_of_inner_edges / 2)
                                 + std::ptrdiff_t(m_faces.size());
    if(euler != 2 - std::ptrdiff_t(m_patch.loops.size()) && !has_loop_that_touches_itself())
      m_findings.add("the Euler characteristic does not fit the loops", m_name, euler, m_patch.loops.size());
  }

  bool has_loop_that_touches_itself() const
  {
    for(const auto& loop : m_patch.loops) {
      std::set<Point_2> sources;
      for(const auto& curve : loop)
        sources.insert(curve.source());
      if(sources.size() < loop.size())
        return true;
    }
    return false;
  }

  void audit_loops()
  {
    for(std::size_t l = 0; l < m_patch.loops.size(); ++l)
      audit_loop(l);
    for(const auto& edge : m_border)
      if(!edge.second.is_used && !m_is_any_loop_without_area)
        m_findings.add("a border edge belongs to no loop", m_name, edge.first, edge.second.target);
  }

  // twice the area of the polygon of samples
  static double area(const std::vector<Audited_curve<Curve>>& loop)
  {
    std::vector<Point_2> points;
    for(const auto& c : loop)
      for(int k = 0; k < 32; ++k)
        points.push_back(c.curve->point(parameter(c, k / 32.)));
    double result = 0;
    for(std::size_t i = 0; i < points.size(); ++i) {
      const Point_2 &p = points[i], &q = points[(i + 1) % points.size()], &o = points.front();
      result += (p.x() - o.x()) * (q.y() - o.y()) - (p.y() - o.y()) * (q.x() - o.x());
    }
    return result;
  }

  static double parameter(const Audited_curve<Curve>& c, double share)
  {
    return c.is_reversed ? c.curve->end() + share * (c.curve->begin() - c.curve->end())
                         : c.curve->begin() + share * (c.curve->end() - c.curve->begin());
  }

  // The border edges along the curves of a loop, from the beginning of the first to the end of the last, the domain on their
  // left.
  void audit_loop(std::size_t l)
  {
    std::vector<Audited_curve<Curve>> loop = m_patch.loops[l];
    if(std::fabs(area(loop)) < 1e-12 * m_extent * m_extent) {
      m_is_any_loop_without_area = true; // rounding tells which side is inside
      return;
    }
    if((area(loop) > 0) != (l == 0)) {
      std::reverse(loop.begin(), loop.end());
      for(auto& c : loop)
        c.is_reversed = !c.is_reversed;
    }
    for(std::size_t i = 0; i < loop.size(); ++i)
      if(!follow(loop[i], l, i))
        return;
  }

  bool follow(const Audited_curve<Curve>& c, std::size_t l, std::size_t i)
  {
    Point_2 at = c.source();
    double share = 0;
    for(bool is_first = true; is_first || !is_near(at, c.target()); is_first = false) {
      Border_edge* best = nullptr;
      double best_share = 2;
      for(auto range = edges_from(at); range.first != range.second; ++range.first) {
        Border_edge& edge = range.first->second;
        const double next = edge.is_used ? 2 : share_on_curve(c, share, edge.target);
        if(next < best_share) {
          best_share = next;
          best = &edge;
        }
      }
      if(!best) {
        m_findings.add("the border leaves a curve", m_name, "loop", l, "curve", i, at, share);
        return false;
      }
      best->is_used = true;
      share = best_share;
      at = best->target;
    }
    return true;
  }

  double tolerance() const { return 2e-9 * m_extent; }

  bool is_near(const Point_2& p, const Point_2& q) const { return squared_distance(p, q) <= tolerance() * tolerance(); }

  // the edges that begin there, up to the gaps that loops may have
  std::pair<typename std::multimap<Point_2, Border_edge>::iterator, typename std::multimap<Point_2, Border_edge>::iterator>
  edges_from(const Point_2& p)
  {
    const auto exact = m_border.equal_range(p);
    if(exact.first != exact.second)
      return exact;
    for(auto it = m_border.lower_bound(Point_2(p.x() - tolerance(), p.y())); it != m_border.end(); ++it) {
      if(it->first.x() > p.x() + tolerance())
        break;
      if(is_near(it->first, p))
        return m_border.equal_range(it->first);
    }
    return exact;
  }

  // Where a point is on a curve, as a share of its parameters, if it is behind `begin`; else 2.
  double share_on_curve(const Audited_curve<Curve>& c, double begin, const Point_2& p) const
  {
    if(is_near(p, c.target()))
      return 1;
    // many samples are for curves that are thin in the domain
    for(const int number_of_samples : {200, 10000}) {
      const double share = share_on_curve(c, begin, p, c.curve->is_straight() ? 2 : number_of_samples);
      if(share <= 1)
        return share;
    }
    return 2;
  }

  double share_on_curve(const Audited_curve<Curve>& c, double begin, const Point_2& p, int n) const
  {
    const auto squared_distance_at = [&](double share) { return squared_distance(c.curve->jet(parameter(c, share)).point, p); };
    std::vector<double> shares, distances;
    for(int k = 0; k <= n; ++k) {
      shares.push_back(begin + (1 - begin) * k / n);
      distances.push_back(squared_distance_at(shares.back()));
    }
    for(std::size_t k = 0; k < shares.size(); ++k)
      if((k == 0 || distances[k] <= distances[k - 1]) && (k + 1 == shares.size() || distances[k] <= distances[k + 1])) {
        const double share = nearest(c, shares[k == 0 ? 0 : k - 1], shares[(std::min)(k + 1, shares.size() - 1)], p);
        if(share > begin && squared_distance_at(share) <= tolerance() * tolerance())
          return share;
      }
    return 2;
  }

  // the share between two others where a curve is closest to a point, by halving
  static double nearest(const Audited_curve<Curve>& c, double low, double high, const Point_2& p)
  {
    const bool is_forward = parameter(c, 1) > parameter(c, 0);
    for(int step = 0; step < 100 && low < high; ++step) {
      const double middle = 0.5 * (low + high);
      const auto jet = c.curve->jet(parameter(c, middle));
      if(middle == low || middle == high)
        break;
      (((jet.point - p) * jet.first > 0) == is_forward ? high : low) = middle;
    }
    return 0.5 * (low + high);
  }
};

#endif // PARAMETRIC_SURFACE_MESHER_TEST_MESH_AUDIT_H
