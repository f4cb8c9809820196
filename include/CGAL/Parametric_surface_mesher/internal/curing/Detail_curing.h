// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_DETAIL_CURING_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_DETAIL_CURING_H

#include <CGAL/Parametric_surface_mesher/internal/curing/Detail_changes.h>
#include <CGAL/Parametric_surface_mesher/internal/curing/Detail_judge.h>
#include <CGAL/Parametric_surface_mesher/internal/curing/Triangle_complex.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Removes triangles with small angles from a complex, the worst first, by the best of the changes around them that move no point
// farther than a given width.
template <class Kernel, class Surface>
class Detail_curing
{
  typedef Triangle_complex<Kernel> Complex;
  typedef Detail_judge<Kernel, Surface> Judge;
  typedef typename Complex::Change Change;
  typedef typename Judge::Quality Quality;
  typedef typename Kernel::Point_3 Point_3;
  typedef std::size_t Index;

public:
  static constexpr double small_sine = 0.2588; // of 15 degrees: triangles with smaller angles are to be removed

  // A place where edges or vertices of the model were joined.
  struct Removal
  {
    Index patch; // that had the triangles which vanished
    Index survivor;
    Point_3 place;
    double moved;
  };

private:
  // Each change makes the angles around it better, which ends. This keeps a pathological case from taking all the time.
  static constexpr std::size_t max_number_of_changes_per_triangle = 20;

  Complex& m_complex;
  Judge m_judge;
  Detail_changes<Kernel> m_changes;
  double m_squared_distance_bound;
  std::set<std::pair<double, Index>> m_queue; // sine and triangle
  std::vector<Removal> m_removals;
  std::size_t m_number_of_changes = 0;
  bool m_is_good = false;

public:
  Detail_curing(Complex& complex, const std::vector<Surface>& surfaces, const std::vector<bool>& are_reversed,
                const Corner_angles<Kernel>& corner_angles, double width, double distance_bound)
    : m_complex(complex), m_judge(complex, surfaces, are_reversed, corner_angles), m_changes(complex, width),
      m_squared_distance_bound(distance_bound * distance_bound)
  {}

  // After a stop, the complex stays as far as it is.
  template <class GoFurther>
  void operator()(const GoFurther& go_further)
  {
    const double sine_before = smallest_sine();
    improve_all(go_further, [this](Index t) { return m_changes.around(t); });
    improve_all(go_further, [this](Index t) {
      std::vector<Change> result = m_changes.around(t);
      const std::vector<Change> slides = m_changes.slides_around(t);
      result.insert(result.end(), slides.begin(), slides.end());
      return result;
    });
    m_is_good = smallest_sine() >= (std::min)(sine_before, small_sine);
  }

  // Whether the smallest angle has not become smaller. It may have where detail is all that there is: a long thin ring, say.
  bool is_good() const { return m_is_good; }

  const std::vector<Removal>& removals() const { return m_removals; }
  std::size_t number_of_changes() const { return m_number_of_changes; }

private:
  // The sine of the smallest angle, apart from corners.
  double smallest_sine() const
  {
    double result = 1;
    for(Index t = 0; t < m_complex.triangles().size(); ++t)
      if(!m_complex.triangle(t).is_removed && !m_judge.is_good(t, result))
        result = m_judge.smallest_sine(t).first;
    return result;
  }

  template <class GoFurther, class ChangesAround>
  void improve_all(const GoFurther& go_further, const ChangesAround& changes_around)
  {
    for(Index t = 0; t < m_complex.triangles().size(); ++t)
      enqueue(t);
    const std::size_t max_number_of_changes
      = m_number_of_changes + max_number_of_changes_per_triangle * (m_complex.triangles().size() + 1);
    while(!m_queue.empty() && m_number_of_changes < max_number_of_changes && go_further()) {
      const Index t = m_queue.begin()->second;
      m_queue.erase(m_queue.begin());
      if(!m_complex.triangle(t).is_removed)
        improve(changes_around(t));
    }
    m_queue.clear();
  }

  void enqueue(Index t)
  {
    if(!m_complex.triangle(t).is_removed && !m_judge.is_good(t, small_sine))
      m_queue.emplace(m_judge.smallest_sine(t).first, t);
  }

  // Makes the best of some changes.
  void improve(const std::vector<Change>& changes)
  {
    const Change* best = nullptr;
    double best_gain = 0;
    for(const Change& change : changes) {
      const double gain = this->gain(change);
      if(gain > best_gain) {
        best_gain = gain;
        best = &change;
      }
    }
    if(best)
      make(*best);
  }

  // Returns by how much a change makes angles better, or 0 if it is not allowed.
  double gain(const Change& change)
  {
    if(m_judge.joins_opposite_sheets(change))
      return 0;
    const Quality before = m_judge.quality(change.removed);
    const Index first = m_complex.triangles().size();
    const Change back = m_complex.apply(change);
    const Quality after = m_judge.quality(added(first));
    m_complex.take_back(back);
    return after.is_better_than(before, m_squared_distance_bound) ? before.badness - after.badness : 0;
  }

  std::vector<Index> added(Index first) const
  {
    std::vector<Index> result;
    for(Index t = first; t < m_complex.triangles().size(); ++t)
      result.push_back(t);
    return result;
  }

  void make(const Change& change)
  {
    ++m_number_of_changes;
    note(change);
    const Index first = m_complex.triangles().size();
    m_complex.apply(change);
    std::set<Index> triangles;
    for(Index t : added(first))
      for(Index v : m_complex.triangle(t).vertices)
        triangles.insert(m_complex.vertex(v).triangles.begin(), m_complex.vertex(v).triangles.end());
    for(Index t : triangles)
      enqueue(t);
  }

  void note(const Change& change)
  {
    if(!change.removes_detail)
      return;
    for(Index t : change.removed)
      if(std::none_of(change.added.begin(), change.added.end(), [&](const auto& added) { return added.replaced == t; }))
        m_removals.push_back({m_complex.triangle(t).patch, change.survivor, m_complex.vertex(change.survivor).point,
                              change.displacements.front().second.length()});
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_CURING_DETAIL_CURING_H
