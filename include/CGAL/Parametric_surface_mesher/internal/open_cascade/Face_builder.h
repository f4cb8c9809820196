// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_FACE_BUILDER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_FACE_BUILDER_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Face_interior.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Loop_closer.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/convert_curves.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/find_sphere_chart.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Narrow_face_closer.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/order_uses.h>

#include <BRep_Tool.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Builds one face of a model from a face of the shape.
class Face_builder
{
  typedef Parametric_surface_model_3<Open_cascade_surface_3> Model;
  typedef Model::Geom_traits Kernel;
  typedef Model::Point_3 Point_3;
  typedef Model::Edge_use Edge_use;
  typedef Model::Loop Loop;
  typedef Model::Curve Curve;

  // An edge and a curve in the domain are compared at 17 points.
  static constexpr int number_of_samples = 16;
  // As shares of the diagonal of the shape. A curve that is farther from its edge than the first is projected anew if that
  // helps; farther than the second, its face is refused.
  static constexpr double distrusted_gap = 1e-4, refused_gap = 1e-2;
  // A curve is not distrusted either if it is within so many tolerances of the edge in the file, as far as these are trusted: readers
  // widen tolerances to whatever their own projections of curves are off by.
  static constexpr double trusted_tolerances = 10, most_trusted_gap = 2.5e-4;
  // As a share of the diagonal: points of loops closer than this are the same point. The default precision of Open CASCADE for a
  // shape of size 1.
  static constexpr double least_tolerance = 1e-7;
  // A little more than what was measured, so that other roundings of the same distance are within the tolerance.
  static constexpr double allowance_for_rounding = 1.01;

  Open_cascade_model_3& m_result;
  const TopTools_IndexedMapOfShape& m_edges;
  const std::vector<Edge_replacement>& m_places; // by edge of the shape
  const std::vector<double>& m_vertex_tolerances;
  TopoDS_Face m_face; // with forward orientation
  std::size_t m_number;
  Open_cascade_surface_3 m_surface, m_original; // the surface of the model, and that of the file
  std::optional<Stereographic_sphere_3<Kernel>> m_chart; // if the two differ, as on some spheres
  std::vector<std::pair<std::size_t, double>> m_gaps; // by edge

public:
  Face_builder(Open_cascade_model_3& result, const TopTools_IndexedMapOfShape& edges,
               const std::vector<Edge_replacement>& places, const std::vector<double>& vertex_tolerances, const TopoDS_Face& face,
               std::size_t number)
    : m_result(result), m_edges(edges), m_places(places), m_vertex_tolerances(vertex_tolerances),
      m_face(TopoDS::Face(face.Oriented(TopAbs_FORWARD))), m_number(number), m_surface(m_face), m_original(m_surface),
      m_chart(Sphere_chart_finder(m_face).find<Kernel>())
  {
    if(m_chart)
      m_surface = Open_cascade_surface_3::reparametrized(*m_chart);
  }

  // The face, with no side and shell set.
  Model::Face operator()()
  {
    std::vector<Loop> loops;
    const Use_order order(m_result.model, m_surface);
    for(TopoDS_Iterator wire(m_face); wire.More(); wire.Next())
      if(wire.Value().ShapeType() == TopAbs_WIRE) {
        const Loop uses = uses_of(wire.Value());
        for(Loop& loop : order(uses)) {
          m_result.number_of_removed_slits -= loop.size(); // the uses of slits, which are in no loop, remain
          loops.push_back(std::move(loop));
        }
        m_result.number_of_removed_slits += uses.size();
      }
    if(loops.empty())
      throw Parametric_surface_mesh_error("the face has no boundary");
    Loop_closer close(m_result.model, m_surface, m_vertex_tolerances, least_tolerance * m_result.diagonal,
                      distrusted_gap * m_result.diagonal);
    close(loops);
    for(const Loop& loop : loops)
      for(const Edge_use& use : loop)
        measure_gap(use);
    Model::Face result{m_surface, std::move(loops)};
    add_inner_elements(close, result);
    keep_gaps();
    return result;
  }

private:
  Loop uses_of(const TopoDS_Shape& wire)
  {
    Loop result;
    for(TopoDS_Iterator i(wire); i.More(); i.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(i.Value());
      if(edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED)
        continue; // an edge inside or outside the face is no boundary; see `add_inner_elements()`
      const std::size_t number = std::size_t(m_edges.FindIndex(edge)) - 1;
      if(m_places[number].is_point)
        continue;
      const Edge_use use{number, edge.Orientation() == TopAbs_REVERSED, domain_curve(edge, number)};
      if(!is_no_boundary(use))
        append_in_place(use, result);
    }
    return result;
  }

  // Adds what lies inside the face. What does not fit there is no reason to leave the face out; it is listed with the reason.
  void add_inner_elements(Loop_closer& close, Model::Face& face)
  {
    const auto is_of_face = [this](const auto& inner) { return inner.shape_face == m_number; };
    if(std::none_of(m_result.inner_edges.begin(), m_result.inner_edges.end(), is_of_face)
       && std::none_of(m_result.inner_vertices.begin(), m_result.inner_vertices.end(), is_of_face))
      return;
    Face_interior interior(m_result.model, face);
    for(auto& inner : m_result.inner_edges)
      if(inner.shape_face == m_number && inner.reason.empty())
        inner.reason = reason_of_error([&] {
          const TopoDS_Edge edge = TopoDS::Edge(m_edges(int(inner.shape_edge) + 1).Oriented(TopAbs_FORWARD));
          if(m_places[inner.shape_edge].is_point || BRep_Tool::Degenerated(edge))
            throw Parametric_surface_mesh_error("it is a point");
          Loop uses;
          append_in_place({inner.shape_edge, false, domain_curve(edge, inner.shape_edge)}, uses);
          for(Edge_use& use : uses) {
            close.attach(use, face.loops);
            measure_gap(use);
            interior.add(use);
          }
        });
    for(auto& inner : m_result.inner_vertices)
      if(inner.shape_face == m_number && inner.reason.empty())
        inner.reason = reason_of_error([&] { interior.add(inner_point(inner.shape_vertex, face.loops.front())); });
  }

  // What the function throws, as a sentence, or nothing.
  template <class Function>
  static std::string reason_of_error(const Function& function)
  {
    try {
      guarded(function);
      return "";
    }
    catch(const std::exception& error) {
      return error.what();
    }
  }

  // \pre vertices of the shape have the same numbers in the model
  Model::Inner_point inner_point(std::size_t vertex, const Loop& outer) const
  {
    const Point_3& p = m_result.model.vertices()[vertex];
    ShapeAnalysis_Surface surface(BRep_Tool::Surface(m_face));
    const gp_Pnt2d found = surface.ValueOfUV(gp_Pnt(p.x(), p.y(), p.z()), least_tolerance * m_result.diagonal);
    Kernel::Point_2 uv(found.X(), found.Y());
    if(m_chart)
      uv = m_chart->domain_point(m_original, uv);
    uv = uv + Domain_periods(m_surface).into(uv.bbox(), loop_box(outer, [](const Edge_use& use) -> const auto& { return use.curve; }));
    const double distance = std::sqrt(squared_distance(m_surface.point(uv.x(), uv.y()), p));
    if(!(distance <= refused_gap * m_result.diagonal))
      throw Parametric_surface_mesh_error("it is " + describe(distance) + " away from the surface");
    return {vertex, uv, 0, allowance_for_rounding * distance};
  }

  // Appends a use of an edge or, if the edge is replaced, uses of the edges in its place.
  void append_in_place(const Edge_use& use, Loop& result) const
  {
    if(m_places[use.edge].pieces.empty())
      result.push_back(use);
    for(const auto& piece : m_places[use.edge].pieces)
      result.push_back({piece.edge, use.is_reversed != piece.match.is_reversed(), piece.match.reparametrized(use.curve)});
  }

  // Whether an edge that is marked as collapsed is no side of the domain. In the chart of a sphere a pole is a regular point.
  // Elsewhere the mark may be wrong: Open CASCADE's readers add such edges between curves that are periods apart, which
  // Loop_closer joins.
  bool is_no_boundary(const Edge_use& use) const
  {
    const auto& edge = m_result.model.edges()[use.edge];
    return edge.is_collapsed
           && (m_chart || gap(use.edge, use.curve) > (std::max)(distrusted_gap * m_result.diagonal, trusted_tolerances * edge.tolerance));
  }

  // The part of a curve of an edge between the vertices.
  Curve in_range(const Curve& curve, std::size_t edge) const
  {
    const Unit_range& range = m_places[edge].range;
    return range.length() == 1 ? curve : restricted(curve, range);
  }

  Curve charted(const Curve& curve) const { return m_chart ? m_chart->curve(m_original, curve) : curve; }

  // The curve of the file or, if that is missing or far from the edge, a projected one if that is closer.
  Curve domain_curve(const TopoDS_Edge& edge, std::size_t number)
  {
    std::optional<Curve> curve = convert_domain_curve<Kernel>(edge, m_face);
    if(curve)
      curve = charted(in_range(*curve, number));
    const double gap = curve ? this->gap(number, *curve) : 0;
    if(curve && !(gap > distrusted(number)))
      return *curve;
    if(!BRep_Tool::IsClosed(edge, m_face)) {
      std::optional<Curve> other = project_domain_curve<Kernel>(edge, m_face);
      if(other)
        other = charted(in_range(*other, number));
      if(other && (!curve || this->gap(number, *other) < 0.5 * gap)) {
        ++m_result.number_of_rebuilt_curves;
        return *other;
      }
    }
    if(!curve)
      throw Parametric_surface_mesh_error(numbered("edge", number) + " has no curve in the domain, and cannot be projected");
    return *curve;
  }

  double tolerance(std::size_t edge) const
  {
    const auto& e = m_result.model.edges()[edge];
    return (std::max)({e.tolerance, m_vertex_tolerances[e.source], m_vertex_tolerances[e.target]});
  }

  double distrusted(std::size_t edge) const
  {
    return (std::max)(distrusted_gap * m_result.diagonal,
                      (std::min)(trusted_tolerances * tolerance(edge), most_trusted_gap * m_result.diagonal));
  }

  // The largest distance between the image of a curve and its edge in space, at the same parameters, and at the ends between the
  // image and the vertices.
  double gap(std::size_t number, const Curve& curve) const
  {
    const auto& edge = m_result.model.edges()[number];
    const auto& vertices = m_result.model.vertices();
    double squared = 0;
    for(int i = 0; i <= number_of_samples; ++i) {
      const double t = double(i) / number_of_samples;
      const auto uv = curve.point(t);
      const Point_3 p = m_surface.point(uv.x(), uv.y());
      double d = 0;
      if(i == 0 || edge.is_collapsed)
        d = squared_distance(p, vertices[edge.source]);
      else if(i == number_of_samples)
        d = squared_distance(p, vertices[edge.target]);
      else if(edge.curve)
        d = squared_distance(p, edge.curve->point(t));
      squared = d <= squared ? squared : d; // also keeps a distance that is not a number
    }
    return std::sqrt(squared);
  }

  void measure_gap(const Edge_use& use)
  {
    const double distance = gap(use.edge, use.curve);
    if(!(distance <= refused_gap * m_result.diagonal))
      throw Parametric_surface_mesh_error(numbered("edge", use.edge) + ": the image of its curve in the domain is "
                                          + describe(distance) + " away from the edge; its tolerance is "
                                          + describe(m_result.model.edges()[use.edge].tolerance));
    m_gaps.emplace_back(use.edge, distance);
  }

  // Sets tolerances of edges that allow the measured gaps, and reports gaps above the tolerances of the file.
  void keep_gaps()
  {
    for(const auto& gap : m_gaps) {
      auto& edge = m_result.model.edges()[gap.first];
      m_result.largest_gap = (std::max)(m_result.largest_gap, gap.second);
      if(gap.first < m_result.number_of_shape_edges && gap.second > allowance_for_rounding * tolerance(gap.first))
        m_result.gaps.push_back({gap.first, m_number, gap.second, tolerance(gap.first)});
      edge.tolerance = (std::max)(edge.tolerance, allowance_for_rounding * gap.second);
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_FACE_BUILDER_H
