// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_EDGE_MATCH_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_EDGE_MATCH_H

#include <CGAL/Parametric_surface_mesher/internal/Open_cascade/suspend_handle_macro.h>
#include <CGAL/Domain_curve_2.h>
#include <CGAL/Parametric_surface_mesher/internal/Arc_length.h>
#include <CGAL/Space_curve_3.h>
#include <CGAL/number_utils.h>
#include <CGAL/Parametric_surface_mesher/internal/Open_cascade/restore_handle_macro.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Two curves in space, side by side, that are to be one. Points correspond that have the same share of the length before
// them, or on the second one behind them if it runs back.
template <class Kernel>
class Edge_match
{
  typedef Space_curve_3<Kernel> Space_curve;
  typedef Domain_curve_2<Kernel> Curve;

  static const int number_of_samples = 64;

  struct Measured_curve
  {
    std::shared_ptr<const Space_curve> curve;
    Arc_length<std::function<double(double)>> length;

    explicit Measured_curve(const std::shared_ptr<const Space_curve>& c)
      : curve(c), length([c](double t) { return c->speed(t); }, c->begin(), c->end(), 16)
    {}
  };

  std::shared_ptr<const Measured_curve> m_first, m_second;
  bool m_is_reversed;

public:
  Edge_match(const std::shared_ptr<const Space_curve>& first, const std::shared_ptr<const Space_curve>& second, bool is_reversed)
    : m_first(std::make_shared<Measured_curve>(first)), m_second(std::make_shared<Measured_curve>(second)),
      m_is_reversed(is_reversed)
  {}

  bool is_reversed() const { return m_is_reversed; }

  // the largest distance of corresponding points
  double distance() const
  {
    double squared = 0;
    for(int i = 0; i <= number_of_samples; ++i) {
      const double t = parameter_on(*m_first, double(i) / number_of_samples);
      squared = (std::max)(squared, CGAL::to_double(squared_distance(m_first->curve->point(t), m_second->curve->point(parameter(t)))));
    }
    return std::sqrt(squared);
  }

  // A curve in a domain, with the parameters of the second curve, gets those of the first. (Its second derivative is not
  // known, and not needed: an edge is measured on its curve in space.)
  Curve reparametrized(const Curve& curve) const
  {
    if(curve.is_straight() && is_proportional())
      return m_is_reversed ? Curve::segment(curve.target(), curve.source()) : curve;
    const auto jet = [match = *this, curve](double t) {
      auto result = curve.jet(match.parameter(t));
      result.first = match.derivative(t) * result.first;
      result.second = 0 * result.second;
      return result;
    };
    Curve result(jet, m_first->curve->begin(), m_first->curve->end());
    result.set_end_points(m_is_reversed ? curve.target() : curve.source(), m_is_reversed ? curve.source() : curve.target());
    return result;
  }

private:
  static double parameter_on(const Measured_curve& curve, double share)
  {
    return curve.length.position_at(share * curve.length.length()).parameter;
  }

  // of the second curve
  double parameter(double t) const
  {
    const double share = m_first->length.length_at(t) / m_first->length.length();
    return parameter_on(*m_second, m_is_reversed ? 1 - share : share);
  }

  // of `parameter()`
  double derivative(double t) const
  {
    const double speed = m_first->curve->speed(t) / m_first->length.length() * m_second->length.length(),
                 result = speed / m_second->curve->speed(parameter(t));
    return (m_is_reversed ? -1 : 1) * (std::isfinite(result) ? result : 1);
  }

  bool is_proportional() const
  {
    for(const double t : {0.125, 0.375, 0.5, 0.75})
      if(std::fabs(parameter(t) - (m_is_reversed ? 1 - t : t)) > 1e-10)
        return false;
    return true;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_EDGE_MATCH_H
