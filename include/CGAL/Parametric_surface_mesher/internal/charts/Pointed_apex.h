// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_POINTED_APEX_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_POINTED_APEX_H

#include <CGAL/Origin.h>
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

// The angle in space that the directions leaving the side of the domain from `p` to `q`, a point in space, sweep over:
// 2 pi at the pole of a sphere.
template <class Surface, class Point_2>
double angle_at_collapsed_side(const Surface& surface, const Point_2& p, const Point_2& q)
{
  typedef typename Surface::Geom_traits Kernel;
  typedef typename Kernel::Vector_3 Vector_3;
  const int number_of_samples = 64;
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
    if(d.squared_length() < 1e-20 * largest)
      continue; // where another side collapses there is no direction
    const Vector_3 direction = d / std::sqrt(d.squared_length());
    if(previous != NULL_VECTOR)
      sum += 2 * std::asin((std::min)(1., 0.5 * std::sqrt((direction - previous).squared_length())));
    previous = direction;
  }
  return sum;
}

// How many triangles are to meet at a pole: with angles close to 60 degrees, but at least three all around.
inline int number_of_sectors(double angle, bool is_all_around)
{
  const double sixty_degrees = 4. / 3 * std::atan(1.);
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
  std::map<std::pair<std::size_t, std::size_t>, double> m_ratios; // of an edge and one of its vertices

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

  // whether the first two pieces of an edge, of this length together, are to be one. Not if edges around the apex would be
  // so long that deviation divides them.
  bool asks_for_one_piece(std::size_t edge, std::size_t vertex, double length, double min_edge) const
  {
    const auto found = m_ratios.find({edge, vertex});
    return found != m_ratios.end() && found->second < 0.75 && found->second * length < 1.9 * min_edge;
  }

private:
  // The edges are chords in space: as those of a cone of revolution with this angle.
  void insert(std::size_t edge, std::size_t vertex, double angle)
  {
    const double sine_of_half_angle = angle / (8 * std::atan(1.));
    const int n = number_of_sectors(angle, true);
    m_ratios[{edge, vertex}] = 2 * std::sin(4 * std::atan(1.) / n) * sine_of_half_angle;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CHARTS_POINTED_APEX_H
