// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_RECENT_VALUES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_RECENT_VALUES_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The values that a costly function had at some of the last points it was asked for: each place of a table keeps the last
// point that fell to it.
template <class Point_2, class Value>
class Recent_values
{
  struct Entry
  {
    Point_2 point = Point_2(std::numeric_limits<double>::quiet_NaN(), 0); // no point is equal to it
    Value value;
  };

  std::vector<Entry> m_entries;

public:
  // `size`: of the table, at least; 0 if nobody will ask
  explicit Recent_values(std::size_t size)
  {
    std::size_t power = 1; // so that places are found without a division
    while(power < size)
      power *= 2;
    m_entries.resize(size == 0 ? 0 : power);
  }

  template <class Function>
  const Value& operator()(const Point_2& p, const Function& function)
  {
    Entry& entry = m_entries[place(p)];
    if(!(entry.point == p)) {
      entry.value = function(p);
      entry.point = p;
    }
    return entry.value;
  }

private:
  // by the upper bits of a product, as those of the mantissa have to count; the hash of the standard library takes as long
  // as some of the functions
  std::size_t place(const Point_2& p) const
  {
    const std::uint64_t product = 0x9e3779b97f4a7c15u * (bits(p.x()) + 3 * bits(p.y()));
    return std::size_t(product >> 32) & (m_entries.size() - 1);
  }

  static std::uint64_t bits(double x)
  {
    std::uint64_t result;
    std::memcpy(&result, &x, sizeof(result));
    return result;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_RECENT_VALUES_H
