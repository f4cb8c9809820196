// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_SOLID_FUSING_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_SOLID_FUSING_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/diagonal_of_shape.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <BOPAlgo_Builder.hxx>
#include <BRepBndLib.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <BRepTools_History.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <TopAbs_ShapeEnum.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Makes solids that touch share their faces, by the general fuse operation of Open CASCADE, and tells where they touch, overlap and
// nearly touch.
class Solid_fusing
{
public:
  typedef std::pair<std::size_t, std::size_t> Pair; // of indices of given solids, the smaller one first

private:
  TopTools_IndexedMapOfShape m_solids; // the given ones
  TopoDS_Shape m_shape;
  opencascade::handle<BRepTools_History> m_history;
  TopTools_IndexedMapOfShape m_pieces;             // the solids of the result
  std::vector<std::vector<std::size_t>> m_origins; // by piece: the given solids that it is a part of

public:
  // `fuzzy`: the distance up to which things that do not touch, or overlap, are taken to touch
  Solid_fusing(const TopoDS_Shape& shape, double fuzzy) : m_shape(shape)
  {
    TopExp::MapShapes(shape, TopAbs_SOLID, m_solids);
    TopTools_IndexedMapOfShape arguments;
    for(int i = 1; i <= m_solids.Extent(); ++i)
      arguments.Add(m_solids(i));
    for(TopExp_Explorer shell(shape, TopAbs_SHELL, TopAbs_SOLID); shell.More(); shell.Next())
      arguments.Add(shell.Current());
    for(TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SHELL); face.More(); face.Next())
      arguments.Add(face.Current());
    check_fuzzy(fuzzy);
    if(arguments.Extent() > 1)
      fuse(arguments, fuzzy);
    find_pieces();
  }

  const TopoDS_Shape& shape() const { return m_shape; }

  // null if there was nothing to fuse
  const opencascade::handle<BRepTools_History>& history() const { return m_history; }

  // The areas of the faces that two solids share, with the numbers of these faces.
  std::map<Pair, std::pair<double, std::size_t>> contacts() const
  {
    TopTools_IndexedDataMapOfShapeListOfShape solids_of_faces;
    TopExp::MapShapesAndAncestors(m_shape, TopAbs_FACE, TopAbs_SOLID, solids_of_faces);
    std::map<Pair, std::pair<double, std::size_t>> result;
    for(int f = 1; f <= solids_of_faces.Extent(); ++f) {
      std::set<std::size_t> solids;
      for(const TopoDS_Shape& solid : solids_of_faces(f))
        solids.insert(first_origin(solid));
      if(solids.size() != 2)
        continue;
      auto& contact = result[{*solids.begin(), *solids.rbegin()}];
      GProp_GProps properties;
      BRepGProp::SurfaceProperties(solids_of_faces.FindKey(f), properties);
      contact.first += std::fabs(properties.Mass());
      ++contact.second;
    }
    return result;
  }

  // The volumes that two solids have in common.
  std::map<Pair, double> overlaps() const
  {
    std::map<Pair, double> result;
    for(int i = 1; i <= m_pieces.Extent(); ++i) {
      const auto& origins = m_origins[std::size_t(i) - 1];
      if(origins.size() < 2)
        continue;
      GProp_GProps properties;
      BRepGProp::VolumeProperties(m_pieces(i), properties);
      for(std::size_t a = 0; a < origins.size(); ++a)
        for(std::size_t b = a + 1; b < origins.size(); ++b)
          result[{origins[a], origins[b]}] += std::fabs(properties.Mass());
    }
    return result;
  }

  // The distances of solids that have nothing in common, if they are no more than `reach`.
  std::map<Pair, double> gaps(double reach) const
  {
    const std::set<Pair> touching = touching_solids();
    std::vector<Bnd_Box> boxes;
    for(int i = 1; i <= m_solids.Extent(); ++i) {
      boxes.emplace_back();
      BRepBndLib::Add(m_solids(i), boxes.back());
      boxes.back().Enlarge(reach / 2);
    }
    std::map<Pair, double> result;
    for(std::size_t a = 0; a < boxes.size(); ++a)
      for(std::size_t b = a + 1; b < boxes.size(); ++b) {
        if(boxes[a].IsOut(boxes[b]) || touching.count({a, b}) > 0)
          continue;
        BRepExtrema_DistShapeShape distance(m_solids(int(a) + 1), m_solids(int(b) + 1));
        if(distance.IsDone() && distance.Value() > 0 && distance.Value() <= reach)
          result[{a, b}] = distance.Value();
      }
    return result;
  }

private:
  void check_fuzzy(double fuzzy) const
  {
    const double largest_share = 0.01; // of the diagonal
    const double diagonal = diagonal_of_shape(m_shape);
    if(fuzzy > largest_share * diagonal)
      throw Parametric_surface_mesh_error("the fuzzy distance " + describe(fuzzy)
                                          + " is more than a hundredth of the diagonal of the shape, " + describe(diagonal));
  }

  void fuse(const TopTools_IndexedMapOfShape& arguments, double fuzzy)
  {
    BOPAlgo_Builder builder;
    for(int i = 1; i <= arguments.Extent(); ++i)
      builder.AddArgument(arguments(i));
    builder.SetFuzzyValue(fuzzy);
    builder.SetNonDestructive(true);
    builder.SetUseOBB(true);
    builder.Perform();
    if(builder.HasErrors()) {
      std::ostringstream errors;
      builder.DumpErrors(errors);
      throw Parametric_surface_mesh_error("the solids cannot be fused; a smaller fuzzy distance may help, or a repair of the shape. "
                                          "Open CASCADE: " + errors.str());
    }
    m_shape = builder.Shape();
    m_history = builder.History();
  }

  void find_pieces()
  {
    TopExp::MapShapes(m_shape, TopAbs_SOLID, m_pieces);
    m_origins.resize(std::size_t(m_pieces.Extent()));
    for(int i = 1; i <= m_solids.Extent(); ++i) {
      TopTools_ListOfShape pieces;
      if(!m_history.IsNull())
        pieces = m_history->Modified(m_solids(i));
      if(pieces.IsEmpty())
        pieces.Append(m_solids(i));
      for(const TopoDS_Shape& piece : pieces)
        if(const int number = m_pieces.FindIndex(piece))
          m_origins[std::size_t(number) - 1].push_back(std::size_t(i) - 1);
    }
  }

  // What two solids have in common belongs to the first of them.
  std::size_t first_origin(const TopoDS_Shape& solid) const
  {
    const int number = m_pieces.FindIndex(solid);
    return number > 0 && !m_origins[std::size_t(number) - 1].empty() ? m_origins[std::size_t(number) - 1].front()
                                                                     : std::size_t(-1);
  }

  // Those with a vertex, an edge or a face in common.
  std::set<Pair> touching_solids() const
  {
    std::set<Pair> result;
    TopTools_IndexedDataMapOfShapeListOfShape solids_of_vertices;
    for(TopAbs_ShapeEnum type : {TopAbs_VERTEX, TopAbs_EDGE, TopAbs_FACE})
      TopExp::MapShapesAndAncestors(m_shape, type, TopAbs_SOLID, solids_of_vertices);
    for(int v = 1; v <= solids_of_vertices.Extent(); ++v) {
      std::set<std::size_t> solids;
      for(const TopoDS_Shape& solid : solids_of_vertices(v))
        if(const int number = m_pieces.FindIndex(solid))
          solids.insert(m_origins[std::size_t(number) - 1].begin(), m_origins[std::size_t(number) - 1].end());
      for(auto a = solids.begin(); a != solids.end(); ++a)
        for(auto b = std::next(a); b != solids.end(); ++b)
          result.insert({*a, *b});
    }
    return result;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_SOLID_FUSING_H
