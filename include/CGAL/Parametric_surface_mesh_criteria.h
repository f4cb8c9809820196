// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESH_CRITERIA_H
#define CGAL_PARAMETRIC_SURFACE_MESH_CRITERIA_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/Mesh_options.h>
#include <CGAL/Parametric_surface_mesher/internal/support/check_value.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherRef

What a mesh must meet. All lengths are in the unit of the surface. A default constructed object asks for a smallest angle
of 30 degrees, a deviation ratio of 0.05, and sizes from the extent of the boundary.

The values come in four groups: sizes, tolerances, improvement, and execution. Each value is checked when it is set.

A criterion of one's own is passed beside it: see `CGAL::parameters::triangle_criterion()`.
*/
class Parametric_surface_mesh_criteria
{
public:
  /// the wanted edge length at the parameters `(u,v)`: a `std::function<double(double, double)>`.
  typedef Parametric_surface_mesher::Sizing_options::Sizing_field Sizing_field;

private:
  // In degrees. Measured on CAD models: 33 in place of 30 makes up to twice as many triangles, 34 up to six times, with smaller smallest angles.
  static constexpr double largest_angle_of_refinement = 32;

  Parametric_surface_mesher::Sizing_options m_sizing;
  Parametric_surface_mesher::Tolerance_options m_tolerances;
  Parametric_surface_mesher::Improvement_options m_improvement;
  Parametric_surface_mesher::Execution_options m_execution;

public:
  /// \name Criteria
  /// Each function sets one value and returns the object, so that calls chain. A value out of its range throws a
  /// `Parametric_surface_mesh_error` that tells both, with and without `NDEBUG`, and leaves the object as it was.
  /// @{

  /// the wanted edge length where nothing else requires shorter edges, and the longest edge of the boundary division.
  /// Default: 1/20 of the diagonal of the boundary's bounding box.
  /// Range: positive and finite.
  Parametric_surface_mesh_criteria& set_max_edge(double length)
  {
    Parametric_surface_mesher::internal::check_positive_and_finite("maximum edge length", length);
    m_sizing.max_edge = length;
    return *this;
  }

  /// the shortest length into which edges are divided: an edge is not divided for the sake of deviation, on the boundary or
  /// inside, if it is shorter than twice this length; and no two inner points are closer to each other. What such edges fail
  /// is in the report. Default: 1/200 of `max_edge()`, or of the default of that if it is smaller.
  /// Range: positive and finite.
  Parametric_surface_mesh_criteria& set_min_edge(double length)
  {
    Parametric_surface_mesher::internal::check_positive_and_finite("minimum edge length", length);
    m_sizing.min_edge = length;
    return *this;
  }

  /// the bound `gamma` of the deviation ratio `H/L`. Default: 0.05. Range: positive;
  /// with infinity the ratio does not count.
  Parametric_surface_mesh_criteria& set_gamma(double gamma)
  {
    Parametric_surface_mesher::internal::check_positive("deviation ratio gamma", gamma);
    m_tolerances.gamma = gamma;
    return *this;
  }

  /// the bound of the smallest angle, in degrees. Default: 30. Refinement goes for no more than 32 degrees, since with more it makes
  /// many triangles and few better ones; improvement aims at what is above that. Triangles that are left with smaller angles are reported. Range: at least 0 and below 60.
  Parametric_surface_mesh_criteria& set_angle(double degrees)
  {
    Parametric_surface_mesher::internal::check_smallest_angle("smallest angle", degrees);
    m_tolerances.angle = degrees;
    return *this;
  }

  /// the factor `C` of the size criterion (paper, eq. 3): a triangle is too large if its circumradius is above
  /// `C (S_1 + S_2 + S_3)`, or above 0.91 of that if it has an angle below 46 degrees. With the default the number of
  /// triangles is that of equilateral ones with the wanted edge length. Default: 0.28.
  /// Range: positive and finite.
  Parametric_surface_mesh_criteria& set_size_factor(double c)
  {
    Parametric_surface_mesher::internal::check_positive_and_finite("size factor", c);
    m_sizing.size_factor = c;
    return *this;
  }

  /// how fast edges grow away from the boundary: the increase of the spacing, up to `max_edge()`, as a share of the distance.
  /// With 0 the spacing inside is a mean of that on the boundary (paper, eq. 2), so that a boundary that is fine all around
  /// makes a fine mesh; 0.1 saves many triangles. Values up to 0.2 leave room for angles of 30 degrees. Default: 0. Range: at least 0 and
  /// finite.
  Parametric_surface_mesh_criteria& set_growth(double growth)
  {
    Parametric_surface_mesher::internal::check_not_negative_and_finite("growth", growth);
    m_sizing.growth = growth;
    return *this;
  }

  /// the bound of the distance from the surface to a triangle, sampled at its edge middles and its centroid, and at more places
  /// where that comes close to the bound.
  /// Default: none. Range: positive.
  Parametric_surface_mesh_criteria& set_distance(double distance)
  {
    Parametric_surface_mesher::internal::check_positive("distance", distance);
    m_tolerances.distance = distance;
    return *this;
  }

  /// the width of detail of a model that may vanish where it would make angles below 15 degrees: edges shorter than this become
  /// a vertex, faces and parts of faces narrower than this are closed up, and the edges on both sides of them become one. No
  /// point moves farther than this, and the topology of each shell stays as it is. Sheets that face each other, as the
  /// sides of a thin wall, are not joined. The triangles meet the bound of the distance, if they did before.
  /// `Parametric_surface_mesh_report::removed_details` tells what has vanished. A share, such as three quarters, of the bound of the
  /// distance is a good choice. Default: nothing vanishes. Range: positive and finite.
  Parametric_surface_mesh_criteria& set_detail(double width)
  {
    Parametric_surface_mesher::internal::check_positive_and_finite("width of detail", width);
    m_tolerances.detail = width;
    return *this;
  }

  /// the number of lines, in each direction of the bounding box of the domain, where features are looked for that
  /// large triangles miss. A feature is found if it is higher than the criteria allow over a square with sides of two
  /// gaps between lines. Surfaces with a function `feature_lines()` (see `ParametricSurface_3`) are looked at on their own lines
  /// instead. 0 for no look. Default: 64.
  Parametric_surface_mesh_criteria& set_feature_resolution(std::size_t number_of_lines)
  {
    m_tolerances.feature_resolution = number_of_lines;
    return *this;
  }

  /// the maximum length of a boundary edge, as a multiple of the local width of its face. Longer edges are halved, down to the
  /// minimum edge; so are edges more than 2.5 times as long as a neighbour on the loop, and edges that are longer than
  /// one across the face by more than the distance between them. Where halves would be shorter than the minimum edge, several
  /// edges in a row are replaced by as many more as have room, and points are moved along narrow faces to where they are
  /// opposite to the middles of edges. Where this leaves angles below 10 degrees, edges become shorter than the minimum edge, as long as
  /// that makes no more than a few percent more triangles in all. The points of an edge of a model are the same for all its faces.
  /// Narrow faces thus get more triangles, without small angles. A value of 1.8 leaves room for angles of 30
  /// degrees. By default the width of faces does not count. Range: positive.
  Parametric_surface_mesh_criteria& set_closeness(double c)
  {
    Parametric_surface_mesher::internal::check_positive("closeness", c);
    m_sizing.closeness = c;
    return *this;
  }

  /// a field of wanted edge lengths, which bounds the spacing together with `max_edge()`. Its values must be positive.
  Parametric_surface_mesh_criteria& set_sizing_field(Sizing_field field)
  {
    m_sizing.field = field ? std::make_shared<const Sizing_field>(std::move(field)) : nullptr;
    return *this;
  }

  /// the deviation measure of the boundary division.
  Parametric_surface_mesh_criteria& set_curve_deviation(Parametric_surface_mesher::Curve_deviation measure)
  {
    m_tolerances.curve_deviation = measure;
    return *this;
  }

  /// what is done about triangles of one solid that pass through each other, and about folds, which are reported only. Looking for them
  /// takes half a microsecond to one for a triangle, a fifth of the time of meshing; with `REFINED` a model whose mesh intersects itself is
  /// meshed several times. Edges may become shorter than the minimum edge there. Default: `IGNORED`.
  Parametric_surface_mesh_criteria& set_self_intersections(Parametric_surface_mesher::Self_intersections handling)
  {
    m_tolerances.self_intersections = handling;
    return *this;
  }

  /// where new points are put. Default: `FRONTAL`, which gives the best triangles; `CIRCUMCENTER` is the fastest.
  Parametric_surface_mesh_criteria& set_placement(Parametric_surface_mesher::Mesh_point_placement placement)
  {
    m_improvement.placement = placement;
    m_improvement.own_placement = nullptr;
    return *this;
  }

  /// takes a placement of the user for triangles that fail: a model of `ParametricSurfacePointPlacement`. Default: none.
  /// Meshing throws if it returns what are no barycentric coordinates.
  Parametric_surface_mesh_criteria& set_placement(const Parametric_surface_mesher::Own_placement& placement)
  {
    m_improvement.placement = Parametric_surface_mesher::Mesh_point_placement::CIRCUMCENTER;
    m_improvement.own_placement = placement;
    return *this;
  }

  /// the largest number of sweeps over the inner vertices, or 0 for none. The first two, before the refinement for deviation,
  /// move vertices to where the triangles around them are closest to equilateral. Further ones, at the end, polish: they increase
  /// mean ratios and smallest angles, make no more triangles fail a criterion, and do not decrease smallest angles below 40
  /// degrees. Sweeps end when one moves few vertices. Default: 2, or 5 for a patch of at least 2000 vertices of which
  /// the second sweep has moved a fifth. On models of many smaller patches 5 sweeps instead of 2 raise the mean smallest angle
  /// by 0.6 to 1.5 degrees, in 1.4 to 2.3 times the time.
  Parametric_surface_mesh_criteria& set_max_number_of_sweeps(unsigned int n)
  {
    m_improvement.max_number_of_sweeps = n;
    return *this;
  }

  /// the smallest angle, in degrees, that the improvement aims at, by moves and flips around the triangles below it. It is not
  /// a criterion: triangles below it are not reported. With 0 only triangles that fail a criterion are improved. Default: 40.
  /// Range: at least 0 and below 60.
  Parametric_surface_mesh_criteria& set_improvement_angle(double degrees)
  {
    Parametric_surface_mesher::internal::check_smallest_angle("improvement angle", degrees);
    m_improvement.angle = degrees;
    return *this;
  }

  /// the largest time spent on the improvement of each patch, in seconds; afterwards no sweep begins and no triangle is
  /// improved. With such a limit the mesh depends on the speed of the machine. Default: none. Range: at
  /// least 0.
  Parametric_surface_mesh_criteria& set_improvement_time(double seconds)
  {
    Parametric_surface_mesher::internal::check_not_negative("improvement time", seconds);
    m_improvement.time = seconds;
    return *this;
  }

  /// the largest number of vertices, a guard against meshes too large for the machine. Each face of a model may have as many as
  /// those before it have left; a large one shares them out among its parts. Default: 20 million.
  Parametric_surface_mesh_criteria& set_max_number_of_vertices(std::size_t n)
  {
    m_execution.max_number_of_vertices = n;
    return *this;
  }

  /// the largest number of triangles, by an estimate, of a patch that is not split; 0 if patches are never split. The parts of
  /// larger patches have up to half as many triangles, or a fiftieth of the patch if that is more; they are meshed
  /// independently, by several threads if there are some, and joined. The split depends on the patch and the criteria alone.
  /// It changes the order of vertices and faces, and makes up to 15 percent more triangles where sizes differ much within a
  /// patch. Patches with collapsed sides and no chart, or with loops that touch, are not split.
  /// Default: 100000 with frontal placement, whose speed depends on the size of parts; 2 million with the others.
  Parametric_surface_mesh_criteria& set_part_size(std::size_t number_of_triangles)
  {
    m_execution.part_size = number_of_triangles;
    return *this;
  }
  /// @}

  /// \name Access
  /// @{

  /// the groups of values.
  const Parametric_surface_mesher::Sizing_options& sizing() const { return m_sizing; }
  const Parametric_surface_mesher::Tolerance_options& tolerances() const { return m_tolerances; }
  const Parametric_surface_mesher::Improvement_options& improvement() const { return m_improvement; }
  const Parametric_surface_mesher::Execution_options& execution() const { return m_execution; }

  /// the maximum edge length. The mesher fills in the default before anything else sees the criteria; in those of a user
  /// `sizing().max_edge` tells whether there is one.
  /// \throws Parametric_surface_mesh_error if it has not been set
  double max_edge() const { return length("maximum", m_sizing.max_edge); }

  /// the minimum edge length, with the same remarks.
  double min_edge() const { return length("minimum", m_sizing.min_edge); }

  double gamma() const { return m_tolerances.gamma; }
  /// the part of `angle()` that refinement goes for: at most 32 degrees.
  double angle_of_refinement() const { return (std::min)(angle(), largest_angle_of_refinement); }
  double angle() const { return m_tolerances.angle; }
  double size_factor() const { return m_sizing.size_factor; }
  double growth() const { return m_sizing.growth; }
  const std::optional<double>& distance() const { return m_tolerances.distance; }
  const std::optional<double>& detail() const { return m_tolerances.detail; }
  std::size_t feature_resolution() const { return m_tolerances.feature_resolution; }
  const std::optional<double>& closeness() const { return m_sizing.closeness; }
  /// the sizing field, or null.
  const std::shared_ptr<const Sizing_field>& sizing_field() const { return m_sizing.field; }
  Parametric_surface_mesher::Curve_deviation curve_deviation() const { return m_tolerances.curve_deviation; }
  Parametric_surface_mesher::Self_intersections self_intersections() const { return m_tolerances.self_intersections; }
  Parametric_surface_mesher::Mesh_point_placement placement() const { return m_improvement.placement; }
  const Parametric_surface_mesher::Own_placement& own_placement() const { return m_improvement.own_placement; }
  const std::optional<unsigned int>& max_number_of_sweeps() const { return m_improvement.max_number_of_sweeps; }
  double improvement_angle() const { return m_improvement.angle; }
  double improvement_time() const { return m_improvement.time; }
  std::size_t max_number_of_vertices() const { return m_execution.max_number_of_vertices; }
  std::size_t part_size() const
  {
    return m_execution.part_size.value_or(
      placement() == Parametric_surface_mesher::Mesh_point_placement::FRONTAL ? 100000 : 2000000);
  }
  /// @}

private:
  static double length(const char* which, const std::optional<double>& length)
  {
    if(!length)
      throw Parametric_surface_mesh_error(std::string("the ") + which + " edge length has not been set");
    return *length;
  }
};

} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESH_CRITERIA_H
