// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_MESH_APART_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_MESH_APART_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/Fold_search.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/Intersection_refinement.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/Meshed_faces.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/mesh_model.h>
#include <CGAL/Parametric_surface_mesher/internal/model/Bad_faces.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Intersection_search.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Mesh_progress.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Phase_timer.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// For each face of a model the solids that its triangles in a mesh bound: two if its other side has no triangles of its own.
template <class Model, class Mesh>
std::vector<std::vector<std::size_t>> solids(const Model& model, const Mesh& mesh)
{
  std::vector<std::vector<std::size_t>> result(model.faces().size());
  for(std::size_t f = 0; f < result.size(); ++f) {
    const auto& face = model.faces()[f];
    const bool has_own_triangles = mesh.has_other_sides || face.other_side_of == Model::no_face;
    if(face.solid)
      result[has_own_triangles ? f : face.other_side_of].push_back(*face.solid);
  }
  return result;
}

// Looks for intersections and folds in a mesh, as far as the criteria ask for that. Returns whether the model is to be meshed again, with
// the sizes of `refinement`; else what is left is in the report. Whoever stops here has the mesh as it is.
template <class Model, class Mesh>
bool is_to_be_refined(const Model& model, const Parametric_surface_mesh_criteria& criteria, const Mesh& mesh, Mesh_progress& progress,
                      std::optional<Intersection_refinement<Model>>& refinement, Parametric_surface_mesh_report& report)
{
  if(criteria.self_intersections() == Self_intersections::IGNORED || report.is_stopped)
    return false;
  progress.on_phase("intersections");
  report.is_stopped = progress.is_stopped();
  if(report.is_stopped)
    return false;
  Phase_timer timer(report.seconds.intersections);
  const Intersection_search<typename Model::Geom_traits> search(mesh);
  const auto solids_of_patches = solids(model, mesh);
  const auto pairs = search(solids_of_patches);
  if(!refinement)
    refinement.emplace(model, criteria, report.min_edge, report.max_edge);
  if(criteria.self_intersections() == Self_intersections::REFINED && refinement->change_sizes(mesh, pairs))
    return true;
  report.intersections = report_of_intersections(search, mesh, pairs, [&](const auto& pair) {
    return refinement->are_surfaces_in_contact(mesh, pair);
  });
  report.folds = Fold_search<Model>(model, mesh)(solids_of_patches);
  return false;
}

// Meshes a model, and again with smaller sizes where the mesh intersects itself. `number_points`: gives the points of the division their
// indices. `kept_faces`: of an earlier run that would be meshed in the same way, then those of this one; a null pointer if none are kept.
// `finish`: is called with the division and the points where several pieces of the mesh may meet
// \pre the mesh is empty
template <class ConcurrencyTag, class Model, class Criteria, class MetricField, class Numbering, class Mesh, class Finish>
void mesh_apart(const Model& model, const Criteria& criteria, const MetricField& metric, Mesh_progress& progress,
                const Bad_faces& bad_faces, Meshed_faces<typename Model::Geom_traits>* kept_faces, const Numbering& number_points,
                Mesh& mesh, Parametric_surface_mesh_report& report, const Finish& finish)
{
  const Mesh empty = mesh;
  std::optional<Model> finer_model;
  std::optional<Intersection_refinement<Model>> refinement;
  Meshed_faces<typename Model::Geom_traits> faces_of_run;
  if(kept_faces == nullptr && criteria.self_intersections() == Self_intersections::REFINED)
    kept_faces = &faces_of_run;
  for(bool is_done = false; !is_done;) {
    mesh = empty;
    Bad_faces bad_faces_of_round = bad_faces;
    const auto seconds = report.seconds;
    report = Parametric_surface_mesh_report();
    report.seconds = seconds;
    auto mesher = make_model_mesher(finer_model ? *finer_model : model, criteria, metric, progress, bad_faces_of_round,
                                    kept_faces, report);
    auto division = mesher.divide();
    mesher.template mesh_faces<ConcurrencyTag>(division, number_points, mesh);
    is_done = !is_to_be_refined(model, criteria, mesh, progress, refinement, report);
    if(is_done)
      finish(division, mesher.meeting_points());
    else
      finer_model = refinement->finer_model(*kept_faces);
  }
  if(finer_model)
    refinement->forget_refined(*kept_faces);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_MESH_APART_H
