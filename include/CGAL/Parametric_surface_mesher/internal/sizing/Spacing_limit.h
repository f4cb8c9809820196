// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_SPACING_LIMIT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_SPACING_LIMIT_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>
#include <CGAL/Surface_curvature_3.h>
#include <CGAL/Surface_jet_3.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The largest spacing that a patch allows at a point: by the maximum edge, the curvature and the user's sizing field.
template <class Oracle>
class Spacing_limit
{
  typedef typename Oracle::Geom_traits Kernel;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Vector_3 Vector_3;

  static constexpr double trusted_share = 0.3; // of the limit by the curvature of the surface

  // A chord of length L has deviation ratio H/L = L kappa / 8 and arc height L^2 kappa / 8. Less than 8 leaves room for edges
  // longer than the spacing: triangles that are split by deviation alone have a good shape, and leave a worse one. Measured
  // on a steep peak, 7 saves most of these splits with points of a front. Circumcentres leave longer edges: with 6 they make
  // 8 percent more triangles, and their mean radius ratio is 0.913 in place of 0.906.
  static constexpr double chord_factor_of_front = 7, chord_factor_of_centers = 6;

  const Oracle& m_oracle;
  Bbox_2 m_box;
  double m_max_edge, m_min_edge, m_gamma;
  std::optional<double> m_distance;
  std::shared_ptr<const Sizing_options::Sizing_field> m_sizing_field;
  double m_chord_factor;
  double m_harmless_curvature; // the largest that allows the maximum edge

public:
  // no point outside `box` is evaluated; if it is empty the curvature of lines always counts
  Spacing_limit(const Oracle& oracle, const Parametric_surface_mesh_criteria& criteria, const Bbox_2& box)
    : m_oracle(oracle), m_box(box), m_max_edge(criteria.max_edge()), m_min_edge(criteria.min_edge()),
      m_gamma(criteria.gamma()), m_distance(criteria.distance()), m_sizing_field(criteria.sizing_field()),
      m_chord_factor(criteria.placement() == Mesh_point_placement::FRONTAL ? chord_factor_of_front : chord_factor_of_centers),
      m_harmless_curvature(m_chord_factor * m_gamma / m_max_edge)
  {
    if(m_distance)
      m_harmless_curvature = (std::min)(m_harmless_curvature, m_chord_factor * *m_distance / square(m_max_edge));
  }

  double operator()(const Point_2& uv, const Surface_jet_3<Kernel>& jet) const
  {
    double limit = by_curvature(uv, jet);
    if(m_sizing_field)
      limit = (std::min)(limit, wanted_size(uv));
    return (std::max)(limit, 1.4 * m_min_edge);
  }

  double operator()(const Point_2& uv) const { return (*this)(uv, m_oracle.surface().jet(uv.x(), uv.y())); }

  // without the sizing field
  double by_curvature(const Point_2& uv, const Surface_jet_3<Kernel>& jet) const
  {
    if((jet.duu == NULL_VECTOR && jet.duv == NULL_VECTOR && jet.dvv == NULL_VECTOR) || is_nearly_straight(jet))
      return m_max_edge;
    const double limit = limit_for(Surface_curvature_3<Kernel>(jet).max_absolute_curvature());
    // No vertex will be much closer to a singular point than this: then there is no limit, as at the point itself. Around an
    // apex the limit tends to zero, and may yet be longer than the distance from it.
    if(m_oracle.is_near_singular_point(jet.point, 0.25 * limit))
      return m_max_edge;
    // around a singular point the lines bend however small the edges are, and the oracle does not count that
    if(m_oracle.is_near_singular_point(jet.point, limit / (6 * m_gamma)))
      return limit;
    const double line_limit = limit_for(largest_line_curvature(jet));
    return line_limit > trusted_share * limit || is_steady(uv, jet, line_limit) ? (std::min)(limit, line_limit) : limit;
  }

private:
  double limit_for(double curvature) const
  {
    double limit = m_max_edge;
    if(curvature * limit > m_chord_factor * m_gamma)
      limit = m_chord_factor * m_gamma / curvature;
    if(m_distance && curvature * limit * limit > m_chord_factor * *m_distance)
      limit = std::sqrt(m_chord_factor * *m_distance / curvature);
    return limit;
  }

  // Whether no curvature can limit the spacing: neither that of the surface nor that of a line in any direction is above
  //   (g |S_uu| + 2 sqrt(e g) |S_uv| + e |S_vv|) / (e g - f^2),
  // as the components of a unit vector are at most sqrt(g / (e g - f^2)) and sqrt(e / (e g - f^2)). The square of this bound
  // costs little.
  bool is_nearly_straight(const Surface_jet_3<Kernel>& jet) const
  {
    const double e = jet.du * jet.du, f = jet.du * jet.dv, g = jet.dv * jet.dv;
    const double bound = 4 * (g * g * (jet.duu * jet.duu) + 2 * e * g * (jet.duv * jet.duv) + e * e * (jet.dvv * jet.dvv));
    return bound < square(m_harmless_curvature * (e * g - f * f)); // not if both are 0 or infinite by rounding
  }

  // Close to where the parametrisation is singular the lines bend more and more, although the surface does not. Their
  // curvature counts only if it is much the same over the length that it asks for.
  bool is_steady(const Point_2& uv, const Surface_jet_3<Kernel>& jet, double line_limit) const
  {
    const double du = 0.75 * line_limit / std::sqrt(jet.du.squared_length()),
                 dv = 0.75 * line_limit / std::sqrt(jet.dv.squared_length());
    if(m_box.xmin() > m_box.xmax())
      return true;
    for(const auto& step : {std::make_pair(du, 0.), std::make_pair(-du, 0.), std::make_pair(0., dv), std::make_pair(0., -dv)}) {
      const double u = (std::min)((std::max)(uv.x() + step.first, m_box.xmin()), m_box.xmax()),
                   v = (std::min)((std::max)(uv.y() + step.second, m_box.ymin()), m_box.ymax());
      const Surface_jet_3<Kernel> other = m_oracle.surface().jet(u, v);
      const double other_limit = limit_for(largest_line_curvature(other));
      if(!(other_limit < 1.6 * line_limit && line_limit < 1.6 * other_limit))
        return false;
    }
    return true;
  }

  // The largest curvature in space of the images of straight domain lines, sampled in four directions of the tangent
  // plane. It bounds the deviation of edges better than the normal curvature does: on a steep flank the images of straight
  // lines bend within the surface.
  static double largest_line_curvature(const Surface_jet_3<Kernel>& jet)
  {
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
  static double squared_part_across(const Vector_3& w, const Vector_3& t)
  {
    const double along = w * t;
    return w * w - along * along;
  }

  double wanted_size(const Point_2& uv) const
  {
    const double size = (*m_sizing_field)(uv.x(), uv.y());
    if(!(size > 0))
      throw Parametric_surface_mesh_error("the sizing field is not positive at (u,v) = " + describe(uv) + ": "
                                          + describe(size));
    return size;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_SPACING_LIMIT_H
