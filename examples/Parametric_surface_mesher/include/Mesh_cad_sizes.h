// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The edge lengths that the options of mesh_cad ask for at places of the shape.
#ifndef MESH_CAD_SIZES_H
#define MESH_CAD_SIZES_H

#include "Cad_mesh.h"
#include "Mesh_cad_names.h"
#include "Mesh_cad_options.h"
#include "Progress_line.h"
#include "with_threads.h"

#include <CGAL/Graded_sizing_field_3.h>
#include <CGAL/IO/read_node_values.h>
#include <CGAL/Interpolated_sizing_field_3.h>
#include <CGAL/Least_sizing_field_3.h>
#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/divide_curve.h>
#include <CGAL/layer_sizes.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace mesh_cad {

typedef CGAL::Graded_sizing_field_3<Kernel> Graded_field;

// The sizes of a run, by index in the shape.
struct Sizes
{
  std::map<std::size_t, double> of_faces, of_edges;
  CGAL::Least_sizing_field_3<Kernel::Point_3> field;
};

inline CGAL::Parametric_surface_mesh_report mesh_model(const Mesh_cad_options& options, const CGAL::Open_cascade_model_3::Model& model,
                                                       const CGAL::Parametric_surface_mesh_criteria& criteria, Cad_mesh& mesh)
{
  Progress_line progress(options.is_quiet, options.callbacks);
  const auto np = mesh.places(CGAL::parameters::leaves_out_bad_faces(true).visitor(std::ref(progress)));
  return with_threads(options.threads, [&](auto tag) {
    return CGAL::make_parametric_surface_mesh<decltype(tag)>(model, criteria, mesh.mesh, np);
  });
}

// What the options ask for near faces, edges and vertices.
class Sizes_near_entities
{
  typedef Kernel::Point_3 Point_3;

  // The largest distance of a face or edge from its triangles or segments, as a share of the length that is wanted there.
  static constexpr double share_of_length = 0.1;

  const Mesh_cad_options& m_options;
  const Names& m_names;
  const CGAL::Open_cascade_model_3& m_shape;

public:
  Sizes_near_entities(const Mesh_cad_options& options, const Names& names, const CGAL::Open_cascade_model_3& shape)
    : m_options(options), m_names(names), m_shape(shape)
  {}

  Graded_field field(const Local_size& size) const
  {
    switch(size.kind) {
    case Local_size::FACE: return near(size, triangles_of(indices_of(Named_faces(m_names, m_shape), size.option, size.name), size));
    case Local_size::EDGE: return near(size, segments_of(indices_of(Named_edges(m_names, m_shape), size.option, size.name), size));
    case Local_size::VERTEX: return near(size, points_of(indices_of(Named_vertices(m_names), size.option, size.name)));
    default: return near(size, triangles_of(faces_of_parts(size), size));
    }
  }

private:
  template <class Pieces>
  Graded_field near(const Local_size& size, const Pieces& pieces) const
  {
    if(pieces.empty())
      throw Usage_error("--" + size.option + ": what '" + size.text + "' names has no extent in the model");
    return Graded_field::near(pieces, size.length, size.growth, share_of_length * size.length);
  }

  Indices faces_of_parts(const Local_size& size) const
  {
    Indices result;
    for(const std::size_t part : parts_in(m_names, size.option, size.name))
      result.insert(m_names.parts[part].faces.begin(), m_names.parts[part].faces.end());
    return result;
  }

  // A mesh that is just fine enough to measure distances.
  std::vector<Kernel::Triangle_3> triangles_of(const Indices& faces, const Local_size& size) const
  {
    auto model = m_shape.model;
    model.remove_faces([&](std::size_t f) { return faces.count(m_shape.shape_faces[f]) == 0; });
    std::vector<Kernel::Triangle_3> result;
    if(model.faces().empty())
      return result;
    const double tolerance = share_of_length * size.length, coarse_gamma = 0.5, coarse_angle = 5;
    CGAL::Parametric_surface_mesh_criteria criteria;
    criteria.set_max_edge((std::max)(m_shape.diagonal / 10, tolerance)).set_min_edge(tolerance).set_distance(tolerance);
    criteria.set_gamma(coarse_gamma).set_angle(coarse_angle).set_max_number_of_sweeps(0);
    Cad_mesh mesh;
    mesh_model(m_options, model, criteria, mesh);
    for(const auto f : mesh.mesh.faces()) {
      const auto p = corners(mesh, f).points;
      const Kernel::Triangle_3 triangle(p[0], p[1], p[2]);
      if(!triangle.is_degenerate())
        result.push_back(triangle);
    }
    return result;
  }

  std::vector<Kernel::Segment_3> segments_of(const Indices& edges, const Local_size& size) const
  {
    Indices wanted; // in the model
    for(const std::size_t e : edges)
      wanted.insert(m_shape.model_edges[e].begin(), m_shape.model_edges[e].end());
    Indices done; // each edge counts once, by its first use
    std::vector<Kernel::Segment_3> result;
    for(const auto& face : m_shape.model.faces())
      for(const auto& loop : face.loops)
        for(const auto& use : loop)
          if(wanted.count(use.edge) > 0 && done.insert(use.edge).second) {
            const auto& curve = m_shape.model.edges()[use.edge].curve;
            if(curve)
              add_segments(*curve, share_of_length * size.length, result);
            else
              add_segments(CGAL::Parametric_surface_mesher::Curve_on_surface_3<CGAL::Open_cascade_surface_3>(face.surface, use.curve),
                           share_of_length * size.length, result);
          }
    return result;
  }

  template <class Curve>
  static void add_segments(const Curve& curve, double tolerance, std::vector<Kernel::Segment_3>& result)
  {
    const int number_of_spans = 8; // none of which winds round more than once
    for(int i = 0; i < number_of_spans; ++i) {
      const auto parameter = [&](int k) { return curve.begin() + (curve.end() - curve.begin()) * k / number_of_spans; };
      add_segments(curve, parameter(i), parameter(i + 1), tolerance, 0, result);
    }
  }

  template <class Curve>
  static void add_segments(const Curve& curve, double from, double to, double tolerance, int depth, std::vector<Kernel::Segment_3>& result)
  {
    const int max_depth = 12; // 32768 segments
    const Point_3 p = curve.point(from), q = curve.point(to);
    const Kernel::Segment_3 segment(p, q);
    const auto is_far = [&](double share) {
      return squared_distance(segment, curve.point(from + share * (to - from))) > tolerance * tolerance;
    };
    if(depth < max_depth && (is_far(0.5) || is_far(0.25) || is_far(0.75))) {
      add_segments(curve, from, 0.5 * (from + to), tolerance, depth + 1, result);
      add_segments(curve, 0.5 * (from + to), to, tolerance, depth + 1, result);
    }
    else if(p != q)
      result.push_back(segment);
  }

  std::vector<Point_3> points_of(const Indices& vertices) const
  {
    std::vector<Point_3> result;
    for(std::size_t v = 0; v < m_shape.shape_vertices.size(); ++v)
      if(vertices.count(m_shape.shape_vertices[v]) > 0)
        result.push_back(m_shape.model.vertices()[v]);
    return result;
  }
};

inline Graded_field field_of(const Local_size& size, const Sizes_near_entities& near_entities)
{
  const auto& x = size.lengths;
  const auto point = [&x](std::size_t first) { return Kernel::Point_3(x[first], x[first + 1], x[first + 2]); };
  switch(size.kind) {
  case Local_size::BOX: return Graded_field::in_box(Kernel::Iso_cuboid_3(point(0), point(3)), size.length, size.growth);
  case Local_size::SPHERE: return Graded_field::in_ball(point(0), x[3], size.length, size.growth);
  case Local_size::CYLINDER: return Graded_field::in_cylinder(Kernel::Segment_3(point(0), point(3)), x[6], size.length, size.growth);
  case Local_size::POINT: return Graded_field::in_ball(point(0), 0, size.length, size.growth);
  default: return near_entities.field(size);
  }
}

// `unit`: in millimetres, that of the message
inline void check_size(const std::string& option, double length, const CGAL::Parametric_surface_mesh_criteria& criteria, double unit)
{
  if(length >= criteria.min_edge())
    return;
  std::ostringstream message;
  message << "--" << option << ": the length " << length / unit << " is below that of --min-edge, " << criteria.min_edge() / unit;
  throw Usage_error(message.str());
}

// Reads the edge lengths of a file. `name`: that of the file, which a colon and the name of the values may follow
inline CGAL::Interpolated_sizing_field_3<Kernel> read_size_field(const std::string& name, double unit)
{
  const bool is_file = std::ifstream(name).good();
  const std::size_t colon = is_file ? std::string::npos : name.rfind(':');
  CGAL::Node_values_3 values
    = CGAL::IO::read_node_values(name.substr(0, colon), colon == std::string::npos ? std::string() : name.substr(colon + 1));
  for(auto& p : values.nodes)
    for(double& x : p)
      x *= unit;
  for(double& value : values.values)
    value *= unit;
  return CGAL::Interpolated_sizing_field_3<Kernel>(values);
}

// \pre lengths of the options are in millimetres, those of `unit` in the lists
inline Sizes make_sizes(const Mesh_cad_options& options, double unit, const Names& names, const CGAL::Open_cascade_model_3& shape,
                        const CGAL::Parametric_surface_mesh_criteria& criteria)
{
  Sizes result;
  const auto read = [&](const char* option, const std::string& list, const auto& entities, std::map<std::size_t, double>& sizes) {
    if(!list.empty())
      sizes = sizes_in(entities, option, list);
    for(auto& size : sizes)
      check_size(option, size.second *= unit, criteria, unit);
  };
  read("face-size", options.face_sizes, Named_faces(names, shape), result.of_faces);
  read("edge-size", options.edge_sizes, Named_edges(names, shape), result.of_edges);
  const Sizes_near_entities near_entities(options, names, shape);
  for(const Local_size& size : options.local_sizes) {
    check_size(size.option, size.length, criteria, unit);
    result.field.add(field_of(size, near_entities));
  }
  if(!options.size_field.empty()) {
    const auto field = read_size_field(options.size_field, unit);
    check_size("size-field", field.length(), criteria, unit);
    result.field.add(field);
  }
  if(options.callbacks.size)
    result.field.add([size = options.callbacks.size](const Kernel::Point_3& p) { return size(p.x(), p.y(), p.z()); });
  return result;
}

inline void set_sizes(const Sizes& sizes, CGAL::Open_cascade_model_3& shape)
{
  for(std::size_t f = 0; f < shape.shape_faces.size(); ++f) {
    const auto found = sizes.of_faces.find(shape.shape_faces[f]);
    if(found != sizes.of_faces.end())
      shape.model.faces()[f].max_edge = found->second;
  }
  for(const auto& size : sizes.of_edges)
    for(const std::size_t e : shape.model_edges[size.first]) {
      double& max_edge = shape.model.edges()[e].max_edge;
      max_edge = max_edge > 0 ? (std::min)(max_edge, size.second) : size.second;
    }
  if(!sizes.field.is_empty())
    shape.model.add_sizing_field(sizes.field);
}

// What --layers asks for.
struct Layers
{
  double smallest_length = 0;
  bool is_limited = false; // whether the thinnest places would take smaller lengths
};

// Adds the sizes for layers of elements to those of the model. A first mesh shows what is opposite to what.
// If the minimum edge was not given, it becomes shorter where the layers take that.
inline Layers add_layer_sizes(const Mesh_cad_options& options, CGAL::Open_cascade_model_3& shape,
                              CGAL::Parametric_surface_mesh_criteria& criteria)
{
  const double share_of_min_edge = 0.25, ratio_to_min_edge = 1.4; // no smaller length is wanted anywhere than 1.4 minimum edges
  const double smallest = ratio_to_min_edge * (options.min_edge > 0 ? 1 : share_of_min_edge) * criteria.min_edge();
  Cad_mesh mesh;
  mesh_model(options, shape.model, criteria, mesh);
  const CGAL::Interpolated_sizing_field_3<Kernel> field(
    CGAL::layer_sizes(mesh.mesh, options.layers, smallest, (std::max)(smallest, criteria.max_edge())));
  shape.model.add_sizing_field(field);
  criteria.set_min_edge((std::min)(criteria.min_edge(), field.length() / ratio_to_min_edge));
  return {field.length(), field.length() <= smallest};
}

} // namespace mesh_cad

#endif // MESH_CAD_SIZES_H
