// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What mesh_patch meshes: a single patch or a model.
#ifndef MESH_PATCH_INPUT_H
#define MESH_PATCH_INPUT_H

#include "Mesh_patch_options.h"
#include "Model_counts.h"
#include "Sample_models.h"
#include "Sample_surfaces.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/IO/read_bezier_patches.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/support/ending_of.h>
#include <CGAL/make_model_of_rectangular_patches.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

struct Mesh_patch_input
{
  // a surface that triangles lie on
  struct Patch
  {
    Sample_surface surface;
    bool is_reversed;
  };

  std::string name;
  std::variant<Sample, Sample_surface_model> source;
  std::vector<Patch> patches;
};

namespace mesh_patch {

// The model as input, with a patch for each face.
inline Mesh_patch_input model_input(const std::string& name, Sample_surface_model model)
{
  std::vector<Mesh_patch_input::Patch> patches;
  for(const auto& face : model.faces())
    patches.push_back({face.surface, face.is_reversed});
  return {name, std::move(model), std::move(patches)};
}

inline Mesh_patch_input read_model(const std::string& file_name)
{
  const auto model = CGAL::make_model_of_rectangular_patches(CGAL::IO::read_bezier_patches(file_name));
  return model_input(file_name.substr(file_name.find_last_of('/') + 1), sample_surface_model(model));
}

inline void check_division(const std::string& name, std::size_t expected, const std::string& places, std::size_t given)
{
  if(given != expected)
    throw Usage_error("--division: " + name + " takes " + plural(expected, "number") + ", one for each of its " + places
                      + ", but " + std::to_string(given) + (given == 1 ? " is" : " are") + " given");
}

inline void prescribe_division(Sample& sample, const std::vector<unsigned int>& numbers)
{
  std::vector<sample_surfaces::Domain::Curve*> curves;
  for(auto& loop : sample.domain.loops())
    for(auto& curve : loop)
      curves.push_back(&curve);
  check_division(sample.name, curves.size(), "boundary curves", numbers.size());
  for(std::size_t i = 0; i < curves.size(); ++i)
    curves[i]->set_number_of_edges(numbers[i]);
}

inline void prescribe_division(Sample_model& sample, const std::vector<unsigned int>& numbers)
{
  check_division(sample.name, model_counts(sample.model).edges, "edges that are no poles", numbers.size());
  std::vector<unsigned int> number_of_edge; // 0 for a collapsed one
  auto next = numbers.begin();
  for(const auto& edge : sample.model.edges())
    number_of_edge.push_back(edge.is_collapsed ? 0 : *next++);
  for(auto& face : sample.model.faces())
    for(auto& loop : face.loops)
      for(auto& use : loop)
        use.curve.set_number_of_edges(number_of_edge[use.edge]);
}

inline bool contains(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

// a sample with the division that the options prescribe
template <class Any_sample>
Any_sample divided(Any_sample sample, const Mesh_patch_options& options)
{
  if(!options.numbers_of_edges.empty())
    prescribe_division(sample, options.numbers_of_edges);
  return sample;
}

inline Mesh_patch_input named_surface(const Mesh_patch_options& options)
{
  if(contains(sample_model_names(), options.surface))
    return model_input(options.surface, divided(make_sample_model(options.surface), options).model);
  const std::string ending = CGAL::Parametric_surface_mesher::internal::ending_of(options.surface);
  if(contains({"step", "stp", "iges", "igs", "brep"}, ending))
    throw Usage_error("'" + options.surface + "' is a CAD file, which the program mesh_cad reads");
  if(!contains(sample_patch_names(), options.surface))
    throw Usage_error("'" + options.surface + "' is not a surface: expected a file that ends in .bpt or one of "
                      + joined(all_sample_names()));
  Sample sample = divided(make_sample(options.surface), options);
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

inline Model_counts counts(const Mesh_patch_input& input)
{
  if(const Sample* sample = std::get_if<Sample>(&input.source))
    return model_counts(sample->domain);
  return model_counts(std::get<Sample_surface_model>(input.source));
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
    for(const auto& face : std::get<Sample_surface_model>(input.source).faces())
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
    throw Usage_error(input.name + " is a point, so that --max-edge has no default");
  if(options.min_edge > max_edge)
    refuse("min-edge", options.min_edge, "at most the length of --max-edge, which is " + text_of(max_edge) + " by default");
  criteria.set_max_edge(max_edge);
  criteria.set_min_edge(options.min_edge > 0 ? options.min_edge : max_edge / 200);
  criteria.set_placement(options.placement == "frontal"      ? CGAL::Parametric_surface_mesher::Mesh_point_placement::FRONTAL
                         : options.placement == "off-center" ? CGAL::Parametric_surface_mesher::Mesh_point_placement::OFF_CENTER
                                                             : CGAL::Parametric_surface_mesher::Mesh_point_placement::CIRCUMCENTER);
  criteria.set_improvement_angle(options.improvement_angle);
  if(options.sweeps)
    criteria.set_max_number_of_sweeps(*options.sweeps);
  criteria.set_gamma(options.gamma).set_angle(options.angle).set_size_factor(options.size_factor);
  if(options.distance > 0)
    criteria.set_distance(options.distance);
  return criteria;
}

} // namespace mesh_patch

#endif // MESH_PATCH_INPUT_H
