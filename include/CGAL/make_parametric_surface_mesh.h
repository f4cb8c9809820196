// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MAKE_PARAMETRIC_SURFACE_MESH_H
#define CGAL_MAKE_PARAMETRIC_SURFACE_MESH_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/First_fundamental_form_metric_2.h>
#include <CGAL/Parametric_domain_2.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesh_parameters.h>
#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesh_visitor.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/check_types.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/mesh_apart.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/with_good_faces.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/with_kept_faces.h>
#include <CGAL/Parametric_surface_mesher/internal/model/Bad_faces.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Criteria_with_own.h>
#include <CGAL/Parametric_surface_mesher/internal/model/model_of_patch.h>
#include <CGAL/Parametric_surface_mesher/internal/model/shells_of_faces.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Face_graph_filler.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Output_maps.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Places_in_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/output/separate_pieces.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Checked_metric_field_2.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Mesh_progress.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Phase_timer.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Parametric_surface_mesher/validate.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <type_traits>

namespace CGAL {

namespace Parametric_surface_mesher {
namespace internal {

template <class Visitor>
Visitor& unwrap(Visitor& visitor) { return visitor; }

template <class Visitor>
Visitor& unwrap(std::reference_wrapper<Visitor>& visitor) { return visitor.get(); }

template <class NamedParameters>
constexpr bool wants_corner_points()
{
  return !parameters::is_default_parameter<NamedParameters, Halfedge_uv_map_t>::value;
}

template <class NamedParameters>
constexpr bool wants_domain_points()
{
  return !parameters::is_default_parameter<NamedParameters, Vertex_uv_map_t>::value;
}

template <class NamedParameters, class Division, class Mesh>
auto places_in_mesh(const Division& division, const Mesh& mesh)
{
  if constexpr(parameters::is_default_parameter<NamedParameters, Vertex_place_map_t>::value
               && parameters::is_default_parameter<NamedParameters, Edge_place_map_t>::value)
    return No_places_in_mesh();
  else
    return Places_in_mesh<Division>(division, mesh);
}

// Hands a finished mesh to the user's data structure.
template <class ConcurrencyTag, class Division, class Kernel, class TriangleMesh, class NamedParameters>
void output(const Division& division, Indexed_mesh<Kernel>& mesh, TriangleMesh& tm, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Kernel::Point_2 Point_2;
  const auto vertex_point_map
    = choose_parameter(get_parameter(np, internal_np::vertex_point), get_property_map(vertex_point, tm));
  const auto vertex_uv_map
    = choose_parameter(get_parameter(np, Vertex_uv_map_t()),
                       Ignoring_property_map<typename Graph_traits::vertex_descriptor, Point_2>());
  const auto halfedge_uv_map
    = choose_parameter(get_parameter(np, Halfedge_uv_map_t()),
                       Ignoring_property_map<typename Graph_traits::halfedge_descriptor, Point_2>());
  const auto face_patch_id_map
    = choose_parameter(get_parameter(np, Face_patch_id_map_t()),
                       Ignoring_property_map<typename Graph_traits::face_descriptor, std::size_t>());
  const auto vertex_place_map
    = choose_parameter(get_parameter(np, Vertex_place_map_t()),
                       Ignoring_property_map<typename Graph_traits::vertex_descriptor, Vertex_place>());
  const auto edge_place_map
    = choose_parameter(get_parameter(np, Edge_place_map_t()),
                       Ignoring_property_map<typename Graph_traits::edge_descriptor, Edge_place>());
  add_to_face_graph<ConcurrencyTag>(mesh, tm,
                                    make_output_maps(vertex_point_map, vertex_uv_map, halfedge_uv_map, face_patch_id_map,
                                                     vertex_place_map, edge_place_map),
                                    places_in_mesh<NamedParameters>(division, mesh));
}

template <class NamedParameters>
bool leaves_out_bad_faces(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, Leaves_out_bad_faces_t()), false);
}

// The criteria with that of the user, if there is one.
inline const Parametric_surface_mesh_criteria& with_own_criterion(const Parametric_surface_mesh_criteria& criteria,
                                                                  internal_np::Param_not_found)
{
  return criteria;
}

template <class Criterion>
Criteria_with_own<Criterion> with_own_criterion(const Parametric_surface_mesh_criteria& criteria, const Criterion& own)
{
  return Criteria_with_own<Criterion>(criteria, own);
}

// Meshes a model and hands the result over to `finish`, with its division and the points where several pieces of it may meet.
// `Numbering` orders the points of the division.
template <class ConcurrencyTag, class Model, class NamedParameters, class Numbering, class Finish>
Parametric_surface_mesh_report mesh_model(const Model& model, const Bad_faces& bad_faces,
                                          const Parametric_surface_mesh_criteria& given_criteria,
                                          const NamedParameters& np, bool keeps_domain_points, bool keeps_corner_points,
                                          bool has_other_sides, Numbering number_points, Finish finish)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef typename Model::Geom_traits Kernel;
  const auto metric
    = checked_metric_field(choose_parameter(get_parameter(np, Metric_field_t()), First_fundamental_form_metric_2<Kernel>()));
  auto given_visitor = choose_parameter(get_parameter(np, internal_np::visitor), Parametric_surface_mesh_visitor());
  Mesh_progress progress(unwrap(given_visitor));

  const auto& criteria = with_own_criterion(given_criteria, get_parameter(np, Triangle_criterion_t()));
  Parametric_surface_mesh_report report;
  Indexed_mesh<Kernel> mesh;
  constexpr bool has_kept_faces = !parameters::is_default_parameter<NamedParameters, Kept_faces_t>::value;
  mesh.keeps_domain_points = keeps_domain_points || has_kept_faces;
  mesh.has_other_sides = has_other_sides;
  mesh.keeps_corner_points = keeps_corner_points || has_kept_faces || given_criteria.detail()
                             || given_criteria.self_intersections() != Self_intersections::IGNORED;
  with_kept_faces(model, criteria, metric, get_parameter(np, Kept_faces_t()), [&](Meshed_faces<Kernel>* kept_faces) {
    mesh_apart<ConcurrencyTag>(model, criteria, metric, progress, bad_faces, kept_faces, number_points, mesh, report,
                               [&](auto& division, const auto& meeting_points) {
                                 Phase_timer timer(report.seconds.output);
                                 progress.on_phase("output");
                                 finish(division, meeting_points, mesh);
                               });
  });
  report.number_of_vertices = mesh.number_of_points();
  return report;
}

// Meshes a model into a face graph.
template <class ConcurrencyTag, class Model, class TriangleMesh, class NamedParameters, class Numbering>
Parametric_surface_mesh_report mesh_model_into(TriangleMesh& tm, const Model& model, const Bad_faces& bad_faces,
                                               const Parametric_surface_mesh_criteria& criteria,
                                               const NamedParameters& np, Numbering number_points)
{
  return mesh_model<ConcurrencyTag>(model, bad_faces, criteria, np, wants_domain_points<NamedParameters>(),
                                    wants_corner_points<NamedParameters>(), true, number_points,
                                    [&](const auto& division, const auto& meeting_points, auto& mesh) {
                                      separate_pieces<ConcurrencyTag>(mesh, shells(model), meeting_points);
                                      output<ConcurrencyTag>(division, mesh, tm, np);
                                    });
}

} // namespace internal
} // namespace Parametric_surface_mesher

/*!
\ingroup PkgParametricSurfaceMesherFunctions

meshes a trimmed parametric surface.

The boundary of the domain is divided once; then the inside is triangulated and refined until every triangle meets the
criteria. The division is never changed: its points are the first vertices of the mesh, in the order of loops and curves.
What could not be met is in the report.

Loops may touch where their curves begin; the pieces of the mesh that meet in such a point have copies of it, at the end of
the vertices.

If the input is refused nothing is added to `tm`.

\tparam ConcurrencyTag `Sequential_tag` (default), `Parallel_tag` or `Parallel_if_available_tag`. With threads the parts of a
large patch (see `Parametric_surface_mesh_criteria::set_part_size()`) are meshed at the same time; the mesh is the same. What
that takes is said below, where models are meshed.
\tparam Surface a model of `ParametricSurface_3`
\tparam Kernel the kernel of the surface, `Surface::Geom_traits`
\tparam Criteria `Parametric_surface_mesh_criteria`
\tparam TriangleMesh a model of `MutableFaceGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param surface the surface
\param domain the trimmed part of its parameter domain
\param criteria what the mesh must meet
\param tm the mesh that the triangles are added to
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
                   as key type and `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_uv_map}
    \cgalParamDescription{a property map that takes the domain point of each vertex}
    \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
                   as key type and `%Point_2` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{halfedge_uv_map}
    \cgalParamDescription{a property map that takes the domain point of the target of each halfedge, in the domain of its face's patch}
    \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%halfedge_descriptor`
                   as key type and `%Point_2` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_place_map}
    \cgalParamDescription{a property map that takes, for each vertex, what it lies on: a model that is meshed has vertices, edges and faces; the edges
                          of a domain are its curves, loop by loop, its vertices are where they begin}
    \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
                   as key type and `Parametric_surface_mesher::Vertex_place` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{edge_place_map}
    \cgalParamDescription{a property map that takes, for each edge of `tm`, the edge of the model, or the curve of the domain, that it is a piece of}
    \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor`
                   as key type and `Parametric_surface_mesher::Edge_place` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{metric_field}
    \cgalParamDescription{the metric field that decides which triangles are well shaped}
    \cgalParamType{a model of `ParametricSurfaceMetricField_2`}
    \cgalParamDefault{`CGAL::First_fundamental_form_metric_2`}
  \cgalParamNEnd
  \cgalParamNBegin{triangle_criterion}
    \cgalParamDescription{a criterion of the user that the triangles are to meet, too}
    \cgalParamType{a model of `ParametricSurfaceTriangleCriterion`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{shows progress and can stop the refinement early; `std::ref` passes it by reference}
    \cgalParamType{a model of `ParametricSurfaceMeshVisitor`}
    \cgalParamDefault{`CGAL::Parametric_surface_mesh_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return counts, smallest angles, what was not met and why, and the time of each phase

\throws Parametric_surface_mesh_error for input that cannot be meshed: values that are not finite, loops that are open, cross
or are nested wrongly, a domain of area zero, a degenerate surface, or sizes that contradict each other

Complexity: `O(n log n)` in practice for `n` triangles.
*/
template <class ConcurrencyTag = Sequential_tag, class Surface, class Kernel, class Criteria, class TriangleMesh,
          class NamedParameters = parameters::Default_named_parameters>
Parametric_surface_mesh_report
make_parametric_surface_mesh(const Surface& surface, const Parametric_domain_2<Kernel>& domain, const Criteria& criteria,
                             TriangleMesh& tm, const NamedParameters& np = parameters::default_values())
{
  using namespace Parametric_surface_mesher::internal;
  if constexpr(check_surface<Surface, Kernel>() && check_options<Criteria, NamedParameters>()) {
    Bad_faces bad_faces(false);
    return mesh_model_into<ConcurrencyTag>(tm, model_of_patch(surface, domain), bad_faces, criteria, np,
                                           [](auto& division) { division.number_along_edges(); });
  }
  else
    return {};
}

/*!
\ingroup PkgParametricSurfaceMesherFunctions

meshes a model of several patches into one mesh. Each edge of the model is divided once, and its points are shared by all
faces that use it, so that the mesh has no crack along it.

The first vertices of the mesh are those vertices of the model that faces use; then come the inner points of its edges,
edge by edge in the order of their first use.

The triangles face as the faces of the model do. The mesh is closed where the model is: an edge with two uses in a shell
joins its faces, or one face with itself. Where an edge has one use, or three and more in one shell, the mesh has a border:
see `Parametric_surface_model_3::Face::shell`. Of a vertex that several pieces of the mesh meet in, each piece has a copy,
at the end of the vertices. So the mesh is always manifold; for triangles that share all points there is
`make_parametric_surface_triangle_soup()`.

The model is checked by `Parametric_surface_mesher::validate()` first.

\tparam ConcurrencyTag `Sequential_tag` (default), `Parallel_tag` or `Parallel_if_available_tag`. With threads the faces are
meshed at the same time, the largest first, and so are the parts of large ones; the mesh is the same, bit by bit. It takes oneTBB
(as for other CGAL packages, link with the target `CGAL::TBB_support`), and the memory for the triangulations of as many faces
as there are threads, and of those with an inner edge between two boundary vertices that another face has, too. Surfaces are
evaluated by several threads as `ParametricSurface_3` tells. Each face, and each part of one, has copies of the sizing field
and of a criterion of the user: what they refer to must bear several threads. A visitor is called by one thread at a time.
\tparam Surface a model of `ParametricSurface_3`

Criteria, mesh, named parameters, report and exceptions are as above; in addition:

\cgalNamedParamsBegin
  \cgalParamNBegin{face_patch_id_map}
    \cgalParamDescription{a property map that takes, for each face of the mesh, the index, from 0, of the patch that it lies on}
    \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor`
                   as key type and `std::size_t` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{leaves_out_bad_faces}
    \cgalParamDescription{whether a face that cannot be meshed is left out and reported, in place of an exception. Edges that
                          it shares with others may have been divided with a look at its sizes, too.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{kept_faces}
    \cgalParamDescription{the faces of an earlier run: those that would get the same triangles keep them and are not meshed again}
    \cgalParamType{`std::ref` of a `Parametric_surface_mesher::Kept_faces<Kernel>`}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd
*/
template <class ConcurrencyTag = Sequential_tag, class Surface, class Criteria, class TriangleMesh,
          class NamedParameters = parameters::Default_named_parameters>
Parametric_surface_mesh_report
make_parametric_surface_mesh(const Parametric_surface_model_3<Surface>& model, const Criteria& criteria,
                             TriangleMesh& tm, const NamedParameters& np = parameters::default_values())
{
  using namespace Parametric_surface_mesher::internal;
  if constexpr(check_surface<Surface, typename Surface::Geom_traits>() && check_options<Criteria, NamedParameters>())
    return with_good_faces(model, leaves_out_bad_faces(np), [&](const auto& checked_model, Bad_faces& bad_faces) {
      return mesh_model_into<ConcurrencyTag>(tm, checked_model, bad_faces, criteria, np,
                                             [](auto& division) { division.number_vertices_first(); });
    });
  else
    return {};
}

} // namespace CGAL

#endif // CGAL_MAKE_PARAMETRIC_SURFACE_MESH_H
