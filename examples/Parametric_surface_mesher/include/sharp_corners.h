// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sharp corners of faces of a model, at which small angles cannot be avoided.
#ifndef SHARP_CORNERS_H
#define SHARP_CORNERS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/model/Model_uses.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace mesh_cad {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Open_cascade_model_3::Model Model;

inline double angle(const Kernel::Vector_3& a, const Kernel::Vector_3& b)
{
  return std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b) * 45 / std::atan(1.);
}

// The direction in space in which a use of an edge leaves its begin, or runs back from its end: that of the tangent or, if
// the edge is long enough, that of the chord to its point at this distance.
inline Kernel::Vector_3 direction(const Model& model, std::size_t face, const Model::Edge_use& use, bool is_at_begin,
                                  double distance)
{
  const bool is_at_source = is_at_begin != use.is_reversed;
  const auto& edge = model.edges()[use.edge];
  if(distance > 0 && edge.curve) {
    const auto point = [&](double t) { return edge.curve->point(is_at_source ? t : 1 - t); };
    const auto chord = [&](double t) { return point(t) - point(0); };
    const auto is_far = [&](double t) { return chord(t).squared_length() >= distance * distance; };
    double near = 0, far = 1. / 1024;
    while(far < 1 && !is_far(far))
      far *= 2;
    if(is_far(far)) {
      for(int i = 0; i < 20; ++i)
        (is_far(0.5 * (near + far)) ? far : near) = 0.5 * (near + far);
      return chord(far);
    }
  }
  const auto c = use.curve.jet(is_at_source ? use.curve.begin() : use.curve.end());
  const auto s = model.faces()[face].surface.jet(c.point.x(), c.point.y());
  return (is_at_source ? 1 : -1) * (c.first.x() * s.du + c.first.y() * s.dv);
}

// The corners of faces with less than a number of degrees. Of several corners of a face at the same point the sharpest counts.
typedef std::map<std::pair<std::size_t, Kernel::Point_3>, double> Sharp_corners;

// A loop without its poles: the edges on either side of one enclose a corner.
inline std::vector<Model::Edge_use> without_poles(const Model& model, const std::vector<Model::Edge_use>& loop)
{
  std::vector<Model::Edge_use> result;
  std::copy_if(loop.begin(), loop.end(), std::back_inserter(result),
               [&](const Model::Edge_use& use) { return !model.edges()[use.edge].is_collapsed; });
  return result;
}

// An end of an edge in the loop of a face.
struct Edge_end
{
  Model::Edge_use use;
  bool is_at_begin; // of the use

  bool is_at_source() const { return is_at_begin != use.is_reversed; }
};

// Adds the corner between two ends of edges at a vertex, if it has less than a number of degrees. The angle is that between the
// tangents of the edges; or, where edges bend towards each other, that in which the nearest points that a mesh may have on them are
// seen, those at the minimum edge.
inline void add_corner(const Model& model, std::size_t face, const Edge_end& a, const Edge_end& b, double degrees,
                       double min_edge, Sharp_corners& result)
{
  double corner = 180;
  for(const double distance : {0., min_edge})
    corner = (std::min)(corner, angle(direction(model, face, a.use, a.is_at_begin, distance),
                                      direction(model, face, b.use, b.is_at_begin, distance)));
  if(corner > degrees)
    return;
  const auto& edge = model.edges()[b.use.edge];
  const auto& vertex = model.vertices()[b.is_at_source() ? edge.source : edge.target];
  double& sharpest = result.emplace(std::make_pair(face, vertex), corner).first->second;
  sharpest = (std::min)(sharpest, corner);
}

// An end of an edge with the direction in the domain in which the edge leaves it.
struct Directed_end
{
  Edge_end end;
  double direction; // as an angle
  bool is_domain_left;
};

// The ends of edges of each face, by their points in its domain.
typedef std::map<std::pair<std::size_t, Kernel::Point_2>, std::vector<Directed_end>> Ends_at_points;

// The point of the domain, on the curve of a use from its source or its target on, whose image is at a distance from that of the end: not
// nearer, where edges that begin with the same tangent are not apart yet, or cross within their tolerances.
inline Kernel::Point_2 point_at_distance(const Model::Face& face, const Model::Edge_use& use, bool is_at_source, double distance)
{
  const auto& curve = use.curve;
  const double begin = is_at_source ? curve.begin() : curve.end(), end = is_at_source ? curve.end() : curve.begin();
  const auto image = [&](const Kernel::Point_2& p) { return face.surface.point(p.x(), p.y()); };
  const Kernel::Point_3 p = image(curve.point(begin));
  for(double share = 1. / 1024;; share *= 2) {
    const Kernel::Point_2 q = curve.point(begin + share * (end - begin));
    if(share >= 0.25 || CGAL::squared_distance(p, image(q)) >= distance * distance)
      return q;
  }
}

inline Ends_at_points ends_at_points(const Model& model, double distance)
{
  const CGAL::Parametric_surface_mesher::internal::Model_uses<Model> uses(model);
  Ends_at_points result;
  for(std::size_t e = 0; e < model.edges().size(); ++e)
    for(const auto& use : uses[e])
      for(const bool is_at_source : {true, false}) {
        const Kernel::Point_2 p = is_at_source ? use.use->curve.source() : use.use->curve.target();
        const Kernel::Vector_2 d = point_at_distance(model.faces()[use.face], *use.use, is_at_source, distance) - p;
        result[{use.face, p}].push_back({{*use.use, is_at_source != use.use->is_reversed}, std::atan2(d.y(), d.x()),
                                         use.is_domain_left == is_at_source});
      }
  return result;
}

// Where loops touch, or a loop touches itself, the corners lie between ends that do not follow each other in a loop.
inline void add_corners_at_touches(const Model& model, double degrees, double min_edge, Sharp_corners& result)
{
  const double far = 10; // minimum edges: the pieces at a cusp are about as long, and curves that cross within tolerances do so before
  for(auto& point : ends_at_points(model, far * min_edge)) {
    auto& ends = point.second;
    if(ends.size() <= 2)
      continue;
    std::sort(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.direction < b.direction; });
    for(std::size_t i = 0; i + 1 < ends.size(); ++i) // both uses of an edge inside the face, which enclose nothing
      if(ends[i].end.use.edge == ends[i + 1].end.use.edge && ends[i].direction == ends[i + 1].direction && ends[i].is_domain_left)
        std::swap(ends[i], ends[i + 1]);
    for(std::size_t i = 0; i < ends.size(); ++i) {
      const Directed_end &end = ends[i], &next = ends[(i + 1) % ends.size()];
      if(end.is_domain_left && !next.is_domain_left)
        add_corner(model, point.first.first, end.end, next.end, degrees, min_edge, result);
    }
  }
}

// The corners of all faces with less than a number of degrees.
inline Sharp_corners sharp_corners(const Model& model, double degrees, double min_edge)
{
  Sharp_corners result;
  for(std::size_t f = 0; f < model.faces().size(); ++f)
    for(const auto& whole_loop : model.faces()[f].loops) {
      const std::vector<Model::Edge_use> loop = without_poles(model, whole_loop);
      for(std::size_t i = 0; i < loop.size(); ++i) {
        const auto &use = loop[i], &next = loop[(i + 1) % loop.size()];
        if(use.edge == next.edge)
          continue; // the two sides of a seam, with all of the face between them
        add_corner(model, f, {use, false}, {next, true}, degrees, min_edge, result);
      }
    }
  add_corners_at_touches(model, degrees, min_edge, result);
  return result;
}

} // namespace mesh_cad

#endif // SHARP_CORNERS_H

