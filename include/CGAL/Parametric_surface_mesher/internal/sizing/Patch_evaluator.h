// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_PATCH_EVALUATOR_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_PATCH_EVALUATOR_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Chord_jet.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Spacing_limit.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/regular_tensor.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Evaluated_point_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_point_2.h>
#include <CGAL/Parametric_surface_oracle_3.h>
#include <CGAL/Surface_jet_3.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Evaluates surface, metric and sizes at a domain point: once for each point of the mesh.
template <class Oracle_>
class Patch_evaluator
{
public:
  typedef Oracle_ Oracle;
  typedef typename Oracle::Geom_traits Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef Evaluated_position<Kernel> Position;
  typedef Evaluated_point<Kernel> Evaluated;

private:
  const Oracle& m_oracle;
  Spacing_limit<Oracle> m_spacing_limit;
  Chord_jet<typename Oracle::Surface> m_chord_jet;
  double m_gamma, m_growth;

public:
  // `box`: of the patch, in the coordinates that it is meshed in
  Patch_evaluator(const Oracle& oracle, const Parametric_surface_mesh_criteria& criteria, const Bbox_2& box)
    : m_oracle(oracle),
      // in a chart the lines of the domain count, and `box` is not theirs
      m_spacing_limit(oracle, criteria, oracle.surface().chart().is_identity() ? box : Bbox_2()),
      m_chord_jet(oracle.surface(), box), m_gamma(criteria.gamma()),
      m_growth(criteria.growth())
  {}

  const Oracle& oracle() const { return m_oracle; }

  // see `Parametric_surface_mesh_criteria::set_growth()`
  double growth() const { return m_growth; }

  // `spacing`: of the neighbourhood; over such lengths the tensor is to tell distances
  Evaluated operator()(const Point_2& uv, double spacing) const { return with_spacing_limit(position(uv, spacing)); }

  // with the point in space given, for boundary vertices
  Evaluated operator()(const Point_2& uv, const Point_3& surface_point, double spacing) const
  {
    return with_spacing_limit(position(uv, surface_point, m_oracle.surface().jet(uv.x(), uv.y()), spacing));
  }

  // for a point that need not become one of the mesh: without the sizes, which cost as much again
  Position position(const Point_2& uv, double spacing) const
  {
    const Surface_jet_3<Kernel> jet = m_oracle.surface().jet(uv.x(), uv.y());
    return position(uv, jet.point, jet, spacing);
  }

  // the largest spacing allowed there
  double spacing_limit(const Position& position) const { return spacing_limit(position.point.domain_point(), position.jet); }

private:
  Evaluated with_spacing_limit(const Position& position) const { return {position, spacing_limit(position)}; }

  Position position(const Point_2& uv, const Point_3& surface_point, const Surface_jet_3<Kernel>& jet, double spacing) const
  {
    if(!std::isfinite(surface_point.x() + surface_point.y() + surface_point.z()))
      throw_not_finite(m_oracle.surface(), uv);
    const Metric_tensor_2 by_derivatives = tensor_of_field(m_oracle, uv, jet);
    const double length = length_of_edges(uv, jet, spacing);
    const bool is_by_chords = length > 0;
    const Regular_tensor regular
      = regular_tensor(is_by_chords ? tensor_of_field(m_oracle, uv, m_chord_jet(uv, jet, length)) : by_derivatives);
    Patch_point_2<Kernel> point(uv, surface_point, regular.tensor);
    set_line_point(m_oracle.surface(), point);
    return {point, jet, is_by_chords || regular.is_replaced, regular.is_singular};
  }

  // the length over which the jet does not tell distances, or 0 if it does
  double length_of_edges(const Point_2& uv, const Surface_jet_3<Kernel>& jet, double spacing) const
  {
    if(!changes_within(jet, spacing, m_gamma))
      return 0;
    const double length = (std::min)(spacing_limit(uv, jet), spacing);
    return changes_within(jet, length, m_gamma) ? length : 0;
  }

  // curvature limits the spacing by what the lines of the domain do, in most charts not those of the chart
  double spacing_limit(const Point_2& uv, const Surface_jet_3<Kernel>& jet) const
  {
    return m_oracle.surface().chart().is_identity() ? m_spacing_limit(uv, jet)
                                                    : m_spacing_limit(uv, m_oracle.surface().line_jet(uv));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_PATCH_EVALUATOR_H
