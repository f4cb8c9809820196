// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESH_REPORT_H
#define CGAL_PARAMETRIC_SURFACE_MESH_REPORT_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesher/Mesh_criterion.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherRef

What meshing did, and what it could not do. Angles are in degrees and, as lengths, those of the triangles in space.
*/
struct Parametric_surface_mesh_report
{
  /// a triangle that fails criteria.
  struct Unmet
  {
    std::size_t face;                                  ///< index of the face in the mesh, in the order of its creation
    Parametric_surface_mesher::Criterion_set criteria; ///< all that it fails
    /// why the last attempt to refine it was refused, or why none was made
    Parametric_surface_mesher::Unmet_cause cause;
  };

  /// a face of the model that the mesh is without: see `CGAL::parameters::leaves_out_bad_faces()`.
  struct Left_out_face
  {
    std::size_t face;   ///< its index in the model
    std::string reason; ///< the error that it causes
  };

  /// detail of a face of the model that the mesh is without: see `Parametric_surface_mesh_criteria::set_detail()`.
  struct Removed_detail
  {
    std::size_t face;                ///< the index of the face in the model
    std::size_t number_of_triangles; ///< of its triangles that vanished, where edges or vertices of the model were joined
    double moved;                    ///< how far points moved there, at most
    std::array<double, 3> place;     ///< a point where it was
    bool is_closed_up;               ///< whether the face has no triangle any more
  };

  /// two faces of the model, or one twice, of which triangles pass through each other or lie on each other: see
  /// `Parametric_surface_mesh_criteria::set_self_intersections()`.
  struct Intersection
  {
    std::array<std::size_t, 2> faces; ///< their indices in the model, in ascending order
    std::size_t number_of_pairs;      ///< of triangles
    std::array<double, 3> place;      ///< a point of one of them
    /// whether at all of these pairs the surfaces themselves cross or touch, so that no mesh of them could do otherwise
    bool is_of_surfaces;
  };

  /// two faces of the model, or one twice, of which triangles with a common edge face each other, although the surfaces do not: see
  /// `Parametric_surface_mesh_criteria::set_self_intersections()`.
  struct Fold
  {
    std::array<std::size_t, 2> faces; ///< their indices in the model, in ascending order
    std::size_t number_of_pairs;      ///< of triangles
    std::array<double, 3> place;      ///< a point of one of them
  };

  /// time in seconds that was spent on each phase, by all threads together; if others use the processor, it counts, too.
  struct Seconds
  {
    double division = 0, triangulation = 0, refinement = 0, improvement = 0, intersections = 0, output = 0;
    /// the sum of all phases.
    double meshing() const { return division + triangulation + refinement + improvement + intersections + output; }

    /// adds phase by phase.
    Seconds& operator+=(const Seconds& other)
    {
      division += other.division;
      triangulation += other.triangulation;
      refinement += other.refinement;
      improvement += other.improvement;
      intersections += other.intersections;
      output += other.output;
      return *this;
    }
  };

  double max_edge = 0; ///< the maximum edge length in effect
  double min_edge = 0; ///< the minimum edge length in effect

  std::size_t number_of_vertices = 0;
  std::size_t number_of_faces = 0;
  std::size_t number_of_boundary_edges = 0; ///< of the division
  /// how often the division was refined because its straight segments crossed
  std::size_t number_of_split_boundary_edges = 0;
  /// how often a piece of the division was halved because its face is narrow there, or its neighbour short
  std::size_t number_of_edges_split_by_closeness = 0;
  /// how many more pieces the division has where faces are so narrow that pieces are shorter than the minimum edge
  std::size_t number_of_edges_added_to_thin_strips = 0;
  /// points where the parametrisation is singular within an edge length, and chords gave the tensor in place of derivatives,
  /// or where the tensor of the metric field was not positive definite and was replaced
  std::size_t number_of_replaced_tensors = 0;
  /// how often a bound on the work was reached: of a search for a place in the domain, of flips, of attempts to repair triangles
  std::size_t number_of_work_limits = 0;
  std::size_t number_of_collapsed_faces = 0; ///< triangles on collapsed sides, which have no area and are left out
  double smallest_angle = 180;             ///< over all triangles
  /// over the triangles but those whose angle is too small because of the boundary
  double smallest_angle_off_boundary = 180;
  std::vector<Unmet> unmet;                ///< every triangle that fails a criterion
  /// whether the visitor has stopped meshing before it was done
  bool is_stopped = false;
  /// triangles that were not compared with the surface, because the visitor has stopped meshing: they may fail the criteria of
  /// deviation and distance though they are not among the unmet
  std::size_t number_of_unjudged_faces = 0;
  std::vector<Left_out_face> left_out;     ///< faces of the model that could not be meshed, by their indices
  std::vector<Removed_detail> removed_details; ///< by the indices of the faces
  std::vector<Intersection> intersections; ///< by the indices of the faces, if they were looked for
  std::vector<Fold> folds;                 ///< by the indices of the faces, if intersections were looked for
  Seconds seconds;

  /// the number of triangles that fail `criterion`, and maybe others, for `cause`.
  std::size_t count(Parametric_surface_mesher::Mesh_criterion criterion, Parametric_surface_mesher::Unmet_cause cause) const
  {
    return std::count_if(unmet.begin(), unmet.end(),
                         [=](const Unmet& u) { return u.criteria.contains(criterion) && u.cause == cause; });
  }

  /// the number of triangles that fail `criterion`, and maybe others.
  std::size_t count(Parametric_surface_mesher::Mesh_criterion criterion) const
  {
    return std::count_if(unmet.begin(), unmet.end(), [=](const Unmet& u) { return u.criteria.contains(criterion); });
  }

  /// the number of triangles that fail a criterion for `cause`.
  std::size_t count(Parametric_surface_mesher::Unmet_cause cause) const
  {
    return std::count_if(unmet.begin(), unmet.end(), [=](const Unmet& u) { return u.cause == cause; });
  }
};

} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESH_REPORT_H
