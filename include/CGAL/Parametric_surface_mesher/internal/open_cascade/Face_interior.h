// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_FACE_INTERIOR_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_FACE_INTERIOR_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Boundary_loops.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Open_cascade_model_3.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Adds to a face what lies inside it: only what meets other edges in common vertices, and is inside the loops. Files have all kinds of
// edges marked as internal; one that does not fit would make the face impossible to mesh. Curves are compared as polylines, and once more
// as finer ones where those meet.
class Face_interior
{
  typedef Parametric_surface_model_3<Open_cascade_surface_3> Model;
  typedef Model::Geom_traits Kernel;
  typedef Kernel::Point_2 Point_2;
  typedef Model::Edge_use Edge_use;
  typedef Boundary_vertex<Kernel> Vertex;
  typedef std::vector<Vertex> Polyline;

  static constexpr int number_of_pieces = 32, number_of_fine_pieces = 512; // of a curve

  const Model& m_model;
  Model::Face& m_face;
  int m_number_of_pieces;
  std::size_t m_number_of_loops; // around the domain
  std::size_t m_next_index;      // of points inside curves
  Boundary_loops<Kernel> m_polylines; // of all loops; those inside run back, too

public:
  // \pre there is nothing inside the face yet
  Face_interior(const Model& model, Model::Face& face) : Face_interior(model, face, number_of_pieces, face.loops.size()) {}

  // \throws Parametric_surface_mesh_error if the edge does not fit into the face
  void add(const Edge_use& use)
  {
    Polyline polyline = there_and_back(use);
    try {
      check(polyline, polyline[polyline.size() / 4].domain_point);
    }
    catch(const Parametric_surface_mesh_error&) {
      Face_interior fine(m_model, m_face, number_of_fine_pieces, m_number_of_loops);
      const Polyline fine_polyline = fine.there_and_back(use);
      fine.check(fine_polyline, fine_polyline[fine_polyline.size() / 4].domain_point);
    }
    m_polylines.push_back(std::move(polyline));
    m_face.loops.push_back({use, {use.edge, !use.is_reversed, use.curve}});
  }

  // \throws Parametric_surface_mesh_error if the point is not inside the face, or on an edge
  void add(const Model::Inner_point& point)
  {
    const Vertex vertex{point.parameters, CGAL::ORIGIN, point.vertex};
    for(const Polyline& polyline : m_polylines)
      for(const Vertex& v : polyline)
        if(v.index == point.vertex)
          throw Parametric_surface_mesh_error("it is a vertex of an edge");
    check({vertex, vertex}, point.parameters);
    m_polylines.push_back({vertex, vertex});
    m_face.inner_points.push_back(point);
  }

private:
  // `pieces_of_edge`: how many each edge is divided into. `number_of_loops`: around the domain; the others lie inside
  Face_interior(const Model& model, Model::Face& face, int pieces_of_edge, std::size_t number_of_loops)
    : m_model(model), m_face(face), m_number_of_pieces(pieces_of_edge), m_number_of_loops(number_of_loops),
      m_next_index(model.vertices().size())
  {
    for(std::size_t l = 0; l < face.loops.size(); ++l) {
      m_polylines.emplace_back();
      if(l < number_of_loops)
        for(const Edge_use& use : face.loops[l])
          append(use, m_polylines.back());
      else
        m_polylines.back() = there_and_back(face.loops[l].front());
    }
    for(const auto& point : face.inner_points)
      m_polylines.push_back(Polyline(2, {point.parameters, CGAL::ORIGIN, point.vertex}));
  }

  Polyline there_and_back(const Edge_use& use)
  {
    Polyline result;
    append(use, result);
    const std::size_t n = result.size();
    result.push_back({end_point(use), CGAL::ORIGIN, end_vertex(use)});
    for(std::size_t i = n; i-- > 1;)
      result.push_back(result[i]);
    return result;
  }

  static Point_2 end_point(const Edge_use& use) { return use.is_reversed ? use.curve.source() : use.curve.target(); }

  std::size_t begin_vertex(const Edge_use& use) const
  {
    return use.is_reversed ? m_model.edges()[use.edge].target : m_model.edges()[use.edge].source;
  }

  std::size_t end_vertex(const Edge_use& use) const
  {
    return use.is_reversed ? m_model.edges()[use.edge].source : m_model.edges()[use.edge].target;
  }

  // Appends the points of a curve but for the last one.
  void append(const Edge_use& use, Polyline& polyline)
  {
    const int n = use.curve.is_straight() ? 2 : m_number_of_pieces;
    for(int i = 0; i < n; ++i) {
      const double share = use.is_reversed ? 1 - double(i) / n : double(i) / n;
      polyline.push_back({use.curve.point(use.curve.begin() + share * (use.curve.end() - use.curve.begin())), CGAL::ORIGIN,
                          i == 0 ? begin_vertex(use) : m_next_index++});
    }
  }

  // `inside`: a point of the polyline that is none of its ends
  void check(const Polyline& polyline, const Point_2& inside) const
  {
    Boundary_loops<Kernel> close_ones;
    for(const Polyline& other : m_polylines)
      if(do_overlap(box_of_loops<Kernel>({other}), box_of_loops<Kernel>({polyline})))
        close_ones.push_back(other);
    close_ones.push_back(polyline);
    const Boundary_check<Kernel> check(close_ones);
    check.check_segments();
    for(const auto& crossing : check.crossings())
      if(crossing.second.first + 1 == close_ones.size())
        throw Parametric_surface_mesh_error(crossing.first.first + 1 == close_ones.size()
                                              ? "it crosses itself"
                                              : "it meets another edge, or a point, and not in a common vertex");
    if(!is_inside(inside))
      throw Parametric_surface_mesh_error("it is not inside the face");
  }

  // Counts the edges of the loops to the right of a point.
  bool is_inside(const Point_2& p) const
  {
    bool result = false;
    for(std::size_t l = 0; l < m_number_of_loops; ++l)
      for(std::size_t i = 0; i < m_polylines[l].size(); ++i) {
        const Point_2 &a = m_polylines[l][i].domain_point, &b = m_polylines[l][(i + 1) % m_polylines[l].size()].domain_point;
        if((a.y() > p.y()) != (b.y() > p.y()) && orientation(a, b, p) == (b.y() > a.y() ? LEFT_TURN : RIGHT_TURN))
          result = !result;
      }
    return result;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_FACE_INTERIOR_H
