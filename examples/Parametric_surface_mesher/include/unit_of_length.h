// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The unit of length of mesh_cad's results. Files are read and meshed in millimetres, since tolerances of Open CASCADE are absolute: in
// kilometres, parts of a machine would be smaller than these.
#ifndef UNIT_OF_LENGTH_H
#define UNIT_OF_LENGTH_H

#include "Mesh_cad_options.h"
#include "Usage_error.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Open_cascade_names_3.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <string>
#include <type_traits>

namespace mesh_cad {

// The names are those of Open CASCADE.
inline double millimetres_of(const std::string& unit)
{
  static const std::map<std::string, double> units{{"UM", 1e-3}, {"MM", 1},    {"CM", 10},     {"M", 1e3},       {"KM", 1e6},
                                                   {"UIN", 25.4e-6}, {"MIL", 25.4e-3}, {"INCH", 25.4}, {"FT", 304.8}, {"MI", 1609344}};
  const auto found = units.find(unit);
  if(found == units.end())
    throw Usage_error("--unit: '" + unit + "' is not a unit of length: UM, MM, CM, M, KM, UIN, MIL, INCH, FT or MI");
  return found->second;
}

// The unit as it is written behind numbers, like "mm".
inline std::string symbol_of_unit(const std::string& unit)
{
  static const std::map<std::string, std::string> symbols{{"UM", "\u00b5m"}, {"UIN", "\u00b5in"}, {"INCH", "in"}};
  const auto found = symbols.find(unit);
  if(found != symbols.end())
    return found->second;
  std::string result = unit;
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

inline void scale_lengths(double factor, Mesh_cad_options& options)
{
  for(double* length : {&options.max_edge, &options.min_edge, &options.distance, &options.detail, &options.sewing_tolerance, &options.fuzzy,
                        &options.reach})
    *length *= factor;
  for(auto& point : options.points)
    for(double& coordinate : point)
      coordinate *= factor;
  for(Local_size& size : options.local_sizes)
    scale(factor, size);
  if(options.callbacks.size)
    options.callbacks.size = [size = options.callbacks.size, factor](double x, double y, double z) {
      return factor * size(x / factor, y / factor, z / factor);
    };
}

inline void scale_lengths(double factor, CGAL::Open_cascade_names_3& names)
{
  for(auto& part : names.parts)
    for(std::size_t i : {3, 7, 11}) // the translation
      part.location[i] *= factor;
}

// Scales the mesh and what was measured in lengths.
template <class Result>
void scale_lengths(double factor, Result& result)
{
  if(factor == 1)
    return;
  const auto scale = [factor](auto& p) { p = std::decay_t<decltype(p)>(factor * p.x(), factor * p.y(), factor * p.z()); };
  for(const auto v : result.mesh.mesh.vertices())
    scale(result.mesh.mesh.point(v));
  if(result.second_order) {
    for(const auto e : result.mesh.mesh.edges())
      scale(result.mesh.mid_side_nodes[e]);
    result.second_order->distance *= factor;
  }
  for(auto& data : result.triangle_data)
    for(double& value : data.values)
      value *= data.name == "deviation" ? factor : data.name == "curvature" ? 1 / factor : 1;
  scale_lengths(factor, result.names);
  const CGAL::Bbox_3 box = result.measures.box;
  result.measures.box = CGAL::Bbox_3(factor * box.xmin(), factor * box.ymin(), factor * box.zmin(),
                                     factor * box.xmax(), factor * box.ymax(), factor * box.zmax());
  for(double* length : {&result.measures.distance, &result.shape.diagonal, &result.shape.largest_gap, &result.report.max_edge,
                        &result.report.min_edge, &result.layers.smallest_length})
    *length *= factor;
  for(auto& face : result.shape.closed_up)
    face.width *= factor;
  for(auto& gap : result.shape.gaps) {
    gap.distance *= factor;
    gap.tolerance *= factor;
  }
  for(auto& contact : result.contacts) {
    contact.area *= factor * factor;
    contact.common_volume *= factor * factor * factor;
    contact.distance *= factor;
  }
  for(auto& imprint : result.imprints)
    for(double* length : {&imprint.distance, &imprint.length, &imprint.projected_length})
      *length *= factor;
  for(auto& detail : result.report.removed_details) {
    detail.moved *= factor;
    for(double& coordinate : detail.place)
      coordinate *= factor;
  }
  for(auto& intersection : result.report.intersections)
    for(double& coordinate : intersection.place)
      coordinate *= factor;
  for(auto& fold : result.report.folds)
    for(double& coordinate : fold.place)
      coordinate *= factor;
  if(result.criteria.detail())
    result.criteria.set_detail(factor * *result.criteria.detail());
  if(result.criteria.distance())
    result.criteria.set_distance(factor * *result.criteria.distance());
  result.criteria.set_max_edge(factor * result.criteria.max_edge()).set_min_edge(factor * result.criteria.min_edge());
}

} // namespace mesh_cad

#endif // UNIT_OF_LENGTH_H
