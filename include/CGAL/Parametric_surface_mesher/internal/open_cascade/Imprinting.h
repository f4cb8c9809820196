// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_IMPRINTING_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_IMPRINTING_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/diagonal_of_shape.h>

#include <BOPAlgo_Splitter.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_NormalProjection.hxx>
#include <BRepTools_History.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <ShapeConstruct_ProjectCurveOnSurface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Puts points and curves on the faces of a shape: they are projected onto the faces close by, and divide these or lie inside them, by
// the splitting operation of Open CASCADE.
class Imprinting
{
public:
  // What has become of a point or a curve.
  struct Result
  {
    double distance = 0;         // the largest one between it and its projection
    double length = 0;           // of a curve
    double projected_length = 0; // of its projection
    std::vector<TopoDS_Shape> tools = {}; // vertices and edges that are put on the faces
    double refused_distance = 0; // of parts of a curve that are too far from the faces
  };

private:
  // A projection counts if it is not behind other faces, as on the back of a plate: the way from it to the curve meets no face. The way
  // begins at the first share of its length, since it meets the face of the projection. The second share is the least distance from faces.
  static constexpr double start_of_way = 0.1, clearance_of_way = 0.01;
  // A projection does not count if the curve is so many times closer to another face. The ratio is above 1, since the place of the curve
  // that is closest to a projected point is not always that of which it is the projection.
  static constexpr double largest_ratio = 2;
  static constexpr int number_of_samples = 8; // of a projected curve
  // The largest distance of a projected curve from its face, as a share of the reach.
  static constexpr double precision_of_projection = 1e-4;
  // Projections of a curve on two faces end close to each other on the edge between these. They are taken to meet if they are closer than
  // the first share of the reach, and than the second one of the diagonal of the shape, so that no tiny piece of the edge is left.
  static constexpr double share_of_reach = 1e-3, share_of_diagonal = 2e-5;
  // What Open CASCADE may approximate a projection by.
  static constexpr int largest_degree = 14, max_number_of_segments = 200;

  TopoDS_Shape m_shape;
  const double m_reach;
  TopoDS_Compound m_faces; // of the shape
  std::vector<TopoDS_Shape> m_tools;
  opencascade::handle<BRepTools_History> m_history;

public:
  // `reach`: the largest distance of a projection
  Imprinting(const TopoDS_Shape& shape, double reach) : m_shape(shape), m_reach(reach)
  {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    BRep_Builder builder;
    builder.MakeCompound(m_faces);
    for(int i = 1; i <= faces.Extent(); ++i)
      builder.Add(m_faces, faces(i));
  }

  // `name`: of the point, for messages
  Result add_point(const gp_Pnt& point, const std::string& name)
  {
    const BRepExtrema_DistShapeShape distance(BRepBuilderAPI_MakeVertex(point).Vertex(), m_faces);
    if(!distance.IsDone() || distance.NbSolution() == 0)
      throw Parametric_surface_mesh_error("the distance of " + name + " from the faces cannot be computed");
    if(!(distance.Value() <= m_reach))
      throw Parametric_surface_mesh_error(name + " is " + describe(distance.Value())
                                          + " away from the faces, and is to be projected by no more than " + describe(m_reach));
    m_tools.push_back(BRepBuilderAPI_MakeVertex(distance.PointOnShape2(1)).Vertex());
    return {distance.Value(), 0, 0, {m_tools.back()}, 0};
  }

  Result add_curve(const TopoDS_Edge& edge, const std::string& name)
  {
    Result result;
    result.length = GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge));
    Bnd_Box box;
    BRepBndLib::Add(edge, box);
    box.Enlarge(m_reach);
    for(TopExp_Explorer face(m_faces, TopAbs_FACE); face.More(); face.Next()) {
      Bnd_Box box_of_face;
      BRepBndLib::Add(face.Current(), box_of_face);
      if(box.IsOut(box_of_face))
        continue;
      TopExp_Explorer part(projection(edge, TopoDS::Face(face.Current())), TopAbs_EDGE);
      if(!part.More())
        part.Init(projection_of_points(edge, TopoDS::Face(face.Current())), TopAbs_EDGE);
      for(; part.More(); part.Next())
        add_part(TopoDS::Edge(part.Current()), edge, result);
    }
    if(!(result.projected_length > 0))
      throw Parametric_surface_mesh_error(
        name
        + (result.refused_distance > 0 ? " is up to " + describe(result.refused_distance) + " away from the faces"
                                       : " has no projection on the faces")
        + ", and is to be projected by no more than " + describe(m_reach));
    return result;
  }

  // Divides the shape by all that was added. The shape is one argument, so that solids that touch in it are not fused.
  void operator()()
  {
    if(m_tools.empty())
      return;
    BOPAlgo_Splitter splitter;
    splitter.AddArgument(m_shape);
    for(const TopoDS_Shape& tool : m_tools)
      splitter.AddTool(tool);
    splitter.SetNonDestructive(true);
    splitter.SetFuzzyValue((std::min)(share_of_reach * m_reach, share_of_diagonal * diagonal_of_shape(m_shape)));
    splitter.Perform();
    if(splitter.HasErrors()) {
      std::ostringstream errors;
      splitter.DumpErrors(errors);
      throw Parametric_surface_mesh_error("points and curves cannot be put on the faces. Open CASCADE: " + errors.str());
    }
    m_shape = splitter.Shape();
    m_history = splitter.History();
  }

  const TopoDS_Shape& shape() const { return m_shape; }
  const opencascade::handle<BRepTools_History>& history() const { return m_history; } // null if nothing was added

  // The vertices and edges of the shape that a point or a curve has become.
  std::vector<TopoDS_Shape> images(const Result& of) const
  {
    TopTools_IndexedMapOfShape elements;
    TopExp::MapShapes(m_shape, TopAbs_VERTEX, elements);
    TopExp::MapShapes(m_shape, TopAbs_EDGE, elements);
    std::vector<TopoDS_Shape> result;
    for(const TopoDS_Shape& tool : of.tools) {
      TopTools_ListOfShape images = m_history->Modified(tool);
      if(images.IsEmpty())
        images.Append(tool);
      for(const TopoDS_Shape& image : images)
        if(elements.Contains(image))
          result.push_back(image);
    }
    return result;
  }

private:
  // The projection of a curve on one face; null if there is none.
  TopoDS_Shape projection(const TopoDS_Edge& edge, const TopoDS_Face& face) const
  {
    try {
      BRepOffsetAPI_NormalProjection project(face);
      project.Add(edge);
      project.SetMaxDistance(m_reach);
      project.SetLimit(true);
      project.SetParams(precision_of_projection * m_reach, precision_of_projection * m_reach, GeomAbs_C2, largest_degree,
                        max_number_of_segments);
      project.Build();
      return project.IsDone() ? project.Projection() : TopoDS_Shape();
    }
    catch(const Standard_Failure&) { // the projection is a point, as that of a radius of a cylinder on its side
      return TopoDS_Shape();
    }
  }

  // The same by an interpolation of projected points, for curves that lie on the face up to rounding: `projection()` misses some of them.
  // Null if the curve is farther away.
  TopoDS_Shape projection_of_points(const TopoDS_Edge& edge, const TopoDS_Face& face) const
  {
    try {
      const BRepExtrema_DistShapeShape distance(edge, face);
      double first = 0, last = 0;
      const opencascade::handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
      if(!distance.IsDone() || distance.Value() > precision_of_projection * m_reach || curve.IsNull())
        return TopoDS_Shape();
      ShapeConstruct_ProjectCurveOnSurface project;
      project.Init(BRep_Tool::Surface(face), Precision::Confusion());
      opencascade::handle<Geom_Curve> copy = curve;
      opencascade::handle<Geom2d_Curve> in_domain;
      if(!project.Perform(copy, first, last, in_domain) || in_domain.IsNull())
        return TopoDS_Shape();
      TopoDS_Edge result = BRepBuilderAPI_MakeEdge(in_domain, BRep_Tool::Surface(face), first, last).Edge();
      BRepLib::BuildCurve3d(result);
      return BRepAlgoAPI_Common(result, face).Shape();
    }
    catch(const Standard_Failure&) {
      return TopoDS_Shape();
    }
  }

  // Whether the way from a projected point to the curve meets no face, and no other face is much closer to the curve there, as on the other
  // side of a solid through which the curve runs.
  bool is_in_front(const gp_Pnt& p, const gp_Pnt& on_curve) const
  {
    const double length = p.Distance(on_curve);
    if(length <= precision_of_projection * m_reach)
      return true;
    const gp_Pnt start(p.XYZ() + start_of_way * (on_curve.XYZ() - p.XYZ()));
    const BRepExtrema_DistShapeShape distance(BRepBuilderAPI_MakeEdge(start, on_curve).Edge(), m_faces);
    const BRepExtrema_DistShapeShape of_curve(BRepBuilderAPI_MakeVertex(on_curve).Vertex(), m_faces);
    return distance.IsDone() && distance.Value() > clearance_of_way * length && of_curve.IsDone()
           && length <= largest_ratio * of_curve.Value() + precision_of_projection * m_reach;
  }

  // Adds a part of a projection if it is close to the curve, and at most of its samples not behind other faces.
  void add_part(const TopoDS_Edge& part, const TopoDS_Edge& curve, Result& result)
  {
    const BRepAdaptor_Curve adaptor(part);
    double largest = 0;
    int number_in_front = 0;
    for(int i = 0; i < number_of_samples; ++i) {
      const double share = (i + 0.5) / number_of_samples;
      const gp_Pnt p = adaptor.Value(adaptor.FirstParameter() + share * (adaptor.LastParameter() - adaptor.FirstParameter()));
      const BRepExtrema_DistShapeShape to_curve(BRepBuilderAPI_MakeVertex(p).Vertex(), curve);
      if(!to_curve.IsDone() || to_curve.NbSolution() == 0)
        return;
      number_in_front += is_in_front(p, to_curve.PointOnShape2(1));
      largest = (std::max)(largest, to_curve.Value());
    }
    if(2 * number_in_front < number_of_samples)
      return;
    if(largest > m_reach) {
      result.refused_distance = (std::max)(result.refused_distance, largest);
      return;
    }
    result.distance = (std::max)(result.distance, largest);
    result.projected_length += GCPnts_AbscissaPoint::Length(adaptor);
    result.tools.push_back(part);
    m_tools.push_back(part);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_IMPRINTING_H
