// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_POINTED_APEX_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_POINTED_APEX_H

#include <CGAL/Origin.h>
#include <CGAL/number_type_config.h>
#include <CGAL/Surface_jet_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The side of the domain from `p` to `q` is one point in space. Returns the angle that the directions leaving this point sweep
// over: 2 pi at the pole of a sphere.
template <class Surface, class Point_2>
double angle_at_collapsed_side(const Surface& surface, const Point_2& p, const Point_2& q)
{
  typedef typename Surface::Geom_traits Kernel;
  typedef typename Kernel::Vector_3 Vector_3;
  const int number_of_samples = 64;
  const double squared_rounding = 1e-20; // of a derivative that vanishes, relative to the largest one
  std::vector<Vector_3> across;
  double largest = 0;
  for(int i = 0; i <= number_of_samples; ++i) {
    const Point_2 x = p + (double(i) / number_of_samples) * (q - p);
    const Surface_jet_3<Kernel> jet = surface.jet(x.x(), x.y());
    across.push_back(p.y() == q.y() ? jet.dv : jet.du);
    largest = (std::max)(largest, across.back().squared_length());
  }
  double sum = 0;
  Vector_3 previous = NULL_VECTOR;
  for(const Vector_3& d : across) {
    if(d.squared_length() < squared_rounding * largest)
      continue; // another side collapses there, too, and no direction leaves it
    const Vector_3 direction = d / std::sqrt(d.squared_length());
    if(previous != NULL_VECTOR)
      sum += 2 * std::asin((std::min)(1., 0.5 * std::sqrt((direction - previous).squared_length())));
    previous = direction;
  }
  return sum;
}

// The number of triangles that are to meet at a pole: with angles close to 60 degrees, and at least three all around.
inline int number_of_sectors(double angle, bool is_all_around)
{
  const double sixty_degrees = CGAL_PI / 3;
  return (std::max)(int(std::lround(angle / sixty_degrees)), is_all_around ? 3 : 1);
}

/*
The seams that end at a pointed apex. Three triangles all around it have edges opposite to it that are shorter than those
that leave it: by the ratio `2 sin(sector / 2)`, the sector being a third of the angle around. Where that is below 0.75
triangles of 30 degrees between these edges and the next ones on the seam need the first piece of the seam to be longer than
the next one: twice as long.
*/
template <class Model>
class Pointed_apexes
{
  // Measured on cones: see the ring around an apex in the benchmarks.
  static constexpr double ratio_of_pointed_apex = 0.75;
  // In minimum edges. Edges of twice the minimum edge are divided for the sake of deviation, which is always bad at an apex.
  static constexpr double largest_edge_at_apex = 1.9;

  std::map<std::pair<std::size_t, std::size_t>, double> m_ratios; // by an edge and one of its vertices

public:
  explicit Pointed_apexes(const Model& model)
  {
    for(const auto& face : model.faces())
      for(const auto& loop : face.loops)
        for(std::size_t i = 0; i < loop.size(); ++i) {
          const auto &side = loop[i], &next = loop[(i + 1) % loop.size()];
          if(model.edges()[side.edge].is_collapsed && next.edge == loop[(i + loop.size() - 1) % loop.size()].edge)
            insert(next.edge, model.edges()[side.edge].source,
                   angle_at_collapsed_side(face.surface, side.curve.source(), side.curve.target()));
        }
  }

  // Whether the first two pieces of an edge, which have this length together, are to be one piece; not if this would make the
  // edges around the apex so long that deviation divides them.
  bool asks_for_one_piece(std::size_t edge, std::size_t vertex, double length, double min_edge) const
  {
    const auto found = m_ratios.find({edge, vertex});
    return found != m_ratios.end() && found->second < ratio_of_pointed_apex && found->second * length < largest_edge_at_apex * min_edge;
  }

  // Whether the edges opposite to a pointed apex would be shorter than the minimum edge if the first piece of an edge has this
  // length. Those around them on the seam are not, so that there would be flat triangles that the apex does not force.
  bool asks_for_longer_piece(std::size_t edge, std::size_t vertex, double length, double min_edge) const
  {
    const auto found = m_ratios.find({edge, vertex});
    return found != m_ratios.end() && found->second * length < min_edge;
  }

private:
  // Takes the edges at the apex to be those of a cone of revolution with this angle.
  void insert(std::size_t edge, std::size_t vertex, double angle)
  {
    const double sine_of_half_angle = angle / (2 * CGAL_PI);
    const int n = number_of_sectors(angle, true);
    m_ratios[{edge, vertex}] = 2 * std::sin(CGAL_PI / n) * sine_of_half_angle;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_POINTED_APEX_H
