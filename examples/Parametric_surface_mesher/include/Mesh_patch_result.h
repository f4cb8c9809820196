// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshing and measuring in mesh_patch.
#ifndef MESH_PATCH_RESULT_H
#define MESH_PATCH_RESULT_H

#include "Mesh_patch_input.h"
#include "Mesh_patch_options.h"
#include "Patch_triangles.h"
#include "Progress_line.h"
#include "Second_order_measures.h"
#include "distance_over_triangle.h"

#include <CGAL/Circumellipse_2.h>
#include <CGAL/First_fundamental_form_metric_2.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Principal_curvature_metric_2.h>
#include <CGAL/Triangle_mesh_deviation.h>
#include <CGAL/Triangle_mesh_quality.h>
#include <CGAL/make_mesh_page.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <functional>
#include <limits>
#include <variant>
#include <vector>

struct Mesh_patch_result
{
  typedef CGAL::Circumellipse_2<Sample_kernel> Ellipse;

  CGAL::Parametric_surface_mesh_criteria criteria; // with the default sizes filled in
  Mesh mesh;
  CGAL::Parametric_surface_mesh_report report;
  CGAL::Triangle_mesh_quality quality;
  CGAL::Triangle_mesh_deviation deviation; // over all patches
  double distance = 0;                     // the largest one of the mesh from the surfaces
  Face_patch_map patch_of_face;
  boost::optional<Second_order_measures> second_order;
  Mesh::Property_map<Mesh::Edge_index, Sample_kernel::Point_3> mid_side_nodes; // there are some if the elements are of second order
  CGAL::Mesh_page_3 page; // if it is wanted
  std::deque<Patch_triangles> patches;     // in a deque, since they cannot be moved in memory
  std::vector<std::vector<Ellipse>> ellipses; // by patch
};

namespace mesh_patch {

// Adds the measurements of one patch to those of all.
inline void add(const CGAL::Triangle_mesh_deviation& d, CGAL::Triangle_mesh_deviation& sum)
{
  sum.max_inner_deviation_ratio = (std::max)(sum.max_inner_deviation_ratio, d.max_inner_deviation_ratio);
  sum.max_inner_normal_deviation_ratio
    = (std::max)(sum.max_inner_normal_deviation_ratio, d.max_inner_normal_deviation_ratio);
  sum.max_border_deviation_ratio = (std::max)(sum.max_border_deviation_ratio, d.max_border_deviation_ratio);
  sum.max_distance_to_face = (std::max)(sum.max_distance_to_face, d.max_distance_to_face);
  sum.max_distance_to_vertex = (std::max)(sum.max_distance_to_vertex, d.max_distance_to_vertex);
  sum.number_of_skipped_edges += d.number_of_skipped_edges;
  sum.number_of_inverted_faces += d.number_of_inverted_faces;
  sum.number_of_domain_violations += d.number_of_domain_violations;
}

// A triangle of a patch, by its centroid in the domain.
struct Triangle_position
{
  std::size_t patch;
  Mesh::Face_index face;
  double u, v;
  double squared_distance; // from the triangles chosen so far
};

inline std::vector<Triangle_position> triangle_positions(const Mesh_patch_result& result)
{
  std::vector<Triangle_position> positions;
  const Uv_layout layout(result.patches);
  for(std::size_t i = 0; i < result.patches.size(); ++i) {
    const Mesh& mesh = result.patches[i].mesh;
    const std::array<double, 2> t = layout.translation(i);
    for(const auto face : mesh.faces()) {
      Triangle_position position = {i, face, 0, 0, (std::numeric_limits<double>::max)()};
      for(const auto v : mesh.vertices_around_face(mesh.halfedge(face))) {
        position.u += result.patches[i].uv[v].x() / 3;
        position.v += result.patches[i].uv[v].y() / 3;
      }
      position.u = (position.u + t[0]) / layout.width;
      position.v = (position.v + t[1]) / layout.height;
      positions.push_back(position);
    }
  }
  return positions;
}

// The circumellipses of `number` triangles spread over the domain: each is far from the ones before.
template <class Metric>
std::vector<std::vector<Mesh_patch_result::Ellipse>> some_ellipses(const Mesh_patch_input& input,
                                                                   const Mesh_patch_result& result,
                                                                   const Metric& metric, std::size_t number)
{
  std::vector<std::vector<Mesh_patch_result::Ellipse>> ellipses(result.patches.size());
  std::vector<Triangle_position> positions = triangle_positions(result);
  for(std::size_t n = 0; n < (std::min)(number, positions.size()); ++n) {
    const Triangle_position next = *std::max_element(positions.begin(), positions.end(), [](const auto& a, const auto& b) {
      return a.squared_distance < b.squared_distance;
    });
    append_circumellipse(result.patches[next.patch], input.patches[next.patch].surface, metric, next.face,
                         ellipses[next.patch]);
    for(Triangle_position& p : positions)
      p.squared_distance = (std::min)(p.squared_distance, CGAL::square(p.u - next.u) + CGAL::square(p.v - next.v));
  }
  return ellipses;
}

inline void measure(const Mesh_patch_input& input, const Halfedge_uv_map& uv, const Face_patch_map& patch,
                    Mesh_patch_result& result)
{
  const unsigned int subdivisions = 3; // edges at their thirds, and the centroid
  result.quality = CGAL::triangle_mesh_quality(result.mesh);
  const Triangle_tree tree(result.mesh.faces().begin(), result.mesh.faces().end(), result.mesh);
  double squared_distance = 0;
  for(const auto face : result.mesh.faces())
    squared_distance = largest_squared_distance(squared_distance, corners_of_triangle(result.mesh, uv, face),
                                                input.patches[patch[face]].surface, tree);
  result.distance = std::sqrt(squared_distance);
  const auto faces = faces_of_patches(result.mesh, patch, input.patches.size());
  for(std::size_t i = 0; i < input.patches.size(); ++i) {
    result.patches.emplace_back();
    append_triangles(result.mesh, uv, faces[i], input.patches[i].is_reversed, result.patches[i]);
    add(CGAL::triangle_mesh_deviation(result.patches[i].mesh, input.patches[i].surface, result.patches[i].uv, subdivisions,
                                      2 * result.criteria.min_edge()), // shorter edges are not divided
        result.deviation);
  }
}

// Makes the nodes in the middles of the edges, and measures the curved triangles. `maps`: where the mesh lies on its surfaces
template <class Maps>
void make_second_order(const Mesh_patch_input& input, const Maps& maps, Mesh_patch_result& result)
{
  const auto nodes = result.mid_side_nodes = result.mesh.add_property_map<Mesh::Edge_index, Sample_kernel::Point_3>("e:node").first;
  const auto make = [&](const auto&... shape) {
    result.second_order = Second_order_measures{CGAL::make_second_order_mesh(shape..., result.mesh, nodes, maps),
                                                CGAL::second_order_mesh_distance(shape..., result.mesh, nodes, maps, subdivisions_for_distance)};
  };
  if(const Sample* sample = std::get_if<Sample>(&input.source))
    make(sample->surface, sample->domain);
  else
    make(std::get<Sample_surface_model>(input.source));
}

template <class Maps>
CGAL::Mesh_page_3 make_page(const Mesh_patch_input& input, const Maps& maps, const Mesh_patch_result& result)
{
  if(const Sample* sample = std::get_if<Sample>(&input.source))
    return CGAL::make_mesh_page(sample->surface, sample->domain, result.mesh, result.report, maps);
  return CGAL::make_mesh_page(std::get<Sample_surface_model>(input.source), result.mesh, result.report, maps);
}

template <class Metric>
void mesh_with_metric(const Mesh_patch_input& input, const Mesh_patch_options& options, const Metric& metric,
                      Mesh_patch_result& result)
{
  namespace parameters = CGAL::parameters;
  const Halfedge_uv_map uv = result.mesh.add_property_map<Mesh::Halfedge_index, Sample_kernel::Point_2>("h:uv").first;
  const Face_patch_map patch = result.patch_of_face = result.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;
  const auto edge_place
    = result.mesh.add_property_map<Mesh::Edge_index, CGAL::Parametric_surface_mesher::Edge_place>("e:place").first;
  const auto places = parameters::halfedge_uv_map(uv, parameters::face_patch_id_map(patch, parameters::edge_place_map(edge_place)));
  result.criteria = make_criteria(options, input);
  {
    Progress_line progress(options.is_quiet);
    const auto maps = parameters::metric_field(metric, places).visitor(std::ref(progress));
    if(const Sample* sample = std::get_if<Sample>(&input.source))
      result.report
        = CGAL::make_parametric_surface_mesh(sample->surface, sample->domain, result.criteria, result.mesh, maps);
    else
      result.report = CGAL::make_parametric_surface_mesh(std::get<Sample_surface_model>(input.source), result.criteria,
                                                         result.mesh, maps);
  }
  Progress_line progress(options.is_quiet);
  progress.on_phase("measuring");
  measure(input, uv, patch, result);
  if(!options.page.empty() || !options.picture.empty())
    result.page = make_page(input, parameters::metric_field(metric, places), result);
  if(options.order == 2)
    make_second_order(input, places, result);
  if(options.ellipses > 0)
    result.ellipses = some_ellipses(input, result, metric, std::size_t(options.ellipses));
}

inline void mesh_and_measure(const Mesh_patch_input& input, const Mesh_patch_options& options,
                             Mesh_patch_result& result)
{
  if(options.metric == "principal-curvature")
    mesh_with_metric(input, options, CGAL::Principal_curvature_metric_2<Sample_kernel>(), result);
  else
    mesh_with_metric(input, options, CGAL::First_fundamental_form_metric_2<Sample_kernel>(), result);
}

} // namespace mesh_patch

#endif // MESH_PATCH_RESULT_H
