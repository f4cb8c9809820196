// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Surface_data.h"

#include <CGAL/B_spline_surface_3.h>
#include <CGAL/Bezier_surface_3.h>
#include <CGAL/IO/read_bezier_patches.h>
#include <CGAL/Surface_jet_3.h>

#include <fstream>
#include <stdexcept>
#include <utility>

namespace {

typedef Kernel::Vector_2 Vector_2;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Surface_jet_3<Kernel> Surface_jet;
typedef CGAL::Parametric_surface_mesher::internal::Taylor_polynomial_2 Number_with_derivatives;

Vector_3 to_vector(const Triple& v) { return Vector_3(v[0], v[1], v[2]); }

// Each copy has registers of its own.
class Formula_surface
{
  std::shared_ptr<const Formula> m_formula;
  mutable std::vector<double> m_numbers;
  mutable std::vector<Number_with_derivatives> m_numbers_with_derivatives;

public:
  typedef Kernel Geom_traits;
  typedef Kernel::Point_3 Point_3;

  explicit Formula_surface(const Formula& formula) : m_formula(std::make_shared<const Formula>(formula))
  {
    if(formula.number_of_results() != 3)
      throw std::invalid_argument("the formula of a surface must have three coordinates, but has "
                                  + std::to_string(formula.number_of_results()));
  }

  Point_3 point(double u, double v) const { return to_point(m_formula->evaluate<3>(Pair{u, v}, m_numbers)); }

  Surface_jet jet(double u, double v) const
  {
    const std::array<Number_with_derivatives, 2> variables
      = {Number_with_derivatives::first_variable(u), Number_with_derivatives::second_variable(v)};
    const auto p = m_formula->evaluate<3>(variables, m_numbers_with_derivatives);
    return {Point_3(p[0].value, p[1].value, p[2].value), Vector_3(p[0].du, p[1].du, p[2].du), Vector_3(p[0].dv, p[1].dv, p[2].dv),
            Vector_3(p[0].duu, p[1].duu, p[2].duu), Vector_3(p[0].duv, p[1].duv, p[2].duv), Vector_3(p[0].dvv, p[1].dvv, p[2].dvv)};
  }
};

class Function_surface
{
  std::function<Triple(double, double)> m_point;
  std::function<Surface::Jet(double, double)> m_jet;

public:
  typedef Kernel Geom_traits;
  typedef Kernel::Point_3 Point_3;

  Function_surface(std::function<Triple(double, double)> point, std::function<Surface::Jet(double, double)> jet)
    : m_point(std::move(point)), m_jet(std::move(jet))
  {}

  bool has_independent_copies() const { return false; }
  Point_3 point(double u, double v) const { return to_point(m_point(u, v)); }

  Surface_jet jet(double u, double v) const
  {
    const Surface::Jet jet = m_jet(u, v);
    return {to_point(jet[0]), to_vector(jet[1]), to_vector(jet[2]), to_vector(jet[3]), to_vector(jet[4]), to_vector(jet[5])};
  }
};

std::vector<Point_3> to_points(const std::vector<Triple>& points)
{
  std::vector<Point_3> result;
  for(const Triple& p : points)
    result.push_back(to_point(p));
  return result;
}

Point_2 to_point(const Pair& p) { return Point_2(p[0], p[1]); }
Vector_2 to_vector(const Pair& v) { return Vector_2(v[0], v[1]); }

} // namespace

Surface Surface::formula(const Formula& formula)
{
  return Surface(std::make_shared<Data>(Data{Formula_surface(formula), std::nullopt}));
}

Surface Surface::function(std::function<Triple(double, double)> point, std::function<Jet(double, double)> jet)
{
  return Surface(std::make_shared<Data>(Data{Function_surface(std::move(point), std::move(jet)), std::nullopt}));
}

Surface Surface::bezier(int degree_u, int degree_v, const std::vector<Triple>& control_points)
{
  const CGAL::Bezier_surface_3<Kernel> bezier(degree_u, degree_v, to_points(control_points));
  return Surface(std::make_shared<Data>(Data{bezier, Rectangle{0, 1, 0, 1}}));
}

Surface Surface::b_spline(int degree_u, int degree_v, const std::vector<double>& knots_u, const std::vector<double>& knots_v,
                          const std::vector<Triple>& control_points, const std::vector<double>& weights)
{
  const CGAL::B_spline_surface_3<Kernel> spline(degree_u, degree_v, knots_u, knots_v, to_points(control_points), weights);
  return Surface(std::make_shared<Data>(Data{spline, Rectangle{spline.u_min(), spline.u_max(), spline.v_min(), spline.v_max()}}));
}

std::vector<Surface> Surface::read_bezier_patches(const std::string& file_name)
{
  std::ifstream file(file_name);
  if(!file)
    throw std::runtime_error("cannot open " + file_name);
  std::vector<Surface> result;
  for(const auto& patch : CGAL::IO::read_bezier_patches<Kernel>(file, file_name))
    result.push_back(Surface(std::make_shared<Data>(Data{patch, Rectangle{0, 1, 0, 1}})));
  return result;
}

Surface::Jet Surface::jet(double u, double v) const
{
  const Surface_jet jet = m_data->surface.jet(u, v);
  return {to_triple(jet.point), to_triple(jet.du), to_triple(jet.dv), to_triple(jet.duu), to_triple(jet.duv), to_triple(jet.dvv)};
}

const std::optional<Rectangle>& Surface::domain() const { return m_data->domain; }

Curve Curve::segment(const Pair& from, const Pair& to)
{
  return Curve(std::make_shared<Data>(Data{Domain_curve::segment(to_point(from), to_point(to))}));
}

Curve Curve::arc(const Pair& center, double radius, double begin, double end)
{
  return Curve(std::make_shared<Data>(Data{Domain_curve::arc(to_point(center), radius, begin, end)}));
}

Curve Curve::circle(const Pair& center, double radius)
{
  return Curve(std::make_shared<Data>(Data{Domain_curve::circle(to_point(center), radius)}));
}

Curve Curve::formula(const Formula& formula, double begin, double end)
{
  if(formula.number_of_results() != 2)
    throw std::invalid_argument("the formula of a curve must have two coordinates, but has " + std::to_string(formula.number_of_results()));
  const auto jet = [formula](double t) {
    std::vector<Number_with_derivatives> registers; // of this call: several threads may call it at the same time
    const auto p = formula.evaluate<2>(std::array<Number_with_derivatives, 1>{Number_with_derivatives::first_variable(t)}, registers);
    return Domain_curve::Jet{Point_2(p[0].value, p[1].value), Vector_2(p[0].du, p[1].du), Vector_2(p[0].duu, p[1].duu)};
  };
  return Curve(std::make_shared<Data>(Data{Domain_curve(jet, begin, end)}));
}

Curve Curve::function(std::function<Jet(double)> function, double begin, double end)
{
  const auto jet = [function = std::move(function)](double t) {
    const Jet j = function(t);
    return Domain_curve::Jet{to_point(j[0]), to_vector(j[1]), to_vector(j[2])};
  };
  return Curve(std::make_shared<Data>(Data{Domain_curve(jet, begin, end)}));
}

Pair Curve::source() const { return {m_data->curve.source().x(), m_data->curve.source().y()}; }
Pair Curve::target() const { return {m_data->curve.target().x(), m_data->curve.target().y()}; }
