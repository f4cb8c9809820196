// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_SHAPE_TRIANGULATOR_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_SHAPE_TRIANGULATOR_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_mesh_parameters.h>
#include <CGAL/Parametric_surface_mesher/Model_places.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Face_triangulation.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Sphere_parameters.h>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_TShape.hxx>
#include <TopoDS_Vertex.hxx>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Writes the mesh of a shape onto the shape: for each face its triangles, for each edge of a face the nodes along it.
Faces that are the same but for their places have one triangulation in Open CASCADE: that of the first one.
*/
template <class TriangleMesh, class NamedParameters>
class Shape_triangulator
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  // A piece of an edge beside a triangle of a face, in the direction of growing parameters.
  struct Piece
  {
    int from, to;         // nodes
    double begin, end;    // parameters of the edge of the model
    bool is_along_loop;   // whether the triangle has it in this direction
  };

  // Nodes along an edge of the shape, from its beginning to its end, with the parameters of its curve.
  struct Chain
  {
    std::vector<int> nodes;
    std::vector<double> parameters;
  };

  typedef std::map<std::size_t, std::vector<Piece>> Pieces; // by edge of the shape

  const Open_cascade_model_3& m_shape;
  const TriangleMesh& m_tm;
  const NamedParameters& m_np;
  TopTools_IndexedMapOfShape m_faces, m_edges, m_vertices;
  std::vector<std::vector<std::size_t>> m_shape_edges; // by edge of the model: where faces are closed up, one is several of the shape
  std::vector<std::vector<face_descriptor>> m_triangles; // by face of the shape
  std::map<std::size_t, std::vector<vertex_descriptor>> m_vertices_at; // of the mesh, by vertex of the shape
  std::size_t m_number_of_faces = 0, m_number_of_bare_edges = 0;

public:
  Shape_triangulator(const Open_cascade_model_3& model, const TriangleMesh& tm, const NamedParameters& np, const TopoDS_Shape& shape)
    : m_shape(model), m_tm(tm), m_np(np), m_shape_edges(model.model.edges().size())
  {
    TopExp::MapShapes(shape, TopAbs_FACE, m_faces);
    TopExp::MapShapes(shape, TopAbs_EDGE, m_edges);
    TopExp::MapShapes(shape, TopAbs_VERTEX, m_vertices);
    for(std::size_t e = 0; e < model.model_edges.size(); ++e)
      if(model.model_edges[e].size() == 1)
        m_shape_edges[model.model_edges[e].front()].push_back(e);
    collect_triangles();
    collect_vertices();
  }

  // The number of faces with triangles, and of edges beside them that the mesh does not follow.
  std::pair<std::size_t, std::size_t> operator()()
  {
    std::set<const TopoDS_TShape*> done;
    for(std::size_t f = 0; f < m_triangles.size(); ++f) {
      const TopoDS_Face& face = TopoDS::Face(m_faces(int(f) + 1));
      if(done.insert(face.TShape().get()).second)
        triangulate(f, face);
    }
    return {m_number_of_faces, m_number_of_bare_edges};
  }

private:
  template <class Tag>
  auto map(Tag tag) const
  {
    return parameters::get_parameter(m_np, tag);
  }

  std::size_t patch(face_descriptor f) const { return get(map(Face_patch_id_map_t()), f); }

  // Of a face that two shells have, the triangles of the first shell count.
  void collect_triangles()
  {
    m_triangles.resize(std::size_t(m_faces.Extent()));
    std::vector<std::optional<std::size_t>> shells(m_triangles.size());
    for(std::size_t f = 0; f < m_shape.shape_faces.size(); ++f)
      if(!shells[m_shape.shape_faces[f]])
        shells[m_shape.shape_faces[f]] = m_shape.model.faces()[f].shell;
    for(const face_descriptor f : faces(m_tm)) {
      const std::size_t face = m_shape.shape_faces[patch(f)];
      if(m_shape.model.faces()[patch(f)].shell == *shells[face])
        m_triangles[face].push_back(f);
    }
  }

  void collect_vertices()
  {
    for(const vertex_descriptor v : vertices(m_tm)) {
      const Parametric_surface_mesher::Vertex_place place = get(map(Vertex_place_map_t()), v);
      if(place.dimension == 0 && place.index < m_shape.shape_vertices.size()
         && m_shape.shape_vertices[place.index] != Open_cascade_model_3::none)
        m_vertices_at[m_shape.shape_vertices[place.index]].push_back(v);
    }
  }

  gp_Pnt point(vertex_descriptor v) const
  {
    const auto points = parameters::choose_parameter(parameters::get_parameter(m_np, internal_np::vertex_point),
                                                     get_const_property_map(vertex_point, m_tm));
    const auto& p = get(points, v);
    return gp_Pnt(p.x(), p.y(), p.z());
  }

  void triangulate(std::size_t f, const TopoDS_Face& face)
  {
    Face_triangulation<vertex_descriptor> triangulation;
    Pieces pieces;
    std::optional<Sphere_parameters> sphere;
    double squared_distance = 0;
    for(const face_descriptor triangle : m_triangles[f]) {
      const auto& model_face = m_shape.model.faces()[patch(triangle)];
      if(!sphere && model_face.surface.is_reparametrized())
        sphere.emplace(face);
      add(triangle, model_face, sphere, triangulation, pieces);
      squared_distance = (std::max)(squared_distance, squared_distance_from(triangle, model_face.surface));
    }
    if(triangulation.is_empty())
      return;
    ++m_number_of_faces;
    const auto finished = triangulation.finished(face.Location().Transformation(), std::sqrt(squared_distance));
    BRep_Builder().UpdateFace(face, finished);
    add_polygons(face, triangulation, pieces, finished);
  }

  template <class Model_face>
  void add(face_descriptor triangle, const Model_face& model_face, const std::optional<Sphere_parameters>& sphere,
           Face_triangulation<vertex_descriptor>& triangulation, Pieces& pieces) const
  {
    std::array<halfedge_descriptor, 3> sides; // each ends in the corner of its index
    std::array<gp_Pnt, 3> points;
    std::array<gp_Pnt2d, 3> uv;
    std::size_t i = 0;
    for(const halfedge_descriptor h : halfedges_around_face(halfedge(triangle, m_tm), m_tm)) {
      sides[i] = h;
      points[i] = point(target(h, m_tm));
      const auto p = get(map(Halfedge_uv_map_t()), h);
      uv[i++] = gp_Pnt2d(p.x(), p.y());
    }
    if(sphere)
      uv = (*sphere)(points);
    std::array<int, 3> nodes;
    for(i = 0; i < 3; ++i)
      nodes[i] = triangulation.node(target(sides[i], m_tm), points[i], uv[i]);
    for(i = 0; i < 3; ++i)
      add_piece(sides[i], nodes[(i + 2) % 3], nodes[i], pieces);
    if(model_face.is_reversed) // the triangles face outward, those of Open CASCADE to the side of the surface
      std::swap(nodes[1], nodes[2]);
    triangulation.add_triangle(nodes);
  }

  // The direction comes from the places of the ends: a halfedge of an edge need not be the one that the edge was asked for.
  void add_piece(halfedge_descriptor h, int from, int to, Pieces& pieces) const
  {
    const Parametric_surface_mesher::Edge_place place = get(map(Edge_place_map_t()), edge(h, m_tm));
    if(place.index == Parametric_surface_mesher::Edge_place::none)
      return;
    const auto& curve = m_shape.model.edges()[place.index].curve;
    const auto ends = std::minmax(place.parameters[0], place.parameters[1]);
    if(!curve || !(ends.first < ends.second)) // parameters that are not known are not numbers
      return;
    const gp_Pnt first = point(source(h, m_tm)), last = point(target(h, m_tm));
    const auto distance = [&](const gp_Pnt& p, double t) {
      const auto q = curve->point(t);
      return p.Distance(gp_Pnt(q.x(), q.y(), q.z()));
    };
    const bool is_along_loop
      = distance(first, ends.first) + distance(last, ends.second) <= distance(first, ends.second) + distance(last, ends.first);
    for(const std::size_t e : m_shape_edges[place.index])
      pieces[e].push_back({is_along_loop ? from : to, is_along_loop ? to : from, ends.first, ends.second, is_along_loop});
  }

  // The largest distance of points of the surface over the middles of the sides and the centroid from the plane of the triangle.
  double squared_distance_from(face_descriptor triangle, const Open_cascade_surface_3& surface) const
  {
    std::array<gp_XY, 3> uv;
    std::array<gp_XYZ, 3> points;
    std::size_t i = 0;
    for(const halfedge_descriptor h : halfedges_around_face(halfedge(triangle, m_tm), m_tm)) {
      const auto p = get(map(Halfedge_uv_map_t()), h);
      uv[i] = gp_XY(p.x(), p.y());
      points[i++] = point(target(h, m_tm)).XYZ();
    }
    const gp_XYZ normal = (points[1] - points[0]) ^ (points[2] - points[0]);
    double result = 0;
    for(const std::array<double, 3>& w : {std::array<double, 3>{0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {1. / 3, 1. / 3, 1. / 3}}) {
      const gp_XY q = w[0] * uv[0] + w[1] * uv[1] + w[2] * uv[2];
      const auto p = surface.point(q.X(), q.Y());
      const double height = (gp_XYZ(p.x(), p.y(), p.z()) - points[0]) * normal;
      if(normal.SquareModulus() > 0)
        result = (std::max)(result, height * height / normal.SquareModulus());
    }
    return result;
  }

  void add_polygons(const TopoDS_Face& face, const Face_triangulation<vertex_descriptor>& triangulation, const Pieces& pieces,
                    const Handle(Poly_Triangulation)& finished)
  {
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE, edges);
    for(int i = 1; i <= edges.Extent(); ++i) {
      const TopoDS_Edge edge = TopoDS::Edge(edges(i).Oriented(TopAbs_FORWARD));
      const auto found = pieces.find(std::size_t(m_edges.FindIndex(edge)) - 1);
      std::vector<Chain> chains;
      if(found != pieces.end())
        for(const bool is_along_loop : {true, false})
          if(std::optional<Chain> chain = chain_of(found->second, is_along_loop, edge))
            chains.push_back(std::move(*chain));
      if(chains.empty())
        if(std::optional<Chain> chain = chain_at_vertex(edge, face, triangulation))
          chains.push_back(std::move(*chain));
      m_number_of_bare_edges += chains.empty();
      if(!chains.empty())
        add_polygon(edge, face, triangulation, std::move(chains), finished);
    }
  }

  // The pieces in one direction of the loop, one after the other; none if there is a gap between two of them.
  static std::optional<Chain> chain_of(std::vector<Piece> pieces, bool is_along_loop, const TopoDS_Edge& edge)
  {
    const auto is_on_other_side = [=](const Piece& p) { return p.is_along_loop != is_along_loop; };
    pieces.erase(std::remove_if(pieces.begin(), pieces.end(), is_on_other_side), pieces.end());
    std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.begin < b.begin; });
    if(pieces.empty())
      return std::nullopt;
    double first = 0, last = 0;
    BRep_Tool::Range(edge, first, last);
    const auto parameter = [=](double t) { return first + t * (last - first); };
    Chain result{{pieces.front().from}, {parameter(pieces.front().begin)}};
    for(const Piece& piece : pieces) {
      if(piece.from != result.nodes.back())
        return std::nullopt;
      result.nodes.push_back(piece.to);
      result.parameters.push_back(parameter(piece.end));
    }
    return result;
  }

  // Of an edge that is a point of the mesh, at a pole or because it is short: all nodes there, in the order of the curve in the domain.
  std::optional<Chain> chain_at_vertex(const TopoDS_Edge& edge, const TopoDS_Face& face,
                                       const Face_triangulation<vertex_descriptor>& triangulation) const
  {
    const TopoDS_Vertex first_vertex = TopExp::FirstVertex(edge), last_vertex = TopExp::LastVertex(edge);
    double first = 0, last = 0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if(first_vertex.IsNull() || curve.IsNull() || !(BRep_Tool::Degenerated(edge) || is_point(edge)))
      return std::nullopt;
    std::vector<int> nodes;
    for(const TopoDS_Vertex& vertex : {first_vertex, last_vertex}) {
      const auto found = m_vertices_at.find(std::size_t(m_vertices.FindIndex(vertex)) - 1);
      if(nodes.empty() && found != m_vertices_at.end())
        for(const vertex_descriptor v : found->second)
          for(const int node : triangulation.nodes_of(v))
            nodes.push_back(node);
    }
    if(nodes.empty())
      return std::nullopt;
    const gp_Pnt2d begin = curve->Value(first);
    const gp_Vec2d direction(begin, curve->Value(last));
    const auto place = [&](int node) { return gp_Vec2d(begin, triangulation.uv(node)) * direction; };
    std::sort(nodes.begin(), nodes.end(), [&](int a, int b) { return place(a) < place(b); });
    if(nodes.size() == 1)
      nodes.push_back(nodes.front());
    Chain result{nodes, {}};
    for(std::size_t i = 0; i < nodes.size(); ++i)
      result.parameters.push_back(first + (last - first) * double(i) / double(nodes.size() - 1));
    return result;
  }

  bool is_point(const TopoDS_Edge& edge) const
  {
    const std::size_t e = std::size_t(m_edges.FindIndex(edge)) - 1;
    return e < m_shape.model_edges.size() && m_shape.model_edges[e].empty();
  }

  // Turns the chain of an edge that has another one in its place, which may run in the other direction.
  static void turn(Chain& chain, const TopoDS_Edge& edge, const TopoDS_Face& face,
                   const Face_triangulation<vertex_descriptor>& triangulation)
  {
    double first = 0, last = 0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if(curve.IsNull() || chain.nodes.front() == chain.nodes.back())
      return;
    const gp_Pnt2d begin = curve->Value(first), end = curve->Value(last);
    const gp_Pnt2d a = triangulation.uv(chain.nodes.front()), b = triangulation.uv(chain.nodes.back());
    if(a.Distance(begin) + b.Distance(end) <= a.Distance(end) + b.Distance(begin))
      return;
    std::reverse(chain.nodes.begin(), chain.nodes.end());
    std::reverse(chain.parameters.begin(), chain.parameters.end());
    for(double& parameter : chain.parameters)
      parameter = first + last - parameter;
  }

  // A closed face has an edge twice: first the chain beside the curve of the edge in its own direction.
  static void add_polygon(const TopoDS_Edge& edge, const TopoDS_Face& face, const Face_triangulation<vertex_descriptor>& triangulation,
                          std::vector<Chain> chains, const Handle(Poly_Triangulation)& finished)
  {
    const auto polygon = [&](const Chain& chain) {
      TColStd_Array1OfInteger nodes(1, int(chain.nodes.size()));
      TColStd_Array1OfReal parameters(1, int(chain.nodes.size()));
      for(std::size_t i = 0; i < chain.nodes.size(); ++i) {
        nodes(int(i) + 1) = chain.nodes[i];
        parameters(int(i) + 1) = chain.parameters[i];
      }
      Handle(Poly_PolygonOnTriangulation) result = new Poly_PolygonOnTriangulation(nodes, parameters);
      result->Deflection(finished->Deflection());
      return result;
    };
    if(chains.size() == 2 && BRep_Tool::IsClosed(edge, face)) {
      double first = 0, last = 0;
      const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
      const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, forward, first, last);
      const auto distance = [&](const Chain& chain) {
        return triangulation.uv(chain.nodes.front()).Distance(curve->Value(first))
               + triangulation.uv(chain.nodes.back()).Distance(curve->Value(last));
      };
      if(distance(chains[1]) < distance(chains[0]))
        std::swap(chains[0], chains[1]);
      BRep_Builder().UpdateEdge(edge, polygon(chains[0]), polygon(chains[1]), finished, face.Location());
    }
    else {
      turn(chains[0], edge, TopoDS::Face(face.Oriented(TopAbs_FORWARD)), triangulation);
      BRep_Builder().UpdateEdge(edge, polygon(chains[0]), finished, face.Location());
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_SHAPE_TRIANGULATOR_H
