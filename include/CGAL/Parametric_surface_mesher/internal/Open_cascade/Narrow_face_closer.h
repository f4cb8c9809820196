// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_NARROW_FACE_CLOSER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_NARROW_FACE_CLOSER_H

#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/Open_cascade/Edge_match.h>
#include <CGAL/Parametric_surface_mesher/internal/Open_cascade/Kernel_guard.h>

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// What takes the place of an edge of the shape in the model.
struct Edge_place
{
  std::size_t edge;  // of the model
  bool is_point;     // whether it is a vertex instead
  std::optional<Edge_match<Parametric_surface_model_3<Open_cascade_surface_3>::Geom_traits>> match; // unless it is the edge itself
};

// Finds faces that are nowhere wider than a given width, and what becomes of their edges: of the two long ones, one takes
// the place of both, and short ones become a vertex. What cannot be closed up without harm to its neighbours stays.
class Narrow_face_closer
{
  typedef Parametric_surface_model_3<Open_cascade_surface_3> Model;
  typedef Model::Geom_traits Kernel;
  typedef Model::Point_3 Point_3;
  typedef Edge_match<Kernel> Match;

  static const int number_of_samples = 16;

  typedef std::vector<std::size_t> Wire; // edges on the boundary of a face; of a seam twice

  // For each vertex and edge, the one that takes its place.
  struct State
  {
    std::vector<std::size_t> vertices, edges;
    std::vector<std::optional<Match>> matches; // with the edges in their places, of those that are not these themselves
  };

  const Model& m_model;
  const TopTools_IndexedMapOfShape& m_faces;
  double m_width;
  std::vector<bool> m_is_short; // edges, no longer than the width and not a point
  std::vector<std::vector<Wire>> m_wires; // of the faces
  std::vector<bool> m_is_closed_up; // faces
  State m_state;
  std::vector<Open_cascade_model_3::Closed_up_face> m_closed_up;

public:
  // \pre the model has the vertices and the edges of the shape
  Narrow_face_closer(const Model& model, const TopTools_IndexedMapOfShape& edges, const TopTools_IndexedMapOfShape& faces,
                     double width)
    : m_model(model), m_faces(faces), m_width(width), m_is_closed_up(std::size_t(faces.Extent()), false)
  {
    m_state.vertices.resize(model.vertices().size());
    m_state.edges.resize(model.edges().size());
    m_state.matches.resize(model.edges().size());
    std::iota(m_state.vertices.begin(), m_state.vertices.end(), std::size_t(0));
    std::iota(m_state.edges.begin(), m_state.edges.end(), std::size_t(0));
    for(std::size_t e = 0; e < model.edges().size(); ++e)
      m_is_short.push_back(is_short(e));
    for(int f = 1; f <= faces.Extent(); ++f)
      m_wires.push_back(wires_of(faces(f), edges));
    for(const std::size_t number_of_long_edges : {0, 2}) // small faces at the ends of narrow ones first
      for(std::size_t f = 0; f < m_wires.size(); ++f)
        if(long_edges(f).size() == number_of_long_edges)
          close_up(f);
    std::sort(m_closed_up.begin(), m_closed_up.end(), [](const auto& a, const auto& b) { return a.shape_face < b.shape_face; });
  }

  const std::vector<Open_cascade_model_3::Closed_up_face>& closed_up() const { return m_closed_up; }
  std::size_t vertex_place(std::size_t v) const { return m_state.vertices[v]; }

  std::vector<Edge_place> edge_places() const
  {
    std::vector<Edge_place> result;
    for(std::size_t e = 0; e < m_state.edges.size(); ++e)
      result.push_back({m_state.edges[e], is_point(m_state, e), m_state.matches[e]});
    return result;
  }

private:
  static bool is_on_boundary(const TopoDS_Shape& edge)
  {
    return edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED;
  }

  static std::vector<Wire> wires_of(const TopoDS_Shape& face, const TopTools_IndexedMapOfShape& edges)
  {
    std::vector<Wire> result;
    for(TopoDS_Iterator wire(face.Oriented(TopAbs_FORWARD)); wire.More(); wire.Next())
      if(wire.Value().ShapeType() == TopAbs_WIRE) {
        result.emplace_back();
        for(TopoDS_Iterator edge(wire.Value()); edge.More(); edge.Next())
          if(is_on_boundary(edge.Value()))
            result.back().push_back(std::size_t(edges.FindIndex(edge.Value())) - 1);
      }
    return result;
  }

  bool are_close(const Point_3& p, const Point_3& q) const { return squared_distance(p, q) <= square(m_width); }

  bool is_short(std::size_t e) const
  {
    const auto& edge = m_model.edges()[e];
    const Point_3 source = m_model.vertices()[edge.source];
    if(edge.is_collapsed || !edge.curve || edge.source == edge.target || !are_close(source, m_model.vertices()[edge.target]))
      return false;
    for(int i = 1; i < number_of_samples; ++i)
      if(!are_close(source, edge.curve->point(double(i) / number_of_samples)))
        return false;
    return true;
  }

  bool is_point(const State& state, std::size_t e) const
  {
    return m_is_short[e] && state.vertices[m_model.edges()[e].source] == state.vertices[m_model.edges()[e].target];
  }

  // the edges of a face but for those that are short, or a pole
  std::vector<std::size_t> long_edges(std::size_t f) const
  {
    std::vector<std::size_t> result;
    for(const Wire& wire : m_wires[f])
      for(const std::size_t e : wire)
        if(!m_is_short[e] && !m_model.edges()[e].is_collapsed)
          result.push_back(e);
    return result;
  }

  void close_up(std::size_t f)
  {
    State state = m_state;
    double width = 0;
    try {
      m_is_closed_up[f] = merge_short_edges(state, f, width) && merge_long_edges(state, f, width) && is_area_small(f);
      m_is_closed_up[f] = m_is_closed_up[f] && are_neighbors_well(state);
    }
    catch(const std::exception&) { // a curve that cannot be evaluated
      m_is_closed_up[f] = false;
    }
    if(!m_is_closed_up[f])
      return;
    m_state = std::move(state);
    m_closed_up.push_back({f, width});
  }

  bool merge_short_edges(State& state, std::size_t f, double& width) const
  {
    for(const Wire& wire : m_wires[f])
      for(const std::size_t e : wire) {
        const auto& edge = m_model.edges()[e];
        if(m_is_short[e] && !merge_vertices(state, edge.source, edge.target))
          return false;
        if(m_is_short[e])
          width = (std::max)(width, distance(edge.source, edge.target));
      }
    return !m_wires[f].empty();
  }

  double distance(std::size_t v, std::size_t w) const
  {
    return std::sqrt(squared_distance(m_model.vertices()[v], m_model.vertices()[w]));
  }

  // All vertices in one place are as close to it as the width, so that widths do not add up.
  bool merge_vertices(State& state, std::size_t v, std::size_t w) const
  {
    const std::size_t kept = (std::min)(state.vertices[v], state.vertices[w]), other = (std::max)(state.vertices[v], state.vertices[w]);
    for(std::size_t i = 0; i < state.vertices.size() && kept != other; ++i)
      if(state.vertices[i] == other) {
        if(!(distance(i, kept) <= m_width))
          return false;
        state.vertices[i] = kept;
      }
    return true;
  }

  bool merge_long_edges(State& state, std::size_t f, double& width) const
  {
    const std::vector<std::size_t> edges = long_edges(f);
    if(edges.empty())
      return true;
    const std::size_t a = edges[0], b = edges[1];
    const std::optional<Match> match = a != b ? match_of(a, b) : std::nullopt;
    if(!match || !merge_ends(state, a, b, match->is_reversed()))
      return false;
    width = (std::max)(width, match->distance());
    const std::size_t kept = (std::min)(state.edges[a], state.edges[b]), other = (std::max)(state.edges[a], state.edges[b]);
    for(std::size_t e = 0; e < state.edges.size() && kept != other; ++e)
      if(state.edges[e] == other) {
        state.edges[e] = kept;
        state.matches[e] = match_of(kept, e);
        if(!state.matches[e])
          return false;
      }
    return true;
  }

  // how the second edge runs along the first one, if it does
  std::optional<Match> match_of(std::size_t first, std::size_t second) const
  {
    const auto &a = m_model.edges()[first].curve, &b = m_model.edges()[second].curve;
    for(const bool is_reversed : {false, true}) {
      const auto ends_are_close = [&](double t) { return are_close(a->point(t), b->point(is_reversed ? 1 - t : t)); };
      if(!a || !b || !ends_are_close(0) || !ends_are_close(1))
        continue;
      const Match match(a, b, is_reversed);
      if(match.distance() <= m_width)
        return match;
    }
    return std::nullopt;
  }

  bool merge_ends(State& state, std::size_t a, std::size_t b, bool is_reversed) const
  {
    const auto &first = m_model.edges()[a], &second = m_model.edges()[b];
    return merge_vertices(state, first.source, is_reversed ? second.target : second.source)
           && merge_vertices(state, first.target, is_reversed ? second.source : second.target);
  }

  // Two edges side by side bound a narrow face, or all of a closed surface but that.
  bool is_area_small(std::size_t f) const
  {
    return guarded([&] {
      GProp_GProps area, perimeter;
      BRepGProp::SurfaceProperties(m_faces(int(f) + 1), area);
      BRepGProp::LinearProperties(m_faces(int(f) + 1), perimeter);
      return std::fabs(area.Mass()) <= m_width * perimeter.Mass();
    });
  }

  // Whether the boundaries of all faces that are left stay such.
  bool are_neighbors_well(const State& state) const
  {
    for(std::size_t f = 0; f < m_wires.size(); ++f)
      if(!m_is_closed_up[f])
        for(const Wire& wire : m_wires[f])
          if(!is_well(state, wire))
            return false;
    return true;
  }

  bool is_well(const State& state, const Wire& wire) const
  {
    const auto is_point = [&](std::size_t e) { return this->is_point(state, e); };
    if(!wire.empty() && std::all_of(wire.begin(), wire.end(), is_point))
      return false;
    std::map<std::size_t, std::size_t> edges; // those in the place of others, with one of these
    for(const std::size_t e : wire) {
      const auto found = edges.emplace(state.edges[e], e).first;
      if(found->second != e && is_spike(state, wire, e))
        return false;
    }
    return true;
  }

  // Whether a wire with an edge there and back has nothing else at one of its ends.
  bool is_spike(const State& state, const Wire& wire, std::size_t e) const
  {
    for(const std::size_t end : {m_model.edges()[e].source, m_model.edges()[e].target}) {
      const auto is_other_at_end = [&](std::size_t i) {
        const auto& edge = m_model.edges()[i];
        return state.edges[i] != state.edges[e] && !is_point(state, i)
               && (state.vertices[edge.source] == state.vertices[end] || state.vertices[edge.target] == state.vertices[end]);
      };
      if(std::none_of(wire.begin(), wire.end(), is_other_at_end))
        return true;
    }
    return false;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_NARROW_FACE_CLOSER_H
