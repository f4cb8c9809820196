// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What mesh_patch meshes: a sample surface or a model of Bezier patches.
#ifndef MESH_PATCH_INPUT_H
#define MESH_PATCH_INPUT_H

#include "Mesh_patch_options.h"
#include "Sample_surfaces.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/IO/read_bezier_patches.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/make_model_of_rectangular_patches.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

typedef CGAL::Parametric_surface_model_3<Sample_surface> Sample_model;

struct Mesh_patch_input
{
  // a surface that triangles lie on
  struct Patch
  {
    Sample_surface surface;
    bool is_reversed;
  };

  std::string name;
  std::variant<Sample, Sample_model> source;
  std::vector<Patch> patches;
};

namespace mesh_patch {

inline bool has_ending(const std::string& name, const std::string& ending)
{
  return name.size() > ending.size() && name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

// The model with surfaces of the type of the samples, so that the mesher is compiled once for both.
template <class Surface>
Sample_model sample_model(const CGAL::Parametric_surface_model_3<Surface>& model)
{
  Sample_model result;
  for(const auto& vertex : model.vertices())
    result.add_vertex(vertex);
  for(const auto& edge : model.edges())
    result.add_edge(edge.source, edge.target, edge.is_collapsed);
  for(const auto& face : model.faces()) {
    Sample_model::Face copy{Sample_surface(face.surface), {}, face.is_reversed};
    for(const auto& loop : face.loops) {
      copy.loops.emplace_back();
      for(const auto& use : loop)
        copy.loops.back().push_back({use.edge, use.is_reversed, use.curve});
    }
    result.add_face(copy);
  }
  return result;
}

inline Mesh_patch_input read_model(const std::string& file_name)
{
  Sample_model model = sample_model(CGAL::make_model_of_rectangular_patches(CGAL::IO::read_bezier_patches(file_name)));
  std::vector<Mesh_patch_input::Patch> patches;
  for(const auto& face : model.faces())
    patches.push_back({face.surface, face.is_reversed});
  return {file_name.substr(file_name.find_last_of('/') + 1), std::move(model), std::move(patches)};
}

inline void prescribe_division(Sample& sample, const std::vector<unsigned int>& numbers)
{
  std::vector<sample_surfaces::Domain::Curve*> curves;
  for(auto& loop : sample.domain.loops())
    for(auto& curve : loop)
      curves.push_back(&curve);
  if(curves.size() != numbers.size())
    throw Usage_error("--division: " + sample.name + " has " + std::to_string(curves.size()) + " boundary curves, but "
                      + std::to_string(numbers.size()) + " numbers are given");
  for(std::size_t i = 0; i < curves.size(); ++i)
    curves[i]->set_number_of_edges(numbers[i]);
}

inline Mesh_patch_input named_surface(const Mesh_patch_options& options)
{
  const std::vector<std::string> names = sample_names();
  if(std::find(names.begin(), names.end(), options.surface) == names.end()) {
    std::string list;
    for(const std::string& name : names)
      list += " " + name;
    throw Usage_error("'" + options.surface + "' is no surface: give a file that ends in .bpt or one of" + list);
  }
  Sample sample = make_sample(options.surface);
  if(!options.numbers_of_edges.empty())
    prescribe_division(sample, options.numbers_of_edges);
  std::vector<Mesh_patch_input::Patch> patches = {{sample.surface, false}};
  return {options.surface, std::move(sample), std::move(patches)};
}

inline Mesh_patch_input read_input(const Mesh_patch_options& options)
{
  if(!has_ending(options.surface, ".bpt"))
    return named_surface(options);
  if(!options.numbers_of_edges.empty())
    throw Usage_error("--division is for the sample surfaces; the curves of a file are divided by --max-edge and --gamma");
  return read_model(options.surface);
}

// The box of a boundary curve, at some points of it.
inline CGAL::Bbox_3 curve_box(const Sample_surface& surface, const sample_surfaces::Domain::Curve& curve)
{
  CGAL::Bbox_3 box;
  for(int i = 0; i <= 8; ++i) {
    const auto uv = curve.point(curve.begin() + (curve.end() - curve.begin()) * i / 8);
    box += surface.point(uv.x(), uv.y()).bbox();
  }
  return box;
}

// The library's default would do, but the program also has to know it.
inline double default_max_edge(const Mesh_patch_input& input)
{
  CGAL::Bbox_3 box;
  if(const Sample* sample = std::get_if<Sample>(&input.source)) {
    for(const auto& loop : sample->domain.loops())
      for(const auto& curve : loop)
        box += curve_box(sample->surface, curve);
  }
  else
    for(const auto& face : std::get<Sample_model>(input.source).faces())
      for(const auto& loop : face.loops)
        for(const auto& use : loop)
          box += curve_box(face.surface, use.curve);
  return std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) + CGAL::square(box.z_span())) / 20;
}

inline CGAL::Parametric_surface_mesh_criteria make_criteria(const Mesh_patch_options& options,
                                                            const Mesh_patch_input& input)
{
  CGAL::Parametric_surface_mesh_criteria criteria;
  const double max_edge = options.max_edge > 0 ? options.max_edge : default_max_edge(input);
  if(!(max_edge > 0) || !std::isfinite(max_edge))
    throw Usage_error(input.name + " has no extent to take the default of --max-edge from");
  if(options.min_edge > max_edge)
    throw Usage_error("--min-edge must not be larger than --max-edge, which is " + std::to_string(max_edge) + " by default");
  criteria.set_max_edge(max_edge);
  criteria.set_min_edge(options.min_edge > 0 ? options.min_edge : max_edge / 100);
  criteria.set_gamma(options.gamma).set_angle(options.angle).set_size_factor(options.size_factor);
  if(options.distance > 0)
    criteria.set_distance(options.distance);
  return criteria;
}

} // namespace mesh_patch

#endif // MESH_PATCH_INPUT_H
