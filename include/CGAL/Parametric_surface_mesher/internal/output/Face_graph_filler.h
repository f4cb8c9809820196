// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_FACE_GRAPH_FILLER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_FACE_GRAPH_FILLER_H

#include <CGAL/Parametric_surface_mesher/Model_places.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Border_edges.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Mesh_elements.h>
#include <CGAL/Parametric_surface_mesher/internal/support/for_each_index.h>

#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Writes an indexed mesh into new elements of a face graph, in linear time and by several threads. (CGAL's functions that make a
// mesh of a polygon soup use one thread and look up each edge.)
template <class Kernel, class TriangleMesh, class Elements, class Maps, class Places>
class Face_graph_filler
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef Indexed_mesh<Kernel> Mesh;
  typedef typename Mesh::Part Part;

  const Mesh& m_from;
  const Border_edges<Kernel>& m_border;
  const Elements& m_elements;
  TriangleMesh& m_mesh;
  const Maps& m_maps;
  const Places& m_places;

public:
  Face_graph_filler(const Mesh& from, const Border_edges<Kernel>& border, const Elements& elements, TriangleMesh& mesh,
                    const Maps& maps, const Places& places)
    : m_from(from), m_border(border), m_elements(elements), m_mesh(mesh), m_maps(maps), m_places(places)
  {}

  template <class ConcurrencyTag>
  void fill()
  {
    for(std::size_t i = 0; i < m_from.points.size(); ++i)
      put_vertex(i, i);
    for(std::size_t i = 0, n = m_from.number_of_points() - m_from.copies.size(); i < m_from.copies.size(); ++i)
      put_vertex(n + i, m_from.copies[i]);
    for_each_index<ConcurrencyTag>(m_from.parts.size(), [this](std::size_t i) {
      fill_vertices(m_from.parts[i]);
      fill_faces(m_from.parts[i]);
    });
    connect_borders();
    connect_inner_points();
    if(Maps::has_edge_places)
      put_places_of_borders();
  }

private:
  // `point`: a shared point, which vertex `i` is, or a copy of it
  void put_vertex(std::size_t i, std::size_t point)
  {
    put(m_maps.vertex_point_map, m_elements.new_vertex(i), m_from.points[point]);
    put(m_maps.vertex_uv_map, m_elements.new_vertex(i), m_from.domain_points[point]);
    put(m_maps.vertex_place_map, m_elements.new_vertex(i), m_places.vertex(point));
  }

  void fill_vertices(const Part& part)
  {
    for(std::size_t i = 0; i < part.points.size(); ++i) {
      put(m_maps.vertex_point_map, m_elements.new_vertex(part.first_point + i), part.points[i]);
      put(m_maps.vertex_place_map, m_elements.new_vertex(part.first_point + i), Vertex_place{2, part.patch, 0});
    }
    for(std::size_t i = 0; i < part.domain_points.size(); ++i)
      put(m_maps.vertex_uv_map, m_elements.new_vertex(part.first_point + i), part.domain_points[i]);
  }

  void fill_faces(const Part& part)
  {
    const std::size_t last_point = part.first_point + part.points.size();
    for(std::size_t f = 0; f < part.faces.size(); ++f) {
      const auto face = m_elements.new_face(part.first_face + f);
      for(std::size_t k = 0; k < 3; ++k) {
        const halfedge_descriptor h = m_elements.new_halfedge(part.halfedges[f][k]);
        const std::size_t v = part.faces[f][(k + 1) % 3];
        set_target(h, m_elements.new_vertex(v), m_mesh);
        set_face(h, face, m_mesh);
        set_next(h, m_elements.new_halfedge(part.halfedges[f][(k + 1) % 3]), m_mesh);
        if(v >= part.first_point && v < last_point)
          set_halfedge(m_elements.new_vertex(v), h, m_mesh);
        if(Maps::has_edge_places && part.halfedges[f][k] % 2 == 0)
          put(m_maps.edge_place_map, edge(h, m_mesh), Edge_place());
        if(m_from.keeps_corner_points)
          put(m_maps.halfedge_uv_map, h, part.corner_points[f][(k + 1) % 3]);
      }
      set_halfedge(face, m_elements.new_halfedge(part.halfedges[f][0]), m_mesh);
      put(m_maps.face_patch_id_map, face, part.patch);
    }
  }

  // Sets the halfedges on borders. A vertex that parts share is the target of a side on the border of each of them.
  void connect_borders()
  {
    for(const auto& side : m_border.sides()) {
      const Part& part = m_from.parts[side.part];
      const halfedge_descriptor h = m_elements.new_halfedge(part.halfedge(side.side));
      set_halfedge(target(h, m_mesh), h, m_mesh);
      if(!side.is_alone)
        continue;
      const halfedge_descriptor outer = opposite(h, m_mesh);
      set_target(outer, m_elements.new_vertex(part.source(side.side)), m_mesh);
      set_face(outer, Graph_traits::null_face(), m_mesh);
    }
    for(const auto& side : m_border.sides())
      if(side.is_alone)
        connect_border(opposite(m_elements.new_halfedge(m_from.parts[side.part].halfedge(side.side)), m_mesh));
  }

  // Gives points inside faces, which are on no border of a part, a halfedge.
  void connect_inner_points()
  {
    std::vector<bool> are_inner;
    for(const auto& place : m_from.places)
      are_inner.push_back(place.is_inside_face && place.dimension == 0);
    if(std::find(are_inner.begin(), are_inner.end(), true) == are_inner.end())
      return;
    for(const auto& side : m_border.sides())
      for(const std::size_t v : {m_from.parts[side.part].source(side.side), m_from.parts[side.part].target(side.side)})
        if(v < are_inner.size())
          are_inner[v] = false;
    for(const Part& part : m_from.parts)
      for(std::size_t f = 0; f < part.faces.size(); ++f)
        for(std::size_t k = 0; k < 3; ++k) {
          const std::size_t v = part.faces[f][(k + 1) % 3];
          if(v < are_inner.size() && are_inner[v])
            set_halfedge(m_elements.new_vertex(v), m_elements.new_halfedge(part.halfedges[f][k]), m_mesh);
        }
  }

  // The sides of one edge follow each other. Those before this are the places of edges that parts do not share.
  void put_places_of_borders()
  {
    const auto& sides = m_border.sides();
    for(std::size_t i = 0; i < sides.size(); ++i) {
      const bool is_joined = i + 1 < sides.size() && sides[i].has_vertices_of(sides[i + 1]);
      const halfedge_descriptor h = m_elements.new_halfedge(m_from.parts[sides[i].part].halfedge(sides[i].side));
      Edge_place place = m_places.edge(sides[i], is_joined ? &sides[i + 1] : nullptr);
      if(h != halfedge(edge(h, m_mesh), m_mesh))
        std::swap(place.parameters[0], place.parameters[1]);
      put(m_maps.edge_place_map, edge(h, m_mesh), place);
      i += is_joined;
    }
  }

  // Finds the next border halfedge by turning around the target through the triangles there, so that parts that touch only in a
  // vertex keep separate borders.
  void connect_border(halfedge_descriptor h)
  {
    halfedge_descriptor next_border = opposite(h, m_mesh);
    do
      next_border = opposite(next(next(next_border, m_mesh), m_mesh), m_mesh);
    while(face(next_border, m_mesh) != Graph_traits::null_face());
    set_next(h, next_border, m_mesh);
    set_halfedge(target(h, m_mesh), h, m_mesh);
  }
};

template <class ConcurrencyTag, class Elements, class Kernel, class TriangleMesh, class Maps, class Places>
void fill_face_graph(const Indexed_mesh<Kernel>& from, const Border_edges<Kernel>& border, TriangleMesh& mesh,
                     const Maps& maps, const Places& places)
{
  const Elements elements(from.number_of_points(), border.number_of_edges(), from.number_of_faces(), mesh);
  Face_graph_filler<Kernel, TriangleMesh, Elements, Maps, Places> filler(from, border, elements, mesh, maps, places);
  filler.template fill<ConcurrencyTag>();
}

// Adds a finished mesh to a face graph, vertices and faces in their order, with threads if its elements and maps allow this.
// \throws Parametric_surface_mesh_error, before anything is added, if the triangles are not the faces of a manifold mesh
template <class ConcurrencyTag, class Kernel, class TriangleMesh, class Maps, class Places>
void add_to_face_graph(Indexed_mesh<Kernel>& from, TriangleMesh& mesh, const Maps& maps, const Places& places)
{
  const Border_edges<Kernel> border(from);
  if constexpr(Is_surface_mesh<TriangleMesh>::value)
    if(!mesh.has_garbage()) {
      typedef std::conditional_t<Maps::template are_concurrent<TriangleMesh>(), ConcurrencyTag, Sequential_tag> Tag;
      fill_face_graph<Tag, Appended_elements<TriangleMesh>>(from, border, mesh, maps, places);
      return;
    }
  fill_face_graph<Sequential_tag, Added_elements<TriangleMesh>>(from, border, mesh, maps, places);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OUTPUT_FACE_GRAPH_FILLER_H
