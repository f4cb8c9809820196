// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_MESH_CRITERION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_MESH_CRITERION_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <array>
#include <cstdint>
#include <string>

namespace CGAL {
namespace Parametric_surface_mesher {

/// \ingroup PkgParametricSurfaceMesherRef
/// the criteria that a triangle can fail.
enum class Mesh_criterion : std::uint8_t
{
  SIZE,      ///< circumradius above `C (S_1 + S_2 + S_3)` (paper, eq. 3)
  ANGLE,     ///< smallest angle below the bound
  DEVIATION, ///< deviation ratio `H/L` of an edge above `gamma`; without a bound of the distance also that of a feature inside
  DISTANCE,  ///< distance from the surface above the absolute bound
  USER,      ///< the criterion of the user, see `CGAL::parameters::triangle_criterion()`
  INVERTED   ///< it faces away from the surface
};

/// \ingroup PkgParametricSurfaceMesherRef
/// why a triangle fails a criterion in the end: what stood against the last attempt to refine it.
enum class Unmet_cause : std::uint8_t
{
  /// the point that would help is behind the boundary or so close to it that it would spoil the triangles there; or what
  /// fails is an edge of the boundary, which is never changed
  BOUNDARY,
  /// the point that would help is closer to a vertex than the minimum edge length; or what fails is an edge shorter than
  /// twice that
  MINIMUM_EDGE,
  SPACING,         ///< the point that would help is so close to a vertex that it would make triangles much smaller than wanted
  NO_BETTER_POINT, ///< no point that was tried makes the triangles around it better
  VERTEX_LIMIT,    ///< the maximum number of vertices was reached
  WORK_LIMIT,      ///< a bound on the work was reached, which keeps difficult places from taking all the time
  STOPPED,         ///< the visitor stopped the refinement
  /// the angle is smaller than what was asked for, but not smaller than 32 degrees: refinement goes for no more, and improvement has not found more
  ANGLE_LIMIT
};

/// \ingroup PkgParametricSurfaceMesherRef
/// all criteria, in the order in which they are judged.
inline constexpr std::array<Mesh_criterion, 6> all_criteria()
{
  return {Mesh_criterion::SIZE,     Mesh_criterion::ANGLE, Mesh_criterion::DEVIATION,
          Mesh_criterion::DISTANCE, Mesh_criterion::USER,  Mesh_criterion::INVERTED};
}

/// \ingroup PkgParametricSurfaceMesherRef
/// all causes.
inline constexpr std::array<Unmet_cause, 8> all_causes()
{
  return {Unmet_cause::BOUNDARY,     Unmet_cause::MINIMUM_EDGE, Unmet_cause::SPACING, Unmet_cause::NO_BETTER_POINT,
          Unmet_cause::VERTEX_LIMIT, Unmet_cause::WORK_LIMIT,   Unmet_cause::STOPPED,      Unmet_cause::ANGLE_LIMIT};
}

/// \ingroup PkgParametricSurfaceMesherRef
/// a set of criteria: those that a triangle fails.
class Criterion_set
{
  std::uint8_t m_bits = 0;

public:
  /// the empty set.
  constexpr Criterion_set() = default;

  /// the set of one criterion.
  constexpr Criterion_set(Mesh_criterion criterion) : m_bits(std::uint8_t(1 << int(criterion))) {}

  constexpr bool empty() const { return m_bits == 0; }
  constexpr bool contains(Mesh_criterion criterion) const { return (m_bits >> int(criterion) & 1) != 0; }

  /// adds the criteria of another set.
  constexpr Criterion_set& operator|=(Criterion_set other)
  {
    m_bits = std::uint8_t(m_bits | other.m_bits);
    return *this;
  }

  friend constexpr Criterion_set operator|(Criterion_set a, Criterion_set b) { return a |= b; }
  friend constexpr bool operator==(Criterion_set a, Criterion_set b) { return a.m_bits == b.m_bits; }
  friend constexpr bool operator!=(Criterion_set a, Criterion_set b) { return a.m_bits != b.m_bits; }

  // an order, for containers
  friend constexpr bool operator<(Criterion_set a, Criterion_set b) { return a.m_bits < b.m_bits; }
};

/// \ingroup PkgParametricSurfaceMesherRef
/// what a criterion is called in messages.
inline const char* name(Mesh_criterion criterion)
{
  switch(criterion) {
  case Mesh_criterion::SIZE: return "size";
  case Mesh_criterion::ANGLE: return "angle";
  case Mesh_criterion::DEVIATION: return "deviation";
  case Mesh_criterion::DISTANCE: return "distance";
  case Mesh_criterion::USER: return "criterion of the user";
  case Mesh_criterion::INVERTED: return "orientation";
  }
  return "";
}

/// \ingroup PkgParametricSurfaceMesherRef
/// what a cause is called in messages.
inline const char* name(Unmet_cause cause)
{
  switch(cause) {
  case Unmet_cause::BOUNDARY: return "boundary";
  case Unmet_cause::MINIMUM_EDGE: return "minimum edge";
  case Unmet_cause::SPACING: return "spacing";
  case Unmet_cause::NO_BETTER_POINT: return "lack of a better point";
  case Unmet_cause::VERTEX_LIMIT: return "vertex limit";
  case Unmet_cause::WORK_LIMIT: return "work limit";
  case Unmet_cause::STOPPED: return "stop by the visitor";
  case Unmet_cause::ANGLE_LIMIT: return "limit of angles by refinement";
  }
  return "";
}

/// \ingroup PkgParametricSurfaceMesherRef
/// the names of several criteria, separated by commas.
inline std::string names(Criterion_set criteria)
{
  std::string result;
  for(Mesh_criterion criterion : all_criteria())
    if(criteria.contains(criterion))
      result += (result.empty() ? "" : ", ") + std::string(name(criterion));
  return result;
}

} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_MESH_CRITERION_H
