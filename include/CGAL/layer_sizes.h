// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LAYER_SIZES_H
#define CGAL_LAYER_SIZES_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Node_values_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Opposite_triangles.h>
#include <CGAL/Parametric_surface_mesher/internal/support/check_value.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {

namespace Parametric_surface_mesher {
namespace internal {

// How many times as long as is wanted an edge may become.
constexpr double largest_ratio_to_wanted_length = 1.4;

// Lowers values at nodes, so that those at the two ends of an edge differ by at most `growth` times its length.
inline void limit_growth(double growth, Node_values_3& mesh)
{
  std::vector<std::vector<std::size_t>> neighbors(mesh.nodes.size());
  for(const auto& triangle : mesh.triangles)
    for(std::size_t i = 0; i < 3; ++i) {
      neighbors[triangle[i]].push_back(triangle[(i + 1) % 3]);
      neighbors[triangle[(i + 1) % 3]].push_back(triangle[i]);
    }
  const auto length = [&](std::size_t a, std::size_t b) {
    const auto &p = mesh.nodes[a], &q = mesh.nodes[b];
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  };
  typedef std::pair<double, std::size_t> Entry; // value and node, the smallest value first
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for(std::size_t node = 0; node < mesh.nodes.size(); ++node)
    queue.emplace(mesh.values[node], node);
  while(!queue.empty()) {
    const Entry entry = queue.top();
    queue.pop();
    if(entry.first > mesh.values[entry.second])
      continue;
    for(const std::size_t other : neighbors[entry.second]) {
      const double limit = entry.first + growth * length(entry.second, other);
      if(limit < mesh.values[other]) {
        mesh.values[other] = limit;
        queue.emplace(limit, other);
      }
    }
  }
}

} // namespace internal
} // namespace Parametric_surface_mesher

/*!
\ingroup PkgParametricSurfaceMesherSizing

finds the edge lengths with which a number of layers of elements fit between the sides of thin walls, and into narrow gaps. In a mesh that
is made with them, nearly all edges are at most as long as the local thickness divided by the number of layers; a few are a little longer.

What is opposite to a triangle is found by rays along its normal, to both sides, from several of its points. It counts if its normal differs
from that of the triangle, or from the opposite of that, by at most 60 degrees, and if it has no corner in common with it. The mesh should
be one of default sizes that does not intersect itself: what it misses is not seen.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, whose faces are triangles
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh the mesh; it need be neither closed nor connected
\param number_of_layers the number of edges that are to fit across a wall or a gap
\param min_length the smallest length that is wanted, however thin the wall
\param max_length the length where nothing is opposite
\param growth how fast lengths grow away from thin places, as a share of the distance
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `mesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
                   as key type and `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the wanted lengths at the vertices of the mesh, for an `Interpolated_sizing_field_3`

\throws Parametric_surface_mesh_error if a face is no triangle, `number_of_layers` or a length is not positive and finite, or `growth` is
negative or not finite

\sa `CGAL::Parametric_surface_model_3::add_sizing_field()`
*/
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Node_values_3 layer_sizes(const TriangleMesh& mesh, double number_of_layers, double min_length, double max_length, double growth = 0.2,
                          const NamedParameters& np = parameters::default_values())
{
  using namespace Parametric_surface_mesher::internal;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor Vertex;
  check_positive_and_finite("number of layers", number_of_layers);
  check_positive_and_finite("smallest length", min_length);
  check_positive_and_finite("largest length", max_length);
  check_not_negative_and_finite("growth", growth);
  const auto points = choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, mesh));
  Node_values_3 result;
  std::map<Vertex, std::size_t> nodes;
  for(const Vertex v : vertices(mesh)) {
    nodes.emplace(v, nodes.size());
    const auto& p = get(points, v);
    result.nodes.push_back({{to_double(p.x()), to_double(p.y()), to_double(p.z())}});
  }
  for(const auto f : faces(mesh)) {
    std::array<std::size_t, 3> triangle;
    std::size_t i = 0;
    for(const Vertex v : vertices_around_face(halfedge(f, mesh), mesh)) {
      if(i == 3)
        throw Parametric_surface_mesh_error(numbered("face", result.triangles.size()) + " of the mesh is no triangle");
      triangle[i++] = nodes.at(v);
    }
    result.triangles.push_back(triangle);
  }
  result.values.assign(result.nodes.size(), max_length);
  const std::vector<double> room = Opposite_triangles(result).room();
  for(std::size_t t = 0; t < room.size(); ++t)
    for(const std::size_t node : result.triangles[t])
      result.values[node] = (std::min)(result.values[node],
                                       (std::max)(room[t] / (number_of_layers * largest_ratio_to_wanted_length), min_length));
  limit_growth(growth, result);
  return result;
}

} // namespace CGAL

#endif // CGAL_LAYER_SIZES_H
