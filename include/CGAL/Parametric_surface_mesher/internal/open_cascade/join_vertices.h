// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_JOIN_VERTICES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_JOIN_VERTICES_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Open_cascade_surface_3.h>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Joins vertices of a model that a file has twice: where a wire ends at one vertex and begins at another one, and both are the same
// point within their tolerances.
class Vertex_joiner
{
  typedef Parametric_surface_model_3<Open_cascade_surface_3> Model;

  Model& m_model;
  const TopTools_IndexedMapOfShape& m_edges;
  std::vector<double>& m_tolerances; // of the vertices
  double m_least_tolerance, m_trusted_tolerance;
  std::size_t m_number_of_joined = 0;

public:
  // Vertices are joined if they are as close as the sum of their tolerances, but at least the first of the given ones, and at most
  // the second.
  Vertex_joiner(Model& model, const TopTools_IndexedMapOfShape& edges, std::vector<double>& tolerances, double least_tolerance,
                double trusted_tolerance)
    : m_model(model), m_edges(edges), m_tolerances(tolerances), m_least_tolerance(least_tolerance),
      m_trusted_tolerance(trusted_tolerance)
  {}

  // Returns the number of vertices that were joined to another one.
  std::size_t operator()(const TopTools_IndexedMapOfShape& faces)
  {
    for(int f = 1; f <= faces.Extent(); ++f)
      for(TopoDS_Iterator wire(faces(f)); wire.More(); wire.Next())
        if(wire.Value().ShapeType() == TopAbs_WIRE)
          join_ends_of(wire.Value());
    return m_number_of_joined;
  }

private:
  // For each vertex of a wire, how many more edges end there than begin.
  std::map<std::size_t, int> surplus_of_ends(const TopoDS_Shape& wire) const
  {
    std::map<std::size_t, int> result;
    for(TopoDS_Iterator edge(wire); edge.More(); edge.Next()) {
      const TopAbs_Orientation orientation = edge.Value().Orientation();
      if(orientation != TopAbs_FORWARD && orientation != TopAbs_REVERSED)
        continue;
      const auto& e = m_model.edges()[std::size_t(m_edges.FindIndex(edge.Value())) - 1];
      const int sign = orientation == TopAbs_FORWARD ? 1 : -1;
      result[e.source] -= sign;
      result[e.target] += sign;
    }
    return result;
  }

  void join_ends_of(const TopoDS_Shape& wire)
  {
    for(std::map<std::size_t, int> surplus = surplus_of_ends(wire);; surplus = surplus_of_ends(wire)) {
      std::size_t end = 0, begin = 0;
      double least = 1;
      for(const auto& v : surplus)
        for(const auto& w : surplus)
          if(v.second > 0 && w.second < 0 && share_of_tolerance(v.first, w.first) < least) {
            least = share_of_tolerance(v.first, w.first);
            end = v.first;
            begin = w.first;
          }
      if(!(least < 1))
        return;
      join((std::min)(end, begin), (std::max)(end, begin));
    }
  }

  double distance(std::size_t v, std::size_t w) const
  {
    return std::sqrt(squared_distance(m_model.vertices()[v], m_model.vertices()[w]));
  }

  // The distance of two vertices over what it may be.
  double share_of_tolerance(std::size_t v, std::size_t w) const
  {
    return distance(v, w) / (std::max)(m_least_tolerance, (std::min)(m_tolerances[v] + m_tolerances[w], m_trusted_tolerance));
  }

  void join(std::size_t kept, std::size_t other)
  {
    m_tolerances[kept] = (std::max)(m_tolerances[kept], m_tolerances[other] + distance(kept, other));
    for(auto& edge : m_model.edges()) {
      edge.source = edge.source == other ? kept : edge.source;
      edge.target = edge.target == other ? kept : edge.target;
    }
    ++m_number_of_joined;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_JOIN_VERTICES_H
