// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_ELEMENT_MESH_MAKER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_ELEMENT_MESH_MAKER_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_mesh_parameters.h>
#include <CGAL/Parametric_surface_mesher/Model_places.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Open_cascade_names_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Entities_of_shape.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Makes an element mesh of the mesh of a shape. Where pieces of the mesh meet in a vertex, an edge or a face of the model, they have copies of the same
points: these become one node. Triangles on both sides of a face between two parts become one, which knows both parts.
*/
template <class TriangleMesh, class NamedParameters>
class Element_mesh_maker
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef Element_mesh_3::Place Place;

  static_assert(!parameters::is_default_parameter<NamedParameters, Halfedge_uv_map_t>::value
                  && !parameters::is_default_parameter<NamedParameters, Face_patch_id_map_t>::value
                  && !parameters::is_default_parameter<NamedParameters, Vertex_place_map_t>::value
                  && !parameters::is_default_parameter<NamedParameters, Edge_place_map_t>::value,
                "The named parameters halfedge_uv_map, face_patch_id_map, vertex_place_map and edge_place_map are needed.");

  const Open_cascade_model_3& m_shape;
  const TriangleMesh& m_tm;
  const NamedParameters& m_np;
  Element_mesh_3 m_result;
  Entities_of_shape m_entities;
  std::vector<std::size_t> m_parts_of_faces, m_shape_edges; // by indices in the model
  typename boost::property_map<TriangleMesh, dynamic_vertex_property_t<std::size_t>>::const_type m_nodes;
  typename boost::property_map<TriangleMesh, dynamic_face_property_t<std::size_t>>::const_type m_surfaces;
  typename boost::property_map<TriangleMesh, dynamic_edge_property_t<std::size_t>>::const_type m_mid_side_nodes; // `none` until it is used
  std::vector<bool> m_has_other_side; // by face of the model
  // Nodes by what copies of a point have in common: dimension and index of the place in the model, and the point itself.
  std::map<std::tuple<int, std::size_t, Element_mesh_3::Point>, std::size_t> m_shared_nodes;
  std::map<std::array<std::size_t, 3>, std::size_t> m_shared_mid_side_nodes; // by both ends and the edge of the model
  std::map<std::array<std::size_t, 2>, std::size_t> m_lines;                 // by both ends: the curve

public:
  Element_mesh_maker(const Open_cascade_model_3& shape, const Open_cascade_names_3& names, const TriangleMesh& tm, const NamedParameters& np)
    : m_shape(shape), m_tm(tm), m_np(np), m_entities(names, m_result), m_parts_of_faces(parts_of_model_faces(shape, names)),
      m_shape_edges(shape_edges_of_model(shape)), m_nodes(get(dynamic_vertex_property_t<std::size_t>(), tm)),
      m_surfaces(get(dynamic_face_property_t<std::size_t>(), tm)), m_mid_side_nodes(get(dynamic_edge_property_t<std::size_t>(), tm))
  {
    m_has_other_side.resize(shape.model.faces().size());
    for(const auto& face : shape.model.faces())
      if(face.other_side_of < m_has_other_side.size())
        m_has_other_side[face.other_side_of] = true;
  }

  Element_mesh_3 operator()()
  {
    add_nodes();
    add_elements();
    return finished();
  }

  // With nodes on edges; `points` has the points.
  template <class MidSidePointMap>
  Element_mesh_3 with_mid_side_nodes(const MidSidePointMap& points)
  {
    m_result.is_second_order = true;
    add_nodes();
    for(const edge_descriptor e : edges(m_tm))
      if(!is_back(face(inner_halfedge(e), m_tm)) || !is_inside_face(e))
        add_mid_side_node(e, get(points, e));
    add_elements();
    return finished();
  }

private:
  template <class Tag>
  auto map(Tag tag) const
  {
    return parameters::get_parameter(m_np, tag);
  }

  template <class Point>
  std::size_t add_node(const Point& p)
  {
    m_result.nodes.push_back({p.x(), p.y(), p.z()});
    m_result.places.emplace_back();
    return m_result.nodes.size() - 1;
  }

  void add_nodes()
  {
    const auto points = parameters::choose_parameter(parameters::get_parameter(m_np, internal_np::vertex_point),
                                                     get_const_property_map(vertex_point, m_tm));
    for(const vertex_descriptor v : vertices(m_tm)) {
      const auto& p = get(points, v);
      Parametric_surface_mesher::Vertex_place place = get(map(Vertex_place_map_t()), v);
      const bool is_in_model = place.index != Parametric_surface_mesher::Vertex_place::none;
      if(place.dimension == 2 && is_in_model) {
        const std::size_t front = front_of(place.index);
        if(front == place.index && !m_has_other_side[front]) { // it has no copies
          put(m_nodes, v, add_node(p));
          continue;
        }
        place.index = front;
      }
      const auto found = m_shared_nodes.emplace(std::make_tuple(place.dimension, place.index, Element_mesh_3::Point{{p.x(), p.y(), p.z()}}),
                                                m_result.nodes.size());
      put(m_nodes, v, found.second ? add_node(p) : found.first->second);
    }
  }

  // The face of the model that one is the other side of, or itself.
  std::size_t front_of(std::size_t model_face) const
  {
    const std::size_t front = m_shape.model.faces()[model_face].other_side_of;
    return front < m_has_other_side.size() ? front : model_face;
  }

  std::size_t patch(face_descriptor f) const { return get(map(Face_patch_id_map_t()), f); }
  bool is_back(face_descriptor f) const { return front_of(patch(f)) != patch(f); }

  bool is_inside_face(edge_descriptor e) const
  {
    return get(map(Edge_place_map_t()), e).index == Parametric_surface_mesher::Edge_place::none;
  }

  // Copies of an edge have one node.
  template <class Point>
  void add_mid_side_node(edge_descriptor e, const Point& p)
  {
    const std::size_t a = get(m_nodes, source(e, m_tm)), b = get(m_nodes, target(e, m_tm));
    if(is_inside_face(e)) {
      put(m_mid_side_nodes, e, add_node(p));
      return;
    }
    const auto found = m_shared_mid_side_nodes.emplace(std::array<std::size_t, 3>{{(std::min)(a, b), (std::max)(a, b), get(map(Edge_place_map_t()), e).index}},
                                                       m_result.nodes.size());
    put(m_mid_side_nodes, e, found.second ? add_node(p) : found.first->second);
  }

  void add_elements()
  {
    add_surfaces();
    for(const face_descriptor f : faces(m_tm))
      add_triangle(f);
    for(const edge_descriptor e : edges(m_tm))
      add_line(e);
    for(const vertex_descriptor v : vertices(m_tm))
      add_point(v);
  }

  // In the order of their numbers.
  void add_surfaces()
  {
    std::set<std::pair<std::size_t, std::size_t>> known; // faces of the shape, and parts
    for(const face_descriptor f : faces(m_tm))
      known.emplace(m_shape.shape_faces[patch(f)], m_parts_of_faces[front_of(patch(f))]);
    for(const auto& surface : known)
      m_entities.surface(surface.first, surface.second);
  }

  void add_triangle(face_descriptor f)
  {
    const std::size_t surface = m_entities.surface(m_shape.shape_faces[patch(f)], m_parts_of_faces[front_of(patch(f))]);
    put(m_surfaces, f, surface);
    if(is_back(f)) {
      m_entities.set_part_in_front(surface, m_parts_of_faces[patch(f)]);
      return;
    }
    Element_mesh_3::Triangle triangle;
    triangle.fill(Element_mesh_3::none);
    std::size_t i = 0;
    for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, m_tm), m_tm)) {
      const std::size_t node = get(m_nodes, target(h, m_tm));
      triangle[i] = node;
      if(m_result.is_second_order) {
        triangle[3 + i] = get(m_mid_side_nodes, edge(next(h, m_tm), m_tm));
        place_on_surface(triangle[3 + i], surface);
      }
      if(place_on_surface(node, surface)) {
        const auto uv = get(map(Halfedge_uv_map_t()), h);
        m_result.places[node].u = uv.x();
        m_result.places[node].v = uv.y();
      }
      ++i;
    }
    m_result.triangles.push_back(triangle);
    m_result.triangle_surfaces.push_back(surface);
  }

  bool place_on_surface(std::size_t node, std::size_t surface)
  {
    if(m_result.places[node].entity != Element_mesh_3::none)
      return false;
    m_result.places[node].entity = surface;
    return true;
  }

  halfedge_descriptor inner_halfedge(edge_descriptor e) const
  {
    const halfedge_descriptor h = halfedge(e, m_tm);
    return is_border(h, m_tm) ? opposite(h, m_tm) : h;
  }

  void add_line(edge_descriptor e)
  {
    const Parametric_surface_mesher::Edge_place place = get(map(Edge_place_map_t()), e);
    const std::size_t shape_edge = place.index == Parametric_surface_mesher::Edge_place::none ? Element_mesh_3::none : m_shape_edges[place.index];
    if(shape_edge == Element_mesh_3::none)
      return;
    const std::size_t curve = m_entities.curve(shape_edge, get(m_surfaces, face(inner_halfedge(e), m_tm)));
    const halfedge_descriptor h = halfedge(e, m_tm);
    Element_mesh_3::Line line{{get(m_nodes, source(h, m_tm)), get(m_nodes, target(h, m_tm)), Element_mesh_3::none}};
    const auto found = m_lines.emplace(std::array<std::size_t, 2>{{(std::min)(line[0], line[1]), (std::max)(line[0], line[1])}}, curve);
    if(!found.second && found.first->second == curve) // a copy
      return;
    if(place.parameters[1] < place.parameters[0])
      std::swap(line[0], line[1]);
    if(m_result.is_second_order) {
      line[2] = get(m_mid_side_nodes, e);
      m_result.places[line[2]] = Place{1, curve};
    }
    m_result.lines.push_back(line);
    m_result.line_curves.push_back(curve);
    for(const vertex_descriptor v : {source(h, m_tm), target(h, m_tm)}) {
      const Parametric_surface_mesher::Vertex_place of_vertex = get(map(Vertex_place_map_t()), v);
      Place& of_node = m_result.places[get(m_nodes, v)];
      if(of_node.dimension == 2) {
        of_node = Place{1, curve};
        if(of_vertex.dimension == 1 && of_vertex.index == place.index)
          of_node.u = of_vertex.parameter;
      }
    }
  }

  void add_point(vertex_descriptor v)
  {
    const Parametric_surface_mesher::Vertex_place place = get(map(Vertex_place_map_t()), v);
    if(place.dimension != 0 || place.index >= m_shape.shape_vertices.size()
       || m_shape.shape_vertices[place.index] == Open_cascade_model_3::none)
      return;
    const std::size_t node = get(m_nodes, v);
    if(m_result.places[node].dimension == 0) // a copy
      return;
    const halfedge_descriptor h = halfedge(v, m_tm);
    const face_descriptor f = face(is_border(h, m_tm) ? opposite(h, m_tm) : h, m_tm);
    const std::size_t vertex = m_entities.vertex(m_shape.shape_vertices[place.index], get(m_surfaces, f));
    m_result.places[node] = Place{0, vertex};
    m_result.points.push_back(node);
    m_result.point_vertices.push_back(vertex);
  }

  Element_mesh_3 finished()
  {
    m_entities.add_groups();
    return std::move(m_result);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_ELEMENT_MESH_MAKER_H
