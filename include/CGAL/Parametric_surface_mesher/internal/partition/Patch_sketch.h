// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_PATCH_SKETCH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_PATCH_SKETCH_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_judge.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/Face_measures.h>
#include <CGAL/Parametric_surface_mesher/internal/refinement/Patch_refinement.h>
#include <CGAL/Parametric_surface_mesher/internal/support/Mesh_progress.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Domain_walk.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/triangulate_boundary.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Judges the faces of a sketch: triangles `coarseness` times as long as wanted, whatever their shape.
template <class Oracle>
class Sketch_judge
{
  const Oracle& m_oracle;
  double m_squared_factor; // (R / sum of spacings)^2 of the largest triangles allowed: an equilateral one has R = edge / sqrt(3)

public:
  Sketch_judge(const Oracle& oracle, double coarseness) : m_oracle(oracle), m_squared_factor(square(coarseness) / 27) {}

  template <class Face_handle>
  Judgement judge_shape(Face_handle f) const
  {
    const double sum = f->vertex(0)->spacing() + f->vertex(1)->spacing() + f->vertex(2)->spacing();
    const double badness = squared_circumradius(squared_lengths(f, m_oracle.metric())) / (m_squared_factor * sum * sum);
    return {badness > 1 ? Criterion_set(Mesh_criterion::SIZE) : Criterion_set(), badness, false};
  }

  // It need not be close to the surface.
  template <class Face_handle>
  Judgement judge_deviation(Face_handle) const
  {
    return {};
  }
};

// A triangle of a sketch, with the number of triangles that a mesh will have there.
template <class Kernel>
struct Sketch_cell
{
  typename Kernel::Point_2 center;
  Metric_tensor_2 tensor;
  double weight;
};

// A coarse mesh of a patch: tells how many triangles there will be, where, and of which size.
template <class Evaluator>
class Patch_sketch
{
public:
  typedef typename Evaluator::Kernel Kernel;
  typedef Patch_triangulation_2<Kernel> Triangulation;
  typedef typename Triangulation::Face_handle Face_handle;
  typedef typename Kernel::Point_2 Point_2;
  typedef Sketch_cell<Kernel> Cell;

private:
  typedef internal::Location<Triangulation> Location;

  const Evaluator& m_evaluate;
  const Parametric_surface_mesh_criteria m_criteria;
  Triangulation m_triangulation;
  std::size_t m_number_of_replaced_tensors = 0; // those of boundary vertices
  mutable Face_handle m_hint;

public:
  // \pre the segments of the loops do not cross
  Patch_sketch(const Evaluator& evaluate, const Parametric_surface_mesh_criteria& criteria,
               const Boundary_loops<Kernel>& loops, double coarseness, Patch_progress& progress)
    : m_evaluate(evaluate), m_criteria(with_circumcenters(criteria))
  {
    Boundary_triangulator<Kernel> triangulate(m_triangulation, loops);
    triangulate(evaluate);
    m_number_of_replaced_tensors = triangulate.number_of_replaced_tensors();
    typedef Sketch_judge<typename Evaluator::Oracle> Judge;
    const Judge judge(evaluate.oracle(), coarseness);
    Patch_refinement<Evaluator, Judge> refine(m_triangulation, evaluate, m_criteria, judge, progress);
    refine(Scope::SHAPE);
  }

  // A copy would refer to members of the original.
  Patch_sketch(const Patch_sketch&) = delete;
  Patch_sketch& operator=(const Patch_sketch&) = delete;

  std::size_t number_of_replaced_tensors() const { return m_number_of_replaced_tensors; }

  std::vector<Cell> cells() const
  {
    std::vector<Cell> result;
    for(Face_handle face : m_triangulation.finite_face_handles())
      if(face->is_in_domain())
        result.push_back(cell(face));
    return result;
  }

  // The spacing at a point of the patch; 0 if the point is not found. Searches are faster if successive points are close together.
  double spacing(const Point_2& p) const
  {
    Location location{Location::LOST, m_hint, -1};
    if(m_hint != Face_handle())
      location = walk_in_domain(m_triangulation, m_hint, p);
    if(location.kind == Location::LOST || location.kind == Location::BEHIND_CONSTRAINT)
      location.face = m_triangulation.locate(typename Triangulation::Point(p));
    if(location.face == Face_handle() || m_triangulation.is_infinite(location.face))
      return 0;
    m_hint = location.face;
    return interpolated_spacing(location.face, p);
  }

private:
  static Parametric_surface_mesh_criteria with_circumcenters(Parametric_surface_mesh_criteria criteria)
  {
    return criteria.set_placement(Mesh_point_placement::CIRCUMCENTER);
  }

  // A cell counts as many triangles as equilateral ones of the wanted size have its area.
  Cell cell(Face_handle face) const
  {
    const Point_2 &p = face->vertex(0)->point().domain_point(), &q = face->vertex(1)->point().domain_point(),
                  &r = face->vertex(2)->point().domain_point();
    const double domain_area = 0.5 * ((q.x() - p.x()) * (r.y() - p.y()) - (r.x() - p.x()) * (q.y() - p.y()));
    Metric_tensor_2 tensor(0, 0, 0);
    double density = 0;
    for(int i = 0; i < 3; ++i) {
      const Metric_tensor_2& m = face->vertex(i)->point().tensor();
      tensor = tensor + (1. / 3) * m;
      density += std::sqrt(m.determinant()) / square(face->vertex(i)->spacing()) / 3;
    }
    const double size_factor_of_wanted_edges = 0.28; // with this factor edges have the length of the spacing in the mean
    const double size = m_criteria.size_factor() / size_factor_of_wanted_edges;
    return {centroid(p, q, r), tensor, domain_area * density * 4 / std::sqrt(3.) / (size * size)};
  }

  static double interpolated_spacing(Face_handle face, const Point_2& p)
  {
    double sum = 0, weights = 0;
    for(int i = 0; i < 3; ++i) {
      const Point_2 &q = face->vertex((i + 1) % 3)->point().domain_point(),
                    &r = face->vertex((i + 2) % 3)->point().domain_point();
      const double weight = (std::max)(0., (q.x() - p.x()) * (r.y() - p.y()) - (r.x() - p.x()) * (q.y() - p.y()));
      sum += weight * face->vertex(i)->spacing();
      weights += weight;
    }
    return weights > 0 ? sum / weights : 0;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_PATCH_SKETCH_H
