// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_CREASE_DIVISION_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_CREASE_DIVISION_H

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Surface.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Edge.hxx>
#include <ShapeUpgrade_FaceDivide.hxx>
#include <ShapeUpgrade_SplitSurface.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_HSequenceOfReal.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The lines of constant `u`, and those of constant `v`, across which the tangent plane of the surface of a face turns.
class Creases_of_face
{
  // In radians, some 11 degrees: an edge across a smaller kink has a deviation ratio, a fourth of this, within the default bound.
  // (Curves that are joined smoothly, like the arcs of a circle, have knots with which they might have a kink, too.)
  static constexpr double smallest_turn = 0.2;
  static constexpr int number_of_samples = 16; // along each line
  static constexpr double step = 1e-6;     // to either side, over the extent of the face in the domain

  GeomAdaptor_Surface m_surface;
  double m_u0 = 0, m_u1 = 0, m_v0 = 0, m_v1 = 0;

public:
  std::vector<double> u, v;

  std::size_t number() const { return u.size() + v.size(); }

  explicit Creases_of_face(const TopoDS_Face& face)
  {
    const auto surface = BRep_Tool::Surface(face);
    BRepTools::UVBounds(face, m_u0, m_u1, m_v0, m_v1);
    if(surface.IsNull() || !(m_u0 < m_u1) || !(m_v0 < m_v1))
      return;
    m_surface.Load(surface, m_u0, m_u1, m_v0, m_v1);
    if(m_surface.NbUIntervals(GeomAbs_C1) > 1)
      for(double x : knots(m_surface.NbUIntervals(GeomAbs_C1), true))
        if(turns_at(x, true))
          u.push_back(x);
    if(m_surface.NbVIntervals(GeomAbs_C1) > 1)
      for(double x : knots(m_surface.NbVIntervals(GeomAbs_C1), false))
        if(turns_at(x, false))
          v.push_back(x);
  }

private:
  std::vector<double> knots(int number_of_intervals, bool is_u) const
  {
    TColStd_Array1OfReal values(1, number_of_intervals + 1);
    is_u ? m_surface.UIntervals(values, GeomAbs_C1) : m_surface.VIntervals(values, GeomAbs_C1);
    std::vector<double> result;
    for(int i = 2; i <= number_of_intervals; ++i)
      result.push_back(values(i));
    return result;
  }

  bool turns_at(double x, bool is_u) const
  {
    const double low = is_u ? m_u0 : m_v0, high = is_u ? m_u1 : m_v1, from = is_u ? m_v0 : m_u0, to = is_u ? m_v1 : m_u1,
                 side = step * (high - low);
    if(!(x - side > low) || !(x + side < high))
      return false;
    for(int i = 0; i < number_of_samples; ++i) {
      const double y = from + (to - from) * (i + 0.5) / number_of_samples;
      const gp_Vec before = is_u ? normal(x - side, y) : normal(y, x - side), after = is_u ? normal(x + side, y) : normal(y, x + side);
      if(before.SquareMagnitude() > 0 && after.SquareMagnitude() > 0 && before.Angle(after) > smallest_turn)
        return true;
    }
    return false;
  }

  gp_Vec normal(double u_, double v_) const
  {
    gp_Pnt p;
    gp_Vec du, dv;
    m_surface.D1(u_, v_, p, du, dv);
    return du.Crossed(dv);
  }
};

// Splits the surface of one face at its creases.
class Split_at_creases : public ShapeUpgrade_SplitSurface
{
  Creases_of_face m_creases;

public:
  explicit Split_at_creases(const Creases_of_face& creases) : m_creases(creases) {}

  void Compute(const Standard_Boolean) override
  {
    insert(m_creases.u, *myUSplitValues);
    insert(m_creases.v, *myVSplitValues);
  }

private:
  static void insert(const std::vector<double>& creases, TColStd_HSequenceOfReal& values)
  {
    for(double x : creases)
      if(x > values.First() && x < values.Last())
        values.InsertBefore(values.Length(), x);
  }
};

// A shape whose faces are divided along their creases, which become edges.
class Crease_division
{
  // A face with more creases, like a terrain of flat tiles, is left as it is.
  static constexpr std::size_t max_number_of_creases = 64;

public:
  static constexpr std::size_t no_index = std::size_t(-1);

private:
  TopoDS_Shape m_shape;
  TopTools_IndexedMapOfShape m_old_faces, m_old_edges, m_old_vertices;
  std::vector<std::size_t> m_faces, m_edges, m_vertices; // of the divided shape: indices in the given one
  bool m_is_divided = false;

public:
  // The given shape is not changed: a copy of it is divided.
  explicit Crease_division(const TopoDS_Shape& shape) : m_shape(shape)
  {
    TopExp::MapShapes(shape, TopAbs_FACE, m_old_faces);
    std::vector<std::pair<int, Creases_of_face>> creases;
    for(int i = 1; i <= m_old_faces.Extent(); ++i) {
      // Where the kernel fails the face stays whole; what is wrong with it is found, and told, when it is built.
      try {
        const Creases_of_face of_face(TopoDS::Face(m_old_faces(i)));
        if(of_face.number() > 0 && of_face.number() <= max_number_of_creases)
          creases.emplace_back(i, of_face);
      }
      catch(const Standard_Failure&) {
      }
    }
    if(creases.empty())
      return;
    const TopoDS_Shape copy = BRepBuilderAPI_Copy(shape, false).Shape(); // with faces and edges in the same order
    m_old_faces.Clear();
    TopExp::MapShapes(copy, TopAbs_FACE, m_old_faces);
    TopExp::MapShapes(copy, TopAbs_EDGE, m_old_edges);
    TopExp::MapShapes(copy, TopAbs_VERTEX, m_old_vertices);
    const Handle(ShapeBuild_ReShape) context = new ShapeBuild_ReShape;
    for(const auto& of_face : creases)
      divide(TopoDS::Face(m_old_faces(of_face.first)), of_face.second, context);
    if(!m_is_divided)
      return;
    m_shape = context->Apply(copy);
    m_faces = origins(m_old_faces, TopAbs_FACE, context);
    m_edges = origins(m_old_edges, TopAbs_EDGE, context);
    m_vertices = origins(m_old_vertices, TopAbs_VERTEX, context);
    correct_parameters();
  }

  bool is_divided() const { return m_is_divided; }
  const TopoDS_Shape& shape() const { return m_shape; }
  std::size_t number_of_old_faces() const { return std::size_t(m_old_faces.Extent()); }
  std::size_t number_of_old_edges() const { return std::size_t(m_old_edges.Extent()); }

  // The index, in the given shape, of the face, edge or vertex that one of the divided shape is, or is a part of. Edges and vertices
  // at creases have none.
  std::size_t old_face(std::size_t face) const { return m_faces[face]; }
  std::size_t old_edge(std::size_t edge) const { return m_edges[edge]; }
  std::size_t old_vertex(std::size_t vertex) const { return m_vertices[vertex]; }

private:
  void divide(const TopoDS_Face& face, const Creases_of_face& creases, const Handle(ShapeBuild_ReShape)& context)
  {
    const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
    try {
      ShapeUpgrade_FaceDivide division(forward);
      division.SetContext(context);
      division.SetSplitSurfaceTool(new Split_at_creases(creases));
      if(division.Perform()) {
        context->Replace(forward, division.Result());
        m_is_divided = true;
      }
    }
    catch(const Standard_Failure&) { // the face stays whole: the crease is crossed by triangles, whose distance is reported
    }
  }

  // Makes the curves of the edges of divided faces have the same parameters, which they are said to have already.
  void correct_parameters() const
  {
    TopTools_IndexedMapOfShape faces, edges;
    TopExp::MapShapes(m_shape, TopAbs_FACE, faces);
    for(int i = 1; i <= faces.Extent(); ++i)
      if(!m_old_faces.Contains(faces(i)))
        TopExp::MapShapes(faces(i), TopAbs_EDGE, edges);
    ShapeFix_Edge fix;
    for(int i = 1; i <= edges.Extent(); ++i)
      if(!BRep_Tool::Degenerated(TopoDS::Edge(edges(i))))
        fix.FixSameParameter(TopoDS::Edge(edges(i)));
  }

  std::vector<std::size_t> origins(const TopTools_IndexedMapOfShape& old, TopAbs_ShapeEnum type,
                                   const Handle(ShapeBuild_ReShape)& context) const
  {
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(m_shape, type, parts);
    std::vector<std::size_t> result(std::size_t(parts.Extent()), no_index);
    for(int i = 1; i <= old.Extent(); ++i) {
      TopTools_IndexedMapOfShape replacements;
      TopExp::MapShapes(context->Apply(old(i)), type, replacements);
      for(int k = 1; k <= replacements.Extent(); ++k)
        if(parts.Contains(replacements(k)))
          result[std::size_t(parts.FindIndex(replacements(k))) - 1] = std::size_t(i) - 1;
    }
    return result;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_CREASE_DIVISION_H
