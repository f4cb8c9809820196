// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVIDE_MODEL_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVIDE_MODEL_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/Boundary_loops.h>
#include <CGAL/Parametric_surface_mesher/internal/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/divide_domain.h>
#include <CGAL/Parametric_surface_mesher/internal/mesh_divided_patch.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/divide_curve.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The edges of a model, each divided once: on the first face that uses it. The mesh gets the vertices of the model first,
// then the inner points of the edges, edge by edge.
template <class Surface>
class Model_division
{
  typedef typename Surface::Geom_traits Kernel;
  typedef Parametric_surface_model_3<Surface> Model;
  typedef typename Model::Edge_use Edge_use;

  struct Division
  {
    std::vector<double> parameters;   // empty if no face uses the edge
    std::size_t first_inner_index = 0; // of the second point
  };

  const Model& m_model;
  std::vector<Division> m_divisions;

public:
  Model_division(const Model& model, const Parametric_surface_mesh_criteria& criteria, Indexed_mesh<Kernel>& mesh)
    : m_model(model), m_divisions(model.edges().size())
  {
    mesh.points = model.vertices();
    mesh.domain_points.resize(mesh.points.size());
    for(const auto& face : model.faces())
      for(const auto& loop : face.loops)
        for(const Edge_use& use : loop)
          if(m_divisions[use.edge].parameters.empty())
            divide(face.surface, use, criteria, mesh);
  }

  // the divided boundary of a face; the mesh gets the domain points of its vertices
  Boundary_loops<Kernel> boundary_loops(const typename Model::Face& face, Indexed_mesh<Kernel>& mesh) const
  {
    Boundary_loops<Kernel> result;
    for(const auto& loop : face.loops) {
      result.emplace_back();
      for(const Edge_use& use : loop)
        append(use, mesh, result.back());
    }
    return result;
  }

  std::size_t number_of_edges() const
  {
    std::size_t result = 0;
    for(std::size_t e = 0; e < m_divisions.size(); ++e)
      if(!m_model.edges()[e].is_collapsed && !m_divisions[e].parameters.empty())
        result += m_divisions[e].parameters.size() - 1;
    return result;
  }

private:
  void divide(const Surface& surface, const Edge_use& use, const Parametric_surface_mesh_criteria& criteria,
              Indexed_mesh<Kernel>& mesh)
  {
    Division& division = m_divisions[use.edge];
    const Curve_on_surface_3<Surface> curve(surface, use.curve);
    const typename Model::Edge& edge = m_model.edges()[use.edge];
    if(edge.is_collapsed)
      division.parameters = {curve.begin(), curve.end()};
    else
      division.parameters
        = divide_curve(curve, criteria, edge.source == edge.target ? 3 : 1, use.curve.number_of_edges());
    division.first_inner_index = mesh.points.size();
    for(std::size_t i = 1; i + 1 < division.parameters.size(); ++i)
      mesh.points.push_back(curve.point(division.parameters[i]));
    mesh.domain_points.resize(mesh.points.size());
  }

  // the points of a use but for its last one, which begins the next use
  void append(const Edge_use& use, Indexed_mesh<Kernel>& mesh, std::vector<Boundary_vertex<Kernel>>& loop) const
  {
    const Division& division = m_divisions[use.edge];
    const std::size_t n = division.parameters.size() - 1;
    for(std::size_t k = 0; k < n; ++k) {
      const std::size_t i = use.is_reversed ? n - k : k;
      const std::size_t index = i == 0   ? m_model.edges()[use.edge].source
                                : i == n ? m_model.edges()[use.edge].target
                                         : division.first_inner_index + i - 1;
      const auto domain_point = use.curve.point(division.parameters[i]);
      mesh.domain_points[index] = domain_point;
      loop.push_back({domain_point, mesh.points[index], index});
    }
  }
};

// The diagonal of the box around the images of the loops, at some points of each curve.
template <class Surface>
double model_diagonal(const Parametric_surface_model_3<Surface>& model)
{
  Bbox_3 box;
  for(const auto& face : model.faces())
    for(const auto& loop : face.loops)
      for(const auto& use : loop)
        box += curve_box(face.surface, use.curve);
  return diagonal(box);
}

// Meshes one face of a divided model into `mesh`.
template <class Face, class Division, class MetricField, class Criteria, class Visitor, class Mesh>
void mesh_face_of_model(const Face& face, std::size_t number, const Division& division, const MetricField& metric,
                        const Criteria& criteria, Visitor& visitor, Mesh& mesh, Parametric_surface_mesh_report& report)
{
  const std::size_t first = mesh.faces.size();
  try {
    mesh_divided_patch(face.surface, metric, criteria, division.boundary_loops(face, mesh), visitor, mesh, report);
  }
  catch(const Parametric_surface_mesh_error& error) {
    throw Parametric_surface_mesh_error("face " + std::to_string(number) + ": " + error.what());
  }
  if(face.is_reversed)
    for(std::size_t i = first; i < mesh.faces.size(); ++i)
      std::swap(mesh.faces[i][1], mesh.faces[i][2]);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVIDE_MODEL_H
