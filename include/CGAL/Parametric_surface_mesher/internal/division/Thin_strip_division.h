// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_THIN_STRIP_DIVISION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_THIN_STRIP_DIVISION_H

#include <CGAL/Parametric_surface_mesher/internal/division/Thin_strips.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Divides the edges of thin strips (see `Thin_strips`) into pieces as long as a multiple of the width. Triangles are best where the
points of either side lie opposite to the middles of the other one's pieces. So the first edge of a strip is divided by sizes, and
those opposite to it have their points there; then those opposite to these, as on a thin rod, which is four strips.
*/
template <class Division>
class Thin_strip_division
{
  typedef typename Division::Kernel::Point_3 Point_3;
  typedef Places_in_strips<Division> Strips;
  typedef Place_in_strip<Division> Place;
  typedef std::map<std::size_t, Place> Places; // by number of the piece

  // As shares of the wanted length: pieces beside points that stay are not shorter; longer ones are divided.
  static constexpr double shortest_piece = 0.3, longest_piece = 1.6;

  Division& m_division;
  const Strips& m_strips;
  std::map<std::size_t, std::vector<double>> m_parameters; // by edge, of those that are done

public:
  Thin_strip_division(Division& division, const Strips& strips) : m_division(division), m_strips(strips) {}

  // Returns how many more pieces there are than before.
  std::size_t operator()()
  {
    for(const auto& edge : m_strips)
      if(m_parameters.count(edge.first) == 0)
        divide_all_from(edge.first);
    std::size_t result = 0;
    for(const auto& edge : m_parameters) {
      const std::size_t before = m_division.number_of_pieces(edge.first);
      result += (std::max)(edge.second.size() - 1, before) - before;
      m_division.set_parameters(edge.first, edge.second);
    }
    return result;
  }

private:
  // Divides an edge, then those opposite to it, then those opposite to these.
  void divide_all_from(std::size_t first)
  {
    std::vector<std::size_t> edges(1, first);
    std::set<std::size_t> known(edges.begin(), edges.end());
    for(std::size_t i = 0; i < edges.size(); ++i) {
      divide(edges[i]);
      for(const auto& place : m_strips.at(edges[i]))
        if(m_strips.count(place.second.opposite_edge) != 0 && m_parameters.count(place.second.opposite_edge) == 0
           && known.insert(place.second.opposite_edge).second)
          edges.push_back(place.second.opposite_edge);
    }
  }

  void divide(std::size_t edge)
  {
    const std::vector<double> points_wanted = points_opposite_to_middles(edge), old = m_division.parameters(edge);
    const Places& places = m_strips.at(edge);
    std::vector<double> result(1, old.front());
    for(std::size_t i = 0; i + 1 < old.size();) {
      std::vector<const Place*> row;
      for(auto place = places.find(i + row.size()); place != places.end() && place->first == i + row.size(); ++place)
        row.push_back(&place->second);
      const std::size_t n = (std::max)(row.size(), std::size_t(1));
      if(row.empty())
        result.push_back(old[i + 1]);
      else
        append_row(std::vector<double>(old.begin() + i, old.begin() + i + n + 1), row, points_wanted, result);
      i += n;
    }
    m_parameters[edge] = result;
  }

  // The points of an edge that are opposite to the middles of pieces that are divided already, in no order.
  std::vector<double> points_opposite_to_middles(std::size_t edge) const
  {
    std::vector<double> result;
    for(const auto& other : m_parameters) {
      const Places& places = m_strips.at(other.first);
      const std::vector<double>& old = m_division.parameters(other.first);
      const bool is_ascending = old.front() < old.back();
      for(std::size_t k = 0; k + 1 < other.second.size(); ++k) {
        const double middle = 0.5 * (other.second[k] + other.second[k + 1]);
        const auto end = std::upper_bound(old.begin(), old.end(), middle,
                                          [=](double a, double b) { return is_ascending ? a < b : b < a; });
        const auto place = places.find(std::size_t(end - old.begin()) - 1);
        if(place != places.end() && place->second.opposite_edge == edge)
          result.push_back(place->second.foot(m_division, m_division.point(other.first, middle)).parameter);
      }
    }
    return result;
  }

  // Appends the parameters of a row of pieces but for its first one: `old` divided anew.
  void append_row(const std::vector<double>& old, const std::vector<const Place*>& row, const std::vector<double>& wanted,
                  std::vector<double>& result) const
  {
    std::vector<double> numbers(1, 0); // of pieces of the wanted length, up to each of the old points
    for(std::size_t i = 0; i < row.size(); ++i)
      numbers.push_back(numbers.back() + row[i]->length / row[i]->wanted_length);
    std::vector<double> fixed(1, 0); // where points lie, in these numbers
    for(double t : wanted)
      if((old.front() < t && t < old.back()) || (old.back() < t && t < old.front()))
        fixed.push_back(interpolated(old, numbers, t));
    std::sort(fixed.begin(), fixed.end());
    std::vector<double> kept;
    for(double number : fixed)
      if(kept.empty() || (number - kept.back() > shortest_piece && numbers.back() - number > shortest_piece))
        kept.push_back(number);
    kept.push_back(numbers.back());
    for(std::size_t i = 0; i + 1 < kept.size(); ++i) {
      const double gap = kept[i + 1] - kept[i];
      const std::size_t n = gap > longest_piece || kept.size() == 2 ? std::size_t(std::ceil(gap)) : 1;
      for(std::size_t k = 1; k < n; ++k)
        result.push_back(interpolated(numbers, old, kept[i] + gap * double(k) / double(n)));
      result.push_back(i + 2 == kept.size() ? old.back() : interpolated(numbers, old, kept[i + 1]));
    }
  }

  // The value at `x` of the function that is linear between its values `y` at the places `xs`, which ascend or descend.
  static double interpolated(const std::vector<double>& xs, const std::vector<double>& ys, double x)
  {
    const bool is_ascending = xs.front() < xs.back();
    std::size_t i = 0;
    while(i + 2 < xs.size() && (is_ascending ? xs[i + 1] < x : xs[i + 1] > x))
      ++i;
    return ys[i] + (ys[i + 1] - ys[i]) * (x - xs[i]) / (xs[i + 1] - xs[i]);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_THIN_STRIP_DIVISION_H
