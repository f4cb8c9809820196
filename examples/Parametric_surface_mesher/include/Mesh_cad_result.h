// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading, meshing and measuring in mesh_cad.
#ifndef MESH_CAD_RESULT_H
#define MESH_CAD_RESULT_H

#include "Mesh_cad_contacts.h"
#include "Mesh_cad_options.h"
#include "Mesh_cad_parts.h"
#include "Mesh_cad_sizes.h"
#include "Progress_line.h"
#include "Second_order_measures.h"
#include "Silence.h"
#include "deciding_bounds.h"
#include "measure_cad_mesh.h"
#include "text_of_numbers.h"
#include "triangle_data.h"
#include "unit_of_length.h"
#include "with_threads.h"

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Triangle_mesh_quality.h>
#include <CGAL/make_mesh_page.h>

#include <CGAL/IO/read_open_cascade_shape.h>
#include <CGAL/carry_over_open_cascade_names.h>
#include <CGAL/fuse_open_cascade_solids.h>
#include <CGAL/make_model_of_open_cascade_shape.h>
#include <CGAL/name_mesh_page.h>
#include <CGAL/repair_open_cascade_shape.h>
#include <CGAL/sew_open_cascade_shape.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/diagonal_of_shape.h>

#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <sys/resource.h>

struct Mesh_cad_result
{
  CGAL::Open_cascade_model_3 shape;
  CGAL::Parametric_surface_mesh_criteria criteria; // with the default sizes filled in
  Cad_mesh mesh;
  CGAL::Parametric_surface_mesh_report report;
  CGAL::Triangle_mesh_quality quality;
  Cad_mesh_measures measures;
  bool is_distance_measured = true; // else this distance, that of curved triangles and the next are not known
  mesh_cad::Deciding_bounds deciding_bounds;
  mesh_cad::Layers layers; // with --layers
  boost::optional<Second_order_measures> second_order;
  CGAL::Open_cascade_names_3 names;
  CGAL::Mesh_page_3 page; // if it is wanted
  std::vector<CGAL::Element_mesh_3::Data> triangle_data; // if the file of the mesh shows it
  std::vector<std::string> file_faults; // what the file contains and the shape lacks
  std::vector<CGAL::Open_cascade_model_3::Left_out_face> left_out; // those of the shape and those of the report
  std::vector<Contact_of_parts> contacts; // with --conformal
  std::vector<Imprint_on_faces> imprints; // with --point and --curves
  TopoDS_Shape open_cascade_shape; // that was meshed, in millimetres
  std::size_t number_of_sewn_edges = 0, number_of_lost_faces = 0; // joined and lost by sewing
  double reading_seconds = 0, model_seconds = 0, meshing_seconds = 0, second_order_seconds = 0, measuring_seconds = 0,
         intersections_seconds = 0;
};

namespace mesh_cad {

// The processor time of this process and of the finished ones that it started, which read files.
inline double processor_seconds()
{
  double result = 0;
  for(int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage;
    if(::getrusage(who, &usage) == 0)
      result += double(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) + 1e-6 * double(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
  }
  return result;
}

// Calls `function` and returns its processor time in seconds.
template <class Function>
double seconds_of(Function function)
{
  const double start = processor_seconds();
  function();
  return processor_seconds() - start;
}

// Removes faces that the user does not want. `is_wanted_in_model` is asked with indices of the model, `is_wanted` with those of the shape.
template <class ModelPredicate, class Predicate>
void keep_faces(const ModelPredicate& is_wanted_in_model, const Predicate& is_wanted, CGAL::Open_cascade_model_3& shape)
{
  std::vector<std::size_t> numbers;
  shape.model.remove_faces([&](std::size_t f) {
    if(is_wanted_in_model(f))
      numbers.push_back(shape.shape_faces[f]);
    return !is_wanted_in_model(f);
  });
  shape.shape_faces.swap(numbers);
  const auto keep_wanted = [&](auto& list) {
    const auto is_unwanted_face = [&](const auto& face) { return !is_wanted(face.shape_face); };
    list.erase(std::remove_if(list.begin(), list.end(), is_unwanted_face), list.end());
  };
  keep_wanted(shape.left_out);
  keep_wanted(shape.closed_up);
}

inline void select_faces(const std::string& list, const Names& names, CGAL::Open_cascade_model_3& shape)
{
  if(list.empty())
    return;
  const Indices wanted = indices_in(Named_faces(names, shape), "faces", list);
  const auto is_wanted = [&](std::size_t face) { return wanted.count(face) > 0; };
  keep_faces([&](std::size_t f) { return is_wanted(shape.shape_faces[f]); }, is_wanted, shape);
}

// A face that two parts share is meshed as the boundary of those that are wanted.
inline void select_parts(const std::set<std::size_t>& wanted, const Names& names, CGAL::Open_cascade_model_3& shape)
{
  if(wanted.empty())
    return;
  const auto parts = CGAL::Parametric_surface_mesher::internal::parts_of_model_faces(shape, names);
  std::set<std::size_t> faces;
  for(const std::size_t part : wanted)
    faces.insert(names.parts[part].faces.begin(), names.parts[part].faces.end());
  if(faces.empty())
    throw Usage_error("--parts: there are no faces in part " + names.parts[*wanted.begin()].path);
  keep_faces([&](std::size_t f) { return is_in(names, parts[f], wanted); }, [&](std::size_t face) { return faces.count(face) > 0; }, shape);
}

inline CGAL::Parametric_surface_mesh_criteria make_criteria(const Mesh_cad_options& o, double diagonal)
{
  CGAL::Parametric_surface_mesh_criteria criteria;
  const double max_edge = o.max_edge > 0 ? o.max_edge : (std::max)(o.share_of_max_edge * diagonal, o.min_edge);
  criteria.set_max_edge(max_edge).set_min_edge(o.min_edge > 0 ? o.min_edge : (std::min)(diagonal / 1000, max_edge));
  criteria.set_gamma(o.gamma).set_angle(o.angle).set_closeness(o.closeness).set_growth(o.growth);
  using CGAL::Parametric_surface_mesher::Self_intersections;
  criteria.set_self_intersections(o.self_intersections == "ignore"   ? Self_intersections::IGNORED
                                  : o.self_intersections == "report" ? Self_intersections::REPORTED
                                                                     : Self_intersections::REFINED);
  if(o.sweeps)
    criteria.set_max_number_of_sweeps(*o.sweeps);
  criteria.set_distance(o.distance > 0 ? o.distance : o.relative_distance * diagonal);
  const double share_of_detail = 0.75; // of the distance: what the curvature takes is measured, and there is room for it
  if(!o.is_detail_kept)
    criteria.set_detail(o.detail > 0 ? o.detail : share_of_detail * *criteria.distance());
  return criteria;
}

// The tolerance of sewing, or 0 if the shape is not sewn. By default only IGES files are sewn, whose faces have no common edges.
inline double sewing_tolerance(const Mesh_cad_options& options, const TopoDS_Shape& shape)
{
  using namespace CGAL::Parametric_surface_mesher::internal;
  const double share_of_diagonal = 1e-5;
  if(options.sewing_tolerance >= 0)
    return options.sewing_tolerance;
  const std::string ending = ending_of(options.input);
  return ending == "iges" || ending == "igs" ? share_of_diagonal * diagonal_of_shape(shape) : 0;
}

// Parts that are apart by no more than this are listed.
inline double reach_of_gaps(const Mesh_cad_options& options, const TopoDS_Shape& shape)
{
  const double share_of_diagonal = 1e-3, multiple_of_fuzzy = 10;
  const double diagonal = CGAL::Parametric_surface_mesher::internal::diagonal_of_shape(shape);
  return (std::max)(share_of_diagonal * diagonal, multiple_of_fuzzy * options.fuzzy);
}

inline TopoDS_Shape read_shape(const Mesh_cad_options& options, Mesh_cad_result& result)
{
  const Silence silence;
  TopoDS_Shape shape = CGAL::IO::read_open_cascade_shape(options.input, "MM", result.file_faults, result.names);
  const double tolerance = sewing_tolerance(options, shape);
  if(tolerance > 0) {
    const CGAL::Sewn_open_cascade_shape sewn = CGAL::sew_open_cascade_shape(shape, tolerance);
    result.number_of_sewn_edges = sewn.number_of_sewn_edges;
    result.number_of_lost_faces = sewn.number_of_lost_faces;
    result.names = CGAL::carry_over_open_cascade_names(result.names, shape, sewn.history, sewn.shape);
    shape = sewn.shape;
  }
  if(options.is_healing_wanted) {
    opencascade::handle<BRepTools_History> history;
    const TopoDS_Shape repaired = CGAL::repair_open_cascade_shape(shape, history);
    result.names = CGAL::carry_over_open_cascade_names(result.names, shape, history, repaired);
    shape = repaired;
  }
  if(options.is_conformal) {
    const CGAL::Fused_open_cascade_solids fused = CGAL::fuse_open_cascade_solids(shape, options.fuzzy, reach_of_gaps(options, shape));
    result.contacts = contacts_between_parts(fused, result.names);
    if(!fused.history.IsNull())
      result.names = CGAL::carry_over_open_cascade_names(result.names, shape, fused.history, fused.shape);
    shape = fused.shape;
  }
  if(!options.points.empty() || !options.curves.empty()) {
    const double diagonal = CGAL::Parametric_surface_mesher::internal::diagonal_of_shape(shape);
    const double reach = options.reach > 0 ? options.reach : default_share_of_reach * diagonal;
    const auto imprinted = imprint(shape, options.points, options.curves, reach, result.file_faults, result.imprints);
    if(!imprinted.history.IsNull())
      result.names = CGAL::carry_over_open_cascade_names(result.names, shape, imprinted.history, imprinted.shape);
    name_imprints(imprinted, result.names);
    shape = imprinted.shape;
  }
  return shape;
}

// BREP files have no unit.
inline bool has_unit(const Mesh_cad_options& options)
{
  const std::string ending = CGAL::Parametric_surface_mesher::internal::ending_of(options.input);
  return ending != "brep" && ending != "rle";
}

// The number of the face and the reason.
inline std::string closed_up_text(const CGAL::Open_cascade_model_3::Closed_up_face& face, const mesh_patch::Text_of_length& length)
{
  return std::to_string(face.shape_face + 1) + " is closed up: it is nowhere wider than " + length(face.width);
}

// Lists the faces of the shape that have lost all their triangles. A face with creases is several of the model.
inline void note_closed_up_faces(Mesh_cad_result& result)
{
  std::set<std::size_t> meshed_faces;
  for(const auto f : result.mesh.mesh.faces())
    meshed_faces.insert(result.shape.shape_faces[result.mesh.patch[f]]);
  std::map<std::size_t, double> closed_up; // how far points moved
  for(const auto& detail : result.report.removed_details) {
    const std::size_t face = result.shape.shape_faces[detail.face];
    if(detail.is_closed_up && meshed_faces.count(face) == 0)
      closed_up[face] = (std::max)(closed_up[face], detail.moved);
  }
  for(const auto& face : closed_up)
    result.shape.closed_up.push_back({face.first, face.second});
}

inline void make_mesh(const Mesh_cad_options& options, Mesh_cad_result& result)
{
  if(result.shape.model.faces().empty()) {
    if(!result.shape.closed_up.empty() && result.left_out.empty())
      throw Usage_error("no face is left to mesh; face "
                        + closed_up_text(result.shape.closed_up.front(), {has_unit(options) ? "mm" : ""}));
    if(result.left_out.empty())
      throw Usage_error("no face could be read from " + options.input);
    throw Usage_error("no face can be meshed; face " + std::to_string(result.left_out.front().shape_face + 1) + ": "
                      + result.left_out.front().reason);
  }
  result.report = mesh_model(options, result.shape.model, result.criteria, result.mesh);
  for(const auto& face : result.report.left_out)
    result.left_out.push_back({result.shape.shape_faces[face.face], face.reason});
  note_closed_up_faces(result);
}

inline void make_second_order(Mesh_cad_result& result)
{
  result.mesh.mid_side_nodes = result.mesh.mesh.add_property_map<Cad_mesh::Mesh::Edge_index, Kernel::Point_3>("e:node").first;
  result.second_order.emplace();
  result.second_order->report
    = CGAL::make_second_order_mesh(result.shape.model, result.mesh.mesh, result.mesh.mid_side_nodes, result.mesh.places());
}

inline double unit_in_millimetres(const Mesh_cad_options& options)
{
  const double result = millimetres_of(options.unit);
  return has_unit(options) ? result : 1;
}

// To look at the finished mesh is no meshing. The report has the times of a clock that goes on while others use the processor: what
// counts are shares of them.
inline void take_out_intersections(Mesh_cad_result& result)
{
  const auto& seconds = result.report.seconds;
  if(seconds.intersections > 0)
    result.intersections_seconds = result.meshing_seconds * seconds.intersections / seconds.meshing();
  result.meshing_seconds -= result.intersections_seconds;
}

// What takes its time: distances, and values of all triangles.
template <class ConcurrencyTag>
void measure_mesh(const Mesh_cad_options& options, Mesh_cad_result& result)
{
  result.measures = measure(result.mesh, result.shape, result.criteria.min_edge());
  result.is_distance_measured = !options.is_measuring_left_out;
  if(result.is_distance_measured) {
    measure_distance<ConcurrencyTag>(result.mesh, result.shape, result.measures);
    result.deciding_bounds = deciding_bounds<ConcurrencyTag>(result.mesh, result.shape, result.criteria);
    if(result.second_order)
      result.second_order->distance = CGAL::second_order_mesh_distance<ConcurrencyTag>(
        result.shape.model, result.mesh.mesh, result.mesh.mid_side_nodes, result.mesh.places(), mesh_patch::subdivisions_for_distance);
  }
  if(mesh_patch::has_ending(options.out, ".vtu"))
    result.triangle_data = triangle_data<ConcurrencyTag>(result.mesh, result.shape);
}

inline void mesh_and_measure(const Mesh_cad_options& given, Mesh_cad_result& result)
{
  const double unit = unit_in_millimetres(given);
  Mesh_cad_options options = given;
  scale_lengths(unit, options);
  TopoDS_Shape& shape = result.open_cascade_shape;
  result.reading_seconds = seconds_of([&] { shape = read_shape(options, result); });
  if(!TopExp_Explorer(shape, TopAbs_FACE).More())
    throw Usage_error("no face could be read from " + options.input);
  std::set<std::size_t> wanted_parts;
  for(const std::string& list : options.part_lists) {
    const auto parts = parts_in(result.names, "parts", list);
    wanted_parts.insert(parts.begin(), parts.end());
  }
  result.model_seconds = seconds_of([&] {
    result.shape = CGAL::make_model_of_open_cascade_shape(shape);
    result.criteria = make_criteria(options, result.shape.diagonal);
    const Sizes sizes = make_sizes(options, unit, result.names, result.shape, result.criteria); // near faces that are not meshed, too
    select_parts(wanted_parts, result.names, result.shape);
    select_faces(options.face_list, result.names, result.shape);
    set_sizes(sizes, result.shape);
  });
  result.left_out = result.shape.left_out;
  double layers_seconds = 0;
  if(options.layers > 0 && !result.shape.model.faces().empty())
    layers_seconds = seconds_of([&] { result.layers = add_layer_sizes(options, result.shape, result.criteria); });
  result.meshing_seconds = seconds_of([&] { make_mesh(options, result); });
  take_out_intersections(result);
  result.meshing_seconds += layers_seconds;
  if(options.order == 2)
    result.second_order_seconds = seconds_of([&] { make_second_order(result); });
  result.measuring_seconds = seconds_of([&] {
    Progress_line progress(options.is_quiet, options.callbacks);
    progress.on_phase("measuring");
    with_threads(options.threads, [&](auto tag) { measure_mesh<decltype(tag)>(options, result); });
    if(!options.page.empty() || !options.picture.empty()) {
      result.page = CGAL::make_mesh_page(result.shape.model, result.mesh.mesh, result.report, result.mesh.places());
      CGAL::name_mesh_page(result.shape, result.names, result.page);
      result.page.scale_lengths(1 / unit);
    }
    scale_lengths(1 / unit, result);
    result.quality = CGAL::triangle_mesh_quality(result.mesh.mesh);
  });
}

} // namespace mesh_cad

#endif // MESH_CAD_RESULT_H
