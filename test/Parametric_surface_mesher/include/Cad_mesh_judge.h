// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares a mesh with the shape that it stands for, as a stranger would: by Open CASCADE, and without anything of this
// package.
#ifndef CAD_MESH_JUDGE_H
#define CAD_MESH_JUDGE_H

#include <Aabb_tree_types.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

// A mesh with the faces of the shape, from 1, that its triangles lie on, and those that it names as too narrow to have any, or to
// have them everywhere.
struct Judged_mesh
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> face_ids;
  std::vector<std::size_t> closed_up_faces;
  std::vector<std::size_t> thinned_faces; // points of these may be close to triangles of other faces instead
  double closed_up_width = 1e-6;          // over the diagonal: what such faces may have as their area over their perimeter
};

struct Cad_mesh_verdict
{
  std::vector<std::size_t> uncovered_faces; // from 1: without triangles and not closed up rightly, or with points far away
  std::size_t border_edges = 0, nonmanifold_edges = 0, repeated_vertices = 0;
  std::size_t misoriented_triangles = 0; // against the side of the face, of those looked at
  double deviation = 0;   // from points of faces and edges to the triangles of the face, over the diagonal
  double farthest_centroid = 0; // from the surface of its face, over the diagonal
  bool is_shape_closed = true;

  bool is_closed() const { return border_edges == 0 && nonmanifold_edges == 0; }

  // "ok", or what is wrong
  std::string text() const
  {
    std::string result;
    if(!uncovered_faces.empty())
      result += "uncov" + std::to_string(uncovered_faces.size()) + " ";
    if((is_shape_closed && border_edges > 0) || nonmanifold_edges > 0 || repeated_vertices > 0)
      result += "open(b" + std::to_string(border_edges) + ",nm" + std::to_string(nonmanifold_edges) + ",rep"
                + std::to_string(repeated_vertices) + ") ";
    if(!is_shape_closed && border_edges == 0)
      result += "closed ";
    if(misoriented_triangles > 0)
      result += "flipped" + std::to_string(misoriented_triangles) + " ";
    if(!(farthest_centroid < 0.02))
      result += "off ";
    return result.empty() ? "ok" : result.substr(0, result.size() - 1);
  }
};

class Cad_mesh_judge
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Kernel::Point_3 Point_3;
  typedef std::vector<Kernel::Triangle_3> Triangles;
  typedef Aabb_tree<Kernel, Aabb_triangle_primitive<Kernel, Triangles::const_iterator>> Tree;

  static const int samples_in_u = 12, samples_on_edge = 24;
  static const std::size_t triangles_looked_at = 300; // of a face
  static constexpr double too_far = 0.01;             // over the diagonal

  const Judged_mesh& m_mesh;
  TopTools_IndexedMapOfShape m_faces;
  std::vector<std::vector<std::size_t>> m_triangles; // of the faces
  std::vector<int> m_numbers_of_shells;              // of the faces
  double m_diagonal = 0;
  Cad_mesh_verdict m_verdict;

public:
  Cad_mesh_judge(const TopoDS_Shape& shape, const Judged_mesh& mesh) : m_mesh(mesh)
  {
    TopExp::MapShapes(shape, TopAbs_FACE, m_faces);
    m_triangles.resize(std::size_t(m_faces.Extent()));
    for(std::size_t t = 0; t < mesh.triangles.size(); ++t)
      m_triangles.at(mesh.face_ids.at(t) - 1).push_back(t);
    Bnd_Box box;
    BRepBndLib::Add(shape, box, false);
    m_diagonal = std::sqrt(box.SquareExtent());
    look_at_shells(shape);
  }

  Cad_mesh_verdict operator()()
  {
    judge_edges();
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
      judge_face(f, TopoDS::Face(m_faces(int(f) + 1)));
    return m_verdict;
  }

private:
  // Faces outside of shells count as one shell.
  void look_at_shells(const TopoDS_Shape& shape)
  {
    m_numbers_of_shells.assign(m_triangles.size(), 0);
    TopTools_IndexedMapOfShape shells;
    for(TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next())
      if(shells.FindIndex(shell.Current()) == 0) {
        shells.Add(shell.Current());
        look_at_faces(TopExp_Explorer(shell.Current(), TopAbs_FACE));
      }
    look_at_faces(TopExp_Explorer(shape, TopAbs_FACE, TopAbs_SHELL));
  }

  void look_at_faces(TopExp_Explorer face)
  {
    TopTools_IndexedMapOfShape edges;
    std::vector<int> uses;
    for(; face.More(); face.Next()) {
      ++m_numbers_of_shells[std::size_t(m_faces.FindIndex(face.Current())) - 1];
      for(TopExp_Explorer edge(face.Current(), TopAbs_EDGE); edge.More(); edge.Next())
        if(!BRep_Tool::Degenerated(TopoDS::Edge(edge.Current()))) {
          const std::size_t i = std::size_t(edges.Add(edge.Current())) - 1;
          uses.resize((std::max)(uses.size(), i + 1), 0);
          ++uses[i];
        }
    }
    for(const int n : uses)
      m_verdict.is_shape_closed = m_verdict.is_shape_closed && n == 2;
  }

  // Each edge of a closed mesh is run through once in either direction.
  void judge_edges()
  {
    std::map<std::pair<std::size_t, std::size_t>, int> uses;
    for(const auto& t : m_mesh.triangles) {
      m_verdict.repeated_vertices += t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
      for(std::size_t k = 0; k < 3; ++k)
        ++uses[{t[k], t[(k + 1) % 3]}];
    }
    for(const auto& use : uses) {
      const auto opposite = uses.find({use.first.second, use.first.first});
      m_verdict.border_edges += opposite == uses.end();
      m_verdict.nonmanifold_edges += use.second > 1;
    }
  }

  Point_3 point(std::size_t i) const { return Point_3(m_mesh.points[i][0], m_mesh.points[i][1], m_mesh.points[i][2]); }

  Kernel::Triangle_3 triangle(std::size_t t) const
  {
    return Kernel::Triangle_3(point(m_mesh.triangles[t][0]), point(m_mesh.triangles[t][1]), point(m_mesh.triangles[t][2]));
  }

  void judge_face(std::size_t f, const TopoDS_Face& face)
  {
    Triangles triangles;
    for(const std::size_t t : m_triangles[f])
      triangles.push_back(triangle(t));
    const bool is_closed_up
      = std::find(m_mesh.closed_up_faces.begin(), m_mesh.closed_up_faces.end(), f + 1) != m_mesh.closed_up_faces.end();
    if(triangles.empty() != is_closed_up || (is_closed_up && !is_narrow(face))) {
      m_verdict.uncovered_faces.push_back(f + 1);
      return;
    }
    const bool is_thinned = std::find(m_mesh.thinned_faces.begin(), m_mesh.thinned_faces.end(), f + 1) != m_mesh.thinned_faces.end();
    const Triangles candidates = is_closed_up || is_thinned ? all_triangles() : triangles;
    const Tree tree(candidates.begin(), candidates.end());
    double farthest = 0;
    for(const gp_Pnt& p : samples(face))
      farthest = (std::max)(farthest, std::sqrt(tree.squared_distance(Point_3(p.X(), p.Y(), p.Z()))));
    m_verdict.deviation = (std::max)(m_verdict.deviation, farthest / m_diagonal);
    if(farthest > too_far * m_diagonal)
      m_verdict.uncovered_faces.push_back(f + 1);
    if(!is_closed_up)
      judge_triangles(f, face, triangles);
  }

  bool is_narrow(const TopoDS_Face& face) const
  {
    GProp_GProps area, perimeter;
    BRepGProp::SurfaceProperties(face, area);
    BRepGProp::LinearProperties(face, perimeter);
    return std::fabs(area.Mass()) <= m_mesh.closed_up_width * m_diagonal * perimeter.Mass();
  }

  Triangles all_triangles() const
  {
    Triangles result;
    for(std::size_t t = 0; t < m_mesh.triangles.size(); ++t)
      result.push_back(triangle(t));
    return result;
  }

  // points inside the face and on its edges
  static std::vector<gp_Pnt> samples(const TopoDS_Face& face)
  {
    std::vector<gp_Pnt> result;
    for(TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(e.Current());
      if(BRep_Tool::Degenerated(edge))
        continue;
      const BRepAdaptor_Curve curve(edge);
      for(int i = 0; i <= samples_on_edge; ++i)
        result.push_back(curve.Value(curve.FirstParameter() + (curve.LastParameter() - curve.FirstParameter()) * i / samples_on_edge));
    }
    const BRepAdaptor_Surface surface(face);
    BRepTopAdaptor_FClass2d classifier(face, BRep_Tool::Tolerance(face));
    double u0, u1, v0, v1;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    for(int i = 0; i < samples_in_u; ++i)
      for(int k = 0; k < samples_in_u; ++k) {
        const double u = u0 + (u1 - u0) * (i + 0.5) / samples_in_u, v = v0 + (v1 - v0) * (k + 0.5) / samples_in_u;
        if(classifier.Perform(gp_Pnt2d(u, v)) == TopAbs_IN)
          result.push_back(surface.Value(u, v));
      }
    return result;
  }

  // Triangles lie on the surface and face as the face does. One between two solids faces to either side.
  void judge_triangles(std::size_t f, const TopoDS_Face& face, const Triangles& triangles)
  {
    const Handle(ShapeAnalysis_Surface) surface = new ShapeAnalysis_Surface(BRep_Tool::Surface(face));
    const std::size_t step = (std::max)(std::size_t(1), triangles.size() / triangles_looked_at);
    for(std::size_t t = 0; t < triangles.size(); t += step) {
      const Point_3 c = CGAL::centroid(triangles[t]);
      m_verdict.farthest_centroid = (std::max)(m_verdict.farthest_centroid, distance(c, *surface) / m_diagonal);
      // The surface may overlap itself outside the face, and the nearest point of a centroid lie there: corners are on it.
      m_verdict.misoriented_triangles += m_numbers_of_shells[f] == 1 && faces_away(triangles[t], c, face, *surface)
                                         && faces_away(triangles[t], triangles[t][0], face, *surface)
                                         && faces_away(triangles[t], triangles[t][1], face, *surface)
                                         && faces_away(triangles[t], triangles[t][2], face, *surface);
    }
  }

  gp_Pnt2d nearest(const Point_3& p, ShapeAnalysis_Surface& surface) const
  {
    return surface.ValueOfUV(gp_Pnt(p.x(), p.y(), p.z()), 1e-7 * m_diagonal);
  }

  double distance(const Point_3& p, ShapeAnalysis_Surface& surface) const
  {
    const gp_Pnt2d uv = nearest(p, surface);
    return surface.Surface()->Value(uv.X(), uv.Y()).Distance(gp_Pnt(p.x(), p.y(), p.z()));
  }

  // Whether a triangle faces away from its face at a point, as far as the normals of slivers mean anything.
  bool faces_away(const Kernel::Triangle_3& triangle, const Point_3& at, const TopoDS_Face& face, ShapeAnalysis_Surface& surface) const
  {
    const gp_Pnt2d uv = nearest(at, surface);
    gp_Pnt p;
    gp_Vec du, dv;
    surface.Surface()->D1(uv.X(), uv.Y(), p, du, dv);
    const gp_Vec normal = du.Crossed(dv) * (face.Orientation() == TopAbs_REVERSED ? -1. : 1.);
    const auto n = CGAL::normal(triangle[0], triangle[1], triangle[2]);
    const double product = normal.X() * n.x() + normal.Y() * n.y() + normal.Z() * n.z(),
                 size = normal.Magnitude() * std::sqrt(n.squared_length());
    return product < -0.2 * size;
  }
};

#endif // CAD_MESH_JUDGE_H
