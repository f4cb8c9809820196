// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVIDE_MODEL_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVIDE_MODEL_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/Boundary_loops.h>
#include <CGAL/Parametric_surface_mesher/internal/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/divide_domain.h>
#include <CGAL/Parametric_surface_mesher/internal/Boundary_size.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Parametric_surface_oracle_3.h>
#include <CGAL/divide_curve.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The edges of a model, each divided once: on the first face that uses it, with the sizes of all faces that do. The mesh gets the
// vertices of the model first, then the inner points of the edges, edge by edge.
template <class Oracle>
class Model_division
{
  typedef typename Oracle::Geom_traits Kernel;
  typedef typename Oracle::Surface Surface;
  typedef Parametric_surface_model_3<Surface> Model;
  typedef typename Model::Edge_use Edge_use;

  struct Use
  {
    std::size_t face;
    const Edge_use* use;
    bool is_domain_left; // of the edge's curve
  };

  struct Division
  {
    std::vector<Use> uses;
    std::vector<double> parameters;   // empty if no face uses the edge
    std::size_t first_inner_index = 0; // of the second point
  };

  const Model& m_model;
  const std::vector<Oracle>& m_oracles; // of the faces
  const Parametric_surface_mesh_criteria& m_criteria;
  std::vector<Boundary_size<Oracle>> m_sizes; // of the faces
  std::vector<Division> m_divisions;

public:
  Model_division(const Model& model, const std::vector<Oracle>& oracles,
                 const Parametric_surface_mesh_criteria& criteria, Indexed_mesh<Kernel>& mesh)
    : m_model(model), m_oracles(oracles), m_criteria(criteria), m_divisions(model.edges().size())
  {
    mesh.points = model.vertices();
    std::vector<std::size_t> order; // of first use
    for(std::size_t f = 0; f < model.faces().size(); ++f)
      collect_uses(f, order);
    for(std::size_t edge : order) {
      divide(edge, mesh);
      append_edges(edge, mesh);
    }
    mesh.domain_points.resize(mesh.points.size());
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
  void collect_uses(std::size_t face, std::vector<std::size_t>& order)
  {
    const auto& loops = m_model.faces()[face].loops;
    const auto curve = [](const Edge_use& use) -> const auto& { return use.curve; };
    m_sizes.emplace_back(m_oracles[face], m_criteria, domain_box(loops, curve));
    for(std::size_t l = 0; l < loops.size(); ++l) {
      double double_area = 0;
      for(const Edge_use& use : loops[l])
        double_area += (use.is_reversed ? -1 : 1) * double_area_seen_from(loops[l].front().curve.source(), use.curve);
      const bool is_loop_left = (double_area > 0) == (l == 0);
      for(const Edge_use& use : loops[l]) {
        if(m_divisions[use.edge].uses.empty())
          order.push_back(use.edge);
        m_divisions[use.edge].uses.push_back({face, &use, is_loop_left != use.is_reversed});
      }
    }
  }

  void divide(std::size_t number, Indexed_mesh<Kernel>& mesh)
  {
    Division& division = m_divisions[number];
    const typename Model::Edge& edge = m_model.edges()[number];
    const auto& domain_curve = division.uses.front().use->curve;
    const Curve_on_surface_3<Surface> curve(m_oracles[division.uses.front().face].surface(), domain_curve);
    if(edge.is_collapsed)
      division.parameters = {curve.begin(), curve.end()};
    else
      division.parameters = divide_curve(curve, m_criteria, [&](double t) { return spacing_limit(division, t); },
                                         edge.source == edge.target ? 3 : 1, domain_curve.number_of_edges());
    division.first_inner_index = mesh.points.size();
    for(std::size_t i = 1; i + 1 < division.parameters.size(); ++i)
      mesh.points.push_back(curve.point(division.parameters[i]));
  }

  // The edges of the division are known before any patch gets chords.
  void append_edges(std::size_t number, Indexed_mesh<Kernel>& mesh) const
  {
    const std::size_t n = m_divisions[number].parameters.size() - 1;
    for(std::size_t i = 0; i < n; ++i) {
      const std::size_t a = index(number, i), b = index(number, i + 1);
      mesh.chords.emplace((std::min)(a, b), (std::max)(a, b));
    }
  }

  // of a point of a divided edge
  std::size_t index(std::size_t number, std::size_t i) const
  {
    const Division& division = m_divisions[number];
    return i == 0                                  ? m_model.edges()[number].source
           : i + 1 == division.parameters.size()   ? m_model.edges()[number].target
                                                   : division.first_inner_index + i - 1;
  }

  double spacing_limit(const Division& division, double t) const
  {
    double limit = m_criteria.max_edge();
    for(const Use& use : division.uses)
      limit = (std::min)(limit, m_sizes[use.face](use.use->curve, t, use.is_domain_left));
    return limit;
  }

  // the points of a use but for its last one, which begins the next use
  void append(const Edge_use& use, Indexed_mesh<Kernel>& mesh, std::vector<Boundary_vertex<Kernel>>& loop) const
  {
    const Division& division = m_divisions[use.edge];
    const std::size_t n = division.parameters.size() - 1;
    for(std::size_t k = 0; k < n; ++k) {
      const std::size_t i = use.is_reversed ? n - k : k;
      const auto domain_point = use.curve.point(division.parameters[i]);
      const std::size_t vertex = index(use.edge, i);
      mesh.domain_points[vertex] = domain_point;
      loop.push_back({domain_point, mesh.points[vertex], vertex});
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

// The oracles of the faces of a model.
template <class Surface, class MetricField>
std::vector<Parametric_surface_oracle_3<Surface, MetricField>>
make_oracles(const Parametric_surface_model_3<Surface>& model, const MetricField& metric)
{
  std::vector<Parametric_surface_oracle_3<Surface, MetricField>> result;
  for(const auto& face : model.faces()) {
    std::vector<typename Surface::Geom_traits::Point_3> singular_points;
    for(const auto& loop : face.loops)
      for(const auto& use : loop)
        if(model.edges()[use.edge].is_collapsed)
          singular_points.push_back(model.vertices()[model.edges()[use.edge].source]);
    result.emplace_back(face.surface, metric, std::move(singular_points));
  }
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DIVIDE_MODEL_H
