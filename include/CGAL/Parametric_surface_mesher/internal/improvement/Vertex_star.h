// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_VERTEX_STAR_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_VERTEX_STAR_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Triangle_quality.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Point_placement.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The shape of the triangles of a star.
struct Star_quality
{
  // The squared sine of 40 degrees, the default improvement angle.
  static constexpr double good_squared_sine = 0.413;

  double squared_sine = 1; // that of the smallest angle
  double mean = 0;         // the mean quality of the triangles

  // Whether no angle is below 40 degrees.
  bool is_good() const { return squared_sine > good_squared_sine; }

  // Good stars are compared by the mean quality, others by the smallest angle.
  bool is_better_than(const Star_quality& other) const
  {
    return other.is_good() ? is_good() && mean > other.mean : squared_sine > other.squared_sine;
  }
};

// The measures of a star with its centre at some position.
struct Star_shape
{
  Star_quality quality;
  double squared_size = 0;     // the largest squared circumradius by the squared sum of the spacings
  double squared_length = 0;   // the largest squared length of an edge of the centre by the squared sum of the spacings
  double squared_distance = std::numeric_limits<double>::infinity(); // from the nearest vertex of the ring
};

// The triangles around an inner vertex, as they are and as they would be if the vertex were elsewhere.
template <class Triangulation, class MetricField>
class Vertex_star
{
public:
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Point Point;
  typedef typename Point::Domain_point_2 Point_2;

private:
  typedef typename Kernel_traits<Point_2>::Kernel Kernel;
  typedef typename Kernel::Vector_2 Vector_2;
  typedef Point_placement<Kernel> Placement;

  const Triangulation& m_triangulation;
  const MetricField& m_metric;
  Vertex_handle m_center;
  std::vector<Face_handle> m_faces;
  std::vector<int> m_numbers;             // by face: the index of the centre in it
  std::vector<Vertex_handle> m_ring;      // face k has the vertices k and k + 1 of the ring
  std::vector<double> m_squared_lengths; // by edge of the ring
  std::size_t m_worst = 0;               // the index of the triangle that was the worst when last measured
  std::vector<std::array<double, 3>> m_triangles; // their squared lengths, as passed by `for_each_triangle()`

public:
  Vertex_star(const Triangulation& triangulation, const MetricField& metric) : m_triangulation(triangulation), m_metric(metric)
  {}

  // \pre `vertex` is not on the boundary
  void collect(Vertex_handle vertex)
  {
    m_center = vertex;
    m_worst = 0;
    m_faces.clear();
    m_numbers.clear();
    m_ring.clear();
    m_squared_lengths.clear();
    const Face_handle first = vertex->face();
    Face_handle face = first;
    do {
      const int i = int(face->vertex(1) == vertex) + 2 * int(face->vertex(2) == vertex); // unlike `index()` this has no branches
      m_faces.push_back(face);
      m_numbers.push_back(i);
      m_ring.push_back(face->vertex(Triangulation::ccw(i)));
      face = face->neighbor(Triangulation::ccw(i));
    } while(face != first);
    for(std::size_t k = 0; k < m_ring.size(); ++k)
      m_squared_lengths.push_back(m_metric.squared_length(ring_point(k), ring_point(k + 1)));
  }

  const std::vector<Face_handle>& faces() const { return m_faces; }
  const Point& center() const { return m_center->point(); }
  double spacing() const { return m_center->spacing(); }

  // The quality of the star as it is.
  template <class TriangleQuality = Squared_mean_ratio>
  Star_quality quality(const TriangleQuality& triangle_quality = TriangleQuality())
  {
    Star_quality result;
    m_triangles.clear();
    for_each_triangle(center(), [&](std::size_t, const std::array<double, 3>& lengths) {
      m_triangles.push_back(lengths);
      result.squared_sine = (std::min)(result.squared_sine, internal::squared_smallest_sine(lengths));
      result.mean += triangle_quality(lengths);
    });
    result.mean /= double(m_ring.size());
    return result;
  }

  // The squared sine of the smallest angle with the centre at this point. If it is not above `least`, the result may be that of any
  // such angle. The triangle that was the worst before comes first, since it most often decides.
  double squared_smallest_sine(const Point& center, double least = 0)
  {
    double result = 1, previous = m_metric.squared_length(center, ring_point(m_worst));
    for(std::size_t i = 0, k = m_worst; i < m_ring.size() && result > least; ++i, k = k + 1 < m_ring.size() ? k + 1 : 0) {
      const double next = m_metric.squared_length(center, ring_point(k + 1));
      const double sine = internal::squared_smallest_sine({m_squared_lengths[k], next, previous});
      if(sine < result) {
        result = sine;
        m_worst = k;
      }
      previous = next;
    }
    return result;
  }

  double squared_distance_to_ring(const Point& center) const
  {
    double result = m_metric.squared_length(center, ring_point(0));
    for(std::size_t k = 1; k < m_ring.size(); ++k)
      result = (std::min)(result, m_metric.squared_length(center, ring_point(k)));
    return result;
  }

  template <class TriangleQuality = Squared_mean_ratio>
  Star_shape shape(const Point& center, const TriangleQuality& triangle_quality = TriangleQuality()) const
  {
    Star_shape result;
    for_each_triangle(center, [&](std::size_t k, const std::array<double, 3>& lengths) {
      const double sum_along_edge = m_center->spacing() + ring_vertex(k + 1)->spacing(), sum = sum_along_edge + m_ring[k]->spacing();
      result.quality.squared_sine = (std::min)(result.quality.squared_sine, internal::squared_smallest_sine(lengths));
      result.quality.mean += triangle_quality(lengths);
      result.squared_size = (std::max)(result.squared_size, squared_circumradius(lengths) / (sum * sum));
      result.squared_length = (std::max)(result.squared_length, lengths[1] / (sum_along_edge * sum_along_edge));
      result.squared_distance = (std::min)(result.squared_distance, lengths[1]);
    });
    result.quality.mean /= double(m_ring.size());
    return result;
  }

  // The mean of the apices of equilateral triangles over the edges of the ring, each in the plane of its triangle.
  // \pre `quality()` was called
  Point_2 mean_of_apices() const
  {
    const Point& p = center();
    double x = 0, y = 0;
    for(std::size_t k = 0; k < m_triangles.size(); ++k) {
      const std::array<double, 3>& lengths = m_triangles[k];
      const Point &q = ring_point(k), &r = ring_point(k + 1);
      // the coordinate of the centre along the edge from `q` to `r`
      const double foot = 0.5 * (lengths[2] + lengths[0] - lengths[1]) / lengths[0];
      // the height of the equilateral triangle over that of the triangle
      const double ratio_of_heights = std::sqrt(3 / (std::max)(squared_area_16(lengths), 1e-300)) * lengths[0];
      const double qx = q.x() - p.x(), qy = q.y() - p.y(), rx = r.x() - p.x(), ry = r.y() - p.y();
      x += 0.5 * (qx + rx) - ratio_of_heights * (qx + foot * (rx - qx));
      y += 0.5 * (qy + ry) - ratio_of_heights * (qy + foot * (ry - qy));
    }
    return Point_2(p.x() + x / double(m_ring.size()), p.y() + y / double(m_ring.size()));
  }

  // The direction in which the mean quality increases most, of length 1 under the tensor of the centre; zero at a maximum. It uses
  // that the gradient of a squared length |c - q|^2 under the metric is 2 (c - q).
  // \pre `quality()` was called
  template <class TriangleQuality>
  Vector_2 direction_of_ascent(const TriangleQuality& triangle_quality) const
  {
    const Point_2 p = center().domain_point();
    Vector_2 result(0, 0);
    for(std::size_t k = 0; k < m_triangles.size(); ++k) {
      const std::array<double, 2> slopes = triangle_quality.derivatives(m_triangles[k]);
      result += slopes[0] * (p - ring_point(k + 1).domain_point()) + slopes[1] * (p - ring_point(k).domain_point());
    }
    const double squared_length = center().tensor().squared_length(result.x(), result.y());
    return squared_length > 0 ? result / std::sqrt(squared_length) : Vector_2(0, 0);
  }

  // The apices of equilateral triangles over the edges of the ring, under the tensors there, and at the end their mean.
  void apices(std::vector<Point_2>& result) const
  {
    result.clear();
    double x = 0, y = 0;
    for(std::size_t k = 0; k < m_ring.size(); ++k) {
      result.push_back(Placement::apex(ring_point(k), ring_point(k + 1), 0.87));
      x += result.back().x();
      y += result.back().y();
    }
    result.emplace_back(x / double(m_ring.size()), y / double(m_ring.size()));
  }

  // Whether a point keeps this distance from the ring, or is at least not closer to it than `old_point`.
  bool is_far_enough(const Point& point, const Point& old_point, double squared_min_distance) const
  {
    const double squared_distance = squared_distance_to_ring(point);
    return squared_distance >= squared_min_distance || squared_distance >= squared_distance_to_ring(old_point);
  }

  // Whether all triangles are positively oriented with the centre at this position, by exact tests. A position that is computed
  // from flat triangles need not be finite.
  bool is_around(const Point_2& position) const
  {
    if(!std::isfinite(position.x() + position.y()))
      return false;
    const auto orientation = m_triangulation.geom_traits().orientation_2_object();
    for(std::size_t k = 0; k < m_ring.size(); ++k)
      if(orientation(ring_point(k), ring_point(k + 1), position) != LEFT_TURN)
        return false;
    return true;
  }

  // Whether a triangle would face away from the surface. This is impossible where the speed of the parametrisation is about the
  // same all around.
  template <class Oracle>
  bool is_inverted(const Point& center, const Oracle& oracle) const
  {
    if(has_even_speed(center))
      return false;
    for(std::size_t k = 0; k < m_ring.size(); ++k)
      if(oracle.is_inverted(center, ring_point(k), ring_point(k + 1)))
        return true;
    return false;
  }

  // Moves the centre to a point from which it may be moved back.
  void try_at(const Point& point)
  {
    m_center->set_point(point);
    for(std::size_t k = 0; k < m_faces.size(); ++k)
      m_faces[k]->touch_by_vertex(m_numbers[k]);
  }

  void unsettle_ring()
  {
    for(Vertex_handle vertex : m_ring)
      vertex->set_settled(false);
  }

private:
  bool has_even_speed(const Point& center) const
  {
    double smallest_e = center.tensor().e(), largest_e = smallest_e, smallest_g = center.tensor().g(), largest_g = smallest_g;
    for(const Vertex_handle& vertex : m_ring) {
      const auto& tensor = vertex->point().tensor();
      smallest_e = (std::min)(smallest_e, tensor.e());
      largest_e = (std::max)(largest_e, tensor.e());
      smallest_g = (std::min)(smallest_g, tensor.g());
      largest_g = (std::max)(largest_g, tensor.g());
    }
    return largest_e < 2 * smallest_e && largest_g < 2 * smallest_g;
  }

  const Vertex_handle& ring_vertex(std::size_t k) const { return m_ring[k < m_ring.size() ? k : 0]; }
  const Point& ring_point(std::size_t k) const { return ring_vertex(k)->point(); }

  // Calls a function with the index of each triangle and its squared lengths: first that of the edge of the ring, then those of the
  // edges opposite to its ends.
  template <class Function>
  void for_each_triangle(const Point& center, const Function& function) const
  {
    double previous = m_metric.squared_length(center, ring_point(0));
    for(std::size_t k = 0; k < m_ring.size(); ++k) {
      const double next = m_metric.squared_length(center, ring_point(k + 1));
      function(k, {m_squared_lengths[k], next, previous});
      previous = next;
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IMPROVEMENT_VERTEX_STAR_H
