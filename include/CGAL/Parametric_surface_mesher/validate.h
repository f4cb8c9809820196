// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_VALIDATE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_VALIDATE_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/model/Model_uses.h>
#include <CGAL/Parametric_surface_mesher/internal/model/curve_box.h>
#include <CGAL/Parametric_surface_mesher/internal/model/name_face.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Boundary_size.h>
#include <CGAL/Parametric_surface_mesher/internal/support/check_value.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Parametric_surface_model_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {

namespace internal {

// Checks that the parts of a model fit together.
template <class Surface>
class Model_validation
{
  typedef Parametric_surface_model_3<Surface> Model;
  typedef typename Model::Edge Edge;
  typedef typename Model::Edge_use Edge_use;
  typedef typename Model::Face Face;
  typedef typename Model::Loop Loop;
  typedef typename Model::Point_3 Point_3;
  typedef Model_uses<Model> Uses;

  static constexpr int number_of_samples = 9;

  const Model& m_model;
  bool m_is_any_face_left_out;
  double m_tolerance = 0;

public:
  // Faces that are left out have no loops.
  explicit Model_validation(const Model& model, bool is_any_face_left_out = false)
    : m_model(model), m_is_any_face_left_out(is_any_face_left_out)
  {}

  // Throws the first error that is found.
  void operator()()
  {
    const auto throw_on = [](const Parametric_surface_mesh_error& error) { throw error; };
    check_elements();
    check_loops(throw_on);
    check_uses(throw_on);
  }

  // What no face can do without.
  void check_elements() const
  {
    if(m_model.faces().empty())
      throw Parametric_surface_mesh_error("the model has no faces");
    check_vertices();
    for(std::size_t e = 0; e < m_model.edges().size(); ++e)
      check_edge(e);
  }

  // Each face for itself. `on_error`: takes an error of each bad face; if it returns, the others are checked
  template <class OnError>
  void check_loops(const OnError& on_error) const
  {
    std::set<std::size_t> faces_with_other_side;
    for(std::size_t f = 0; f < m_model.faces().size(); ++f)
      check_face(f, on_error, [&] {
        check_length("wanted edge length", m_model.faces()[f].max_edge, numbered("face", f));
        for(std::size_t l = 0; l < number_of_loops(f); ++l)
          check_loop(f, l);
        for(const auto& point : m_model.faces()[f].inner_points)
          check_inner_point(f, point);
        check_other_side(f, faces_with_other_side);
      });
  }

  // The faces with each other. `on_error`: as above; the others are checked as if the bad face were not there
  // \pre the loops are good
  template <class OnError>
  void check_uses(const OnError& on_error)
  {
    Uses uses(m_model);
    Bbox_3 box;
    const auto leave_out = [&](const Parametric_surface_mesh_error& error) {
      uses.leave_out(error.face().value()); // while its loops are there: `on_error` may take them away
      on_error(error);
    };
    for(std::size_t f = 0; f < m_model.faces().size(); ++f)
      check_face(f, leave_out, [&] { box += boundary_box(m_model, f); });
    m_tolerance = m_model.tolerance() > 0 ? m_model.tolerance() : 1e-6 * diagonal(box);
    for(std::size_t f = 0; f < m_model.faces().size(); ++f)
      if(!m_model.faces()[f].loops.empty())
        check_face(f, leave_out, [&] { check_places_of_inner_points(f); });
    const std::vector<std::size_t> order = uses.order();
    std::vector<std::size_t> places(m_model.edges().size()); // of the edges in the order
    for(std::size_t i = 0; i < order.size(); ++i)
      places[order[i]] = i;
    std::set<std::size_t> left; // places of edges that are to be checked
    for(std::size_t i = 0; i < order.size(); ++i)
      left.insert(left.end(), i);
    while(!left.empty())
      try {
        check_uses_of_edge(order[*left.begin()], uses);
        left.erase(left.begin());
      }
      catch(const Parametric_surface_mesh_error& error) {
        // its edges may have another first use now
        for(const auto& loop : m_model.faces()[error.face().value()].loops)
          for(const Edge_use& use : loop)
            left.insert(places[use.edge]);
        leave_out(error);
      }
  }

private:
  // Calls `check`; an error that it throws goes to `on_error`, with the number of the face.
  template <class OnError, class Check>
  static void check_face(std::size_t face, const OnError& on_error, const Check& check)
  {
    try {
      about_face(face, check);
    }
    catch(const Parametric_surface_mesh_error& error) {
      on_error(error);
    }
  }

  // \pre errors tell the face
  void check_uses_of_edge(std::size_t e, const Uses& uses) const
  {
    for(const auto& use : uses[e])
      about_face(use.face, [&] { check_use(use.face, *use.use, uses[e].front().face, *uses[e].front().use); });
    check_orientation(e, uses);
  }

  void check_vertices() const
  {
    for(std::size_t v = 0; v < m_model.vertices().size(); ++v) {
      const Point_3& p = m_model.vertices()[v];
      if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
        throw Parametric_surface_mesh_error(numbered("vertex", v) + " is not finite: it is at (" + describe(p.x()) + ", "
                                            + describe(p.y()) + ", " + describe(p.z()) + ")");
    }
  }

  void check_edge(std::size_t e) const
  {
    m_model.check_vertices_of_edge(e);
    check_length("tolerance", m_model.edges()[e].tolerance, numbered("edge", e));
    check_length("longest edge of the division", m_model.edges()[e].max_edge, numbered("edge", e));
  }

  static void check_length(const char* name, double length, const std::string& place)
  {
    if(!(length >= 0 && std::isfinite(length)))
      throw_out_of_range(name + (" of " + place), "at least 0 and finite", length);
  }

  std::size_t number_of_loops(std::size_t f) const
  {
    if(m_model.faces()[f].loops.empty() && !m_is_any_face_left_out)
      throw Parametric_surface_mesh_error(numbered("face", f) + " has no loop");
    return m_model.faces()[f].loops.size();
  }

  void check_loop(std::size_t f, std::size_t l) const
  {
    const auto& loop = m_model.faces()[f].loops[l];
    const std::string place = numbered("face", f) + ", " + numbered("loop", l);
    if(loop.empty())
      throw Parametric_surface_mesh_error(place + " has no edge");
    check_edge_numbers(m_model, f, l);
    for(const Edge_use& use : loop)
      for(const auto& end : {use.curve.source(), use.curve.target()})
        if(!std::isfinite(end.x()) || !std::isfinite(end.y()))
          throw Parametric_surface_mesh_error(place + ", " + numbered("edge", use.edge)
                                              + ": the curve in the domain ends at (u,v) = " + describe(end)
                                              + ", which is not finite");
    const Bbox_2 box = loop_box(loop, [](const Edge_use& use) -> const auto& { return use.curve; });
    const double tolerance = 1e-6 * (box.x_span() + box.y_span());
    for(std::size_t i = 0; i < loop.size(); ++i)
      check_joint(loop[i], loop[(i + 1) % loop.size()], place, tolerance);
  }

  void check_inner_point(std::size_t f, const typename Model::Inner_point& point) const
  {
    const std::string place = numbered("face", f) + ": the inner point at (u,v) = " + describe(point.parameters);
    if(point.vertex >= m_model.vertices().size())
      throw Parametric_surface_mesh_error(place + " is no vertex: there is none with index " + std::to_string(point.vertex));
    if(!std::isfinite(point.parameters.x()) || !std::isfinite(point.parameters.y()))
      throw Parametric_surface_mesh_error(place + " is not finite");
    check_length("wanted edge length", point.max_edge, place);
    check_length("tolerance", point.tolerance, place);
  }

  void check_places_of_inner_points(std::size_t f) const
  {
    for(const auto& point : m_model.faces()[f].inner_points) {
      Gap gap;
      gap.add(m_model.faces()[f].surface.point(point.parameters.x(), point.parameters.y()), m_model.vertices()[point.vertex], "");
      const double tolerance = (std::max)(m_tolerance, point.tolerance);
      if(!(gap.distance <= tolerance))
        throw Parametric_surface_mesh_error(numbered("face", f) + ": the inner point at (u,v) = " + describe(point.parameters) + " is "
                                            + describe(gap.distance) + " away from " + numbered("vertex", point.vertex)
                                            + "; the tolerance is " + describe(tolerance));
    }
  }

  // `fronts`: takes the faces that have an other side
  void check_other_side(std::size_t f, std::set<std::size_t>& fronts) const
  {
    const auto& face = m_model.faces()[f];
    const std::size_t front = face.other_side_of;
    if(front == Model::no_face)
      return;
    const std::string place = numbered("face", f) + " is to be the other side of ";
    if(!(front < f))
      throw Parametric_surface_mesh_error(place + "a face that does not come before it, with the index " + std::to_string(front));
    const auto& other = m_model.faces()[front];
    const std::string name = numbered("face", front);
    if(other.other_side_of != Model::no_face || !fronts.insert(front).second)
      throw Parametric_surface_mesh_error(place + name + ", which is or has an other side already");
    if(face.shell == other.shell || face.is_reversed == other.is_reversed)
      throw Parametric_surface_mesh_error(place + name + ", but " + (face.shell == other.shell ? "is in the same shell" : "faces to the same side"));
    if(!other.loops.empty() && !have_same_uses(face.loops, other.loops)) // else it is left out
      throw Parametric_surface_mesh_error(place + name + ", but has other loops");
  }

  static bool have_same_uses(const std::vector<Loop>& loops, const std::vector<Loop>& others)
  {
    return std::equal(loops.begin(), loops.end(), others.begin(), others.end(), [](const Loop& loop, const Loop& other) {
      return std::equal(loop.begin(), loop.end(), other.begin(), other.end(), [](const Edge_use& use, const Edge_use& other_use) {
        return use.edge == other_use.edge && use.is_reversed == other_use.is_reversed;
      });
    });
  }

  // One use ends where the next one begins, at the same vertex and in the domain.
  void check_joint(const Edge_use& use, const Edge_use& next, const std::string& place, double tolerance) const
  {
    const std::size_t end = end_vertex(use, !use.is_reversed), begin = end_vertex(next, next.is_reversed);
    if(end != begin)
      throw Parametric_surface_mesh_error(place + " is open: " + numbered("edge", use.edge) + " ends at "
                                          + numbered("vertex", end) + ", but the next one, " + numbered("edge", next.edge)
                                          + ", begins at " + numbered("vertex", begin));
    const auto p = use.is_reversed ? use.curve.source() : use.curve.target(),
               q = next.is_reversed ? next.curve.target() : next.curve.source();
    if(!(squared_distance(p, q) <= tolerance * tolerance))
      throw Parametric_surface_mesh_error(place + " is open in the domain: " + numbered("edge", use.edge)
                                          + " ends at (u,v) = " + describe(p) + ", the next one, "
                                          + numbered("edge", next.edge) + ", begins at " + describe(q));
  }

  std::size_t end_vertex(const Edge_use& use, bool is_target) const
  {
    return is_target ? m_model.edges()[use.edge].target : m_model.edges()[use.edge].source;
  }

  // The use is the same curve in space, at the same parameters, as the edge: its own curve if it has one, else its first
  // use.
  void check_use(std::size_t f, const Edge_use& use, std::size_t first_face, const Edge_use& first) const
  {
    const Edge& edge = m_model.edges()[use.edge];
    check_range(f, use, edge.curve ? edge.curve->begin() : first.curve.begin(),
                edge.curve ? edge.curve->end() : first.curve.end());
    Gap largest;
    for(int k = 0; k < number_of_samples; ++k) {
      const double share = double(k) / (number_of_samples - 1);
      const Point_3 p = point(f, use, share);
      if(k == 0 || edge.is_collapsed)
        largest.add(p, m_model.vertices()[edge.source], numbered("vertex", edge.source));
      else if(k == number_of_samples - 1)
        largest.add(p, m_model.vertices()[edge.target], numbered("vertex", edge.target));
      else if(edge.curve)
        largest.add(p, edge.curve->point(parameter(*edge.curve, share)), "the curve of the edge");
      else
        largest.add(p, point(first_face, first, share), "its image on " + numbered("face", first_face));
    }
    const double tolerance = (std::max)(m_tolerance, edge.tolerance);
    if(!(largest.distance <= tolerance))
      throw Parametric_surface_mesh_error(numbered("face", f) + ", " + numbered("edge", use.edge)
                                          + ": the image of the curve in the domain is " + describe(largest.distance)
                                          + " away from " + largest.what + "; the tolerance is " + describe(tolerance));
  }

  void check_range(std::size_t f, const Edge_use& use, double begin, double end) const
  {
    if(use.curve.begin() != begin || use.curve.end() != end)
      throw Parametric_surface_mesh_error(numbered("face", f) + ", " + numbered("edge", use.edge)
                                          + ": the curve in the domain has the parameters " + describe(use.curve.begin())
                                          + " to " + describe(use.curve.end()) + ", but the edge " + describe(begin)
                                          + " to " + describe(end));
  }

  // the largest distance of points that should be one
  struct Gap
  {
    double distance = 0;
    std::string what;

    void add(const Point_3& p, const Point_3& q, const std::string& name_of_q)
    {
      const double d = std::sqrt(squared_distance(p, q));
      if(d <= distance)
        return;
      distance = d; // also if it is not a number
      what = name_of_q;
    }
  };

  template <class Curve>
  static double parameter(const Curve& curve, double share)
  {
    return curve.begin() + share * (curve.end() - curve.begin());
  }

  Point_3 point(std::size_t f, const Edge_use& use, double share) const
  {
    const auto uv = use.curve.point(share == 1 ? use.curve.end() : parameter(use.curve, share));
    return m_model.faces()[f].surface.point(uv.x(), uv.y());
  }

  // Two uses in one shell must lie on different sides of the edge.
  void check_orientation(std::size_t e, const Uses& uses) const
  {
    if(m_model.edges()[e].is_collapsed || m_model.edges()[e].allows_turned_faces)
      return;
    for(const auto& shell : uses.by_shell(e))
      if(shell.second.size() == 2 && uses.is_face_left(shell.second[0]) == uses.is_face_left(shell.second[1]))
        throw Parametric_surface_mesh_error(numbered("faces", shell.second[0].face) + " and "
                                            + std::to_string(shell.second[1].face + 1) + " face to different sides along "
                                            + numbered("edge", e) + ": reverse one of them, or call orient_faces()",
                                            shell.second[1].face);
  }
};

} // namespace internal

/*!
\ingroup PkgParametricSurfaceMesherModel

checks that the parts of a model fit together: what edges and loops refer to exists, and coordinates, lengths and tolerances
are finite; every loop is closed, by its vertices and in the domain of its face; every
use of an edge is, at the same parameters, the same curve in space as the edge, within the tolerance of the model or that
of the edge if it is larger (compared at nine points); and two faces of a shell at an edge face to the same side, unless the edge
allows others. Meshing calls it.

\throws Parametric_surface_mesh_error if something does not fit; the message names the face, the loop, the edge and the
distance

Complexity: linear in the number of edge uses, apart from looking them up by shell.
*/
template <class Surface>
void validate(const Parametric_surface_model_3<Surface>& model)
{
  internal::Model_validation<Surface> check(model);
  check();
}

} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_VALIDATE_H
