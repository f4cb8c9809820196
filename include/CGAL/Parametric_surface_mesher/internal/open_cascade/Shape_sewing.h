// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_SHAPE_SEWING_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_SHAPE_SEWING_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepTools_History.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cstddef>
#include <map>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Sews what is open of a shape. Solids and shells that are closed stay as they are: sewn together, those that touch would become one
// shell that bounds nothing. An open solid is sewn for itself, and all faces outside of solids and closed shells are sewn together.
class Shape_sewing
{
  double m_tolerance;
  TopTools_IndexedMapOfShape m_parts; // of the result
  std::size_t m_number_of_sewn_edges = 0, m_number_of_free_edges = 0;
  opencascade::handle<BRepTools_History> m_history = new BRepTools_History();

public:
  Shape_sewing(const TopoDS_Shape& shape, double tolerance) : m_tolerance(tolerance)
  {
    add(shape, TopAbs_SOLID, TopAbs_SHAPE);
    add(shape, TopAbs_SHELL, TopAbs_SOLID);
    TopTools_MapOfShape done;
    for(int i = 1; i <= m_parts.Extent(); ++i)
      for(TopExp_Explorer face(m_parts(i), TopAbs_FACE); face.More(); face.Next())
        done.Add(face.Current());
    TopoDS_Compound rest;
    BRep_Builder builder;
    builder.MakeCompound(rest);
    for(TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SOLID); face.More(); face.Next())
      if(done.Add(face.Current()))
        builder.Add(rest, face.Current());
    if(TopoDS_Iterator(rest).More())
      sew(m_parts.IsEmpty() ? shape : rest);
    if(m_parts.IsEmpty())
      throw Parametric_surface_mesh_error("there is nothing to sew");
  }

  std::size_t number_of_sewn_edges() const { return m_number_of_sewn_edges; }
  std::size_t number_of_free_edges() const { return m_number_of_free_edges; }

  const opencascade::handle<BRepTools_History>& history() const { return m_history; }

  TopoDS_Shape shape() const
  {
    if(m_parts.Extent() == 1)
      return m_parts(1);
    TopoDS_Compound result;
    BRep_Builder builder;
    builder.MakeCompound(result);
    for(int i = 1; i <= m_parts.Extent(); ++i)
      builder.Add(result, m_parts(i));
    return result;
  }

private:
  // Adds the solids, and sews those that are open; or adds the closed shells outside of solids.
  void add(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind, TopAbs_ShapeEnum avoided)
  {
    for(TopExp_Explorer part(shape, kind, avoided); part.More(); part.Next())
      if(is_closed(part.Current()))
        m_parts.Add(part.Current());
      else if(kind == TopAbs_SOLID)
        sew(part.Current());
  }

  // Whether each edge has two uses.
  static bool is_closed(const TopoDS_Shape& part)
  {
    TopTools_IndexedMapOfShape edges;
    std::map<int, int> uses;
    for(TopExp_Explorer face(part, TopAbs_FACE); face.More(); face.Next())
      for(TopExp_Explorer edge(face.Current(), TopAbs_EDGE); edge.More(); edge.Next()) {
        const TopAbs_Orientation orientation = edge.Current().Orientation();
        if((orientation == TopAbs_FORWARD || orientation == TopAbs_REVERSED) && !BRep_Tool::Degenerated(TopoDS::Edge(edge.Current())))
          ++uses[edges.Add(edge.Current())];
      }
    return std::all_of(uses.begin(), uses.end(), [](const auto& use) { return use.second == 2; });
  }

  void sew(const TopoDS_Shape& part)
  {
    BRepBuilderAPI_Sewing sewing(m_tolerance);
    sewing.Add(part);
    sewing.Perform();
    if(sewing.SewedShape().IsNull())
      return;
    m_parts.Add(sewing.SewedShape());
    m_history->Merge(sewing.GetContext()->History());
    m_number_of_sewn_edges += std::size_t(sewing.NbContigousEdges());
    m_number_of_free_edges += std::size_t(sewing.NbFreeEdges());
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_SHAPE_SEWING_H
