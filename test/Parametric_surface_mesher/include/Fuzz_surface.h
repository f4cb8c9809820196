// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One type for all surfaces and one for all metric fields of the fuzz test, so that the mesher is compiled for them once.
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_FUZZ_SURFACE_H
#define PARAMETRIC_SURFACE_MESHER_TEST_FUZZ_SURFACE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/First_fundamental_form_metric_2.h>
#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Parametric_point_2.h>
#include <CGAL/Principal_curvature_metric_2.h>
#include <CGAL/Surface_jet_3.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <utility>

// (x,y) -> (a x + b y + p, c x + d y + q)
struct Fuzz_map_2
{
  double a = 1, b = 0, c = 0, d = 1, p = 0, q = 0;

  std::pair<double, double> operator()(double x, double y) const { return {a * x + b * y + p, c * x + d * y + q}; }

  // \pre the determinant is not 0
  Fuzz_map_2 inverse() const
  {
    const double e = a * d - b * c;
    return {d / e, -b / e, -c / e, a / e, (b * q - d * p) / e, (c * p - a * q) / e};
  }

  // this map after another one
  Fuzz_map_2 after(const Fuzz_map_2& f) const
  {
    const std::pair<double, double> origin = (*this)(f.p, f.q);
    return {a * f.a + b * f.c, a * f.b + b * f.d, c * f.a + d * f.c, c * f.b + d * f.d, origin.first, origin.second};
  }
};

// Thrown where a mesh takes so many evaluations of its surface that the mesher seems not to end.
struct Fuzz_work_limit : std::runtime_error
{
  Fuzz_work_limit() : std::runtime_error("the surface is evaluated far too often") {}
};

// Counts the evaluations of all surfaces that share it.
class Fuzz_work
{
  std::atomic<std::uint64_t> m_number_left{~std::uint64_t(0)};

public:
  void allow(std::uint64_t number_of_evaluations) { m_number_left = number_of_evaluations; }

  void count()
  {
    if(m_number_left-- == 0) {
      m_number_left = 0; // other threads end, too
      throw Fuzz_work_limit();
    }
  }
};

// `factor S(map(u,v))`, whatever `S` is: a model of `ParametricSurface_3`. It has a rectangle, too, for models of patches.
class Fuzz_surface
{
public:
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Geom_traits;
  typedef Geom_traits::Point_3 Point_3;
  typedef Geom_traits::Vector_3 Vector_3;
  typedef CGAL::Surface_jet_3<Geom_traits> Jet;

private:
  std::function<Point_3(double, double)> m_point;
  std::function<Jet(double, double)> m_jet;
  std::shared_ptr<Fuzz_work> m_work;
  Fuzz_map_2 m_map;
  double m_factor = 1;
  double m_u_min = 0, m_u_max = 1, m_v_min = 0, m_v_max = 1;

public:
  template <class Surface>
  Fuzz_surface(const Surface& surface, double u_min, double u_max, double v_min, double v_max)
    : m_point([surface](double u, double v) { return surface.point(u, v); }),
      m_jet([surface](double u, double v) { return surface.jet(u, v); }), m_u_min(u_min), m_u_max(u_max), m_v_min(v_min),
      m_v_max(v_max)
  {}

  double u_min() const { return m_u_min; }
  double u_max() const { return m_u_max; }
  double v_min() const { return m_v_min; }
  double v_max() const { return m_v_max; }

  void set_map(const Fuzz_map_2& map) { m_map = map; }
  void set_factor(double factor) { m_factor = factor; }
  void set_work(const std::shared_ptr<Fuzz_work>& work) { m_work = work; }

  Point_3 point(double u, double v) const
  {
    if(m_work)
      m_work->count();
    const std::pair<double, double> x = m_map(u, v);
    return scaled(m_point(x.first, x.second));
  }

  Jet jet(double u, double v) const
  {
    if(m_work)
      m_work->count();
    const std::pair<double, double> x = m_map(u, v);
    const Jet s = m_jet(x.first, x.second);
    const double a = m_map.a, b = m_map.b, c = m_map.c, d = m_map.d, f = m_factor;
    // not that of `s`: derivatives of B-splines come with a point that is rounded in another way
    return {scaled(m_point(x.first, x.second)),
            f * (a * s.du + c * s.dv),
            f * (b * s.du + d * s.dv),
            f * (a * a * s.duu + 2 * a * c * s.duv + c * c * s.dvv),
            f * (a * b * s.duu + (a * d + b * c) * s.duv + c * d * s.dvv),
            f * (b * b * s.duu + 2 * b * d * s.duv + d * d * s.dvv)};
  }

private:
  Point_3 scaled(const Point_3& p) const { return Point_3(m_factor * p.x(), m_factor * p.y(), m_factor * p.z()); }
};

// The default metric, that of principal curvatures, or one that a function makes of the default one and the place in space.
class Fuzz_metric
{
public:
  typedef Fuzz_surface::Geom_traits Kernel;
  typedef std::function<CGAL::Metric_tensor_2(const CGAL::Metric_tensor_2&, const Kernel::Point_3&)> Function;

  enum class Kind
  {
    FIRST_FUNDAMENTAL_FORM,
    PRINCIPAL_CURVATURE,
    FUNCTION
  };

private:
  Kind m_kind = Kind::FIRST_FUNDAMENTAL_FORM;
  CGAL::Principal_curvature_metric_2<Kernel> m_principal;
  Function m_function;

public:
  Fuzz_metric() = default;
  explicit Fuzz_metric(const CGAL::Principal_curvature_metric_2<Kernel>& principal)
    : m_kind(Kind::PRINCIPAL_CURVATURE), m_principal(principal)
  {}
  explicit Fuzz_metric(Function function) : m_kind(Kind::FUNCTION), m_function(std::move(function)) {}

  bool is_default() const { return m_kind == Kind::FIRST_FUNDAMENTAL_FORM; }

  CGAL::Metric_tensor_2 tensor(const CGAL::Surface_jet_3<Kernel>& jet) const
  {
    if(m_kind == Kind::PRINCIPAL_CURVATURE)
      return m_principal.tensor(jet);
    const CGAL::Metric_tensor_2 first = m_first.tensor(jet);
    return m_kind == Kind::FUNCTION ? m_function(first, jet.point) : first;
  }

  double squared_length(const CGAL::Parametric_point_2<Kernel>& p, const CGAL::Parametric_point_2<Kernel>& q) const
  {
    return is_default() ? m_first.squared_length(p, q) : m_principal.squared_length(p, q);
  }

private:
  CGAL::First_fundamental_form_metric_2<Kernel> m_first;
};

#endif // PARAMETRIC_SURFACE_MESHER_TEST_FUZZ_SURFACE_H
