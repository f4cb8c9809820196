// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_MID_SIDE_PLACEMENT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_MID_SIDE_PLACEMENT_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/divide_curve.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Middle_of_curve.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Quadratic_triangle_3.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Surface_foot.h>
#include <CGAL/Parametric_surface_model_3.h>

#include <boost/math/tools/roots.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// An edge of a mesh from end to end.
template <class Kernel>
struct Chord
{
  typename Kernel::Point_3 source, target;

  typename Kernel::Point_3 middle() const { return straight_middle(source, target); }
  double length() const { return std::sqrt(squared_distance(source, target)); }

  // A point that is farther from the middle than the ends are is not that of a curve between them.
  bool may_have_middle(const typename Kernel::Point_3& p) const
  {
    return 4 * squared_distance(p, middle()) <= squared_distance(source, target);
  }
};

// Finds the mid-side nodes of the edges of a mesh on the curves and surfaces of its model.
template <class Surface>
class Mid_side_placement
{
public:
  typedef typename Surface::Geom_traits Kernel;
  typedef Parametric_surface_model_3<Surface> Model;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef std::optional<Point_3> Place; // none where nothing was found

private:
  // Of the length of an edge: if the middle of its line in the domain is not farther than that from the middle of the chord, the point
  // wanted is looked for from there.
  static constexpr double share_for_first_place = 0.1;

  struct Use
  {
    std::size_t face;
    const typename Model::Edge_use* use;
  };

  const Model& m_model;
  std::vector<std::optional<Use>> m_first_uses; // by edge

public:
  // Refers to the model.
  explicit Mid_side_placement(const Model& model) : m_model(model), m_first_uses(model.edges().size())
  {
    for(std::size_t f = 0; f < model.faces().size(); ++f)
      for(const auto& loop : model.faces()[f].loops)
        for(const auto& use : loop)
          if(use.edge < m_first_uses.size() && !m_first_uses[use.edge])
            m_first_uses[use.edge] = Use{f, &use};
  }

  // The middle, by length in space, of the piece of an edge of the model between two parameters of its curve.
  Place on_piece(std::size_t edge, const std::array<double, 2>& parameters, const Chord<Kernel>& chord) const
  {
    if(!std::isfinite(parameters[0]) || !std::isfinite(parameters[1]))
      return std::nullopt;
    return guarded_place(chord, [&] {
      return with_curve(edge, [&](const auto& curve) { return Place(middle_of_piece(curve, parameters[0], parameters[1])); });
    });
  }

  // The point of an edge of the model that is closest to the middle of the chord.
  Place near_edge(std::size_t edge, const Chord<Kernel>& chord) const
  {
    return guarded_place(chord, [&] {
      return with_curve(edge, [&](const auto& curve) { return Place(closest_point(curve, chord.middle())); });
    });
  }

  // Where the surface of a face meets the plane between both ends of the chord, as close to the chord as possible there: the middle,
  // by length, of an arc. `from`, `to`: the parameters of the ends.
  Place on_face(std::size_t face, const Point_2& from, const Point_2& to, const Chord<Kernel>& chord) const
  {
    const double length = chord.length();
    if(!(length > 0))
      return std::nullopt;
    const Surface& surface = m_model.faces()[face].surface;
    const Directions_in_section<Kernel> directions{(chord.target - chord.source) / length};
    Place result;
    find_near(surface, chord.middle(), places_between(from, to), share_for_first_place * length, [&](const Point_2& start) {
      result = guarded_place(chord, [&]() -> Place {
        const auto uv = find_on_surface(surface, start, chord.middle(), length, directions);
        return uv ? Place(surface.point(uv->x(), uv->y())) : std::nullopt;
      });
      return bool(result);
    });
    return result ? result : on_line_in_domain(surface, from, to, chord);
  }

private:
  // The point over the straight line in the domain that is equally far from both ends: where the surface bends so much that steps do not
  // converge.
  static Place on_line_in_domain(const Surface& surface, const Point_2& from, const Point_2& to, const Chord<Kernel>& chord)
  {
    return guarded_place(chord, [&]() -> Place {
      const auto point = [&](double t) { return surface.point(from.x() + t * (to.x() - from.x()), from.y() + t * (to.y() - from.y())); };
      const auto lead = [&](double t) { return squared_distance(point(t), chord.source) - squared_distance(point(t), chord.target); };
      if(!(lead(0) < 0 && lead(1) > 0))
        return std::nullopt;
      const auto t = boost::math::tools::bisect(lead, 0., 1., boost::math::tools::eps_tolerance<double>());
      return point(0.5 * (t.first + t.second));
    });
  }

  // A surface or a curve that cannot be evaluated has no place.
  template <class Find>
  static Place guarded_place(const Chord<Kernel>& chord, const Find& find)
  {
    try {
      const Place place = find();
      return place && chord.may_have_middle(*place) ? place : std::nullopt;
    }
    catch(const Parametric_surface_mesh_error&) {
      return std::nullopt;
    }
  }

  // Calls `function` with the curve that the edge was divided along.
  template <class Function>
  Place with_curve(std::size_t edge, const Function& function) const
  {
    if(m_model.edges()[edge].curve)
      return function(*m_model.edges()[edge].curve);
    if(!m_first_uses[edge])
      return std::nullopt;
    const Use& use = *m_first_uses[edge];
    return function(Curve_on_surface_3<Surface>(m_model.faces()[use.face].surface, use.use->curve));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_MID_SIDE_PLACEMENT_H
