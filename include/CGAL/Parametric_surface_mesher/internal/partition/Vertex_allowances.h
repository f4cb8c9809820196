// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_VERTEX_ALLOWANCES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_VERTEX_ALLOWANCES_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// How the vertices that a patch may have are shared out among its parts, before these are meshed; and how many they took. So
// it can be told, once a mesh is there, whether a smaller limit would have changed it.
class Vertex_allowances
{
public:
  struct Allowance
  {
    double share;              // of what is left of the limit
    std::size_t number_before; // of vertices that the patch has anyway
    std::size_t number = 0;    // that the part took; with all that it might take, it may have wanted more

    std::size_t allowed_number(std::size_t limit) const
    {
      return std::size_t(share * double(limit - (std::min)(limit, number_before)));
    }
  };

private:
  std::vector<Allowance> m_allowances;
  double m_estimated_number_of_triangles = 0; // of a patch in parts

public:
  void set_estimated_number_of_triangles(double number) { m_estimated_number_of_triangles = number; }

  // Whether most of a patch would have to do without the triangles that it wants: there are two for each vertex. Then it is not
  // split.
  static bool is_too_large(double number_of_triangles, std::size_t max_number_of_vertices)
  {
    return number_of_triangles / 2 > 2 * double(max_number_of_vertices);
  }

  void add(const Allowance& allowance) { m_allowances.push_back(allowance); }

  // Whether the mesh would be another one with this limit.
  // \pre it is not larger than the limit in effect
  bool is_limited_by(std::size_t limit) const
  {
    return is_too_large(m_estimated_number_of_triangles, limit)
           || std::any_of(m_allowances.begin(), m_allowances.end(),
                          [=](const Allowance& allowance) { return allowance.number >= allowance.allowed_number(limit); });
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_VERTEX_ALLOWANCES_H
