// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_MESH_OPTIONS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_MESH_OPTIONS_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesher/Point_placements.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace CGAL {
namespace Parametric_surface_mesher {

/// \ingroup PkgParametricSurfaceMesherRef
/// how the boundary division measures the deviation of an edge (paper, section "Curve Division").
enum class Curve_deviation
{
  HEIGHT_OVER_CHORD, ///< `H/L`, arc height over chord length: the paper's simplified form
  HEIGHT_OVER_RADIUS ///< `H/R`, arc height over the curvature radius at the middle
};

/// \ingroup PkgParametricSurfaceMesherRef
/// what is done about triangles of one solid that pass through each other, or lie on each other: see
/// `Parametric_surface_model_3::Face::solid`.
enum class Self_intersections
{
  IGNORED,  ///< they are not looked for
  REPORTED, ///< they are listed in the report
  /// the model is meshed again, with shorter edges where facets pass through each other though their surfaces do not; what is left is
  /// listed in the report
  REFINED
};

/// \ingroup PkgParametricSurfaceMesherRef
/// where the refinement puts new points.
enum class Mesh_point_placement
{
  CIRCUMCENTER, ///< at the centre of a bad triangle's circumellipse: the paper's
  OFF_CENTER,   ///< nearer to the shortest edge of a bad triangle, where the new triangle has the wanted angle (Ungor 2004)
  FRONTAL       ///< from the boundary inwards, so that triangles of the wanted size arise; circumcentres for what is left
};

/// \ingroup PkgParametricSurfaceMesherRef
/// a model of `ParametricSurfacePointPlacement`, or none.
typedef std::function<Triangle_weights(const Triangle_weights& squared_lengths, double spacing)> Own_placement;

/// \ingroup PkgParametricSurfaceMesherRef
/// how long edges are to be. The functions of `Parametric_surface_mesh_criteria` that set the values explain them; this and
/// the next three groups are what it consists of.
struct Sizing_options
{
  /// the wanted edge length at the parameters `(u,v)`.
  typedef std::function<double(double u, double v)> Sizing_field;

  std::optional<double> max_edge;  ///< by default a share of the extent of the boundary
  std::optional<double> min_edge;  ///< by default a share of `max_edge`
  double size_factor = 0.28;       ///< `C` of the size criterion (paper, eq. 3)
  double growth = 0;               ///< of the spacing inside, as a share of the distance
  std::optional<double> closeness; ///< length of boundary edges over the width of a face; by default it does not count
  /// by default none. Copies of the options share it.
  std::shared_ptr<const Sizing_field> field;
};

/// \ingroup PkgParametricSurfaceMesherRef
/// how close to the surface and how well shaped triangles are to be.
struct Tolerance_options
{
  double gamma = 0.05;            ///< bound of the deviation ratio `H/L`
  double angle = 30;              ///< bound of the smallest angle, in degrees
  std::optional<double> distance; ///< bound of the distance from the surface; by default there is none
  std::optional<double> detail;   ///< width of detail that may vanish; by default all is kept
  std::size_t feature_resolution = 64; ///< lines in either direction on which features are looked for
  Curve_deviation curve_deviation = Curve_deviation::HEIGHT_OVER_CHORD; ///< measure of the boundary division
  Self_intersections self_intersections = Self_intersections::IGNORED;  ///< what is done about them
};

/// \ingroup PkgParametricSurfaceMesherRef
/// what is done for better triangles than the tolerances ask for.
struct Improvement_options
{
  Mesh_point_placement placement = Mesh_point_placement::FRONTAL; ///< where new points are put
  Own_placement own_placement;                      ///< of the user, in place of that; none by default
  std::optional<unsigned int> max_number_of_sweeps; ///< over the inner vertices; the default depends on the patch
  double angle = 40;                                ///< smallest angle that is aimed at, in degrees
  double time = std::numeric_limits<double>::infinity(); ///< limit for each patch, in seconds
};

/// \ingroup PkgParametricSurfaceMesherRef
/// what the run may use, and how it is divided.
struct Execution_options
{
  std::size_t max_number_of_vertices = 20000000; ///< of each patch, or of all patches of a model together
  std::optional<std::size_t> part_size; ///< triangles above which a patch is split; the default depends on the placement
};

} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_MESH_OPTIONS_H
