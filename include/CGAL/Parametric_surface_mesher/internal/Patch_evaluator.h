// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_EVALUATOR_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_EVALUATOR_H

#include <CGAL/Parametric_point_2.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/Boundary_loops.h>
#include <CGAL/Surface_curvature_3.h>
#include <CGAL/Surface_jet_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A point of the mesh as evaluated: with its tensor, and the largest spacing that curvature and sizing field allow there.
template <class Kernel>
struct Evaluated_point
{
  Parametric_point_2<Kernel> point;
  double spacing_limit;
  bool is_tensor_replaced;
};

// Evaluates surface, metric and sizes at a domain point: once for each point of the mesh.
template <class Oracle>
class Patch_evaluator
{
public:
  typedef typename Oracle::Geom_traits Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef Evaluated_point<Kernel> Evaluated;

private:
  const Oracle& m_oracle;
  const Parametric_surface_mesh_criteria& m_criteria;

public:
  Patch_evaluator(const Oracle& oracle, const Parametric_surface_mesh_criteria& criteria)
    : m_oracle(oracle), m_criteria(criteria)
  {}

  const Oracle& oracle() const { return m_oracle; }

  Evaluated operator()(const Point_2& uv) const
  {
    const Surface_jet_3<Kernel> jet = m_oracle.surface().jet(uv.x(), uv.y());
    return evaluated(uv, jet.point, jet);
  }

  // with the point in space given, for boundary vertices
  Evaluated operator()(const Point_2& uv, const Point_3& surface_point) const
  {
    return evaluated(uv, surface_point, m_oracle.surface().jet(uv.x(), uv.y()));
  }

private:
  Evaluated evaluated(const Point_2& uv, const Point_3& surface_point, const Surface_jet_3<Kernel>& jet) const
  {
    Metric_tensor_2 tensor = m_oracle.metric().tensor(jet);
    check_finite(uv, surface_point, tensor);
    const bool is_replaced = !is_well_conditioned(tensor);
    if(is_replaced)
      tensor = regularized(tensor);
    return {Parametric_point_2<Kernel>(uv, surface_point, tensor), spacing_limit(uv, jet), is_replaced};
  }

  static void check_finite(const Point_2& uv, const Point_3& p, const Metric_tensor_2& m)
  {
    if(!std::isfinite(p.x() + p.y() + p.z()))
      throw Parametric_surface_mesh_error("the surface is not finite at (u,v) = " + describe(uv));
    if(!std::isfinite(m.e() + m.f() + m.g()))
      throw Parametric_surface_mesh_error("the metric tensor is not finite at (u,v) = " + describe(uv));
  }

  // beyond this ratio of eigenvalues the determinant is rounding noise
  static bool is_well_conditioned(const Metric_tensor_2& m)
  {
    return m.is_positive_definite() && m.determinant() > 1e-14 * m.trace() * m.trace();
  }

  // Where the parametrisation is singular the tensor is not positive definite. A small multiple of the identity
  // makes it so; at a point where all derivatives vanish it is the identity.
  static Metric_tensor_2 regularized(const Metric_tensor_2& m)
  {
    const double size = m.trace() > 1e-200 ? 1e-6 * m.trace() : 1e-200;
    return m + Metric_tensor_2(size, 0, size);
  }

  // A chord of length L has deviation ratio H/L = L kappa / 8 and arc height L^2 kappa / 8. The factor 7 in place of 8 leaves
  // room for edges longer than the spacing; measured on a steep peak, it saves most of the splits by deviation.
  double spacing_limit(const Point_2& uv, const Surface_jet_3<Kernel>& jet) const
  {
    const double limit = limit_by_curvature(Surface_curvature_3<Kernel>(jet).max_absolute_curvature());
    // around a singular point the lines bend however small the edges are, and the oracle does not count that
    if(m_oracle.is_near_singular_point(jet.point, limit / (6 * m_criteria.gamma())))
      return limit_by_user(uv, limit);
    return limit_by_user(uv, (std::min)(limit, limit_by_curvature(largest_line_curvature(jet))));
  }

  double limit_by_curvature(double curvature) const
  {
    double limit = m_criteria.max_edge();
    if(curvature * limit > 7 * m_criteria.gamma())
      limit = 7 * m_criteria.gamma() / curvature;
    if(m_criteria.distance() > 0 && curvature * limit * limit > 7 * m_criteria.distance())
      limit = std::sqrt(7 * m_criteria.distance() / curvature);
    return limit;
  }

  double limit_by_user(const Point_2& uv, double limit) const
  {
    if(m_criteria.sizing_field())
      limit = (std::min)(limit, wanted_size(uv));
    return (std::max)(limit, m_criteria.min_edge());
  }

  // The largest curvature in space of the images of straight domain lines, sampled in four directions of the tangent
  // plane. It bounds the deviation of edges better than the normal curvature does: on a steep flank the images of straight
  // lines bend within the surface.
  static double largest_line_curvature(const Surface_jet_3<Kernel>& jet)
  {
    typedef typename Kernel::Vector_3 Vector_3;
    const double e = jet.du * jet.du, f = jet.du * jet.dv, g = jet.dv * jet.dv;
    const double area = e * g - f * f; // squared
    if(!(area > 1e-14 * e * g))
      return 0;
    // an orthonormal frame: S_u scaled, and the domain direction (a, b) across it
    const double b = std::sqrt(e / area), a = -f / e * b;
    const Vector_3 x = jet.du / std::sqrt(e), y = a * jet.du + b * jet.dv;
    const Vector_3 xx = jet.duu / e, xy = (a * jet.duu + b * jet.duv) / std::sqrt(e),
                   yy = a * a * jet.duu + 2 * a * b * jet.duv + b * b * jet.dvv;
    const Vector_3 diagonal = 0.5 * (xx + yy);
    return std::sqrt((std::max)({squared_part_across(xx, x), squared_part_across(yy, y),
                                 squared_part_across(diagonal + xy, 0.7071067811865476 * (x + y)),
                                 squared_part_across(diagonal - xy, 0.7071067811865476 * (x - y))}));
  }

  // the squared length of the part of `w` perpendicular to the unit vector `t`
  template <class Vector_3>
  static double squared_part_across(const Vector_3& w, const Vector_3& t)
  {
    const double along = w * t;
    return w * w - along * along;
  }

  double wanted_size(const Point_2& uv) const
  {
    const double size = m_criteria.sizing_field()(uv.x(), uv.y());
    if(!(size > 0))
      throw Parametric_surface_mesh_error("the sizing field is not positive at (u,v) = " + describe(uv) + ": "
                                          + std::to_string(size));
    return size;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PATCH_EVALUATOR_H
