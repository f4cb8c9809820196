// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_STRIP_DIVISION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_STRIP_DIVISION_H

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
Pieces along a strip narrower than they are long are halved only if the halves are no shorter than the minimum edge. Where
they are not, several in a row have room for more pieces all the same: three of 1.3 minimum edges in place of two of 1.95.
*/
template <class Division>
class Strip_division
{
  typedef typename Division::Piece Piece;

  typedef std::map<std::size_t, std::set<std::size_t>> Numbers; // the indices of pieces, by edge

  // The least length of a piece, in minimum edges: with 1 no point could be moved along the strip afterwards.
  static constexpr double least_length = 1.15;

  Division& m_division;
  double m_min_edge;
  Numbers m_pieces, m_pieces_in_corners;

public:
  Strip_division(Division& division, double min_edge) : m_division(division), m_min_edge(min_edge) {}

  // Adds a piece along a strip.
  void collect(const Piece& piece) { collect(piece, m_pieces); }

  // Adds a piece in a corner. It counts as along a strip if the next piece of its edge does.
  void collect_in_corner(const Piece& piece) { collect(piece, m_pieces_in_corners); }

  // Replaces pieces along strips by more of them, and returns the edges that have changed.
  std::set<std::size_t> operator()()
  {
    std::set<std::size_t> changed;
    for(auto& pieces : m_pieces) {
      for(const std::size_t number : m_pieces_in_corners[pieces.first])
        if(pieces.second.count(number - 1) + pieces.second.count(number + 1) > 0)
          pieces.second.insert(number);
      if(divide(pieces.first, pieces.second))
        changed.insert(pieces.first);
    }
    return changed;
  }

private:
  void collect(const Piece& piece, Numbers& numbers) const
  {
    if(m_division.can_be_split(piece) && !m_division.is_kept(piece))
      numbers[piece.edge].insert(piece.number);
  }

  bool divide(std::size_t edge, const std::set<std::size_t>& numbers)
  {
    const std::vector<double> old = m_division.parameters(edge);
    std::vector<double> parameters(1, old.front());
    for(std::size_t i = 0; i + 1 < old.size();) {
      std::size_t end = i;
      while(numbers.count(end) != 0)
        ++end;
      end = (std::max)(end, i + 1);
      std::vector<double> pieces(old.begin() + i, old.begin() + end + 1);
      if(numbers.count(i) != 0)
        pieces = divided(edge, pieces);
      parameters.insert(parameters.end(), pieces.begin() + 1, pieces.end());
      i = end;
    }
    if(parameters == old)
      return false;
    m_division.set_parameters(edge, parameters);
    return true;
  }

  // Divides a row of pieces into more equal ones if these have room.
  std::vector<double> divided(std::size_t edge, const std::vector<double>& row) const
  {
    std::vector<double> lengths(1, 0);
    for(std::size_t i = 0; i + 1 < row.size(); ++i)
      lengths.push_back(lengths.back() + distance(edge, row[i], row[i + 1]));
    for(auto n = std::size_t(lengths.back() / (least_length * m_min_edge)); n + 1 > row.size(); --n) {
      const std::vector<double> result = equal_pieces(row, lengths, n);
      if(are_long_enough(edge, result))
        return result;
    }
    return row;
  }

  static std::vector<double> equal_pieces(const std::vector<double>& row, const std::vector<double>& lengths, std::size_t n)
  {
    std::vector<double> result(1, row.front());
    std::size_t i = 0;
    for(std::size_t k = 1; k < n; ++k) {
      const double length = lengths.back() * double(k) / double(n);
      while(lengths[i + 1] < length)
        ++i;
      result.push_back(row[i] + (row[i + 1] - row[i]) * (length - lengths[i]) / (lengths[i + 1] - lengths[i]));
    }
    result.push_back(row.back());
    return result;
  }

  bool are_long_enough(std::size_t edge, const std::vector<double>& row) const
  {
    for(std::size_t i = 0; i + 1 < row.size(); ++i)
      if(distance(edge, row[i], row[i + 1]) < m_min_edge)
        return false;
    return true;
  }

  double distance(std::size_t edge, double t0, double t1) const
  {
    return std::sqrt(squared_distance(m_division.point(edge, t0), m_division.point(edge, t1)));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVISION_STRIP_DIVISION_H
