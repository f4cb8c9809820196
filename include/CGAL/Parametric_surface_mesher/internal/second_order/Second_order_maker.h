// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_SECOND_ORDER_MAKER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_SECOND_ORDER_MAKER_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Curved_elements.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Mesh_in_model.h>
#include <CGAL/Parametric_surface_mesher/internal/second_order/Mid_side_placement.h>
#include <CGAL/Second_order_mesh_report.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Makes the mid-side nodes of a mesh.
template <class Surface, class Mesh>
class Second_order_maker
{
  typedef typename Surface::Geom_traits Kernel;
  typedef typename Kernel::Vector_3 Vector_3;
  typedef typename Mid_side_placement<Surface>::Place Place;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;
  typedef typename Mesh::face_descriptor face_descriptor;
  typedef typename Mesh::edge_descriptor edge_descriptor;
  typedef Curved_elements<Kernel> Elements;

  // What a solver takes without complaint: Gmsh's optimisation of curved elements stops at the same value.
  static constexpr double least_scaled_jacobian = 0.1;

  const Parametric_surface_model_3<Surface>& m_model;
  const Mesh& m_mesh;
  Mid_side_placement<Surface> m_placement;
  Second_order_mesh_report m_report;

public:
  // Refers to both.
  Second_order_maker(const Parametric_surface_model_3<Surface>& model, const Mesh& mesh)
    : m_model(model), m_mesh(mesh), m_placement(model)
  {}

  template <class MidSidePointMap>
  Second_order_mesh_report make(const MidSidePointMap& points)
  {
    const auto indices = get_initialized_edge_index_map(m_mesh.mesh);
    std::vector<typename Elements::Side> sides(num_edges(m_mesh.mesh));
    for(const edge_descriptor e : edges(m_mesh.mesh))
      sides[get(indices, e)] = side(e);
    std::vector<typename Elements::Element> triangles;
    for(const face_descriptor f : faces(m_mesh.mesh))
      triangles.push_back(element(f, indices));
    Elements elements(std::move(sides), std::move(triangles), least_scaled_jacobian);
    elements.curve_less();
    for(const edge_descriptor e : edges(m_mesh.mesh)) {
      const auto& side = elements.sides()[get(indices, e)];
      put(points, e, side.node());
      m_report.number_of_curved_less += side.is_curved_less();
    }
    judge(elements);
    return std::move(m_report);
  }

private:
  typename Elements::Side side(edge_descriptor e)
  {
    const halfedge_descriptor h = halfedge(e, m_mesh.mesh);
    const Chord<Kernel> chord{m_mesh.source_point(h), m_mesh.target_point(h)};
    const Place place = this->place(e, chord);
    return {chord.middle(), place.value_or(chord.middle())};
  }

  Place place(edge_descriptor e, const Chord<Kernel>& chord)
  {
    const Edge_place piece = m_mesh.place(e);
    if(piece.index == Edge_place::none)
      return counted(place_on_face(e, chord), m_report.number_on_surfaces);
    if(const Place place = m_placement.on_piece(piece.index, piece.parameters, chord))
      return counted(place, m_report.number_on_curves);
    const Place near = m_placement.near_edge(piece.index, chord);
    return counted(near ? near : place_on_face(e, chord), m_report.number_of_projected);
  }

  Place counted(const Place& place, std::size_t& number)
  {
    ++(place ? number : m_report.number_of_straight);
    return place;
  }

  Place place_on_face(edge_descriptor e, const Chord<Kernel>& chord) const
  {
    halfedge_descriptor h = halfedge(e, m_mesh.mesh);
    if(m_mesh.is_on_border(h))
      h = opposite(h, m_mesh.mesh);
    return m_placement.on_face(m_mesh.patch(face(h, m_mesh.mesh)), m_mesh.source_uv(h), m_mesh.target_uv(h), chord);
  }

  template <class EdgeIndexMap>
  typename Elements::Element element(face_descriptor f, const EdgeIndexMap& indices) const
  {
    typename Elements::Element result;
    std::size_t i = 0;
    for(const halfedge_descriptor h : m_mesh.sides(f)) {
      result.corners[i] = m_mesh.source_point(h);
      result.sides[i++] = get(indices, edge(h, m_mesh.mesh));
    }
    const auto& p = result.corners;
    const Vector_3 straight = cross_product(p[1] - p[0], p[2] - p[0]), normal = surface_normal(f);
    result.facing = normal * straight > 0 ? normal : straight; // straight triangles that face to the other side stay as they are
    return result;
  }

  // In the middle of a triangle, on the side of the surface that its face faces to; none if it cannot be evaluated.
  Vector_3 surface_normal(face_descriptor f) const
  {
    double u = 0, v = 0;
    for(const halfedge_descriptor h : m_mesh.sides(f)) {
      u += m_mesh.target_uv(h).x() / 3;
      v += m_mesh.target_uv(h).y() / 3;
    }
    const auto& patch = m_model.faces()[m_mesh.patch(f)];
    try {
      const auto jet = patch.surface.jet(u, v);
      return (patch.is_reversed ? -1 : 1) * cross_product(jet.du, jet.dv);
    }
    catch(const Parametric_surface_mesh_error&) {
      return Vector_3(0, 0, 0);
    }
  }

  void judge(const Elements& elements)
  {
    for(std::size_t f = 0; f < elements.jacobians().size(); ++f) {
      const double jacobian = elements.jacobians()[f];
      if(jacobian >= least_scaled_jacobian)
        m_report.smallest_scaled_jacobian = (std::min)(m_report.smallest_scaled_jacobian, jacobian);
      else
        m_report.uncertified.push_back({f, jacobian});
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SECOND_ORDER_SECOND_ORDER_MAKER_H
