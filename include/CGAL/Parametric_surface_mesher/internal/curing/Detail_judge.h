// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_DETAIL_JUDGE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_DETAIL_JUDGE_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/Mesh_criterion.h>
#include <CGAL/Parametric_surface_mesher/internal/curing/Corner_angles.h>
#include <CGAL/Parametric_surface_mesher/internal/curing/Triangle_complex.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/number_utils.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Judges triangles of a complex: their angles, which side of the surface they show, how far it is from them, and the folds at
// their sides.
template <class Kernel, class Surface>
class Detail_judge
{
  typedef Triangle_complex<Kernel> Complex;
  typedef typename Complex::Triangle Triangle;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;
  typedef std::size_t Index;

  static constexpr double largest_cosine_of_fold = 0.94; // 20 degrees between two triangles at an edge
  static constexpr double cosine_of_tilt = 0.8;          // 37 degrees between a triangle and the surface
  static constexpr double least_sine = 0.087;            // of 5 degrees: what one step may make worse for the sake of others
  static constexpr double good_sine = 0.342;             // of 20 degrees: triangles with larger angles are all good

public:
  // What some triangles are like, together.
  struct Quality
  {
    double badness = 0;       // a sum over angles that are too small
    double cosine_of_tilt = 1;    // the smallest one between triangles and the surface
    double cosine_of_fold = -1;   // the largest one between two triangles at an edge; 1 if one lies on the other
    double squared_distance = 0; // the largest one of the surface
    double sine = 1;             // the smallest one of an angle, apart from corners

    // Whether these triangles may take the place of others.
    bool is_better_than(const Quality& old, double squared_distance_bound) const
    {
      return badness < old.badness * (1 - least_gain) && sine > 0 && sine >= (std::min)(least_sine, old.sine)
             && cosine_of_tilt >= (std::min)(Detail_judge::cosine_of_tilt, old.cosine_of_tilt)
             && cosine_of_fold <= (std::max)(largest_cosine_of_fold, old.cosine_of_fold)
             && squared_distance <= (std::max)(squared_distance_bound, old.squared_distance);
    }

    static constexpr double least_gain = 1e-3; // so that changes end
  };

private:
  const Complex& m_complex;
  const std::vector<Surface>& m_surfaces; // by patch
  const std::vector<bool>& m_are_reversed;
  const Corner_angles<Kernel>& m_corner_angles;

public:
  Detail_judge(const Complex& complex, const std::vector<Surface>& surfaces, const std::vector<bool>& are_reversed,
               const Corner_angles<Kernel>& corner_angles)
    : m_complex(complex), m_surfaces(surfaces), m_are_reversed(are_reversed), m_corner_angles(corner_angles)
  {}

  Quality quality(const std::vector<Index>& triangles) const
  {
    Quality result;
    for(Index t : triangles)
      add(t, result);
    return result;
  }

  // The sine of the smallest angle, and the corner that has it.
  std::pair<double, std::size_t> smallest_sine(Index t) const
  {
    std::array<double, 3> lengths; // squared; that of the side opposite to the corner
    for(std::size_t i = 0; i < 3; ++i)
      lengths[i] = squared_distance(m_complex.point(t, i + 1), m_complex.point(t, i + 2));
    const std::size_t i = std::size_t(std::min_element(lengths.begin(), lengths.end()) - lengths.begin());
    const double product = lengths[(i + 1) % 3] * lengths[(i + 2) % 3];
    return {product > 0 ? std::sqrt(normal(t).squared_length() / product) : 0, i};
  }

  // Whether no change should remove a triangle: its smallest angle is large enough, or is one that the shape asks for, between two
  // edges of the model in a vertex of it.
  bool is_good(Index t, double sine) const
  {
    const auto smallest = smallest_sine(t);
    return smallest.first >= sine || is_corner(t, smallest.second);
  }

  // Whether a change would join sheets of a shell that face each other, as both sides of a thin wall or of a gap.
  template <class Change>
  bool joins_opposite_sheets(const Change& change) const
  {
    std::vector<Sheet> kept, added;
    for(Index t : m_complex.vertex(change.survivor).triangles)
      if(std::find(change.removed.begin(), change.removed.end(), t) == change.removed.end())
        append_sheets(m_complex.triangle(t), kept);
    for(const Triangle& triangle : change.added)
      if(triangle.has(change.survivor))
        append_sheets(triangle, added);
    return are_opposite(kept, added) && !are_opposite(kept, kept) && !are_opposite(added, added);
  }

  // What the criteria ask for and a triangle does not meet, apart from its size.
  Criterion_set failed(Index t, const Parametric_surface_mesh_criteria& criteria) const
  {
    Criterion_set result;
    if(smallest_sine(t).first < std::sin(criteria.angle() * std::atan(1.) / 45))
      result |= Mesh_criterion::ANGLE;
    if(criteria.distance() && squared_distance_of_surface(t) > square(*criteria.distance()))
      result |= Mesh_criterion::DISTANCE;
    for(std::size_t i = 0; i < 3; ++i) {
      const Point_3 &p = m_complex.point(t, i), &q = m_complex.point(t, i + 1);
      const auto &uv = m_complex.triangle(t).uv[i], &next = m_complex.triangle(t).uv[(i + 1) % 3];
      const Point_3 middle
        = m_surfaces[m_complex.triangle(t).patch].point(0.5 * (uv.x() + next.x()), 0.5 * (uv.y() + next.y()));
      if(CGAL::squared_distance(middle, typename Kernel::Segment_3(p, q)) > square(criteria.gamma()) * squared_distance(p, q))
        result |= Mesh_criterion::DEVIATION;
    }
    return result;
  }

private:
  struct Sheet
  {
    Index shell;
    Vector_3 normal;
  };

  // Appends a triangle once for each of its shells, with the normal that points out of that.
  void append_sheets(const Triangle& triangle, std::vector<Sheet>& sheets) const
  {
    const Vector_3 normal = surface_normal(triangle);
    sheets.push_back({triangle.shells[0], normal});
    if(triangle.shells[1] != Complex::none)
      sheets.push_back({triangle.shells[1], -normal});
  }

  static bool are_opposite(const std::vector<Sheet>& a, const std::vector<Sheet>& b)
  {
    return std::any_of(a.begin(), a.end(), [&](const Sheet& first) {
      return std::any_of(b.begin(), b.end(), [&](const Sheet& second) {
        return first.shell == second.shell && first.normal * second.normal < -largest_cosine_of_fold;
      });
    });
  }

  void add(Index t, Quality& quality) const
  {
    const auto smallest = smallest_sine(t);
    if(smallest.first < good_sine && !is_corner(t, smallest.second)) {
      quality.sine = (std::min)(quality.sine, smallest.first);
      quality.badness += square(1 - smallest.first / good_sine);
    }
    const Vector_3 normal = unit(this->normal(t)), from_surface = surface_normal(m_complex.triangle(t));
    if(from_surface.squared_length() > 0)
      quality.cosine_of_tilt = (std::min)(quality.cosine_of_tilt, normal * from_surface);
    for(std::size_t i = 0; i < 3; ++i)
      for(Index shell : m_complex.triangle(t).shells)
        if(const auto other = neighbor(t, i, shell))
          quality.cosine_of_fold
            = (std::max)(quality.cosine_of_fold, -(side(t, shell) * side(*other, shell) * (normal * unit(this->normal(*other)))));
    quality.squared_distance = (std::max)(quality.squared_distance, squared_distance_of_surface(t));
  }

  bool is_corner(Index t, std::size_t i) const
  {
    return m_complex.vertex(m_complex.triangle(t).vertices[i]).dimension == 0 && m_complex.is_on_patch_border(t, i)
           && m_complex.is_on_patch_border(t, (i + 2) % 3)
           && m_corner_angles.has_corner_as_small(m_complex.point(t, i), m_complex.triangle(t).patch, angle(t, i));
  }

  double angle(Index t, std::size_t i) const
  {
    return Corner_angles<Kernel>::angle(m_complex.point(t, i + 1) - m_complex.point(t, i),
                                        m_complex.point(t, i + 2) - m_complex.point(t, i));
  }

  // 1 if a triangle of a shell faces out of it, else -1
  int side(Index t, Index shell) const { return m_complex.triangle(t).shells[0] == shell ? 1 : -1; }

  // The triangle across a side, if two triangles of the shell meet there.
  std::optional<Index> neighbor(Index t, std::size_t i, Index shell) const
  {
    const Triangle& triangle = m_complex.triangle(t);
    std::optional<Index> result;
    for(Index other : m_complex.triangles_at(triangle.vertices[i], triangle.vertices[(i + 1) % 3]))
      if(other != t && m_complex.triangle(other).is_in(shell)) {
        if(result)
          return std::nullopt;
        result = other;
      }
    return result;
  }

  Vector_3 normal(Index t) const
  {
    return cross_product(m_complex.point(t, 1) - m_complex.point(t, 0), m_complex.point(t, 2) - m_complex.point(t, 0));
  }

  static Vector_3 unit(const Vector_3& v)
  {
    const double length = std::sqrt(v.squared_length());
    return length > 0 ? v / length : v;
  }

  // The normal of the surface at the middle of a triangle, or zero where the surface is singular.
  Vector_3 surface_normal(const Triangle& triangle) const
  {
    const auto& uv = triangle.uv;
    const auto jet = m_surfaces[triangle.patch].jet((uv[0].x() + uv[1].x() + uv[2].x()) / 3, (uv[0].y() + uv[1].y() + uv[2].y()) / 3);
    return unit(m_are_reversed[triangle.patch] ? cross_product(jet.dv, jet.du) : cross_product(jet.du, jet.dv));
  }

  double squared_distance_of_surface(Index t) const
  {
    const typename Kernel::Triangle_3 triangle(m_complex.point(t, 0), m_complex.point(t, 1), m_complex.point(t, 2));
    const auto& uv = m_complex.triangle(t).uv;
    double result = 0;
    for(const auto& w : {std::array<double, 3>{0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {1. / 3, 1. / 3, 1. / 3}}) {
      const Point_3 p = m_surfaces[m_complex.triangle(t).patch].point(w[0] * uv[0].x() + w[1] * uv[1].x() + w[2] * uv[2].x(),
                                                                      w[0] * uv[0].y() + w[1] * uv[1].y() + w[2] * uv[2].y());
      result = (std::max)(result, double(CGAL::squared_distance(p, triangle)));
    }
    return result;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_DETAIL_JUDGE_H
