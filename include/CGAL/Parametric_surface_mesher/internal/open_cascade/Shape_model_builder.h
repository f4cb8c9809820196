// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_SHAPE_MODEL_BUILDER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_SHAPE_MODEL_BUILDER_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/orient_faces.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Face_builder.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Narrow_face_closer.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/convert_curves.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/join_vertices.h>

#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Builds the model of a shape face by face; faces that cannot be built are left out.
class Shape_model_builder
{
  typedef Parametric_surface_model_3<Open_cascade_surface_3> Model;
  typedef Model::Geom_traits Kernel;

  Open_cascade_model_3 m_result;
  TopTools_IndexedMapOfShape m_vertices, m_edges, m_faces;
  std::vector<double> m_vertex_tolerances;
  std::vector<Unit_range> m_ranges; // by edge of the shape: the part of its curve that is used
  std::vector<Edge_replacement> m_places; // by edge of the shape
  std::set<std::size_t> m_closed_up; // by indices in the shape
  std::map<std::size_t, std::size_t> m_fronts; // the first faces of the model, by indices in the shape
  std::set<std::size_t> m_backs; // faces of the shape whose other side is in the model, too

public:
  explicit Shape_model_builder(const TopoDS_Shape& shape)
  {
    if(shape.IsNull())
      throw Parametric_surface_mesh_error("the shape is empty");
    TopExp::MapShapes(shape, TopAbs_VERTEX, m_vertices);
    TopExp::MapShapes(shape, TopAbs_EDGE, m_edges);
    TopExp::MapShapes(shape, TopAbs_FACE, m_faces);
    m_result.number_of_shape_faces = std::size_t(m_faces.Extent());
    m_result.number_of_shape_edges = std::size_t(m_edges.Extent());
    m_result.diagonal = diagonal();
  }

  // Closes up faces that are nowhere wider than a share of the diagonal.
  Open_cascade_model_3 operator()(const TopoDS_Shape& shape, double closed_up_width)
  {
    for(int i = 1; i <= m_vertices.Extent(); ++i)
      add_vertex(TopoDS::Vertex(m_vertices(i)));
    for(int i = 1; i <= m_edges.Extent(); ++i)
      add_edge(TopoDS::Edge(m_edges(i).Oriented(TopAbs_FORWARD)));
    Vertex_joiner join_vertices(model(), m_edges, m_vertex_tolerances, same_point * m_result.diagonal,
                                trusted_tolerance * m_result.diagonal);
    m_result.number_of_joined_vertices = join_vertices(m_faces);
    close_narrow_faces(closed_up_width * m_result.diagonal);
    list_inner_elements();
    add_shells(shape);
    orient();
    m_result.shape_vertices.resize(model().vertices().size(), Open_cascade_model_3::none);
    std::iota(m_result.shape_vertices.begin(), m_result.shape_vertices.begin() + m_vertices.Extent(), std::size_t(0));
    return std::move(m_result);
  }

private:
  // Only boxes of unbounded curves and surfaces are larger, in which some coordinates stand for infinity.
  static constexpr double largest_squared_extent = 1e30;
  // A curve is cut where it runs beyond its vertex by more than this share of the diagonal, a hundredth of the minimum edge that
  // mesh_cad takes by default; if it passes the vertex at less than a share of the distance at which it ends; and if more than a
  // share of it is left.
  static constexpr double least_overrun = 1e-5, share_of_overrun = 0.5, least_rest = 0.1;
  // As shares of the diagonal. Vertices closer than the first are one point, whatever their tolerances are; the default precision of
  // Open CASCADE for a shape of size 1. What a file says of its tolerances is believed up to the second, half of the distance that a
  // mesh may have from its shape by default, when edges or vertices are taken for one.
  static constexpr double same_point = 1e-7, trusted_tolerance = 2.5e-4;

  Model& model() { return m_result.model; }

  // A face whose curves in the domain are missing may have an infinite box, which does not count.
  double diagonal() const
  {
    Bnd_Box box;
    for(const TopTools_IndexedMapOfShape* shapes : {&m_edges, &m_faces})
      for(int i = 1; i <= shapes->Extent(); ++i) {
        Bnd_Box part;
        BRepBndLib::Add((*shapes)(i), part, false);
        if(!part.IsVoid() && !part.IsOpen() && part.SquareExtent() < largest_squared_extent)
          box.Add(part);
      }
    if(box.IsVoid() || !(box.SquareExtent() > 0))
      throw Parametric_surface_mesh_error("the shape is empty: none of its faces and edges has a finite size above 0");
    return std::sqrt(box.SquareExtent());
  }

  std::size_t add_vertex(const TopoDS_Vertex& vertex)
  {
    m_vertex_tolerances.push_back(BRep_Tool::Tolerance(vertex));
    return model().add_vertex(to_point<Kernel>(BRep_Tool::Pnt(vertex).XYZ()));
  }

  void add_edge(const TopoDS_Edge& edge)
  {
    Model::Edge result;
    const int source = m_vertices.FindIndex(TopExp::FirstVertex(edge)), target = m_vertices.FindIndex(TopExp::LastVertex(edge));
    result.is_collapsed = source == target && BRep_Tool::Degenerated(edge);
    if(!result.is_collapsed)
      result.curve = guarded([&] { return convert_space_curve<Kernel>(edge); });
    result.tolerance = BRep_Tool::Tolerance(edge);
    if(source > 0 && target > 0) {
      result.source = std::size_t(source - 1);
      result.target = std::size_t(target - 1);
    }
    else
      result.source = result.target = add_vertex_on(result);
    m_ranges.push_back(range_between_vertices(result));
    if(m_ranges.back().length() < 1)
      result.curve = restricted(result.curve, m_ranges.back());
    model().add_edge(std::move(result));
  }

  // The part of an edge between its vertices: less than all of it if its curve runs beyond them. If the curve cannot be evaluated,
  // building a face will report the error.
  Unit_range range_between_vertices(const Model::Edge& edge)
  {
    try {
      return edge.curve ? guarded([&] { return found_range(edge); }) : Unit_range{0, 1};
    }
    catch(const std::exception&) {
      return {0, 1};
    }
  }

  Unit_range found_range(const Model::Edge& edge)
  {
    Unit_range result{0, 1};
    for(double* t : {&result.first, &result.last}) {
      const auto& vertex = model().vertices()[t == &result.first ? edge.source : edge.target];
      const auto squared = [&](double s) { return squared_distance(edge.curve->point(s), vertex); };
      const double near = parameter_near_end(*edge.curve, *t, vertex);
      if(squared(near) < square(share_of_overrun) * squared(*t) && squared(*t) > square(least_overrun * m_result.diagonal))
        *t = near;
    }
    return result.length() > least_rest ? result : Unit_range{0, 1};
  }

  // Adds the vertex of an edge without vertices, which must be a closed curve.
  std::size_t add_vertex_on(const Model::Edge& edge)
  {
    m_vertex_tolerances.push_back(edge.tolerance);
    return model().add_vertex(edge.curve ? edge.curve->point(0) : Model::Point_3(0, 0, 0));
  }

  void close_narrow_faces(double width)
  {
    const Narrow_face_closer closer(model(), m_edges, m_faces, width, trusted_tolerance * m_result.diagonal);
    m_result.closed_up = closer.closed_up();
    for(const auto& face : m_result.closed_up)
      m_closed_up.insert(face.shape_face);
    for(std::size_t v = 0; v < m_vertex_tolerances.size(); ++v)
      move_vertex(v, closer.vertex_place(v));
    for(std::size_t e = 0; e < m_result.number_of_shape_edges; ++e) {
      m_places.push_back(closer.edge_replacement(e));
      m_places.back().range = m_ranges[e];
      move_edge(e, closer);
    }
  }

  void move_vertex(std::size_t v, std::size_t place)
  {
    const double distance = std::sqrt(squared_distance(model().vertices()[v], model().vertices()[place]));
    m_vertex_tolerances[place] = (std::max)(m_vertex_tolerances[place], m_vertex_tolerances[v] + distance);
  }

  // Sets the place of an edge. The tolerance of an edge that replaces others becomes the distance from them.
  void move_edge(std::size_t e, const Narrow_face_closer& closer)
  {
    Model::Edge& edge = model().edges()[e];
    edge.source = closer.vertex_place(edge.source);
    edge.target = closer.vertex_place(edge.target);
    m_result.model_edges.emplace_back();
    for(const auto& piece : m_places[e].pieces) {
      double& tolerance = model().edges()[piece.edge].tolerance;
      tolerance = (std::max)(tolerance, edge.tolerance + piece.match.distance());
      m_result.model_edges.back().push_back(piece.edge);
    }
    if(m_places[e].pieces.empty() && !m_places[e].is_point)
      m_result.model_edges.back().push_back(e);
  }

  void list_inner_elements()
  {
    for(int f = 1; f <= m_faces.Extent(); ++f) {
      TopTools_MapOfShape known; // an edge on the boundary is followed already
      const TopoDS_Shape face = m_faces(f).Oriented(TopAbs_FORWARD);
      for(TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
        if(is_on_boundary(edge.Current()))
          known.Add(edge.Current());
      for(TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
        if(known.Add(edge.Current()))
          m_result.inner_edges.push_back({std::size_t(m_edges.FindIndex(edge.Current())) - 1, std::size_t(f) - 1,
                                          reason_against(edge.Current())});
      for(TopoDS_Iterator vertex(face); vertex.More(); vertex.Next())
        if(vertex.Value().ShapeType() == TopAbs_VERTEX && known.Add(vertex.Value()))
          m_result.inner_vertices.push_back({std::size_t(m_vertices.FindIndex(vertex.Value())) - 1, std::size_t(f) - 1,
                                             reason_against(vertex.Value())});
    }
  }

  static std::string reason_against(const TopoDS_Shape& element)
  {
    return element.Orientation() == TopAbs_EXTERNAL ? "it is marked as outside of the face" : "";
  }

  // Whether an edge, with its orientation in a face, is a part of the boundary.
  static bool is_on_boundary(const TopoDS_Shape& edge)
  {
    return edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED;
  }

  // Sets the shells. A face that two solids share belongs to the shells of both. A solid has the number of its first shell.
  void add_shells(const TopoDS_Shape& shape)
  {
    TopTools_IndexedDataMapOfShapeListOfShape solids_of_shells;
    TopExp::MapShapesAndAncestors(shape, TopAbs_SHELL, TopAbs_SOLID, solids_of_shells);
    TopTools_DataMapOfShapeInteger solids; // the number of the first shell of each
    std::size_t number = 0;
    TopTools_MapOfShape shells;
    for(TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next())
      if(shells.Add(shell.Current())) {
        TopTools_ListOfShape faces;
        for(TopExp_Explorer face(shell.Current(), TopAbs_FACE); face.More(); face.Next())
          faces.Append(face.Current());
        const TopTools_ListOfShape& solids_of_shell = solids_of_shells.FindFromKey(shell.Current());
        std::size_t solid = number;
        if(!solids_of_shell.IsEmpty() && !solids.Bind(solids_of_shell.First(), int(number)))
          solid = std::size_t(solids.Find(solids_of_shell.First()));
        add_shell(faces, number++, solid);
      }
    add_shell(free_faces(shape), number, std::nullopt);
  }

  // The faces outside of shells. One that a shell has, too, is noted, and not meshed again.
  TopTools_ListOfShape free_faces(const TopoDS_Shape& shape)
  {
    TopTools_MapOfShape faces_in_shells, known;
    for(TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next())
      for(TopExp_Explorer face(shell.Current(), TopAbs_FACE); face.More(); face.Next())
        faces_in_shells.Add(face.Current());
    TopTools_ListOfShape result;
    for(TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SHELL); face.More(); face.Next())
      if(known.Add(face.Current())) {
        if(faces_in_shells.Contains(face.Current()))
          m_result.repeated_faces.push_back(std::size_t(m_faces.FindIndex(face.Current())) - 1);
        else
          result.Append(face.Current());
      }
    return result;
  }

  void add_shell(const TopTools_ListOfShape& faces, std::size_t shell, std::optional<std::size_t> solid)
  {
    std::map<int, int> numbers_of_uses; // by edge
    for(const TopoDS_Shape& face : faces) {
      for(TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
        if(is_on_boundary(edge.Current()) && !BRep_Tool::Degenerated(TopoDS::Edge(edge.Current())))
          ++numbers_of_uses[m_edges.FindIndex(edge.Current())];
      if(m_closed_up.count(std::size_t(m_faces.FindIndex(face)) - 1) == 0)
        add_face(TopoDS::Face(face), shell, solid);
    }
    for(const auto& edge : numbers_of_uses)
      m_result.is_shape_closed = m_result.is_shape_closed && edge.second == 2;
  }

  void add_face(const TopoDS_Face& face, std::size_t shell, std::optional<std::size_t> solid)
  {
    const std::size_t number = std::size_t(m_faces.FindIndex(face)) - 1;
    try {
      const auto build = [&] { return Face_builder(m_result, m_edges, m_places, m_vertex_tolerances, face, number)(); };
      Model::Face result = guarded(build);
      result.is_reversed = face.Orientation() == TopAbs_REVERSED;
      result.shell = shell;
      result.solid = solid;
      const auto front = m_fronts.emplace(number, model().faces().size());
      if(!front.second && model().faces()[front.first->second].shell != shell && m_backs.insert(number).second)
        result.other_side_of = front.first->second;
      model().add_face(std::move(result));
      m_result.shape_faces.push_back(number);
    }
    catch(const std::exception& error) {
      if(m_result.left_out.empty() || m_result.left_out.back().shape_face != number)
        m_result.left_out.push_back({number, error.what()});
    }
  }

  // Reverses faces so that neighbours in a shell face to the same side. Pieces in which they do stay as they are: the boundary of a
  // cavity faces inward. Where a shell cannot be oriented, it is open.
  void orient()
  {
    std::vector<bool> before;
    for(const auto& face : model().faces())
      before.push_back(face.is_reversed);
    Face_orientation<Model> orientation(model());
    std::set<std::size_t> turned_edges;
    for(std::size_t f = 0; f < before.size(); ++f)
      if(!orientation.is_done(f)) {
        const auto piece = orientation.orient_piece(f);
        if(piece.is_changed)
          orientation.face_outward(piece);
        for(const auto& contradiction : piece.contradictions)
          turned_edges.insert(contradiction.edge);
      }
    for(std::size_t e : turned_edges)
      model().edges()[e].allows_turned_faces = true;
    for(auto& face : model().faces())
      if(face.other_side_of != Model::no_face && face.is_reversed == model().faces()[face.other_side_of].is_reversed)
        face.other_side_of = Model::no_face; // neither of them is the other side
    m_result.turned_edges.assign(turned_edges.begin(), turned_edges.end());
    for(std::size_t f = 0; f < before.size(); ++f)
      m_result.number_of_reversed_faces += model().faces()[f].is_reversed != before[f];
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_SHAPE_MODEL_BUILDER_H
